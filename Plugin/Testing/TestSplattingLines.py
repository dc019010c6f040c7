# SPDX-License-Identifier: BSD-3-Clause
"""The representation Splatting Lines: what it draws of which data, and what its properties change."""

import json
import pathlib
import re
import tempfile
import unittest

import numpy

from rendering import *
from paraview.vtk.util.numpy_support import vtk_to_numpy
from splatting_lines_tests import SplattingLinesTests
from surface_tests import check_colors_come_back, check_iso_value


def sampled_wavelet():
    wavelet = Wavelet()
    wavelet.UpdatePipeline()
    return InkIsoSurfaceSampler(Input=wavelet, Isosurfaces=[130.0])


class TestSplattingLines(SplattingLinesTests, unittest.TestCase):
    def test_is_what_the_sampler_is_shown_with(self):
        self.assertEqual(Show(sampled_wavelet(), self.view).Representation, "Splatting Lines")

    def test_draws_paper_and_ink(self):
        self.show(sampled_wavelet(), Phi=100)
        pixels = picture(self.view)
        self.assert_drawn(pixels)
        self.assertGreater(numpy.all(pixels > 0.99, axis=-1).mean(), 0.1)
        self.assertGreater(numpy.all(pixels < 0.5, axis=-1).mean(), 0.01)

    def test_images_are_drawn_by_their_iso_surface(self):
        wavelet = Wavelet()
        display = self.show(wavelet, Phi=100)
        automatic = picture(self.view)
        self.assertGreater(numpy.all(automatic < 0.5, axis=-1).mean(), 0.005)
        check_iso_value(self, display, "Lines")
        self.assertGreater(numpy.abs(picture(self.view) - automatic).max(), 0.5)
        # Meshes have none.
        Hide(wavelet, self.view)
        self.show(Sphere(), LinesAutomaticIsoValue=0, LinesIsoValue=1e6)
        self.assertGreater((~is_background(picture(self.view))).mean(), 0.1)

    def test_more_tau_phi_and_lambda_change_the_ink(self):
        display = self.show(sampled_wavelet())
        by_tau, by_phi = [], []
        for display.Tau in (0.95, 1.0, 1.05):
            by_tau.append(ink(picture(self.view)))
        display.Tau = 1.0
        for display.Phi in (0.0, 20.0, 100.0):
            by_phi.append(ink(picture(self.view)))
        fine = picture(self.view)
        display.Lambda = 6
        broad = picture(self.view)
        self.assertEqual(by_tau, sorted(set(by_tau)))
        self.assertEqual(by_phi, sorted(set(by_phi)))
        self.assertLess(by_phi[0], 1.0)
        self.assertGreater(numpy.abs(fine - broad).mean(), 0.005)

    def test_colors(self):
        self.show(sampled_wavelet(), Phi=500, InkColor=[0, 0, 1], PaperColor=[1, 0, 0])
        pixels = picture(self.view)
        drawn = pixels[inside(pixels)]
        # But where an outline around a hole of less than a pixel is beyond the surface for a part.
        self.assertLess((drawn[:, 1] > 0.02).mean(), 0.001)
        self.assertGreater(drawn[:, 0].max(), 0.98)
        self.assertGreater(drawn[:, 2].max(), 0.9)

    def test_styles_of_lines(self):
        display = self.show(sampled_wavelet())
        plain = ink(picture(self.view))
        display.AddedLineWidth = 8
        self.assertGreater(ink(picture(self.view)), 1.2 * plain)
        display.AddedLineWidth = 0
        display.Thinning = True
        self.assertLess(ink(picture(self.view)), 0.8 * plain)
        display.Thinning = False
        display.SpeckleLength = 1000
        self.assertEqual(ink(picture(self.view)), 0)
        display.SpeckleLength = 0
        display.CullBackFaces = True
        self.assertAlmostEqual(ink(picture(self.view)) / plain, 1.0, delta=0.3)

    def test_hidden_lines(self):
        """A small ball in a large one."""
        balls = [Sphere(Radius=r, ThetaResolution=100, PhiResolution=100) for r in (0.2, 0.5)]
        display = self.show(GroupDatasets(Input=balls), HiddenStrength=1.0)

        def inside():
            return ink(picture(self.view)[70:130, 70:130])

        self.assertEqual(inside(), 0)
        display.HiddenLayers = True
        solid = inside()
        self.assertGreater(solid, 10)
        display.HiddenDashLength = 25
        self.assertLess(inside(), 0.9 * solid)
        display.HiddenDashLength = 0
        display.HiddenStrength = 0.3
        self.assertLess(inside(), 0.5 * solid)
        display.HiddenColor = [1, 0, 0]
        self.assertGreater(inside(), 0, "the ink's color still")
        display.UseHiddenColor = True
        self.assertAlmostEqual(inside(), 0, delta=0.5)  # red, as white, has all red
        display.InkColor = [0, 0, 1]
        display.UseHiddenColor = False
        pixels = picture(self.view)[70:130, 70:130]
        self.assertAlmostEqual(pixels[..., 2].min(), 1.0, delta=0.01)
        self.assertLess(pixels[..., 0].min(), 0.8)
        display.NumberOfLayers = 1
        self.assertEqual(inside(), 0)

    def test_colors_of_tone_and_of_arrays(self):
        display = self.show(sampled_wavelet(), Tau=1.02, ToneColor=[1, 0, 0])
        pixels = picture(self.view)
        # But for 6 of 10,723 pixels, in narrow gaps between surfaces that ink of both sides reaches into.
        self.assertLess((pixels[inside(pixels)].ptp(axis=1) > 0.01).mean(), 0.001)
        display.ColorByTone = True
        pixels = picture(self.view)
        self.assertGreater((pixels[..., 0] - pixels[..., 1])[~is_background(pixels)].max(), 0.3)

        def share_of_color():
            pixels = picture(self.view)
            drawn = pixels[inside(pixels)]
            return (drawn.ptp(axis=1) > 0.1).sum() / (drawn.min(axis=1) < 0.5).sum()

        display.ColorByTone = False
        self.assertLess(share_of_color(), 0.002)
        ColorBy(display, ("POINTS", "Normals", "X"))
        self.assertGreater(share_of_color(), 0.5)
        ColorBy(display, None)
        self.assertLess(share_of_color(), 0.002)

    def test_colors_come_back_after_points_were_made_without(self):
        heights = Elevation(Input=Wavelet(), LowPoint=[0, 0, -10], HighPoint=[0, 0, 10])
        display = self.show(heights, Phi=100, LinesScalars=["POINTS", "RTData"])
        check_colors_come_back(self, display, "Lines")

    def test_colors_of_cells(self):
        sphere = Sphere(ThetaResolution=60, PhiResolution=60)
        ids = ProcessIdScalars(Input=sphere)
        cells = PointDatatoCellData(Input=Calculator(Input=ids, ResultArrayName="Height", Function="coordsZ"))
        cells.PassPointData = True
        display = self.show(cells, Tau=1.05)
        ColorBy(display, ("CELLS", "Height"))
        pixels = picture(self.view)
        self.assertGreater(pixels[~is_background(pixels)].ptp(axis=1).max(), 0.3)

    def test_while_moving_fewer_points_are_drawn_and_then_all_again(self):
        display = self.show(sampled_wavelet(), PointsWhileMoving=1000)
        still = picture(self.view)

        def moving():
            self.view.SMProxy.InteractiveRender()
            pixels = vtk.vtkUnsignedCharArray()
            self.view.SMProxy.GetRenderWindow().GetPixelData(0, 0, 199, 199, 0, pixels, 0)
            return vtk_to_numpy(pixels).reshape(200, 200, 3) / 255.0

        self.view.LODThreshold = 1000.0
        numpy.testing.assert_allclose(moving(), still, atol=0.01)
        self.view.LODThreshold = 0.0
        fewer = moving()
        self.assert_drawn(fewer)
        self.assertGreater(numpy.abs(fewer - still).mean(), 0.01)
        self.assertLess(numpy.mean(is_background(fewer) != is_background(still)), 0.08)
        display.PointsWhileMoving = 0
        numpy.testing.assert_allclose(moving(), still, atol=0.01)
        display.PointsWhileMoving = 1000
        moving()
        numpy.testing.assert_array_equal(picture(self.view), still)

    def test_paper_opacity_and_visibility(self):
        display = self.show(sampled_wavelet(), Phi=100)
        whole = picture(self.view)
        display.PaperVisibility = False
        lines = picture(self.view)
        self.assertGreater(is_background(lines).mean(), is_background(whole).mean() + 0.1)
        self.assertLess(is_background(lines).mean(), 1.0)
        display.PaperVisibility = True
        display.Opacity = 0.5
        faint = picture(self.view)
        paper = numpy.all(whole > 0.99, axis=-1)
        numpy.testing.assert_allclose(numpy.median(faint[paper], axis=0), [0.5, 1.0, 0.5], atol=0.02)
        display.Opacity = 1
        display.Visibility = 0
        self.assertTrue(is_background(picture(self.view)).all())
        display.Visibility = 1
        numpy.testing.assert_array_equal(picture(self.view), whole)

    def test_ambient_occlusion_leaves_lines_as_they_are(self):
        self.show(sampled_wavelet())
        ball = Sphere(Radius=4, Center=[5, 0, 14], ThetaResolution=32, PhiResolution=32)
        # In a color that no line has: a gray ball has some pixels of the gray of the lines that it hides.
        color = [1, 0, 0]
        Show(ball, self.view, AmbientColor=color, DiffuseColor=color)
        plain = picture(self.view)
        Hide(ball, self.view)
        alone = is_background(picture(self.view))
        lines = ~alone & (numpy.abs(picture(self.view) - plain).max(axis=-1) == 0)
        self.assertGreater(lines.mean(), 0.1)
        Show(ball, self.view)
        self.view.UseAmbientOcclusion = True
        shaded = picture(self.view)
        numpy.testing.assert_allclose(shaded[lines], plain[lines], atol=0.01)
        self.assertGreater(numpy.abs(shaded - plain).max(), 0.01, "of the ball")

    def test_other_representations_take_over_and_give_back(self):
        display = self.show(sampled_wavelet())
        drawing = picture(self.view)
        display.SetRepresentationType("Outline")
        self.assertLess((~is_background(picture(self.view))).mean(), 0.05)
        display.SetRepresentationType("Splatting Lines")
        numpy.testing.assert_array_equal(picture(self.view), drawing)

    def test_is_moved_and_scaled_with_its_bounds(self):
        display = self.show(Sphere(ThetaResolution=60, PhiResolution=60))
        at_home = picture(self.view)
        display.Position = [100, 0, 0]
        display.Scale = [2, 2, 2]
        self.assertTrue(is_background(picture(self.view)).all())
        ResetCamera(self.view)
        numpy.testing.assert_allclose(self.view.CameraFocalPoint, [100, 0, 0], atol=0.01)
        away = picture(self.view)
        self.assertLess(numpy.mean(is_background(at_home) != is_background(away)), 0.01)

    def test_new_data_is_drawn(self):
        sampler = sampled_wavelet()
        self.show(sampler)
        before = picture(self.view)
        sampler.Isosurfaces = [200.0]
        after = picture(self.view)
        self.assertGreater(is_background(after).mean(), is_background(before).mean() + 0.1)

    def test_hidden_lines_have_the_arrays_colors_unless_they_have_their_own(self):
        inner, outer = Sphere(Radius=0.3, ThetaResolution=100, PhiResolution=100), Sphere(
            Radius=0.5, ThetaResolution=100, PhiResolution=100
        )
        both = MergeBlocks(Input=GroupDatasets(Input=[inner, outer]))
        radius = Calculator(Input=both, ResultArrayName="Distance", Function="mag(coords)")
        display = self.show(radius, HiddenLayers=True, NumberOfLayers=2, HiddenStrength=1, PaperColor=[1, 1, 1])
        ColorBy(display, ("POINTS", "Distance"))
        table = GetColorTransferFunction("Distance")
        table.RGBPoints = [0.3, 1, 0, 0, 0.4, 1, 0, 0, 0.41, 0, 0, 1, 0.5, 0, 0, 1]

        def middle():
            # Away from the outer sphere's contour, what is not paper is the inner one's.
            pixels = picture(self.view)[62:138, 62:138].reshape(-1, 3)
            return pixels[pixels.min(axis=1) < 0.2]

        lines = middle()
        self.assertGreater(len(lines), 50)
        self.assertGreater(lines[:, 0].min(), 0.9)
        display.UseHiddenColor, display.HiddenColor = True, [0, 0, 1]
        lines = middle()
        self.assertGreater(lines[:, 2].min(), 0.9)
        self.assertLess(lines[:, 0].min(), 0.2)

    def test_exported_scenes_have_the_points(self):
        sampler = sampled_wavelet()
        self.show(sampler)
        Render(self.view)
        count = sampler.GetDataInformation().GetNumberOfPoints()
        with tempfile.TemporaryDirectory() as folder:

            def exported(name):
                path = pathlib.Path(folder) / name
                ExportView(str(path), view=self.view)
                return path.read_text(encoding="utf-8")

            points = re.findall(r'<Coordinate[^>]*point="([^"]*)"', exported("scene.x3d"))
            self.assertEqual(sum(len(one.replace(",", " ").split()) for one in points), 3 * count)
            scene = json.loads(exported("scene.gltf"))
            positions = [
                scene["accessors"][primitive["attributes"]["POSITION"]]["count"]
                for mesh in scene["meshes"]
                for primitive in mesh["primitives"]
            ]
            self.assertEqual(positions, [count])
            self.assertGreater(len(exported("scene.vrml").splitlines()), count)


if __name__ == "__main__":
    unittest.main()
