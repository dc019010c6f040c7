# SPDX-License-Identifier: BSD-3-Clause
"""Where `ink render` looks from, what it takes for up, and what it leaves out with --crop."""

import json

import numpy as np
import pytest

import ink_files

pytestmark = pytest.mark.one_build


# A mesh of which only what is said matters.
SMALL = ["--style", "splatting-lines", "--samples", 1000, "--size", 32]


@pytest.fixture
def drawn(picture):
    """Where there is ink, [row from the top, column]."""

    def render(file, *arguments, size="120x120"):
        # Flat sides have no lines.
        style = ["--style", "stipple", "--lighting", "off"] if file.suffix == ".ply" else ["--style", "splatting-lines"]
        return (picture(file, *style, *arguments, size=size)[..., :3] < 200).any(axis=2)

    return render


def box(size, middle=(0, 0, 0)):
    """A box of triangles, as the meshes of ink_files."""
    corners = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], "<f4")
    points = ((corners - 0.5) * size + middle).astype("<f4")
    quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    triangles = np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))], "<i4")
    return points, np.zeros_like(points), triangles


def joined(*meshes):
    offsets = np.cumsum([0, *(len(mesh[0]) for mesh in meshes)])
    triangles = np.vstack([mesh[2] + offset for mesh, offset in zip(meshes, offsets)]).astype("<i4")
    return np.vstack([mesh[0] for mesh in meshes]), np.vstack([mesh[1] for mesh in meshes]), triangles


def table(up):
    """A slab on a foot, twice as wide along its first side as along the other, with an axis up."""
    along = {"z": (0, 1, 2), "y": (0, 2, 1)}[up]
    place = lambda values: [values[along.index(axis)] for axis in range(3)]
    return joined(box(place((4, 2, 0.2)), place((0, 0, 0.1))), box(place((0.5, 0.5, 2)), place((0, 0, 1.2))))


def extent(ink):
    rows, columns = np.flatnonzero(ink.any(axis=1)), np.flatnonzero(ink.any(axis=0))
    return rows[-1] - rows[0] + 1, columns[-1] - columns[0] + 1


@pytest.mark.parametrize("up", ["z", "y"])
def test_meshes_stand_upright(ink, drawn, tmp_path, up):
    path = tmp_path / "table.ply"
    ink_files.write_ply(path, table(up), normals=False)
    level = ("--parallel", "--elevation", 0)
    shown = drawn(path, *level)
    # The slab is below, and its long side is seen.
    width = lambda rows: np.ptp(np.flatnonzero(rows.any(axis=0)))
    middle = shown.shape[0] // 2
    assert width(shown[middle + 5 :]) > 2 * width(shown[: middle - 5])
    assert extent(shown)[1] > 1.5 * extent(shown)[0]
    result = ink("render", path, *SMALL, "-o", tmp_path / "out.png")
    assert ("the mesh seems to stand with y up; --up says otherwise" in result.err) == (up == "y")
    assert (drawn(path, *level, "--up", up) == shown).all()
    assert (drawn(path, *level, f"--up=-{up}") != shown).any()


def test_the_side_that_shows_most(ink, drawn, tmp_path):
    path = tmp_path / "long.ply"
    ink_files.write_ply(path, box((1, 4, 1.5)), normals=False)
    straight = ("--parallel", "--azimuth", 0, "--elevation", 0)
    rows, columns = extent(drawn(path, *straight))
    assert columns > 2 * rows
    assert "the left of the mesh shows most and is drawn; --view says otherwise" in ink("render", path, *SMALL, "-o", tmp_path / "o.png").err
    rows, columns = extent(drawn(path, "--parallel", "--view", "front"))
    assert columns < rows


def test_what_is_long_is_not_seen_along_its_length(drawn, tmp_path):
    """A bar between two wide plates, of which the near one would hide all else."""
    path = tmp_path / "bar.ply"
    ends = [box((0.1, 1, 1), (x, 0, 0)) for x in (-4, 4)]
    ink_files.write_ply(path, joined(*ends, box((8, 0.03, 0.03))), normals=False)
    rows, columns = extent(drawn(path, "--parallel"))
    assert columns > 2 * rows


def test_a_tree_stands(ink, tmp_path):
    """Its trunk is less of it than its lowest branches are where it lies."""
    path = tmp_path / "tree.ply"
    sizes = [(0.3, 1.6, 0.3), (0.1, 1.2, 0.1), (0.1, 1, 0.1)]
    branches = [box(size, (0.3 * i, 0, 5 + i)) for i, size in zip((-1, 0, 1), sizes)]
    ink_files.write_ply(path, joined(box((0.05, 0.05, 6), (0, 0, 3)), *branches), normals=False)
    assert "seems to stand" not in ink("render", path, *SMALL, "-o", tmp_path / "o.png").err


def test_one_flat_face_is_seen_at_an_angle(ink, drawn, tmp_path):
    """It would be a gray silhouette."""
    path = tmp_path / "box.ply"
    ink_files.write_ply(path, box((2, 1, 2)), normals=False)
    says = "from straight ahead only one flat face of the mesh is seen, so it is seen at an angle; --azimuth and --elevation say otherwise"
    assert says in ink("render", path, *SMALL, "-o", tmp_path / "o.png").err
    angle = ("--view", "front", "--azimuth", 30, "--elevation", 20)
    assert (drawn(path) == drawn(path, *angle)).all()
    for chosen in (("--azimuth", 0, "--elevation", 0), ("--view", "front"), angle):
        assert says not in ink("render", path, *SMALL, *chosen, "-o", tmp_path / "o.png").err
    rows, columns = extent(drawn(path, "--parallel", "--azimuth", 0, "--elevation", 0))
    assert rows / columns == pytest.approx(1, abs=0.03)


@pytest.mark.parametrize("up", ["z", "y"])
def test_what_lies_flat_is_seen_from_above(ink, drawn, tmp_path, up):
    path = tmp_path / "plate.ply"
    size = (4, 3, 0.2) if up == "z" else (4, 0.2, 3)
    ink_files.write_ply(path, box(size), normals=False)
    rows, columns = extent(drawn(path, "--parallel", "--up", up))
    # From 30 degrees above half of its depth is seen, and most of its height.
    assert rows / columns == pytest.approx((3 * 0.5 + 0.2 * 3**0.5 / 2) / 4, abs=0.03)
    says = "the mesh lies flat, so it is seen from above; --elevation says otherwise"
    assert says in ink("render", path, *SMALL, "--up", up, "-o", tmp_path / "o.png").err
    for chosen in (("--up", up, "--elevation", 0), ("--up", up, "--view", "front")):
        rows, columns = extent(drawn(path, "--parallel", *chosen))
        assert rows / columns == pytest.approx(0.2 / 4, abs=0.03)
        assert says not in ink("render", path, *SMALL, *chosen, "-o", tmp_path / "o.png").err


def test_volumes_and_even_meshes_are_seen_from_the_front_with_z_up(ink, volume_file, tmp_path):
    ink_files.write_ply(tmp_path / "ball.ply", ink_files.sphere_mesh())
    assert ink("render", volume_file, "--iso", 100, "--size", 32, "-o", tmp_path / "o.png").err.count("\n") == 1
    result = ink("render", tmp_path / "ball.ply", *SMALL, "-o", tmp_path / "o.png")
    assert "--up" not in result.err and "--view" not in result.err


@pytest.mark.parametrize("style, thin, side", [
    ("splatting-lines", "z", "top"), ("splatting-lines", "x", "left"), ("splatting-lines", "y", None), ("contours", "z", "top"),
    # Its lines are traced only where the picture shows the surface.
    ("line-art", "z", "top")])
def test_volumes_are_not_seen_edge_on(ink, picture, tmp_path, style, thin, side):
    path = tmp_path / "v.nrrd"
    steps = {axis: 0.3 if axis == thin else 1.0 for axis in "xyz"}
    ink_files.write_nrrd(path, ink_files.blob(), directions=f"({steps['x']},0,0) (0,{steps['y']},0) (0,0,{steps['z']})")
    few = ("--density", 0, "--line-spacing", 16, "--subdivision", 1) if style == "line-art" else ()
    options = ("--style", style, "--iso", 100, *few)
    small = (*options, "--size", 100, "-o", tmp_path / "o.png")
    says = f"what is drawn shows more from its {side} than from its front, so that is seen; --view says otherwise"
    err = ink("render", path, *small).err
    assert err.count("shows more") == err.count(says) == (1 if side else 0)
    assert (picture(path, *options, size=100) == picture(path, *options, "--view", side or "front", size=100)).all()
    for chosen in (("--view", "front"), ("--position", "100,-100,20")):
        assert "shows more" not in ink("render", path, *small, *chosen).err


def test_slabs_are_seen_through_straight_ahead(ink, picture, tmp_path):
    """A few slices of a ball: their cut, at an angle, or the rim all around."""
    path = tmp_path / "v.nrrd"
    ink_files.write_nrrd(path, ink_files.blob()[13:19])
    options = ("--size", 100, "-o", tmp_path / "o.png")
    says = "cut to a slab, so it is seen at an angle"
    assert says in ink("render", path, *options, "--iso", 100).err
    through = ("--style", "stipple", "--stipple-source", "volume")
    err = ink("render", path, *options, *through).err
    assert says not in err and "shows more from its top" in err
    straight = picture(path, *through, "--view", "top")
    assert (straight < 128).any()
    assert np.array_equal(picture(path, *through), straight)


@pytest.mark.parametrize("axis, shape", [("x", (2, 3)), ("-x", (2, 3)), ("y", (3, 2)), ("-y", (3, 2)), ("z", (4, 2)), ("-z", (4, 2))])
def test_up(drawn, tmp_path, axis, shape):
    """A box of 2 x 3 x 4: the axis that is up is its height."""
    path = tmp_path / "box.ply"
    ink_files.write_ply(path, box((2, 3, 4)), normals=False)
    rows, columns = extent(drawn(path, "--parallel", f"--up={axis}", "--view", "front"))
    assert rows / columns == pytest.approx(shape[0] / shape[1], rel=0.08)


def test_up_turns_the_picture(drawn, volume_file):
    upright = drawn(volume_file, "--iso", 100, "--parallel")
    turned = drawn(volume_file, "--iso", 100, "--parallel", "--up=-z")
    assert (turned[::-1, ::-1] != upright).mean() < 0.01


def test_roll_is_counterclockwise(drawn, volume_file):
    upright = drawn(volume_file, "--iso", 100, "--parallel", "--view", "left")
    rolled = drawn(volume_file, "--iso", 100, "--parallel", "--view", "left", "--roll", 90)
    difference = (np.rot90(upright) != rolled).mean()
    assert difference < 0.02 and difference < 0.5 * (np.rot90(upright, -1) != rolled).mean()


def test_position_and_focal_point(drawn, volume_file):
    """From the front, at such a distance that the middle of the blob is small and in the middle."""
    seen = drawn(volume_file, "--iso", 100, "--position", "15.5,-300,15.5", "--focal-point", "15.5,15.5,15.5")
    rows, columns = np.nonzero(seen)
    assert 0 < np.ptp(rows) < 30 and abs((rows.min() + rows.max()) / 2 - 60) < 5
    nearer = drawn(volume_file, "--iso", 100, "--position", "15.5,-150,15.5", "--focal-point", "15.5,15.5,15.5")
    assert np.ptp(np.nonzero(nearer)[0]) > 1.6 * np.ptp(rows)
    # What is looked at is in the middle of the picture.
    beside = drawn(volume_file, "--iso", 100, "--zoom", 0.3, "--focal-point", "-30,15,15")
    assert np.nonzero(beside)[1].min() > 60
    # From straight above the front of the subject is below.
    above = drawn(volume_file, "--iso", 100, "--position", "15.5,15.5,200", "--focal-point", "15.5,15.5,15")
    assert above.any()


@pytest.mark.parametrize("camera", [["--zoom", 4], ["--zoom", 4, "--parallel"], ["--zoom", 4, "--focal-point", "0.2,-1,0.1", "--roll", 30],
                                    ["--position", "0,-1.5,0", "--focal-point", "0,0,0"]])  # fmt: skip
def test_from_near_strokes_fill_the_picture(picture, tmp_path, camera):
    """Of line art, which has them only where the picture shows the surface then."""
    ink_files.write_ply(tmp_path / "ball.ply", ink_files.sphere_mesh())
    style = ["--style", "line-art", "--density", 0.1, "--no-curved-meshes", "--light", "180,0", "--view", "front"]
    near = 255.0 - picture(tmp_path / "ball.ply", *style, *camera, size="160x120")[..., 0]
    grays = near.reshape(6, 20, 8, 20).mean(axis=(1, 3))
    assert grays.min() > 0.4 * grays.mean(), grays.astype(int)


@pytest.mark.parametrize("arguments, words", [
    (["--position", "1,2,3", "--focal-point", "1,2,3"], "--position"), (["--position", "1,2"], "--position"),
    (["--position", "1,2,nan"], "--position"), (["--roll", "x"], "--roll"), (["--up", "w"], "--up"),
    (["--position", "1,2,3", "--frames", 2], "--position"), (["--crop", "1,0,0,1,0,1"], "--crop"),
    (["--crop", "1,0,0,1,0"], "--crop"), (["--crop", "0,1,0,1,0,inf"], "--crop")])
def test_cameras_and_boxes_that_cannot_be(ink, volume_file, arguments, words):
    name = "none%d.png" if "--frames" in arguments else "none.png"
    result = ink("render", volume_file, "--iso", 100, "-o", name, *arguments)
    assert result.code == 2 and words in result.error


def info(ink, *arguments):
    result = ink("info", "--json", *arguments)
    assert result.code == 0, result
    return json.loads(result.out)[0]


def test_crop_keeps_whole_voxels_where_they_are(ink, tmp_path):
    affine = [[0.5, 0, 0, 3], [0, 1, 0, 4], [0, 0, 2, 5]]
    ink_files.write_nifti(tmp_path / "v.nii", ink_files.blob((20, 24, 28), np.int16), spacing=(0.5, 1, 2), affine=affine)
    whole = info(ink, tmp_path / "v.nii")
    assert whole["dimensions"] == [28, 24, 20] and whole["bounds"] == [-16.5, -3, -27, -4, 5, 43]
    part = info(ink, tmp_path / "v.nii", "--crop=-10,-5,-20.5,-10.5,5,20")
    assert part["dimensions"] == [11, 10, 8] and part["bounds"] == [-10, -5, -20, -11, 5, 19]


def test_crop_of_meshes_and_points(ink, tmp_path):
    ink_files.write_ply(tmp_path / "ball.ply", ink_files.sphere_mesh(40, 60))
    part = info(ink, tmp_path / "ball.ply", "--crop=0,2,-2,2,-2,2")
    assert part["bounds"][0] == pytest.approx(0, abs=1e-6) and part["bounds"][1] > 0.9
    points, normals, _ = ink_files.sphere_mesh(40, 60)
    ink_files.write_ply(tmp_path / "cloud.ply", (points, normals, np.zeros((0, 3), "<i4")), normals=True)
    part = info(ink, tmp_path / "cloud.ply", "--crop=0,2,-2,2,-2,2")
    assert part["points"] == (points[:, 0] >= 0).sum() and part["point_arrays"][0]["name"] == "Normals"


@pytest.mark.parametrize("name", ["v.vti", "m.ply", "c.ply"])
def test_crop_that_leaves_nothing(ink, tmp_path, name):
    points, normals, triangles = ink_files.sphere_mesh()
    ink_files.write_vti(tmp_path / "v.vti", ink_files.blob())
    ink_files.write_ply(tmp_path / "m.ply", (points, normals, triangles))
    ink_files.write_ply(tmp_path / "c.ply", (points, normals, np.zeros((0, 3), "<i4")))
    result = ink("render", tmp_path / name, "--crop", "100,101,0,1,0,1", "-o", tmp_path / "o.png")
    assert result.code == 1 and "--crop: nothing lies in the box; the data is from " in result.error


def test_a_cropped_drawing_is_that_part(drawn, volume_file):
    left = drawn(volume_file, "--iso", 100, "--parallel", "--crop", "15,40,0,40,0,40")
    rows, columns = extent(left)
    assert rows > 1.3 * columns
