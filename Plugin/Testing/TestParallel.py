# SPDX-License-Identifier: BSD-3-Clause
"""The same points and pictures on one process and on several, here and on a server:

python3 TestParallel.py MPIEXEC PVBATCH PVSERVER PVPYTHON SLEEP_WHEN_IDLE [INK]

SLEEP_WHEN_IDLE is the library of SleepWhenIdle.cxx. With the program ink also of OpenVDB files, which it writes.
Not with pvpython, which is an MPI process itself: mpiexec refuses to be started by one."""

import pathlib
import re
import socket
import subprocess
import sys
import tempfile
import unittest

import numpy

from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D
from vtkmodules.vtkImagingCore import vtkImageChangeInformation, vtkRTAnalyticSource
from vtkmodules.vtkIOImage import vtkMetaImageWriter, vtkNIFTIImageWriter, vtkPNGReader
from vtkmodules.vtkIOLegacy import vtkPolyDataWriter, vtkStructuredPointsWriter
from vtkmodules.vtkIOParallelXML import vtkXMLPImageDataWriter, vtkXMLPPolyDataWriter
from vtkmodules.vtkIOPLY import vtkPLYWriter
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter, vtkXMLPolyDataWriter

HERE = pathlib.Path(__file__).resolve().parent
MPIEXEC, PVBATCH, PVSERVER, PVPYTHON, SLEEP_WHEN_IDLE = sys.argv[1:6]
INK = sys.argv[6] if len(sys.argv) > 6 else None

# What two processes draw of all pictures: each style, data of each kind, and the one that differs more from one process's
# than that of four does, the dense lines. Measured: of all others two processes' pictures are those of four to the bit, but
# for five pixels of two pictures in which four differ more from one.
OF_TWO = (
    *("paper", "dense-lines", "wavelet-lines", "nii-stipples", "pvti-stipples", "pvti-solid-illustration", "pvtp-contours"),
    *("pvti-labels-solid-illustration", "slices-solid-illustration"),
    *("pvtp-line-art", "blocks-lines", "largest-parts-solid-lines", "mesh-chance-stipples"),
)


def write_files(folder):
    """A volume and a mesh in each format, in the parallel ones as four parts."""
    volume = vtkRTAnalyticSource()
    volume.SetWholeExtent(0, 30, 0, 28, 0, 26)
    volume.SetCenter(15, 14, 13)
    slices = vtkImageChangeInformation()
    slices.SetInputConnection(volume.GetOutputPort())
    slices.SetOutputSpacing(1, 1, 3)
    # A ball with a lid, made on a grid of a third of the size.
    z, y, x = numpy.indices((20, 21, 22)) - numpy.array([9.5, 10, 10.5]).reshape(3, 1, 1, 1)
    labels = (numpy.hypot(numpy.hypot(x, y), z) < 9.2).astype(numpy.uint8) * numpy.where(z > 4, 2, 1).astype(numpy.uint8)
    grid = vtkImageData()
    grid.SetDimensions(66, 63, 60)
    enlarged = vtkTrivialProducer()
    enlarged.SetOutput(grid)
    values = numpy_to_vtk(labels.repeat(3, 0).repeat(3, 1).repeat(3, 2).ravel(), deep=True)
    values.SetName("Labels")
    grid.GetPointData().SetScalars(values)
    surface = vtkFlyingEdges3D()
    surface.SetInputConnection(volume.GetOutputPort())
    surface.SetValue(0, 150.0)
    surface.ComputeNormalsOff()
    for writer, producer, name in (
        (vtkNIFTIImageWriter(), volume, "volume.nii"),
        (vtkStructuredPointsWriter(), volume, "volume.vtk"),
        (vtkXMLImageDataWriter(), volume, "volume.vti"),
        (vtkMetaImageWriter(), volume, "volume.mhd"),
        (vtkXMLPImageDataWriter(), volume, "volume.pvti"),
        (vtkXMLPImageDataWriter(), slices, "slices.pvti"),
        (vtkXMLPImageDataWriter(), enlarged, "enlarged.pvti"),
        (vtkPolyDataWriter(), surface, "mesh.vtk"),
        (vtkPLYWriter(), surface, "mesh.ply"),
        (vtkXMLPolyDataWriter(), surface, "mesh.vtp"),
        (vtkXMLPPolyDataWriter(), surface, "mesh.pvtp"),
    ):
        producer.UpdateWholeExtent()
        writer.SetInputConnection(producer.GetOutputPort())
        writer.SetFileName(str(folder / name))
        if name.endswith(("pvti", "pvtp")):
            writer.SetNumberOfPieces(4)
            writer.SetEndPiece(3)
        writer.Write()
    volume.UpdateWholeExtent()
    vtk_to_numpy(volume.GetOutput().GetPointData().GetScalars()).astype("<f4").tofile(folder / "volume.raw")
    if INK:
        vdb = [INK, "convert", str(folder / "volume.nii"), str(folder / "volume.vdb"), "--around", "150"]
        subprocess.run(vdb, check=True)


def read(file):
    """Indexed [y, x, rgb], or rgba where the file has it."""
    reader = vtkPNGReader()
    reader.SetFileName(str(file))
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(height, width, -1)
    return pixels.astype(int)


def on_processes(count, *command):
    # Allowed: a test machine may have fewer cores than processes, and its only user may be root. Processes that wait
    # leave their cores to those that draw.
    options = ["--allow-run-as-root", "--oversubscribe", "--mca", "mpi_yield_when_idle", "1"]
    return [MPIEXEC, *options, "-x", f"LD_PRELOAD={SLEEP_WHEN_IDLE}", "-n", str(count), *map(str, command)]


def free_port():
    with socket.socket() as listener:
        listener.bind(("localhost", 0))
        return listener.getsockname()[1]


class TestParallel(unittest.TestCase):
    def run_quietly(self, command):
        result = subprocess.run(command, capture_output=True, text=True, timeout=800)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        self.assertNotIn("ERR|", result.stdout + result.stderr)

    def compare(self, name, found, expected):
        """Pictures: lines to the bit. Blended dots are put together from processes' pictures of 8 bits, with
        other rounding than one picture has."""
        difference = numpy.abs(found - expected).max(axis=-1)
        if name.endswith(("stipples", "illustration", "contours")):
            # Measured: 14, of an illustration.
            self.assertLessEqual(difference.max(), 20 if name.endswith("illustration") else 12)
            # Rims of dots: most of the picture of a surface, few pixels of the others.
            self.assertLess((difference > 0).mean(), 0.02 if "solid" in name else 0.004)
        elif name == "paper":
            # A pixel of an outline that is partly beyond the surface is blended with what its own process has behind: with
            # the neighbor in a hole of the drawing, or without. Measured: four pixels, on four processes.
            self.assertLessEqual(numpy.count_nonzero(difference > 1), 6)
        elif name == "dense-lines":
            # Points on the border of two pieces are there twice, and so weigh more among the splats of their layer.
            # Measured: 3, and .33 % of the pixels, on two processes.
            self.assertLessEqual(difference.max(), 6)
            self.assertLess((difference > 0).mean(), 0.006)
        else:
            # Processes deliver points in another order, and in that the splats' 32-bit floats are summed up, with other
            # rounding. One process with its points shuffled draws such pixels, too: none or one in a picture, by one
            # level. Measured here: one, in two of the pictures.
            self.assertLessEqual(difference.max(), 1)
            self.assertLessEqual(numpy.count_nonzero(difference), 2)

    def drawings(self, processes, inputs, chosen=()):
        """The points and the pictures of drawings.py by their names, all or those chosen."""
        with tempfile.TemporaryDirectory() as folder:
            self.run_quietly(on_processes(processes, PVBATCH, HERE / "drawings.py", inputs, folder, *chosen))
            points = {file.stem: numpy.load(file) for file in pathlib.Path(folder).glob("*.npy")}
            return points, {file.stem: read(file) for file in pathlib.Path(folder).glob("*.png")}

    def test_number_of_processes_does_not_show(self):
        with tempfile.TemporaryDirectory() as inputs:
            write_files(pathlib.Path(inputs))
            expected_points, expected_pictures = self.drawings(1, inputs)
            self.assertEqual(len(expected_points), 2 * 7 + 2 * 3 + 8 + 2 + 1 + (3 if INK else 0))
            self.assertEqual(len(expected_pictures), 1 + 3 * 3 + 1 + 4 + 1 + 5 + 5 + 2 + 2 + 2 + 5 + 2 + 5 + 6 + 2)
            for name, points in expected_points.items():
                self.assertGreater(len(points), 1000, name)
            for name, picture in expected_pictures.items():
                self.assertGreater(numpy.mean(numpy.all(picture < 128, axis=-1)), 0.01, name)
            with self.subTest("what was enlarged is drawn as what it was made of"):
                made_of, blocks = (expected_pictures[f"{name}-solid-illustration"] for name in ("enlarged", "enlarged-blocks"))
                self.assertGreater((numpy.abs(made_of - blocks).max(axis=-1) > 60).mean(), 0.02)
            for processes, chosen in ((2, OF_TWO), (4, ())):
                found_points, found_pictures = self.drawings(processes, inputs, chosen)
                self.assertEqual(set(found_points), set(expected_points))
                self.assertEqual(set(found_pictures), set(chosen or expected_pictures))
                for name, points in expected_points.items():
                    with self.subTest(name, processes=processes):
                        numpy.testing.assert_array_equal(found_points[name], points)
                for name, picture in found_pictures.items():
                    with self.subTest(name, processes=processes):
                        self.compare(name, picture, expected_pictures[name])

    def test_symmetric_processes_start_with_one_iso_value(self):
        with tempfile.TemporaryDirectory() as inputs:
            write_files(pathlib.Path(inputs))
            command = on_processes(2, PVBATCH, "--sym", HERE / "symmetric_iso_values.py", inputs)
            result = subprocess.run(command, capture_output=True, text=True, timeout=800)
            self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
            for name in ("nii", "pvti"):
                found = re.findall(rf"{name}: \[([^]]+)\]", result.stdout)
                self.assertEqual(len(found), 2, result.stdout + result.stderr)
                self.assertEqual(len(set(found)), 1, found)

    def test_server_draws_as_client(self):
        for processes in (1, 2):
            with tempfile.TemporaryDirectory() as folder:
                port = free_port()
                server = subprocess.Popen(
                    on_processes(processes, PVSERVER, f"--server-port={port}"),
                    stdout=subprocess.PIPE,
                    stderr=subprocess.DEVNULL,
                    text=True,
                )
                try:
                    # A client that comes too early complains.
                    self.assertTrue(any("Accepting connection" in line for line in server.stdout))
                    self.run_quietly([PVPYTHON, str(HERE / "remote_drawings.py"), str(port), folder])
                    server.wait(timeout=600)
                finally:
                    server.terminate()
                    server.wait()
                    server.stdout.close()
                pictures = {file.stem: read(file) for file in pathlib.Path(folder).glob("*.png")}
                self.assertEqual(len(pictures), 2 * 5)
                for name in ("lines", "stipples", "colored-stipples", "colored-again-lines"):
                    with self.subTest(name, processes=processes):
                        here, there = (pictures[f"{place}-{name}"] for place in ("here", "server"))
                        self.assertGreater(numpy.mean(here[..., 1] < 128), 0.01)
                        if name == "colored-again-lines":
                            self.assertGreater(numpy.mean(numpy.ptp(here, axis=-1) > 60), 0.01)
                        if processes == 1:
                            numpy.testing.assert_array_equal(there, here)
                        elif name == "colored-stipples":
                            # Of every dot's rim three colors are rounded once more, not only its alpha.
                            self.assertLessEqual(numpy.abs(there - here).max(), 3)
                        else:
                            self.compare(name, there, here)
                with self.subTest("transparent", processes=processes):
                    here, there = (pictures[f"{place}-transparent"] for place in ("here", "server"))
                    self.assertEqual(here[2, 2, 3], 0)
                    self.assertGreater(here[..., 3].max(), 200)
                    # The client lays what it is sent over white and over black, and rounds once more.
                    self.assertLessEqual(numpy.abs(there - here)[..., 3].max(), 1)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
