# SPDX-License-Identifier: BSD-3-Clause
"""The temporal coherence of lines on a mesh that deforms (Zhang et al. 2014, section 6): a furrowed tube that twists and bends.

    . Utilities/env.sh headless && $INK_PYTHON Testing/Benchmarks/lines_coherence.py [FRAMES [SAMPLES]]

Samples that move with the mesh (vtkInkSurfaceSampler's FollowDeformation) against those that are made anew for each frame,
of blue and of white noise. Of each pair of frames:

- shimmer: of all ink, the share that comes or goes beyond a pixel's shift (as in splat_quality.py): each picture is compared with
  the other one's neighborhood of a pixel, so that lines may move by that much;
- specks: of all ink, the share that comes or goes beyond a pixel's shift and is in no line: two pixels or more away from the ink
  of a drawing of many more samples, which shows the true lines;
- travel: how far the samples move on the screen at the most, in pixels (made anew: not the same samples).
"""

import importlib
import sys

import numpy as np
from vtkink import VTK_PACKAGE, vtk, vtkInkSplattingLinesMapper, vtkInkSurfaceSampler

support = importlib.import_module(f"{VTK_PACKAGE}.util.numpy_support")
SIZE = 500


def tube(time, rows=160, columns=120):
    """Points of a tube with five furrows, twisted and bent in proportion to the time, 0 to 1."""
    s, a = np.meshgrid(np.linspace(-2, 2, rows), np.arange(columns) * 2 * np.pi / columns, indexing="ij")
    radius = 0.55 * (1 + 0.12 * np.cos(5 * a))
    around = a + 0.9 * time * s
    x, y = radius * np.cos(around), radius * np.sin(around)
    return np.stack([x + 0.35 * time * (s * s - 1.3), y, s], axis=2).reshape(-1, 3)


def mesh(rows=160, columns=120):
    """The tube at rest, as vtkPolyData."""
    i, j = np.meshgrid(np.arange(rows - 1), np.arange(columns), indexing="ij")
    a, b = i * columns + j, i * columns + (j + 1) % columns
    triangles = np.concatenate([np.stack([a, b, b + columns], axis=2), np.stack([a, b + columns, a + columns], axis=2)])
    data = vtk.vtkPolyData()
    data.SetPoints(vtk.vtkPoints())
    data.GetPoints().SetData(support.numpy_to_vtk(tube(0.0), deep=1))
    faces = np.c_[np.full(triangles.size // 3, 3), triangles.reshape(-1, 3)].ravel().astype(np.int64)
    cells = vtk.vtkCellArray()
    cells.ImportLegacyFormat(support.numpy_to_vtkIdTypeArray(faces, deep=1))
    data.SetPolys(cells)
    return data


class Scene:
    def __init__(self, follow, blue, samples, size=SIZE):
        self.size, self.mesh = size, mesh()
        self.sampler = vtkInkSurfaceSampler()
        self.sampler.SetInputData(self.mesh)
        self.sampler.SetFollowDeformation(follow)
        self.sampler.SetMethod(vtkInkSurfaceSampler.BLUE_NOISE if blue else vtkInkSurfaceSampler.WHITE_NOISE)
        self.sampler.SetNumberOfSamples(samples)
        self.sampler.ComputePriorityOff()
        self.mapper = vtkInkSplattingLinesMapper()
        self.mapper.SetInputConnection(self.sampler.GetOutputPort())
        actor = vtk.vtkActor()
        actor.SetMapper(self.mapper)
        renderer = vtk.vtkRenderer()
        renderer.SetBackground(1, 1, 1)
        renderer.AddActor(actor)
        self.window = vtk.vtkRenderWindow()
        self.window.SetOffScreenRendering(True)
        self.window.SetMultiSamples(0)
        self.window.SetSize(size, size)
        self.window.AddRenderer(renderer)
        camera = renderer.GetActiveCamera()
        camera.ParallelProjectionOn()
        camera.SetPosition(0, -10, 0)
        camera.SetViewUp(0, 0, 1)
        camera.SetParallelScale(2.3)
        camera.SetClippingRange(5, 15)

    def at(self, time):
        """The picture's darkness at a time, and where the samples are, in pixels."""
        self.mesh.GetPoints().SetData(support.numpy_to_vtk(tube(time), deep=1))
        self.mesh.GetPoints().Modified()
        self.mesh.Modified()
        self.window.Render()
        pixels = vtk.vtkUnsignedCharArray()
        self.window.GetPixelData(0, 0, self.size - 1, self.size - 1, 0, pixels, 0)
        ink = 1 - np.frombuffer(memoryview(pixels), np.uint8).reshape(self.size, self.size, 3)[:, :, 0] / 255
        positions = support.vtk_to_numpy(self.sampler.GetOutput().GetPoints().GetData())
        return ink, positions[:, [0, 2]] * self.size / 4.6


def widened(ink, pixels=1):
    """The darkest of each pixel's neighborhood."""
    shifts = [(y, x) for y in range(-pixels, pixels + 1) for x in range(-pixels, pixels + 1)]
    return np.max([np.roll(ink, shift, (0, 1)) for shift in shifts], axis=0)


def measure(scene, frames, step, truth=None):
    """Shimmer, specks and travel, each the mean over the frames; specks only with the true lines of each frame."""
    sums = np.zeros(3)
    before, positions_before = scene.at(0.0)
    for i in range(1, frames + 1):
        after, positions = scene.at(i * step)
        gone = np.maximum(before - widened(after), 0)
        come = np.maximum(after - widened(before), 0)
        all_ink = before.sum() + after.sum()
        sums[0] += (gone.sum() + come.sum()) / all_ink
        if truth:
            lines = np.maximum(widened(truth[i - 1], 2), widened(truth[i], 2)) > 0.1
            sums[1] += (gone[~lines].sum() + come[~lines].sum()) / all_ink
        same = len(positions) == len(positions_before)
        sums[2] += np.abs(positions - positions_before).max() if same else np.nan
        before, positions_before = after, positions
    return sums / frames


def main():
    frames = int(sys.argv[1]) if len(sys.argv) > 1 else 10
    samples = int(sys.argv[2]) if len(sys.argv) > 2 else 60000
    # Slow enough for lines to move by less than the pixel that shimmer allows.
    step = 1 / 240
    many = Scene(True, False, 16 * samples)
    # As wide splats as those of the samples that are compared.
    few = Scene(True, True, samples)
    few.at(0.0), many.at(0.0)
    radius = [one.sampler.GetOutput().GetPointData().GetArray("Radius").GetValue(0) for one in (few, many)]
    many.mapper.SetLambda(few.mapper.GetLambda() * radius[0] / radius[1])
    truth = [many.at(i * step)[0] for i in range(frames + 1)]
    print(f"{samples} samples, {frames} frames of 240, window {SIZE}x{SIZE}\n")
    print("| samples | shimmer | specks | travel |\n|---|---|---|---|")
    for blue in (True, False):
        for follow in (True, False):
            shimmer, specks, travel = measure(Scene(follow, blue, samples), frames, step, truth)
            name = ("blue" if blue else "white") + (", moved" if follow else ", made anew")
            print(f"| {name} | {shimmer:.2%} | {specks:.2%} | {travel:.1f} |", flush=True)


if __name__ == "__main__":
    main()
