# SPDX-License-Identifier: BSD-3-Clause
"""What is said of two pictures is true of pictures that are known."""

import numpy as np
import pytest

import picture_metrics as metrics

SIZE = 256

pytestmark = pytest.mark.one_build


def lines(*rows, darkness=1.0):
    picture = np.zeros((SIZE, SIZE))
    picture[list(rows), 20:236] = darkness
    return picture


@pytest.mark.parametrize("picture, precision, recall", [
    (lines(50, 150), 1, 1),
    (lines(52, 148), 1, 1),
    (lines(53, 147), 0, 0),
    (lines(50), 1, 0.5),
    (lines(50, 150, 100, 200), 0.5, 1),
    (lines(50, 150) + lines(100, darkness=0.5), 0.8, 1),
    (lines(50, 150) + lines(100, darkness=0.2), 1, 1),
    (lines(), 0, 0),
])  # fmt: skip
def test_lines(picture, precision, recall):
    found = metrics.compare_lines(picture, lines(50, 150))
    assert found[:2] == pytest.approx((precision, recall), abs=0.01)
    assert found.f == pytest.approx(2 * precision * recall / max(precision + recall, 1e-9), abs=0.01)


def dots(points, radius=1):
    picture = np.zeros((SIZE, SIZE))
    for x, y in np.rint(points).astype(int):
        picture[max(y - radius, 0) : y + radius + 1, max(x - radius, 0) : x + radius + 1] = 1
    return picture


def hexagons(distance):
    x, y = np.meshgrid(np.arange(0.0, SIZE, distance), np.arange(0, SIZE, distance * np.sqrt(3) / 2))
    x[1::2] += distance / 2
    return np.stack([x.ravel(), y.ravel()], axis=1)


def test_evenness_of_a_lattice_and_of_chance():
    assert metrics.measure_evenness(hexagons(8), SIZE * SIZE) == pytest.approx(1, abs=0.03)
    chance = np.random.default_rng(5).uniform(0, SIZE, (3000, 2))
    assert metrics.measure_evenness(chance, SIZE * SIZE) == pytest.approx(0.465, abs=0.02)
    assert metrics.measure_evenness(chance[:1], SIZE * SIZE) == metrics.measure_evenness(chance[:0], SIZE * SIZE) == 0


def test_nearest_distances_of_more_points_than_are_done_at_once():
    points = np.stack([np.arange(2500.0) ** 1.5, np.zeros(2500)], axis=1)
    gaps = np.diff(points[:, 0])
    assert metrics.nearest_distances(points) == pytest.approx(np.minimum([gaps[0], *gaps], [*gaps, gaps[-1]]), rel=1e-5)


def test_dots_are_found_also_where_they_touch():
    points = np.array([[5, 5], [20, 5], [23, 8], [30, 90], [200, 250]])
    for darkness in (1, 0.4):
        found = metrics.find_dots(darkness * dots(points))
        assert len(found) == len(points)
        assert all(abs(found - point).max(axis=1).min() <= 1 for point in points)
    assert len(metrics.find_dots(np.zeros((SIZE, SIZE)))) == 0
    assert len(metrics.find_dots(0.05 * dots(points))) == 0
    large = metrics.find_dots(dots(points[:1] + 100, radius=4))
    assert len(large) == 1 and abs(large - 105).max() <= 4


def test_stipples():
    silhouette = np.zeros((SIZE, SIZE), bool)
    silhouette[30:226, 30:226] = True
    reference = dots(hexagons(7)) * silhouette
    same = metrics.compare_stipples(reference, reference, silhouette)
    assert (same.tone, same.outside, same.bare) == (0, 0, 0) and same.evenness == same.reference_evenness > 0.8
    without = reference.copy()
    without[:, 128:] = 0
    half = metrics.compare_stipples(without, reference, silhouette)
    assert half.bare == pytest.approx(0.5, abs=0.07) and half.tone > 0.05 and half.outside == 0
    pale = metrics.compare_stipples(0.8 * reference, reference, silhouette)
    assert pale.tone == pytest.approx(0.2 * metrics.blur(reference)[silhouette].mean(), rel=0.1) and pale.bare == 0
    beyond = reference.copy()
    beyond[5:15, 5:15] = 1
    assert metrics.compare_stipples(beyond, reference, silhouette).outside == pytest.approx(100 / beyond.sum())
    nothing = metrics.compare_stipples(np.zeros_like(reference), reference, silhouette)
    assert nothing.bare > 0.95 and nothing.outside == 0 and nothing.evenness == 0


def test_a_blur_keeps_ink_and_has_its_width():
    picture = np.zeros((SIZE, SIZE))
    picture[128, 128] = 1
    blurred = metrics.blur(picture)
    assert blurred.sum() == pytest.approx(1, abs=1e-3)
    assert blurred.max() == pytest.approx(1 / (2 * np.pi * metrics.BLUR**2), rel=1e-3)
