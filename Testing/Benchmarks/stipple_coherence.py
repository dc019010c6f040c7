# SPDX-License-Identifier: BSD-3-Clause
"""The temporal coherence of stipples in motion (Lu et al. 2003, sections 5.2 and 8): the engine, preset anatomy, rotated by a degree a frame
and zoomed by 2 % a frame, seen whole and close up.

    . Utilities/env.sh headless && $INK_PYTHON Testing/Benchmarks/stipple_coherence.py

Of each pair of frames, of the stipples in the window in both, all of them measured on what the shader decides for each stipple (EvaluateMarks):

- come or go: of the stipples drawn in either frame, the share that only one of them has;
- pop: the share of them whose ink changes by half a stipple or more;
- ink: the sum of all changes of ink, as a share of the ink;
- picture: the difference of the second frame to the first one's marks drawn with the second's camera (each stipple where
  it is now, as pale as it was before), as a share of the ink. Without it there is nothing but motion.

None is ever drawn elsewhere than where the generator put it: Testing/Python/test_stipple_pictures.py looks at pictures for that.
"""

import importlib
import pathlib
import sys

import numpy as np
from vtkink import VTK_PACKAGE, vtk, vtkInkStippleControls, vtkInkStippleGenerator, vtkInkStippleMapper

to_numpy = importlib.import_module(f"{VTK_PACKAGE}.util.numpy_support").vtk_to_numpy
ENGINE = pathlib.Path(__file__).resolve().parents[2] / "Data" / "engine.nii.gz"
SIZE = 600
FRAMES = int(sys.argv[1]) if len(sys.argv) > 1 else 10

WAYS = (
    ("intensity, fading (default)", vtkInkStippleMapper.INTENSITY, 1.0),
    ("intensity, sudden", vtkInkStippleMapper.INTENSITY, 0.0),
    ("probability, fading", vtkInkStippleMapper.PROBABILITY, 1.0),
    ("probability, sudden", vtkInkStippleMapper.PROBABILITY, 0.0),
)


class Scene:
    def __init__(self):
        reader = vtk.vtkNIFTIImageReader()
        reader.SetFileName(str(ENGINE))
        generator = vtkInkStippleGenerator()
        generator.SetInputConnection(reader.GetOutputPort())
        generator.SetGradientPercentile(98)
        generator.Update()
        self.points = to_numpy(generator.GetOutput().GetPoints().GetData()).astype(np.float64)
        self.mapper = vtkInkStippleMapper()
        self.mapper.SetInputConnection(generator.GetOutputPort())
        self.mapper.HeadlightOn()
        vtkInkStippleControls().Apply(self.mapper)
        self.mapper.SetFadeBySize(False)
        self.actor = vtk.vtkActor()
        self.actor.SetMapper(self.mapper)
        self.renderer = vtk.vtkRenderer()
        self.renderer.SetBackground(1, 1, 1)
        self.renderer.AddActor(self.actor)
        self.window = vtk.vtkRenderWindow()
        self.window.SetOffScreenRendering(True)
        self.window.SetSize(SIZE, SIZE)
        self.window.AddRenderer(self.renderer)
        self.camera = self.renderer.GetActiveCamera()
        self.look_whole()
        self.window.Render()

    def look_whole(self):
        self.camera.SetPosition(-1, -2, 1.4)
        self.camera.SetFocalPoint(0, 0, 0)
        self.camera.SetViewUp(0, 0, 1)
        self.camera.SetViewAngle(30)
        self.renderer.ResetCamera()

    def dolly(self, factor):
        self.camera.Dolly(factor)
        self.renderer.ResetCameraClippingRange()

    def ink(self):
        """Of each stipple, in whole ones of the drawing's size; 0: not drawn. Also its area in pixels."""
        marks = vtk.vtkFloatArray()
        if not self.mapper.EvaluateMarks(self.renderer, self.actor, marks):
            sys.exit("this OpenGL cannot tell what becomes of the stipples")
        _, opacity, diameter = to_numpy(marks)[:, :3].T.copy()
        return opacity, np.pi / 4 * diameter**2

    def outside(self, drawn):
        """Which of some stipples lie outside the window."""
        return (np.abs(self.positions(drawn) - SIZE / 2) > SIZE / 2).any(axis=1)

    def positions(self, drawn):
        """Where some of the stipples are, in pixels."""
        matrix = self.camera.GetCompositeProjectionTransformMatrix(1, -1, 1)
        to_clip = np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
        clip = np.c_[self.points[drawn], np.ones(len(drawn))] @ to_clip.T
        return (clip[:, :2] / clip[:, 3:] + 1) / 2 * SIZE

    def picture(self, opacity, area):
        """The marks as darkness: their ink shared out to the four pixels around, as far as paper is left."""
        drawn = np.flatnonzero(opacity)
        position = self.positions(drawn) - 0.5
        corner = np.floor(position).astype(int)
        part = position - corner
        ink = np.zeros((SIZE + 2, SIZE + 2))
        amount = (opacity * area)[drawn]
        for dx in (0, 1):
            for dy in (0, 1):
                weight = np.abs(1 - dx - part[:, 0]) * np.abs(1 - dy - part[:, 1])
                np.add.at(ink, (np.clip(corner[:, 1] + dy + 1, 0, SIZE + 1), np.clip(corner[:, 0] + dx + 1, 0, SIZE + 1)),
                          weight * amount)
        return 1 - np.exp(-ink)


def measure(scene, move):
    sums = np.zeros(4)
    last, area_before = scene.ink()
    for _ in range(FRAMES):
        seen = np.flatnonzero(last)
        left = seen[scene.outside(seen)]
        move()
        new, area_after = scene.ink()
        seen = np.flatnonzero(np.maximum(last, new))
        before, after = last.copy(), new.copy()
        # What comes or goes over the window's edges is none of this.
        for gone in (left, seen[scene.outside(seen)]):
            before[gone] = after[gone] = 0
        either = np.count_nonzero((before > 0) | (after > 0))
        change = np.abs(after - before)
        now = scene.picture(after, area_after)
        then = scene.picture(before, area_before)
        sums += (
            np.count_nonzero((before > 0) != (after > 0)) / either,
            np.count_nonzero(change >= 0.5) / either,
            change.sum() / after.sum(),
            np.abs(now - then).sum() / now.sum(),
        )
        last, area_before = new, area_after
    return sums / FRAMES


scene = Scene()
print(f"{len(scene.points)} stipples, {FRAMES} frames each, window {SIZE}x{SIZE}\n")
print("| motion | parts of stipples | come or go | pop | ink | picture |\n|---|---|---|---|---|---|")
for seen, nearer in (("whole", 1.0), ("close up", 3.0)):
    for motion, move in (("rotation", lambda: scene.camera.Azimuth(1)), ("zoom", lambda: scene.dolly(1.02))):
        for name, way, fade in WAYS:
            scene.look_whole()
            scene.dolly(nearer)
            scene.mapper.SetSmallElements(way)
            scene.mapper.SetFade(fade)
            numbers = " | ".join(f"{number:.2%}" for number in measure(scene, move))
            print(f"| {motion}, {seen} | {name} | {numbers} |", flush=True)
