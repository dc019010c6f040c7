# SPDX-License-Identifier: BSD-3-Clause
"""A large picture is its preview in finer pixels: sizes are parts of the picture's height."""

import functools

import numpy as np
import pytest

pytestmark = pytest.mark.one_build

SMALL, FACTOR = 300, 4


@pytest.fixture
def preview_and_print(picture):
    """Ink, 0 to 1, of a small picture, and of a large one, which is also made smaller to its size."""

    # Prints of previews of two sizes are the same.
    drawn = functools.cache(picture)

    def render(file, *arguments, side=SMALL):
        factor = SMALL * FACTOR // side
        small, large = (1 - drawn(file, *arguments, size=f"{size}")[..., :3].mean(axis=2) / 255
                        for size in (side, side * factor))  # fmt: skip
        return small, large.reshape(side, factor, side, factor).mean(axis=(1, 3)), large

    return render


def spots(dark):
    """The middles of what is connected, over corners, too."""
    found, left = [], {tuple(place) for place in np.argwhere(dark)}
    while left:
        spot, border = [], [left.pop()]
        while border:
            y, x = border.pop()
            spot.append((y, x))
            for near in [(y + i, x + j) for i in (-1, 0, 1) for j in (-1, 0, 1)]:
                if near in left:
                    left.remove(near)
                    border.append(near)
        found.append(np.mean(spot, axis=0))
    return np.array(found)


# Few and large dots, one beside the other.
APART = ["--stipple-size", 12, "--pixels-per-stipple", 245, "--parts", "intensity", "--fade", 0, "--lighting", "off"]


def test_dots_stay_where_they_are(preview_and_print, mesh_file):
    small, smaller, large = preview_and_print(mesh_file, "--style", "stipple", *APART)
    middles = spots(large > 0.5)
    # Not what lies between dots that touch around it.
    middles = middles[large[tuple(middles.astype(int).T)] > 0.5]
    assert len(middles) > 300
    rows, columns = (middles / FACTOR).astype(int).T
    # In the gaps in the middle of touching dots, and in small dots, there is less ink; 0.93 of it at least, as measured.
    assert (small[rows, columns] > 0.9 * smaller[rows, columns]).all(), "each dot of the print is one of the preview"
    assert (small[rows, columns] > 0.2).mean() > 0.98
    # But for a dot on the horizon, which the finer surface hides: 0.04 % as measured.
    assert small[smaller == 0].sum() < 0.002 * small.sum(), "and all of its ink is theirs"


@pytest.mark.parametrize("preset", ["anatomy", "soft-tissue", "engineering"])
def test_stipples_cover_as_much(preview_and_print, volume_file, mesh_file, preset):
    style = ["--preset", preset, "--style", "stipple"]
    small, smaller, _ = preview_and_print(volume_file, *style)
    # Dots that are smaller than pixels are paler: by 6 % for anatomy.
    assert small.mean() == pytest.approx(smaller.mean(), rel=0.08)
    for file, side in ((volume_file, 2 * SMALL), (mesh_file, SMALL)):
        small, smaller, _ = preview_and_print(file, *style, side=side)
        assert small.mean() == pytest.approx(smaller.mean(), rel=0.05)
        blocks = lambda ink: ink.reshape(side // 10, 10, side // 10, 10).mean(axis=(1, 3))
        assert np.abs(blocks(small) - blocks(smaller)).max() < 0.06
        # Not only the gray: the same dots.
        assert np.abs(small - smaller).mean() < 0.25 * small.mean()


def test_pixels_are_a_choice(preview_and_print, mesh_file):
    small, smaller, large = preview_and_print(mesh_file, "--style", "stipple", "--size-unit", "pixels", *APART)
    # As many pixels a dot make sixteen times as many dots.
    assert len(spots(large > 0.5)) > 4 * len(spots(small > 0.5))
    assert np.abs(small - smaller).mean() > 0.5 * small.mean()


@pytest.mark.parametrize("file", ["volume", "mesh"])
def test_print_sizes_are_full_ink(picture, volume_file, mesh_file, file):
    """Tone is the size of dots: hardly any ink is in dots that have no black core."""
    file = {"volume": volume_file, "mesh": mesh_file}[file]
    ink = 1 - picture(file, "--style", "stipple", size="2400")[..., :3].mean(axis=2) / 255
    full = np.pad(ink > 0.98, 2)
    # The rim of a dot, antialiased, is up to two pixels wide.
    near = np.any([np.roll(full, (i, j), (0, 1)) for i in range(-2, 3) for j in range(-2, 3)], axis=0)[2:-2, 2:-2]
    assert ink[near].sum() > 0.9 * ink.sum()


def test_thinned_lines_are_black_and_as_wide_in_any_size(preview_and_print, picture, volume_file):
    thin = ["--style", "splatting-lines", "--thin", "--hardness", 1, "--iso", 100]
    ink = 1 - picture(volume_file, *thin, size="1000")[..., 0] / 255
    # A pixel wide, wherever it begins: half of one that was rendered would have 0.5 at most.
    assert ink.max() > 0.7
    large = 1 - picture(volume_file, *thin, size="2000")[..., 0] / 255
    assert large.mean() == pytest.approx(ink.mean(), rel=0.25)


@pytest.mark.parametrize("side", [150, 200])
def test_lines_of_previews_are_as_broad(preview_and_print, volume_file, side):
    small, smaller, _ = preview_and_print(volume_file, "--style", "splatting-lines", "--iso", 100, side=side)
    # 3.5 % at the most.
    assert small.mean() == pytest.approx(smaller.mean(), rel=0.05)
