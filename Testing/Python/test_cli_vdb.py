# SPDX-License-Identifier: BSD-3-Clause
"""`ink convert`, and .vdb files wherever `ink` reads volumes."""

import json
import os
import struct

import numpy as np
import pytest

from ink_files import blob, read_png, write_nifti, write_ply, sphere_mesh

OFFSET_OF_COUNT = 8 + 4 + 4 + 4 + 1 + 36


def has_convert(ink):
    return any(line.split()[:1] == ["convert"] for line in ink("--help").out.splitlines())


@pytest.fixture(scope="module")
def can_convert(ink):
    if not has_convert(ink):
        pytest.skip("built without OpenVDB")


@pytest.fixture
def volume(tmp_path, can_convert):
    path = tmp_path / "blob.nii.gz"
    affine = [[-1, 0, 0, 20], [0, 0.5, 0, -30], [0, 0, 2, 5]]
    write_nifti(path, blob(), affine=affine)
    return path


def points(ink, file, out, *options):
    """The sorted rows of x y z nx ny nz that `ink sample` writes."""
    result = ink("sample", file, out, "--quiet", *options)
    assert result.code == 0, result.err
    rows = np.loadtxt(out)
    return rows[np.lexsort(rows.T)]


def test_a_band_has_exactly_the_volumes_points(ink, volume, tmp_path):
    band = tmp_path / "band.vdb"
    result = ink("convert", volume, band, "--around", "100")
    assert result.code == 0 and not result.out, result.err
    assert not list(tmp_path.glob("*.tmp"))
    expected = points(ink, volume, tmp_path / "volume.xyz", "--iso", "100")
    suggested = json.loads(ink("info", "--json", band).out)[0]["suggested_iso"]
    assert suggested == [{"value": 100, "shows": "that of the file's surface", "kept_share": None}]
    # The band knows its value.
    assert np.array_equal(points(ink, band, tmp_path / "band.xyz"), expected)
    assert len(expected) > 500


def test_a_whole_volume_keeps_its_values_and_its_place(ink, volume, tmp_path):
    whole = tmp_path / "whole.vdb"
    assert ink("convert", volume, "-o", whole, "--name", "blob").code == 0
    before, after = (ink("info", file).out.splitlines() for file in (volume, whole))
    value = lambda lines, name: next(line.split(None, 1)[1] for line in lines if line.startswith(name))
    for name in ("dimensions", "spacing", "origin", "range"):
        assert value(before, name) == value(after, name)
    assert "blob" in value(after, "format")
    for iso in ("50", "150"):
        expected = points(ink, volume, tmp_path / "volume.xyz", "--iso", iso)
        assert np.array_equal(points(ink, whole, tmp_path / "whole.xyz", "--iso", iso), expected)


def test_a_wider_band_is_a_larger_file(ink, volume, tmp_path):
    sizes = []
    for width in ("1", "3", "8"):
        band = tmp_path / f"band{width}.vdb"
        assert ink("convert", volume, band, "--around", "100", "--half-width", width).code == 0
        sizes.append(band.stat().st_size)
    assert sizes[0] < sizes[1] < sizes[2]


def test_render_draws_a_vdb_file(ink, volume, tmp_path):
    band, picture = tmp_path / "band.vdb", tmp_path / "band.png"
    assert ink("convert", volume, band, "--around", "100").code == 0
    result = ink("render", band, "-o", picture, "--size", "64x64")
    assert result.code == 0 and picture.stat().st_size > 100, result.err
    assert "iso-value 100: that of the file's surface" in result.err


@pytest.mark.parametrize("style, options", [("splatting-lines", []),
                                            # Stipples are those of discs in this order, and tiles have another.
                                            ("illustration", ["--cut", "open", "--smallest-part", "0"])])  # fmt: skip
def test_a_picture_is_that_of_the_volume(ink, volume, tmp_path, style, options):
    """Where the surface is neither smoothed nor subdivided, which that of a grid is not."""
    band = tmp_path / "band.vdb"
    assert ink("convert", volume, band, "--around", "100").code == 0
    pictures = []
    for file in (volume, band):
        out = tmp_path / f"{len(pictures)}.png"
        assert ink("render", file, "-o", out, "--iso", "100", "--size", "120x100", "--style", style, "--smoothing", "0",
                   "--subdivision", "1", *options).code == 0
        pictures.append(read_png(out).astype(int))
    # The same marks; their order, and with it rounding, may differ.
    assert pictures[0].min() < 100
    assert np.abs(pictures[0] - pictures[1]).max() <= 2


def drawn(ink, file, out, *options):
    """The picture of a surface at 100, and what was said."""
    result = ink("render", file, "-o", out, "--iso", "100", "--size", "120x100", "--style", "splatting-lines", *options)
    assert result.code == 0, result.err
    return read_png(out).astype(int)


def test_the_largest_part_of_two_balls_is_drawn(ink, can_convert, tmp_path):
    z, y, x = np.meshgrid(*[np.arange(n) for n in (24, 24, 48)], indexing="ij")
    of = lambda middle, radius: np.clip(100 + 40 * (radius - np.sqrt((x - middle) ** 2 + (y - 12) ** 2 + (z - 12) ** 2)), 0, 200)
    large, small = of(12, 8.0), of(36, 5.0)
    files = []
    for name, values in (("both", np.maximum(large, small)), ("one", large)):
        volume, grid = tmp_path / f"{name}.nii.gz", tmp_path / f"{name}.vdb"
        write_nifti(volume, values.astype("f4"))
        assert ink("convert", volume, grid).code == 0
        files.append(grid)
    settings = ["--smoothing", "1", "--subdivision", "2"]
    both, one = (drawn(ink, file, tmp_path / "all.png", *settings) for file in files)
    kept = drawn(ink, files[0], tmp_path / "kept.png", *settings, "--largest-parts", "1")
    dark = lambda picture: int((picture < 128).sum())
    # The frame is that of the points that are left.
    assert np.abs(kept - one).max() <= 2
    assert dark(both) > 0 and np.abs(both - kept).max() > 100


@pytest.mark.parametrize("target", ["surface", "normals"])
def test_a_smoothed_picture_is_that_of_the_volume(ink, volume, tmp_path, target):
    grid = tmp_path / "whole.vdb"
    assert ink("convert", volume, grid).code == 0
    settings = ["--smoothing", "1.5", "--subdivision", "2", "--smoothing-target", target]
    pictures = [drawn(ink, file, tmp_path / "smooth.png", *settings) for file in (volume, grid)]
    assert np.abs(pictures[0] - pictures[1]).max() <= 2
    rough = drawn(ink, grid, tmp_path / "rough.png", "--smoothing", "0", "--subdivision", "1")
    assert np.abs(pictures[1] - rough).max() > 100


@pytest.mark.one_build
@pytest.mark.parametrize("around", [[], ["--around", "100"]], ids=["whole", "band"])
def test_what_is_chosen_is_as_of_the_volume(ink, tmp_path, can_convert, around):
    """Divided by as much, and smoothed by nearly as much."""
    noisy, grid = tmp_path / "noisy.nii.gz", tmp_path / "noisy.vdb"
    values = blob((40, 40, 40)) * 0.7 + np.random.default_rng(1).normal(20, 8, (40, 40, 40))
    write_nifti(noisy, np.clip(values, 0, 255).astype(np.uint8))
    assert ink("convert", noisy, grid, *around).code == 0
    pictures = {name: drawn(ink, grid, tmp_path / "grid.png", *options) for name, options in {
        "automatic": [], "rough": ["--smoothing", "0"], "undivided": ["--subdivision", "1"],
        "divided": ["--subdivision", "8"]}.items()}  # fmt: skip
    differs = lambda a, b: np.abs(a - b).mean()
    assert np.array_equal(pictures["automatic"], pictures["divided"]), "40 voxels are 25 thousandths of the picture each"
    whole = drawn(ink, noisy, tmp_path / "volume.png")
    for other in ("rough", "undivided"):
        assert differs(pictures["automatic"], pictures[other]) > 5 * differs(pictures["automatic"], whole), other


@pytest.fixture
def wide(ink, can_convert, tmp_path):
    """A bar whose second half was moved so far away that an image of both would take 4 GiB."""
    values = np.zeros((6, 8, 4200), np.uint8)
    values[2:4, 2:6, 10:4190] = 200
    raw, near, far = (tmp_path / name for name in ("bar.raw", "near.vdb", "far.vdb"))
    raw.write_bytes(values.tobytes())
    assert ink("convert", raw, near, "--raw", "4200x8x6:uint8", "--around", "100").code == 0
    data = near.read_bytes()
    # A node's place, and behind it which children it has: the first one.
    place = struct.pack("<3i", 4096, 0, 0) + b"\x01" + bytes(64)
    assert data.count(place) == 1
    data = data.replace(place, struct.pack("<3i", 1 << 25, 0, 0) + place[12:])
    # Nor does the file say how large the volume was.
    for name in (b"ink_domain_first", b"file_bbox_min"):
        assert data.count(name) == 1
        data = data.replace(name, name[:-1] + b"?")
    far.write_bytes(data)
    return near, far


def test_a_huge_sparse_grid_is_sampled_and_drawn(ink, wide, tmp_path):
    near, far = wide
    rows = [points(ink, file, tmp_path / "out.xyz", "--memory", "256MiB") for file in wide]
    # Cut in two, the bar has no more points but at the cuts.
    assert len(rows[0]) > 40000 and abs(len(rows[1]) - len(rows[0])) < 200
    assert rows[1][:, 0].max() > 1e7
    out = tmp_path / "far.png"
    assert ink("render", far, "-o", out, "--size", "64x64", "--memory", "256MiB", "--style", "splatting-lines").code == 0
    # Of the default style, whose stipples a surface has that is less than 2^24 samples wide.
    (tmp_path / "far.png").unlink()
    illustration = ink("render", far, "-o", out, "--size", "64x64", "--memory", "256MiB")
    assert illustration.code == 1 and not out.exists()
    assert "cannot be stippled" in illustration.error and "times as wide as its samples are apart" in illustration.error
    several = ink("sample", far, tmp_path / "two.vtp", "--iso", "50", "--iso", "150")
    assert several.code == 0, several.err


def test_what_needs_an_image_too_large_names_the_option(ink, wide):
    result = ink("info", wide[1], "--memory", "256MiB")
    assert result.code == 1 and len(result.err.splitlines()) == 1
    assert "--memory" in result.err and "MaximumMemory" not in result.err


@pytest.mark.parametrize("iso", ["500", "-3", "nan"])
def test_iso_values_that_a_grid_does_not_have(ink, volume, tmp_path, iso):
    band, out = tmp_path / "band.vdb", tmp_path / "out.vtp"
    assert ink("convert", volume, band, "--around", "100").code == 0
    result = ink("sample", band, out, f"--iso={iso}")
    assert result.code == 2 and len(result.err.splitlines()) == 1 and not out.exists()
    assert ("--iso 'nan': expected a number" if iso == "nan" else f"--iso {iso}: expected a value above") in result.err


@pytest.mark.parametrize(
    "options, code, words",
    [
        (["OUT.vdb", "--around", "500"], 2, ["--around 500", "up to 199"]),
        (["OUT.vdb", "--around", "nan"], 2, ["--around"]),
        (["OUT.vdb", "--half-width", "2"], 2, ["--around"]),
        (["OUT.vdb", "--around", "100", "--half-width", "0"], 2, ["1"]),
        (["OUT.png"], 2, [".vdb"]),
        (["nowhere/OUT.vdb"], 1, ["no directory"]),
        (["OUT.vdb", "--grid", "a"], 2, ["--grid", "OpenVDB"]),
    ],
)
def test_what_cannot_be_is_one_line_and_no_file(ink, volume, tmp_path, options, code, words):
    result = ink("convert", volume, tmp_path / options[0], *options[1:])
    assert result.code == code, result.err
    assert len(result.err.splitlines()) == 1
    assert all(word in result.err for word in words), result.err
    assert not list(tmp_path.glob("*.vdb")) and not list(tmp_path.glob("*.tmp"))


def test_built_without_openvdb_it_says_so(ink, tmp_path):
    if has_convert(ink):
        pytest.skip("built with OpenVDB")
    file, out = tmp_path / "a.vdb", tmp_path / "out"
    file.write_bytes(b"anything")
    for arguments in (["info", file], ["sample", file, f"{out}.vtp"], ["render", file, "-o", f"{out}.png"]):
        result = ink(*arguments)
        assert result.code == 1 and not result.out
        assert len(result.err.splitlines()) == 1 and "built without OpenVDB" in result.err
    assert not list(tmp_path.glob("out*"))


def test_what_needs_openvdb_is_loaded_when_it_is_needed(ink, volume, tmp_path):
    file, out = tmp_path / "a.vdb", tmp_path / "out.vdb"
    file.write_bytes(b"anything")
    # Found before those of ink, and no library.
    (tmp_path / "libvtkInkProgramVDB.so").write_bytes(b"anything")
    env = {"LD_LIBRARY_PATH": f"{tmp_path}:{os.environ.get('LD_LIBRARY_PATH', '')}"}
    assert ink("info", volume, env=env).code == 0
    for arguments in (["info", file], ["convert", volume, out, "--quiet"]):
        result = ink(*arguments, env=env)
        assert result.code == 1 and not result.out
        assert "cannot load what reads and writes OpenVDB files: " in result.error and str(tmp_path) in result.error
    assert not out.exists()


def test_a_mesh_cannot_be_converted(ink, can_convert, tmp_path):
    mesh = tmp_path / "sphere.ply"
    write_ply(mesh, sphere_mesh(10, 10))
    result = ink("convert", mesh, tmp_path / "sphere.vdb")
    assert result.code == 2 and "mesh" in result.err


def test_damaged_files_are_one_line(ink, volume, tmp_path):
    band = tmp_path / "band.vdb"
    assert ink("convert", volume, band, "--around", "100").code == 0
    data = band.read_bytes()
    many = data[:OFFSET_OF_COUNT] + struct.pack("<I", 0xFFFFFFFF) + data[OFFSET_OF_COUNT + 4 :]
    for name, content, words in (
        ("words", b"no voxels here", "not an OpenVDB file"),
        ("short", data[: len(data) // 2], "bytes"),
        ("header", data[:40], "within its header"),
        ("count", many, "within its metadata"),
    ):
        bad = tmp_path / f"{name}.vdb"
        bad.write_bytes(content)
        result = ink("info", bad)
        assert result.code == 1 and not result.out
        assert len(result.err.splitlines()) == 1 and bad.name in result.err and words in result.err


def test_a_grid_that_is_not_there_is_named_with_those_that_are(ink, volume, tmp_path):
    band = tmp_path / "band.vdb"
    assert ink("convert", volume, band).code == 0
    result = ink("info", band, "--grid", "velocity")
    assert result.code == 1 and "'velocity'" in result.err and "'density' (float)" in result.err
