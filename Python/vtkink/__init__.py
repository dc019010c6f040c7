"""Pen-and-ink illustration of volumes, meshes and point clouds in VTK."""

from .vtkInkFiltersSampling import *
from .vtkInkRenderingSplattingLines import *
