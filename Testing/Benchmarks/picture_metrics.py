# SPDX-License-Identifier: BSD-3-Clause
"""How alike two pen-and-ink pictures are: arrays of darkness, 0 for paper to 1 for ink, of one size.

The pictures are of 1024 x 1024 pixels; distances are in pixels.
"""

from typing import NamedTuple

import numpy as np

MATCH_DISTANCE = 2
BLUR = 12
#: Ink that is paler than this is no line.
PALEST_INK = 0.25
#: After a blur of DOT_BLUR; a black pixel has twice as much.
PALEST_DOT = 0.15
DOT_BLUR = 0.7


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
    """The centers (x, y) of dots, (n, 2): peaks of darkness after a slight blur, so that dots that touch are several."""
    # Rounded, as the middle of a large dot is all one.
    blurred = np.round(blur(picture, DOT_BLUR), 6)
    padded = np.pad(blurred, 1)
    height, width = picture.shape
    peaks = blurred >= PALEST_DOT
    for y, x in ((0, 0), (0, 1), (0, 2), (1, 0), (1, 2), (2, 0), (2, 1), (2, 2)):
        neighbor = padded[y : y + height, x : x + width]
        # Of equal pixels the last one is the peak.
        peaks &= blurred >= neighbor if (y, x) < (1, 1) else blurred > neighbor
    return np.argwhere(peaks)[:, ::-1].astype(float)


def nearest_distances(points):
    """Of each point (n, 2), from two on, the distance to the nearest other one."""
    low, extent = points.min(axis=0), np.ptp(points, axis=0)
    # About two points in a square.
    side = max(np.sqrt(2 * extent.prod() / len(points)), extent.max() / len(points), 1e-9)
    squares = np.floor((points - low) / side).astype(np.int64) + 1
    columns = squares[:, 0].max() + 2
    index = squares[:, 1] * columns + squares[:, 0]
    order = np.argsort(index, kind="stable")
    points, index = points[order], index[order]
    starts = np.searchsorted(index, np.arange(columns * (squares[:, 1].max() + 2) + 1))
    nearest = np.full(len(points), np.inf)
    for neighbor in (dy * columns + dx for dy in (-1, 0, 1) for dx in (-1, 0, 1)):
        first, end = starts[index + neighbor], starts[index + neighbor + 1]
        for rank in range((end - first).max()):
            near = np.flatnonzero((first + rank < end) & (first + rank != np.arange(len(points))))
            offsets = points[first[near] + rank] - points[near]
            nearest[near] = np.minimum(nearest[near], np.hypot(*offsets.T))
    # What is farther than a square may lie beyond the squares around.
    for alone in np.flatnonzero(nearest > side):
        distances = np.hypot(*(points - points[alone]).T)
        distances[alone] = np.inf
        nearest[alone] = distances.min()
    found = np.empty(len(points))
    found[order] = nearest
    return found


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
    evenness, reference_evenness = (
        measure_evenness(find_dots(np.where(silhouette, ink, 0)), area) for ink in (picture, reference)
    )
    bare = (tone < reference_tone / 4) & (reference_tone > 0.04)
    return Stipples(
        tone=float(np.sqrt(np.mean((tone - reference_tone)[silhouette] ** 2))),
        evenness=evenness,
        reference_evenness=reference_evenness,
        outside=_share(picture, ~dilate(silhouette, MATCH_DISTANCE)),
        bare=float(bare[silhouette].sum() / area),
    )
