# SPDX-License-Identifier: BSD-3-Clause
"""What `ink render` draws, and what it says while it does."""

import os
import pty
import re
import subprocess

import numpy as np
import pytest

import ink_files
from conftest import TIME_LIMIT

# What only this style has: illustration, the default, has stipples beside its lines.
LINES = ["--style", "splatting-lines"]


def ink_bounds(image):
    """First and last row and column with a dark pixel."""
    dark = (image[..., :3] < 160).any(axis=2)
    rows, columns = np.flatnonzero(dark.any(axis=1)), np.flatnonzero(dark.any(axis=0))
    return rows[0], rows[-1], columns[0], columns[-1]


def test_the_chosen_iso_value_is_named_and_sensible(ink, volume_file, tmp_path):
    result = ink("render", volume_file, "--size", "64x64", "-o", tmp_path / "out.png")
    assert (result.code, result.out) == (0, "")
    value = float(re.match(r"ink: iso-value (\S+): ", result.err).group(1))
    assert 60 < value < 140


def test_a_given_iso_value_needs_no_words(ink, volume_file, tmp_path):
    result = ink("render", volume_file, "--iso", 100, "--size", "64x64", "-o", tmp_path / "out.png")
    assert (result.code, result.out, "iso-value" in result.err) == (0, "", False)


def test_timings_are_of_all_steps_in_their_order(ink, volume_file, tmp_path):
    arguments = ["render", volume_file, "--iso", 100, "--size", "64x64", "-o", tmp_path / "out.png"]
    line = next(line for line in ink(*arguments, "--timings").err.splitlines() if "drawing" in line)
    steps = re.findall(r"(\w+) (\d+\.\d\d) s \((\d+) %\)", line)
    assert [name for name, _, _ in steps] == ["reading", "generating", "uploading", "drawing"]
    assert all(float(seconds) < TIME_LIMIT for _, seconds, _ in steps) and float(steps[-1][1]) > 0
    assert 98 <= sum(int(share) for _, _, share in steps) <= 102
    assert "drawing" not in ink(*arguments).err and ink(*arguments, "--timings", "-q").err == ""


def test_same_input_same_bytes(ink, volume_file, tmp_path):
    for name, threads in (("a.png", "1"), ("b.png", "2")):
        result = ink("render", volume_file, "--size", "200x150", "-q", "-o", tmp_path / name, env={"VTK_SMP_MAX_THREADS": threads})
        assert result.code == 0
    assert (tmp_path / "a.png").read_bytes() == (tmp_path / "b.png").read_bytes()


@pytest.mark.parametrize("size", ["1x1", "16x9", "320x200", "200x320", "2000x100"])
def test_size(picture, volume_file, size):
    width, height = map(int, size.split("x"))
    assert picture(volume_file, *LINES, size=size).shape == (height, width, 3)


@pytest.mark.parametrize("size", ["300x200", "200x300"])
@pytest.mark.parametrize("projection", [[], ["--parallel"]])
@pytest.mark.one_build
def test_the_subject_fits_with_a_margin(picture, volume_file, size, projection):
    image = picture(volume_file, "--iso", 100, *projection, size=size)
    height, width = image.shape[:2]
    top, bottom, left, right = ink_bounds(image)
    margins = np.array([top / height, 1 - (bottom + 1) / height, left / width, 1 - (right + 1) / width])
    assert (margins > 0.005).all(), margins
    # The blob is about as wide as it is high: the shorter side of the picture is the tight one.
    tight = margins[:2] if height < width else margins[2:]
    assert (tight < 0.06).all(), margins


@pytest.mark.one_build
def test_large_pictures_show_the_same(picture, volume_file):
    options = [*LINES, "--iso", 100]
    small = picture(volume_file, *options).mean(axis=2)
    large = picture(volume_file, *options, size="1000x1000").mean(axis=2).reshape(200, 5, 200, 5).mean(axis=(1, 3))
    assert np.abs(small - large).mean() < 4


@pytest.mark.one_build
def test_views_are_the_sides_of_the_subject(picture, volume_file):
    """The blob has its bumps to its left (+x, large), back (+y, medium) and top (+z, small)."""
    views = {name: picture(volume_file, "--iso", 100, "--view", name, "--parallel", "--stipples", 20000) for name in
             ("front", "back", "left", "right", "top", "bottom")}
    rows = lambda image: np.flatnonzero((image < 200).any(axis=(1, 2)))
    columns = lambda image: np.flatnonzero((image < 200).any(axis=(0, 2)))

    def narrow(image, side):
        """How much of the picture the drawing spans close to one of its ends: a bump is narrow."""
        lines = {"top": rows(image)[:12], "bottom": rows(image)[-12:], "left": columns(image)[:12], "right": columns(image)[-12:]}[side]
        part = image[lines] if side in ("top", "bottom") else image[:, lines].transpose(1, 0, 2)
        found = np.flatnonzero((part < 200).any(axis=(0, 2)))
        return found[-1] - found[0]

    for name in ("front", "back", "left", "right"):
        assert narrow(views[name], "top") < narrow(views[name], "bottom"), name
    bumps = {"front": "right", "back": "left", "left": "right", "right": "left", "top": "top", "bottom": "bottom"}
    opposite = {"right": "left", "left": "right", "top": "bottom", "bottom": "top"}
    for name, side in bumps.items():
        assert narrow(views[name], side) < narrow(views[name], opposite[side]), name


@pytest.mark.parametrize("arguments, view", [
    (["--azimuth", 90], "left"), (["--azimuth", -90], "right"), (["--azimuth", 180], "back"), (["--elevation", 90], "top"),
    (["--elevation", -90], "bottom"), (["--view", "left", "--azimuth", -90], "front"), (["--azimuth", 360], "front")])
@pytest.mark.one_build
def test_angles_lead_from_view_to_view(picture, volume_file, arguments, view):
    turned = picture(volume_file, *LINES, "--iso", 100, *arguments)
    named = picture(volume_file, *LINES, "--iso", 100, "--view", view)
    assert np.abs(turned.astype(int) - named).mean() < 1


def test_zoom_enlarges(picture, volume_file):
    half = ink_bounds(picture(volume_file, "--iso", 100, "--zoom", 0.5))
    whole = ink_bounds(picture(volume_file, "--iso", 100))
    assert 0.4 < (half[1] - half[0]) / (whole[1] - whole[0]) < 0.6


def test_several_iso_values(picture, tmp_path):
    """A ball of positive values beside one of negative values: each has its own surface."""
    ball = ink_files.blob((32, 32, 16), np.float32)
    ink_files.write_vti(tmp_path / "balls.vti", np.concatenate([ball, -ball], axis=2))
    one, other, both = (picture(tmp_path / "balls.vti", *values) for values in
                        (["--iso", 100], ["--iso", -100], ["--iso", 100, "--iso", -100]))
    dark = [(image < 160).sum() for image in (one, other, both)]
    left, right = (np.abs(part - part[0, 0]).sum() > 0 for part in (both[:, :90].astype(int), both[:, 110:].astype(int)))
    assert left and right, "both halves are drawn"
    assert min(dark) > 100
    assert (one != both).any() and (other != both).any()


def test_colors(picture, volume_file):
    image = picture(volume_file, *LINES, "--iso", 100, "--ink-color", "#f00", "--paper-color", "#00ff00", "--background",
                    "blue")
    pixels = set(map(tuple, image.reshape(-1, 3)))
    assert tuple(image[0, 0]) == (0, 0, 255)
    assert (0, 255, 0) in pixels
    assert max(r for r, g, b in pixels) > 120


def test_transparent(picture, volume_file):
    plain = picture(volume_file, "--iso", 100)
    image = picture(volume_file, "--iso", 100, "--transparent")
    assert image.shape[2] == 4
    assert tuple(image[0, 0]) == (0, 0, 0, 0)
    assert image[100, 90, 3] == 255
    alpha = image[..., 3:] / 255
    over_white = image[..., :3] * alpha + 255 * (1 - alpha)
    assert np.abs(over_white - plain).max() < 4


def test_transparent_without_paper_is_ink_alone(picture, volume_file):
    image = picture(volume_file, *LINES, "--iso", 100, "--transparent", "--paper-color", "none", "--ink-color", "navy")
    assert 0 < image[..., 3].mean() < 60
    strong = image[image[..., 3] > 100]
    assert np.abs(strong[:, :3].astype(int) - [0, 0, 128]).max() < 6


@pytest.mark.parametrize("option, low, high", [("--tau", 0.8, 1.2), ("--phi", 5, 100)])
@pytest.mark.one_build
def test_more_ink_with_larger_values(picture, volume_file, option, low, high):
    light = picture(volume_file, "--iso", 100, option, low).mean()
    dark = picture(volume_file, "--iso", 100, option, high).mean()
    assert dark < light - 1


@pytest.mark.parametrize("option, values", [("--lambda", (1, 4)), ("--sigma", (0.2, 0.8))])
@pytest.mark.one_build
def test_other_parameters_change_the_lines(picture, volume_file, option, values):
    a, b = (picture(volume_file, *LINES, "--iso", 100, option, value).astype(int) for value in values)
    # Much of the ink of lines that are thinner than a pixel.
    assert np.abs(a - b).mean() > 0.1 * (255 - a).mean()


def test_lines_become_wider_and_thinner(picture, volume_file):
    plain, wide, thin, thin_wide = (
        255 - picture(volume_file, *LINES, "--iso", 100, *options).mean()
        for options in ([], ["--line-width", 8], ["--thin"], ["--thin", "--line-width", 8])
    )
    assert thin < 0.7 * plain < plain < 0.9 * wide
    assert thin < thin_wide < wide


def test_hardness_leaves_no_grays(picture, volume_file):
    def grays(*options):
        image = picture(volume_file, *LINES, "--iso", 100, "--phi", 20, *options, size="400x400")
        return ((image > 20) & (image < 235)).sum()

    # What is left is the edges of lines.
    assert grays("--hardness", 1) < 0.8 * grays()


@pytest.mark.one_build
def test_speckles_go(picture, tmp_path):
    """A large ball and, beside it, one that is a few pixels wide."""
    ball = ink_files.blob((48, 48, 48), np.float32)
    small = np.zeros((48, 48, 16), np.float32)
    small[22:26, 22:26, 6:10] = 200
    ink_files.write_vti(tmp_path / "balls.vti", np.concatenate([ball, small], axis=2))
    columns = [
        np.flatnonzero((picture(tmp_path / "balls.vti", *LINES, "--iso", 100, *options)[..., 0] < 160).any(axis=0))
        for options in ([], ["--speckles", 40])
    ]
    assert columns[1].max() < columns[0].max() - 20
    assert columns[1].min() == columns[0].min()


@pytest.fixture
def nested(tmp_path):
    """A ball of 200 in one of 100, both with soft edges."""
    z, y, x = np.mgrid[-1:1:48j, -1:1:48j, -1:1:48j]
    r = np.sqrt(x * x + y * y + z * z)
    ink_files.write_vti(tmp_path / "nested.vti", sum(np.clip(1000 * (size - r), 0, 100) for size in (0.9, 0.5)).astype(np.float32))
    return [tmp_path / "nested.vti", "--iso", 50, "--iso", 150, "--subdivision", 1]


def test_layers_show_what_is_hidden(picture, nested):
    def inside(*options):
        """The ink in the middle of the picture, where the visible ball is paper."""
        return 255 - picture(*nested, *LINES, *options)[60:140, 60:140].astype(int)

    none, faint, strong, dashed, colored = (
        inside(*options)
        for options in (
            [],
            ["--layers", 2],
            ["--layers", 2, "--hidden-strength", 1],
            ["--layers", 2, "--hidden-strength", 1, "--hidden-dashes", 20],
            ["--layers", 2, "--hidden-strength", 1, "--hidden-color", "red,blue"],
        )
    )
    assert none.sum() == 0
    assert 0 < 2 * faint.sum() < strong.sum()
    assert 0.25 < dashed.sum() / strong.sum() < 0.85
    assert colored[..., 0].sum() == 0 < colored[..., 1].sum()


@pytest.mark.one_build
def test_hidden_lines_need_layers(ink, nested, tmp_path):
    result = ink("render", *nested, *LINES, "--hidden-dashes", 5, "-o", tmp_path / "out.png")
    assert result.code == 2
    assert "--hidden-dashes" in result.err and "--layers" in result.err


def test_tone_colors_lines_by_how_the_surface_lies(picture, volume_file):
    plain = picture(volume_file, *LINES, "--iso", 100, "--tau", 1.01)
    toned = picture(volume_file, *LINES, "--iso", 100, "--tau", 1.01, "--tone-color", "red")
    assert (plain[..., 0] == plain[..., 1]).all()
    red = toned[..., 0].astype(int) - toned[..., 1]
    assert red.max() > 60, "some lines lie where the surface faces the viewer"
    # Its ink is as much as before, seen through red glass.
    assert np.abs(toned[..., 1].astype(int) - plain[..., 1]).max() < 12


@pytest.mark.one_build
def test_speed_costs_little_accuracy(picture, volume_file):
    exact = picture(volume_file, *LINES, "--iso", 100, "--maximum-downsampling", 1, "--lambda", 6).astype(int)
    for options, most in (([], 6), (["--half-floats"], 6), (["--point-fraction", 0.7], 20)):
        quick = picture(volume_file, *LINES, "--iso", 100, "--lambda", 6, *options)
        assert 0 < np.abs(quick - exact).mean() < most, options


def run_on_terminal(arguments):
    """The exit code of a command and what it writes to a terminal on stderr."""
    try:
        leader, follower = pty.openpty()
    except OSError as error:
        pytest.skip(f"no pseudo-terminals here: {error}")
    process = subprocess.Popen(["ink", *map(str, arguments)], stderr=follower, stdout=subprocess.PIPE)
    os.close(follower)
    text = b""
    while True:
        try:
            part = os.read(leader, 4096)
        except OSError:
            break
        if not part:
            break
        text += part
    os.close(leader)
    return process.wait(timeout=TIME_LIMIT), text.decode()


def test_progress_on_a_terminal(volume_file, tmp_path):
    code, text = run_on_terminal(["render", volume_file, "--iso", 100, "--size", "64x64", "-o", tmp_path / "out.png"])
    assert code == 0
    progress, cleared, last = text.rpartition("\r\x1b[K")
    for step in ("reading blob.vti", "sampling the surface", "placing stipples", "drawing"):
        assert step in progress
    assert "\n" not in progress, "progress is one line"
    assert cleared, "the line is taken away"
    assert re.fullmatch(r"ink: wrote \S*/out\.png: [^\r\n]*\r\n", last), last


@pytest.mark.parametrize("style, least, options", [
    ("illustration", 20, []), ("splatting-lines", 12, []), ("stipple", 10, []), ("contours", 3, []),
    ("line-art", 4, ["--subdivision", "2", "--line-spacing", "8"])])  # fmt: skip
def test_drawing_tells_how_far_it_is(volume_file, tmp_path, style, least, options):
    """Of one picture in one piece, too."""
    out = tmp_path / "out.png"
    arguments = ["render", volume_file, "--style", style, "--iso", "100", "--size", "500x400", *options]
    code, text = run_on_terminal([*arguments, "-o", out])
    assert code == 0
    percents = [int(percent) for percent in re.findall(r"drawing (\d+) %", text)]
    assert percents == sorted(percents) and (percents[0], percents[-1]) == (0, 100), percents
    assert len(set(percents)) > least, percents
    # What is watched is what is drawn.
    again = tmp_path / "again.png"
    subprocess.run(["ink", *arguments, "-q", "-o", again], check=True)
    assert out.read_bytes() == again.read_bytes()


def test_errors_on_a_terminal_start_a_clean_line(volume_file, tmp_path):
    code, text = run_on_terminal(["render", volume_file, "--iso", 1000, "-o", tmp_path / "out.png"])
    assert code == 2
    assert text.split("\x1b[K")[-1].startswith("ink: error: ")


def test_quiet_on_a_terminal(volume_file, tmp_path):
    code, text = run_on_terminal(["render", volume_file, "--quiet", "--size", "64x64", "-o", tmp_path / "out.png"])
    assert (code, text) == (0, "")
