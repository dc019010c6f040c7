# SPDX-License-Identifier: BSD-3-Clause
"""Bad input: one line on stderr, the promised exit code, and the output file as it was."""

import os
import signal
import subprocess
import time

import numpy as np
import pytest

import ink_files
from conftest import TIME_LIMIT

OLD = b"an old picture"


@pytest.fixture
def refused(ink, tmp_path):
    """Runs a rendering that has to fail and returns its message."""

    def run(code, *arguments, env=None):
        out = tmp_path / "kept" / "out.png"
        out.parent.mkdir(exist_ok=True)
        out.write_bytes(OLD)
        result = ink("render", *arguments, "-o", out, env=env)
        assert result.code == code, result
        assert result.out == ""
        assert out.read_bytes() == OLD
        assert os.listdir(out.parent) == ["out.png"], "a temporary file is left"
        return result.error

    return run


NRRD = "NRRD0004\ntype: uchar\ndimension: {}\nsizes: {}\nencoding: raw\n\n"


@pytest.mark.parametrize("dimension, sizes", [
    ("1", "24"), ("2", "2 2"), ("5", "2 2 2 2 2"), ("3", "2 2"), ("x", "2 2 2"), ("3", "-2 2 2"), ("3", "0 2 2"),
    ("3", "4294967296 4294967296 2"), ("3", "1e30 1 1"), ("4", "1000000000 1000000000 1000000000 1000000000"),
])
def test_nrrd_sizes_that_are_none(refused, tmp_path, dimension, sizes):
    path = tmp_path / "v.nrrd"
    path.write_bytes(NRRD.format(dimension, sizes).encode() + bytes(64))
    assert "sizes" in refused(1, path)


@pytest.mark.parametrize("form", ["ascii", "binary_little_endian"])
@pytest.mark.parametrize("properties", ["", "property float x\n", "property list double int x\n"])
def test_ply_headers_that_promise_too_much(refused, tmp_path, form, properties):
    path = tmp_path / "m.ply"
    path.write_text(f"ply\nformat {form} 1.0\nelement vertex 999999999999999999\n{properties}end_header\n1\n")
    assert "header" in refused(1, path)


def test_output_in_the_current_folder(ink, volume_file, tmp_path):
    result = ink("render", volume_file, "--iso", 100, "--size", "32x32", "-o", "new.png", cwd=tmp_path)
    assert result.code == 0, result
    assert os.listdir(tmp_path) == ["new.png"]


@pytest.mark.parametrize("arguments", [["rendr", "v.nii"], ["render", "v.nii", "-o", "a.png", "--isovalue", "80"]])
@pytest.mark.one_build
def test_unknown_arguments_are_named(ink, arguments):
    result = ink(*arguments)
    assert result.code == 2
    assert ("'rendr'" if "rendr" in arguments else "'--isovalue'") in result.error


@pytest.mark.parametrize("arguments, meant", [
    (["rendr", "v.nii"], "render"), (["inof", "v.nii"], "info"), (["render", "v.nii", "-o", "a.png", "--isovalue", "80"], None),
    (["render", "v.nii", "-o", "a.png", "--siz=80"], "--size"), (["render", "v.nii", "--siz", "80", "-o", "a.png"], "--size"),
    (["render", "v.nii", "-o", "a.png", "--azimut", "80"], "--azimuth"),
    (["render", "v.nii", "-o", "a.png", "--elevaiton", "80"], "--elevation"), (["render", "v.nii", "-o", "a.png", "--view", "fornt"], "front"),
    (["render", "v.nii", "-o", "a.png", "--style", "stiple"], "stipple"), (["style", "splating-lines"], "splatting-lines"),
    (["render", "v.nii", "-o", "a.png", "--preset", "specimn"], "specimen"),
    (["render", "v.nii", "-o", "a.png", "--style", "stipple", "--preset", "enginering"], "engineering"), (["render", "v.nii", "-o", "a.png", "--preset", "q"], None),
    (["sample", "v.nii", "a.vtp", "--arrays", "normals"], "Normals"), (["render", "v.nii", "-o", "a.png", "--xyzzy"], None)])  # fmt: skip
@pytest.mark.one_build
def test_what_was_meant(ink, arguments, meant):
    result = ink(*arguments)
    assert result.code == 2
    assert ("did you mean" in result.error) == (meant is not None)
    assert meant is None or result.error.endswith(f"; did you mean '{meant}'?")


@pytest.mark.parametrize("arguments, message", [
    (["sample", "v.nii", "a.vtp", "--iso", "abc"], "--iso 'abc': expected a number"),
    (["sample", "v.nii", "a.vtp", "--iso", "1,x"], "--iso 'x': expected a number"),
    (["sample", "v.ply", "a.vtp", "--seed", "1.5"], "--seed '1.5': expected a whole number from -2.147484e+09 to 2.147484e+09"),
    (["sample", "v.ply", "a.vtp", "--seed"], "--seed: expected N, found nothing"),
    (["render", "v.nii"], "OUT or --output: required, found nothing (see ink render --help)"),
    (["render", "-o", "a.png"], "FILE: required, found nothing (see ink render --help)"),
    (["render", "v.nii", "-o", "a.png", "--zoom", "1", "--zoom", "2"], "--zoom: expected once, found 2 times"),
    (["render", "v.nii", "-o", "a.png", "--big-endian"], "--big-endian: expected with --raw"),
    (["sample", "v.ply", "a.vtp", "--radius", "1", "--count", "5"], "--count: expected without --radius"),
    (["render", "v.nii", "-o", "a.png", "--view", "behind"], "--view 'behind': expected back, bottom, front, iso, left, right or top"),
    (["render", "v.nii", "-o", "a.png", "--zoom", "0"], "--zoom '0': expected a number from 0.01 to 1000"),
    (["render", "v.nii", "a.png", "w.nii"], "'w.nii': one argument too many, expected FILE OUT (see ink render --help)"),
    (["render", "v.nii", "w.nii", "-o", "a.png"], "OUT or --output: expected once, found 2 times"),
    (["generate", "fish"], "'fish': expected bash, man or zsh")])  # fmt: skip
@pytest.mark.one_build
def test_messages_are_inks_own(ink, arguments, message):
    result = ink(*arguments)
    assert result.code == 2
    assert result.error.removeprefix("ink: error: ").endswith(message)


def test_missing_file(refused, tmp_path):
    assert "no such file" in refused(1, tmp_path / "absent.nii")


def test_directory_without_dicom(refused, tmp_path):
    (tmp_path / "folder").mkdir()
    assert "without DICOM files" in refused(1, tmp_path / "folder")
    (tmp_path / "folder" / "readme.txt").write_text("nothing")
    assert "without DICOM files" in refused(1, tmp_path / "folder")


def test_empty_file(refused, tmp_path):
    (tmp_path / "empty.nii").touch()
    assert "empty" in refused(1, tmp_path / "empty.nii")


def test_not_a_file(refused, tmp_path):
    os.mkfifo(tmp_path / "pipe.nii")
    assert "regular file" in refused(1, tmp_path / "pipe.nii")


@pytest.mark.skipif(os.geteuid() == 0, reason="root may read everything")
def test_unreadable_file(refused, volume_file, tmp_path):
    path = tmp_path / "secret.vti"
    path.write_bytes(volume_file.read_bytes())
    path.chmod(0)
    assert "permission denied" in refused(1, path)


def test_unknown_type(refused, tmp_path):
    (tmp_path / "drawing.docx").write_bytes(b"hello")
    message = refused(1, tmp_path / "drawing.docx")
    assert "'.docx'" in message and ".nii.gz" in message


@pytest.mark.parametrize("suffix", [".nii", ".nii.gz", ".nrrd", ".nhdr", ".mha", ".mhd", ".vti", ".vtr", ".vts", ".vtk", ".ply", ".obj", ".stl", ".vtp", ".vtu", ".gii", ".pcd"])
@pytest.mark.parametrize("content", [b"This is no volume.\n", bytes(range(256)) * 20, b"\n", b"\0" * 1000],
                         ids=["text", "bytes", "newline", "zeros"])
def test_contents_that_are_something_else(ink, tmp_path, suffix, content):
    path = tmp_path / ("file" + suffix)
    path.write_bytes(content)
    result = ink("info", path)
    assert result.code == 1
    assert path.name in result.error


def test_missing_data_files(refused, tmp_path):
    ink_files.write_metaimage(tmp_path / "v.mhd", ink_files.blob())
    ink_files.write_nrrd(tmp_path / "w.nhdr", ink_files.blob())
    (tmp_path / "v.raw").unlink()
    (tmp_path / "w.raw").unlink()
    assert "v.mhd" in refused(1, tmp_path / "v.mhd")
    assert "w.raw" in refused(1, tmp_path / "w.nhdr")


def test_encodings_that_are_none(refused, tmp_path):
    ink_files.write_nrrd(tmp_path / "v.nrrd", ink_files.blob(), "bzip2")
    assert "'bzip2'; expected raw, gzip or ascii" in refused(1, tmp_path / "v.nrrd")


# What made VTK's readers crash or hang, or say something before ink did, each with what the one line has to name.
TRIANGLE_PLY = ("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
NRRD_WITH_DIRECTIONS = ("NRRD0004\ntype: uchar\ndimension: 3\nspace: left-posterior-superior\nsizes: 2 2 2\n"
                        "space directions: (1,0,0) (0,1,0) (0,0,1)\nencoding: raw\n\n12345678")
QUAD_OBJ = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1 4//1\n"
META = ("ObjectType = Image\nNDims = 3\nBinaryData = True\nDimSize = 2 2 2\nElementType = MET_UCHAR\n"
        "ElementDataFile = LOCAL\n12345678")
POINTS_VTP = ('<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian"><PolyData><Piece NumberOfPoints="3" '
              'NumberOfVerts="1" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="0"><Points><DataArray type="Float32" '
              'NumberOfComponents="3" format="ascii">0 0 0 1 0 0 1 1 0</DataArray></Points><Verts><DataArray type="Int64" '
              'Name="connectivity" format="ascii">0 1 2</DataArray><DataArray type="Int64" Name="offsets" format="ascii">3'
              '</DataArray></Verts></Piece></PolyData></VTKFile>\n')
TETRAHEDRON_VTU = ('<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian"><UnstructuredGrid>'
                   '<Piece NumberOfPoints="4" NumberOfCells="1"><Points><DataArray type="Float32" NumberOfComponents="3" '
                   'format="ascii">0 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points><Cells><DataArray type="Int64" '
                   'Name="connectivity" format="ascii">0 1 2 3</DataArray><DataArray type="Int64" Name="offsets" format="ascii">4'
                   '</DataArray><DataArray type="UInt8" Name="types" format="ascii">10</DataArray></Cells></Piece>'
                   '</UnstructuredGrid></VTKFile>\n')
LEGACY = ("# vtk DataFile Version 3.0\ntest\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 2 2\nPOINT_DATA 8\n"
          "SCALARS a float 1\nLOOKUP_TABLE default\n1 2 3 4 5 6 7 8\n")


@pytest.mark.parametrize("name, whole", [("m.ply", TRIANGLE_PLY), ("v.nrrd", NRRD_WITH_DIRECTIONS), ("m.obj", QUAD_OBJ),
                                         ("v.mha", META), ("m.vtp", POINTS_VTP), ("m.vtu", TETRAHEDRON_VTU), ("v.vtk", LEGACY)])
def test_files_that_are_broken_below_can_be_read(ink, tmp_path, name, whole):
    (tmp_path / name).write_text(whole)
    result = ink("info", tmp_path / name)
    assert result.code == 0, result


@pytest.mark.parametrize("name, whole, part, change, expected", [
    # Crashes.
    ("m.ply", TRIANGLE_PLY, "vertex_indices", "vertex_indicex", "'vertex_indices'"),
    ("m.ply", TRIANGLE_PLY, "vertex_indices", "v", "'vertex_indices'"),
    ("m.ply", TRIANGLE_PLY, "list uchar int vertex_indices", "int vertex_indices", "'vertex_indices'"),
    ("m.ply", TRIANGLE_PLY, "element vertex 3", "elemenu vertex 3", "elemenu vertex 3"),
    ("m.ply", TRIANGLE_PLY, "element vertex 3", "elementvertex 3", "elementvertex 3"),
    ("m.ply", TRIANGLE_PLY, "element vertex 3", "element vertex", "'element vertex'"),
    ("m.ply", TRIANGLE_PLY, "element vertex 3", "element 3", "'element 3'"),
    ("m.ply", TRIANGLE_PLY, "element vertex 3", "\n", "'property float x'"),
    ("m.ply", TRIANGLE_PLY, "element vertex 3\nproperty float x", "property float x\nelement vertex 3", "'property float x'"),
    ("m.ply", TRIANGLE_PLY, "property float z", "property float", "'property float'"),
    ("m.obj", QUAD_OBJ, "vn 0 0 1\n", "", "normal"),
    ("v.mha", META, "NDims = 3", "NDims = 0", "NDims"),
    # Hangs.
    ("v.nrrd", NRRD_WITH_DIRECTIONS, "(1,0,0) (0,1,0) (0,0,1)", "(1,0,0) (0,1,0) (0,", "space directions"),
    ("v.nrrd", NRRD_WITH_DIRECTIONS, "(1,0,0) (0,1,0) (0,0,1)", "(1,0,0) (0,", "space directions"),
    ("v.nrrd", NRRD_WITH_DIRECTIONS, "(1,0,0) (0,1,0) (0,0,1)", "(1,", "space directions"),
    ("v.nrrd", NRRD_WITH_DIRECTIONS, "(1,0,0) (0,1,0) (0,0,1)", "(1,0,0) (0,1,0) (0,0,)", "space directions"),
    # Memory for numbers of points that are not there.
    ("m.vtp", POINTS_VTP, ">3</DataArray></Verts>", ">3000000000</DataArray></Verts>", "3e+09 points"),
    ("m.vtp", POINTS_VTP, 'NumberOfPoints="3"', 'NumberOfPoints="3000000000"', "points"),
    ("m.vtu", TETRAHEDRON_VTU, 'NumberOfCells="1"', 'NumberOfCells="3000000000"', "cells"),
    # Cells that VTK would look for beyond the points.
    ("m.vtu", TETRAHEDRON_VTU, "0 1 2 3<", "0 1 2 4<", "a cell has point 4, but there are 4 points"),
    ("m.vtu", TETRAHEDRON_VTU, ">10<", ">12<", "expected 8"),
    # The library's messages before ours.
    ("v.vtk", LEGACY, "ASCII", "ASCIJ", "'ascij'"),
    ("v.vtk", LEGACY, "DATASET", "DATASEU", "'dataseu'"),
])
@pytest.mark.parametrize("command", ["info", "render", "sample"])
def test_broken_files_are_refused_in_one_line(ink, tmp_path, command, name, whole, part, change, expected):
    path = tmp_path / name
    assert part in whole
    path.write_text(whole.replace(part, change, 1))
    result = ink(command, path, *{"info": [], "render": ["-o", tmp_path / "out.png"], "sample": [tmp_path / "out.vtp"]}[command])
    assert result.code == 1, result
    assert expected in result.error
    assert os.listdir(tmp_path) == [name]


def test_one_slice(refused, tmp_path):
    ink_files.write_vti(tmp_path / "v.vti", ink_files.blob()[15:16])
    for options in (["--iso", 50], [], ["--style", "stipple"]):
        message = refused(1, tmp_path / "v.vti", *options)
        assert "the volume is a single slice, 32 x 32 x 1 voxels: expected two slices or more" in message


def test_mesh_whose_faces_name_missing_points(refused, tmp_path):
    points, normals, triangles = ink_files.sphere_mesh(6, 8)
    ink_files.write_ply(tmp_path / "m.ply", (points, normals, triangles + 3))
    assert "points" in refused(1, tmp_path / "m.ply")


@pytest.mark.parametrize("iso", ["-1", "0", "201", "1e30"])
def test_iso_out_of_range(refused, volume_file, iso):
    message = refused(2, volume_file, "--iso", "100", "--iso", iso)
    assert "--iso" in message and " 0 " in message


@pytest.mark.parametrize("iso", ["nan", "inf", "-inf"])
@pytest.mark.one_build
def test_iso_that_is_no_number(refused, volume_file, iso):
    message = refused(2, volume_file, "--iso", "100", "--iso", iso)
    assert "--iso" in message and "number" in message and iso in message


def test_iso_of_a_mesh(refused, tmp_path):
    ink_files.write_vtp(tmp_path / "m.vtp", ink_files.sphere_mesh(6, 8))
    assert "mesh" in refused(2, tmp_path / "m.vtp", "--iso", "1")


@pytest.mark.parametrize("size", ["0x5", "5x0", "1000000x1000000", "99999999999x1", "100001x1", "60000x60000", "x", "0", "100x", "-5x5", "5x5x5", "axb", ""])
@pytest.mark.one_build
def test_absurd_size(refused, volume_file, size):
    assert "--size" in refused(2, volume_file, "--size", size)


@pytest.mark.parametrize("option, value", [
    ("--tau", "0"), ("--tau", "nan"), ("--phi", "-1"), ("--phi", "x"), ("--lambda", "0"), ("--sigma", "1e9"),
    ("--zoom", "0"), ("--zoom", "inf"), ("--azimuth", "nan"), ("--elevation", "1000"), ("--view", "behind"), ("--style", "oil"),
    ("--iso", "dense"), ("--ink-color", "#12"), ("--paper-color", "no color"), ("--background", "")])
@pytest.mark.one_build
def test_values_that_options_do_not_take(refused, volume_file, option, value):
    assert option in refused(2, volume_file, option, value)


@pytest.mark.parametrize("layout", ["", "32x32:uint8", "32x32x32", "32x32x32:uint7", "0x32x32:uint8", "32x32x32:", "axbxc:uint8"])
@pytest.mark.one_build
def test_raw_layouts_that_are_none(refused, tmp_path, layout):
    (tmp_path / "v.raw").write_bytes(bytes(32**3))
    assert "--raw" in refused(2, tmp_path / "v.raw", "--raw", layout)


@pytest.mark.parametrize("layout, bytes_needed", [("32x32x33:uint8", 33792), ("32x32x31:uint8", 31744), ("32x32x32:int16", 65536),
                                                  ("999999x999999x999999:float64", 7999976000023999992)])
@pytest.mark.one_build
def test_raw_size_mismatch(refused, tmp_path, layout, bytes_needed):
    (tmp_path / "v.raw").write_bytes(bytes(32**3))
    message = refused(1, tmp_path / "v.raw", "--raw", layout)
    assert "32768 bytes" in message and str(bytes_needed) in message


@pytest.mark.parametrize("spacing", ["1,2", "1,2,3,4", "0,1,1", "-1,1,1", "nan,1,1", "a,b,c"])
@pytest.mark.one_build
def test_spacings_that_are_none(refused, tmp_path, spacing):
    (tmp_path / "v.raw").write_bytes(bytes(32**3))
    assert "--spacing" in refused(2, tmp_path / "v.raw", "--raw", "32x32x32:uint8", "--spacing", spacing)


@pytest.mark.parametrize("arguments", [[], ["paint"], ["render"], ["render", "a.nii"], ["info"], ["render", "a.nii", "-o"],
                                       ["render", "a.nii", "b.nii", "-o", "c.png"], ["--no-such-option"]])
@pytest.mark.one_build
def test_wrong_usage(ink, arguments):
    result = ink(*arguments)
    assert result.code == 2
    assert result.error


@pytest.mark.parametrize("name, expected", [("absent/out.png", "no directory"), ("folder.png", "is a directory"),
                                            ("volume.vti/out.png", "irectory")])
def test_outputs_that_cannot_be(ink, volume_file, tmp_path, name, expected):
    (tmp_path / "folder.png").mkdir()
    (tmp_path / "volume.vti").write_bytes(volume_file.read_bytes())
    before = sorted(os.listdir(tmp_path))
    result = ink("render", volume_file, "-o", tmp_path / name)
    assert result.code == 1
    assert expected in result.error
    assert sorted(os.listdir(tmp_path)) == before


def test_output_of_another_type(ink, volume_file, tmp_path):
    result = ink("render", volume_file, "-o", tmp_path / "out.bmp")
    assert result.code == 2
    assert ".png" in result.error


def test_output_where_nobody_may_write(ink, volume_file):
    result = ink("render", volume_file, "--size", "32x32", "-q", "-o", "/proc/ink-test.png")
    assert result.code == 1
    assert "/proc/ink-test.png" in result.error


def test_full_disk(ink, volume_file, tmp_path):
    (tmp_path / "full.png").symlink_to("/dev/full")
    result = ink("render", volume_file, "--size", "32x32", "-q", "-o", tmp_path / "full.png")
    assert result.code == 1
    assert "No space left" in result.error


def test_existing_file_is_replaced_with_its_permissions(ink, volume_file, tmp_path):
    out = tmp_path / "out.png"
    out.write_bytes(OLD)
    out.chmod(0o640)
    (tmp_path / "link.png").symlink_to(out)
    assert ink("render", volume_file, "--size", "32x32", "-q", "-o", tmp_path / "link.png").code == 0
    assert (tmp_path / "link.png").is_symlink()
    assert ink_files.read_png(out).shape == (32, 32, 3)
    assert out.stat().st_mode & 0o777 == 0o640
    assert sorted(os.listdir(tmp_path)) == ["link.png", "out.png"]


@pytest.mark.parametrize("delay", [0.05, 0.2, 0.4, 0.8])
def test_interruption_leaves_nothing_behind(volume_file, tmp_path, delay):
    out = tmp_path / "out.png"
    out.write_bytes(OLD)
    # Shells let what they run in the background ignore it.
    heed = lambda: signal.signal(signal.SIGINT, signal.SIG_DFL)
    command = ["ink", "render", volume_file, "--size", "1500x1500", "-q", "-o", out]
    process = subprocess.Popen(command, stderr=subprocess.PIPE, preexec_fn=heed)
    time.sleep(delay)
    process.send_signal(signal.SIGINT)
    process.communicate(timeout=TIME_LIMIT)
    # A fast machine may be done before.
    assert process.returncode == -signal.SIGINT or (delay > 0.1 and process.returncode == 0)
    assert os.listdir(tmp_path) == ["out.png"]
    if process.returncode != 0:
        assert out.read_bytes() == OLD


def test_no_display(ink, refused, volume_file):
    if "vtkXOpenGLRenderWindow" not in ink("--version").out:
        pytest.skip("this VTK draws without a display")
    assert "xvfb-run" in refused(1, volume_file, env={"DISPLAY": ""})
    assert ":12345" in refused(1, volume_file, env={"DISPLAY": ":12345"})
