# SPDX-License-Identifier: BSD-3-Clause
"""Lines on a mesh that deforms: samples that move with it come and go less than samples that are made anew."""

import numpy as np
import pytest

pytestmark = pytest.mark.one_build

pytest.importorskip("vtkink")
import lines_coherence as coherence  # noqa: E402


@pytest.mark.parametrize("blue, share", [(True, 0.4), (False, 0.95)])
def test_moved_samples_shimmer_less(blue, share):
    """White noise that is made anew falls on nearly the same places of the faces, as each sample's numbers are hashed."""
    shimmer = {}
    for follow in (True, False):
        scene = coherence.Scene(follow, blue, 12000, 400)
        shimmer[follow] = coherence.measure(scene, 4, 1 / 240)[0]
        assert scene.sampler.GetNumberOfSamplings() == (1 if follow else 5)
    assert shimmer[True] < share * shimmer[False], shimmer


def test_samples_move_as_the_surface_does():
    scene = coherence.Scene(True, True, 5000, 100)
    times = (0.0, 0.01, 0.02, 0.5)
    drawn = [scene.at(time) for time in times]
    assert scene.sampler.GetNumberOfSamplings() == 1
    # No sample moves faster than the mesh's points do, and twice as far in twice the time.
    pixels = 100 / 4.6
    for i, j in ((0, 1), (1, 2)):
        mesh = (coherence.tube(times[j]) - coherence.tube(times[i]))[:, [0, 2]] * pixels
        moved = np.abs(drawn[j][1] - drawn[i][1])
        assert moved.max() <= np.abs(mesh).max() * 1.001
    first, second = drawn[1][1] - drawn[0][1], drawn[2][1] - drawn[1][1]
    assert np.abs(second - first).max() < 0.1 * np.abs(first).max()
    assert all(ink.sum() > 0 for ink, _ in drawn)


def test_a_mesh_at_rest_does_not_change():
    scene = coherence.Scene(True, True, 5000, 100)
    (first, _), (second, _) = scene.at(0.25), scene.at(0.25)
    assert (first == second).all()
