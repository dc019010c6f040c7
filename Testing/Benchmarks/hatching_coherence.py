# SPDX-License-Identifier: BSD-3-Clause
"""The temporal coherence of hatching in motion: line art of an engine, its two families of strokes without contours, turned by a
degree a frame and zoomed by 2 % a frame, seen whole and close up.

    . Utilities/env.sh headless && $INK_PYTHON Testing/Benchmarks/hatching_coherence.py [FRAMES]

The light moves with the camera, as the style has it, or stays where it is, which leaves the tones as they are. Of each pair of frames,
of the parts of strokes between two of their points that are in the window and face the viewer in both (by a cosine of a tenth; nearer to
a silhouette a pixel holds all tones), as wide as the shader has them (EvaluateWidths):

- come or go: of the length drawn in either frame, the share that only one of them has;
- pop: the share of it whose width changes by half a pixel or more;
- most: the largest change of a part's width, in pixels;
- ink: the sum of all changes of ink, as a share of the ink;
- picture: the difference of the second frame to the first one's strokes drawn with the second's camera (each as wide as it
  was before), as a share of the ink. Without it there is nothing but motion;
- shimmer: of all ink of the true pictures, the share that comes or goes beyond a pixel's shift when the motion is only so long that
  no stroke moves by more than half a pixel.
"""

import importlib
import pathlib
import sys

import numpy as np
import vtkink
from vtkink import VTK_PACKAGE, vtk, vtkInkLineArtStyle, vtkInkStrokeMapper

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from lines_coherence import widened  # noqa: E402

support = importlib.import_module(f"{VTK_PACKAGE}.util.numpy_support")
DATA = pathlib.Path(__file__).resolve().parents[2] / "Data"
SIZE = 600
WIDE = 0.5  # pixels: a change that pops
SHIFT = 0.5  # pixels: motion that shimmers
FACING = 0.1  # cosine


class Scene:
    """Strokes of a style's preset over a surface that hides them; and the same with widths that stay."""

    def __init__(self, data, preset, size=SIZE, **parameters):
        self.size = size
        self.style = vtkInkLineArtStyle()
        for name, value in {"Preset": preset, **parameters}.items():
            self.style.SetParameterAsString(name, str(value))
        self.style.Draw(data)
        self.mapper = self.style.GetStrokeMapper()
        strokes = self.style.GetPiece(1)
        offsets = support.vtk_to_numpy(strokes.GetLines().GetOffsetsArray())
        # Of many points only some are strokes'.
        self.used, ids = np.unique(support.vtk_to_numpy(strokes.GetLines().GetConnectivityArray()), return_inverse=True)
        self.points = support.vtk_to_numpy(strokes.GetPoints().GetData())[self.used].astype(float)
        inner = np.ones(len(ids) - 1, bool)
        inner[offsets[1:-1] - 1] = False
        self.parts = np.stack([ids[:-1], ids[1:]], axis=1)[inner]

        self.frozen_strokes = vtk.vtkPolyData()
        self.frozen_strokes.SetPoints(vtk.vtkPoints())
        self.frozen_strokes.GetPoints().SetData(support.numpy_to_vtk(self.points, deep=1))
        lines = vtk.vtkCellArray()
        lines.SetData(*(support.numpy_to_vtkIdTypeArray(array.astype(np.int64), deep=1) for array in (offsets, ids)))
        self.frozen_strokes.SetLines(lines)
        normals = support.vtk_to_numpy(strokes.GetPointData().GetNormals())[self.used]
        self.frozen_strokes.GetPointData().SetNormals(support.numpy_to_vtk(normals, deep=1))
        self.normals = normals.astype(float)
        self.frozen_mapper = vtkInkStrokeMapper()
        self.frozen_mapper.SetInputData(self.frozen_strokes)
        self.frozen_mapper.SetSurfaceData(self.style.GetPiece(0))
        self.frozen_mapper.SetSizeUnitToPixels()
        self.frozen_mapper.SetLineWidth(1)
        self.frozen_mapper.SetTaper(self.mapper.GetTaper())

        self.renderer = vtk.vtkRenderer()
        self.renderer.SetBackground(1, 1, 1)
        self.renderer.AutomaticLightCreationOff()
        self.renderer.AddLight(self.style.GetLight())
        self.actor, self.frozen = vtk.vtkActor(), vtk.vtkActor()
        for actor, mapper in ((self.actor, self.mapper), (self.frozen, self.frozen_mapper)):
            actor.SetMapper(mapper)
            self.renderer.AddActor(actor)
        self.frozen.VisibilityOff()
        self.window = vtk.vtkRenderWindow()
        self.window.SetOffScreenRendering(True)
        self.window.SetMultiSamples(0)
        self.window.SetSize(size, size)
        self.window.AddRenderer(self.renderer)
        self.camera = self.renderer.GetActiveCamera()
        self.look_whole()
        self.window.Render()

    def fix_light(self):
        """Leaves the light where it is, whatever the camera does."""
        light = self.style.GetLight()
        position, target = light.GetTransformedPosition(), light.GetTransformedFocalPoint()
        light.SetTransformMatrix(None)
        light.SetLightTypeToSceneLight()
        light.SetPosition(position)
        light.SetFocalPoint(target)

    def look_whole(self):
        self.camera.SetPosition(-1, -2, 1.4)
        self.camera.SetFocalPoint(0, 0, 0)
        self.camera.SetViewUp(0, 0, 1)
        self.camera.SetViewAngle(30)
        self.renderer.ResetCamera()

    def turn(self, degrees):
        self.camera.Azimuth(degrees)
        self.renderer.ResetCameraClippingRange()

    def dolly(self, factor):
        self.camera.Dolly(factor)
        self.renderer.ResetCameraClippingRange()

    def picture(self):
        """How dark pixels are, 0 to 1."""
        self.window.Render()
        pixels = vtk.vtkUnsignedCharArray()
        self.window.GetPixelData(0, 0, self.size - 1, self.size - 1, 0, pixels, 0)
        return 1 - np.frombuffer(memoryview(pixels), np.uint8).reshape(self.size, self.size, 3)[:, :, 0] / 255

    def frozen_picture(self, widths):
        """The strokes with widths of points, whatever light and distance ask for."""
        array = support.numpy_to_vtk(widths, deep=1)
        array.SetName("Width")
        self.frozen_strokes.GetPointData().AddArray(array)
        self.actor.VisibilityOff()
        self.frozen.VisibilityOn()
        ink = self.picture()
        self.actor.VisibilityOn()
        self.frozen.VisibilityOff()
        return ink

    def widths(self):
        """Of the strokes at each point, in pixels."""
        widths = vtk.vtkFloatArray()
        if not self.mapper.EvaluateWidths(self.renderer, self.actor, widths):
            sys.exit("this OpenGL cannot tell how wide strokes are")
        return support.vtk_to_numpy(widths)[self.used]

    def pixels(self):
        """Where points are in the window."""
        matrix = self.camera.GetCompositeProjectionTransformMatrix(1, -1, 1)
        to_clip = np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
        clip = np.c_[self.points, np.ones(len(self.points))] @ to_clip.T
        return (clip[:, :2] / clip[:, 3:] + 1) / 2 * self.size

    def seen(self, pixels):
        """Which points are in the window and face the viewer, who is not infinitely far away."""
        to_viewer = np.array(self.camera.GetPosition()) - self.points
        cosine = (to_viewer * self.normals).sum(axis=1) / np.linalg.norm(to_viewer, axis=1)
        return (cosine > FACING) & (np.abs(pixels - self.size / 2) < self.size / 2).all(axis=1)


def compare(before, after, lengths):
    """What comes or goes, pops, changes most, and changes of the ink: of parts with widths, and lengths, in both frames."""
    either = np.maximum(before, after) > 0
    drawn = lengths[either].sum()
    change = np.abs(after - before)
    return (
        lengths[(before > 0) != (after > 0)].sum() / drawn,
        lengths[change >= WIDE].sum() / drawn,
        change.max(),
        (change * lengths).sum() / (after * lengths).sum(),
    )


def unmatched(before, after):
    """The share of the ink of two pictures that comes or goes beyond a pixel's shift."""
    gone = np.maximum(before - widened(after), 0)
    come = np.maximum(after - widened(before), 0)
    return (gone.sum() + come.sum()) / (before.sum() + after.sum())


def measure(scene, frames, move):
    """All six numbers, the means over the frames, but of the largest change the largest; `move` takes a share of a frame's motion."""
    rows = []
    before, pixels = scene.widths(), scene.pixels()
    seen = scene.seen(pixels)
    for _ in range(frames):
        picture = scene.picture()
        move(1.0)
        after, moved = scene.widths(), scene.pixels()
        seen_after = scene.seen(moved)
        both = (seen & seen_after)[scene.parts].all(axis=1)
        move(-1.0)
        share = SHIFT / np.linalg.norm(moved - pixels, axis=1)[scene.parts[both]].max()
        move(share)
        shimmer = unmatched(picture, scene.picture())
        move(1.0 - share)
        ends = moved[scene.parts[both]]
        lengths = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
        parts = [widths[scene.parts[both]].mean(axis=1) for widths in (before, after)]
        now, then = scene.frozen_picture(after), scene.frozen_picture(before)
        rows.append((*compare(*parts, lengths), np.abs(now - then).sum() / now.sum(), shimmer))
        before, pixels, seen = after, moved, seen_after
    mean = np.mean(rows, axis=0)
    mean[2] = np.max(rows, axis=0)[2]
    return mean


def main(frames):
    engine = vtkink.read(DATA / "engine.nii.gz")
    print(f"{frames} frames each, window {SIZE}x{SIZE}\n")
    print("| motion | preset | light | come or go | pop | most | ink | picture | shimmer |\n|---|---|---|---|---|---|---|---|---|")
    for preset in ("engraving", "sketch"):
        scene = Scene(engine, preset, IsoValues=80)
        motions = {"rotation": scene.turn, "zoom": lambda share: scene.dolly(1.02**share)}
        for light in ("with the camera", "fixed"):
            for seen, nearer in (("whole", 1.0), ("close up", 3.0)):
                for motion, move in motions.items():
                    scene.look_whole()
                    scene.dolly(nearer)
                    scene.window.Render()
                    come, pop, most, ink, picture, shimmer = measure(scene, frames, move)
                    row = f"{come:.2%} | {pop:.2%} | {most:.2f} | {ink:.2%} | {picture:.2%} | {shimmer:.2%}"
                    print(f"| {motion}, {seen} | {preset} | {light} | {row} |", flush=True)
            scene.look_whole()
            scene.window.Render()
            scene.fix_light()


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 10)
