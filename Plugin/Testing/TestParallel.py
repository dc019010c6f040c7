"""Draws the same picture on one process and on several:  pvpython TestParallel.py MPIEXEC PVBATCH

Run by pvbatch (argument: the picture's file) it draws it; run by pvpython it compares."""

import pathlib
import subprocess
import sys
import tempfile

import numpy

from rendering import *


def draw(file, opaque):
    """Two styles over each other: lines without paper in front of a surface cut the same way."""
    wavelet = Wavelet()
    wavelet.UpdatePipeline()
    view = green_view()
    sampler = InkIsoSurfaceSampler(Input=wavelet, Isosurfaces=[130.0])
    display = Show(sampler, view)
    display.SetRepresentationType("Splatting Lines")
    display.Phi = 100
    display.PaperVisibility = opaque
    Show(Sphere(Radius=4, Center=[5, 0, 8], ThetaResolution=32, PhiResolution=32), view)
    ResetCamera(view)
    SaveScreenshot(file, view)


def read(file):
    reader = vtk.vtkPNGReader()
    reader.SetFileName(str(file))
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[..., :3] / 255.0
