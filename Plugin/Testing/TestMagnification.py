# SPDX-License-Identifier: BSD-3-Clause
"""Marks follow how large the view shows them: in steps of two, of still pictures only, and not to and fro."""

import re
import unittest

import numpy

from paraview import simple
from paraview.simple import *

from rendering import green_view, marks, picture

# The first step up, and back, and the first one down, and back: the ends of a step are sqrt(2) times what is in its middle, and
# one leaves it 1.4 times beyond them.
UP, BACK_FROM_UP = 2**0.5 * 1.4, 2**0.5 / 1.4
DOWN, BACK_FROM_DOWN = 0.5**0.5 / 1.4, 0.5**0.5 * 1.4


def magnification(display):
    text = str(display.GetClientSideObject().GetActiveRepresentation())
    return float(re.search(r"Magnification: (\S+)", text)[1])


# A view's first picture would show all of what there is, wherever the camera was.
simple._DisableFirstRenderCameraReset()

# A surface of a wavelet in the middle of its bounds, which takes few marks in any view.
SMALL = {"IllustrationAutomaticIsoValue": 0, "IllustrationIsoValue": 200.0}


class TestMagnification(unittest.TestCase):
    def setUp(self):
        # Views of 500 pixels or more in height are alike.
        self.view = green_view(512)
        self.view.CameraParallelProjection = 1

    def tearDown(self):
        Delete(self.view)
        for source in GetSources().values():
            Delete(source)

    def show(self, source, style="Illustration", **properties):
        display = Show(source, self.view)
        display.SetRepresentationType(style)
        for name, value in properties.items():
            setattr(display, name, value)
        # Without the picture that simple.py's draws.
        self.view.ResetCamera()
        bounds = source.GetDataInformation().GetBounds()
        self.whole = 0.5 * numpy.linalg.norm(numpy.subtract(bounds[1::2], bounds[0::2]))
        return display

    def zoom(self, factor):
        """The picture, times a factor, in which the sphere around the data's bounds is as high as the view."""
        self.view.CameraParallelScale = self.whole / factor
        return picture(self.view)

    def assert_made(self, display, times, magnified, message=None):
        self.assertEqual((marks(display)[1], magnification(display)), (times, magnified), message)

    def test_a_step_makes_marks_once_and_its_ends_are_wide(self):
        display = self.show(Wavelet(), **SMALL)
        whole = self.zoom(1)
        self.assert_made(display, 1, 1)
        for factor, times, magnified in (
            (0.99 * UP, 1, 1),
            (1.01 * UP, 2, 2),
            (1.01 * UP, 2, 2),
            (1.005 * BACK_FROM_UP, 2, 2),
            (1, 3, 1),
            (1.01 * DOWN, 3, 1),
            (0.99 * DOWN, 4, 0.5),
            (0.99 * BACK_FROM_DOWN, 4, 0.5),
            (1, 5, 1),
        ):
            self.zoom(factor)
            self.assert_made(display, times, magnified, factor)
        numpy.testing.assert_array_equal(self.zoom(1), whole)

    def test_surfaces_are_sampled_as_finely_as_they_are_seen(self):
        # 128 voxels along the longest side.
        wavelet = Wavelet(WholeExtent=[-64, 63, -64, 63, -4, 3])
        # Points along a cut are not as many.
        surface = {"LinesAutomaticIsoValue": 0, "LinesIsoValue": 150.0, "LinesCut": "Open"}
        display = self.show(wavelet, "Splatting Lines", **surface)
        counts = []
        for factor in (1, 2, 4, 1, 0.5):
            self.zoom(factor)
            counts.append(marks(display)[0])
        # Cells of half a voxel, of a quarter and of an eighth, and voxels; a cell has a point.
        for finer, coarser in ((1, 0), (2, 1), (3, 4)):
            self.assertAlmostEqual(counts[finer] / counts[coarser], 4, delta=0.7)
        self.assertEqual(counts[3], counts[0])
        self.zoom(1)
        chosen = magnification(display)
        display.LinesSubdivision = 2
        picture(self.view)
        given = marks(display)
        self.assertEqual(given[0], counts[0])
        self.zoom(2)
        self.assertEqual(marks(display), given, "what is given stays")
        self.assertNotEqual(magnification(display), chosen)

    def test_stipples_are_as_many_as_there_is_room_for(self):
        display = self.show(Sphere(ThetaResolution=64, PhiResolution=64))
        close = self.zoom(4)
        # Room for 4.2 million; two are made at most.
        display.IllustrationNumberOfSurfaceStipples = 2_000_000
        numpy.testing.assert_array_equal(picture(self.view), close)
        # As many as for a view of all: pi times the square of the diameter in thousandths of the height, four of them for each.
        display.IllustrationNumberOfSurfaceStipples = round(numpy.pi * 1000**2 / 3 / 4)
        self.assertGreater(numpy.abs(picture(self.view) - close).mean(), 0.05, "as few are larger")

    def test_an_interaction_makes_nothing(self):
        display = self.show(Wavelet(), **SMALL)
        self.zoom(1)
        for factor in (2, 4, 8):
            self.view.CameraParallelScale = self.whole / factor
            self.view.SMProxy.InteractiveRender()
            self.assert_made(display, 1, 1)
        picture(self.view)
        self.assert_made(display, 2, 8)

    def test_what_the_marks_do_not_depend_on_makes_nothing(self):
        mesh = self.show(Sphere(ThetaResolution=32, PhiResolution=32), "Contours")
        self.zoom(8)
        self.assert_made(mesh, 1, 8)
        Hide(GetActiveSource(), self.view)
        hatched = self.show(Sphere(ThetaResolution=32, PhiResolution=32), "Line Art", LineArtDensity=0, LineArtLineSpacing=16)
        self.zoom(8)
        self.assert_made(hatched, 1, 1, "traced for a view of all")
        Hide(GetActiveSource(), self.view)
        full = self.show(Wavelet(), **SMALL)
        self.zoom(4)
        self.zoom(100)
        self.assert_made(full, 2, 8, "there are as many as there can be")

    def test_a_view_of_another_size_makes_nothing_within_a_step(self):
        display = self.show(Wavelet(), **SMALL)
        self.zoom(1)
        # As many pixels as one likes, and down to 0.505 of 500.
        for size, times in (([900, 900], 1), ([900, 512], 1), ([400, 260], 1), ([300, 240], 2), ([300, 480], 2), ([300, 500], 3)):
            self.view.ViewSize = size
            # Higher than wide, it would show more.
            picture(self.view)
            self.assertEqual(marks(display)[1], times, size)

    def test_the_first_picture_is_as_fine_as_the_later_ones(self):
        wavelet = Wavelet()
        self.show(wavelet, **SMALL)
        self.zoom(1)
        expected = self.zoom(2.2)
        Delete(GetDisplayProperties(wavelet, self.view))
        display = Show(wavelet, self.view)
        display.SetRepresentationType("Illustration")
        SetProperties(display, **SMALL)
        numpy.testing.assert_array_equal(picture(self.view), expected)
        self.assertEqual(magnification(display), 2)

    def test_the_eye_comes_near_and_goes_through(self):
        self.view.CameraParallelProjection = 0
        display = self.show(Wavelet(), **SMALL)
        # How wide it is does not matter, and near points take many pixels.
        self.view.ViewSize = [100, 512]
        picture(self.view)
        self.assert_made(display, 1, 1)
        camera = GetActiveCamera()
        whole = camera.GetDistance()
        steps = []
        for factor in (1, 0.7, 0.4, 0.2, 0.01):
            camera.Dolly(camera.GetDistance() / (factor * whole))
            picture(self.view)
            steps.append(magnification(display))
        self.assertEqual(steps, sorted(steps))
        self.assertEqual((steps[0], steps[-1]), (1, 8))
        # Looking away nothing is seen that marks could be made for.
        made = marks(display)
        camera.Yaw(180)
        camera.SetDistance(whole)
        picture(self.view)
        self.assertEqual((marks(display), magnification(display)), (made, 8))

    def test_what_is_moved_and_scaled_is_seen_where_it_is(self):
        display = self.show(Wavelet(), **SMALL)
        self.zoom(1)
        display.Scale = [2.2, 2.2, 2.2]
        picture(self.view)
        self.assert_made(display, 2, 2)
        display.Position = [1000, 0, 0]
        display.Scale = [1, 1, 1]
        picture(self.view)
        self.assert_made(display, 2, 2, "it is not in the view")


if __name__ == "__main__":
    unittest.main(verbosity=2)
