# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of representations share: a view, and pictures of it as numpy arrays."""

import re
import unittest

import numpy

from paraview import vtk
from paraview.simple import *
from paraview.vtk.util.numpy_support import vtk_to_numpy

BACKGROUND = (0.0, 1.0, 0.0)


def green_view(size=200):
    """A square render view with nothing in it: no axes, no anti-aliasing, a green background."""
    view = CreateRenderView(ViewSize=[size, size])
    view.UseColorPaletteForBackground = False
    view.BackgroundColorMode = "Single Color"
    view.Background = BACKGROUND
    view.OrientationAxesVisibility = False
    view.UseFXAA = False
    return view


class TestInOneView(unittest.TestCase):
    """Tests that share a view, since a new window would compile all shaders again; each has sources of its own."""

    def setUp(self):
        self.view = GetActiveView() or green_view()

    def tearDown(self):
        for source in GetSources().values():
            Delete(source)

    @classmethod
    def tearDownClass(cls):
        for view in GetViews():
            Delete(view)


def picture(view):
    """The view, rendered: floats indexed [y, x, rgb], y upwards."""
    Render(view)
    image = view.SMProxy.CaptureWindow(1)
    width, height, _ = image.GetDimensions()
    pixels = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)
    return pixels[..., :3] / 255.0


def marks(display, *numbers):
    """Of the representation on this process: how many points it draws, and how often it made them, or other numbers."""
    text = str(display.GetClientSideObject().GetActiveRepresentation())
    return tuple(int(re.search(rf"{name}: (\d+)", text)[1]) for name in numbers or ("Points drawn", "Times made"))


def is_background(pixels):
    return numpy.all(numpy.abs(pixels - BACKGROUND) < 0.01, axis=-1)


def inside(pixels):
    """What is drawn, but for two pixels along outlines, where ink shares them with the background."""
    drawn = ~is_background(pixels)
    for axis in (0, 1, 0, 1):
        drawn = drawn & numpy.roll(drawn, 1, axis) & numpy.roll(drawn, -1, axis)
    return drawn


def ink(pixels):
    """How dark the drawing is: the sum over its pixels of what white would have more of red."""
    return float(numpy.sum(1.0 - pixels[~is_background(pixels)][:, 0]))


class Warnings:
    """Collects what VTK's objects warn of while it is entered."""

    def __enter__(self):
        self.texts = []
        self.window = vtk.vtkOutputWindow.GetInstance()
        self.tags = [self.window.AddObserver(event, self) for event in ("WarningEvent", "ErrorEvent")]
        return self.texts

    CallDataType = "string0"

    def __call__(self, caller, event, text):
        self.texts.append(text)

    def __exit__(self, *_):
        for tag in self.tags:
            self.window.RemoveObserver(tag)
