# SPDX-License-Identifier: BSD-3-Clause
"""Contours of images, meshes and grids in ParaView's view, and silhouettes over the other drawings."""

import math
import pathlib
import unittest

import numpy

from paraview.simple import *

from rendering import TestInOneView, ink, marks, picture
from surface_tests import SurfaceTests

PENCIL = pathlib.Path(__file__).resolve().parents[2] / "Data" / "pencil.png"
STYLES = {"Illustration": "Illustration", "Splatting Lines": "Lines", "Stipple": "Stipple"}
# Of surfaces, whose number does not matter.
FEW_MARKS = {
    "Illustration": {"IllustrationNumberOfSurfaceStipples": 20000},
    "Splatting Lines": {"LinesNumberOfSamples": 20000},
    "Stipple": {"NumberOfSurfaceStipples": 20000},
}


def sphere():
    return Sphere(ThetaResolution=120, PhiResolution=60)


class TestContours(SurfaceTests, TestInOneView):
    PREFIX = "Contours"
    SHOWS = {"ContoursLineWidth": 10}
    WIDE = {"ContoursLineWidth": 20}
    FEW_MARKS = {"ContoursSubdivision": 1}

    def show(self, source, style="Contours", **properties):
        display = Show(source, self.view)
        display.SetRepresentationType(style)
        display.ColorArrayName = ["POINTS", ""]
        for name, value in properties.items():
            setattr(display, name, value)
        self.view.CameraParallelProjection = 1
        ResetCamera(self.view)
        return display

    def circle(self, pixels, width):
        """The radius of the circle that the ink is; there is no other."""
        size = pixels.shape[0]
        y, x = numpy.mgrid[:size, :size] + 0.5 - size / 2
        away = numpy.hypot(x, y)
        dark = 1 - pixels[..., 0]
        radius = float((dark * away).sum() / dark.sum())
        self.assertLess(dark[numpy.abs(away - radius) > width / 2 + 2].sum(), 0.001 * dark.sum())
        self.assertAlmostEqual(dark.sum() / (2 * numpy.pi * radius * width), 1.0, delta=0.1)
        return radius

    def test_a_sphere_is_a_circle(self):
        # Two hundredths of 200 pixels.
        self.show(sphere(), ContoursLineWidth=20, ContoursDepthWidth=0)
        radius = self.circle(picture(self.view), 4)
        GetActiveCamera().Azimuth(60)
        self.assertAlmostEqual(self.circle(picture(self.view), 4), radius, delta=0.3)

    def test_lines_are_what_is_asked_for(self):
        display = self.show(Box(), ContoursLineWidth=10, ContoursDepthWidth=0)
        GetActiveCamera().Azimuth(35)
        GetActiveCamera().Elevation(30)
        whole = ink(picture(self.view))
        made = marks(display)
        display.ContoursCreases = 0
        outline = ink(picture(self.view))
        # Six of nine edges, which are of different lengths.
        self.assertTrue(0.5 * whole < outline < 0.8 * whole, (outline, whole))
        display.ContoursCreases = 1
        display.ContoursHiddenLines = "Dashed"
        dashed = ink(picture(self.view))
        self.assertTrue(1.05 * whole < dashed < 1.5 * whole, (dashed, whole))
        display.ContoursHiddenLines = "Faint"
        display.ContoursHiddenOpacity = 1.0
        self.assertGreater(ink(picture(self.view)), dashed)
        display.ContoursSilhouettes = display.ContoursBorders = display.ContoursCreases = 0
        self.assertEqual(ink(picture(self.view)), 0)
        # All of that without another surface.
        self.assertEqual(marks(display), made)

    def test_a_preset_sets_what_goes_with_it(self):
        display = self.show(sphere())
        before = marks(display)
        drawn = ink(picture(self.view))
        display.ContoursPreset = "Brush"
        found = (display.ContoursLineWidth, display.ContoursTaper, display.ContoursCreases)
        self.assertEqual(found, (6.0, 0.8, 0))
        self.assertGreater(ink(picture(self.view)), 1.2 * drawn)
        display.ContoursPreset = "Hidden Lines"
        self.assertEqual((display.ContoursHiddenLines, display.ContoursJoin), ("Dashed", "Pointed"))
        self.assertEqual(marks(display), before)

    def look(self, position, focal_point, up):
        camera = GetActiveCamera()
        camera.SetPosition(position)
        camera.SetFocalPoint(focal_point)
        camera.SetViewUp(up)

    def test_density_and_texture(self):
        smaller = Sphere(Radius=0.2, Center=[1, 0, 0], ThetaResolution=120, PhiResolution=60)
        # Side by side; other tests go on from where the camera was.
        camera = GetActiveCamera()
        self.addCleanup(self.look, camera.GetPosition(), camera.GetFocalPoint(), camera.GetViewUp())
        self.look((0, 0, 9), (0, 0, 0), (0, 1, 0))
        both = AppendGeometry(Input=[sphere(), smaller])
        display = self.show(both, ContoursLineWidth=30, ContoursDepthWidth=0)
        whole = ink(picture(self.view))
        made = marks(display)
        display.ContoursDensity = 0.5
        # The larger one's circle.
        self.assertAlmostEqual(ink(picture(self.view)) / whole, 5 / 7, delta=0.02)
        display.ContoursDensity = 1.0
        display.ContoursTexture = str(PENCIL)
        self.assertTrue(0.2 * whole < ink(picture(self.view)) < 0.9 * whole)
        display.ContoursTexture = ""
        self.assertEqual(ink(picture(self.view)), whole)
        self.assertEqual(marks(display), made)

    def length_of(self, lines):
        return IntegrateVariables(Input=lines).CellData["Length"].GetRange()[0]

    def test_the_filter_finds_lines_for_an_eye(self):
        lines = InkContours(Input=sphere(), EyeDirection=[1, 2, 3], Borders=0)
        self.assertEqual(lines.GetHints().FindNestedElementByName("ShowInMenu").GetAttribute("category"), "Ink")
        # A great circle, and from an eye at twice the radius one of radius r sqrt(1 - 1 / 4).
        self.assertAlmostEqual(self.length_of(lines), math.pi, delta=0.01)
        lines.Eye = "Position"
        lines.EyePosition = [0.0, 0.0, 1.0]
        self.assertAlmostEqual(self.length_of(lines), math.pi * math.sqrt(0.75), delta=0.01)
        lines = InkContours(Input=Box(), Silhouettes=0, Creases=1)
        self.assertAlmostEqual(self.length_of(lines), 12.0, delta=1e-6)
        self.assertEqual(lines.CellData["ContourKind"].GetRange(), (1, 1))

    def test_the_filter_takes_images(self):
        ball = Calculator(Input=Wavelet(), ResultArrayName="distance", Function="mag(coords)")
        lines = InkContours(Input=ball, ContourBy=["POINTS", "distance"], Isosurfaces=[6.0])
        self.assertAlmostEqual(self.length_of(lines), 12 * math.pi, delta=0.2)
        lines.Method = "Segments Through Voxels"
        lines.UpdatePipeline()
        wavelet = Wavelet()
        wavelet.UpdatePipeline()
        low, high = wavelet.PointData["RTData"].GetRange(0)
        suggested = InkContours(Input=wavelet)
        self.assertTrue(low < suggested.Isosurfaces[0] < high)
        self.assertGreater(self.length_of(suggested), 10)

    def test_silhouettes_over_the_other_drawings(self):
        for style, prefix in STYLES.items():
            for make in (sphere, lambda: Wavelet(WholeExtent=[-5, 5] * 3)):
                with self.subTest(style, source=make):
                    source = make()
                    display = self.show(source, style, **FEW_MARKS[style])
                    self.assertEqual(getattr(display, f"{prefix}Silhouettes"), 0)
                    plain = picture(self.view)
                    setattr(display, f"{prefix}Silhouettes", 1)
                    setattr(display, f"{prefix}SilhouetteWidth", 30)
                    outlined = picture(self.view)
                    self.assertGreater(ink(outlined), ink(plain) + 200)
                    for method in ("Image Space", "Toon Shading", "Segments Through Voxels"):
                        setattr(display, f"{prefix}SilhouetteMethod", method)
                        self.assertNotEqual(picture(self.view).tolist(), outlined.tolist(), method)
                    setattr(display, f"{prefix}Silhouettes", 0)
                    numpy.testing.assert_array_equal(picture(self.view), plain)
                    Hide(source, self.view)


if __name__ == "__main__":
    unittest.main(verbosity=2)
