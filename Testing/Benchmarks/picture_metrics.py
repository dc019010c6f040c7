# SPDX-License-Identifier: BSD-3-Clause
"""How alike two pen-and-ink pictures are: arrays of darkness, 0 for paper to 1 for ink, of one size.

The pictures are of 1024 x 1024 pixels; distances are in pixels.
"""

from typing import NamedTuple

import numpy as np

MATCH_DISTANCE = 2
BLUR = 12
#: Ink that is paler than this is no line, and no dot.
PALEST_INK = 0.25
#: In pixels; what is larger are lines, or dots that run together.
LARGEST_DOT = 60


class Lines(NamedTuple):
    precision: float  #: the share of ink that has ink of the reference near it
    recall: float  #: the share of the reference's ink that has ink near it
    f: float


class Stipples(NamedTuple):
    tone: float  #: root mean square difference of blurred darkness within the silhouette
    evenness: float
    reference_evenness: float
    outside: float  #: the share of ink that lies outside of the silhouette
    bare: float  #: the share of the silhouette that is bare where the reference is not


def dilate(mask, radius):
    """All pixels within a distance of the mask."""
    reach = range(-radius, radius + 1)
    padded = np.pad(mask, radius)
    height, width = mask.shape
    near = [(y + radius, x + radius) for y in reach for x in reach if x * x + y * y <= radius * radius]
    return np.any([padded[y : y + height, x : x + width] for y, x in near], axis=0)


def _share(ink, mask):
    total = ink.sum()
    return float(ink[mask].sum() / total) if total > 0 else 0.0


def compare_lines(picture, reference):
    """Ink counts by its darkness, and matches where the other picture has ink within MATCH_DISTANCE."""
    precision, recall = (
        _share(np.where(ink >= PALEST_INK, ink, 0), dilate(other >= PALEST_INK, MATCH_DISTANCE))
        for ink, other in ((picture, reference), (reference, picture))
    )
    return Lines(precision, recall, 2 * precision * recall / max(precision + recall, 1e-12))


def blur(picture, sigma=BLUR):
    """By a Gaussian; there is paper around the picture."""

    def kernel(n):
        d = np.arange(n)[:, None] - np.arange(n)
        return np.exp(-0.5 * (d / sigma) ** 2) / (sigma * np.sqrt(2 * np.pi))

    return kernel(picture.shape[0]) @ picture @ kernel(picture.shape[1])


def find_dots(picture):
    """The centers of all spots of ink (x, y) that are no larger than LARGEST_DOT, (n, 2)."""
    mask = np.pad(picture >= PALEST_INK, 1)
    height, width = mask.shape
    labels = np.where(mask, np.arange(mask.size, dtype=np.int32).reshape(mask.shape), -1)
    shifts = [(slice(y, y + height - 2), slice(x, x + width - 2)) for y in (0, 1, 2) for x in (0, 1, 2)]
    inner = (slice(1, -1), slice(1, -1))

    def spread():
        largest = labels.copy()
        for shift in shifts:
            np.maximum(largest[inner], labels[shift], out=largest[inner])
        return np.where(mask, largest, -1)

    # A label goes one pixel a step. Spots that are wider are left with several, next to each other.
    for _ in range(16):
        labels = spread()
    wide = spread()
    wide = np.unique([labels[wide != labels], wide[wide != labels]])
    y, x = np.nonzero(mask)
    kept, spots, sizes = np.unique(labels[mask], return_inverse=True, return_counts=True)
    centers = np.stack([np.bincount(spots, x), np.bincount(spots, y)], axis=1) / sizes[:, None] - 1
    return centers[(sizes <= LARGEST_DOT) & ~np.isin(kept, wide)]


def nearest_distances(points):
    """Of each point the distance to the nearest other one."""
    squares = (points**2).sum(axis=1)
    found = []
    for first in range(0, len(points), 1000):
        some = points[first : first + 1000]
        distances = squares[first : first + 1000, None] + squares - 2 * some @ points.T
        distances[np.arange(len(some)), first + np.arange(len(some))] = np.inf
        found.append(np.sqrt(np.maximum(distances.min(axis=1), 0)))
    return np.concatenate(found)


def measure_evenness(dots, area):
    """The mean distance to the nearest dot, in that of a hexagonal lattice of as many dots on the area: 1 is a lattice, and
    dots that know nothing of each other have 0.47. 0 of fewer than two dots."""
    if len(dots) < 2:
        return 0.0
    return float(nearest_distances(dots).mean() / np.sqrt(2 / np.sqrt(3) * area / len(dots)))


def compare_stipples(picture, reference, silhouette):
    """:param silhouette: where the surface truly is, an array of bool"""
    tone, reference_tone = blur(picture), blur(reference)
    area = silhouette.sum()
    evenness, reference_evenness = (measure_evenness(find_dots(ink), area) for ink in (picture, reference))
    bare = (tone < reference_tone / 4) & (reference_tone > 0.04)
    return Stipples(
        tone=float(np.sqrt(np.mean((tone - reference_tone)[silhouette] ** 2))),
        evenness=evenness,
        reference_evenness=reference_evenness,
        outside=_share(picture, ~dilate(silhouette, MATCH_DISTANCE)),
        bare=float(bare[silhouette].sum() / area),
    )
