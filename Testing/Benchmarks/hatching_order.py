# SPDX-License-Identifier: BSD-3-Clause
"""How calm hatching is: the first family of lines of line art, with directions by the sign of curvatures, smoothed as crosses, and
combed (CombDirections of vtkInkLinesOfCurvature).

    . Utilities/env.sh headless && $INK_PYTHON Testing/Benchmarks/hatching_order.py FILE[:ISO_VALUE] ...

Of samples half a spacing apart on lines, and of all pairs of them on different lines that are within 1.5 spacings on the same side of
the same sheet (by normals of 25 degrees):

- apart: the share of pairs whose lines are at more than 45 degrees to each other, in thousandths;
- length: the mean length of a line, in spacings.
"""

import importlib
import sys

import numpy as np
import vtkink
from vtkink import VTK_PACKAGE, vtkInkLineArtStyle, vtkInkLinesOfCurvature

support = importlib.import_module(f"{VTK_PACKAGE}.util.numpy_support")
NEAR = 1.5  # spacings
FACING = np.cos(np.radians(25))


def unit(vectors):
    return vectors / np.maximum(np.linalg.norm(vectors, axis=-1, keepdims=True), 1e-300)


def samples(lines, spacing):
    """Positions, directions and normals along lines, and the lines' numbers."""
    points, normals = (support.vtk_to_numpy(array).astype(float) for array in (lines.GetPoints().GetData(), lines.GetPointData().GetArray("Normals")))
    ends, ids = (support.vtk_to_numpy(array) for array in (lines.GetLines().GetOffsetsArray(), lines.GetLines().GetConnectivityArray()))
    found = []
    for number in np.flatnonzero(support.vtk_to_numpy(lines.GetCellData().GetArray("LineFamily")) == 0):
        line = ids[ends[number] : ends[number + 1]]
        steps = np.diff(points[line], axis=0)
        arc = np.concatenate([[0], np.cumsum(np.linalg.norm(steps, axis=1))])
        count = max(int(2 * arc[-1] / spacing), 1)
        at = (np.arange(count) + 0.5) / count * arc[-1]
        step = np.clip(np.searchsorted(arc, at) - 1, 0, len(steps) - 1)
        position = points[line[step]] + (at - arc[step])[:, None] * unit(steps[step])
        found.append((position, unit(steps[step]), normals[line[step]], np.full(count, number)))
    return [np.concatenate(parts) for parts in zip(*found)]


def neighbors(positions, distance):
    """Pairs of positions within a distance, each once or twice."""
    cells = np.floor((positions - positions.min(axis=0)) / distance).astype(np.int64) + 1
    sizes = cells.max(axis=0) + 2
    keys = (cells[:, 0] * sizes[1] + cells[:, 1]) * sizes[2] + cells[:, 2]
    order = np.argsort(keys, kind="stable")
    ordered = keys[order]
    for x, y, z in np.ndindex(3, 3, 3):
        wanted = keys + ((x - 1) * sizes[1] + y - 1) * sizes[2] + z - 1
        begin, end = np.searchsorted(ordered, wanted), np.searchsorted(ordered, wanted, "right")
        for shift in range((end - begin).max(initial=0)):
            first = np.flatnonzero(begin + shift < end)
            second = order[begin[first] + shift]
            near = np.linalg.norm(positions[first] - positions[second], axis=1) < distance
            yield first[near], second[near]


def share_apart(lines, spacing):
    """Of pairs of neighboring samples, the share that is at more than 45 degrees."""
    positions, directions, normals, numbers = samples(lines, spacing)
    pairs = apart = 0
    for first, second in neighbors(positions, NEAR * spacing):
        same_sheet = (normals[first] * normals[second]).sum(axis=1) > FACING
        first, second = (side[same_sheet & (numbers[first] != numbers[second])] for side in (first, second))
        pairs += len(first)
        apart += ((directions[first] * directions[second]).sum(axis=1) ** 2 < 0.5).sum()
    return apart / max(pairs, 1)


def mean_length(lines, spacing):
    _, _, _, numbers = samples(lines, spacing)
    return 0.5 * len(numbers) / len(np.unique(numbers))


def main(files):
    print("data,directions,apart,length")
    for file in files:
        name, _, iso_value = file.partition(":")
        style = vtkInkLineArtStyle()
        if iso_value:
            style.SetParameterAsString("IsoValues", iso_value)
        style.Draw(vtkink.reading.data_object(name))
        lines = style.GetLinesOfCurvature()
        lines.SetFamilies(vtkInkLinesOfCurvature.MAXIMUM)
        for setting, smooth, comb in (("by sign", False, False), ("smoothed as crosses", True, False), ("combed", True, True)):
            lines.SetSmoothDirections(smooth)
            lines.SetCombDirections(comb)
            lines.Update()
            found, spacing = lines.GetOutput(), lines.GetSpacing()
            apart, length = 1000 * share_apart(found, spacing), mean_length(found, spacing)
            print(f"{name.rpartition('/')[2]},{setting},{apart:.2g},{length:.3g}", flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
