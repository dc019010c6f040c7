# SPDX-License-Identifier: BSD-3-Clause
"""Contours of meshes and volumes as ink: where it is, how much of it, what is hidden; hard cases."""

import functools
import importlib
import pathlib
import subprocess
import sys

import numpy as np
import pytest

import ink_files
from style_scene import StyleScene

vtkink = pytest.importorskip("vtkink")
vtk = vtkink.vtk
numpy_support = importlib.import_module(f"{vtkink.VTK_PACKAGE}.util.numpy_support")

ROOT = pathlib.Path(__file__).resolve().parents[2]
SIZE = 400
# Four pixels, the same at all depths.
PLAIN = {"line_width": 10, "depth_width": 0, "shortest_part": 2}
RADIUS = 0.8
ISO = (1, 1, 1)


def sphere(radius=RADIUS, middle=(0, 0, 0)):
    source = vtk.vtkSphereSource()
    source.SetRadius(radius)
    source.SetCenter(middle)
    source.SetThetaResolution(120)
    source.SetPhiResolution(60)
    source.Update()
    return source.GetOutput()


def cube():
    source = vtk.vtkCubeSource()
    source.Update()
    return source.GetOutput()


def ball(cells=48, scale=1.0, origin=0.0):
    """A distance from a middle, as an image of the cube of side 2."""
    z, y, x = np.meshgrid(*[np.linspace(-1, 1, cells)] * 3, indexing="ij")
    image = vtk.vtkImageData()
    image.SetDimensions([cells] * 3)
    image.SetSpacing([2 * scale / (cells - 1)] * 3)
    image.SetOrigin([origin - scale] * 3)
    values = (100 * (1 + RADIUS - np.sqrt(x * x + y * y + z * z))).astype("f4")
    image.GetPointData().SetScalars(numpy_support.numpy_to_vtk(values.ravel(), deep=True))
    return image


def draw(data, direction=(0, 0, 1), scale=1.0, origin=0.0, style="contours", **parameters):
    """Darkness, 0 to 1, from below up, of what is seen along a direction in a frame of two units."""
    plain = PLAIN if style == "contours" and "preset" not in parameters else {}
    actor = vtkink.draw(data, style, size=(SIZE, SIZE), **{**plain, **parameters})
    return StyleScene(actor, SIZE).draw(direction, scale, origin)


def pixel_of(points, direction):
    """Where points are in the picture, x and y."""
    back = np.array(direction) / np.linalg.norm(direction)
    right = np.cross((0, 1, 0), back)
    right /= np.linalg.norm(right)
    points = np.atleast_2d(np.array(points, float))
    return np.stack([points @ right, points @ np.cross(back, right)], axis=1) * SIZE / 2 + SIZE / 2


def edges_of_cube(direction):
    """The twelve edges, as pairs of pixels: those with a corner that is farthest from the viewer come last."""
    corners = np.array([(x, y, z) for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)])
    edges = [(a, b) for a in range(8) for b in range(a) if np.abs(corners[a] - corners[b]).sum() == 1]
    farthest = np.argmin(corners @ np.array(direction))
    edges.sort(key=lambda edge: farthest in edge)
    pixels = pixel_of(corners, direction)
    return [(pixels[a], pixels[b]) for a, b in edges]


def ink_along(drawn, edge):
    """The share of an edge that has ink, but for its ends."""
    shares = np.linspace(0.05, 0.95, 200)[:, None]
    x, y = ((1 - shares) * edge[0] + shares * edge[1]).T
    return (drawn[np.floor(y).astype(int), np.floor(x).astype(int)] > 0.5).mean()


def length(edge):
    return np.linalg.norm(edge[0] - edge[1])


def assert_circle(drawn, radius, width=4.0):
    """One closed circle of ink."""
    y, x = np.mgrid[:SIZE, :SIZE] + 0.5 - SIZE / 2
    distance = np.hypot(x, y)
    assert drawn.sum() == pytest.approx(2 * np.pi * radius * width, rel=0.03)
    assert (drawn * distance).sum() / drawn.sum() == pytest.approx(radius, abs=0.3)
    assert drawn[np.abs(distance - radius) > width / 2 + 1.5].max() == 0
    assert drawn[np.abs(distance - radius) < width / 2 - 1].min() > 0.9


@pytest.mark.parametrize("direction", [(0, 0, 1), (0.3, -0.2, 1), (1, 0.5, 0.2)])
def test_a_sphere_is_one_circle(direction):
    assert_circle(draw(sphere(), direction), RADIUS * SIZE / 2)


@pytest.mark.one_build
def test_a_ball_of_voxels_is_the_same_circle():
    assert_circle(draw(ball(), iso_values=100), RADIUS * SIZE / 2)
    assert_circle(draw(ball(), iso_values=100, line_width=20), RADIUS * SIZE / 2, 8)


# A point in each cell: in image space each becomes a polygon, and by default there are 64 times as many.
COARSE = {"iso_values": 0, "subdivision": 1}


@pytest.mark.parametrize("data, method", [("sphere", "image-space"), ("sphere", "toon"), ("ball", "image-space"), ("ball", "toon"), ("ball", "voxel-segments")])
def test_published_methods_draw_the_circle(data, method):
    """Where exact chains have it, and nowhere else; each as broad as it is."""
    image = ball()
    values = numpy_support.vtk_to_numpy(image.GetPointData().GetScalars())
    values[:] = np.tanh((values - 100) / 8)  # a boundary, blurred
    options = COARSE if method == "image-space" else {"iso_values": 0}
    drawn = draw(image if data == "ball" else sphere(), method=method, largest_cosine=0.3, **options)
    y, x = np.mgrid[:SIZE, :SIZE] + 0.5 - SIZE / 2
    distance = np.hypot(x, y)
    radius = RADIUS * SIZE / 2
    # Lines in image space reach past the surface by half their width, and voxels' centers lie off it by half a voxel.
    inner, outer = {"image-space": (1, 3.5), "toon": (radius * (1 - 0.91**0.5) + 2, 2), "voxel-segments": (22, 12)}[method]
    assert drawn[(distance < radius - inner) | (distance > radius + outer)].max() < 0.1
    around = (np.arctan2(y, x) * 18 / np.pi).astype(int)
    ring = np.abs(distance - radius) < 12
    least = 0.3 if method == "voxel-segments" else 1.0
    assert all(drawn[ring & (around == part)].max() >= 0.9 * least for part in range(-17, 18))
    if method == "toon":
        assert drawn.sum() == pytest.approx(0.09 * np.pi * radius**2, rel=0.08)


def test_segments_through_voxels_need_an_image():
    with pytest.raises(ValueError, match="need an image, found a mesh"):
        draw(sphere(), method="voxel-segments")


@pytest.mark.parametrize("pixels", [0.1, 0.3, 0.7])
@pytest.mark.one_build
def test_lines_of_less_than_a_pixel_fade_evenly(pixels):
    """Along the circle each tenth of it has the ink of its length. Measured: 3 % less or more."""
    drawn = draw(sphere(), line_width=1000 * pixels / SIZE)
    y, x = np.mgrid[:SIZE, :SIZE] + 0.5 - SIZE / 2
    part = np.floor((np.arctan2(y, x) / (2 * np.pi) + 0.5) * 10).astype(int).clip(0, 9)
    ink = np.bincount(part.ravel(), drawn.ravel())
    np.testing.assert_allclose(ink, 2 * np.pi * RADIUS * SIZE / 2 * pixels / 10, rtol=0.05)


@pytest.mark.parametrize("scale, origin", [(1e-9, 0.0), (1e9, 0.0), (1.0, 1e5)])
@pytest.mark.one_build
def test_size_and_place_do_not_matter(scale, origin):
    assert_circle(draw(ball(scale=scale, origin=origin), scale=scale, origin=origin, iso_values=100), RADIUS * SIZE / 2)


def test_a_cube_shows_nine_edges():
    edges = edges_of_cube(ISO)
    drawn = draw(cube(), ISO)
    assert [ink_along(drawn, edge) for edge in edges] == [1] * 9 + [0] * 3
    # The outline's edges are silhouettes and creases, and drawn once: the smooth sides of lines are no darker.
    assert drawn.sum() == pytest.approx(4 * sum(map(length, edges[:9])), rel=0.02)
    # Without creases, what separates faces that are seen from those that are not.
    outline = draw(cube(), ISO, creases=False)
    assert outline.sum() == pytest.approx(4 * sum(map(length, edges[:9])) * 6 / 9, rel=0.05)


def test_hidden_edges_are_dashed_or_faint():
    edges = edges_of_cube(ISO)
    dashed = draw(cube(), ISO, dash_length=20, gap_length=20)
    assert [ink_along(dashed, edge) for edge in edges[:9]] == [1] * 9
    assert np.mean([ink_along(dashed, edge) for edge in edges[9:]]) == pytest.approx(0.5, abs=0.12)
    faint = draw(cube(), ISO, hidden_opacity=0.4)
    for begin, end in edges[9:]:
        x, y = np.floor(0.3 * begin + 0.7 * end).astype(int)
        assert faint[y, x] == pytest.approx(0.4, abs=0.03)


def test_what_lies_behind_is_hidden():
    both = vtk.vtkAppendPolyData()
    both.AddInputData(sphere(0.5))
    both.AddInputData(sphere(0.3, (0, 0, -0.6)))
    both.Update()
    assert_circle(draw(both.GetOutput()), 0.5 * SIZE / 2)
    assert draw(both.GetOutput(), hidden_lines="faint").sum() > 1.1 * draw(both.GetOutput()).sum()


def test_density_draws_the_longest_lines():
    """Of three circles, whose lengths are 4, 2 and 1 sevenths of all."""
    balls = vtk.vtkAppendPolyData()
    for radius, x in ((0.4, -0.5), (0.2, 0.2), (0.1, 0.6)):
        balls.AddInputData(sphere(radius, (x, 0, 0)))
    balls.Update()
    whole = draw(balls.GetOutput())
    for density, sevenths in ((1, 7), (0.9, 7), (0.8, 6), (0.6, 6), (0.5, 4), (0.01, 4), (0, 0)):
        drawn = draw(balls.GetOutput(), density=density)
        assert drawn.sum() == pytest.approx(whole.sum() * sevenths / 7, rel=0.03), density
        assert (drawn <= whole).all()


def test_a_texture_is_drawn_along_lines(tmp_path, ink):
    """Half of each repetition is ink, of which there is a whole number around a circle."""
    stripes = vtk.vtkImageData()
    stripes.SetDimensions(64, 2, 1)
    values = np.where(np.arange(128) % 64 < 32, 255, 0).astype("u1")
    stripes.GetPointData().SetScalars(numpy_support.numpy_to_vtk(values, deep=True))
    file = tmp_path / "stripes.png"
    writer = vtk.vtkPNGWriter()
    writer.SetInputData(stripes)
    writer.SetFileName(str(file))
    writer.Write()
    whole, half = (draw(sphere(), line_width=20, **texture) for texture in ({}, {"texture": str(file), "texture_length": 10}))
    assert half.sum() == pytest.approx(whole.sum() / 2, rel=0.03)
    assert (half <= whole + 0.01).all()
    # 1005 pixels are 12.6 times 10 widths of 8 pixels.
    angles = np.arange(0, 2 * np.pi, 0.002)
    along = half[tuple((SIZE / 2 + RADIUS * SIZE / 2 * part(angles)).astype(int) for part in (np.sin, np.cos))] > 0.5
    assert (along != np.roll(along, 1)).sum() == 2 * 13
    result = ink("render", ROOT / "Data/engine.nii.gz", "--style", "contours", "--texture", tmp_path / "none.png", "-o", tmp_path / "a.png")
    assert result.code != 0 and "expected an image file" in result.error and "none.png" in result.error
    with pytest.raises(ValueError, match="expected an image file"):
        draw(sphere(), texture=str(ROOT / "README.md"))


def test_borders_of_an_open_mesh():
    source = vtk.vtkPlaneSource()
    source.SetResolution(8, 8)
    source.Update()
    drawn = draw(source.GetOutput())
    assert drawn.sum() == pytest.approx(4 * 4 * SIZE / 2, rel=0.03)
    assert drawn[SIZE // 4 + 5 : -SIZE // 4 - 5, SIZE // 4 + 5 : -SIZE // 4 - 5].max() == 0
    assert draw(source.GetOutput(), borders=False).sum() == 0


def test_what_leaves_the_image_has_a_line_along_the_cut():
    half = ball(49)
    half.SetDimensions(49, 49, 25)
    values = numpy_support.vtk_to_numpy(ball(49).GetPointData().GetScalars())[: 49 * 49 * 25]
    half.GetPointData().SetScalars(numpy_support.numpy_to_vtk(values, deep=True))
    for cut in ("rim", "cap"):
        # From the side, the flat one is an edge.
        drawn = draw(half, (1, 0, 0), iso_values=100, cut=cut)
        assert drawn.sum() == pytest.approx(4 * (np.pi + 2) * RADIUS * SIZE / 2, rel=0.06), cut


@pytest.mark.one_build
def test_parts_are_left_out():
    z, y, x = np.meshgrid(*[np.linspace(-1, 1, 40)] * 3, indexing="ij")
    balls = [radius - np.sqrt((x - middle) ** 2 + y * y + z * z) for middle, radius in ((-0.4, 0.45), (0.6, 0.25))]
    both, one = (vtkink.draw(np.maximum(*balls), "contours", iso_values=0.0, largest_parts=parts).GetBounds() for parts in (0, 1))
    assert both[1] == pytest.approx(39 * (1 + 0.85) / 2, abs=0.1)
    assert one[1] == pytest.approx(39 * (1 + 0.05) / 2, abs=0.1) and one[0] == both[0]


@pytest.mark.one_build
def test_presets_differ():
    drawn = {name: draw(cube(), ISO, preset=name) for name in vtkink.styles()["contours"].presets}
    assert list(drawn) == ["pen", "technical", "hidden-lines", "glass", "brush"]
    for name, one in drawn.items():
        assert 0.002 < one.mean() < 0.2, name
        assert all((one != other).any() for key, other in drawn.items() if key != name), name


@pytest.mark.one_build
def test_volumes_that_are_no_balls():
    wavelet = vtk.vtkRTAnalyticSource()
    wavelet.Update()
    for data, scale, direction in ((wavelet.GetOutput(), 14, (0, 0.3, 1)), (vtkink.read(ROOT / "Data/bonsai.nii.gz"), 130, (0, -1, 0.1))):
        middle = data.GetCenter()
        data.SetOrigin([a - b for a, b in zip(data.GetOrigin(), middle)])
        drawn = draw(data, direction, scale=scale, line_width=3)
        assert 0.01 < drawn.mean() < 0.15


def bits(inside):
    """A volume of 0 and 1, in the cube of side 2."""
    image = vtk.vtkImageData()
    image.SetDimensions(inside.shape[::-1])
    step = 2 / max(inside.shape)
    image.SetSpacing([step] * 3)
    image.SetOrigin([-step * (n - 1) / 2 for n in image.GetDimensions()])
    image.GetPointData().SetScalars(numpy_support.numpy_to_vtk(inside.astype("u1").ravel(), deep=True))
    return image


def shell(size, outer, thickness):
    """The walls of a box of voxels."""
    walls = np.ones((outer,) * 3)
    walls[(slice(thickness, -thickness),) * 3] = 0
    return np.pad(walls, (size - outer) // 2)


@pytest.mark.parametrize(
    "inside", [shell(12, 8, 1), shell(16, 12, 2), np.pad(np.ones((6, 6, 6)), 3), np.pad(np.ones((10, 1, 10)), ((3, 3), (7, 8), (3, 3)))],
    ids=["walls-of-one", "walls-of-two", "box", "plate"],
)  # fmt: skip
@pytest.mark.parametrize("direction", [(0.04, 0.02, 1), (0.3, 0.2, 1)])
def test_bits_have_a_whole_outline(inside, direction):
    """Their normals are smoothed and their points are not: silhouettes by these lie behind the surface's edges."""
    drawn = draw(bits(inside), direction)
    filled = draw(bits(inside), direction, style="splatting-lines", tau=0.8, phi=0, paper_color="black")
    # Of the outline's points each has ink within a voxel.
    covered = filled > 0.5
    inner = covered.copy()
    for axis in (0, 1):
        for step in (-1, 1):
            inner &= np.roll(covered, step, axis)
    rim = np.argwhere(covered & ~inner)
    ink = np.argwhere(drawn > 0.5)
    assert len(ink) > 100
    voxel = SIZE / max(inside.shape)
    nearest = np.array([np.hypot(*(ink - point).T).min() for point in rim])
    assert (nearest < voxel).mean() > 0.97


@pytest.mark.parametrize("style", ["illustration", "splatting-lines", "stipple"])
@pytest.mark.parametrize("data", [sphere, ball], ids=["mesh", "image"])
def test_silhouettes_are_drawn_over_other_styles(style, data):
    """A closed ring of ink of the width that is asked for, in the style's ink, and nothing else than that is new."""
    y, x = np.mgrid[:SIZE, :SIZE] + 0.5 - SIZE / 2
    away = np.abs(np.hypot(x, y) - RADIUS * SIZE / 2)
    # Contours are exact: no more points than show where they lie.
    few = {"number_of_samples": 20000} if style != "stipple" else {}
    few = {"iso_values": 100.0, "subdivision": 1} if data is ball else few
    plain = draw(data(), style=style, **few)
    outlined = draw(data(), style=style, silhouette_width=20, silhouette_depth_width=0, **few)
    assert outlined[away < 3].min() > 0.9
    assert (outlined != plain)[away > 6].mean() < 0.002
    colored = draw(data(), style=style, silhouette_width=20, ink_color="white", **few)
    assert colored[away < 3].max() < 0.1


@functools.cache
def plainly_drawn(style):
    """A ball, and its picture without silhouettes."""
    image = ball()
    values = numpy_support.vtk_to_numpy(image.GetPointData().GetScalars())
    values[:] = np.tanh((values - 100) / 8)
    return image, draw(image, style=style, **COARSE)


@pytest.mark.parametrize("method", ["voxel-segments", "image-space", "toon"])
@pytest.mark.parametrize("style", ["illustration", "splatting-lines", "stipple"])
def test_published_silhouettes_are_drawn_over_other_styles(style, method):
    """Ink is added around the circle, and within it nowhere."""
    image, plain = plainly_drawn(style)
    y, x = np.mgrid[:SIZE, :SIZE] + 0.5 - SIZE / 2
    away = np.abs(np.hypot(x, y) - RADIUS * SIZE / 2)
    outlined = draw(image, style=style, **COARSE, silhouette_method=method, silhouette_width=12)
    added = outlined - plain
    # Half of the least that was measured: 3426, 874 and 66.
    assert added[away < 6].sum() > {"voxel-segments": 1700, "image-space": 430, "toon": 33}[method]
    assert (np.abs(added) > 0.05)[away > 24].mean() < 0.002


def test_silhouettes_follow_the_viewer_and_hide_behind_their_surface():
    both = vtk.vtkAppendPolyData()
    both.AddInputData(sphere(0.5))
    both.AddInputData(sphere(0.3, (0, 0, -0.6)))
    both.Update()
    alone, hidden = (draw(mesh, style="splatting-lines", tau=0.8, phi=0, silhouettes=True, silhouette_width=10)
                     for mesh in (sphere(0.5), both.GetOutput()))  # fmt: skip
    assert hidden.sum() == pytest.approx(alone.sum(), rel=0.05)
    beside = draw(both.GetOutput(), (1, 0, 0), style="splatting-lines", tau=0.8, phi=0, silhouettes=True, silhouette_width=10)
    assert beside.sum() > 1.2 * alone.sum()


@pytest.mark.one_build
def test_the_same_with_one_thread_and_two(ink, tmp_path):
    file = tmp_path / "ball.nrrd"
    ink_files.write_nrrd(file, ink_files.blob())
    pictures = []
    for threads in (1, 2):
        out = tmp_path / f"{threads}.png"
        result = ink("render", file, "--style", "contours", "--iso", 100, "--line-width", 10, "-q", "--size", "200x200", "-o", out,
                     env={"VTK_SMP_MAX_THREADS": str(threads)})  # fmt: skip
        assert (result.code, result.err) == (0, ""), result
        pictures.append(ink_files.read_png(out))
    assert (pictures[0] == pictures[1]).all()
    assert 0.005 < (pictures[0][..., 0] < 128).mean() < 0.1


def test_what_is_wrong_is_said(ink, tmp_path):
    cloud = vtk.vtkPolyData()
    cloud.SetPoints(sphere().GetPoints())
    for data, words in ((cloud, "points without polygons"), (vtk.vtkPolyData(), "no points"), (vtk.vtkTable(), "vtkTable"),
                        (np.ones((8, 8, 8)), "different finite values")):  # fmt: skip
        with pytest.raises(ValueError, match=words):
            vtkink.draw(data, "contours")
    with pytest.raises(ValueError, match="no surface"):
        vtkink.draw(ink_files.blob(), "contours", iso_values=5000)
    file = tmp_path / "ball.nrrd"
    ink_files.write_nrrd(file, ink_files.blob())
    result = ink("render", file, "--style", "contours", "--creases", "-o", tmp_path / "a.png")
    assert result.code != 0 and "--creases" in result.error and "a volume" in result.error


@pytest.mark.parametrize("name", ["contours", "volume_contours"])
def test_the_examples_draw(tmp_path, name):
    nifti = ROOT / "Data" / "engine.nii.gz"
    done = subprocess.run([sys.executable, ROOT / f"Python/Examples/{name}.py", nifti], cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == 0, done
    assert 0.005 < (ink_files.read_png(tmp_path / f"{name}.png") < 128).mean() < 0.2


@pytest.mark.one_build
def test_silhouettes_of_an_image_are_those_of_the_analytic_sphere():
    """Its circle: where p.e is the square of the radius. Cells measure 0.043."""
    contours = vtkink.vtkInkContours()
    contours.SetInputData(ball())
    contours.SetValue(0, 100)
    eye = np.array((1.0, 2.0, 4.0))
    contours.SetEyeToPosition()
    contours.SetEyePosition(eye)
    contours.Update()
    lines = contours.GetOutput()
    assert lines.GetNumberOfLines() == 1
    points = numpy_support.vtk_to_numpy(lines.GetPoints().GetData()).astype(float)
    assert np.abs(np.linalg.norm(points, axis=1) - RADIUS).max() < 0.003
    assert np.abs(points @ eye - RADIUS**2).max() / np.linalg.norm(eye) < 0.005
