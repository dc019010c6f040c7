# SPDX-License-Identifier: BSD-3-Clause
"""Volumes larger than `--memory`: read a few slices at a time, with the same result as in one piece."""

import os
import re
import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest

import ink_files

# The least that ink accepts: 8 MiB of it are for slices, and volumes above 16 MiB are not read whole.
LITTLE = "128MiB"
PLENTY = "2GiB"


def waves(shape, dtype=np.uint8):
    """Values with surfaces everywhere, [z, y, x] or [z, y, x, component], also across the borders of parts."""
    z, y, x = np.meshgrid(*[np.arange(n) for n in shape[:3]], indexing="ij", sparse=True)
    values = np.sin(x / 9) * np.cos(y / 11) + np.sin(z / 5 + x / 40)
    values = np.where(np.hypot(x - shape[2] / 2, y - shape[1] / 2) < 60, values, -2) * 30 + 60
    if len(shape) == 4:
        values = np.stack([values, *[values[..., ::-1]] * (shape[3] - 1)], axis=-1)
    return values.astype(dtype)


SHAPES = {1: (72, 512, 512), 2: (72, 512, 256), 4: (72, 256, 256), 8: (72, 256, 128)}
TYPES = ["uint8", "int8", "uint16", "int16", "uint32", "int32", "uint64", "int64", "float32", "float64"]


@pytest.fixture
def same(ink, tmp_path):
    """Runs `ink sample` with little and with plenty of memory, compares the files, returns their columns."""

    def run(file, *arguments):
        results = []
        for name, memory in (("parts.vtp", LITTLE), ("whole.vtp", PLENTY)):
            result = ink("sample", file, tmp_path / name, "--memory", memory, *arguments)
            assert result.code == 0, result
            results.append(result)
        # Notes and the number of points, too, but for the files' names.
        assert "parts.vtp" in results[0].err and "whole.vtp" in results[1].err
        assert replace(results[0], err=results[0].err.replace("parts.vtp", "whole.vtp")) == results[1]
        assert (tmp_path / "parts.vtp").read_bytes() == (tmp_path / "whole.vtp").read_bytes()
        return ink_files.read_points(tmp_path / "whole.vtp")

    return run


@pytest.mark.parametrize("name, order", [*[(name, "<") for name in TYPES], ("int16", ">"), ("uint32", ">"), ("float64", ">")])
@pytest.mark.one_build
def test_raw_files_of_all_types(same, tmp_path, name, order):
    dtype = np.dtype(name)
    volume = waves(SHAPES[dtype.itemsize], dtype)
    assert volume.nbytes > 16 << 20
    (tmp_path / "v.raw").write_bytes(volume.astype(dtype.newbyteorder(order)).tobytes())
    nz, ny, nx = volume.shape
    columns = same(tmp_path / "v.raw", "--raw", f"{nx}x{ny}x{nz}:{name}", "--spacing", "1,1,3", "--iso", 70,
                   *(["--big-endian"] if order == ">" else []))
    assert len(columns["x"]) > 30000
    assert columns["z"].max() > 3 * (nz - 3), "points of all parts"


def write_parts(path, volume, format, order="<", skipped=0):
    """A MetaImage or NRRD volume: whatever of the formats VTK reads without decompressing."""
    shape = volume.shape
    nz, ny, nx = shape[:3]
    components = shape[3] if volume.ndim == 4 else 1
    data = volume.astype(volume.dtype.newbyteorder(order)).tobytes()
    detached = path.suffix in (".mhd", ".nhdr")
    if format == "metaimage":
        kind = {"uint8": "UCHAR", "int16": "SHORT", "float32": "FLOAT"}[volume.dtype.name]
        lines = ["ObjectType = Image", "NDims = 3", "BinaryData = True", f"BinaryDataByteOrderMSB = {order == '>'}",
                 "CompressedData = False", "TransformMatrix = 0 1 0 -1 0 0 0 0 1", "Offset = 5 6 7", "ElementSpacing = 1 2 3",
                 f"DimSize = {nx} {ny} {nz}", f"ElementNumberOfChannels = {components}"]
        if skipped:
            lines += ["HeaderSize = " + str(skipped)]
        lines += [f"ElementType = MET_{kind}", f"ElementDataFile = {'v.data' if detached else 'LOCAL'}", ""]
    else:
        kind = {"uint8": "uchar", "int16": "short", "float32": "float"}[volume.dtype.name]
        space = "left-anterior-superior" if format == "flipped" else "left-posterior-superior"
        sizes, directions = f"{nx} {ny} {nz}", "(1,0,0) (0,2,0) (0,0,3)"
        if components > 1:
            sizes, directions = f"{components} {sizes}", "none " + directions
        lines = ["NRRD0004", f"type: {kind}", f"dimension: {3 + (components > 1)}", f"sizes: {sizes}", f"space: {space}",
                 f"space directions: {directions}", f"endian: {'big' if order == '>' else 'little'}", "encoding: raw",
                 "space origin: (5,6,7)"]
        lines += ["data file: v.data", ""] if detached else ["", ""]
    head = "\n".join(lines).encode()
    path.write_bytes(head if detached else head + data)
    if detached:
        (path.parent / "v.data").write_bytes((b"\n" * 100 if skipped else b"") + data)


@pytest.mark.parametrize("name, format, dtype, arguments", [
    ("v.mha", "metaimage", "uint8", {}), ("v.mha", "metaimage", "int16", {"order": ">"}), ("v.mhd", "metaimage", "float32", {}),
    ("v.mhd", "metaimage", "uint8", {"skipped": -1}), ("v.mhd", "metaimage", "int16", {"skipped": 100}),
    ("v.nrrd", "nrrd", "int16", {}), ("v.nrrd", "nrrd", "float32", {"order": ">"}), ("v.nhdr", "nrrd", "uint8", {}),
    ("v.nrrd", "flipped", "int16", {})])
@pytest.mark.one_build
def test_metaimage_and_nrrd(same, tmp_path, name, format, dtype, arguments):
    volume = waves(SHAPES[np.dtype(dtype).itemsize], dtype)
    write_parts(tmp_path / name, volume, format, **arguments)
    columns = same(tmp_path / name, "--iso", 70, "--iso", 40)
    assert len(columns["x"]) > 60000
    assert set(columns["SurfaceIndex"]) == {0, 1}


@pytest.mark.parametrize("name, write", [("v.nii", ink_files.write_nifti), ("v.vtk", ink_files.write_legacy)])
def test_nifti_and_legacy_vtk(same, tmp_path, name, write):
    write(tmp_path / name, waves(SHAPES[2], np.int16))
    assert len(same(tmp_path / name, "--iso", 70)["x"]) > 30000


@pytest.mark.parametrize("name, format", [("v.mha", "metaimage"), ("v.nrrd", "nrrd")])
@pytest.mark.one_build
def test_the_first_of_several_components(same, ink, tmp_path, name, format):
    volume = waves((72, 256, 128, 3), np.int16)
    write_parts(tmp_path / name, volume, format)
    one = same(tmp_path / name, "--iso", 70)
    write_parts(tmp_path / name, np.ascontiguousarray(volume[..., 0]), format)
    other = same(tmp_path / name, "--iso", 70)
    for column in other:
        assert np.array_equal(one[column], other[column])


@pytest.mark.parametrize("rule, precision", [("half-open", "double"), ("strict", "float")])
@pytest.mark.one_build
def test_rules_and_precisions(same, tmp_path, rule, precision):
    volume = (waves(SHAPES[1]) // 20 * 20).astype(np.uint8)
    (tmp_path / "v.raw").write_bytes(volume.tobytes())
    same(tmp_path / "v.raw", "--raw", "512x512x72:uint8", "--iso", 60, "--rule", rule, "--precision", precision)


@pytest.mark.parametrize("dtype", ["uint8", "float32"])
@pytest.mark.one_build
def test_chosen_iso_values_and_info(same, ink, tmp_path, dtype):
    """Statistics are the same, too, with values that are not finite."""
    volume = waves(SHAPES[np.dtype(dtype).itemsize], dtype)
    if dtype == "float32":
        volume[3, 4:9, 5] = np.nan
        volume[60, 7, 8] = np.inf
    nz, ny, nx = volume.shape
    (tmp_path / "v.raw").write_bytes(volume.tobytes())
    layout = ["--raw", f"{nx}x{ny}x{nz}:{dtype}"]
    same(tmp_path / "v.raw", *layout)
    little, plenty = (ink("info", tmp_path / "v.raw", *layout, "--memory", memory) for memory in (LITTLE, PLENTY))
    assert little.code == 0 and little == plenty
    assert ("not finite     6 voxels" in little.out) == (dtype == "float32")


@pytest.mark.one_build
def test_noise_has_more_points_than_memory(same, tmp_path):
    """Nearly every cell has a point: they are made a few layers at a time and wait in a file."""
    volume = np.random.default_rng(3).random((64, 200, 200))
    (tmp_path / "v.raw").write_bytes(volume.tobytes())
    columns = same(tmp_path / "v.raw", "--raw", "200x200x64:float64", "--iso", 0.5)
    assert len(columns["x"]) > 2e6
    assert sorted(os.listdir(tmp_path)) == ["parts.vtp", "v.raw", "whole.vtp"]


@pytest.mark.parametrize("style, smoothing, subdivision", [
    ("splatting-lines", 0, 1), ("illustration", 0, 1), ("splatting-lines", 1.5, 1), ("splatting-lines", 0, 2)])
def test_pictures_are_the_same(ink, tmp_path, style, smoothing, subdivision):
    """What is given is done a few slices at a time, too."""
    (tmp_path / "v.raw").write_bytes(waves(SHAPES[1]).tobytes())
    pictures = []
    for memory in (LITTLE, PLENTY):
        out = tmp_path / "picture.png"
        result = ink("render", tmp_path / "v.raw", "--raw", "512x512x72:uint8", "--iso", 70, "--size", "200x200", "--memory",
                     memory, "--style", style, "--smoothing", smoothing, "--subdivision", subdivision, "-q", "-o", out)
        assert result.code == 0, result
        pictures.append(ink_files.read_png(out).astype(int))
    assert pictures[0].min() < 100
    # Points come in another order, of which the last bit of a sum depends.
    assert np.abs(pictures[0] - pictures[1]).max() <= (1 if smoothing or subdivision > 1 else 0)


def noisy_waves():
    """Of which a surface is smoothed by half a voxel or so."""
    noise = np.random.default_rng(5).normal(20, 1.5, SHAPES[1])
    return np.clip(waves(SHAPES[1]) + noise, 0, 255).astype(np.uint8)


@pytest.fixture
def look(ink, tmp_path):
    """Draws noisy waves a hundred lines high; returns the picture, and what was said but for the last line."""
    noisy_waves().tofile(tmp_path / "v.raw")

    def run(width, *arguments):
        out = tmp_path / "picture.png"
        result = ink("render", tmp_path / "v.raw", "--raw", "512x512x72:uint8", "--iso", 90, "--size", f"{width}x100", "--view",
                     "top", "--style", "splatting-lines", "-o", out, *arguments)
        assert result.code == 0, result
        return ink_files.read_png(out).astype(int), "\n".join(result.err.splitlines()[:-1])

    return run


@pytest.mark.one_build
def test_what_is_chosen_is_the_same(look):
    """How much the noise asks to smooth, and how far voxels are divided, which are larger in a wider picture."""
    for width, subdivision in ((100, 1), (250, 2)):
        whole, parts = (look(width, "--memory", memory) for memory in (PLENTY, LITTLE))
        assert parts[1] == whole[1] == ""
        assert np.abs(parts[0] - whole[0]).max() <= 1
        assert np.array_equal(parts[0], look(width, "--memory", LITTLE, "--subdivision", subdivision)[0])
        assert np.abs(parts[0] - look(width, "--memory", LITTLE, "--smoothing", 0)[0]).max() > 50


@pytest.mark.one_build
def test_what_is_chosen_is_left_out_where_slices_have_no_room(ink, tmp_path):
    """The notes say how much memory is enough, and what to say instead."""
    values = np.random.default_rng(5).normal(20, 1.5, (18, 1024, 1024))
    values[9:, 200:500, 200:500] += 40
    values.astype(np.uint8).tofile(tmp_path / "v.raw")

    def notes(memory, *arguments):
        result = ink("render", tmp_path / "v.raw", "--raw", "1024x1024x18:uint8", "--iso", 40, "--size", "500x100", "--view", "front",
                     "--style", "splatting-lines", "--memory", memory, "-o", tmp_path / "picture.png", *arguments)
        assert result.code == 0, result
        return result.err.splitlines()[:-1]

    found = notes(LITTLE)
    parts = ("the surface is not smoothed", "--smoothing 0"), ("voxels are not divided", "--subdivision 1")
    assert len(found) == 2
    enough = []
    for note, (what, option) in zip(found, parts):
        text = rf"ink: {what}, as memory has room for 4 slices at a time: --memory (\d+) MiB is enough; {option} asks for no more"
        enough.append(int(re.fullmatch(text, note)[1]))
    assert notes(f"{max(enough)}MiB") == []
    assert notes(LITTLE, "--smoothing", 0, "--subdivision", 1) == []


def test_what_needs_more_slices_says_so(ink, tmp_path):
    (tmp_path / "v.raw").write_bytes(waves(SHAPES[1]).tobytes())
    for option, expected in ((["--smoothing", 8], "expected more --memory than 128 MiB, or less --smoothing"),
                             (["--see-through"], "--see-through needs the whole volume")):
        result = ink("render", tmp_path / "v.raw", "--raw", "512x512x72:uint8", "--iso", 70, "--memory", LITTLE, *option,
                     "-o", tmp_path / "picture.png")
        assert result.code != 0
        assert expected in result.err and len(result.err.splitlines()) == 1, result


MEASURE = """
import os, subprocess, sys
process = subprocess.Popen(sys.argv[1:])
_, status, usage = os.wait4(process.pid, 0)
print(usage.ru_maxrss)
sys.exit(os.waitstatus_to_exitcode(status))
"""


def peak_memory(*arguments):
    """MiB that a run of ink had resident at most. Started from a process of its own: what its parent has counts, too."""
    done = subprocess.run([sys.executable, "-S", "-c", MEASURE, "ink", *map(str, arguments)], capture_output=True, text=True)
    assert done.returncode == 0, done
    return int(done.stdout) / 1024


BALLS = [((700, 300, 90), 40), ((100, 620, 31), 20), ((1000, 1000, 250), 5)]


def ball(radius):
    axis = np.arange(-radius - 6, radius + 7)
    z, y, x = np.meshgrid(axis, axis, axis, indexing="ij")
    return np.clip(100 - 20 * (np.sqrt(x * x + y * y + z * z) - radius), 0, 255).astype(np.uint8)


def write_balls(path, head, dimensions, scale=1):
    """A file of zeros with a few balls in it. Where there are none it has holes, which take no disk."""
    nx, ny, nz = dimensions
    with open(path, "wb") as file:
        file.write(head)
        file.truncate(len(head) + nx * ny * nz)
        for center, radius in BALLS:
            x, y, z = np.array(center) * scale
            values = ball(radius)
            reach = len(values) // 2
            for k, slice in enumerate(values):
                for j, row in enumerate(slice):
                    file.seek(len(head) + ((z - reach + k) * ny + y - reach + j) * nx + x - reach)
                    file.write(row.tobytes())


def check_balls(sampled, crop, folder, scale=1):
    """The points of each ball are those of a small volume of its own, in the same order."""
    for center, radius in BALLS:
        center = np.array(center) * scale
        inside = np.all([abs(sampled[axis] - c) < radius + 6 for axis, c in zip("xyz", center)], axis=0)
        values = ball(radius)
        ink_files.write_metaimage(folder / "crop.mha", values, offset="%d %d %d" % tuple(center - len(values) // 2))
        expected = crop(folder / "crop.mha")
        assert inside.sum() == len(expected["x"]) > 0
        for column in expected:
            assert np.allclose(sampled[column][inside], expected[column], rtol=0, atol=1e-3), column


@pytest.fixture
def crop(ink, tmp_path):
    def run(file):
        assert ink("sample", file, tmp_path / "crop.vtp", "--iso", 100, "-q").code == 0
        return ink_files.read_points(tmp_path / "crop.vtp")

    return run


META = "ObjectType = Image\nNDims = 3\nBinaryData = True\nDimSize = 1024 1024 512\nElementType = MET_UCHAR\nElementDataFile = {}\n"
NRRD = "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 1024 1024 512\nencoding: raw\n{}\n"


@pytest.mark.parametrize("name, head", [("v.mha", META.format("LOCAL")), ("v.mhd", META.format("v.data")),
                                        ("v.nrrd", NRRD.format("")), ("v.nhdr", NRRD.format("data file: v.data\n"))],
                         ids=["mha", "mhd", "nrrd", "nhdr"])
def test_512_mib_under_256(crop, tmp_path, name, head):
    data = tmp_path / name
    if name in ("v.mhd", "v.nhdr"):
        data.write_text(head)
        data, head = tmp_path / "v.data", ""
    write_balls(data, head.encode(), (1024, 1024, 512))
    peak = peak_memory("sample", tmp_path / name, tmp_path / "out.vtp", "--iso", 100, "--memory", "256MiB", "-q")
    data.unlink()
    assert peak < 256
    check_balls(ink_files.read_points(tmp_path / "out.vtp"), crop, tmp_path)


@pytest.mark.one_build
def test_4_gib_under_1(crop, tmp_path):
    write_balls(tmp_path / "v.raw", b"", (2048, 2048, 1024), scale=2)
    peak = peak_memory("sample", tmp_path / "v.raw", tmp_path / "out.vtp", "--raw", "2048x2048x1024:uint8", "--iso", 100,
                       "--memory", "1GiB", "-q")
    (tmp_path / "v.raw").unlink()
    assert peak < 1024
    check_balls(ink_files.read_points(tmp_path / "out.vtp"), crop, tmp_path, scale=2)


@pytest.fixture
def refused(ink, tmp_path):
    """Runs ink on a file, which has to fail without writing, and returns the message."""

    def run(code, *arguments):
        result = ink(*arguments)
        assert result.code == code, result
        assert not (tmp_path / "out.vtp").exists()
        return result.error

    return run


@pytest.mark.parametrize("size", ["", "1", "100", "1e9", "-1GiB", "GiB", "127MiB", "1 lot", "nanGiB", "0.0001TiB"])
@pytest.mark.one_build
def test_sizes_that_are_none(refused, volume_file, tmp_path, size):
    assert "--memory" in refused(2, "sample", volume_file, tmp_path / "out.vtp", f"--memory={size}")


@pytest.mark.parametrize("size", ["128MiB", "0.2GiB", "1g", "1 GiB", "1T", "131072kib"])
@pytest.mark.one_build
def test_sizes(ink, volume_file, tmp_path, size):
    assert ink("sample", volume_file, tmp_path / "out.vtp", "--memory", size).code == 0


@pytest.mark.one_build
def test_slices_that_memory_cannot_hold(refused, ink, tmp_path):
    """The message says how much is enough."""
    with open(tmp_path / "v.raw", "wb") as file:
        file.truncate(3000 * 3000 * 20)
        file.seek(2 * 3000 * 3000 + 1500 * 3000 + 1500)
        file.write(b"\xff")
    command = ["sample", tmp_path / "v.raw", tmp_path / "out.vtp", "--raw", "3000x3000x20:uint8", "--iso", 100]
    message = refused(1, *command, "--memory", LITTLE)
    needed = re.search(r"expected --memory (\d+) MiB or more, found 128 MiB$", message)
    assert needed, message
    assert f"{needed[1]} MiB" in refused(1, *command, "--memory", f"{int(needed[1]) - 1}MiB")
    assert ink(*command, "--memory", f"{needed[1]}MiB").code == 0


@pytest.mark.one_build
def test_layers_with_more_points_than_memory_holds(refused, ink, tmp_path):
    volume = np.zeros((20, 1000, 1000), np.uint8)
    volume[10] = np.random.default_rng(3).integers(0, 256, (1000, 1000), np.uint8)
    (tmp_path / "v.raw").write_bytes(volume.tobytes())
    command = ["sample", tmp_path / "v.raw", tmp_path / "out.vtp", "--raw", "1000x1000x20:uint8", "--iso", 128]
    message = refused(1, *command, "--memory", LITTLE)
    needed = re.search(r"expected --memory (\d+) MiB or more$", message)
    assert needed, message
    assert ink(*command, "--memory", f"{int(needed[1])}MiB").code == 0


@pytest.mark.one_build
def test_more_points_than_can_be_drawn(refused, tmp_path):
    np.random.default_rng(3).integers(0, 256, (70, 500, 500), np.uint8).tofile(tmp_path / "v.raw")
    message = refused(1, "render", tmp_path / "v.raw", "-o", tmp_path / "out.png", "--raw", "500x500x70:uint8", "--iso", 128,
                      "--memory", LITTLE)
    assert "points" in message and "--memory" in message


@pytest.mark.parametrize("name, write", [
    ("v.nrrd", lambda p, v: ink_files.write_nrrd(p, v, "gzip")), ("v.mha", lambda p, v: ink_files.write_metaimage(p, v, compressed=True)),
    ("v.vti", ink_files.write_vti), ("v.nii.gz", ink_files.write_nifti)])
def test_files_that_can_only_be_read_whole(refused, ink, tmp_path, name, write):
    write(tmp_path / name, np.zeros((130, 1024, 1024), np.uint8))
    message = refused(1, "sample", tmp_path / name, tmp_path / "out.vtp", "--memory", LITTLE)
    assert "its voxels take 130 MiB" in message and "found 128 MiB" in message
    assert "all voxels have the value 0" in refused(1, "sample", tmp_path / name, tmp_path / "out.vtp", "--memory", PLENTY)


@pytest.mark.parametrize("name", ["v.mha", "v.mhd", "v.nrrd", "v.nhdr"])
@pytest.mark.one_build
def test_files_that_are_too_short(refused, tmp_path, name):
    write = ink_files.write_metaimage if name.startswith("v.m") else ink_files.write_nrrd
    write(tmp_path / name, waves(SHAPES[1]))
    data = tmp_path / ("v.raw" if name in ("v.mhd", "v.nhdr") else name)
    os.truncate(data, data.stat().st_size - 1)
    message = refused(1, "sample", tmp_path / name, tmp_path / "out.vtp", "--iso", 70, "--memory", LITTLE)
    assert str(waves(SHAPES[1]).size - 1) in message and str(waves(SHAPES[1]).size) in message


@pytest.mark.parametrize("values, message", [(0, "all voxels have the value 0"), (np.nan, "no voxel has a finite value")])
@pytest.mark.parametrize("arguments", [[], ["--iso", 5]])
@pytest.mark.one_build
def test_nothing_to_sample(refused, tmp_path, values, message, arguments):
    (tmp_path / "v.raw").write_bytes(np.full(SHAPES[4], values, np.float32).tobytes())
    assert message in refused(1, "sample", tmp_path / "v.raw", tmp_path / "out.vtp", "--raw", "256x256x72:float32", "--memory",
                              LITTLE, *arguments)


@pytest.mark.parametrize("iso", ["nan", "-1", "0", "1000"])
@pytest.mark.one_build
def test_iso_values_out_of_range(refused, tmp_path, iso):
    (tmp_path / "v.raw").write_bytes(waves(SHAPES[1]).tobytes())
    message = refused(2, "sample", tmp_path / "v.raw", tmp_path / "out.vtp", "--raw", "512x512x72:uint8", "--memory", LITTLE,
                      "--iso", 70, "--iso", iso)
    assert ("--iso 'nan': expected a number" if iso == "nan" else f"--iso {iso}: expected a value above 0 and up to") in message


@pytest.mark.parametrize("slices", [1, 2, 3])
@pytest.mark.one_build
def test_few_slices(ink, refused, tmp_path, slices):
    """Fewer than are needed at a time otherwise."""
    volume = np.zeros((slices, 2400 // slices, 1000))
    volume[0, 500, 500] = 1
    (tmp_path / "v.raw").write_bytes(volume.tobytes())
    command = ["sample", tmp_path / "v.raw", tmp_path / "out.vtp", "--raw", f"1000x{2400 // slices}x{slices}:float64"]
    for arguments in (["--iso", 0.5], []):
        if slices == 1:
            # More memory would not help.
            for memory in ("130MiB", "190MiB"):
                message = refused(1, *command, *arguments, "--memory", memory)
                assert "single slice, 1000 x 2400 x 1 voxels: expected two slices or more" in message
        else:
            assert "needed at a time" in refused(1, *command, *arguments, "--memory", "130MiB")
            assert ink(*command, *arguments, "--memory", "190MiB").code == 0
            (tmp_path / "out.vtp").unlink()


@pytest.mark.one_build
def test_label_maps(ink, tmp_path):
    """Are drawn as their mask, but for borders, smoothed, a few slices at a time, too."""
    z, y, x = np.ogrid[:72, :512, :512]
    inside = (z - 30.3) ** 2 * 100 + (y - 255.7) ** 2 + (x - 255.2) ** 2 < 200 ** 2
    ids = 1 + 80 * (x > 255) + 9 * (y > 255) + 0 * z
    pictures = {}
    for name, volume, borders in (("labels", inside * ids, "off"), ("mask", inside * 255, "auto"), ("borders", inside * ids, "on")):
        volume.astype(np.uint8).tofile(tmp_path / "v.raw")
        for memory in (LITTLE, PLENTY):
            out = tmp_path / "picture.png"
            result = ink("render", tmp_path / "v.raw", "--raw", "512x512x72:uint8", "--iso", 0.5, "--size", "200x200",
                         "--memory", memory, "--style", "splatting-lines", "--smoothing", 1.5, "--subdivision", 1, "-q", "-o",
                         out, "--label-borders", borders)
            assert result.code == 0, result
            pictures[name, memory] = ink_files.read_png(out).astype(int)
    whole = pictures["mask", PLENTY]
    assert whole.min() < 100
    borders = pictures.pop(("borders", PLENTY))
    assert np.abs(pictures.pop(("borders", LITTLE)) - borders).max() <= 1
    assert np.abs(borders - whole).max() > 30
    for picture in pictures.values():
        assert np.abs(picture - whole).max() <= 1


@pytest.mark.one_build
def test_thick_slices(ink, refused, tmp_path):
    """Contours are interpolated a few slices at a time as in memory, unless memory has no room for what distances reach into."""
    z, y, x = np.ogrid[:264, :256, :256]
    tubes = {"1,1,4": np.hypot(y - 127.7, x - 127.2 - 50 * np.sin(z / 15)), "4,1,1": np.hypot(y - 127.7, z - 132 - 50 * np.sin(x / 15))}

    def command(spacing, memory, interpolation):
        np.clip(100 - 60 * (tubes[spacing] - 40), 0, 200).astype(np.uint8).tofile(tmp_path / "v.raw")
        return ("render", tmp_path / "v.raw", "--raw", "256x256x264:uint8", "--spacing", spacing, "--iso", 20, "--size", "300x300",
                "--memory", memory, "--style", "splatting-lines", "--smoothing", 1, "--subdivision", 1,
                "--shape-based-interpolation", interpolation, "-o", tmp_path / "picture.png")

    def draw(*arguments):
        result = ink(*command(*arguments))
        assert result.code == 0, result
        return ink_files.read_png(tmp_path / "picture.png").astype(int), result.err

    # Room for 21 slices, and for 28.
    values = {}
    for spacing, memory in (("1,1,4", LITTLE), ("4,1,1", "138MiB")):
        contours, _ = draw(spacing, PLENTY, "auto" if spacing == "1,1,4" else "on")
        assert contours.min() < 100
        in_parts, notes = draw(spacing, memory, "on")
        assert np.abs(in_parts - contours).max() <= 1 and "contours" not in notes
        values[spacing], _ = draw(spacing, PLENTY, "off")
        assert np.abs(values[spacing] - contours).max() > 30
    # Across x, distances reach into the slices that are read.
    message = refused(1, *command("4,1,1", LITTLE, "on"))
    assert "needs 26 slices at a time" in message and "--shape-based-interpolation off, or less --smoothing" in message
    in_parts, notes = draw("4,1,1", LITTLE, "auto")
    assert "values are interpolated between slices, not contours, as memory has room for 21 slices at a time" in notes
    assert np.abs(in_parts - values["4,1,1"]).max() <= 1


@pytest.mark.one_build
def test_blocks_are_seen_from_a_corner(ink, tmp_path):
    """Also where they are read a few slices at a time."""
    voxels = np.zeros((280, 256, 256), np.uint8)
    voxels[40:160, 60:200, 50:210] = 200
    voxels.tofile(tmp_path / "v.raw")
    pictures = []
    for memory in (PLENTY, LITTLE):
        result = ink("render", tmp_path / "v.raw", "--raw", "256x256x280:uint8", "--iso", 100, "--memory", memory, "--style",
                     "splatting-lines", "--label-map", "off", "--smoothing", 0, "--size", 200, "-o", tmp_path / "picture.png")
        assert result.code == 0 and "is a block, so it is seen from a corner" in result.err, result
        pictures.append(ink_files.read_png(tmp_path / "picture.png").astype(int))
    assert np.abs(pictures[0] - pictures[1]).max() <= 1 and pictures[0].min() < 100
