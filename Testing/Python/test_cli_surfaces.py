# SPDX-License-Identifier: BSD-3-Clause
"""Which surface of a volume `ink` chooses, which of its parts it draws, where these end, and what it fits the picture to."""

import json
import pathlib
import re

import numpy as np
import pytest

import ink_files

pytestmark = pytest.mark.one_build

DATA = pathlib.Path(__file__).resolve().parents[2] / "Data"


def grid(shape):
    return np.meshgrid(*[np.arange(n, dtype=float) - (n - 1) / 2 for n in shape], indexing="ij")


def ball(shape, center, radius):
    """Its signed distance as values: 100 on its surface, more inside."""
    z, y, x = grid(shape)
    cx, cy, cz = center
    return np.clip(100 - 20 * (np.sqrt((x - cx) ** 2 + (y - cy) ** 2 + (z - cz) ** 2) - radius), 0, 200)


def listed(ink, path):
    """The suggested iso-values, with what `ink info` says of each."""
    result = ink("info", path)
    assert (result.code, result.err) == (0, ""), result
    lines = result.out.splitlines()
    first = next(i for i, line in enumerate(lines) if line.startswith("suggested iso"))
    last = next((i for i in range(first + 1, len(lines)) if lines[i].strip() and lines[i][0] != " "), len(lines))
    return [(float(line[15:].split()[0]), line[15:].partition("(")[2]) for line in lines[first:last]]


def trunk(path):
    """In Hounsfield units: air, a body, flesh in it, and spongy bone, which has no clear boundary."""
    z, y, x = grid((40, 48, 48))
    distance = np.sqrt((x / 1.2) ** 2 + y**2)
    inside = lambda radius: 1 / (1 + np.exp(2 * (distance - radius)))
    noise = np.random.default_rng(3).normal(0, 1, x.shape)
    values = -1000 + 900 * inside(18) + 140 * inside(13) + np.where(distance < 5, 300 + 200 * noise, 15 * noise)
    ink_files.write_nifti(path, values.astype(np.int16))


def test_bone_in_ct_is_known_by_its_units(ink, tmp_path):
    trunk(tmp_path / "ct.nii")
    values = listed(ink, tmp_path / "ct.nii")
    assert -800 < values[0][0] < -200 and "outermost" in values[0][1]
    assert values[1][0] == 200 and values[1][1].startswith("bone, by its Hounsfield units, keeps")
    few = ["--size", "100x100", "-o", tmp_path / "out.png"]
    for option, words in (("--preset=bone", "iso-value 200: bone"), ("--see-through", "inner iso-value 200: bone")):
        result = ink("render", tmp_path / "ct.nii", option, *few)
        assert result.code == 0 and words in result.err, result


# The bonsai's inner ones lie half way between the peaks of its materials: 40, 135 and 205.
@pytest.mark.parametrize("file, expected", [("engine.nii.gz", [80, 160]), ("bonsai.nii.gz", [36, 88, 170])])
def test_the_best_iso_values_of_a_scan_are_listed(ink, file, expected):
    found = listed(ink, DATA / file)
    assert [value for value, _ in found] == pytest.approx(expected, abs=5)
    assert found[0][1].startswith("the outermost clear boundary, keeps ")
    assert found[-1][1].startswith("the boundary of the densest part, keeps ")


def test_render_names_its_choice_and_the_next_ones(ink, tmp_path):
    values = ball((40, 40, 40), (0, 0, 0), 15) * 0.2 + ball((40, 40, 40), (0, 0, 0), 8)
    ink_files.write_nifti(tmp_path / "v.nii", values.astype(np.int16))
    found = listed(ink, tmp_path / "v.nii")
    assert len(found) == 2
    result = ink("render", tmp_path / "v.nii", "--style", "splatting-lines", "--size", "64x64", "-o", tmp_path / "out.png")
    choice = re.match(r"ink: iso-value (\S+): the outermost clear boundary, keeps \S+ % of the volume; "
                      r"next best: (\S+): the boundary of the densest part, keeps \S+ % of the volume\n"
                      r"ink: wrote [^\n]*\n$", result.err)
    assert choice, result.err
    assert [float(choice.group(1)), float(choice.group(2))] == [value for value, _ in found]


def test_of_labels_their_number_is_said_and_no_value_between_them(ink, tmp_path):
    z, y, x = grid((40, 40, 40))
    sectors = 5 + 9 * np.floor((np.arctan2(y, x) + np.pi) * 1.2) + 70 * (z > 0)
    inside = np.sqrt(x * x + y * y + z * z) < 16
    labels = np.where(inside, sectors, 0).astype(np.int16)
    for name, values, number, shows in (("labels", labels, len(np.unique(labels)) - 1, "all {} labels"),
                                        ("mask", inside.astype(np.int16) * 5, 1, "a mask")):
        path = tmp_path / f"{name}.nii"
        ink_files.write_nifti(path, values)
        edge = f"the edge of {shows.format(number)}, keeps 27 % of the volume"
        described = json.loads(ink("info", "--json", path).out)[0]
        assert described["labels"] == number
        assert described["suggested_iso"] == [{"value": 2.5, "shows": edge, "kept_share": pytest.approx(inside.mean())}]
        assert f"labels         {number}\nsuggested iso  2.5 ({edge})\n" in ink("info", path).out
        result = ink("render", path, "--style", "splatting-lines", "--size", "64x64", "-o", tmp_path / "out.png")
        assert result.err.startswith(f"ink: iso-value 2.5: {edge}\nink: wrote "), result.err


def test_the_edge_of_a_mask_is_not_chosen(ink, tmp_path):
    z, y, x = grid((48, 48, 48))
    inside = np.sqrt(x * x + y * y + z * z)
    noise = np.random.default_rng(1).normal(0, 12, inside.shape)
    values = np.where(inside < 20, 500 + 300 / (1 + np.exp(2 * (inside - 11))) + noise, 0)
    ink_files.write_nifti(tmp_path / "v.nii", values.astype(np.int16))
    assert listed(ink, tmp_path / "v.nii")[0][0] == pytest.approx(650, abs=60)


LINES = ["--style", "splatting-lines", "--iso", 100]


@pytest.fixture
def balls(tmp_path):
    """Two balls and a speck, and the larger ball alone."""
    shape = (30, 40, 60)
    large, small = ball(shape, (-14, 0, 0), 11), ball(shape, (18, 0, 0), 6)
    both = np.maximum(large, small)
    both[3, 3, 30] = 200
    for name, values in (("both", both), ("large", large)):
        ink_files.write_nifti(tmp_path / f"{name}.nii", values.astype(np.uint8))
    return tmp_path


def test_the_largest_part_alone_is_drawn_as_if_there_were_no_other(picture, balls):
    """The frame fits it, too."""
    wanted = picture(balls / "large.nii", *LINES)
    assert (picture(balls / "both.nii", *LINES, "--largest-parts", 1) == wanted).all()
    assert (picture(balls / "both.nii", *LINES, "--smallest-part", 0.5) == wanted).all()
    assert (picture(balls / "both.nii", *LINES) != wanted).any()


def test_specks_are_left_out_unless_asked_for(picture, balls):
    two = picture(balls / "both.nii", *LINES, "--largest-parts", 2)
    assert (picture(balls / "both.nii", *LINES) == two).all()
    assert (picture(balls / "both.nii", *LINES, "--smallest-part", 0) != two).any()


def test_parts_of_a_volume_read_a_few_slices_at_a_time(ink, picture, tmp_path):
    shape = (72, 64, 64)
    both = np.maximum(ball(shape, (-8, 0, 4), 22), ball(shape, (24, 0, -30), 7))
    # Nearly all of it is air.
    with open(tmp_path / "v.raw", "wb") as file:
        for values in both.astype(np.uint8):
            file.write(np.pad(values, ((0, 1536 - 64), (0, 1536 - 64))).tobytes())
    # Styles smooth only what fits into memory (Documentation/large-volumes.md).
    same = ["--smoothing", 0, "--subdivision", 1]
    options = [tmp_path / "v.raw", "--raw", "1536x1536x72:uint8", *LINES, *same, "--largest-parts", 1]
    whole = picture(*options, "--memory", "2GiB")
    assert (picture(*options, "--memory", "170MiB") == whole).all()


def lower_edge(picture, file, *options):
    """The share of the lower edge of what is drawn that has ink, by how the surface is cut."""

    def drawn(cut, *more):
        image = picture(file, *LINES, *options, *more, "--parallel", "--cut", cut, size="400x400")[..., 0]
        if not (image < 128).any():
            return 0
        rows, columns = np.flatnonzero((image < 128).any(axis=1)), np.flatnonzero((image < 128).any(axis=0))
        edge = 1 - image[rows[-1] - 8 : rows[-1] + 2, columns[0] + 8 : columns[-1] - 7] / 255
        # Across the line, which may share its ink between two rows: the cap's edge is as thin as contours are
        # (0.76 pixels, 0.41 at the least).
        return (edge.sum(axis=0) > 0.3).mean()

    return drawn


@pytest.mark.parametrize("view", ["front", "right"])
def test_a_cut_is_one_line(picture, tmp_path, view):
    """Half a ball, cut by the volume's lower side, which faces away."""
    values = ball((40, 80, 80), (0, 0, -19.5), 30)
    ink_files.write_nifti(tmp_path / "half.nii", values.astype(np.uint8))
    drawn = lower_edge(picture, tmp_path / "half.nii", "--view", view)
    assert drawn("open", "--as-published") < 0.5
    assert drawn("open") == 1, "an outline, as the surface ends"
    assert drawn("rim") == 1
    assert drawn("cap") > 0.99


@pytest.mark.parametrize("elevation", [10, 35, 60, 85])
def test_a_cut_that_faces_the_viewer_is_one_line(picture, tmp_path, elevation):
    """A table that leaves the volume on all sides, seen from the front and above."""
    z = np.arange(20)[:, None, None] + 0 * ball((20, 60, 60), (0, 0, 0), 1)
    ink_files.write_nifti(tmp_path / "table.nii", np.clip(100 + 40 * (10.3 - z), 0, 200).astype(np.uint8))
    drawn = lower_edge(picture, tmp_path / "table.nii", "--view", "front", "--elevation", elevation)
    assert drawn("open", "--as-published") < 0.5
    assert drawn("open") == 1, "an outline, as the surface ends"
    assert drawn("rim") == 1


def test_the_array_of_a_volume_is_chosen(ink, tmp_path):
    shape = (30, 30, 30)
    density, core = (ball(shape, (0, 0, 0), radius).astype(np.uint8) for radius in (12, 5))
    ink_files.write_vti(tmp_path / "both.vti", density, core=core)
    ink_files.write_vti(tmp_path / "core.vti", core)
    drawn = {}
    for name, file, options in (("chosen", "both.vti", ["--scalars", "core"]), ("alone", "core.vti", []), ("active", "both.vti", [])):
        result = ink("render", tmp_path / file, *LINES, "--size", "200x200", *options, "-o", tmp_path / f"{name}.png")
        assert result.code == 0, result
        drawn[name] = (tmp_path / f"{name}.png").read_bytes()
    assert drawn["chosen"] == drawn["alone"] != drawn["active"]
    result = ink("render", tmp_path / "both.vti", *LINES, "--scalars", "velocity", "-o", tmp_path / "none.png")
    assert result.code == 1
    assert "found an image without the array 'velocity', with 'density', 'core'" in result.error
    assert not (tmp_path / "none.png").exists()


@pytest.mark.parametrize("slices", [1, 7])
def test_a_small_label_in_a_large_volume_fills_the_picture_all_the_same(picture, tmp_path, slices):
    """A nodule of a lung, as segmentations have them, also in thick slices: its voxels are large, and divided."""
    z, y, x = np.indices((160 // slices, 160, 160))
    z = slices * z + (slices - 1) / 2
    label = ((z - 60) ** 2 + (y - 110) ** 2 + (x - 40) ** 2 < 10**2).astype(np.uint8)
    ink_files.write_nifti(tmp_path / "nodule.nii", label, spacing=(1, 1, slices))

    def drawn(*options):
        return picture(tmp_path / "nodule.nii", "--style", "splatting-lines", *options)

    np.testing.assert_array_equal(drawn(), drawn("--subdivision", 8))
    assert (drawn() < 128).sum() < 0.7 * (drawn("--subdivision", 1) < 128).sum(), "hairs"
