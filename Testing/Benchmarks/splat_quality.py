# SPDX-License-Identifier: BSD-3-Clause
"""How good the lines are, of the mapper's splats and of the splats as published (Zhang et al. 2014):

- contour: of all directions around a sphere's contour, the share where a line is at least half as dark as ink;
- specks: of all ink on the engine, the share in spots of up to 8 pixels that touch no other ink;
- shimmer: of all ink on the engine, the share that comes or goes when the camera turns by a tenth of a degree.

    . Utilities/env.sh headless && $INK_PYTHON Testing/Benchmarks/splat_quality.py
"""

import pathlib

import numpy as np
from vtkink import vtk, vtkInkIsoSurfaceSampler, vtkInkSplattingLinesMapper

ENGINE = pathlib.Path(__file__).resolve().parents[2] / "Data" / "engine.nii.gz"
SIZE = 800


class Scene:
    def __init__(self, source, as_published):
        mapper = vtkInkSplattingLinesMapper()
        mapper.SetInputConnection(source.GetOutputPort())
        mapper.SetAsPublished(as_published)
        actor = vtk.vtkActor()
        actor.SetMapper(mapper)
        self.renderer = vtk.vtkRenderer()
        self.renderer.SetBackground(1, 1, 1)
        self.renderer.AddActor(actor)
        self.window = vtk.vtkRenderWindow()
        self.window.SetOffScreenRendering(True)
        self.window.SetMultiSamples(0)
        self.window.SetSize(SIZE, SIZE)
        self.window.AddRenderer(self.renderer)
        self.camera = self.renderer.GetActiveCamera()

    def ink(self):
        """The picture's darkness, 0 to 1, as an array of SIZE x SIZE."""
        self.window.Render()
        pixels = vtk.vtkUnsignedCharArray()
        self.window.GetPixelData(0, 0, SIZE - 1, SIZE - 1, 0, pixels, 0)
        numbers = np.frombuffer(memoryview(pixels), np.uint8).reshape(SIZE, SIZE, 3)
        return 1 - numbers[:, :, 0] / 255


def contour(as_published):
    image = vtk.vtkImageEllipsoidSource()
    image.SetWholeExtent(0, 127, 0, 127, 0, 127)
    image.SetCenter(63.5, 63.5, 63.5)
    image.SetRadius(50, 50, 50)
    smooth = vtk.vtkImageGaussianSmooth()
    smooth.SetInputConnection(image.GetOutputPort())
    smooth.SetStandardDeviation(1.5)
    sampler = vtkInkIsoSurfaceSampler()
    sampler.SetInputConnection(smooth.GetOutputPort())
    sampler.SetValue(0, 127.5)
    scene = Scene(sampler, as_published)
    scene.camera.ParallelProjectionOn()
    scene.camera.SetFocalPoint(63.5, 63.5, 63.5)
    scene.camera.SetPosition(163.5, 133.5, 263.5)
    scene.camera.SetParallelScale(60)
    scene.renderer.ResetCameraClippingRange()
    ink = scene.ink()
    pixels = 50 * SIZE / 120
    directions = np.arange(0, 2 * np.pi, np.pi / 360)
    # The darkest pixel on the way across the contour.
    across = [
        ink[
            (SIZE / 2 + (pixels + d) * np.sin(directions)).astype(int),
            (SIZE / 2 + (pixels + d) * np.cos(directions)).astype(int),
        ]
        for d in np.arange(-5, 5.5, 0.5)
    ]
    return np.mean(np.max(across, axis=0) >= 0.5)


def engine(as_published):
    reader = vtk.vtkNIFTIImageReader()
    reader.SetFileName(str(ENGINE))
    sampler = vtkInkIsoSurfaceSampler()
    sampler.SetInputConnection(reader.GetOutputPort())
    sampler.SetValue(0, 80)
    scene = Scene(sampler, as_published)
    scene.camera.SetPosition(-1, -2, 1.4)
    scene.camera.SetViewUp(0, 0, 1)
    scene.renderer.ResetCamera()
    return scene


def specks(ink, largest=8):
    dark = ink > 0.1
    total = ink[dark].sum()
    seen = np.zeros_like(dark)
    lonely = 0.0
    for start in zip(*np.nonzero(dark)):
        if seen[start]:
            continue
        seen[start] = True
        spot, rest = [start], [start]
        while rest:
            y, x = rest.pop()
            for v in range(max(y - 1, 0), min(y + 2, SIZE)):
                for u in range(max(x - 1, 0), min(x + 2, SIZE)):
                    if dark[v, u] and not seen[v, u]:
                        seen[v, u] = True
                        spot.append((v, u))
                        rest.append((v, u))
        if len(spot) <= largest:
            lonely += sum(ink[position] for position in spot)
    return lonely / total


def shimmer(scene, before):
    """Compares each picture with the other's neighborhood of a pixel, so that lines may move by that much."""
    scene.camera.Azimuth(0.1)
    after = scene.ink()
    shifts = [(dy, dx) for dy in (-1, 0, 1) for dx in (-1, 0, 1)]

    def unmatched(a, b):
        near = np.max([np.roll(b, shift, (0, 1)) for shift in shifts], axis=0)
        return np.maximum(a - near, 0).sum()

    return (unmatched(before, after) + unmatched(after, before)) / (before.sum() + after.sum())


print(f"{'':12}{'contour':>10}{'specks':>10}{'shimmer':>10}")
for name, as_published in (("published", True), ("vtkInk", False)):
    scene = engine(as_published)
    ink = scene.ink()
    print(f"{name:12}{contour(as_published):10.1%}{specks(ink):10.2%}{shimmer(scene, ink):10.2%}")
