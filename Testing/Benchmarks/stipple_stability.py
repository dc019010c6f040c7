# SPDX-License-Identifier: BSD-3-Clause
"""How many stipples of an iso-surface stay where they are when the iso-value changes.

    . Utilities/env.sh headless && $INK_PYTHON Testing/Benchmarks/stipple_stability.py FILE.nii.gz ISO

For changes of the value by .01, .1, 1 and 4: the share of stipples that have one within a tenth of a voxel afterwards, and of those whose
priority is the same within .01, too. Last, evenness: the deviation of the distance to the nearest neighbor over its mean.
"""

import importlib
import sys

import numpy as np
from vtkink import VTK_PACKAGE, vtk, vtkInkIsoSurfaceSampler, vtkInkStippleGenerator

to_numpy = importlib.import_module(f"{VTK_PACKAGE}.util.numpy_support").vtk_to_numpy


def stipples(image, value):
    """As in a picture a thousand pixels wide, seven pixels a stipple: positions and priorities."""
    sampler = vtkInkIsoSurfaceSampler()
    sampler.SetInputData(image)
    sampler.SetValue(0, value)
    sampler.SetSmallestPart(-1)
    sampler.Update()
    generator = vtkInkStippleGenerator()
    generator.SetInputData(sampler.GetOutput())
    generator.SetNumberOfSurfaceStipples(vtkInkStippleGenerator.CountForPicture(sampler.GetOutput(), 1000, 7.0))
    generator.Update()
    output = generator.GetOutput()
    return to_numpy(output.GetPoints().GetData()).astype(float), to_numpy(output.GetPointData().GetArray("Priority"))


def nearest(positions, queries, rank=0):
    """The position of that rank by its distance from each query: its index and the distance."""
    points = vtk.vtkPoints()
    points.SetDataTypeToDouble()
    points.SetNumberOfPoints(len(positions))
    for i, position in enumerate(positions):
        points.SetPoint(i, *position)
    data = vtk.vtkPolyData()
    data.SetPoints(points)
    locator = vtk.vtkStaticPointLocator()
    locator.SetDataSet(data)
    locator.BuildLocator()
    found = vtk.vtkIdList()
    indices = np.empty(len(queries), int)
    for i, query in enumerate(queries):
        locator.FindClosestNPoints(rank + 1, query, found)
        indices[i] = found.GetId(rank)
    return indices, np.linalg.norm(positions[indices] - queries, axis=1)


def main(file, value):
    reader = vtk.vtkNIFTIImageReader()
    reader.SetFileName(file)
    reader.Update()
    image = reader.GetOutput()
    before, priority = stipples(image, value)
    for change in (0.01, 0.1, 1.0, 4.0):
        after, priority_after = stipples(image, value + change)
        index, distance = nearest(after, before)
        kept = distance < 0.1 * min(image.GetSpacing())
        same = kept & (np.abs(priority - priority_after[index]) < 0.01)
        print(f"{len(before)} stipples, iso-value + {change}: kept {kept.mean():.3f}, priority too {same.mean():.3f}")
    _, distance = nearest(before, before, 1)
    print(f"nearest neighbor: deviation {distance.std() / distance.mean():.3f} of the mean")


if __name__ == "__main__":
    main(sys.argv[1], float(sys.argv[2]))
