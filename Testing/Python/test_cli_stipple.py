# SPDX-License-Identifier: BSD-3-Clause
"""`ink render --style stipple`: each option moves the ink the right way, and wrong ones are refused in one line."""

import os

import numpy as np
import pytest

import ink_files

pytestmark = pytest.mark.one_build


@pytest.fixture
def stippled(picture):
    """Ink, 0 (none) to 1, of a stipple drawing."""

    def render(file, *arguments, paper=255, fits=True):
        image = picture(file, "--style", "stipple", *arguments)
        assert not fits or (image[0, 0] == paper).all(), "the corner is paper"
        return np.abs(image[..., :3].astype(int) - paper).mean(axis=2) / 255

    return render


@pytest.fixture
def refused(ink, tmp_path):
    """Runs a rendering that has to fail and returns its message; the old picture has to stay."""

    def run(code, *arguments):
        out = tmp_path / "kept" / "out.png"
        out.parent.mkdir(exist_ok=True)
        out.write_bytes(b"an old picture")
        result = ink("render", *arguments, "-o", out)
        assert (result.code, result.out) == (code, ""), result
        assert out.read_bytes() == b"an old picture"
        assert os.listdir(out.parent) == ["out.png"], "a temporary file is left"
        return result.error

    return run


def colorfulness(image):
    image = image[..., :3].astype(int)
    return (image.max(axis=2) - image.min(axis=2)).mean()


def test_illustrations_are_the_default(picture, volume_file):
    default = picture(volume_file, "--iso", 100)
    assert (default == picture(volume_file, "--iso", 100, "--style", "illustration")).all()
    assert (default != picture(volume_file, "--iso", 100, "--style", "stipple")).any()


def test_same_stipples_on_any_number_of_threads(ink, volume_file, tmp_path):
    pictures = []
    for threads in ("1", "2"):
        out = tmp_path / f"{threads}.png"
        result = ink("render", volume_file, "--style", "stipple", "--size", "150x150", "-q", "-o", out,
                     env={"VTK_SMP_MAX_THREADS": threads})
        assert result.code == 0, result
        pictures.append(out.read_bytes())
    assert pictures[0] == pictures[1]


@pytest.mark.parametrize("preset", ["anatomy", "Bone", "soft-tissue", "engineering", "as-published"])
def test_presets_draw_on_white(stippled, volume_file, mesh_file, preset):
    for file in (volume_file, mesh_file):
        ink = stippled(file, "--preset", preset)
        # On a mesh, whose shade has a stipple a pixel as published, up to the ball's part of the picture.
        most = 0.65 if preset == "as-published" else 0.5
        assert 0.01 < ink.mean() < most and ink.max() > 0.4


def test_white_on_black(stippled, volume_file):
    assert 0.01 < stippled(volume_file, "--preset", "plate-white-on-black", paper=0).mean() < 0.5


def test_colors_decide_what_stipples_show(stippled, picture, volume_file):
    """On paper darker than the ink they are where the light falls: from the front, in the middle."""
    middle = (slice(80, 110), slice(70, 100))
    light = ["--light", "0,0", "--iso", 100, "--silhouette", "off"]
    black = stippled(volume_file, *light)
    white = stippled(volume_file, *light, "--ink-color", "white", "--paper-color", "black", paper=0)
    assert white[middle].mean() / white.mean() > 2 * black[middle].mean() / black.mean()
    page = picture(volume_file, "--style", "stipple", "--ink-color", "navy", "--paper-color", "#ffeedd")
    assert tuple(page[0, 0]) == (255, 238, 221)
    assert ((page[..., 0] < 60) & (page[..., 2] > 100)).any()


@pytest.mark.parametrize("option, low, high", [
    ("--gradient", 0, 1), ("--sharpness", 1, 0), ("--interior", 1, 0), ("--boundary", "0.2,0.2,1", "2,2,1"),
    ("--silhouette", "0.1,0,1", "1,2,1"), ("--silhouette", "off", "1,2,0.5"), ("--resolution", "-2,3", "off"),
    ("--lighting", "0.2", "off"), ("--interior-curve", "4,0", "off"), ("--distance-curve", "on", "1,1"),
    ("--value-effect", 1, 0), ("--pixels-per-stipple", 20, 3), ("--stipple-size", 1, 3), ("--percentile", 99, 80),
    ("--threshold", 55, 5), ("--facing-angle", 30, 180), ("--window", "150,200", "20,200")])
def test_more_ink(stippled, volume_file, option, low, high):
    low, high = (stippled(volume_file, "--stipple-source", "volume", option, value).mean() for value in (low, high))
    assert low < high - 0.001


@pytest.mark.parametrize("option, value", [
    ("--orientation", 1), ("--distance", 0.9), ("--seed", 7), ("--max-stipples", 2), ("--max-stipples", "projected"),
    ("--parts", "intensity"), ("--gradient-weighting", "inverse-distance"), ("--parts", "probability"), ("--light", "60,0"), ("--distance-curve", "2,0.5")])
def test_other_options_change_the_stipples(stippled, volume_file, option, value):
    assert (stippled(volume_file) != stippled(volume_file, option, value)).any()


def test_light_comes_from_its_side(stippled, volume_file):
    left, right = (stippled(volume_file, "--iso", 100, "--light", light) for light in ("-80,0", "80,0"))
    ratio = lambda ink: ink[:, 45:95].sum() / ink[:, 95:145].sum()
    assert ratio(left) < 0.8 * ratio(right)


def test_projected_lists_are_long_enough(stippled, volume_file, mesh_file):
    """With shorter ones stipples have to grow to keep the gray; the mesh's polygons are small enough for these."""
    for file, zoom, source in ((volume_file, 0.6, ["--stipple-source", "volume"]), (mesh_file, 1, [])):
        published = ["--zoom", zoom, "--preset", "as-published", *source]
        grown, kept = ([stippled(file, *published, *lists, *way).mean() for way in ([], ["--no-grow-with-zoom"])]
                       for lists in (["--max-stipples", 1], ["--max-stipples", "projected"]))
        assert file == mesh_file or grown[1] < 0.8 * grown[0]
        assert abs(kept[1] / kept[0] - 1) < 0.02 and abs(kept[0] / grown[0] - 1) < 0.25


def test_no_growing(stippled, volume_file):
    close = ["--zoom", 20, "--max-stipples", 1]
    grown = stippled(volume_file, *close, fits=False).mean()
    assert stippled(volume_file, *close, "--no-grow-with-zoom", fits=False).mean() < 0.5 * grown


def test_iso_surfaces_hide_what_lies_behind(stippled, tmp_path):
    """A ball before a ball: where the surface hides nothing, one sees the rear one, and the far sides, through the other."""
    ball = ink_files.blob((24, 24, 24))
    ink_files.write_vti(tmp_path / "balls.vti", np.concatenate([ball, ball], axis=1))
    options = ["--view", "front", "--lighting", "off", "--silhouette", "off", "--distance", 0, "--pixels-per-stipple", 60]
    through = stippled(tmp_path / "balls.vti", *options, "--iso", 100, "--no-surface-hides").mean()
    solid = stippled(tmp_path / "balls.vti", *options, "--iso", 100).mean()
    assert 0.5 * through < solid < 0.9 * through


def test_meshes_hide_their_far_side(stippled, mesh_file):
    """So there is about half the ink of what is seen through."""
    options = ["--lighting", "off", "--pixels-per-stipple", 60]
    seen = stippled(mesh_file, *options)
    through = stippled(mesh_file, *options, "--occluder-offset", 100)
    assert seen.mean() < 0.75 * through.mean()


def test_samples_and_tessellation(stippled, tmp_path):
    """The tone does not depend on how many polygons the sphere has, nor on how many stipples it could have."""
    tones = []
    for rows, columns, samples in ((20, 30, 20000), (60, 90, 20000), (60, 90, 60000)):
        ink_files.write_ply(tmp_path / "ball.ply", ink_files.sphere_mesh(rows, columns), normals=True)
        tones.append(stippled(tmp_path / "ball.ply", "--samples", samples).mean())
    assert max(tones) < 1.1 * min(tones), tones


def test_warm_and_cool(picture, volume_file):
    style = ["--style", "stipple"]
    assert colorfulness(picture(volume_file, *style)) == 0
    assert colorfulness(picture(volume_file, *style, "--color", 1)) > 2
    green = picture(volume_file, *style, "--color", 1, "--warm-color", "green", "--cool-color", "green",
                    "--distance-weight", 1).astype(int)
    assert (green[..., 1] >= green[..., 0]).all() and (green[..., 1] > green[..., 0] + 50).any()


def test_scalar_colors(picture, volume_file):
    style = ["--style", "stipple", "--stipple-source", "volume"]
    image = picture(volume_file, *style, "--color-map", "red,blue", "--color-range", "0,200").astype(int)
    assert (image[..., 0] > image[..., 2] + 30).any() and (image[..., 2] > image[..., 0] + 30).any()
    blue = picture(volume_file, *style, "--color-map", "red,blue", "--color-range", "-10,0.5").astype(int)
    assert (blue[..., 2] >= blue[..., 0]).all()
    for name in ("viridis", "cool-warm", "rainbow"):
        assert colorfulness(picture(volume_file, *style, "--color-map", name)) > 1
    named = picture(volume_file, *style, "--color-map", "red,blue", "--color-range", "0,200", "--color-by", "density")
    assert (named == image).all()
    viridis = picture(volume_file, *style, "--color-map", "viridis", "--color-range", "0,200")
    for options in (["--color-range", "0,200"], ["--color-by", "density", "--color-range", "0,200"]):
        assert (picture(volume_file, *style, *options) == viridis).all()
    assert colorfulness(picture(volume_file, *style, "--color-range", "0,200", "--color-map", "")) == 0


def test_transparent(picture, volume_file):
    image = picture(volume_file, "--style", "stipple", "--transparent")
    assert image.shape[2] == 4 and tuple(image[0, 0]) == (0, 0, 0, 0) and image[..., 3].max() > 200


def test_turned_volumes_are_drawn_as_they_lie(picture, tmp_path):
    """A direction matrix turns stipples and the surface that hides them alike."""
    volume = ink_files.blob()
    ink_files.write_nrrd(tmp_path / "plain.nrrd", volume)
    ink_files.write_nrrd(tmp_path / "turned.nrrd", np.ascontiguousarray(volume.transpose(0, 2, 1)),
                         directions="(0,1,0) (1,0,0) (0,0,1)")
    pictures = [picture(tmp_path / name, "--style", "stipple", "--iso", 100, "--pixels-per-stipple", 6).astype(int)
                for name in ("plain.nrrd", "turned.nrrd")]
    blocks = [image.mean(axis=2).reshape(10, 20, 10, 20).mean(axis=(1, 3)) for image in pictures]
    difference = blocks[0] - blocks[1]  # by other stipples only
    assert abs(difference.mean()) < 1 and difference.std() < 10 and np.abs(difference).max() < 35
    assert np.abs(pictures[0] - 255).mean() > 3


@pytest.mark.parametrize("arguments, words", [
    (["--boundary", "1,2"], ["--boundary '1,2'", "base,gain,exponent", "3 numbers", "found 2"]),
    (["--boundary", "1,2,3,4"], ["found 4"]),
    (["--boundary", ""], ["found 1"]),
    (["--silhouette", "1,2,nan"], ["exponent", "from 0.01 to 20", "'nan'"]),
    (["--resolution", "1,1"], ["distance", "from -8 to 0", "'1'"]),
    (["--lighting", "bright"], ["exponent", "'bright'"]),
    (["--distance-curve", "1,1.5"], ["size", "from 0 to 1"]),
    (["--interior-curve", "1,2,3"], ["exponent,size", "found 3"]),
    (["--gradient", "nan"], ["--gradient", "0 to 1"]),
    (["--gradient", "1.5"], ["--gradient", "0 to 1"]),
    (["--stipple-size", "inf"], ["--stipple-size"]),
    (["--preset", "oil"], ["--preset", "anatomy"]),
    (["--parts", "half"], ["--parts", "size"]),
    (["--max-stipples", "0"], ["--max-stipples", "1 to 64", "projected"]),
    (["--max-stipples", "7.5"], ["--max-stipples", "'7.5'"]),
    (["--max-stipples", "many"], ["--max-stipples", "'many'"]),
    (["--gradient-weighting", "gaussian"], ["--gradient-weighting", "inverse-distance"]),
    (["--percentile", "101"], ["--percentile", "0 to 100"]),
    (["--percentile", "90", "--threshold", "3"], ["--threshold", "--percentile"]),
    (["--window", "5"], ["--window"]),
    (["--window", "5,1"], ["--window '5,1'", "lower value first"]),
    (["--light", "0"], ["--light"]),
    (["--iso", "1000"], ["--iso 1000"]),
    (["--color-map", "mauvish"], ["--color-map 'mauvish'", "viridis"]),
    (["--color-map", "red,mauvish"], ["--color-map", "'mauvish'", "#rrggbb"]),
    (["--color-map", "viridis", "--color-range", "3,3"], ["--color-range '3,3'"]),
    (["--paper-color", "none"], ["--paper-color 'none'", "--transparent"]),
    (["--warm-color", "mauvish"], ["--warm-color 'mauvish'"]),
    (["--samples", "1000"], ["--samples", "mesh"]),
    (["--boundary-base", "0.3", "--boundary", "off"], ["--boundary-base", "--boundary-enhancement"]),
])
def test_wrong_options(refused, volume_file, arguments, words):
    message = refused(2, volume_file, "--style", "stipple", *arguments)
    assert all(word in message for word in words), message


@pytest.mark.parametrize("option, value", [("--tau", 1), ("--phi", 50), ("--lambda", 2), ("--sigma", 0.5),
                                           ("--as-published", None), ("--background", "red")])
def test_options_of_lines_alone(refused, volume_file, option, value):
    arguments = [option] if value is None else [option, value]
    message = refused(2, volume_file, "--style", "stipple", *arguments)
    assert f"{option}: expected with --style" in message and "splatting-lines" in message and message.endswith("found --style stipple")


@pytest.mark.parametrize("option, value", [("--preset", "bone"), ("--gradient", 1), ("--boundary", "off"),
                                           ("--no-grow-with-zoom", None), ("--color-map", "viridis"), ("--light", "0,0")])
def test_options_of_stipples_alone(refused, volume_file, option, value):
    arguments = [option] if value is None else [option, value]
    message = refused(2, volume_file, "--style", "splatting-lines", *arguments)
    assert f"{option}: expected with --style" in message and message.endswith("found --style splatting-lines")


@pytest.mark.parametrize("option, value", [("--percentile", 90), ("--threshold", 1), ("--window", "0,1"), ("--iso", 1)])
def test_options_of_volumes_alone(refused, mesh_file, option, value):
    message = refused(2, mesh_file, "--style", "stipple", option, value)
    assert option in message and "mesh" in message


def test_nothing_to_draw(refused, tmp_path, volume_file):
    ink_files.write_vti(tmp_path / "even.vti", np.full((8, 8, 8), 7, np.uint8))
    assert "nothing to draw" in refused(1, tmp_path / "even.vti", "--style", "stipple")
    assert "window" in refused(1, volume_file, "--style", "stipple", "--window", "900,1000")


@pytest.mark.parametrize("has_normals", [True, False])
def test_points_without_polygons(stippled, tmp_path, has_normals):
    """They are drawn as discs, near each other as those of a scan, with normals that are estimated where there are none."""
    points, normals, triangles = ink_files.sphere_mesh()
    ink_files.write_ply(tmp_path / "cloud.ply", (points, normals, np.zeros((0, 3), "<i4")), normals=has_normals)
    ink_files.write_ply(tmp_path / "mesh.ply", (points, normals, triangles), normals=True)
    of_points, of_mesh = (stippled(tmp_path / name).mean() for name in ("cloud.ply", "mesh.ply"))
    assert of_points == pytest.approx(of_mesh, rel=0.1)


def test_arrays_that_are_not_there(refused, volume_file, tmp_path):
    volume = ink_files.blob()
    ink_files.write_vti(tmp_path / "v.vti", volume, temperature=volume.astype("f4"))
    ink_files.write_vti(tmp_path / "c.vti", volume, where="CellData", temperature=volume.astype("f4"))
    ink_files.write_vtp(tmp_path / "m.vtp", ink_files.sphere_mesh())
    of_image = "no numeric array 'temprature' to color by (point arrays: 'density', 'temperature'); did you mean 'temperature'?"
    for style in (["illustration"], ["stipple"], ["stipple", "--stipple-source", "volume"]):
        for name in ("v.vti", "c.vti"):
            assert of_image in refused(1, tmp_path / name, "--style", *style, "--color-by", "temprature")
    for style in ("illustration", "stipple"):
        message = refused(1, tmp_path / "m.vtp", "--style", style, "--color-by", "pressure")
        assert "no numeric array 'pressure' to color by (point arrays: 'Normals', cell arrays: none)" in message


def test_volumes_larger_than_memory(refused, tmp_path):
    """Only lines are made a few slices at a time."""
    with open(tmp_path / "huge.raw", "wb") as file:
        file.truncate(1024 * 1024 * 256)
    message = refused(1, tmp_path / "huge.raw", "--raw", "1024x1024x256:uint8", "--memory", "300MiB", "--style", "stipple")
    assert "256 MiB" in message and "--memory of" in message and "illustration" in message


def test_positions_that_floats_cannot_hold(ink, tmp_path):
    points, normals, triangles = ink_files.sphere_mesh()
    ink_files.write_vtp(tmp_path / "far.vtp", (points.astype("<f8") * 1e78, normals, triangles))
    assert ink("render", tmp_path / "far.vtp", "--style", "stipple", "-o", tmp_path / "far.png").code in (0, 1)
