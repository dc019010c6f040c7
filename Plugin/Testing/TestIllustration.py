# SPDX-License-Identifier: BSD-3-Clause
"""Illustrations of images, meshes and points in ParaView's view."""

import unittest

from paraview.simple import *

from rendering import TestInOneView, is_background, picture


class TestIllustration(TestInOneView):
    def show(self, source, **properties):
        display = Show(source, self.view)
        display.SetRepresentationType("Illustration")
        display.IllustrationPaper = 0
        for name, value in properties.items():
            setattr(display, name, value)
        ResetCamera(self.view)
        return display

    def ink(self):
        """Of what is drawn on the surface's white paper."""
        return float((1.0 - picture(self.view)[..., 1]).sum())

    def marks(self, display):
        """How many points lines are drawn of, and when they were made."""
        points = display.GetClientSideObject().GetActiveRepresentation().GetRenderedDataObject(0).GetPoints()
        return (points.GetNumberOfPoints(), points.GetMTime()) if points else (0, 0)

    def test_an_image_is_drawn_at_a_value_that_suits_it_or_that_is_given(self):
        display = self.show(Wavelet())
        self.assertEqual(display.IllustrationAutomaticIsoValue, 1)
        self.assertGreater((~is_background(picture(self.view))).mean(), 0.1)
        automatic = self.marks(display)
        self.assertGreater(automatic[0], 1000)
        display.IllustrationIsoValue = 250.0
        picture(self.view)
        self.assertEqual(self.marks(display), automatic)
        display.IllustrationAutomaticIsoValue = 0
        picture(self.view)
        self.assertNotEqual(self.marks(display)[0], automatic[0])
        # Beyond the data there is none.
        display.IllustrationIsoValue = 1e6
        self.assertTrue(is_background(picture(self.view)).all())

    def test_meshes_are_drawn_and_settings_change_the_ink(self):
        display = self.show(Sphere(ThetaResolution=64, PhiResolution=64))
        drawn = self.ink()
        self.assertGreater(drawn, 100)
        before = self.marks(display)
        display.IllustrationPixelsPerStipple = 40
        self.assertLess(self.ink(), 0.8 * drawn)
        self.assertEqual(self.marks(display), before)

    def test_nothing_is_made_again_while_the_camera_moves(self):
        display = self.show(Wavelet())
        picture(self.view)
        before = self.marks(display)
        camera = GetActiveCamera()
        camera.Azimuth(40)
        camera.Zoom(4)
        picture(self.view)
        self.assertEqual(self.marks(display), before)


if __name__ == "__main__":
    unittest.main(verbosity=2)
