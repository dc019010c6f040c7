# SPDX-License-Identifier: BSD-3-Clause
"""The temporal coherence of contours in motion: subjects that are turned by a degree a frame.

    . Utilities/env.sh headless && $INK_PYTHON Testing/Benchmarks/contours_coherence.py [FRAMES]

A surface's silhouettes move over it as the eye moves, so that the same line is never in the same place twice. Of each pair of
frames, with all chains, hidden ones too, in pieces no longer than their segments:

- appear, disappear: of all chains' length, the share that is farther from the other frame's chains than REACH, in hundredths of
  the subject's diagonal: three times what a point turns by that is half a diagonal from the axis;
- slide: of the length that stays, how far dashes move along it, in periods of a dash and its gap, on average; 0.25 is chance;
- jump: the share of that length whose dashes move by more than a tenth of a period.

Dashes are those of the style Contours. *drawn* is the slide of surfaces' silhouettes and borders, without creases, as
vtkInkSilhouetteMapper draws them, and *coherent* the same with its CoherentDashes, which draws them to where they were in the
frame before. Silhouettes of volumes are straight from the voxels; `surface` is the smoothed one that the
style draws.
"""

import importlib
import pathlib
import sys

import numpy as np
import vtkink
from vtkink import VTK_PACKAGE, vtk, vtkInkContours, vtkInkContoursStyle, vtkInkSilhouetteMapper

support = importlib.import_module(f"{VTK_PACKAGE}.util.numpy_support")
DATA = pathlib.Path(__file__).resolve().parents[2] / "Data"
REACH = 2.7
# Dash and gap, in thousandths of the picture's height, which the diagonal about fills.
PERIOD = 0.013


def sphere():
    source = vtk.vtkSphereSource()
    source.SetThetaResolution(240)
    source.SetPhiResolution(120)
    source.Update()
    return source.GetOutput()


def box():
    """A machine part: all of its lines are drawn as creases, which do not depend on the eye."""
    source = vtk.vtkCubeSource()
    source.Update()
    return source.GetOutput()


def surface(image, value):
    style = vtkInkContoursStyle()
    style.SetParameterAsString("IsoValues", str(value))
    style.Draw(image)
    return style.GetPiece(0)


class Frame:
    """Chains in pieces: each one's middle, its vector, and the phases of dashes in its middle and from end to end, in periods."""

    def __init__(self, lines, period):
        points = support.vtk_to_numpy(lines.GetPoints().GetData()).astype(float).reshape(-1, 3)
        arcs = support.vtk_to_numpy(lines.GetPointData().GetArray("ArcLength"))
        offsets = support.vtk_to_numpy(lines.GetLines().GetOffsetsArray())
        ids = support.vtk_to_numpy(lines.GetLines().GetConnectivityArray())
        pieces = [(np.zeros((0, 3)), np.zeros((0, 3)), np.zeros(0), np.zeros(0))]
        for begin, end in zip(offsets[:-1], offsets[1:]):
            chain = ids[begin:end]
            ways = np.diff(points[chain], axis=0)
            closed = chain[0] == chain[-1]
            along = arcs[chain].astype(float)
            if closed:
                # As strokes are drawn, the last segment has its own length, and the line a whole number of dashes.
                along[-1] = along[-2] + np.linalg.norm(ways[-1])
            whole = along[-1] - along[0]
            fitted = whole / max(round(whole / period), 1) if closed and whole > 0 else period
            along /= fitted
            pieces.append((points[chain[:-1]] + ways / 2, ways, (along[:-1] + along[1:]) / 2, np.diff(along)))
        self.middles, self.ways, self.phases, self.steps = map(np.concatenate, zip(*pieces))
        self.lengths = np.linalg.norm(self.ways, axis=1)
        self.data = vtk.vtkPolyData()
        self.data.SetPoints(vtk.vtkPoints())
        self.data.GetPoints().SetData(support.numpy_to_vtk(self.middles, deep=1))

    def nearest(self, others):
        """Of each piece's middle the phase at the nearest point of another frame, and how far its piece is."""
        locator = vtk.vtkStaticPointLocator()
        locator.SetDataSet(others.data)
        locator.BuildLocator()
        found = np.array([locator.FindClosestPoint(middle) for middle in self.middles], int)
        away = self.middles - others.middles[found]
        along = (away * others.ways[found]).sum(axis=1) / np.maximum(others.lengths[found] ** 2, 1e-30)
        along = np.clip(along, -0.5, 0.5)
        return others.phases[found] + along * others.steps[found], np.linalg.norm(away, axis=1)


def compare(before, after, reach):
    """What appears, disappears, slides and jumps."""
    _, away = before.nearest(after)
    phases, fresh = after.nearest(before)
    total = after.lengths.sum()
    stays = fresh <= reach
    change = after.phases - phases
    slide = np.abs(change - np.round(change))[stays]
    kept = after.lengths[stays]
    return (
        after.lengths[~stays].sum() / total,
        before.lengths[away > reach].sum() / before.lengths.sum(),
        (slide * kept).sum() / kept.sum(),
        kept[slide > 0.1].sum() / kept.sum(),
    )


def eye_at(degrees, diagonal, middle):
    angle = np.radians(20 + degrees)
    return middle + 2 * diagonal * np.array([np.sin(angle), -np.cos(angle), 0.4])


def compare_frames(at, frames, diagonal):
    all_frames = [at(degrees) for degrees in range(frames + 1)]
    rows = [compare(*pair, REACH / 100 * diagonal) for pair in zip(all_frames[:-1], all_frames[1:])]
    return np.mean(rows, axis=0)


def measure(data, frames, value=None, silhouettes=True):
    contours = vtkInkContours()
    contours.SetInputData(data)
    contours.SetSilhouettes(silhouettes)
    contours.ComputeArcLengthOn()
    if value is not None:
        contours.SetValue(0, value)
    else:
        contours.CreasesOn()
        contours.SetFeatureAngle(40)
    diagonal, middle = data.GetLength(), np.array(data.GetCenter())
    contours.SetEyeToPosition()

    def at(degrees):
        contours.SetEyePosition(*eye_at(degrees, diagonal, middle))
        contours.Update()
        return Frame(contours.GetOutput(), PERIOD * diagonal)

    return compare_frames(at, frames, diagonal)


def measure_drawn(data, frames, coherent):
    """How far dashes slide that the mapper draws."""
    diagonal, middle = data.GetLength(), np.array(data.GetCenter())
    mapper = vtkInkSilhouetteMapper()
    mapper.SetInputData(data)
    mapper.SetSizeUnitToWorld()
    mapper.SetDashLength(8 / 13 * PERIOD * diagonal)
    mapper.SetGapLength(5 / 13 * PERIOD * diagonal)
    mapper.DashedOn()
    mapper.SetCoherentDashes(coherent)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    renderer = vtk.vtkRenderer()
    renderer.AddActor(actor)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetSize(64, 64)
    window.AddRenderer(renderer)
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(*middle)
    camera.SetViewUp(0, 0, 1)

    def at(degrees):
        camera.SetPosition(*eye_at(degrees, diagonal, middle))
        renderer.ResetCameraClippingRange()
        window.Render()
        return Frame(mapper.GetContours(renderer, actor), PERIOD * diagonal)

    return compare_frames(at, frames, diagonal)[2]


def main(frames):
    engine, bonsai = (vtkink.read(DATA / f"{name}.nii.gz") for name in ("engine", "bonsai"))
    print(f"{frames} frames of a degree each\n")
    print("| contours of | appear | disappear | slide | jump | drawn | coherent |\n|---|---|---|---|---|---|---|")
    for name, data, options in (
        ("box", box(), {"silhouettes": False}),
        ("sphere", sphere(), {}),
        ("engine", engine, {"value": 100.0}),
        ("engine, surface", surface(engine, 100.0), {}),
        ("bonsai", bonsai, {"value": 40.0}),
        ("bonsai, surface", surface(bonsai, 40.0), {}),
    ):
        appear, disappear, slide, jump = measure(data, frames, **options)
        # The mapper takes surfaces.
        drawn = " | " if "value" in options else " | ".join(f"{measure_drawn(data, frames, on):.3f}" for on in (False, True))
        print(f"| {name} | {appear:.2%} | {disappear:.2%} | {slide:.3f} | {jump:.1%} | {drawn} |", flush=True)


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 10)
