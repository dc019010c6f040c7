# SPDX-License-Identifier: BSD-3-Clause
"""The representation Splatting Lines: which points it draws of meshes, of grids and of points."""

import unittest

import numpy

from paraview import servermanager
from rendering import *
from splatting_lines_tests import SplattingLinesTests


# Where their number does not matter.
FEW_MARKS = {"LinesNumberOfSamples": 20000}


class TestSplattingLinesOfMeshes(SplattingLinesTests, unittest.TestCase):
    def test_any_points_with_normals(self):
        sphere = Sphere(ThetaResolution=60, PhiResolution=60)
        self.show(sphere, **FEW_MARKS)
        of_surface = picture(self.view)
        self.assert_drawn(of_surface)
        Hide(sphere, self.view)
        self.show(AppendDatasets(Input=[sphere]), **FEW_MARKS)  # a vtkUnstructuredGrid
        numpy.testing.assert_array_equal(picture(self.view), of_surface)

    def test_composite_data_is_drawn_as_one(self):
        left = Sphere(ThetaResolution=60, PhiResolution=60, Center=[-0.25, 0, 0])
        right = Sphere(ThetaResolution=60, PhiResolution=60, Center=[0.25, 0, 0])
        one = AppendGeometry(Input=[left, right])
        self.show(one)
        of_one = picture(self.view)
        Hide(one, self.view)
        self.show(GroupDatasets(Input=[left, right]))
        numpy.testing.assert_array_equal(picture(self.view), of_one)

    def test_ghost_points_are_left_out(self):
        source = ProgrammableSource(OutputDataSetType="vtkPolyData")
        source.Script = """
import vtk
sphere = vtk.vtkSphereSource()
sphere.SetThetaResolution(500)
sphere.SetPhiResolution(250)
sphere.Update()
self.GetOutput().ShallowCopy(sphere.GetOutput())
ghosts = self.GetOutput().AllocatePointGhostArray()
for i in range(ghosts.GetNumberOfTuples()):
    if self.GetOutput().GetPoint(i)[0] < 0:
        ghosts.SetValue(i, vtk.vtkDataSetAttributes.DUPLICATEPOINT)
"""
        self.show(source)
        self.assertGreater((~is_background(picture(self.view))).mean(), 0.1)
        numpy.testing.assert_allclose(self.view.CameraFocalPoint, [0.25, 0, 0], atol=0.01)

    def test_a_coarse_mesh_is_drawn_as_the_smooth_surface_that_its_normals_describe(self):
        fine = Sphere(ThetaResolution=200, PhiResolution=200)
        self.show(fine)
        smooth = picture(self.view)
        self.assert_drawn(smooth)
        Hide(fine, self.view)
        display = self.show(Sphere(ThetaResolution=8, PhiResolution=8))
        # Other samples: a few pixels differ along the outline, of a polygon of eight sides a tenth of all would.
        coarse = picture(self.view)
        self.assertLess((is_background(coarse) != is_background(smooth)).mean(), 0.01)
        self.assertEqual(marks(display)[0], 200000)
        self.assertAlmostEqual(ink(coarse) / ink(smooth), 1.0, delta=0.1)
        display.LinesNumberOfSamples = 5000
        picture(self.view)
        self.assertEqual(marks(display)[0], 5000)
        display.LinesNumberOfSamples = 0
        picture(self.view)
        self.assertEqual(marks(display)[0], 50, "its own points")

    def test_a_box_has_its_edges(self):
        # The six sides' own normals, and none.
        for box in (Box(), PassArrays(Input=Box())):
            display = self.show(box, LinesSilhouetteWidth=10)
            self.view.CameraPosition = [3.0, 2.0, 4.0]
            ResetCamera(self.view)
            pixels = picture(self.view)
            # As many as make each stand for a disc of 1.3 thousandths of the diagonal.
            self.assertAlmostEqual(marks(display)[0], 6 / (numpy.pi * 3 * 0.0013**2), delta=10)
            # Three of its sides are in the view: their nine edges, two pixels wide and 100 or so long, and paper between them.
            self.assertTrue(0.03 < (pixels.max(axis=-1) < 0.5).mean() < 0.1, (pixels.max(axis=-1) < 0.5).mean())
            self.assertGreater(numpy.all(pixels > 0.99, axis=-1).mean(), 0.4)
            Hide(box, self.view)

    def test_raw_points_get_normals_and_radii(self):
        scan = ProgrammableSource(OutputDataSetType="vtkPolyData")
        scan.Script = """
import vtk
sphere = vtk.vtkSphereSource()
sphere.SetThetaResolution(100)
sphere.SetPhiResolution(100)
sphere.Update()
self.GetOutput().SetPoints(sphere.GetOutput().GetPoints())
"""
        with Warnings() as warnings:
            display = self.show(scan)
            of_points = picture(self.view)
            self.assertEqual(marks(display)[0], 9802)
            Hide(scan, self.view)
            cloud = PointSource(NumberOfPoints=2000, Radius=1.0)
            display = self.show(cloud)
            self.assert_drawn(picture(self.view))
            self.assertEqual(marks(display)[0], 2000)
            Hide(cloud, self.view)
        self.assertEqual(warnings, [])
        self.show(Sphere(ThetaResolution=100, PhiResolution=100))
        of_mesh = picture(self.view)
        self.assertLess((is_background(of_points) != is_background(of_mesh)).mean(), 0.02)
        self.assertAlmostEqual(ink(of_points) / ink(of_mesh), 1.0, delta=0.3)

    def test_a_dense_mesh_is_drawn_by_its_own_points(self):
        display = self.show(Sphere(ThetaResolution=500, PhiResolution=250))
        self.assert_drawn(picture(self.view))
        self.assertEqual(marks(display)[0], 500 * 248 + 2)

    def test_a_dense_grid_is_drawn_by_its_outer_surface(self):
        plate = Wavelet(WholeExtent=[0, 200, 0, 200, 0, 1])
        grid = Threshold(Input=plate, Scalars=["POINTS", "RTData"], LowerThreshold=0.0, UpperThreshold=1000.0)
        with Warnings() as warnings:
            self.show(grid)
            self.assert_drawn(picture(self.view))
            Hide(grid, self.view)
            self.show(GroupDatasets(Input=[grid]))
            self.assert_drawn(picture(self.view))
        self.assertEqual(warnings, [])

    def test_coloring_on_or_off_samples_nothing_again(self):
        heights = Elevation(Input=Sphere(ThetaResolution=16, PhiResolution=16), LowPoint=[0, 0, -0.5], HighPoint=[0, 0, 0.5])
        display = self.show(heights, Tau=1.05, **FEW_MARKS)
        ColorBy(display, ("POINTS", "Elevation"))
        colored = picture(self.view)
        made = marks(display)
        ColorBy(display, None)
        self.assertGreater(numpy.abs(picture(self.view) - colored).max(), 0.3)
        ColorBy(display, ("POINTS", "Elevation"))
        numpy.testing.assert_array_equal(picture(self.view), colored)
        self.assertEqual(marks(display), made)

    def test_a_mesh_without_normals_gets_those_of_its_polygons(self):
        sphere = Sphere(ThetaResolution=60, PhiResolution=60)
        bare = PassArrays(Input=sphere)
        pictures = []
        with Warnings() as warnings:
            for source in (sphere, bare, GroupDatasets(Input=[bare])):
                self.show(source, **FEW_MARKS)
                pictures.append(picture(self.view))
                Hide(source, self.view)
        self.assertEqual(warnings, [])
        self.assert_drawn(pictures[0])
        for other in pictures[1:]:
            self.assertLess(numpy.abs(other - pictures[0]).mean(), 0.01)

    def test_points_are_selected_where_they_are_seen(self):
        """Of a mesh that is drawn by its own points, of one that is sampled, and of points that get their normals."""
        for resolution, of_points in ((500, False), (60, False), (60, True)):
            sphere = Sphere(ThetaResolution=resolution, PhiResolution=resolution // 2)
            if of_points:
                sphere = ProgrammableFilter(Input=sphere, CopyArrays=0)
                sphere.Script = "self.GetOutput().CopyStructure(self.GetInput()); self.GetOutput().SetPolys(None)"
            self.show(sphere)
            picture(self.view)
            # The left half of the picture is x < 0, and z > 0 is what faces this camera; splats reach a little farther.
            SelectSurfacePoints(Rectangle=[0, 0, 99, 199], View=self.view)
            selection = servermanager._getPyProxy(sphere.SMProxy.GetSelectionInput(0))
            self.assertIsNotNone(selection)
            chosen = ExtractSelection(Input=sphere, Selection=selection)
            chosen.UpdatePipeline()
            information = chosen.GetDataInformation()
            # A quarter of them, where they are fewer than pixels.
            found = information.GetNumberOfPoints() / sphere.GetDataInformation().GetNumberOfPoints()
            self.assertTrue(0.15 < found < 0.35 or resolution == 500 and found > 0.03, found)
            low_x, high_x, _, _, low_z, _ = information.GetBounds()
            self.assertLess(high_x, 0.05)
            self.assertLess(low_x, -0.4)
            self.assertGreater(low_z, -0.1)
            ClearSelection(sphere)
            Hide(sphere, self.view)


if __name__ == "__main__":
    unittest.main()
