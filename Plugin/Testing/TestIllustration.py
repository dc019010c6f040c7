# SPDX-License-Identifier: BSD-3-Clause
"""Illustrations of images, meshes and points in ParaView's view."""

import unittest

import numpy

from paraview import vtk
from paraview.simple import *
from paraview.vtk.util.numpy_support import numpy_to_vtk

from rendering import TestInOneView, Warnings, is_background, marks, picture
from surface_tests import check_colors_come_back, check_iso_value, grids_and_composites


# Of meshes, where their number does not matter.
FEW_MARKS = {"IllustrationNumberOfSurfaceStipples": 20000}


class TestIllustration(TestInOneView):
    def show(self, source, **properties):
        display = Show(source, self.view)
        display.SetRepresentationType("Illustration")
        SetProperties(display, IllustrationPaper=0, **properties)
        ResetCamera(self.view)
        return display

    def ink(self):
        """Of what is drawn on the surface's white paper."""
        return float((1.0 - picture(self.view)[..., 1]).sum())

    def test_an_image_is_drawn_at_a_value_that_suits_it_or_that_is_given(self):
        display = self.show(Wavelet())
        self.assertEqual(display.IllustrationAutomaticIsoValue, 1)
        self.assertGreater((~is_background(picture(self.view))).mean(), 0.1)
        check_iso_value(self, display, "Illustration")
        # Beyond the data there is none.
        display.IllustrationIsoValue = 1e6
        self.assertTrue(is_background(picture(self.view)).all())

    def test_meshes_are_drawn_and_settings_change_the_ink(self):
        display = self.show(Sphere(ThetaResolution=64, PhiResolution=64), **FEW_MARKS)
        drawn = self.ink()
        self.assertGreater(drawn, 100)
        before = marks(display)
        display.IllustrationPixelsPerStipple = 40
        self.assertLess(self.ink(), 0.8 * drawn)
        self.assertEqual(marks(display), before)

    def test_an_array_colors_stipples_and_not_lines(self):
        heights = Elevation(Input=Wavelet(), LowPoint=[0, 0, -10], HighPoint=[0, 0, 10])
        mesh = Elevation(Input=Sphere(ThetaResolution=64, PhiResolution=64), LowPoint=[0, 0, -0.5], HighPoint=[0, 0, 0.5])
        for source, drawn in ((heights, {"IllustrationScalars": ["POINTS", "RTData"]}), (mesh, {})):
            display = self.show(source, **FEW_MARKS, **drawn)
            display.IllustrationPaper = 1
            ColorBy(display, None)
            black = picture(self.view)
            self.assertLess(numpy.ptp(black, axis=-1).max(), 0.02, "gray")
            ColorBy(display, ("POINTS", "Elevation"))
            GetColorTransferFunction("Elevation").RGBPoints = [0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0.0, 0.0]
            pixels = picture(self.view)
            self.assertGreater((numpy.ptp(pixels, axis=-1) > 0.2).mean(), 0.02)
            self.assertGreater((pixels.max(axis=-1) < 0.2).sum(), 50, "lines")
            made = marks(display)[1]
            # Off and on again is a matter of drawing.
            ColorBy(display, None)
            numpy.testing.assert_array_equal(picture(self.view), black)
            ColorBy(display, ("POINTS", "Elevation"))
            numpy.testing.assert_array_equal(picture(self.view), pixels)
            self.assertEqual(marks(display)[1], made)
            Hide(source, self.view)

    def test_colors_come_back_after_marks_were_made_without(self):
        heights = Elevation(Input=Wavelet(), LowPoint=[0, 0, -10], HighPoint=[0, 0, 10])
        display = self.show(heights, IllustrationScalars=["POINTS", "RTData"])
        check_colors_come_back(self, display, "Illustration")

    def test_a_preset_sets_what_goes_with_it(self):
        display = self.show(Sphere(ThetaResolution=64, PhiResolution=64), **FEW_MARKS)
        before = marks(display)
        drawn = self.ink()
        display.IllustrationPreset = "Skin"
        self.assertEqual((display.IllustrationStippleSize, display.IllustrationPhi), (1.8, 60))
        self.assertLess(self.ink(), 0.9 * drawn)
        self.assertEqual(marks(display), before)

    def test_the_preset_bone_draws_the_surface_within(self):
        z, y, x = numpy.meshgrid(*[numpy.linspace(-1, 1, 32)] * 3, indexing="ij")
        blurred = lambda distance: 1 / (1 + numpy.exp(32 * distance))
        radius = numpy.sqrt(x * x + y * y + z * z)
        values = (60 * blurred(radius - 0.8) + 140 * blurred(radius - 0.4)).astype("f4")
        image = vtk.vtkImageData()
        image.SetDimensions(values.shape)
        array = numpy_to_vtk(values.ravel(), deep=True)
        array.SetName("density")
        image.GetPointData().SetScalars(array)
        source = TrivialProducer()
        source.GetClientSideObject().SetOutput(image)
        display = self.show(source)

        def value(**properties):
            SetProperties(display, **properties)
            picture(self.view)
            return display.IllustrationIsoValue

        outer = value()
        self.assertTrue(20 < outer < 50, outer)
        inner = value(IllustrationPreset="Bone")
        self.assertTrue(90 < inner < 160, inner)
        self.assertEqual(value(IllustrationPreset="Skin"), outer)
        self.assertEqual(value(IllustrationPreset="Bone", IllustrationIsoChoice="Outermost"), outer)
        self.assertEqual(value(IllustrationIsoChoice="Inner"), inner)
        self.assertEqual(value(IllustrationIsoValue=45), 45)
        self.assertEqual(value(IllustrationPreset="Specimen", IllustrationIsoChoice="Outermost"), 45)

    def test_see_through_shows_two_surfaces(self):
        display = self.show(Wavelet(), IllustrationAutomaticIsoValue=0, IllustrationIsoValue=200)
        inner = picture(self.view)
        display.IllustrationSeeThrough = 1
        display.IllustrationAutomaticOuterIsoValue = 0
        display.IllustrationOuterIsoValue = 120
        both = picture(self.view)
        # The outer one is around the inner one: measured 2.4 times its picture.
        self.assertGreater((~is_background(both)).mean(), 1.5 * (~is_background(inner)).mean())
        display.IllustrationOuterStrength = 0
        numpy.testing.assert_array_equal(picture(self.view), inner)

    def test_values_of_two_surfaces_are_shown_and_made_again_only_where_they_change(self):
        display = self.show(Wavelet())
        picture(self.view)
        once = marks(display)
        display.IllustrationOuterIsoValue = 60.0
        picture(self.view)
        self.assertEqual(marks(display), once, "there is none")
        display.IllustrationAutomaticOuterIsoValue = 1
        display.IllustrationIsoValue = 200.0
        display.IllustrationSeeThrough = 1
        picture(self.view)
        made = marks(display)
        outer = display.IllustrationOuterIsoValue
        self.assertTrue(37 < outer < 200, outer)
        for switch in (0, 1):
            display.IllustrationAutomaticOuterIsoValue = switch
            picture(self.view)
            self.assertEqual(marks(display), made)
        display.IllustrationOuterIsoValue = 120.0
        picture(self.view)
        self.assertEqual((marks(display)[1], display.IllustrationAutomaticOuterIsoValue), (made[1] + 1, 0))

    def test_grids_and_composites_are_drawn(self):
        wavelet = Wavelet(WholeExtent=[-8, 8] * 3)
        for source in grids_and_composites(wavelet):
            self.show(source, **FEW_MARKS)
            self.assertGreater((~is_background(picture(self.view))).mean(), 0.05, source)
            Hide(source, self.view)
        mixed = GroupDatasets(Input=[wavelet, Sphere()])
        with Warnings() as warnings:
            self.show(mixed, **FEW_MARKS)
            self.assertGreater((~is_background(picture(self.view))).mean(), 0.05)
        self.assertIn("1 datasets beside images", "".join(warnings))


if __name__ == "__main__":
    unittest.main(verbosity=2)
