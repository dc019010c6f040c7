"""The same picture on one process and on several:  python3 TestParallel.py MPIEXEC PVBATCH

Not with pvpython, which is an MPI process itself: mpiexec refuses to be started by one."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

HERE = pathlib.Path(__file__).resolve().parent
MPIEXEC, PVBATCH = sys.argv[1:3]


def read(file):
    reader = vtkPNGReader()
    reader.SetFileName(str(file))
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(height, width, -1)[..., :3] / 255.0


class TestParallel(unittest.TestCase):
    def pictures(self, processes):
        """The pictures of drawings.py by their names."""
        with tempfile.TemporaryDirectory() as folder:
            # Allowed: a test machine may have fewer cores than processes, and its only user may be root.
            mpiexec = [MPIEXEC, "--allow-run-as-root", "--oversubscribe", "-n", str(processes)]
            result = subprocess.run(
                [*mpiexec, PVBATCH, str(HERE / "drawings.py"), folder], capture_output=True, text=True, timeout=200
            )
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertNotIn("ERR|", result.stdout + result.stderr)
            return {file.stem: read(file) for file in pathlib.Path(folder).glob("*.png")}

    def test_number_of_processes_does_not_show(self):
        expected = self.pictures(1)
        self.assertEqual(set(expected), {"paper", "lines", "stipples", "solid", "mesh"})
        for picture in expected.values():
            self.assertGreater(numpy.mean(numpy.all(picture < 0.5, axis=-1)), 0.01)
        for processes in (2, 4):
            found = self.pictures(processes)
            self.assertEqual(set(found), set(expected))
            for name, picture in expected.items():
                with self.subTest(name, processes=processes):
                    if name == "mesh":
                        # Other stipples, as good: its polygons come in another order.
                        self.assertAlmostEqual(found[name].mean(), picture.mean(), delta=0.002)
                    elif name in ("stipples", "solid"):
                        # The same dots, but blended in another order, with other rounding.
                        difference = numpy.abs(found[name] - picture)
                        self.assertLess(difference.max(), 1.5 / 255)
                        self.assertLess((difference > 0).mean(), 1e-3)
                    else:
                        numpy.testing.assert_array_equal(found[name], picture)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
