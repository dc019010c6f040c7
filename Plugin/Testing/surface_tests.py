# SPDX-License-Identifier: BSD-3-Clause
"""What representations of one surface have in common, as tests for classes of their own."""

from paraview.simple import *

from rendering import Warnings, ink, picture


class SurfaceTests:
    """Tests that a TestInOneView takes beside its own. It has `show` and `marks`, and
    PREFIX of its properties' names, and what SHOWS an image clearly, its properties by name."""

    def test_an_image_is_drawn_at_a_value_that_suits_it_or_that_is_given(self):
        display = self.show(Wavelet(), **self.SHOWS)
        self.assertEqual(getattr(display, f"{self.PREFIX}AutomaticIsoValue"), 1)
        self.assertGreater((picture(self.view)[..., 0] < 0.5).mean(), 0.005)
        automatic = self.marks(display)
        self.assertGreater(automatic[0], 1000)
        setattr(display, f"{self.PREFIX}IsoValue", 250.0)
        picture(self.view)
        self.assertEqual(self.marks(display), automatic)
        setattr(display, f"{self.PREFIX}AutomaticIsoValue", 0)
        picture(self.view)
        self.assertNotEqual(self.marks(display)[0], automatic[0])
        # Beyond the data there is none.
        setattr(display, f"{self.PREFIX}IsoValue", 1e6)
        self.assertEqual(ink(picture(self.view)), 0)

    def test_grids_and_composites_are_drawn(self):
        wavelet = Wavelet(WholeExtent=[-8, 8] * 3)
        unstructured = AppendDatasets(Input=[wavelet])
        structured = Transform(Input=Plane(XResolution=9, YResolution=9))
        groups = [GroupDatasets(Input=[Sphere(), Cone()]), GroupDatasets(Input=[wavelet, Wavelet(WholeExtent=[9, 20, -8, 8, -8, 8])])]
        for source in (unstructured, structured, *groups):
            self.show(source)
            self.assertGreater(ink(picture(self.view)), 50, source)
            Hide(source, self.view)
        with Warnings() as warnings:
            self.show(PointSource(NumberOfPoints=50))
            self.assertEqual(ink(picture(self.view)), 0)
        self.assertIn("points without polygons", "".join(warnings))

    def test_nothing_is_made_again_while_the_camera_moves(self):
        display = self.show(Wavelet())
        first = picture(self.view)
        before = self.marks(display)
        camera = GetActiveCamera()
        camera.Azimuth(40)
        camera.Zoom(4)
        self.assertTrue((picture(self.view) != first).any())
        self.assertEqual(self.marks(display), before)
