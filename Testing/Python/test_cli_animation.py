# SPDX-License-Identifier: BSD-3-Clause
"""`ink render` of several frames: series of files, turntables, pictures and videos."""

import json
import os
import stat

import numpy as np
import pytest

import ink_files

SIZE = 120
FRAMES = 5


def ball(time):
    """A sphere that is drawn out along x and lifted as time goes from 0 to 1."""
    points, normals, triangles = ink_files.sphere_mesh(24, 36)
    return (points * (1 + time, 1, 1) + (0, 0, 0.8 * time)).astype("<f4"), normals, triangles


@pytest.fixture(scope="module")
def series(tmp_path_factory):
    """ball_8.ply to ball_12.ply: by their letters, 10 would come before 8."""
    folder = tmp_path_factory.mktemp("series")
    for i in range(FRAMES):
        ink_files.write_ply(folder / f"ball_{i + 8}.ply", ball(i / (FRAMES - 1)))
    return folder


# The style that is drawn soonest.
LINES = ["--style", "splatting-lines"]


def frames_of(ink, source, out, *arguments):
    result = ink("render", source, "--size", f"{SIZE}x{SIZE}", "--samples", 4000, "-o", out / "f_%02d.png", *arguments)
    assert result.code == 0, result
    files = sorted(out.glob("f_*.png"))
    return [ink_files.read_png(file).mean(axis=2) for file in files]


def bounds(image):
    rows, columns = np.nonzero(image < 128)
    return rows.min(), rows.max(), columns.min(), columns.max()


def test_a_series_of_a_deforming_mesh(ink, series, tmp_path):
    images = frames_of(ink, series / "ball_%d.ply", tmp_path)
    assert len(images) == FRAMES
    # The camera stays: the ball gets wider and rises, and its height does not change.
    boxes = np.array([bounds(image) for image in images])
    heights, widths = boxes[:, 1] - boxes[:, 0], boxes[:, 3] - boxes[:, 2]
    assert (np.diff(widths) > 0).all() and abs(widths[-1] / widths[0] - 2) < 0.1, widths
    assert np.ptp(heights) <= 3 and (np.diff(boxes[:, 0]) < 0).all(), boxes
    assert boxes[:, [0, 2]].min() >= 2 and boxes[:, [1, 3]].max() <= SIZE - 3, "all frames fit"


def pvd(folder):
    path = folder / "ball.pvd"
    entries = "".join(f'<DataSet timestep="{i / 10}" part="0" file="ball_{i + 8}.ply"/>' for i in reversed(range(FRAMES)))
    path.write_text(f'<?xml version="1.0"?><VTKFile type="Collection"><Collection>{entries}</Collection></VTKFile>')
    return path


def json_series(folder):
    path = folder / "ball.ply.series"
    files = [{"name": f"ball_{i + 8}.ply", "time": i} for i in range(FRAMES)]
    path.write_text(json.dumps({"file-series-version": "1.0", "files": files}))
    return path


@pytest.mark.one_build
def test_all_ways_to_name_a_series_are_the_same(ink, series, tmp_path):
    pictures = []
    names = [series / "ball_%d.ply", series / "ball_*.ply", series / "ball_?*.ply", pvd(series), json_series(series)]
    for number, name in enumerate(names):
        out = tmp_path / str(number)
        out.mkdir()
        pictures.append(frames_of(ink, name, out, *LINES))
    for other in pictures[1:]:
        assert len(other) == FRAMES
        assert all((a == b).all() for a, b in zip(pictures[0], other))


@pytest.mark.parametrize("frames, steps", [("3", [0, 2, 4]), ("1", [0]), ("1:3", [1, 2, 3]), ("0:4:2", [0, 2, 4]),
                                           ("9", [0, 1, 1, 2, 2, 3, 3, 4, 4])])
@pytest.mark.one_build
def test_chosen_frames(ink, series, tmp_path, frames, steps):
    images = frames_of(ink, series / "ball_%d.ply", tmp_path, "--frames", frames, *LINES)
    widths = [bounds(image)[3] - bounds(image)[2] for image in images]
    assert len(images) == len(steps)
    for i, j in zip(range(len(steps)), range(1, len(steps))):
        assert (widths[i] < widths[j]) == (steps[i] < steps[j])


@pytest.mark.one_build
def test_samples_are_moved_and_not_made_anew(ink, tmp_path):
    """A threshold at which noise is drawn, on a sphere that moves by a tenth of a pixel; where faces come in another
    order each time, they are other faces, and samples are made anew."""
    points, normals, triangles = ink_files.sphere_mesh(24, 36)
    changes = []
    for turn in (0, 1):
        folder = tmp_path / str(turn)
        folder.mkdir()
        for i in range(3):
            moved = (points * (1 + i / 500, 1, 1)).astype("<f4")
            ink_files.write_ply(folder / f"s_{i}.ply", (moved, normals, np.roll(triangles, turn * 100 * i, axis=0)))
        images = frames_of(ink, folder / "s_%d.ply", folder, *LINES, "--tau", 1.02)
        changes.append(sum(np.abs(a - b).mean() for a, b in zip(images, images[1:])))
    assert changes[0] < 0.3 * changes[1], changes


@pytest.mark.one_build
def test_topology_may_change(ink, tmp_path):
    for i, (rows, columns) in enumerate([(20, 30), (20, 30), (21, 30)]):
        ink_files.write_ply(tmp_path / f"s_{i}.ply", ink_files.sphere_mesh(rows, columns))
    images = frames_of(ink, tmp_path / "s_%d.ply", tmp_path)
    assert len(images) == 3 and all((image < 128).any() for image in images)
    assert (images[0] == images[1]).all()


def test_volumes_keep_the_first_ones_iso_value(ink, tmp_path):
    for i in range(3):
        ink_files.write_vti(tmp_path / f"v_{i}.vti", np.roll(ink_files.blob(), i, axis=2) + np.uint8(5 * i))
    out = tmp_path / "f_%d.png"
    result = ink("render", tmp_path / "v_%d.vti", *LINES, "--size", "80x80", "-o", out)
    assert result.code == 0 and result.err.count("iso-value") == 1, result
    assert len(list(tmp_path.glob("f_*.png"))) == 3


def test_a_turntable_goes_once_around(ink, volume_file, tmp_path):
    images = frames_of_volume(ink, volume_file, tmp_path, "--frames", 4, "--parallel")
    assert len(images) == 4
    # Half way around, a silhouette is mirrored.
    filled = [np.cumsum(image < 192, axis=1).astype(bool) & np.cumsum(image[:, ::-1] < 192, axis=1)[:, ::-1].astype(bool)
              for image in images]
    for a, b in ((0, 2), (1, 3)):
        assert (filled[a] != filled[b][:, ::-1]).mean() < 0.02
        assert (filled[a] != filled[a + 1]).mean() > 0.02
    # The first is the plain picture, but for the distance at which all of them fit.
    heights = [np.ptp(np.nonzero(one.any(axis=1))[0]) for one in filled]
    assert max(heights) - min(heights) <= 1, f"the camera keeps its distance: {heights}"


@pytest.mark.one_build
def test_a_turntable_leaves_upright_what_is(ink, tmp_path):
    points, normals, triangles = ink_files.sphere_mesh(24, 36)
    mesh = tmp_path / "needle.ply"
    ink_files.write_ply(mesh, ((points * (1, 1, 8)).astype("<f4"), normals, triangles))
    images = frames_of(ink, mesh, tmp_path, "--view", "iso", "--frames", 4, "--parallel")
    boxes = np.array([bounds(image) for image in images])
    assert np.ptp(boxes, axis=0).max() <= 3, boxes
    assert (boxes[:, 1] - boxes[:, 0] > 3 * (boxes[:, 3] - boxes[:, 2])).all(), boxes


def frames_of_volume(ink, volume, out, *arguments):
    result = ink("render", volume, "--iso", 100, "--size", f"{SIZE}x{SIZE}", "-o", out / "t_%d.png", *arguments)
    assert result.code == 0, result
    return [ink_files.read_png(file).mean(axis=2) for file in sorted(out.glob("t_*.png"))]


def test_a_turntable_of_stipples(ink, volume_file, tmp_path):
    result = ink("render", volume_file, "--style", "stipple", "--frames", 2, "--size", "60x60", "-o", tmp_path / "t_%d.png")
    assert result.code == 0 and len(list(tmp_path.glob("t_*.png"))) == 2, result


def fake_ffmpeg(folder, script):
    program = folder / "ffmpeg"
    program.write_text("#!/bin/sh\n" + script)
    program.chmod(program.stat().st_mode | stat.S_IXUSR)
    return {"PATH": f"{folder}:{os.environ['PATH']}"}


def test_a_video_gets_all_pixels(ink, series, tmp_path):
    """What ffmpeg is told and given, by a program in its place that writes down both."""
    env = fake_ffmpeg(tmp_path, 'for last; do :; done; echo "$@" > ' + str(tmp_path / "arguments") + '\ncat > "$last"\n')
    options = [*LINES, "--samples", 4000, "--size", "50x30"]
    result = ink("render", series / "ball_%d.ply", *options, "--fps", 12, "-o", tmp_path / "out.mp4", env=env)
    assert result.code == 0, result
    arguments = (tmp_path / "arguments").read_text()
    assert "-s 50x30 -r 12 " in arguments and "rgb24" in arguments and "libx264" in arguments
    raw = np.frombuffer((tmp_path / "out.mp4").read_bytes(), np.uint8).reshape(FRAMES, 30, 50, 3)
    assert ink("render", series / "ball_%d.ply", *options, "-o", tmp_path / "f_%d.png").code == 0
    for i in range(FRAMES):
        assert (raw[i] == ink_files.read_png(tmp_path / f"f_{i}.png")).all()
    assert not list(tmp_path.glob("ink-*")), "nothing is left behind"


@pytest.mark.one_build
def test_a_video_that_fails_changes_nothing(ink, series, tmp_path):
    out = tmp_path / "out.webm"
    out.write_text("before")
    for script in ("echo 'no such codec' >&2; exit 1", "cat > /dev/null; echo 'no such codec' >&2; exit 3"):
        env = fake_ffmpeg(tmp_path, script)
        result = ink("render", series / "ball_%d.ply", *LINES, "--samples", 4000, "--size", "300x300", "-o", out, env=env)
        assert result.code == 1 and "ffmpeg failed: no such codec" in result.error, result
        assert out.read_text() == "before"
        assert not list(tmp_path.glob("ink-*"))


@pytest.mark.one_build
def test_no_ffmpeg(ink, series, tmp_path):
    program = os.path.dirname(next(p for p in (os.path.join(d, "ink") for d in os.environ["PATH"].split(":")) if os.path.exists(p)))
    if os.path.exists(os.path.join(program, "ffmpeg")):
        pytest.skip("ffmpeg lies beside ink")
    result = ink("render", series / "ball_%d.ply", "-o", tmp_path / "out.gif", env={"PATH": program})
    assert result.code == 1 and "ffmpeg" in result.error and "%04d" in result.error
    assert not (tmp_path / "out.gif").exists()


@pytest.mark.parametrize("source, arguments, code, words", [
    ("ball_%d.ply", ["-o", "out.png"], 2, ["out_%04d.png"]), ("ball_%d.ply", ["-o", "o_%s.png"], 2, ["out_%04d.png"]),
    ("ball_8.ply", ["-o", "out.mp4"], 2, ["--frames"]), ("ball_8.ply", ["--frames", "x", "-o", "o_%d.png"], 2, ["--frames 'x'"]),
    ("ball_8.ply", ["--frames", "0", "-o", "o_%d.png"], 2, ["from 1"]),
    ("ball_8.ply", ["--frames", "1:2", "-o", "o_%d.png"], 2, ["once around"]),
    ("ball_%d.ply", ["--frames", "3:9", "-o", "o_%d.png"], 2, ["0 to 4"]),
    ("ball_%d.ply", ["--frames", "3:2", "-o", "o_%d.png"], 2, ["--frames '3:2'"]),
    ("cube_%d.ply", ["-o", "o_%d.png"], 1, ["pattern"]), ("none.pvd", ["-o", "o_%d.png"], 1, ["no such file"]),
    ("ball_%d.ply", ["--style", "stipple", "-o", "o_%d.png"], 2, ["series"]),
    ("ball_%d.ply", ["--transparent", "-o", "o.mp4"], 2, ["--transparent"]),
    ("ball_%d.ply", ["-o", "no/such/folder_%d.png"], 1, ["no directory"]),
])
@pytest.mark.one_build
def test_wrong_usage(ink, series, tmp_path, source, arguments, code, words):
    result = ink("render", series / source, *arguments, cwd=tmp_path)
    assert result.code == code and all(word in result.error for word in words), result
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("name, text, words", [
    ("a.pvd", "<VTKFile/>", ["Collection"]), ("a.pvd", "no XML", ["Collection"]),
    ("a.pvd", "<VTKFile><Collection><DataSet timestep='x' file='a.ply'/></Collection></VTKFile>", ["timestep"]),
    ("a.pvd", "<VTKFile><Collection/></VTKFile>", ["no files"]),
    ("a.pvd", "<VTKFile><Collection><DataSet timestep='1' file='a'/><DataSet timestep='1' part='1' file='b'/></Collection></VTKFile>",
     ["several", "time 1"]),
    ("a.vtp.series", "[", ["JSON"]), ("a.vtp.series", '{"files": [{"name": 3, "time": 1}]}', ["JSON"]),
    ("a.vtp.series", '{"files": [{"name": "missing.vtp", "time": 1}]}', ["missing.vtp", "no such file"]),
])
@pytest.mark.one_build
def test_broken_series(ink, tmp_path, name, text, words):
    (tmp_path / name).write_text(text)
    result = ink("render", tmp_path / name, "-o", tmp_path / "o_%d.png")
    assert result.code == 1 and all(word in result.error for word in words), result


@pytest.mark.one_build
def test_only_render_takes_series(ink, series, tmp_path):
    result = ink("sample", pvd(series), tmp_path / "out.vtp")
    assert result.code == 1 and "series" in result.error
