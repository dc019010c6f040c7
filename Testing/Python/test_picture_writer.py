# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of `vtkink.draw` and of vtkInkPictureWriter say their resolution, as those of `ink` do."""

import struct

import numpy as np
import pytest

import ink_files
from picture_files import png_chunks, read_tiff

vtkink = pytest.importorskip("vtkink")

from vtkink import numpy_support, vtk  # noqa: E402

RNG = np.random.default_rng(5)


def image_of(pixels):
    """Rows from the top, as files have them."""
    image = vtk.vtkImageData()
    image.SetDimensions(pixels.shape[1], pixels.shape[0], 1)
    values = np.ascontiguousarray(pixels[::-1]).reshape(-1, pixels.shape[2])
    image.GetPointData().SetScalars(numpy_support.numpy_to_vtk(values, deep=True))
    return image


def write(pixels, path, dpi=None):
    writer = vtkink.vtkInkPictureWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(pixels if isinstance(pixels, vtk.vtkImageData) else image_of(pixels))
    if dpi is not None:
        writer.SetDotsPerInch(dpi)
    assert writer.Write() == (writer.GetErrorCode() == 0)
    return writer


@pytest.mark.parametrize("components", [3, 4])
def test_the_same_pixels_and_their_resolution(tmp_path, components):
    pixels = RNG.integers(0, 256, (11, 7, components), np.uint8)
    assert write(pixels, tmp_path / "p.png", 600).GetErrorCode() == 0
    assert (ink_files.read_png(tmp_path / "p.png") == pixels).all()
    chunks = dict(png_chunks((tmp_path / "p.png").read_bytes()))
    assert struct.unpack(">IIB", chunks[b"pHYs"]) == (23622, 23622, 1)
    assert write(pixels, tmp_path / "p.tif", 150).GetErrorCode() == 0
    found, tags = read_tiff(tmp_path / "p.tif")
    assert (found == pixels).all() and tags[282][0] / tags[282][1] == 150


def test_jpeg(tmp_path):
    pixels = np.full((16, 24, 3), (200, 120, 40), np.uint8)
    assert write(pixels, tmp_path / "p.jpg", 96).GetErrorCode() == 0
    data = (tmp_path / "p.jpg").read_bytes()
    assert struct.unpack(">BHH", data[13:18]) == (1, 96, 96)


@pytest.mark.parametrize("name, pixels, expected", [
    ("p.bmp", np.zeros((4, 4, 3), np.uint8), "ends in .png"),
    ("p.png", np.zeros((4, 4, 2), np.uint8), "found 2 components"),
    ("p.jpg", np.zeros((4, 4, 4), np.uint8), "expected red, green and blue, found 4"),
    ("p.png", np.zeros((4, 4, 3), np.float32), "without such scalars"),
    ("absent/p.png", np.zeros((4, 4, 3), np.uint8), "No such file"),
])  # fmt: skip
def test_what_cannot_be_written_is_one_error(tmp_path, capfd, name, pixels, expected):
    assert write(pixels, tmp_path / name).GetErrorCode() != 0
    errors = capfd.readouterr().err
    assert errors.count("The picture cannot be written") == 1 and expected in errors
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("dpi, expected", [({}, 11811), ({"dpi": 600}, 23622), ({"dpi": np.float32(72)}, 2835)])
def test_pictures_of_draw(tmp_path, dpi, expected):
    vtkink.draw(ink_files.blob(), "splatting-lines", tmp_path / "p.png", size=(60, 40), **dpi)
    chunks = dict(png_chunks((tmp_path / "p.png").read_bytes()))
    assert struct.unpack(">IIB", chunks[b"pHYs"]) == (expected, expected, 1)


def test_draw_writes_other_formats(tmp_path):
    for name in ("p.png", "p.tif"):
        vtkink.draw(ink_files.blob(), "splatting-lines", tmp_path / name, size=(60, 40), dpi=200)
    pixels, tags = read_tiff(tmp_path / "p.tif")
    assert (pixels == ink_files.read_png(tmp_path / "p.png")).all() and tags[282][0] / tags[282][1] == 200


@pytest.mark.parametrize("dpi", [0, -1, 1e9, float("nan"), "300", True, None])
def test_resolutions_that_cannot_be(tmp_path, dpi):
    with pytest.raises(ValueError, match="dpi: expected a number from 1 to 30000, found"):
        vtkink.draw(ink_files.blob(), "splatting-lines", tmp_path / "p.png", dpi=dpi)
    assert not list(tmp_path.iterdir())
