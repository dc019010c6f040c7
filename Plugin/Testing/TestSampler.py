# SPDX-License-Identifier: BSD-3-Clause
"""The sampler as ParaView offers it: where it can be applied, and what it starts with."""

import gzip
import pathlib
import struct
import tempfile
import unittest

from paraview.modules.vtkRemotingCore import vtkPVPluginTracker
from rendering import *

ENGINE = pathlib.Path(__file__).resolve().parents[2] / "Data" / "engine.nii.gz"


class TestSampler(unittest.TestCase):
    def setUp(self):
        for source in GetSources().values():
            Delete(source)

    def test_plugin_is_loaded_from_its_path_and_known_by_name(self):
        tracker = vtkPVPluginTracker.GetInstance()
        loaded = [tracker.GetPluginName(i) for i in range(tracker.GetNumberOfPlugins()) if tracker.GetPluginLoaded(i)]
        self.assertIn("vtkInk", loaded)
        LoadDistributedPlugin("vtkInk", remote=False)

    def test_menu(self):
        hints = InkIsoSurfaceSampler(Input=Wavelet()).GetHints()
        self.assertEqual(hints.FindNestedElementByName("ShowInMenu").GetAttribute("category"), "Ink")

    def test_starts_with_the_iso_value_that_ink_suggests(self):
        wavelet = Wavelet()
        wavelet.UpdatePipeline()
        sampler = InkIsoSurfaceSampler(Input=wavelet)
        low, high = wavelet.PointData["RTData"].GetRange(0)
        self.assertEqual(sampler.SampleBy[:], ["POINTS", "RTData"])
        self.assertTrue(low < sampler.Isosurfaces[0] < high)
        sampler.UpdatePipeline()
        self.assertGreater(sampler.GetDataInformation().GetNumberOfPoints(), 1000)
        self.assertIsNotNone(sampler.PointData["Normals"])
        self.assertIsNotNone(sampler.PointData["Radius"])
        # As "ink info Data/engine.nii.gz" has it, of a reader that has not been updated.
        sampler = InkIsoSurfaceSampler(Input=OpenDataFile(str(ENGINE)))
        self.assertEqual(sampler.Isosurfaces[:], [77])

    def test_without_a_boundary_starts_where_paraview_does(self):
        constant = Calculator(Input=Wavelet(), ResultArrayName="c", Function="3")
        sampler = InkIsoSurfaceSampler(Input=constant, SampleBy=["POINTS", "c"])
        self.assertEqual(sampler.Isosurfaces[:], [3.0])

    def test_opens_a_compressed_nifti_volume_and_samples_it_unasked(self):
        # Not updated, so ParaView does not know yet which arrays there are.
        sampler = InkIsoSurfaceSampler(Input=OpenDataFile(str(ENGINE)))
        sampler.Isosurfaces = [80.0]
        sampler.UpdatePipeline()
        self.assertEqual(sampler.GetDataInformation().GetNumberOfPoints(), 293070)

    def test_opens_a_freesurfer_volume_in_its_axes(self):
        header = struct.pack(">7ih15f", 1, 6, 5, 4, 1, 0, 0, 1, 1, 2, 3, -1, 0, 0, 0, 0, -1, 0, 1, 0, 0, 0, 0).ljust(284, b"\0")
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "brain.mgz"
            path.write_bytes(gzip.compress(header + bytes(range(120))))
            reader = OpenDataFile(str(path))
            self.assertEqual(reader.GetXMLName(), "InkVolumeReader")
            reader.UpdatePipeline()
            self.assertEqual(reader.GetDataInformation().DataInformation.GetExtent(), (0, 5, 0, 4, 0, 3))
            image = servermanager.Fetch(reader)
            self.assertEqual(image.GetSpacing(), (1.0, 2.0, 3.0))
            # To the left, down and to the back.
            matrix = image.GetDirectionMatrix()
            self.assertEqual([matrix.GetElement(i, j) for i in range(3) for j in range(3)], [1, 0, 0, 0, 0, -1, 0, -1, 0])
            reader.Spacing = [2.0, 2.0, 2.0]
            reader.UpdatePipeline()
            self.assertEqual(servermanager.Fetch(reader).GetSpacing(), (2.0, 2.0, 2.0))

    def test_iso_values_and_options_reach_the_filter(self):
        wavelet = Wavelet()
        wavelet.UpdatePipeline()
        sampler = InkIsoSurfaceSampler(Input=wavelet)
        counts = []
        for values in ([120.0], [200.0], [120.0, 200.0]):
            sampler.Isosurfaces = values
            sampler.UpdatePipeline()
            counts.append(sampler.GetDataInformation().GetNumberOfPoints())
        self.assertGreater(min(counts), 0)
        self.assertEqual(counts[0] + counts[1], counts[2])

        sampler.ComputeNormals = False
        sampler.ComputeRadius = False
        sampler.GenerateVertices = False
        sampler.CrossingRule = "Strict"
        sampler.OutputPointsPrecision = "Double"
        sampler.UpdatePipeline()
        self.assertIsNone(sampler.PointData["Normals"])
        self.assertIsNone(sampler.PointData["Radius"])
        self.assertEqual(sampler.GetDataInformation().GetNumberOfCells(), 0)
        filter = sampler.GetClientSideObject()
        self.assertEqual(filter.GetOutput().GetPoints().GetDataType(), 11)

    def test_samples_a_mesh_with_scalars_alike_everywhere(self):
        heights = Elevation(Input=Sphere(), LowPoint=[0, 0, -0.5], HighPoint=[0, 0, 0.5], ScalarRange=[-1, 1])
        sampler = InkSurfaceSampler(Input=heights, NumberOfSamples=2000)
        self.assertEqual(sampler.Density[:], ["POINTS", "None"])
        sampler.UpdatePipeline()
        low, high = sampler.GetDataInformation().GetBounds()[4:]
        self.assertLess(low, -0.45)
        self.assertGreater(high, 0.45)
        with Warnings() as warnings:
            sampler.Density = ["POINTS", "Elevation"]
            sampler.UpdatePipeline()
        self.assertEqual(len(warnings), 1, warnings)
        self.assertIn('of the density "Elevation" there are 25 negative values', warnings[0])

    def test_each_filter_hides_its_input(self):
        image, mesh = Wavelet(), Sphere()
        for one in (
            InkIsoSurfaceSampler(Input=image),
            InkStippleGenerator(Input=image),
            InkSurfaceSampler(Input=mesh),
            InkPointPriority(Input=mesh),
        ):
            visibility = one.GetHints().FindNestedElementByName("Visibility")
            # 2 hides only what would cover the output, and not an image's outline.
            self.assertEqual(visibility.GetAttribute("replace_input"), "1")

    def test_is_offered_for_images_with_scalars_only(self):
        image = Wavelet()
        cells = PointDatatoCellData(Input=image)
        vectors = Calculator(Input=image, ResultArrayName="v", Function="coords")
        only_vectors = PassArrays(Input=vectors, PointDataArrays=["v"])
        surface = Sphere()
        sampler = InkIsoSurfaceSampler(Input=image)
        domain = sampler.SMProxy.GetProperty("Input")
        offered = {}
        for name, source in dict(
            image=image, cells=cells, vectors=vectors, only_vectors=only_vectors, surface=surface
        ).items():
            source.UpdatePipeline()
            domain.SetUncheckedInputConnection(0, source.SMProxy, 0)
            offered[name] = bool(domain.IsInDomains())
        domain.ClearUncheckedElements()
        expected = dict(image=True, cells=True, vectors=True, only_vectors=False, surface=False)
        self.assertEqual(offered, expected)


if __name__ == "__main__":
    unittest.main()
