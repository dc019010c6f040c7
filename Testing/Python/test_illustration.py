# SPDX-License-Identifier: BSD-3-Clause
"""Stipples of iso-surfaces, and illustrations, beside those of the mesh of the same surface; hard cases."""

import functools
import importlib
import re

import numpy as np
import pytest

import ink_files
from style_scene import StyleScene

vtkink = pytest.importorskip("vtkink")
vtk = vtkink.vtk
numpy_support = importlib.import_module(f"{vtkink.VTK_PACKAGE}.util.numpy_support")

SIZE = 400
RADIUS = 0.8


def ball(cells, spacing=(1.0, 1.0, 1.0), noise=0.0, origin=0.0, scale=1.0):
    """A ball of radius 0.8 in a cube of side 2, blurred as a scanner does; `spacing` relative."""
    counts = [max(int(round(cells / step)), 2) for step in spacing]
    axes = [np.linspace(-1, 1, count) for count in counts]
    z, y, x = np.meshgrid(*axes[::-1], indexing="ij")
    distance = np.sqrt(x * x + y * y + z * z)
    values = 200 / (1 + np.exp((distance - RADIUS) / (0.8 * max(spacing) / cells)))
    values = values + np.random.default_rng(1).normal(0, 1, values.shape) * noise * 200
    image = vtk.vtkImageData()
    image.SetDimensions(counts)
    image.SetSpacing([2 * scale / (count - 1) for count in counts])
    image.SetOrigin([origin - scale] * 3)
    image.GetPointData().SetScalars(numpy_support.numpy_to_vtk(values.astype("f4").ravel(), deep=True))
    return image


def sphere():
    source = vtk.vtkSphereSource()
    source.SetRadius(RADIUS)
    source.SetThetaResolution(180)
    source.SetPhiResolution(90)
    source.Update()
    return source.GetOutput()


def picture(actor, scale=1.0, origin=0.0):
    """Darkness, 0 to 1, of a picture whose frame is the cube."""
    return StyleScene(actor, SIZE).draw(scale=scale, origin=origin)


def draw(data, style, scale=1.0, origin=0.0, **parameters):
    if isinstance(data, vtk.vtkImageData):
        parameters.setdefault("iso_values", 100)
    actor = vtkink.draw(data, style, size=(SIZE, SIZE), **parameters)
    return actor, picture(actor, scale, origin)


def blurred(drawn, width=16):
    """Means over squares."""
    height, length = drawn.shape
    return drawn.reshape(height // width, width, length // width, width).mean(axis=(1, 3))


def evenness(actor):
    """The mean distance to the nearest stipple on the side towards +z, of that in a hexagonal lattice."""
    points = numpy_support.vtk_to_numpy(actor.style.GetPiece(0).GetPoints().GetData()).astype(float)
    points = points[points[:, 2] > 0.6 * RADIUS]
    area = 2 * np.pi * RADIUS * 0.4 * RADIUS
    grid = {}
    cell = np.sqrt(area / len(points)) * 2
    for point in points:
        grid.setdefault(tuple((point // cell).astype(int)), []).append(point)
    nearest = []
    for key, inside in grid.items():
        around = np.concatenate([grid[other] for dx in (-1, 0, 1) for dy in (-1, 0, 1) for dz in (-1, 0, 1)
                                 if (other := (key[0] + dx, key[1] + dy, key[2] + dz)) in grid])  # fmt: skip
        distances = np.linalg.norm(np.array(inside)[:, None] - around[None], axis=2)
        nearest.extend(np.sort(distances, axis=1)[:, 1])
    return np.mean(nearest) / np.sqrt(2 * area / (np.sqrt(3) * len(points)))


# Dots of two pixels. Those of two thousandths of so small a picture are finer than its pixels and than the points of a volume.
IN_PIXELS = {"size_unit": "pixels"}


@pytest.fixture(scope="module")
def mesh_stipples():
    return draw(sphere(), "stipple", **IN_PIXELS)


@pytest.mark.parametrize("cells, options", [
    (24, {}), (48, {}), (96, {}), (48, {"spacing": (1.0, 1.0, 3.0)}), (48, {"noise": 0.03})])
@pytest.mark.one_build
def test_stipples_of_a_volume_are_as_those_of_its_mesh(mesh_stipples, cells, options):
    actor, drawn = draw(ball(cells, **options), "stipple", **IN_PIXELS)
    mesh_actor, of_mesh = mesh_stipples
    # 0.9 % at the most; of long voxels 7.8 %, for so many more samples cover the surface.
    assert drawn.sum() == pytest.approx(of_mesh.sum(), rel=0.1 if "spacing" in options else 0.02)
    assert np.abs(blurred(drawn) - blurred(of_mesh)).mean() < 0.05 * blurred(of_mesh).max()
    assert evenness(actor) == pytest.approx(evenness(mesh_actor), abs=0.05)
    # Hardly any ink beyond the rim.
    y, x = np.mgrid[:SIZE, :SIZE]
    beyond = np.hypot(x - SIZE / 2, y - SIZE / 2) > RADIUS * SIZE / 2 + 2
    assert drawn[beyond].sum() < 0.01 * drawn.sum()


@pytest.mark.one_build
def test_density_does_not_depend_on_the_number_of_voxels():
    counts = [draw(ball(cells), "stipple")[0].style.GetPiece(0).GetNumberOfPoints() for cells in (16, 32, 64)]
    assert max(counts) < 1.1 * min(counts)


def test_what_lies_behind_is_hidden():
    """Of two balls, one before the other, only the front one's stipples show, dark as they are alone."""
    z, y, x = np.meshgrid(*[np.linspace(-1, 1, 48)] * 3, indexing="ij")
    values = {}
    for name, balls in {"front": [(0.5, 0.4)], "both": [(0.5, 0.4), (-0.5, 0.3)]}.items():
        distance = np.min([np.sqrt(x * x + y * y + (z - middle) ** 2) - radius for middle, radius in balls], axis=0)
        values[name] = (200 / (1 + np.exp(distance / 0.02))).astype("f4")
    ink = {}
    for name, array in values.items():
        image = ball(48)
        image.GetPointData().SetScalars(numpy_support.numpy_to_vtk(array.ravel(), deep=True))
        for hides in (True, False):
            # Distance is relative to the range of depths.
            actor = draw(image, "stipple", surface_hides=hides, distance_enhancement=False, stipple_size=4,
                         pixels_per_stipple=30, smoothing=0, **IN_PIXELS)[0]  # fmt: skip
            ink[name, hides] = picture(actor).sum()
    assert ink["both", True] == pytest.approx(ink["front", True], rel=0.05)
    assert ink["both", False] > 1.2 * ink["both", True]


@functools.cache
def ink_of_ball(style):
    return draw(ball(32), style)[1].sum()


@pytest.mark.parametrize("scale, origin", [(1e-9, 0.0), (1e9, 0.0), (1.0, 1e5)])
@pytest.mark.one_build
def test_size_and_place_do_not_matter(scale, origin):
    data = ball(32, scale=scale, origin=origin)
    for style in ("stipple", "illustration"):
        drawn = draw(data, style, scale, origin)[1]
        assert drawn.sum() == pytest.approx(ink_of_ball(style), rel=0.03), style


def test_lines_and_stipples_register():
    _, both = draw(ball(48), "illustration")
    _, lines = draw(ball(48), "splatting-lines")
    _, stipples = draw(ball(48), "stipple", pixels_per_stipple=8)
    # Where there are lines there is ink, and what there is more are stipples on paper.
    assert both[lines > 0.9].mean() > 0.9
    assert both.sum() == pytest.approx(np.maximum(lines, stipples).sum(), rel=0.1)


@pytest.mark.one_build
def test_presets_differ_and_leave_what_is_given():
    few = {"number_of_surface_stipples": 50000}
    drawn = {name: draw(ball(32), "illustration", preset=name, **few)[1] for name in vtkink.styles()["illustration"].presets}
    assert list(drawn) == ["specimen", "bone", "skin", "organ", "vessel", "machine-part"]
    for name, one in drawn.items():
        assert 0.01 < one.mean() < 0.5, name
        assert name == "bone" or (one != drawn["bone"]).any()
    actor, _ = draw(ball(32), "illustration", preset="vessel", tau=0.9, **few)
    assert actor.style.GetParameter("Tau") == 0.9
    assert actor.style.GetParameter("StippleSize") == 2.0


def test_meshes_and_points_are_illustrated_too(tmp_path):
    mesh = sphere()
    cloud = vtk.vtkPolyData()
    cloud.SetPoints(mesh.GetPoints())
    of_mesh, of_cloud, of_volume = (draw(data, "illustration")[1] for data in (mesh, cloud, ball(96)))
    for other in (of_cloud, of_volume):
        assert other.sum() == pytest.approx(of_mesh.sum(), rel=0.12)
        assert np.abs(blurred(other) - blurred(of_mesh)).mean() < 0.05


@pytest.mark.one_build
def test_subdivision_is_the_same_in_a_picture_of_any_size():
    def count(size, **parameters):
        return vtkink.draw(ball(32), "splatting-lines", size=(size, size), iso_values=100,
                           **parameters).style.GetPiece(0).GetNumberOfPoints()  # fmt: skip

    # Of 32 voxels each measures 31 thousandths: until they are no more than 4.
    assert count(100) == count(400) == count(400, subdivision=8)
    coarse = count(400, subdivision=1)
    assert count(400) == pytest.approx(64 * coarse, rel=0.1)
    assert count(100, subdivision=2) == pytest.approx(4 * coarse, rel=0.1)


OUTER, INNER = 0.85, 0.4


def nested(count=64):
    """Two materials, the one around the other, which is no ball, so that lines lie within it."""
    z, y, x = np.meshgrid(*[np.linspace(-1, 1, count)] * 3, indexing="ij")
    step = lambda distance: 1 / (1 + np.exp(distance * count))
    box = np.max(np.abs([x + 0.2 * y, y - 0.2 * x, z]), axis=0) - INNER
    values = 60 * step(np.sqrt(x * x + y * y + z * z) - OUTER) + 140 * step(box)
    image = ball(4)
    image.SetDimensions([count] * 3)
    image.SetSpacing([2 / (count - 1)] * 3)
    image.GetPointData().SetScalars(numpy_support.numpy_to_vtk(values.astype("f4").ravel(), deep=True))
    return image


def test_see_through_shows_the_inner_surface_within_the_outline_of_the_outer_one():
    image = nested()
    y, x = np.mgrid[:SIZE, :SIZE]
    distance = np.hypot(x - SIZE / 2, y - SIZE / 2) / (SIZE / 2)
    at_inner, at_rim = distance < 0.75 * INNER * np.sqrt(2), np.abs(distance - OUTER) < 0.03
    between = (distance > 1.1 * INNER * np.sqrt(2)) & (distance < 0.85 * OUTER)
    inner = draw(image, "illustration", iso_values=130)[1]
    outer = draw(image, "illustration", iso_values=30)[1]
    both = draw(image, "illustration", iso_values=130, outer_iso_value=30, see_through=True)[1]
    # The inner one as dark as alone, where it is; nothing of the outer one but a little more ink.
    assert both[inner > 0.9].mean() > 0.9
    assert both[at_inner].sum() < 1.1 * inner[at_inner].sum() + 0.05 * at_inner.sum()
    # The outer one fainter, most of all where it faces the viewer, but its outline is there all around.
    assert both[between].mean() < 0.35 * outer[between].mean()
    assert 0.1 * outer[at_rim].sum() < both[at_rim].sum() < 0.8 * outer[at_rim].sum()
    angle = np.arctan2(y - SIZE / 2, x - SIZE / 2)
    for start in np.arange(-np.pi, np.pi, np.pi / 6):
        sector = at_rim & (angle >= start) & (angle < start + np.pi / 6)
        assert both[sector].max() > 0.2, start
    # Nothing beyond.
    assert both[distance > OUTER + 0.05].sum() < 0.01 * both.sum()


def test_see_through_has_an_ink_of_its_own():
    image = nested()
    few = {"see_through": True, "iso_values": 130, "subdivision": 2, "number_of_surface_stipples": 50000}
    plain = draw(image, "illustration", **few)[1]
    for strength in (0.0, 1.0):
        drawn = draw(image, "illustration", **few, outer_strength=strength)[1]
        assert (drawn.sum() > plain.sum()) == (strength == 1.0)
    # Red ink takes no red light away, but for pixels that it shares with black.
    alone = draw(image, "illustration", iso_values=130)[1]
    red = draw(image, "illustration", iso_values=130, outer_ink_color="red")[1]
    # 0.17 %
    assert (np.abs(red - alone) > 0.06).mean() < 0.004
    with pytest.raises(ValueError, match="two clear boundaries"):
        vtkink.draw(ball(32), "illustration", see_through=True)


@pytest.mark.parametrize("style", ["stipple", "illustration"])
@pytest.mark.one_build
def test_hard_cases(style):
    with pytest.raises(ValueError, match="(different finite values|nothing to draw)"):
        vtkink.draw(np.ones((8, 8, 8)), style)
    with pytest.raises(ValueError, match="(no surface|no stipple)"):
        vtkink.draw(ink_files.blob(), style, iso_values=5000)
    holes = ink_files.blob().astype("f4")
    holes[10:14, :, 20] = np.nan
    assert vtkink.draw(holes, style).style.GetPiece(0).GetNumberOfPoints() > 100
    thin = np.zeros((3, 40, 40), "f4")
    thin[1, 8:32, 8:32] = 100
    image = ball(4)
    image.SetDimensions(40, 40, 3)
    image.SetSpacing(1, 1, 1000)
    image.GetPointData().SetScalars(numpy_support.numpy_to_vtk(thin.ravel(), deep=True))
    assert vtkink.draw(image, style, iso_values=50).style.GetPiece(0).GetNumberOfPoints() > 100


def test_the_command_line_illustrates_by_default(ink, tmp_path):
    file = tmp_path / "ball.nrrd"
    ink_files.write_nrrd(file, ink_files.blob())
    for name, options in {"default": [], "named": ["--style", "illustration"]}.items():
        result = ink("render", file, "-o", tmp_path / f"{name}.png", "--size", "200x200", *options)
        assert result.code == 0, result
    first, second = (ink_files.read_png(tmp_path / f"{name}.png") for name in ("default", "named"))
    assert (first == second).all()
    assert (first < 100).mean() > 0.01


@pytest.mark.one_build
def test_bone_is_the_surface_within(ink, tmp_path):
    file = tmp_path / "nested.nrrd"
    array = numpy_support.vtk_to_numpy(nested(48).GetPointData().GetScalars()).reshape(48, 48, 48)
    ink_files.write_nrrd(file, array)

    # Marks are not what this is of.
    stipples = ("--stipples", 5000)

    def value(*options):
        few = () if "--style" in options else stipples
        result = ink("render", file, "-o", tmp_path / "out.png", "--size", 100, "--subdivision", 1, *few, *options)
        assert result.code == 0, result
        return [float(number) for number in re.findall(r"iso-value (\S+):", result.err)]

    outer, inner = value(), value("--preset", "bone")
    assert 20 < outer[0] < 40 and 100 < inner[0] < 160
    assert value("--preset", "bone", "--iso-choice", "outermost") == value("--preset", "skin") == outer
    for style in ("splatting-lines", "contours"):
        assert value("--style", style, "--iso-choice", "inner") == inner
    assert value("--preset", "bone", "--iso", 50) == []
    assert vtkink.draw(nested(), preset="bone", subdivision=1, number_of_surface_stipples=5000).style.GetNote(0).startswith("iso-value 1")
    # A turntable keeps it.
    frames = ("--frames", 2, "-o", tmp_path / "f%d.png")
    result = ink("render", file, "--size", 64, "--preset", "bone", *stipples, *frames)
    assert f"iso-value {inner[0]:g}" in result.err, result


def test_the_command_line_sees_through(ink, tmp_path):
    file = tmp_path / "nested.nrrd"
    array = numpy_support.vtk_to_numpy(nested(48).GetPointData().GetScalars()).reshape(48, 48, 48)
    ink_files.write_nrrd(file, array)
    result = ink("render", file, "-o", tmp_path / "both.png", "--size", "200x200", "--see-through")
    assert result.code == 0, result
    assert "outer iso-value " in result.err and "inner iso-value " in result.err
    result = ink("render", file, "-o", tmp_path / "given.png", "--size", "200x200", "--iso", 130, "--outer-iso", 30)
    assert result.code == 0, result
    both, given = (1 - ink_files.read_png(tmp_path / f"{name}.png")[..., 0] / 255 for name in ("both", "given"))
    # The iso-values that it chooses are nearly these: the same tones, of other dots.
    assert np.abs(blurred(both, 20) - blurred(given, 20)).mean() < 0.03 * blurred(given, 20).max()


def test_values_color_stipples(picture, volume_file):
    small = ["--iso", 100, "--stipples", 20000]
    spread = lambda image: np.ptp(image.astype(int), axis=-1).max()
    assert spread(picture(volume_file, *small)) == 0
    assert spread(picture(volume_file, *small, "--color-map", "red,blue")) > 100


def test_colors_of_the_array_that_is_drawn_are_said_to_be_one(ink, tmp_path):
    ink_files.write_nrrd(tmp_path / "ball.nrrd", ink_files.blob())
    small = ["--iso", 100, "--size", "100x100", "--stipples", 5000, "--color-map", "viridis", "-o", tmp_path / "ball.png"]
    result = ink("render", tmp_path / "ball.nrrd", *small)
    assert result.code == 0
    assert "--color-by" in result.err


def test_each_label_has_a_color_also_the_first(picture, tmp_path):
    labels = (ink_files.blob() > 100) * np.where(np.arange(32) < 16, 3, 90).astype(np.uint8)
    ink_files.write_nrrd(tmp_path / "labels.nrrd", labels)
    image = picture(tmp_path / "labels.nrrd", "--color-map", "red,blue", "--stipples", 20000).astype(int)
    redness = image[..., 0] - image[..., 2]
    assert (redness > 80).sum() > 200
    assert (redness < -80).sum() > 200
    # In order, however far ids lie apart, and whatever is drawn of them.
    ids = np.where(labels == 90, 2035, labels.astype(np.int16) * 4)
    ink_files.write_nrrd(tmp_path / "labels.nrrd", ids)
    options = ("--color-map", "red,blue", "--stipples", 20000)
    assert (picture(tmp_path / "labels.nrrd", *options) == image).all()
    assert (picture(tmp_path / "labels.nrrd", *options, "--color-range", "0,24") != image).any()
