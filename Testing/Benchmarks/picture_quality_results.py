# SPDX-License-Identifier: BSD-3-Clause
"""What picture_quality.py measures, and the files that it writes figures to."""

import csv
from typing import NamedTuple

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
    tone_ceiling: float | str = ""
    outside_ceiling: float | str = ""


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
