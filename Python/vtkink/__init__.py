"""Pen-and-ink illustration of volumes, meshes and point clouds in VTK.

vtkInk's classes work with those of the VTK that they were built with, whatever its Python package is called;
``vtkink.vtk`` has all of them under one name::

    from vtkink import vtk, vtkInkIsoSurfaceSampler, vtkInkSplattingLinesMapper

``help()`` of a class says what its properties do, their ranges and defaults.
"""

import importlib

from ._build import VERSION as __version__, VTK_PACKAGE, VTK_VERSION


def _vtk_module(name):
    try:
        return importlib.import_module(f"{VTK_PACKAGE}.{name}")
    except ImportError as error:
        raise ImportError(
            f"vtkink {__version__} needs the Python package {VTK_PACKAGE} of VTK {VTK_VERSION} "
            f"on Python's path: {error}"
        ) from error


def _check_vtk_version():
    version = _vtk_module("vtkCommonCore").vtkVersion
    found = f"{version.GetVTKMajorVersion()}.{version.GetVTKMinorVersion()}"
    if found != VTK_VERSION:
        raise ImportError(f"vtkink {__version__} needs VTK {VTK_VERSION}; the package {VTK_PACKAGE} is VTK {found}")


# VTK comes first, so that vtkInk uses the libraries that VTK's own package loads, and with it the OpenGL classes
# that stand behind vtkRenderer and vtkRenderWindow.
_check_vtk_version()
_vtk_module("vtkRenderingOpenGL2")

from .vtkInkFiltersFields import *
from .vtkInkFiltersSampling import *

try:
    from .vtkInkIOVDB import *
except ModuleNotFoundError as error:
    # A build without OpenVDB has no such module; one that is there but cannot be loaded is an error.
    if error.name != f"{__name__}.vtkInkIOVDB":
        raise

from .vtkInkRenderingSplattingLines import *
from .vtkInkRenderingStipple import *


def __getattr__(name):
    # Only on demand: loading all of VTK takes a while.
    if name == "vtk":
        return _vtk_module("all")
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
