# SPDX-License-Identifier: BSD-3-Clause
"""How near splatting lines come to a picture that was drawn four times as large and made smaller, in gray levels (RMS):
in all, and what of the square of it lies at outlines, at edges between surfaces, beside these, and elsewhere.

    . Utilities/env.sh headless && $INK_PYTHON Testing/Benchmarks/lines_antialiasing.py [PROPERTY=VALUE ...]

Drawn as a window shows them (1), and twice as large and made smaller, as `ink render` does (2).
"""

import pathlib
import sys

import numpy as np
from vtkink import vtk, vtkInkIsoSurfaceSampler, vtkInkSplattingLinesMapper

DATA = pathlib.Path(__file__).resolve().parents[2] / "Data"
SIZE = 768
REFERENCE = 4
# Between surfaces, distances differ within a pixel by this many pixels at least.
JUMP = 4


def draw(source, factor, properties):
    """Gray levels and distances from the viewer, of SIZE * factor pixels each way, and how long a pixel of SIZE is."""
    size = SIZE * factor
    mapper = vtkInkSplattingLinesMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    for name, value in properties:
        getattr(mapper, "Set" + name)(value)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.AddActor(actor)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(size, size)
    window.AddRenderer(renderer)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(-1, -2, 1.4)
    camera.SetViewUp(0, 0, 1)
    camera.ParallelProjectionOn()
    renderer.ResetCamera()
    window.Render()
    pixels = vtk.vtkUnsignedCharArray()
    window.GetPixelData(0, 0, size - 1, size - 1, 0, pixels, 0)
    depths = vtk.vtkFloatArray()
    window.GetZbufferData(0, 0, size - 1, size - 1, depths)
    near, far = camera.GetClippingRange()
    z = np.frombuffer(memoryview(depths), np.float32).reshape(size, size)
    gray = np.frombuffer(memoryview(pixels), np.uint8).reshape(size, size, 3)[:, :, 0].astype(float)
    return gray, np.where(z < 1, near + z * (far - near), np.inf), 2 * camera.GetParallelScale() / SIZE


def blocks(image, factor):
    return image.reshape(SIZE, factor, SIZE, factor)


def grow(mask):
    return np.any([np.roll(mask, (dy, dx), (0, 1)) for dy in (-1, 0, 1) for dx in (-1, 0, 1)], axis=0)


def measure(name, iso_value, properties):
    reader = vtk.vtkNIFTIImageReader()
    reader.SetFileName(str(DATA / f"{name}.nii.gz"))
    sampler = vtkInkIsoSurfaceSampler()
    sampler.SetInputConnection(reader.GetOutputPort())
    sampler.SetValue(0, iso_value)
    gray, depths, pixel = draw(sampler, REFERENCE, properties)
    reference = blocks(gray, REFERENCE).mean((1, 3))
    nearest = blocks(depths, REFERENCE).min((1, 3))
    farthest = blocks(depths, REFERENCE).max((1, 3))
    outline = np.isfinite(nearest) & ~np.isfinite(farthest)
    edge = np.zeros_like(outline)
    inside = np.isfinite(farthest)
    edge[inside] = farthest[inside] - nearest[inside] > JUMP * pixel
    beside = grow(outline | edge) & ~outline & ~edge
    for factor in (1, 2):
        error = (blocks(draw(sampler, factor, properties)[0], factor).mean((1, 3)) - reference) ** 2
        parts = [error[part].sum() / error.size for part in (outline, edge, beside, ~(outline | edge | beside))]
        print(f"{name:10}{factor:4}{np.sqrt(error.mean()):10.2f}" + "".join(f"{part:10.1f}" for part in parts))


def main():
    properties = [(name, (float if "." in value else int)(value)) for name, value in (text.split("=") for text in sys.argv[1:])]
    print(f"{'':10}{'':4}{'RMS':>10}{'outlines':>10}{'edges':>10}{'beside':>10}{'else':>10}")
    measure("engine", 80, properties)
    measure("bonsai", 36, properties)


if __name__ == "__main__":
    main()
