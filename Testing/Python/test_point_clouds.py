# SPDX-License-Identifier: BSD-3-Clause
"""Raw scans: points of uneven density without normals, with noise, outliers, copies and a hole, are drawn as surfaces."""

import numpy as np
import pytest

import ink_files

SIZE = 300
HOLE = np.array([-0.35, -0.9, 0.2]) / np.linalg.norm([-0.35, -0.9, 0.2])
HOLE_ANGLE = 0.22


def scan(seed=1):
    """A ball with twenty times as many points to its left as to its right, and a smaller one hidden in its right."""
    rng = np.random.default_rng(seed)
    ball = rng.normal(size=(90000, 3))
    ball /= np.linalg.norm(ball, axis=1, keepdims=True)
    ball = ball[rng.random(len(ball)) < 0.05 ** ((ball[:, 0] + 1) / 2)]
    ball = ball[ball @ HOLE < np.cos(HOLE_ANGLE)]
    ball += rng.normal(scale=0.0015, size=ball.shape)
    inner = rng.normal(size=(6000, 3))
    ball = np.concatenate([ball, [0.45, 0.1, 0] + 0.3 * inner / np.linalg.norm(inner, axis=1, keepdims=True)])
    outliers = rng.uniform(-1.8, 1.8, (60, 3))
    outliers = outliers[np.linalg.norm(outliers, axis=1) > 1.4]
    return np.concatenate([ball, outliers, np.repeat(ball[:100], 30, axis=0)]), len(ball), len(outliers)


@pytest.fixture(scope="module")
def cloud(tmp_path_factory):
    points, ball, outliers = scan()
    path = tmp_path_factory.mktemp("scan") / "scan.xyz"
    np.savetxt(path, points, "%.6f")
    return path, points, ball, outliers


def zones(image, radius):
    """The picture's darkness, and of each pixel its place on the front of the unit ball, z up."""
    ink = 1 - image[..., 0] / 255
    rows, columns = np.mgrid[: image.shape[0], : image.shape[1]]
    x = (columns + 0.5 - image.shape[1] / 2) / radius
    z = -(rows + 0.5 - image.shape[0] / 2) / radius
    out = np.hypot(x, z)
    y = -np.sqrt(np.maximum(1 - out**2, 0))
    to_hole = np.arccos(np.clip(np.stack([x, y, z], axis=2) @ HOLE, -1, 1))
    return ink, out, to_hole


def judge(image):
    """Ink on the contour, in the smooth middle, and in the middle of the hole, each the share of dark pixels."""
    ink, out, to_hole = zones(image, 0.95 * SIZE / 2)
    angles = np.linspace(0, 2 * np.pi, 180, endpoint=False)
    found = 0
    for angle in angles:
        along = np.linspace(0.93, 1.07, 40) * 0.95 * SIZE / 2
        rows = np.clip((SIZE / 2 - along * np.sin(angle)).astype(int), 0, SIZE - 1)
        columns = np.clip((SIZE / 2 + along * np.cos(angle)).astype(int), 0, SIZE - 1)
        found += ink[rows, columns].max() > 0.35
    smooth = (out < 0.8) & (to_hole > HOLE_ANGLE + 0.12)
    return found / len(angles), (ink[smooth] > 0.3).mean(), (ink[to_hole < 0.5 * HOLE_ANGLE] > 0.3).mean()


def test_a_scan_is_drawn_as_its_surface(ink, cloud, tmp_path):
    path, points, ball, outliers = cloud
    result = ink("render", path, "--style", "splatting-lines", "--parallel", "--neighbors", 32, "--size", f"{SIZE}x{SIZE}",
                 "-o", tmp_path / "out.png")
    assert result.code == 0 and "estimated" in result.err, result
    contour, smooth, hole = judge(ink_files.read_png(tmp_path / "out.png"))
    assert contour > 0.95
    assert smooth < 0.003
    assert hole == 0


@pytest.mark.one_build
def test_one_radius_for_all_does_worse():
    """Drawn with the mapper as it is: one radius leaves holes among the sparse points, through which the back shows."""
    vtkink = pytest.importorskip("vtkink")
    vtk = vtkink.vtk
    points, _, _ = scan()
    data = vtk.vtkPolyData()
    data.SetPoints(vtk.vtkPoints())
    for point in points:
        data.GetPoints().InsertNextPoint(point)
    inks = {}
    for uniform in (False, True):
        sampler = vtkink.vtkInkSurfaceSampler()
        sampler.SetInputData(data)
        sampler.SetUniformRadius(uniform)
        sampler.SetNormalNeighbors(32)
        mapper = vtkink.vtkInkSplattingLinesMapper()
        mapper.SetInputConnection(sampler.GetOutputPort())
        actor = vtk.vtkActor()
        actor.SetMapper(mapper)
        renderer = vtk.vtkRenderer()
        renderer.AddActor(actor)
        renderer.SetBackground(1, 1, 1)
        camera = renderer.GetActiveCamera()
        camera.ParallelProjectionOn()
        camera.SetPosition(0, -5, 0)
        camera.SetViewUp(0, 0, 1)
        camera.SetParallelScale(1 / 0.95)
        renderer.ResetCameraClippingRange(-2, 2, -2, 2, -2, 2)
        window = vtk.vtkRenderWindow()
        window.SetOffScreenRendering(True)
        window.SetMultiSamples(0)
        window.SetSize(SIZE, SIZE)
        window.AddRenderer(renderer)
        window.Render()
        pixels = vtk.vtkUnsignedCharArray()
        window.GetPixelData(0, 0, SIZE - 1, SIZE - 1, 0, pixels, 0)
        image = np.frombuffer(memoryview(pixels), np.uint8).reshape(SIZE, SIZE, 3)[::-1]
        inks[uniform] = judge(image)
    assert inks[False][0] > 0.95 and inks[False][1] < 0.0005
    assert inks[True][1] > 0.003, inks


@pytest.mark.one_build
def test_what_is_left_out_is_said(ink, cloud, tmp_path):
    path, points, ball, outliers = cloud
    result = ink("sample", path, tmp_path / "out.vtp")
    (left_out,) = [int(line.split()[1]) for line in result.err.splitlines() if "left out" in line]
    columns = ink_files.read_points(tmp_path / "out.vtp")
    assert len(columns["x"]) == len(points) - left_out
    assert outliers <= left_out < outliers + 0.002 * ball
    assert (np.linalg.norm([columns[axis] for axis in "xyz"], axis=0) < 1.1).all()
    # Denser points have smaller discs.
    radius, x = columns["Radius"], columns["x"]
    assert np.median(radius[x > 0.8]) > 2.5 * np.median(radius[x < -0.7])


@pytest.mark.one_build
def test_normals_towards_the_scanner(ink, tmp_path):
    rng = np.random.default_rng(3)
    wave = np.c_[rng.uniform(-1, 1, (4000, 2)), np.zeros(4000)]
    wave[:, 2] = 0.1 * np.sin(5 * wave[:, 0])
    np.savetxt(tmp_path / "wave.xyz", wave)
    for side in (1, -1):
        assert ink("sample", tmp_path / "wave.xyz", tmp_path / "out.vtp", "--viewpoint", f"0,0,{side * 9}", "-q").code == 0
        normals = ink_files.read_points(tmp_path / "out.vtp")["nz"]
        assert (side * normals > 0.5).all()


@pytest.mark.one_build
def test_threads_do_not_matter(ink, cloud, tmp_path):
    for threads in ("1", "2"):
        result = ink("sample", cloud[0], tmp_path / f"{threads}.vtp", "-q", env={"VTK_SMP_MAX_THREADS": threads})
        assert result.code == 0
    assert (tmp_path / "1.vtp").read_bytes() == (tmp_path / "2.vtp").read_bytes()


@pytest.mark.parametrize("samples", [[], ["--samples", 0]])
def test_points_of_all_formats_need_no_normals(picture, ink, tmp_path, samples):
    points, normals, _ = ink_files.sphere_mesh(60, 90)
    ink_files.write_ply(tmp_path / "points.ply", (points, normals, np.empty((0, 3), int)))
    np.savetxt(tmp_path / "points.xyz", points, "%.9g")
    assert ink("sample", tmp_path / "points.ply", tmp_path / "points.vtp", "--arrays", "none", "-q").code == 0
    first = picture(tmp_path / "points.xyz", *samples)
    assert (first < 100).any()
    for suffix in ("ply", "vtp"):
        assert np.abs(first.astype(float) - picture(tmp_path / f"points.{suffix}", *samples)).mean() < 1


@pytest.mark.one_build
def test_xyz_files(ink, tmp_path):
    path = tmp_path / "points.xyz"

    def columns_of(text, *words):
        path.write_text(text)
        result = ink("sample", path, tmp_path / "out.vtp")
        assert result.code == 0 and all(word in result.err for word in words), result
        return ink_files.read_points(tmp_path / "out.vtp")

    assert len(columns_of("# a comment\n1 2 3\n\n4,5;6\n +7\t8 9e0 \r\n0 0 nan")["x"]) == 4
    with_normals = columns_of("0 0 0 0 0 1\n1 0 0 0 0 -1\n0 1 0 0 0 0\n")
    assert list(with_normals["nz"]) in ([1, -1, 0], [1, 0, -1], [-1, 0, 1], [-1, 1, 0], [0, 1, -1], [0, -1, 1])
    assert "estimated" not in ink("sample", path, tmp_path / "out.vtp").err
    columns_of("0 0 0 255 3 4\n1 0 0 1 2 200\n0 1 0 8 8 8\n", "only x, y and z are used", "estimated")


@pytest.mark.parametrize("text, words", [
    ("1 2\n", ["line 1", "'1 2'", "x, y and z"]), ("1 2 3\n1 2 3 4\n", ["line 2", "3 numbers"]),
    ("1 2 3\nx y z\n", ["line 2", "'x y z'"]), ("# nothing\n", ["no points"]), ("x" * 99, ["x...'"]),
])
@pytest.mark.one_build
def test_xyz_files_that_are_none(ink, tmp_path, text, words):
    (tmp_path / "bad.xyz").write_text(text)
    for command in (["render", "-o", tmp_path / "out.png"], ["sample", "-o", tmp_path / "out.vtp"], ["info"]):
        result = ink(*command, tmp_path / "bad.xyz")
        assert result.code == 1 and all(word in result.error for word in words), result


@pytest.mark.parametrize("text", ["1 2 3\n", "1 2 3\n" * 40, "0 0 0\n1 0 0\n", "nan 0 0\n1 0 0\n",
                                  "".join(f"{i} {2 * i} 0\n" for i in range(50))])
@pytest.mark.one_build
def test_degenerate_clouds_are_no_crash(ink, tmp_path, text):
    (tmp_path / "few.xyz").write_text(text)
    result = ink("render", tmp_path / "few.xyz", "--size", "64x64", "-o", tmp_path / "out.png")
    drawn = text.count("\n") in (2, 50) and "nan" not in text
    assert result.code == (0 if drawn else 1) and (drawn or "radius" in result.error), result
    assert ink("sample", tmp_path / "few.xyz", tmp_path / "out.vtp").code == 0
    columns = ink_files.read_points(tmp_path / "out.vtp")
    assert np.isfinite(columns["Radius"]).all() and (columns["Radius"] >= 0).all()


@pytest.mark.one_build
def test_options_of_points_on_a_mesh_and_a_volume(ink, volume_file, tmp_path):
    points, normals, triangles = ink_files.sphere_mesh(10, 12)
    ink_files.write_ply(tmp_path / "mesh.ply", (points, normals, triangles))
    for file, found in ((tmp_path / "mesh.ply", "mesh"), (volume_file, "volume")):
        for option in (["--neighbors", 20], ["--viewpoint", "0,0,1"]):
            for output in (["render", "-o", tmp_path / "out.png"], ["sample", "-o", tmp_path / "out.vtp"]):
                result = ink(*output, file, *option)
                assert result.code == 2 and option[0] in result.error and found in result.error, result
