# SPDX-License-Identifier: BSD-3-Clause
"""Line art of images, meshes and grids in ParaView's view."""

import unittest

import numpy

from paraview.simple import *

from rendering import TestInOneView, ink, marks, picture
from surface_tests import SurfaceTests


def sphere():
    return Sphere(ThetaResolution=64, PhiResolution=32)


class TestLineArt(SurfaceTests, TestInOneView):
    PREFIX = "LineArt"
    # Few strokes, of few lines: what these tests are of is not their number.
    SHOWS = {"LineArtDensity": 0, "LineArtLineSpacing": 16}
    FEW_MARKS = {"LineArtSubdivision": 1}
    WIDE = {"LineArtContourWidth": 20, **SHOWS}

    def show(self, source, **properties):
        display = Show(source, self.view)
        display.SetRepresentationType("Line Art")
        display.ColorArrayName = ["POINTS", ""]
        for name, value in properties.items():
            setattr(display, name, value)
        self.view.CameraParallelProjection = 1
        ResetCamera(self.view)
        return display

    def test_a_mesh_is_hatched(self):
        self.show(sphere(), LineArtDensity=0.1, LineArtLineSpacing=10)
        self.assertTrue(0.02 < (picture(self.view)[..., 0] < 0.5).mean() < 0.2)

    def test_sliders_change_the_ink_and_make_nothing_again(self):
        display = self.show(sphere(), LineArtDensity=0.1, LineArtContourWidth=0, LineArtLineSpacing=10)
        usual = ink(picture(self.view))
        made = marks(display)
        tones = []
        for tone in (0.1, 0.3, 0.5, 0.7, 0.9):
            display.LineArtTone = tone
            tones.append(ink(picture(self.view)))
        self.assertTrue(all(a < b for a, b in zip(tones, tones[1:])), tones)
        display.LineArtTone = 0.5
        self.assertEqual(ink(picture(self.view)), usual)
        # What makes the tone changes, and not the tone.
        first = picture(self.view)
        for name, values in (("Density", (0.0, 0.8)), ("Width", (0.0, 0.5)), ("Crosshatch", (1.0,))):
            before = getattr(display, f"LineArt{name}")
            for value in values:
                setattr(display, f"LineArt{name}", value)
                drawn = picture(self.view)
                self.assertGreater(numpy.abs(drawn - first).mean(), 0.01, (name, value))
                self.assertAlmostEqual(ink(drawn) / usual, 1.0, delta=0.1, msg=(name, value))
            setattr(display, f"LineArt{name}", before)
        display.LineArtContourWidth = 20
        self.assertGreater(ink(picture(self.view)), 1.1 * usual)
        self.assertEqual(marks(display), made)
        # The length of strokes is cut anew.
        display.LineArtLength = 30
        picture(self.view)
        self.assertNotEqual(marks(display), made)

    def test_an_image_has_strokes_on_its_outside_alone(self):
        # Through its cuts the surface is seen from within, too.
        display = self.show(Wavelet(), LineArtAutomaticIsoValue=0, LineArtIsoValue=100, LineArtContourWidth=0, LineArtLineSpacing=10,
            **self.FEW_MARKS)
        outside = ink(picture(self.view))
        display.LineArtCullingCosine = 1.0
        self.assertGreater(ink(picture(self.view)), 1.02 * outside)

    def test_a_preset_sets_what_goes_with_it(self):
        display = self.show(sphere(), LineArtLineSpacing=10)
        drawn = picture(self.view)
        display.LineArtPreset = "Sketch"
        found = (display.LineArtDensity, display.LineArtLength, display.LineArtTaper, display.LineArtContourWidth)
        self.assertEqual(found, (0.4, 60.0, 0.5, 2.5))
        sketch = picture(self.view)
        self.assertGreater(numpy.abs(sketch - drawn).mean(), 0.01)
        display.LineArtDepthWidth = 0.7
        display.LineArtPreset = "Technical"
        self.assertEqual((display.LineArtCrosshatch, display.LineArtCreases, display.LineArtLength), (0.0, 1, 0.0))
        # No preset has this.
        self.assertEqual(display.LineArtDepthWidth, 0.7)


if __name__ == "__main__":
    unittest.main(verbosity=2)
