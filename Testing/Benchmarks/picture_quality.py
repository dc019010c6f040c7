# SPDX-License-Identifier: BSD-3-Clause
"""How good pictures of volumes are, compared with pictures of the surfaces that the volumes were made of.

    . Utilities/env.sh headless
    $INK_PYTHON Testing/Benchmarks/picture_quality.py --quick              # some cases, in minutes
    $INK_PYTHON Testing/Benchmarks/picture_quality.py --output today.csv   # all of them
    $INK_PYTHON Testing/Benchmarks/picture_quality.py --page today.csv     # writes Documentation/picture-quality.md

Each known surface (phantoms.py) becomes volumes of different sizes, types and noise. Each volume is drawn with a style's
defaults, the iso-value included, and compared (picture_metrics.py) with the surface's mesh drawn by the same style with the
same camera. The bunny and the horse of Stanford and Georgia Tech are taken from a folder (--meshes), where they lie in one.
"""

import argparse
import csv
import itertools
import multiprocessing
import os
import pathlib
import re
import sys
import time
from typing import NamedTuple

import numpy as np
import phantoms
import picture_metrics
import vtkink
from vtkink import numpy_support, vtk

SIZE = 1024
SUPERSAMPLING = 2
MARGIN = 0.05
VIEW_ANGLE = 30.0
#: From the front, from the right and from above.
DIRECTION = np.array([-np.sin(np.radians(30)), np.cos(np.radians(30)), -np.tan(np.radians(15))])

SIZES = (48, 96, 192)
SLICE_DISTANCES = (1, 3)
TYPES = ("uint8", "int16")
NOISES = (0.0, 0.02, 0.05, 0.1)


class Case(NamedTuple):
    surface: str
    size: int
    slice_distance: int
    type: str
    noise: float

    def __str__(self):
        slices = "" if self.slice_distance == 1 else f" 1:1:{self.slice_distance}"
        return f"{self.surface} {self.size}{slices} {self.type} {100 * self.noise:.0f}%"


class Result(NamedTuple):
    """A row of the table; what a style does not show is empty."""

    surface: str
    size: int
    slice_distance: int
    type: str
    noise: float
    style: str
    iso_error: float | str = ""  #: in steps of the outermost boundary
    precision: float | str = ""
    recall: float | str = ""
    f: float | str = ""
    tone: float | str = ""
    evenness: float | str = ""
    reference_evenness: float | str = ""
    outside: float | str = ""
    bare: float | str = ""
    f_ceiling: float | str = ""  #: of the mesh of the volume's values before noise and rounding
    bare_ceiling: float | str = ""


QUICK = (
    Case("bunny", 96, 1, "int16", 0.0),
    Case("bunny", 96, 1, "uint8", 0.05),
    Case("bunny", 48, 1, "uint8", 0.02),
    Case("horse", 96, 1, "int16", 0.02),
    Case("horse", 192, 3, "uint8", 0.0),
    Case("knot", 48, 1, "uint8", 0.0),
    Case("knot", 96, 1, "int16", 0.1),
    Case("vessels", 96, 1, "uint8", 0.05),
    Case("vessels", 192, 1, "int16", 0.02),
    Case("shells", 96, 1, "uint8", 0.02),
    Case("shells", 96, 3, "int16", 0.05),
    Case("two materials", 96, 3, "int16", 0.05),
    Case("two materials", 48, 1, "uint8", 0.1),
)
STYLES = ("splatting-lines", "stipple", "illustration")


def all_cases(surfaces):
    return [Case(*values) for values in itertools.product(surfaces, SIZES, SLICE_DISTANCES, TYPES, NOISES)]


# ----------------------------------------------------------------------------------------------------------- pictures


def fit_camera(points):
    """The camera that sees all points, in the middle of the picture and with a margin, as `ink render` does."""
    direction = DIRECTION / np.linalg.norm(DIRECTION)
    right = np.cross(direction, [0, 0, 1])
    right /= np.linalg.norm(right)
    up = np.cross(right, direction)
    center = (points.min(axis=0) + points.max(axis=0)) / 2
    tangent = (1 - MARGIN) * np.tan(np.radians(VIEW_ANGLE / 2))
    across, depth = np.abs((points - center) @ np.stack([right, up]).T), (points - center) @ direction
    distance = float((across / tangent - depth[:, None]).max())
    camera = vtk.vtkCamera()
    camera.SetViewAngle(VIEW_ANGLE)
    camera.SetFocalPoint(*center)
    camera.SetPosition(*(center - distance * direction))
    camera.SetViewUp(*up)
    return camera


def _darkness(renderer, supersampling):
    """Renders, and returns how dark pixels are, 0 to 1, from the bottom row on."""
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(SIZE * supersampling, SIZE * supersampling)
    window.AddRenderer(renderer)
    renderer.ResetCameraClippingRange()
    window.Render()
    pixels = vtk.vtkUnsignedCharArray()
    end = SIZE * supersampling - 1
    window.GetPixelData(0, 0, end, end, 0, pixels, 0)
    window.Finalize()
    shape = (SIZE, supersampling, SIZE, supersampling, 3)
    # Green stands for gray.
    return 1 - np.frombuffer(memoryview(pixels), np.uint8).reshape(shape)[..., 1].mean(axis=(1, 3)) / 255


def draw(data, style, camera):
    """The darkness of a picture as vtkink.draw writes it, but with a camera; and the style's notes."""
    actor = vtkink.draw(data, style, size=(SIZE, SIZE))
    made = actor.style
    renderer = vtk.vtkRenderer()
    background = [0.0, 0.0, 0.0]
    made.GetBackgroundColor(background)
    renderer.SetBackground(background)
    if made.GetLight() is not None:
        renderer.RemoveAllLights()
        renderer.AddLight(made.GetLight())
    renderer.SetActiveCamera(camera)
    renderer.AddActor(actor)
    made.SetPixelScale(SUPERSAMPLING)
    darkness = _darkness(renderer, SUPERSAMPLING)
    return darkness, [made.GetNote(index) for index in range(made.GetNumberOfNotes())]


def find_silhouette(mesh, camera):
    """Where the mesh is, an array of bool."""
    mapper, actor, renderer = vtk.vtkPolyDataMapper(), vtk.vtkActor(), vtk.vtkRenderer()
    mapper.SetInputData(mesh)
    mapper.ScalarVisibilityOff()
    actor.SetMapper(mapper)
    actor.GetProperty().LightingOff()
    actor.GetProperty().SetColor(0, 0, 0)
    renderer.SetBackground(1, 1, 1)
    renderer.SetActiveCamera(camera)
    renderer.AddActor(actor)
    return _darkness(renderer, 1) > 0.5


def write_pair(path, reference, picture):
    """A PNG file: the mesh's picture on the left, the volume's on the right."""
    pair = np.concatenate([reference, np.ones((SIZE, 4)), picture], axis=1)
    image = vtk.vtkImageData()
    image.SetDimensions(pair.shape[1], pair.shape[0], 1)
    values = np.rint(255 * (1 - pair)).astype(np.uint8)
    image.GetPointData().SetScalars(numpy_support.numpy_to_vtk(values.reshape(-1), deep=True))
    writer = vtk.vtkPNGWriter()
    writer.SetInputData(image)
    writer.SetFileName(str(path))
    writer.Write()


# ------------------------------------------------------------------------------------------------------------ measure


def _iso_error(notes, boundary):
    """How far the first iso-value that is named lies from the middle of the boundary."""
    named = re.search(r"iso-value ([-+.\de]+)", " ".join(notes))
    outside, inside = boundary
    return (float(named[1]) - (outside + inside) / 2) / (inside - outside) if named else ""


def find_ceiling(style, mesh, references):
    """What the grid lets a picture reach: F and bare of the mesh of the values before noise and rounding."""
    picture, _ = draw(mesh, style, references.camera)
    if style == "splatting-lines":
        return {"f_ceiling": picture_metrics.compare_lines(picture, references.pictures[style]).f}
    found = picture_metrics.compare_stipples(picture, references.pictures[style], references.silhouette)
    return {"bare_ceiling": found.bare}


def measure(case, style, phantom, references, ceiling, pictures=None):
    """
    :param ceiling: of find_ceiling
    :param pictures: a folder, for a PNG file of both pictures
    """
    reference = references.pictures[style]
    try:
        picture, notes = draw(phantoms.image(phantom), style, references.camera)
    except ValueError as nothing:
        print(f"{case}, {style}: {nothing}", file=sys.stderr)
        picture, notes = np.zeros((SIZE, SIZE)), []
    if pictures:
        name = f"{case}, {style}".replace(" ", "-").replace(",", "").replace(":", "").replace("%", "")
        write_pair(pathlib.Path(pictures) / f"{name}.png", reference, picture)
    found = {"iso_error": _iso_error(notes, phantom.boundary), **ceiling}
    if style == "splatting-lines":
        found.update(picture_metrics.compare_lines(picture, reference)._asdict())
    else:
        found.update(picture_metrics.compare_stipples(picture, reference, references.silhouette)._asdict())
    return Result(*case, style, **found)


class References(NamedTuple):
    """What pictures of a surface's volumes are compared with."""

    points: np.ndarray  #: of the mesh that it is
    camera: object
    silhouette: np.ndarray
    pictures: dict  #: by style: the mesh's, as darkness


def draw_references(surface, styles):
    mesh, camera = phantoms.mesh(surface), fit_camera(surface.points)
    pictures = {style: draw(mesh, style, camera)[0] for style in styles}
    return References(surface.points, camera, find_silhouette(mesh, camera), pictures)


class Group(NamedTuple):
    """Cases of one surface, those with the same grid one after the other."""

    cases: list
    styles: tuple
    meshes: str
    pictures: str
    ceilings: bool = True  #: whether to measure what the grid lets pictures reach, too

    def __call__(self):
        results, of = [], None
        for (name, *grid), cases in itertools.groupby(self.cases, key=lambda case: case[:3]):
            grid = phantoms.cube(*grid)
            surfaces = phantoms.with_scans(self.meshes)[name](grid)
            # Most meshes are the same for any grid, and then so are their pictures.
            if of is None or not np.array_equal(of.points, surfaces[0].points):
                of = draw_references(surfaces[0], self.styles)
            values = phantoms.blurred(surfaces, grid)
            ceilings = dict.fromkeys(self.styles, {})
            if self.ceilings:
                sharp = phantoms.mesh(phantoms.iso_surface(values, grid, surfaces[0].step / 2))
                ceilings = {style: find_ceiling(style, sharp, of) for style in self.styles}
            for case in cases:
                phantom = phantoms.scan(surfaces, values, grid, case.type, case.noise)
                for style in self.styles:
                    results.append(measure(case, style, phantom, of, ceilings[style], self.pictures))
        return results


def _run(group):
    return group()


def run(cases, styles, meshes, pictures, jobs):
    groups = {}
    for case in sorted(cases, key=lambda case: case[:3]):
        groups.setdefault(case.surface, []).append(case)
    # The longest first, so that no process is left alone with it.
    groups = [Group(group, styles, meshes, pictures) for group in groups.values()]
    groups.sort(key=lambda group: -sum(case.size for case in group.cases))
    results = []
    start = time.monotonic()
    with multiprocessing.get_context("spawn").Pool(jobs) as pool:
        for done in pool.imap_unordered(_run, groups):
            results += done
            print(f"{len(results)} of {len(cases) * len(styles)}, {time.monotonic() - start:.0f} s", file=sys.stderr)
    order = {case: index for index, case in enumerate(cases)}
    return sorted(results, key=lambda result: (styles.index(result.style), order[Case(*result[:5])]))


def write_csv(results, path):
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(Result._fields)
        writer.writerows([f"{value:.4g}" if isinstance(value, float) else value for value in row] for row in results)


def read_csv(path):
    kinds = {**dict.fromkeys(Result._fields, float), "surface": str, "type": str, "style": str}
    kinds.update(size=int, slice_distance=int)
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    return [Result(**{name: kinds[name](text) if text else "" for name, text in row.items()}) for row in rows]


# --------------------------------------------------------------------------------------------------------------- page

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE = ROOT / "Documentation" / "picture-quality.md"
INTRODUCTION = """# Picture quality

How near pictures of volumes, drawn with nothing but `--style`, come to pictures of the surface that the volume shows.
Known surfaces become volumes as a scanner would see them: blurred by a point spread of 0.7 voxel, with Gaussian noise of
0 to 10 % of the step at the boundary, as uint8 (a step of 160) and int16 (2000), in cubes of 48, 96 and 192 voxels a side
and with slices as far apart as one voxel or three. Each picture has 1024 x 1024 pixels and is compared with the one that
the same style draws of the surface's mesh with the same camera. This page is written by

    . Utilities/env.sh headless
    $INK_PYTHON Testing/Benchmarks/picture_quality.py --output today.csv --meshes FOLDER
    $INK_PYTHON Testing/Benchmarks/picture_quality.py --page today.csv Testing/Benchmarks/picture-quality-before.csv

`--quick` measures some cases, in some minutes of one processor: those of the tables below. FOLDER holds the Stanford
bunny and the Georgia Tech horse as bunny.ply and horse.ply; without it these two are left out.
[phantoms.py](../Testing/Benchmarks/phantoms.py) makes the volumes, [picture_metrics.py](../Testing/Benchmarks/picture_metrics.py)
compares.

- precision: the share of the ink that lies within 2 pixels of the mesh picture's ink; recall: the share of the mesh
  picture's ink that lies within 2 pixels of ink; F: their harmonic mean;
- tone: the root mean square difference of darkness within the silhouette, after a blur of 12 pixels, in % of full ink;
- evenness: the mean distance from a dot to the nearest one, in that of a hexagonal lattice of as many dots on the same area:
  how much less it is than in the mesh's picture;
- outside: the share of the ink that lies more than 2 pixels outside of the surface's silhouette;
- bare: the share of the silhouette that is bare where the mesh's picture is not;
- iso-value: how far the one chosen lies from the middle of the outermost boundary, in % of its step;
- ceiling: the same figure of the picture of another mesh, which marching cubes make of the volume's values before noise and
  rounding, at the true middle of the boundary: what the grid itself leaves of the surface.

The tree of vessels tapers from 6 voxels to 1 at every size. A tube that is thinner than 1.65 voxels does not reach half of
its value after the point spread, so that no iso-surface shows the last fifth of the tree's length without showing noise,
too. Two pixels are 0.1 voxels of 48 and 0.2 of 96: what the bunny and the horse lack are lines of details that are finer than
voxels; contours of the two materials are displaced, as their outer boundary is half a step, so that the denser ball is half
a voxel larger at the one iso-value that both share, and noise is twice as large a share of it; shells of two voxels in slices
of three are neither whole nor smooth. So the ceiling of F is 0.87 for the bunny at 96 and 0.54 at 48, 0.82 for the horse at 96,
0.64 and 0.79 for the vessels at 96 and 192, 0.60 and 0.22 for the shells with slices as far apart as one voxel and three, 0.47 and
0.43 for the two materials at 96 1:1:3 and at 48. Of the rows below the target, all reach it with their noise but the last, which
has 10 % noise; volumes, which are smoothed and subdivided, are often better than that mesh. Dots are as even as the mesh's within
0.05 in all pictures of stipples; of the illustrations, the vessels at 96 miss it by 0.0001.
"""


class Measure(NamedTuple):
    title: str
    field: str  #: of Result, which is empty where there is no such figure
    value: callable  #: of a result
    is_reached: callable  #: the target, of a result
    target: str  #: empty for what has none
    digits: int


def _f_target(result):
    return 0.9 if result.size >= 96 and result.noise <= 0.05 else 0.8


def _percent(title, field, most, target, digits):
    value = lambda result: 100 * getattr(result, field)
    return Measure(title, field, value, lambda result: abs(value(result)) <= most, target, digits)


F = Measure("F", "f", lambda r: r.f, lambda r: r.f >= _f_target(r), "0.9; 0.8 at 48 or 10 % noise", 2)
EVENNESS = Measure(
    "evenness",
    "evenness",
    lambda r: r.evenness - r.reference_evenness,
    lambda r: abs(r.evenness - r.reference_evenness) <= 0.05,
    "within 0.05",
    2,
)
MEASURES = (
    F,
    _percent("tone, %", "tone", 5, "5", 1),
    EVENNESS,
    _percent("outside, %", "outside", 1, "1", 1),
    _percent("bare, %", "bare", 1, "1", 1),
    Measure("F, ceiling", "f_ceiling", lambda r: r.f_ceiling, None, "", 2),
    Measure("bare, ceiling, %", "bare_ceiling", lambda r: 100 * r.bare_ceiling, None, "", 1),
    _percent("iso-value, %", "iso_error", 25, "within 25", 0),
)


def measures_of(results):
    """Those that a style's results have."""
    return [measure for measure in MEASURES if any(getattr(result, measure.field) != "" for result in results)]


def _rows_of_table(*rows):
    return "".join(f"| {' | '.join(map(str, row))} |\n" for row in (rows[0], ["---"] * len(rows[0]), *rows[1:]))


def _values(results, measure):
    return [measure.value(result) for result in results if getattr(result, measure.field) != ""]


def _means(sets, measure, keep):
    """The mean over the results to keep, of each set of results."""
    cells = []
    for results in sets:
        values = _values(filter(keep, results), measure)
        cells.append(f"{np.mean(values):.{measure.digits}f}" if values else "–")
    return " → ".join(cells)


def _summary(sets, measures):
    """For each measure: its target, the share of pictures that reach it, median and worst, of each set of results."""
    rows = [["", "target", "pictures that reach it, %", "median", "worst"]]
    for measure in filter(lambda one: one.target, measures):
        shares, medians, worst = [], [], []
        for results in sets:
            kept = [result for result in results if _values([result], measure)]
            values = _values(kept, measure)
            if values:
                shares.append(f"{100 * np.mean([measure.is_reached(result) for result in kept]):.0f}")
                medians.append(f"{np.median(values):.{measure.digits}f}")
                worst.append(f"{min(values) if measure is F else max(values, key=abs):.{measure.digits}f}")
        rows.append([measure.title, measure.target, *(" → ".join(column) for column in (shares, medians, worst))])
    return _rows_of_table(*rows)


def _details(sets, measures):
    """A row for each surface and grid: F for each noise; all else for noise up to 5 %."""
    has_f = F in measures
    others = [measure for measure in measures if measure is not F]
    header = ["surface", "voxels", "slices"] + [f"F, noise {100 * noise:.0f} %" for noise in NOISES] * has_f
    rows = [header + [measure.title for measure in others]]
    for grid in dict.fromkeys(result[:3] for results in sets for result in results):
        row = [grid[0], grid[1], f"1:1:{grid[2]}"]
        for noise in NOISES if has_f else ():
            row.append(_means(sets, F, lambda r, noise=noise: r[:3] == grid and r.noise == noise))
        for measure in others:
            # Ceilings are those of values without noise.
            most = 0.05 if measure.target else 1.0
            row.append(_means(sets, measure, lambda r, most=most: r[:3] == grid and r.noise <= most))
        rows.append(row)
    return _rows_of_table(*rows)


def page(today, before=()):
    """Markdown of results; and, of those cases that were measured before, too, what became of the figures."""
    text = INTRODUCTION
    for style in dict.fromkeys(result.style for result in today):
        now = [result for result in today if result.style == style]
        measures = measures_of(now)
        text += f"\n## {style}\n\n{_summary([now], measures)}\nMeans over both types"
        text += " (but for F over noise of 0, 2 and 5 %, too):\n\n" + _details([now], measures)
        then = [result for result in before if result.style == style]
        both = {result[:6] for result in then} & {result[:6] for result in now}
        if both:
            sets = [[result for result in results if result[:6] in both] for results in (then, now)]
            text += f"\n{len(both)} of these pictures before smoothing, finer sampling and surface stipples, and today:\n\n"
            text += _summary(sets, measures)
    return text + _pictures()


def _pictures():
    """Those that Utilities/pictures.sh quality has drawn."""
    found = sorted((PAGE.parent / "images").glob("*-quality-*.png"))
    if not found:
        return ""
    text = "\n## Pictures\n\nOf phantoms: the mesh, the volume without and with what is chosen automatically; of scans: the "
    text += "last two."
    for path in found:
        style, _, subject = path.stem.partition("-quality-")
        text += f"\n\n![{subject.replace('-', ' ').capitalize()}, {style}](images/{path.name})"
    return text + "\n"


def cases_table(results):
    """Markdown with a row for each case: what `--quick` prints."""
    text = ""
    for style in dict.fromkeys(result.style for result in results):
        kept = [result for result in results if result.style == style]
        measures = measures_of(kept)
        shares = [
            Measure("precision", "precision", lambda r: r.precision, None, "", 2),
            Measure("recall", "recall", lambda r: r.recall, None, "", 2),
        ]
        shown = (shares if F in measures else []) + measures
        rows = [["case", *(measure.title for measure in shown)], ["target", *(measure.target for measure in shown)]]
        for result in kept:
            cells = [_values([result], measure) for measure in shown]
            rows.append(
                [Case(*result[:5])] + [f"{cell[0]:.{m.digits}f}" if cell else "–" for cell, m in zip(cells, shown)]
            )
        text += f"{style}\n\n{_rows_of_table(*rows)}\n"
    return text


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true", help="some cases, in minutes")
    parser.add_argument("--cases", metavar="REGEX", default="", help="those whose name it finds, as '^knot 96 .*uint8'")
    parser.add_argument("--styles", default="", help="with commas; all by default")
    parser.add_argument("--meshes", metavar="FOLDER", help="with bunny.ply and horse.ply")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--pictures", metavar="FOLDER", help="to write pairs of pictures to: the mesh's and the volume's")
    parser.add_argument("--output", metavar="CSV", help="to write all figures to")
    parser.add_argument(
        "--page",
        metavar="CSV",
        nargs="+",
        help="write Documentation/picture-quality.md of such a file, and of one from before",
    )
    arguments = parser.parse_args()
    if arguments.page:
        PAGE.write_text(page(*map(read_csv, arguments.page)), encoding="utf-8")
        return
    surfaces = phantoms.with_scans(arguments.meshes)
    cases = [case for case in QUICK if case.surface in surfaces] if arguments.quick else all_cases(surfaces)
    cases = [case for case in cases if re.search(arguments.cases, str(case))]
    wanted = arguments.styles.split(",") if arguments.styles else STYLES
    styles = tuple(style for style in wanted if style in vtkink.styles())
    if not cases or not styles:
        parser.error("no case or no style of that name")
    if arguments.pictures:
        os.makedirs(arguments.pictures, exist_ok=True)
    results = run(cases, styles, arguments.meshes, arguments.pictures, arguments.jobs)
    if arguments.output:
        write_csv(results, arguments.output)
    print(cases_table(results))


if __name__ == "__main__":
    main()
