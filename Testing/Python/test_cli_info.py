# SPDX-License-Identifier: BSD-3-Clause
"""`ink info` says what is in a file, and `ink --version` and `--help` what is in ink."""

import json
import re

import numpy as np
import pytest

import ink_files


def info(ink, *arguments):
    result = ink("info", *arguments)
    assert (result.code, result.err) == (0, ""), result
    fields = {}
    for line in result.out.splitlines():
        fields.setdefault(line[:15].strip(), line[15:])
    return fields


def test_volume(ink, tmp_path):
    ink_files.write_nifti(tmp_path / "v.nii.gz", ink_files.blob((20, 24, 28), np.int16) - np.int16(50), spacing=(0.5, 1, 2),
                          affine=[[0.5, 0, 0, 3], [0, 1, 0, 4], [0, 0, 2, 5]])
    fields = info(ink, tmp_path / "v.nii.gz")
    assert fields["format"] == "NIfTI volume"
    assert fields["dimensions"] == "28 x 24 x 20"
    assert fields["spacing"] == "0.5 1 2"
    # NIfTI's right and front are turned to DICOM's left and back.
    assert fields["origin"] == "-3 -4 5"
    assert fields["direction"] == "-1 0 0, 0 -1 0, 0 0 1"
    assert fields["type"] == "short (16 bits)"
    assert fields["components"] == "1"
    assert re.match(r"-50 to 14\d$", fields["range"])
    assert 0 < float(fields["suggested iso"].split()[0]) < 100


def test_mesh(ink, tmp_path):
    mesh = ink_files.sphere_mesh(6, 8)
    ink_files.write_vtp(tmp_path / "m.vtp", mesh)
    fields = info(ink, tmp_path / "m.vtp")
    assert fields["points"] == str(len(mesh[0]))
    assert fields["cells"] == str(len(mesh[2]))
    assert fields["bounds"].endswith("-1 to 1")
    assert fields["point arrays"] == "Normals: float, 3 components, -1 to 1"
    assert "cell arrays" not in fields


@pytest.mark.one_build
@pytest.mark.parametrize("where", ["PointData", "CellData"])
def test_arrays_of_images(ink, tmp_path, where):
    """Those of cells are those of voxels in their centers by then."""
    volume = ink_files.blob((8, 9, 10))
    nothing = np.full(volume.shape, np.nan, "f4")
    ink_files.write_vti(tmp_path / "v.vti", volume, where=where, temperature=np.linspace(-2, 5, volume.size), nothing=nothing)
    out = ink("info", tmp_path / "v.vti").out
    assert f"point arrays   density: unsigned char, 1 component, 0 to {volume.max()}\n" in out
    assert "\n               temperature: double, 1 component, -2 to 5\n               nothing: float, 1 component\n" in out
    found = json.loads(ink("info", "--json", tmp_path / "v.vti").out)[0]["point_arrays"]
    assert [(one["name"], one["range"]) for one in found[1:]] == [("temperature", [-2, 5]), ("nothing", None)]


@pytest.mark.one_build
def test_arrays_of_a_meshs_cells(ink, tmp_path):
    mesh = "POINTS 3 float\n0 0 0 1 0 0 0 1 0\nPOLYGONS 1 4\n3 0 1 2\nCELL_DATA 1\nVECTORS flow float\n3 -4 0\n"
    (tmp_path / "m.vtk").write_text("# vtk DataFile Version 3.0\nmesh\nASCII\nDATASET POLYDATA\n" + mesh)
    fields = info(ink, tmp_path / "m.vtk")
    assert fields["cell arrays"] == "flow: float, 3 components, -4 to 3"
    found = json.loads(ink("info", "--json", tmp_path / "m.vtk").out)[0]
    assert found["cell_arrays"] == [{"name": "flow", "type": "float", "components": 3, "range": [-4, 3]}]


@pytest.mark.one_build
def test_values_of_cells_are_those_of_voxels_in_their_centers(ink, tmp_path):
    volume = ink_files.blob((8, 9, 10))
    ink_files.write_vti(tmp_path / "v.vti", volume, where="CellData")
    result = ink("info", tmp_path / "v.vti")
    assert result.code == 0, result
    assert "dimensions     10 x 9 x 8" in result.out
    assert "origin         0.5 0.5 0.5" in result.out
    assert "its values are those of its cells" in result.out
    assert f"range          0 to {volume.max()}" in result.out


def test_several_files(ink, tmp_path):
    ink_files.write_vti(tmp_path / "v.vti", ink_files.blob())
    ink_files.write_vtp(tmp_path / "m.vtp", ink_files.sphere_mesh(6, 8))
    both = ink("info", tmp_path / "v.vti", tmp_path / "m.vtp")
    apart = [ink("info", tmp_path / name).out for name in ("v.vti", "m.vtp")]
    assert both.code == 0 and both.out == "\n".join(apart)
    (tmp_path / "broken.vti").write_text("<VTKFile")
    result = ink("info", tmp_path / "absent.vti", tmp_path / "v.vti", tmp_path / "broken.vti", tmp_path / "m.vtp")
    assert result.code == 1 and result.out == both.out, "what can be read is described"
    messages = result.err.splitlines()
    assert len(messages) == 2 and "absent.vti" in messages[0] and "broken.vti" in messages[1]
    assert all(message.startswith("ink: error: ") for message in messages)
    result = ink("info", "--json", tmp_path / "absent.vti", tmp_path / "m.vtp")
    assert result.code == 1 and "absent.vti" in result.error
    assert [one["file"] for one in json.loads(result.out)] == [str(tmp_path / "m.vtp")]
    assert ink("info", "--json", tmp_path / "absent.vti").out == ""
    # What is asked for suits some only.
    result = ink("info", "--spacing", "1,1,1", tmp_path / "absent.vti", tmp_path / "m.vtp", tmp_path / "v.vti")
    assert result.code == 2 and result.out == apart[0]
    assert [name in message for name, message in zip(("absent.vti", "m.vtp"), result.err.splitlines())] == [True, True]
    result = ink("info", "--crop", "90,95,90,95,90,95", tmp_path / "v.vti", tmp_path / "m.vtp")
    assert [name in message for name, message in zip(("v.vti", "m.vtp"), result.err.splitlines())] == [True, True]


def test_json(ink, tmp_path):
    volume = ink_files.blob((20, 24, 28)).astype(np.float32)
    volume[0, 0, 0] = np.nan
    ink_files.write_vti(tmp_path / "v.vti", volume)
    ink_files.write_vtp(tmp_path / "m.vtp", ink_files.sphere_mesh(6, 8))
    result = ink("info", "--json", tmp_path / "v.vti", tmp_path / "m.vtp")
    assert (result.code, result.err) == (0, "")
    first, second = json.loads(result.out)
    assert first["file"] == str(tmp_path / "v.vti") and first["dimensions"] == [28, 24, 20]
    assert first["type"] == "float" and first["components"] == 1 and first["not_finite"] == 1
    assert "labels" not in first
    assert first["range"] == [0, pytest.approx(200, abs=1)] \
        and [0 < one["value"] < 200 for one in first["suggested_iso"]] == [True]
    assert all(set(one) == {"value", "shows", "kept_share"} for one in first["suggested_iso"])
    assert second["points"] == len(ink_files.sphere_mesh(6, 8)[0])
    assert first["point_arrays"] == [{"name": "density", "type": "float", "components": 1, "range": first["range"]}]
    assert second["point_arrays"] == [{"name": "Normals", "type": "float", "components": 3, "range": [-1, 1]}]
    ink_files.write_vti(tmp_path / "c.vti", np.full((4, 4, 4), 7, np.uint8))
    constant = json.loads(ink("info", "--json", tmp_path / "c.vti").out)[0]
    assert constant["range"] == [7, 7] and constant["suggested_iso"] == []


def test_rescaled_values(ink, tmp_path):
    ink_files.write_nifti(tmp_path / "v.nii", ink_files.blob(), slope=2.0, intercept=-1000.0)
    fields = info(ink, tmp_path / "v.nii")
    stored = int(ink_files.blob().max())
    assert fields["range"] == f"-1000 to {2 * stored - 1000}"
    assert fields["note"] == "its stored values are rescaled: 2 v - 1000"


def test_time_series_use_the_first_step(ink, tmp_path):
    ink_files.write_nifti(tmp_path / "v.nii", ink_files.blob(), times=3)
    fields = info(ink, tmp_path / "v.nii")
    assert fields["dimensions"] == "32 x 32 x 32"
    assert fields["components"] == "1"
    assert "3 time steps; the first is used" in fields["note"]


def test_colors_use_the_first_component(ink, tmp_path):
    blob = ink_files.blob()
    ink_files.write_vti(tmp_path / "v.vti", np.stack([blob, blob // 2, blob // 4], axis=3))
    fields = info(ink, tmp_path / "v.vti")
    assert fields["components"] == "3"
    assert fields["range"] == f"0 to {blob.max()}"
    assert "the first is used" in fields["note"]


@pytest.mark.parametrize("value, expected", [(7.0, "7 to 7"), (np.nan, "none")])
def test_volumes_of_one_value_have_no_surface(ink, tmp_path, value, expected):
    ink_files.write_nifti(tmp_path / "v.nii", np.full((8, 8, 8), value, np.float32))
    fields = info(ink, tmp_path / "v.nii")
    assert fields["range"] == expected
    assert fields["suggested iso"].startswith("none")
    result = ink("render", tmp_path / "v.nii", "-o", tmp_path / "out.png")
    assert result.code == 1
    assert "no surface" in result.error


def test_values_that_are_not_finite_are_counted(ink, tmp_path):
    volume = ink_files.blob(dtype=np.float32)
    volume[0, 0, :5] = [np.nan, np.inf, -np.inf, np.nan, np.nan]
    ink_files.write_nifti(tmp_path / "v.nii", volume)
    fields = info(ink, tmp_path / "v.nii")
    assert fields["not finite"] == "5 voxels"
    low, high = map(float, fields["range"].split(" to "))
    assert np.isfinite([low, high]).all()


def test_version(ink):
    result = ink("--version")
    assert (result.code, result.err) == (0, "")
    assert re.match(r"vtkInk \d+\.\d+\.\d+\nVTK    9\.\d+\S*\nOpenGL .*OpenGL \d\.\d.*\nwindow vtk\w+RenderWindow\n$", result.out)


def test_version_without_a_display(ink):
    if "vtkXOpenGLRenderWindow" not in ink("--version").out:
        pytest.skip("this VTK draws without a display")
    result = ink("--version", env={"DISPLAY": ""})
    assert (result.code, result.err) == (0, "")
    assert "no display" in result.out


@pytest.mark.parametrize("arguments", [["--help"], ["render", "--help"], ["info", "--help"]])
def test_help(ink, arguments):
    result = ink(*arguments)
    assert (result.code, result.err) == (0, "")
    assert "Exit codes" in result.out
