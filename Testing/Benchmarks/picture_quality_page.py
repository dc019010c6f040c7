# SPDX-License-Identifier: BSD-3-Clause
"""Documentation/picture-quality.md, of the figures that picture_quality.py measured and that lie beside this file."""

import pathlib
from typing import NamedTuple

import numpy as np
from picture_quality_results import NOISES, Case, read_csv

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE = ROOT / "Documentation" / "picture-quality.md"
OTHERS = {
    "before smoothing, finer sampling and surface stipples": "picture-quality-before.csv",
    "with `--smoothing 0`": "picture-quality-unsmoothed.csv",
    "with `--subdivision 1`": "picture-quality-undivided.csv",
}
INTRODUCTION = """<!-- SPDX-License-Identifier: BSD-3-Clause -->
# Picture quality

How near pictures of volumes, drawn with nothing but `--style`, come to pictures of the surface that the volume shows.
Known surfaces become volumes as a scanner would see them: blurred by a point spread of 0.7 voxel, with Gaussian noise of
0 to 10 % of the step at the boundary, as uint8 (a step of 160) and int16 (2000), in cubes of 48, 96 and 192 voxels a side
and with slices as far apart as one voxel or three. Each picture has 1024 x 1024 pixels and is compared with the one that
the same style draws of the surface's mesh with the same camera. This page is written by

    . Utilities/env.sh headless
    $INK_PYTHON Testing/Benchmarks/picture_quality.py --quarter --meshes FOLDER --output Testing/Benchmarks/picture-quality.csv
    $INK_PYTHON Testing/Benchmarks/picture_quality.py --page

`--quarter` measures a fourth of all cases, in which each type and each noise is as frequent; `--quick` some, in minutes.
FOLDER holds the Stanford bunny and the Georgia Tech horse as bunny.ply and horse.ply; without it these two are left out.
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
too. Two pixels are 0.1 voxels of 48, 0.2 of 96 and 0.4 of 192: what the bunny and the horse lack are lines of details that are
finer than voxels; contours of the two materials are displaced, as their outer boundary is half a step, so that the denser ball is half
a voxel larger at the one iso-value that both share, and noise is twice as large a share of it; shells of two voxels in slices
of three are neither whole nor smooth. So the ceilings beside the figures are often worse than the targets, and with noise nothing
reaches them but by smoothing: volumes, which are smoothed and subdivided, are often better than that mesh. A second row of a
measure counts the pictures that reach the target or their ceiling. Smoothing makes lines better nearly everywhere, but tone a little
worse, as normals that are smoothed over bends are lit more evenly; shells in slices of three lose by both measures, vessels by tone.
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


def _ceiling(name):
    field = f"{name}_ceiling"
    return Measure(f"{name}, ceiling, %", field, lambda result: 100 * getattr(result, field), None, "", 1)


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
    _ceiling("tone"),
    _ceiling("outside"),
    _ceiling("bare"),
    _percent("iso-value, %", "iso_error", 25, "within 25", 0),
)


def _against_ceiling(measure, target, tolerance):
    """A measure's difference to its ceiling; reached where the measure's own target is, too."""
    field = f"{measure.field}_ceiling"
    worse = -1 if measure is F else 1
    difference = lambda r: measure.value(r) - (1 if measure is F else 100) * getattr(r, field)
    is_reached = lambda r: measure.is_reached(r) or worse * difference(r) <= tolerance
    return Measure(f"{measure.title}, less its ceiling", field, difference, is_reached, target, measure.digits)


AGAINST_CEILINGS = {F: _against_ceiling(F, "as above, or at least -0.05", 0.05)}
for _measure in MEASURES:
    if _measure.field in ("tone", "outside", "bare"):
        AGAINST_CEILINGS[_measure] = _against_ceiling(_measure, "as above, or at most 1", 1)


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


def _worst(measure, values):
    if measure in (F, AGAINST_CEILINGS[F]):
        return min(values)
    return max(values) if measure in AGAINST_CEILINGS.values() else max(values, key=abs)


def _summary(sets, measures):
    """For each measure: its target, the share of pictures that reach it, median and worst, of each set of results."""
    rows = [["", "target", "pictures that reach it, %", "median", "worst"]]
    targets = [measure for measure in measures if measure.target]
    for measure in (row for one in targets for row in (one, AGAINST_CEILINGS.get(one)) if row):
        shares, medians, worst = [], [], []
        for results in sets:
            kept = [result for result in results if _values([result], measure)]
            values = _values(kept, measure)
            if values:
                shares.append(f"{100 * np.mean([measure.is_reached(result) for result in kept]):.0f}")
                medians.append(f"{np.median(values):.{measure.digits}f}")
                worst.append(f"{_worst(measure, values):.{measure.digits}f}")
        if shares:
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


def page(today, others=None):
    """Markdown of results; and what figures were of those cases that were measured otherwise, too, by how."""
    text = INTRODUCTION
    for style in dict.fromkeys(result.style for result in today):
        now = [result for result in today if result.style == style]
        measures = measures_of(now)
        text += f"\n## {style}\n\n{_summary([now], measures)}\nMeans over both types"
        text += " (but for F over noise of 0, 2 and 5 %, too):\n\n" + _details([now], measures)
        for how, results in (others or {}).items():
            then = [result for result in results if result.style == style]
            both = {result[:6] for result in then} & {result[:6] for result in now}
            if both:
                sets = [[result for result in results if result[:6] in both] for results in (then, now)]
                text += f"\n{len(both)} of these pictures {how}, and today:\n\n{_summary(sets, measures)}"
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


def write():
    figures = pathlib.Path(__file__).with_name
    others = {how: read_csv(figures(name)) for how, name in OTHERS.items() if figures(name).exists()}
    PAGE.write_text(page(read_csv(figures("picture-quality.csv")), others), encoding="utf-8")
