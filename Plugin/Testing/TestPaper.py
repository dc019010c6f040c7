# SPDX-License-Identifier: BSD-3-Clause
"""The paper: a plain background of views with vtkInk's representations, and of no others."""

import pathlib
import tempfile
import unittest

import numpy

from vtkmodules.vtkIOImage import vtkPNGReader
from paraview.vtk.util.numpy_support import vtk_to_numpy
from rendering import *

WHITE, BLACK, RED = (1, 1, 1), (0, 0, 0), (1, 0, 0)


class TestPaper(TestInOneView):
    def setUp(self):
        super().setUp()
        self.sphere = Sphere(ThetaResolution=32, PhiResolution=32)

    def show(self, representation, source=None, view=None):
        display = Show(source or self.sphere, view or self.view)
        display.NumberOfSurfaceStipples = 1000
        display.SetRepresentationType(representation)
        ResetCamera(view or self.view)
        return display

    def corner(self, view=None):
        return tuple(picture(view or self.view)[2, 2].round(3))

    def test_is_white_behind_both_representations_only_and_while_they_are_seen(self):
        display = self.show("Surface")
        self.assertEqual(self.corner(), BACKGROUND)
        for representation in ("Stipple", "Splatting Lines"):
            display.SetRepresentationType(representation)
            self.assertEqual(self.corner(), WHITE, representation)
            Hide(self.sphere, self.view)
            self.assertEqual(self.corner(), BACKGROUND, representation)
            Show(self.sphere, self.view)
            self.assertEqual(self.corner(), WHITE, representation)
            display.SetRepresentationType("Outline")
            self.assertEqual(self.corner(), BACKGROUND, representation)
        self.assertEqual(tuple(self.view.Background), BACKGROUND)
        display.SetRepresentationType("Stipple")
        Delete(display)
        self.assertEqual(self.corner(), BACKGROUND)

    def test_has_a_color_and_can_be_switched_off(self):
        display = self.show("Splatting Lines")
        display.PaperColor = RED
        self.assertEqual(self.corner(), RED)
        display.LinesPaper = False
        self.assertEqual(self.corner(), BACKGROUND)
        display.SetRepresentationType("Stipple")
        display.StipplePaperColor = RED
        self.assertEqual(self.corner(), RED)
        display.StipplePaper = False
        self.assertEqual(self.corner(), BACKGROUND)

    def test_is_black_for_the_plate(self):
        display = self.show("Stipple")
        display.StipplePreset = "Plate, White on Black"
        self.assertEqual(self.corner(), BLACK)
        display.StipplePreset = "Bone"
        self.assertEqual(self.corner(), WHITE)

    def test_covers_gradients_and_leaves_them(self):
        self.view.BackgroundColorMode = "Gradient"
        self.view.Background2 = [0, 0, 1]
        before = picture(self.view)
        self.show("Stipple")
        self.assertEqual(self.corner(), WHITE)
        Hide(self.sphere, self.view)
        numpy.testing.assert_array_equal(picture(self.view), before)
        self.view.BackgroundColorMode = "Single Color"

    def test_is_the_last_shown_ones(self):
        self.show("Stipple").StipplePaperColor = RED
        other = Sphere(Center=[2, 0, 0])
        self.show("Stipple", other)
        self.assertEqual(self.corner(), WHITE)
        Hide(other, self.view)
        self.assertEqual(self.corner(), RED)
        Hide(self.sphere, self.view)
        self.assertEqual(self.corner(), BACKGROUND)

    def test_other_views_keep_their_backgrounds(self):
        other = green_view()
        self.show("Surface", view=other)
        self.show("Stipple")
        self.assertEqual((self.corner(), self.corner(other)), (WHITE, BACKGROUND))
        Delete(other)
        SetActiveView(self.view)

    def test_a_transparent_picture_has_none(self):
        self.show("Stipple")
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "picture.png"
            SaveScreenshot(str(file), self.view, TransparentBackground=1)
            reader = vtkPNGReader()
            reader.SetFileName(str(file))
            reader.Update()
        pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
        alpha = pixels.reshape(200, 200, 4)[..., 3]
        self.assertEqual(alpha[2, 2], 0)
        self.assertGreater(alpha.max(), 200)
        self.assertEqual(self.corner(), WHITE)

    def test_nothing_is_picked_on_it(self):
        self.show("Splatting Lines")
        picture(self.view)
        SelectSurfacePoints(Rectangle=[0, 0, 9, 9], View=self.view)
        self.assertIsNone(self.sphere.SMProxy.GetSelectionInput(0))


if __name__ == "__main__":
    unittest.main()
