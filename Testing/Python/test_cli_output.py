# SPDX-License-Identifier: BSD-3-Clause
"""The files of `ink render`: formats, resolution, the standard output, and pictures drawn in tiles."""

import os
import pathlib
import re
import struct
import subprocess

import numpy as np
import pytest

import ink_files
from conftest import TIME_LIMIT
from picture_files import png_chunks, read_tiff


# The style that is drawn soonest, of as few points as show something.
LINES = ["--style", "splatting-lines"]
MESH_LINES = [*LINES, "--samples", 4000]


@pytest.fixture
def written(ink, tmp_path):
    """Renders a file and returns the picture's path."""

    def render(file, name, *arguments, size="200x160"):
        out = tmp_path / name
        result = ink("render", file, "--size", size, "--quiet", "-o", out, *arguments)
        assert (result.code, result.out, result.err) == (0, "", ""), result
        return out

    return render


def test_a_number_is_the_side_of_a_square(written, volume_file):
    assert ink_files.read_png(written(volume_file, "out.png", *LINES, size="96")).shape == (96, 96, 3)


@pytest.mark.parametrize("dpi, expected", [([], 11811), (["--dpi", 600], 23622), (["--dpi", 72], 2835)])
def test_png_says_its_resolution(written, volume_file, dpi, expected):
    chunks = dict(png_chunks(written(volume_file, "out.png", *LINES, *dpi).read_bytes()))
    assert struct.unpack(">IIB", chunks[b"pHYs"]) == (expected, expected, 1)


@pytest.mark.parametrize("name", ["out.tif", "out.tiff", "OUT.TIF"])
def test_tiff_is_the_same_picture(written, picture, volume_file, name):
    pixels, tags = read_tiff(written(volume_file, name, *LINES, "--dpi", 600))
    assert (pixels == picture(volume_file, *LINES, size="200x160")).all()
    assert tags[296] == (2,) and tags[282][0] / tags[282][1] == 600 and tags[283][0] / tags[283][1] == 600


def test_tiff_with_alpha(written, picture, volume_file):
    pixels, tags = read_tiff(written(volume_file, "out.tif", *LINES, "--transparent"))
    assert tags[338] == (2,)
    assert (pixels == picture(volume_file, *LINES, "--transparent", size="200x160")).all()


@pytest.mark.parametrize("name", ["out.jpg", "out.jpeg"])
def test_jpeg_is_nearly_the_same_picture(written, picture, volume_file, name):
    path = written(volume_file, name, *LINES, "--dpi", 600)
    data = path.read_bytes()
    assert data[:4] == b"\xff\xd8\xff\xe0" and data[6:11] == b"JFIF\0"
    assert struct.unpack(">BHH", data[13:18]) == (1, 600, 600)
    vtkink = pytest.importorskip("vtkink")
    reader = vtkink.vtk.vtkJPEGReader()
    reader.SetFileName(str(path))
    reader.Update()
    image = reader.GetOutput()
    assert image.GetDimensions() == (200, 160, 1)
    pixels = vtkink.numpy_support.vtk_to_numpy(image.GetPointData().GetScalars()).reshape(160, 200, 3)[::-1]
    assert np.abs(pixels.astype(int) - picture(volume_file, *LINES, size="200x160")).mean() < 2


def test_jpeg_has_no_alpha(ink, volume_file, tmp_path):
    result = ink("render", volume_file, "--transparent", "-o", tmp_path / "out.jpg")
    assert result.code == 2 and "--transparent: expected a PNG or TIFF file" in result.error


def test_numbered_pictures_of_other_formats(ink, mesh_file, tmp_path):
    assert ink("render", mesh_file, *MESH_LINES, "--size", 48, "--frames", 2, "-q", "-o", tmp_path / "f%d.tif").code == 0
    assert sorted(os.listdir(tmp_path)) == ["f0.tif", "f1.tif"]
    assert read_tiff(tmp_path / "f1.tif")[0].shape == (48, 48, 3)


def test_the_standard_output(picture, volume_file, tmp_path):
    done = subprocess.run(["ink", "render", str(volume_file), *LINES, "--size", "200x160", "-q", "-o", "-"],
                          capture_output=True, timeout=TIME_LIMIT, cwd=tmp_path)  # fmt: skip
    assert (done.returncode, done.stderr) == (0, b"")
    assert not os.listdir(tmp_path)
    (tmp_path / "out.png").write_bytes(done.stdout)
    assert (ink_files.read_png(tmp_path / "out.png") == picture(volume_file, *LINES, size="200x160")).all()


def test_the_picture_is_an_argument_or_an_option(ink, volume_file, tmp_path):
    size = ("--size", 64)
    assert ink("render", volume_file, tmp_path / "argument.png", *size).code == 0
    assert ink("render", volume_file, "-o", tmp_path / "option.png", *size).code == 0
    assert (tmp_path / "argument.png").read_bytes() == (tmp_path / "option.png").read_bytes()
    text = ink("render", "--help").out
    assert "OUT OUT.png REQUIRED" in text and re.search(r"-o,--output OUT.png +the same as OUT\n", text)


def test_the_standard_output_that_is_closed(volume_file):
    command = f"ink render '{volume_file}' --size 64 -q -o - >&-"
    done = subprocess.run(["sh", "-c", command], capture_output=True, text=True, timeout=TIME_LIMIT)
    assert done.returncode == 1 and done.stderr.count("\n") == 1 and "cannot write '-'" in done.stderr


def test_the_last_line_says_what_was_written(ink, volume_file, tmp_path):
    out = tmp_path / "out.png"
    result = ink("render", volume_file, *LINES, "--iso", 100, "--size", "300x150", "--dpi", 300, "-o", out)
    assert result.err.splitlines() == [f"ink: wrote {out}: 300 x 150 pixels, 300 dpi, 25 x 13 mm"]
    result = ink("sample", volume_file, tmp_path / "p.vtp", "--iso", 100)
    count = len(ink_files.read_points(tmp_path / "p.vtp")["x"])
    assert result.err.splitlines() == [f"ink: wrote {tmp_path / 'p.vtp'}: {count} points"]


# What is drawn whole by default is summed up for several pixels at once where splats are large; tiles are exact.
EXACT = ["--maximum-downsampling", 1]
# As many as can be told apart: to place those of the default takes four times as long as to draw them.
FEW = ["--pixels-per-stipple", 30, "--stipple-size", 5]
ONE_BUILD = pytest.mark.one_build


def expect_no_seams(picture, file, *options, size, tile):
    whole = picture(file, *options, size=size).astype(int)
    tiles = picture(file, *options, "--tile", tile, size=size).astype(int)
    difference = np.abs(whole - tiles).max(axis=2)
    assert (whole[..., 0] < 128).sum() > 100, "there is something to be cut"
    # 5 pixels at the most.
    assert (difference > 16).sum() <= 10, f"{(difference > 16).sum()} pixels differ in {file.name}"


@pytest.mark.parametrize("style, options", [
    ("splatting-lines", EXACT), pytest.param("splatting-lines", [*EXACT, "--hidden-layers"], marks=ONE_BUILD),
    pytest.param("splatting-lines", [*EXACT, "--thin", "--line-width", 3], marks=ONE_BUILD),
    pytest.param("splatting-lines", [*EXACT, "--speckles", 6], marks=ONE_BUILD),
    ("splatting-lines", [*EXACT, "--parallel", "--zoom", 1.3]), ("stipple", FEW),
    pytest.param("stipple", ["--size-unit", "pixels"], marks=ONE_BUILD),
    pytest.param("stipple", [*FEW, "--zoom", 1.7, "--view", "iso"], marks=ONE_BUILD), ("stipple", [*FEW, "--transparent"])])  # fmt: skip
def test_tiles_have_no_seams(picture, volume_file, mesh_file, style, options):
    """Six tiles, of which the last ones are smaller."""
    for file in (volume_file, mesh_file):
        # By default 200000, which takes longer than to draw them.
        few = ["--samples", 20000] if file == mesh_file and style == "splatting-lines" else []
        expect_no_seams(picture, file, "--style", style, *options, *few, size="640x360", tile=300)


@pytest.mark.parametrize("style, options", [("splatting-lines", EXACT), ("stipple", FEW)])
@pytest.mark.parametrize("size, tile", [("440x440", 256), ("300x720", 512)])
@ONE_BUILD
def test_tiles_of_other_sizes_have_no_seams(picture, volume_file, style, options, size, tile):
    """Up to nine tiles, of which some have neighbors on all sides."""
    expect_no_seams(picture, volume_file, "--style", style, *options, size=size, tile=tile)


@ONE_BUILD
def test_outlines_of_rough_surfaces_have_no_seams(picture, tmp_path):
    """What is shown within an outline that is rougher than its normals goes by what is far from it."""
    z, y, x = (np.mgrid[:64, :64, :64] - 31.3) / np.array([20, 24, 28]).reshape(3, 1, 1, 1)
    ball = 100 + 400 * (1 - np.sqrt(x ** 2 + y ** 2 + z ** 2)) + np.random.default_rng(5).normal(0, 30, x.shape)
    ink_files.write_nifti(tmp_path / "rough.nii", np.clip(ball, 0, 200).astype(np.float32))
    tiles, whole = (picture(tmp_path / "rough.nii", "--style", "contours", "--iso", 100, "--smoothing", 2, "--tile", tile, size="1500x1500")
                    for tile in (512, 8192))
    assert (whole < 128).sum() > 5000
    assert np.abs(tiles.astype(int) - whole).max() < 32


def test_more_pixels_than_opengl_has(written, mesh_file):
    """Wider than any window, a strip of tiles that are as high as it."""
    path = written(mesh_file, "wide.tif", "--style", "stipple", "--zoom", 4, size="17000x120")
    pixels, _ = read_tiff(path)
    assert pixels.shape == (120, 17000, 3) and (pixels[:, 8300:8700] < 128).any()


@pytest.mark.parametrize("tile", ["0", "255", "9000", "x", "100.5"])
def test_tiles_that_cannot_be(ink, volume_file, tile):
    result = ink("render", volume_file, "-o", "none.png", "--tile", tile)
    assert result.code == 2 and "--tile '" in result.error


@pytest.mark.one_build
def test_a_video_of_any_spelling_and_rate(ink, volume_file, tmp_path):
    """By a program in ffmpeg's place, which writes down what it is told."""
    program = tmp_path / "ffmpeg"
    program.write_text('#!/bin/sh\nfor last; do :; done\necho "$@" > "$ARGUMENTS"\ncat > "$last"\n')
    program.chmod(0o755)
    env = {"PATH": f"{tmp_path}:{os.environ['PATH']}", "ARGUMENTS": str(tmp_path / "arguments")}
    for name, rate, codec in (("a.MP4", "29.97002997", "libx264"), ("b.WebM", "1000", "libvpx"), ("c.GIF", "0.1", "palettegen")):
        result = ink("render", volume_file, *LINES, "--frames", 2, "--fps", rate, "--size", "20x10", "-o", tmp_path / name, env=env)
        assert result.code == 0 and (tmp_path / name).stat().st_size == 2 * 20 * 10 * 3, result
        words = (tmp_path / "arguments").read_text()
        assert f"-s 20x10 -r {rate} " in words and codec in words


def test_what_is_said_of_tiles(ink):
    """Help and documentation name the same limits."""
    said = " ".join(ink("render", "--help-all").out.split())
    assert "(1024 above 4.2 million pixels or 8192 a side)" in said
    page = pathlib.Path(__file__).parents[2] / "Documentation" / "command-line.md"
    assert "more than 4.2 million pixels, or of more than 8192 a side, is drawn in tiles of 1024" in " ".join(page.read_text().split())
