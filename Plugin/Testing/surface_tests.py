# SPDX-License-Identifier: BSD-3-Clause
"""What representations of one surface have in common, as tests for classes of their own."""

import numpy

from paraview.simple import *

from rendering import Warnings, ink, inside, is_background, marks, picture


def grids_and_composites(wavelet):
    """Data that is neither an image nor a mesh alone."""
    unstructured = AppendDatasets(Input=[wavelet])
    structured = Transform(Input=Plane(XResolution=9, YResolution=9))
    meshes = GroupDatasets(Input=[Sphere(), Cone()])
    images = GroupDatasets(Input=[wavelet, Wavelet(WholeExtent=[9, 20, -8, 8, -8, 8])])
    return unstructured, structured, meshes, images


def check_iso_value(test, display, prefix, least=1000):
    """Of what is drawn at an automatic iso-value: the slider shows it, and marks are made again only at another one."""
    automatic = marks(display)
    test.assertGreater(automatic[0], least)
    shown = getattr(display, f"{prefix}IsoValue")
    test.assertTrue(37 < shown < 277, shown)
    for switch in (0, 1, 0):
        setattr(display, f"{prefix}AutomaticIsoValue", switch)
        picture(test.view)
        test.assertEqual(marks(display), automatic)
        test.assertEqual(getattr(display, f"{prefix}IsoValue"), shown)
    # Moved, it is what counts.
    setattr(display, f"{prefix}AutomaticIsoValue", 1)
    setattr(display, f"{prefix}IsoValue", 250.0)
    picture(test.view)
    test.assertEqual(getattr(display, f"{prefix}AutomaticIsoValue"), 0)
    test.assertNotEqual(marks(display)[0], automatic[0])
    test.assertEqual(marks(display)[1], automatic[1] + 1)


def check_colors_come_back(test, display, prefix):
    """Colors of an image's array, off while the surface becomes another one, and on again: marks made without get them."""
    array = ("POINTS", "Elevation")

    def share_of_colors():
        pixels = picture(test.view)
        return (numpy.ptp(pixels[inside(pixels)], axis=-1) > 0.2).mean()

    for value in (150.0, 170.0):
        ColorBy(display, array)
        test.assertGreater(share_of_colors(), 0.05)
        ColorBy(display, None)
        setattr(display, f"{prefix}IsoValue", value)
        test.assertLess(share_of_colors(), 0.01)
        made = marks(display)[1]
        ColorBy(display, array)
        test.assertGreater(share_of_colors(), 0.05)
        test.assertEqual(marks(display)[1], made + 1)


class SurfaceTests:
    """Tests that a TestInOneView takes beside its own. It has `show`, and
    PREFIX of its properties' names, and what SHOWS lines clearly, draws a WIDE outline, and makes FEW_MARKS of images, its
    properties by name."""

    FEW_MARKS = {}

    def set(self, display, **properties):
        for name, value in properties.items():
            setattr(display, self.PREFIX + name, value)

    def test_lines_are_drawn_on_paper_or_without_and_in_any_colors(self):
        display = self.show(Sphere(ThetaResolution=64, PhiResolution=32), **self.SHOWS)
        drawn = picture(self.view)
        self.assertFalse(is_background(drawn).any())
        numpy.testing.assert_array_equal(drawn[2, 2], 1.0)
        self.set(display, Paper=0)
        bare = picture(self.view)
        self.assertGreater(is_background(bare).mean(), 0.3)
        # Of green there is as much in the background as in white paper.
        self.assertAlmostEqual((1 - bare[..., 1]).sum(), (1 - drawn[..., 1]).sum(), delta=1)
        self.set(display, Paper=1, PaperColor=[1.0, 1.0, 0.0], InkColor=[0.0, 0.0, 1.0])
        colored = picture(self.view)
        numpy.testing.assert_array_equal(colored[2, 2], (1.0, 1.0, 0.0))
        # Blue ink, of which nothing is black on yellow paper.
        self.assertLess(colored[..., 0].min(), 0.05)
        self.assertGreater(colored.max(axis=-1).min(), 0.4)

    def test_an_image_is_drawn_at_a_value_that_suits_it_or_that_is_given(self):
        display = self.show(Wavelet(), **self.SHOWS, **self.FEW_MARKS)
        self.assertEqual(getattr(display, f"{self.PREFIX}AutomaticIsoValue"), 1)
        self.assertGreater((picture(self.view)[..., 0] < 0.5).mean(), 0.005)
        check_iso_value(self, display, self.PREFIX)
        # Beyond the data there is none.
        self.set(display, IsoValue=1e6)
        self.assertEqual(ink(picture(self.view)), 0)

    def test_grids_and_composites_are_drawn(self):
        for source in grids_and_composites(Wavelet(WholeExtent=[-8, 8] * 3)):
            self.show(source, **self.SHOWS, **self.FEW_MARKS)
            self.assertGreater(ink(picture(self.view)), 50, source)
            Hide(source, self.view)
        with Warnings() as warnings:
            self.show(PointSource(NumberOfPoints=50))
            self.assertEqual(ink(picture(self.view)), 0)
        self.assertIn("points without polygons", "".join(warnings))

    def test_points_of_a_mesh_are_picked_beside_its_lines(self):
        self.show(Sphere(ThetaResolution=64, PhiResolution=32), **self.WIDE)
        picture(self.view)
        SelectSurfacePoints(Rectangle=[0, 0, 199, 199], View=self.view)
        source = GetActiveSource()
        found = servermanager.Fetch(ExtractSelection(Input=source))
        # Of 1922 points those about the circle.
        self.assertTrue(32 < found.GetNumberOfPoints() < 400, found.GetNumberOfPoints())
        ClearSelection(source)

    def test_points_of_a_split_mesh_are_picked(self):
        # Without normals, its corners are three points each on the surface that is drawn.
        box = Clean(Input=Box())
        self.show(box, **self.WIDE)
        picture(self.view)
        SelectSurfacePoints(Rectangle=[0, 0, 199, 199], View=self.view)
        source = GetActiveSource()
        found = servermanager.Fetch(ExtractSelection(Input=source))
        self.assertTrue(4 <= found.GetNumberOfPoints() <= 8, found.GetNumberOfPoints())
        ClearSelection(source)

    def test_colors_of_arrays_make_nothing_again(self):
        """Lines have the ink's color."""
        display = self.show(Wavelet(), **self.SHOWS, **self.FEW_MARKS)
        ColorBy(display, None)
        first = picture(self.view)
        before = marks(display)
        ColorBy(display, ("POINTS", "RTData"))
        numpy.testing.assert_array_equal(picture(self.view), first)
        self.assertEqual(marks(display), before)

    def test_nothing_is_made_again_while_the_camera_moves(self):
        """Where it shows what is drawn much larger, see TestMagnification.py."""
        display = self.show(Wavelet(), **self.SHOWS, **self.FEW_MARKS)
        first = picture(self.view)
        before = marks(display)
        camera = GetActiveCamera()
        camera.Azimuth(40)
        camera.Zoom(1.5)
        self.assertTrue((picture(self.view) != first).any())
        self.assertEqual(marks(display), before)
