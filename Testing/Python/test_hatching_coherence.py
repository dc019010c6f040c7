# SPDX-License-Identifier: BSD-3-Clause
"""What the coherence of hatching is measured with tells what comes, goes and pops; and hatching does little of that."""

import numpy as np
import pytest

pytestmark = pytest.mark.one_build

vtkink = pytest.importorskip("vtkink")
vtk = vtkink.vtk
import hatching_coherence as coherence  # noqa: E402


@pytest.fixture(scope="module")
def scene():
    ball = vtk.vtkSphereSource()
    ball.SetThetaResolution(60)
    ball.SetPhiResolution(60)
    ball.Update()
    return coherence.Scene(ball.GetOutput(), "engraving", 200)


def test_parts_that_come_go_and_pop_count_by_their_length():
    before, after = np.array([0.0, 1.0, 2.0, 0.0]), np.array([0.2, 0.0, 2.1, 0.0])
    found = coherence.compare(before, after, np.array([1.0, 2.0, 5.0, 9.0]))
    assert found == pytest.approx((3 / 8, 2 / 8, 1.0, (0.2 + 2.0 + 0.5) / (0.2 + 10.5)))


def test_ink_that_moves_by_a_pixel_does_not_shimmer():
    ink = np.zeros((20, 20))
    ink[5:15, 8] = 1
    assert coherence.unmatched(ink, np.roll(ink, 1, 1)) == 0
    assert coherence.unmatched(ink, np.roll(ink, 2, 1)) == 1
    assert coherence.unmatched(ink, 0 * ink) == 1


def test_nothing_changes_without_motion(scene):
    before = scene.widths()
    assert (scene.widths() == before).all()
    assert before.max() > 0.5
    assert (scene.frozen_picture(before) == scene.frozen_picture(before)).all()


def test_widths_change_smoothly(scene):
    """Where the surface faces the viewer before and after a tenth of a degree."""
    before, seen = scene.widths(), scene.seen(scene.pixels())
    for _ in range(10):
        scene.turn(0.1)
        after, seen_after = scene.widths(), scene.seen(scene.pixels())
        assert np.abs(after - before)[seen & seen_after].max() < 0.5 * coherence.WIDE
        before, seen = after, seen_after
