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
vtkInkSilhouetteMapper draws them, and *coherent* the same with its CoherentDashes, which shifts each chain's dashes as a whole to where
they were in the frame before. Silhouettes of volumes are straight from the voxels; `surface` is the smoothed one that the
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
    """Chains in pieces: where each one's middle is, its length, and the place in a period of dashes."""

    def __init__(self, lines, period):
        points = support.vtk_to_numpy(lines.GetPoints().GetData()).astype(float).reshape(-1, 3)
        arcs = support.vtk_to_numpy(lines.GetPointData().GetArray("ArcLength"))
        offsets = support.vtk_to_numpy(lines.GetLines().GetOffsetsArray())
        ids = support.vtk_to_numpy(lines.GetLines().GetConnectivityArray())
        middles, lengths, phases = [np.zeros((0, 3))], [np.zeros(0)], [np.zeros(0)]
        for begin, end in zip(offsets[:-1], offsets[1:]):
            chain = ids[begin:end]
            steps = np.linalg.norm(np.diff(points[chain], axis=0), axis=1)
            whole = steps.sum()
            closed = chain[0] == chain[-1]
            # A closed line has a whole number of dashes.
            fitted = whole / max(round(whole / period), 1) if closed and whole > 0 else period
            middles.append((points[chain[:-1]] + points[chain[1:]]) / 2)
            lengths.append(steps)
            phases.append((arcs[chain[:-1]] + steps / 2) / fitted % 1.0)
        self.middles, self.lengths, self.phases = map(np.concatenate, (middles, lengths, phases))
        self.data = vtk.vtkPolyData()
        self.data.SetPoints(vtk.vtkPoints())
        self.data.GetPoints().SetData(support.numpy_to_vtk(self.middles, deep=1))

    def nearest(self, others):
        """Of each piece the nearest one of another frame, and how far it is."""
        locator = vtk.vtkStaticPointLocator()
        locator.SetDataSet(others.data)
        locator.BuildLocator()
        found = np.array([locator.FindClosestPoint(middle) for middle in self.middles], int)
        return found, np.linalg.norm(self.middles - others.middles[found], axis=1)


def compare(before, after, reach):
    """What appears, disappears, slides and jumps."""
    _, away = before.nearest(after)
    found, fresh = after.nearest(before)
    total = after.lengths.sum()
    stays = fresh <= reach
    change = np.abs(after.phases - before.phases[found])
    slide = np.minimum(change, 1 - change)[stays]
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
