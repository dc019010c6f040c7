# SPDX-License-Identifier: BSD-3-Clause
"""OpenVDB files as ParaView opens them: as an image and straight as points."""

import pathlib
import subprocess
import tempfile
import unittest

from paraview.simple import *

ENGINE = pathlib.Path(__file__).resolve().parents[2] / "Data" / "engine.nii.gz"


class TestVDB(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.file = str(pathlib.Path(cls.folder.name) / "engine.vdb")
        subprocess.run(["ink", "convert", str(ENGINE), cls.file, "--around", "80"], check=True)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_the_reader_is_offered_for_the_extension(self):
        reader = OpenDataFile(self.file)
        self.assertIsNotNone(reader)
        self.assertIn(reader.GetXMLName(), ("InkVDBReader", "InkVDBIsoSurfaceSampler"))

    def test_image_and_points_of_a_band_are_those_of_the_volume(self):
        reader = InkOpenVDBReader(FileName=self.file)
        reader.UpdatePipeline()
        names = reader.GetProperty("GridNames")
        self.assertEqual([names.GetElement(n) for n in range(names.GetNumberOfElements())], ["density"])
        self.assertEqual(reader.Grid, "density")
        self.assertEqual(reader.GetDataInformation().DataInformation.GetExtent(), (0, 255, 0, 255, 0, 127))
        sampler = InkIsoSurfaceSampler(Input=reader)
        sampler.Isosurfaces = [80.0]
        straight = InkOpenVDBIsoSurfaceSampler(FileName=self.file)
        straight.Isosurfaces = [80.0]
        for one in (sampler, straight):
            one.UpdatePipeline()
            self.assertEqual(one.GetDataInformation().GetNumberOfPoints(), 293070)
            self.assertIsNotNone(one.PointData["Normals"])


if __name__ == "__main__":
    unittest.main()
