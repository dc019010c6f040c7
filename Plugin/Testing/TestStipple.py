# SPDX-License-Identifier: BSD-3-Clause
"""The representation Stipple: what it draws of which data, what its properties change, and what they leave."""

import pathlib
import tempfile
import unittest

import numpy

from paraview import servermanager, smstate
from rendering import *


class TestStipple(TestInOneView):
    def show(self, source, **properties):
        display = Show(source, self.view)
        display.SetRepresentationType("Stipple")
        display.StipplePaper = False  # TestPaper.py looks at it
        for name, value in properties.items():
            setattr(display, name, value)
        ResetCamera(self.view)
        return display

    def show_wavelet(self, **properties):
        return self.show(Wavelet(), **{"GradientPercentile": 60, **properties})

    def show_sphere(self, **properties):
        return self.show(Sphere(ThetaResolution=32, PhiResolution=32), NumberOfSurfaceStipples=20000, **properties)

    def test_settings_of_surfaces_light_are_not_shown(self):
        """The plugin has ParaView's group of them again, with decorators that hide it."""
        for source in (Sphere(), Wavelet()):
            display = Show(source, self.view).SMProxy
            groups = [display.GetPropertyGroup(i) for i in range(display.GetNumberOfPropertyGroups())]
            names = [
                {group.GetProperty(i).GetXMLName() for i in range(group.GetNumberOfProperties())}
                for group in groups
                if group.GetXMLLabel() == "Lighting"
            ]
            self.assertEqual(len(names), 2)
            self.assertEqual(names[0] - names[1], {"InteractiveSelectionColor"}, "which is never shown")
            self.assertEqual(names[1] - names[0], set())

    def ink(self):
        return ink(picture(self.view))

    def stipples(self, display):
        """How many were made on this process, and how often."""
        return marks(display)

    def test_is_offered_for_images_meshes_and_composite_data(self):
        sphere = Sphere()
        for source in (
            Wavelet(),
            sphere,
            AppendDatasets(Input=[sphere]),  # a vtkUnstructuredGrid
            ImageDatatoPointSet(Input=Wavelet()),  # a vtkStructuredGrid
            GroupDatasets(Input=[sphere, sphere]),
        ):
            display = Show(source, self.view)
            self.assertIn("Stipple", display.GetProperty("Representation").GetAvailable())

    def test_draws_dots_of_ink_on_the_background(self):
        self.show_wavelet()
        pixels = picture(self.view)
        inked = ~is_background(pixels)
        self.assertGreater(inked.mean(), 0.02)
        self.assertLess(inked.mean(), 0.7)
        self.assertFalse(inked[0, 0])
        self.assertLess(pixels[..., 1].min(), 0.1)
        # Black over green is green, darker.
        self.assertLess(pixels[..., 0].max(), 0.02)

    def test_sliders_change_the_ink_and_make_no_new_stipples(self):
        display = self.show_wavelet()
        picture(self.view)
        made = self.stipples(display)
        self.assertGreater(made[0], 10000)
        for slider, more in (("Gradient", True), ("Sharpness", False), ("Interior", False)):
            inks = []
            for position in (0.0, 0.5, 1.0):
                setattr(display, f"Stipple{slider}", position)
                inks.append(self.ink())
            self.assertEqual(inks, sorted(set(inks), reverse=not more), slider)
            display.StipplePreset = "Bone"
            display.StipplePreset = "Anatomy"
        before = picture(self.view)
        for slider in ("Orientation", "Distance", "Color"):
            setattr(display, f"Stipple{slider}", 1.0)
            after = picture(self.view)
            self.assertGreater(numpy.abs(after - before).mean(), 0.002, slider)
            before = after
        self.assertEqual(self.stipples(display), made)

    def test_a_slider_sets_what_it_stands_for_and_nothing_else(self):
        display = self.show_wavelet(BoundaryBase=4.0, StippleSize=5.0, PixelsPerStipple=9.0)
        kse = display.SilhouetteExponent
        display.StippleOrientation = 0.0
        self.assertEqual((display.LightingEnhancement, display.LightingExponent), (1, 20.0))
        self.assertEqual(display.SilhouetteGain, 0.0)
        self.assertEqual((display.BoundaryBase, display.StippleSize, display.PixelsPerStipple, display.SilhouetteExponent), (4.0, 5.0, 9.0, kse))
        display.StippleSharpness = 1.0
        self.assertLess(display.SilhouetteExponent, kse)
        display.SilhouetteExponent = 3.0
        display.StippleGradient = 0.2
        self.assertEqual(display.SilhouetteExponent, 3.0)
        self.assertNotEqual(display.BoundaryBase, 4.0)

    def test_each_enhancement_is_switched(self):
        display = self.show_wavelet()
        whole = picture(self.view)
        made = self.stipples(display)
        for name in ("Boundary", "Silhouette", "Resolution", "Lighting", "Distance", "Interior"):
            setattr(display, f"{name}Enhancement", False)
            self.assertGreater(numpy.abs(picture(self.view) - whole).mean(), 0.001, name)
            setattr(display, f"{name}Enhancement", True)
        numpy.testing.assert_array_equal(picture(self.view), whole)
        self.assertEqual(self.stipples(display), made)

    def test_quantized_positions_look_alike(self):
        display = self.show_wavelet()
        exact = picture(self.view)
        made = self.stipples(display)
        display.PositionPrecision = "Quantized"
        rounded = picture(self.view)
        self.assertGreater(numpy.abs(rounded - exact).max(), 0.0)
        self.assertLess(numpy.abs(rounded - exact).mean(), 0.002)
        self.assertEqual(self.stipples(display), made)

    def test_presets_set_the_sliders_and_differ(self):
        display = self.show_wavelet(StipplePreset="Bone")
        display.StippleGradient = 0.9
        pictures, sharpness = [], []
        for preset in display.GetProperty("StipplePreset").GetAvailable():
            display.StipplePreset = preset
            self.assertLess(display.StippleGradient, 0.7)
            sharpness.append(display.StippleSharpness)
            pictures.append(picture(self.view))
        self.assertGreater(len(set(sharpness)), 2)
        for i, one in enumerate(pictures):
            for other in pictures[:i]:
                self.assertGreater(numpy.abs(one - other).mean(), 0.001)
        self.assertEqual((display.StipplePreset, display.ValueEffect, display.PixelsPerStipple), ("As Published", 1.0, 1.0))
        display.StipplePreset = "Plate, White on Black"
        self.assertEqual(list(display.StippleInkColor), [1.0, 1.0, 1.0])
        self.assertEqual((display.LightInk, display.FadeBySize), (1, 1))
        self.assertGreater(picture(self.view).min(axis=-1).max(), 0.9)
        display.StipplePreset = "Anatomy"
        self.assertEqual(display.LightInk, 0)
        numpy.testing.assert_array_equal(picture(self.view), pictures[0])

    def test_where_there_are_stipples_follows_the_generators_properties(self):
        display = self.show_wavelet()
        picture(self.view)
        counts = [self.stipples(display)[0]]
        for name, value in (
            ("GradientPercentile", 90),
            ("StipplesPerElement", 2),
            ("ScalarWindow", [150.0, 300.0]),
            ("UseScalarWindow", True),
        ):
            setattr(display, name, value)
            picture(self.view)
            counts.append(self.stipples(display)[0])
        self.assertEqual(counts[1], counts[2] * 4)
        self.assertEqual(counts[2], counts[3])
        self.assertGreater(counts[0], 3 * counts[1])
        self.assertGreater(counts[3], counts[4])
        self.assertGreater(counts[4], 0)
        made = self.stipples(display)
        display.StippleSeed = 7
        picture(self.view)
        self.assertEqual(self.stipples(display)[0], made[0])
        self.assertGreater(self.stipples(display)[1], made[1])

    def test_colors_by_an_array_through_the_lookup_table(self):
        wavelet = Wavelet()
        display = self.show(wavelet, GradientPercentile=60, BoundaryEnhancement=False, LightingEnhancement=False)
        ColorBy(display, ("POINTS", "RTData"))
        table = GetColorTransferFunction("RTData")
        table.RGBPoints = [37.0, 1.0, 0.0, 0.0, 277.0, 0.0, 0.0, 1.0]
        table.ColorSpace = "RGB"
        pixels = picture(self.view)
        inked = pixels[~is_background(pixels)]
        self.assertGreater(inked[:, 0].max(), 0.4)
        self.assertGreater(inked[:, 2].max(), 0.4)
        made = self.stipples(display)
        table.RGBPoints = [37.0, 0.0, 0.0, 1.0, 277.0, 0.0, 0.0, 1.0]
        pixels = picture(self.view)
        self.assertLess(pixels[~is_background(pixels)][:, 0].max(), 0.02)
        self.assertEqual(self.stipples(display), made)
        ColorBy(display, None)
        pixels = picture(self.view)
        self.assertLess(pixels[..., 2].max(), 0.02)

    def test_coloring_on_or_off_makes_no_new_stipples(self):
        heights = Elevation(Input=Sphere(), LowPoint=[0, -0.5, 0], HighPoint=[0, 0.5, 0])
        for source, array in ((Wavelet(), "RTData"), (heights, "Elevation")):
            display = self.show(source)
            ColorBy(display, None)
            plain = picture(self.view)
            made = self.stipples(display)
            for _ in range(2):
                ColorBy(display, ("POINTS", array))
                self.assertGreater(numpy.abs(picture(self.view) - plain).mean(), 0.001)
                ColorBy(display, None)
                numpy.testing.assert_array_equal(picture(self.view), plain)
            self.assertEqual(self.stipples(display), made)
            Hide(source, self.view)

    def test_colors_meshes_by_arrays_of_points_and_of_cells(self):
        sphere = Sphere(ThetaResolution=32, PhiResolution=32)
        elevation = Elevation(Input=sphere, LowPoint=[0, -0.5, 0], HighPoint=[0, 0.5, 0])
        both = PointDatatoCellData(Input=elevation, PassPointData=True)
        display = self.show(both, NumberOfSurfaceStipples=20000, LightingEnhancement=False)
        for association in ("POINTS", "CELLS"):
            ColorBy(display, (association, "Elevation"))
            table = GetColorTransferFunction("Elevation")
            table.RGBPoints = [0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0]
            table.ColorSpace = "RGB"
            pixels = picture(self.view)
            # Rows count upwards.
            self.assertGreater(pixels[20:60, :, 0].max(), 0.6)
            self.assertLess(pixels[20:60, :, 2].max(), 0.4)
            self.assertGreater(pixels[140:180, :, 2].max(), 0.6)

    def test_colors_by_an_array_that_has_the_name_of_one_of_the_stipples(self):
        wavelet = Wavelet()
        value = Calculator(Input=wavelet, ResultArrayName="Value", Function="RTData")
        display = self.show(value, GradientPercentile=60, StippleBy=["POINTS", "RTData"])
        shape = is_background(picture(self.view))
        ColorBy(display, ("POINTS", "Value"))
        numpy.testing.assert_array_equal(is_background(picture(self.view)), shape)

    def test_meshes_are_drawn_in_the_shade(self):
        self.show_sphere(StippleHeadlight=True)
        inked = ~is_background(picture(self.view))
        rows = inked[90:110]
        rim = numpy.flatnonzero(rows.any(axis=0))[0]
        self.assertLess(rows[:, 90:110].mean(), 0.6 * rows[:, rim + 1 : rim + 8].mean())

    def test_a_surface_hides_what_lies_behind_it(self):
        front = Sphere(Center=[0, 0, 5], Radius=2, ThetaResolution=32, PhiResolution=32)
        pair = AppendGeometry(Input=[front, Sphere(ThetaResolution=32, PhiResolution=32)])
        heights = Elevation(Input=pair, LowPoint=[0, 0, 0], HighPoint=[0, 0, 5])
        display = self.show(heights, NumberOfSurfaceStipples=40000, LightingEnhancement=False)
        ColorBy(display, ("POINTS", "Elevation"))
        table = GetColorTransferFunction("Elevation")
        table.RGBPoints = [0.0, 0.0, 0.0, 1.0, 0.5, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0]
        self.assertLess(picture(self.view)[..., 2].max(), 0.02)
        display.SurfaceHides = False
        self.assertGreater(picture(self.view)[..., 2].max(), 0.2)

    def test_an_iso_surface_hides_what_lies_behind_it(self):
        display = self.show_wavelet(GradientPercentile=0)
        picture(self.view)
        see_through = self.stipples(display)
        display.StippleIsoValue = 150.0
        picture(self.view)
        self.assertEqual(self.stipples(display), see_through, "of all voxels, whatever the value")
        display.StippleSource = "Iso-Surface"
        solid = picture(self.view)
        self.assertNotEqual(self.stipples(display)[0], see_through[0])
        self.assertGreater((~is_background(solid)).mean(), 0.02)
        display.OccluderOffset = 100
        self.assertGreater(self.ink(), 1.002 * ink(solid))

    def test_other_data_is_drawn_by_its_outer_surface(self):
        sphere = Sphere(ThetaResolution=32, PhiResolution=32)
        count = {"NumberOfSurfaceStipples": 20000}
        self.show(sphere, **count)
        of_mesh = picture(self.view)
        Hide(sphere, self.view)
        grid = AppendDatasets(Input=[sphere])
        self.show(grid, **count)
        # The same surface, its polygons perhaps in another order.
        self.assertAlmostEqual(self.ink() / ink(of_mesh), 1.0, delta=0.05)
        Hide(grid, self.view)
        self.show(GroupDatasets(Input=[Sphere(Center=[-1, 0, 0]), Sphere(Center=[1, 0, 0])]), **count)
        inked = ~is_background(picture(self.view))
        self.assertGreater(inked[:, :100].sum(), 500)
        self.assertAlmostEqual(inked[:, :100].sum() / inked[:, 100:].sum(), 1.0, delta=0.3)

    def test_the_number_on_a_mesh_follows_the_picture_not_the_polygons(self):
        def count(resolution, **properties):
            display = self.show(Sphere(ThetaResolution=resolution, PhiResolution=resolution), **properties)
            picture(self.view)
            return self.stipples(display)[0]

        few, many = count(30), count(120)
        # Of a ball, pi times the square of its diameter in thousandths of the height, four of them for each, in a view as high
        # as the sphere around its bounds.
        self.assertAlmostEqual(many / (numpy.pi * 1000**2 / 3 / 4), 1.0, delta=0.02)
        self.assertAlmostEqual(few / many, 1.0, delta=0.02)
        self.assertAlmostEqual(count(120, StipplePictureSize=300) / many, 0.25, delta=0.01)
        self.assertAlmostEqual(count(120, MaximumStipplesMode="Projected") / many, 3.0 * 4.0 * 0.6**2, delta=0.06)

    def test_the_number_in_a_voxel_can_follow_the_picture(self):
        whole = Wavelet(WholeExtent=[-10, 10, -10, 10, -10, 10])
        for source in (whole, GroupDatasets(Input=[whole])):
            display = self.show(source, GradientPercentile=60)
            picture(self.view)
            voxels = marks(display, "Cells drawn")[0]
            self.assertEqual(self.stipples(display)[0], 8 * voxels)
            display.MaximumStipplesMode = "Projected"
            # 21 voxels along a side.
            for size, number in ((100, 23), (60 * 21 / 10, 36), (600, 64)):
                display.StipplePictureSize = size
                picture(self.view)
                self.assertEqual(self.stipples(display)[0], number * voxels)
            Hide(source, self.view)
        # Beside one that is three times as far across in all, each measures a third.
        far = Wavelet(WholeExtent=[32, 52, -10, 10, -10, 10])
        display = self.show(GroupDatasets(Input=[whole, far]), GradientPercentile=60)
        display.MaximumStipplesMode = "Projected"
        display.StipplePictureSize = 300
        picture(self.view)
        self.assertEqual(self.stipples(display)[0], round((300 / 63) ** 2) * marks(display, "Cells drawn")[0])

    def test_progress_is_told_and_the_work_can_be_stopped(self):
        for source in (Sphere(), Wavelet()):
            display = self.show(source)
            algorithm = display.GetClientSideObject().GetActiveRepresentation()
            told = []
            tag = algorithm.AddObserver("ProgressEvent", lambda one, event: told.append(one.GetProgress()))
            display.StippleSeed = 4
            picture(self.view)
            self.assertEqual(algorithm.GetProgressText(), "Making stipples")
            self.assertGreater(len(set(told)), 5)
            self.assertGreater(self.stipples(display)[0], 0)
            algorithm.RemoveObserver(tag)
            tag = algorithm.AddObserver("ProgressEvent", lambda one, event: one.SetAbortExecute(1))
            display.StippleSeed = 5
            picture(self.view)
            self.assertEqual(self.stipples(display)[0], 0)
            algorithm.RemoveObserver(tag)
            display.StippleSeed = 6
            picture(self.view)
            self.assertGreater(self.stipples(display)[0], 0)
            Hide(source, self.view)

    def test_a_mesh_of_few_polygons_gets_enough_stipples(self):
        display = self.show(Box())
        picture(self.view)
        self.assertGreater(self.stipples(display)[0], 100000)

    def test_images_of_composite_data_are_normalized_together(self):
        whole = Wavelet(WholeExtent=[-10, 10, -10, 10, -10, 10])
        display = self.show(GroupDatasets(Input=[whole]), GradientPercentile=60)
        of_group = picture(self.view)
        count = self.stipples(display)[0]
        Hide(GetActiveSource(), self.view)
        display = self.show(whole, GradientPercentile=60)
        numpy.testing.assert_array_equal(picture(self.view), of_group)
        self.assertEqual(self.stipples(display)[0], count)

    def test_stipples_of_the_filter_are_drawn_as_they_are(self):
        wavelet = Wavelet()
        self.show(wavelet)
        expected = picture(self.view)
        Hide(wavelet, self.view)
        generator = InkStippleGenerator(Input=wavelet)
        display = Show(generator, self.view)
        self.assertEqual(display.Representation, "Stipple")
        display.StipplePaper = False
        numpy.testing.assert_array_equal(picture(self.view), expected)

    def test_stipples_of_the_filter_are_selected_where_they_are_seen(self):
        generator = InkStippleGenerator(Input=Wavelet(), GradientPercentile=60)
        self.show(generator)
        picture(self.view)
        SelectSurfacePoints(Rectangle=[0, 0, 99, 199], View=self.view)
        selection = servermanager._getPyProxy(generator.SMProxy.GetSelectionInput(0))
        self.assertIsNotNone(selection)
        chosen = ExtractSelection(Input=generator, Selection=selection)
        chosen.UpdatePipeline()
        information = chosen.GetDataInformation()
        self.assertGreater(information.GetNumberOfPoints(), 100)
        # The left half of the picture.
        self.assertLess(information.GetBounds()[1], 0.5)

    def test_an_image_without_scalars_is_an_error_named_once(self):
        with Warnings() as warnings:
            self.show(PassArrays(Input=Wavelet()))
            self.assertTrue(is_background(picture(self.view)).all())
            picture(self.view)
        self.assertEqual(len(warnings), 1, warnings)
        self.assertIn("No point scalars in the image. Its point arrays: none.", warnings[0])

    def test_images_of_cells_are_drawn_as_those_of_points(self):
        image = Wavelet()
        self.show(image, GradientPercentile=60)
        of_points = self.ink()
        Hide(image, self.view)
        self.show(PointDatatoCellData(Input=image), GradientPercentile=60)
        self.assertAlmostEqual(self.ink() / of_points, 1.0, delta=0.07)

    def test_new_data_is_drawn(self):
        wavelet = Wavelet()
        self.show(wavelet, GradientPercentile=60)
        before = picture(self.view)
        wavelet.XFreq = 10
        self.assertGreater(numpy.abs(picture(self.view) - before).mean(), 0.005)

    def test_is_moved_with_its_bounds(self):
        display = self.show_sphere()
        self.assertGreater(self.ink(), 0)
        display.Position = [100, 0, 0]
        self.assertTrue(is_background(picture(self.view)).all())
        ResetCamera(self.view)
        numpy.testing.assert_allclose(self.view.CameraFocalPoint, [100, 0, 0], atol=0.01)
        self.assertGreater(self.ink(), 0)

    def test_lines_are_drawn_as_tubes(self):
        with Warnings() as warnings:
            self.show(Line())
            self.assertGreater(self.ink(), 0)
        self.assertEqual(len(warnings), 0, warnings)

    def assert_restored(self, save, load):
        changed = {"StipplePreset": "Engineering", "StippleInterior": 0.9, "SilhouetteGain": 0.7, "StippleInkColor": [0, 0, 1]}
        display = self.show_wavelet(**changed)
        names = [name for name in display.ListProperties() if name.startswith(("Stipple", "K", "Gradient"))]
        expected = {name: str(getattr(display, name)) for name in names}
        drawn = picture(self.view)
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "saved"
            save(file)
            Delete(self.view)
            self.tearDown()
            load(file)
        (self.view,) = GetViews()
        # A setting of ParaView's, which states leave out.
        self.view.UseFXAA = False
        (source,) = GetSources().values()
        display = GetDisplayProperties(source, self.view)
        self.assertEqual(display.Representation, "Stipple")
        self.assertEqual({name: str(getattr(display, name)) for name in names}, expected)
        numpy.testing.assert_array_equal(picture(self.view), drawn)

    def test_is_restored_from_a_state(self):
        self.assert_restored(
            lambda file: SaveState(str(file.with_suffix(".pvsm"))), lambda file: LoadState(str(file.with_suffix(".pvsm")))
        )

    def test_is_restored_from_a_script(self):
        self.assert_restored(
            lambda file: file.write_text(smstate.get_state(), encoding="utf-8"),
            lambda file: exec(file.read_text(encoding="utf-8"), {}),
        )


if __name__ == "__main__":
    unittest.main()
