# SPDX-License-Identifier: BSD-3-Clause
"""vtkink.draw() and read(): files are what `ink` has of them; keywords of any numbers; what draws nothing is an error."""

import keyword
import json
import math
import re

import numpy as np
import pytest

import ink_files

vtkink = pytest.importorskip("vtkink")
vtk = vtkink.vtk
numpy_support = vtkink.numpy_support
reading = vtkink.reading

BLOB = ink_files.blob((20, 24, 28))
MESH = ink_files.sphere_mesh(20, 30)
# RAS to the voxels' x, y and z: 2 apart along x, turned and shifted.
AFFINE = [[2, 0, 0, 10], [0, 0, 1, -5], [0, -1, 0, 7]]

FILES = {
    "v.nii": lambda p: ink_files.write_nifti(p, BLOB, AFFINE, slope=2.0, intercept=-100.0),
    "V.NII.gz": lambda p: ink_files.write_nifti(p, BLOB, AFFINE, slope=0.5),
    "v.nrrd": lambda p: ink_files.write_nrrd(p, BLOB, space="right-anterior-superior", origin="(3,4,5)"),
    "v.mha": lambda p: ink_files.write_metaimage(p, BLOB, matrix="0 1 0 1 0 0 0 0 1", offset="1 2 3"),
    "v.mrc": lambda p: ink_files.write_mrc(p, BLOB.astype("int16"), (2, 3, 1), cell=(9, 10, 11)),
    "v.vti": lambda p: ink_files.write_vti(p, BLOB),
    "cells.vti": lambda p: ink_files.write_vti(p, BLOB, where="CellData"),
    "v.vtk": lambda p: ink_files.write_legacy(p, BLOB),
    "series": lambda p: ink_files.write_dicom(p, BLOB),
    "m.ply": lambda p: ink_files.write_ply(p, MESH),
    "m.obj": lambda p: ink_files.write_obj(p, MESH),
    "m.off": lambda p: ink_files.write_off(p, MESH),
    "m.stl": lambda p: ink_files.write_stl(p, MESH),
    "m.vtp": lambda p: ink_files.write_vtp(p, MESH),
    "m.vtu": lambda p: ink_files.write_vtu(p, MESH),
    "m.gii": lambda p: ink_files.write_gifti(p, MESH),
    "m.pcd": lambda p: ink_files.write_pcd(p, MESH),
    "m.xyz": lambda p: np.savetxt(p, np.hstack(MESH[:2])),
}


def numbers(text):
    return [float(word) for word in text.replace("(", " ").replace(")", " ").replace(",", " ").replace("to", " ").split()]


def described(ink, path):
    """What `ink info` says."""
    result = ink("info", path)
    assert result.code == 0, result
    return {line[:15].strip(): line[15:] for line in result.out.splitlines()}


@pytest.mark.parametrize("name", FILES)
def test_files_are_read_as_ink_reads_them(ink, tmp_path, name):
    path = tmp_path / name
    FILES[name](path)
    said, data = described(ink, path), vtkink.read(path)
    if data.IsA("vtkPolyData"):
        assert data.GetBounds() == pytest.approx(numbers(said["bounds"]), abs=1e-4)
        assert data.GetNumberOfPoints() == int(said["points"]) == len(MESH[0])
        return
    direction = [data.GetDirectionMatrix().GetElement(row, column) for row in range(3) for column in range(3)]
    assert direction == pytest.approx(numbers(said.get("direction", "1 0 0 0 1 0 0 0 1")))
    assert data.GetOrigin() == pytest.approx(numbers(said["origin"]))
    assert data.GetSpacing() == pytest.approx(numbers(said["spacing"]))
    assert data.GetScalarRange() == pytest.approx(numbers(said["range"]))


def test_vdb_files_are_read_where_ink_was_built_with_openvdb(ink, tmp_path):
    FILES["v.nii"](tmp_path / "v.nii")
    if not hasattr(vtkink, "vtkInkVDBReader"):
        (tmp_path / "v.vdb").write_bytes(b"x")
        with pytest.raises(ValueError, match="without OpenVDB"):
            vtkink.read(tmp_path / "v.vdb")
        return
    assert ink("convert", tmp_path / "v.nii", tmp_path / "v.vdb").code == 0
    volume, grid = vtkink.read(tmp_path / "v.nii"), vtkink.read(tmp_path / "v.vdb")
    assert grid.GetBounds() == pytest.approx(volume.GetBounds())
    assert grid.GetScalarRange() == volume.GetScalarRange()


def test_values_are_rescaled(tmp_path):
    FILES["v.nii"](tmp_path / "v.nii")
    image = vtkink.read(tmp_path / "v.nii")
    values = numpy_support.vtk_to_numpy(image.GetPointData().GetScalars())
    assert np.array_equal(values, BLOB.ravel() * 2.0 - 100.0)


@pytest.mark.parametrize("slope", [1.0, 2.0])
def test_axes_are_turned(tmp_path, slope):
    ink_files.write_nifti(tmp_path / "v.nii", BLOB, AFFINE, slope)
    image = vtkink.read(tmp_path / "v.nii")
    # +x and +y are the patient's left and back, where NIfTI's are right and front.
    assert image.GetOrigin() == (-10, 5, 7)
    assert [image.GetDirectionMatrix().GetElement(row, 0) for row in range(3)] == [-1, 0, 0]


def rendered(path):
    """How much ink there is in each of 12 x 12 parts of the box around the drawing."""
    dark = ink_files.read_png(path)[..., :3].min(axis=2) < 128
    rows, columns = (np.flatnonzero(dark.any(axis=axis)) for axis in (1, 0))
    box = dark[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1]
    return np.array([[part.mean() for part in np.array_split(row, 12, axis=1)] for row in np.array_split(box, 12)])


def test_the_picture_is_that_of_ink(ink, tmp_path):
    """A body without a mirror plane: turned or mirrored it would be another picture."""
    path = tmp_path / "v.nii"
    ink_files.write_nifti(path, ink_files.blob((40, 40, 40)), AFFINE, slope=2.0, intercept=-100.0)
    assert ink("render", path, "--style", "splatting-lines", "--iso", 100, "--size", "300x300", "-q", "-o", tmp_path / "ink.png").code == 0
    vtkink.draw(path, "splatting-lines", tmp_path / "draw.png", size=(300, 300), iso_values=100)
    ours, theirs = rendered(tmp_path / "draw.png"), rendered(tmp_path / "ink.png")

    def likeness(other):
        return np.corrcoef(other.ravel(), theirs.ravel())[0, 1]

    assert likeness(ours) > 0.9
    assert max(likeness(other) for other in (ours[:, ::-1], ours[::-1], ours[::-1, ::-1])) < 0.8


@pytest.mark.parametrize("size", [(300, 200), (200, 300)])
def test_pictures_of_all_styles_are_framed_as_ink_frames_them(ink, tmp_path, size):
    """Of a body whose picture is a full disc, so that the bounds of its ink are those of the subject."""
    ink_files.write_ply(tmp_path / "m.ply", ink_files.sphere_mesh())

    def bounds(path):
        dark = ink_files.read_png(path)[..., :3].min(axis=2) < 128
        return [index for axis in (1, 0) for index in np.flatnonzero(dark.any(axis=axis))[[0, -1]]]

    text = f"{size[0]}x{size[1]}"
    assert ink("render", tmp_path / "m.ply", "--style", "splatting-lines", "--size", text, "-q", "-o", tmp_path / "i.png").code == 0
    vtkink.draw(tmp_path / "m.ply", "splatting-lines", tmp_path / "l.png", size=size)
    # Thousandths of so small a picture are less than a pixel, and gray where the light falls.
    vtkink.draw(tmp_path / "m.ply", "stipple", tmp_path / "s.png", size=size, size_unit="pixels")
    assert bounds(tmp_path / "l.png") == bounds(tmp_path / "i.png")
    assert np.abs(np.subtract(bounds(tmp_path / "s.png"), bounds(tmp_path / "i.png"))).max() <= 3


# Of which frames do not depend.
FEW_MARKS = {"NumberOfSamples": "2000", "NumberOfSurfaceStipples": "2000", "LineSpacing": "16"}


def frame_of(data, style, **parameters):
    style = vtkink.vtkInkStyle.CreateStyle(style)
    names = {style.GetParameterName(i) for i in range(style.GetNumberOfParameters())}
    for name, value in {**{name: few for name, few in FEW_MARKS.items() if name in names}, **parameters}.items():
        assert style.SetParameterAsString(name, value)
    assert style.Make(data)
    return numpy_support.vtk_to_numpy(style.GetFramePoints().GetData())


def test_pictures_of_all_styles_register(tmp_path):
    """They are fitted to the same points, whatever is drawn."""
    ink_files.write_ply(tmp_path / "m.ply", ink_files.sphere_mesh())
    mesh = vtkink.read(tmp_path / "m.ply")
    # A part that is left out, and a surface that leaves the volume.
    volume = np.maximum(ink_files.blob((40, 40, 40)), 0)
    volume[2:4, 2:4, 2:4] = 200
    volume = vtkink.reading.data_object(volume[:, :30])
    for data, least in ((mesh, mesh.GetNumberOfPoints()), (volume, 1000)):
        frames = {name: frame_of(data, name) for name in vtkink.styles()}
        assert len(frames) == 5
        expected = frames["splatting-lines"]
        assert len(expected) > least  # of a mesh, as the smooth surface that it is drawn as
        for name, frame in frames.items():
            assert np.array_equal(frame, expected), name
    # Of voxels, in place of a surface that there is.
    assert np.array_equal(frame_of(volume, "stipple", StippleSource="volume"), expected)
    assert np.array_equal(frame_of(volume, "stipple", StippleSource="volume", IsoValues="150"), frame_of(volume, "splatting-lines", IsoValues="150"))
    assert np.array_equal(frame_of(volume, "contours", Method="voxel-segments"), expected)


def test_the_surface_that_voxels_are_framed_by_is_not_spoken_of():
    """It is not drawn, nor is one missed where there is none."""
    ramp = np.broadcast_to(np.arange(20, dtype=np.float32)[:, None, None], (20, 20, 20))
    for volume in (ramp, np.where(ramp > 9, np.float32(np.nan), ramp)):
        style = vtkink.vtkInkStyle.CreateStyle("stipple")
        style.SetParameterAsString("StippleSource", "volume")
        assert style.Make(vtkink.reading.data_object(volume.copy()))
        notes = [style.GetNote(i) for i in range(style.GetNumberOfNotes())]
        assert not any("surface" in note or "iso-value" in note for note in notes), notes


def test_what_is_drawn_without_a_clear_boundary_is_said(ink, tmp_path):
    noise = np.random.default_rng(3).normal(100, 20, (24, 24, 24)).astype(np.float32)
    ink_files.write_vti(tmp_path / "n.vti", noise)
    result = ink("render", tmp_path / "n.vti", "--style", "splatting-lines", "--size", 100, "-o", tmp_path / "n.png")
    assert result.code == 0
    assert re.search(r"no boundary between materials is clear, so what is drawn is the surface around the upper \d+ % of", result.err)
    ink_files.write_vti(tmp_path / "b.vti", BLOB)
    assert "no boundary" not in ink("render", tmp_path / "b.vti", "--size", 100, "-o", tmp_path / "b.png").err


def test_the_lobes_of_an_orbital_are_drawn_and_how_to_draw_both_signs_is_said(ink, tmp_path):
    z, y, x = np.mgrid[-12:13, -12:13, -12:13] / 2.0
    ink_files.write_vti(tmp_path / "o.vti", (x * y * np.exp(-np.sqrt(x**2 + y**2 + z**2) / 0.6)).astype(np.float32))
    result = ink("render", tmp_path / "o.vti", "--style", "splatting-lines", "--size", 100, "-o", tmp_path / "o.png")
    assert result.code == 0
    both = re.search(r"nothing is drawn of the negative values; .*\(--iso=(-[\d.e-]+,[\d.e-]+)\) draw both", result.err)
    drawn = ink("render", tmp_path / "o.vti", "--style", "splatting-lines", "--size", 100, "--iso=" + both[1], "-o", tmp_path / "b.png")
    assert drawn.code == 0 and "negative" not in drawn.err
    assert (tmp_path / "b.png").read_bytes() != (tmp_path / "o.png").read_bytes()


def test_legacy_files_of_other_data(tmp_path):
    """vtkInkVolumeReader takes those of structured points; a title does not say what a file holds."""
    (tmp_path / "mesh.vtk").write_text("# vtk DataFile Version 3.0\nt\nASCII\ndataset polydata\nPOINTS 3 float\n"
                                       "0 0 0 1 0 0 0 1 0\nPOLYGONS 1 4\n3 0 1 2\n")  # fmt: skip
    mesh = vtkink.read(tmp_path / "mesh.vtk")
    assert mesh.IsA("vtkPolyData") and mesh.GetNumberOfPolys() == 1
    assert vtkink.draw(tmp_path / "mesh.vtk", "stipple", number_of_surface_stipples=50).GetMapper().GetInput().GetNumberOfPoints() == 50
    ink_files.write_legacy(tmp_path / "v.vtk", BLOB)
    content = (tmp_path / "v.vtk").read_bytes().replace(b"\ntest\n", b"\nDATASET POLYDATA\n")
    (tmp_path / "v.vtk").write_bytes(content)
    assert vtkink.read(tmp_path / "v.vtk").GetDimensions() == BLOB.shape[::-1]
    (tmp_path / "grid.vtk").write_text("# vtk DataFile Version 3.0\nt\nASCII\nDATASET RECTILINEAR_GRID\nDIMENSIONS 3 2 2\n"
                                       "X_COORDINATES 3 float\n0 2 4\nY_COORDINATES 2 float\n0 1\nZ_COORDINATES 2 float\n0 1\n"
                                       "POINT_DATA 12\nSCALARS a short\nLOOKUP_TABLE default\n" + "1 2 3 " * 4)  # fmt: skip
    grid = vtkink.read(tmp_path / "grid.vtk")
    assert grid.IsA("vtkImageData") and grid.GetSpacing() == (2.0, 1.0, 1.0)
    (tmp_path / "cells.vtk").write_text("# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n"
                                        "0 0 0 1 0 0 0 1 0 0 0 1\nCELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n")  # fmt: skip
    assert vtkink.read(tmp_path / "cells.vtk").GetNumberOfPolys() == 4


@pytest.mark.parametrize("name", ["v.nii", "v.nrrd", "v.vti", "v.vtk", "m.ply", "m.xyz"])
def test_damaged_files_are_one_exception(tmp_path, capfd, name):
    path = tmp_path / name
    FILES[name](path)
    path.write_bytes(path.read_bytes()[:-60] + (b" x" if name == "m.xyz" else b""))
    with pytest.raises(ValueError) as raised:
        vtkink.draw(path)
    assert str(raised.value).startswith(f"cannot read '{path}': "), raised.value
    assert capfd.readouterr().err == "", "VTK says nothing beside it"


def parameters_of(style, **keywords):
    return json.loads(vtkink.drawing._make_style(style, None, keywords).GetParametersAsJSON())["parameters"]


@pytest.mark.parametrize("style, keyword, value, name, expected", [
    ("stipple", "sharpness", np.float32(0.75), "Sharpness", 0.75),
    ("stipple", "sharpness", np.array(0.75), "Sharpness", 0.75),
    ("stipple", "sharpness", np.longdouble(0.75), "Sharpness", 0.75),
    ("stipple", "seed", np.uint16(7), "Seed", 7),
    ("stipple", "grow_with_zoom", np.bool_(True), "GrowWithZoom", True),
    ("stipple", "preset", np.str_("bone"), "Preset", "bone"),
    ("stipple", "ink_color", [np.float64(0.25), np.int8(1), 0], "InkColor", [0.25, 1, 0]),
    ("stipple", "iso_values", (np.float32(80), np.int64(100)), "IsoValues", [80, 100]),
    ("stipple", "iso_values", [np.array(80), np.array(100.5)], "IsoValues", [80, 100.5]),
    ("stipple", "iso_values", range(80, 120, 20), "IsoValues", [80, 100]),
    ("stipple", "iso_values", np.float32(80), "IsoValues", [80]),
    ("stipple", "scalar_window", np.array([20, 30], np.int16), "ScalarWindow", [20, 30]),
    ("splatting-lines", "hidden_color", np.array([[0, 0, 1], [1, 0, 0]]), "HiddenColor", [0, 0, 1, 1, 0, 0]),
    ("splatting-lines", "hidden_color", ["blue", (1, np.float32(0.5), 0)], "HiddenColor", [0, 0, 1, 1, 0.5, 0]),
])
def test_keywords_take_any_numbers(style, keyword, value, name, expected):
    assert parameters_of(style, **{keyword: value})[name] == expected


def test_no_keyword_is_a_word_of_pythons():
    for style in vtkink.styles().values():
        assert not [word for word in style.parameters if not word.isidentifier() or keyword.iskeyword(word)]
    actor = vtkink.draw(BLOB, "splatting-lines", iso_values=[50], lambda_=2.5)
    assert actor.GetMapper().GetLambda() == 2.5



@pytest.mark.parametrize("keyword, value, words", [
    ("scalar_window", (20, math.inf), ["2 numbers", "found '20,inf'"]),
    ("scalar_window", np.array([np.nan, 30]), ["2 numbers", "found 'nan,30.0'"]),
    ("scalar_window", np.array([20, 30, 40]), ["2 numbers", "found [20,30,40]"]),
    ("sharpness", math.nan, ["a number from 0 to 1", "found 'nan'"]),
    ("sharpness", 10**400, ["a number from 0 to 1", "found '1000"]),
    ("sharpness", np.float32(2), ["a number from 0 to 1", "found 2"]),
    ("sharpness", 1j, ["a number from 0 to 1", "found '1j'"]),
    ("sharpness", None, ["a number from 0 to 1", "found 'None'"]),
    ("seed", -math.inf, ["a whole number", "found '-inf'"]),
    ("grow_with_zoom", math.nan, ["on or off", "nan"]),
    ("iso_values", {80, 90}, ["any number of numbers", "80, 90"]),
    ("iso_values", [80, b"90"], ["any number of numbers", "found '80,b'90''"]),
    ("ink_color", [math.inf, 0, 0], ["#rrggbb", "found 'inf,0,0'"]),
    ("preset", np.int64(1), ["bone", "found 1"]),
    ("color_by", math.nan, ["text", "found nan"]),
])  # fmt: skip
def test_wrong_values_are_named_by_keyword(keyword, value, words):
    with pytest.raises(ValueError) as raised:
        vtkink.draw(BLOB, "stipple", **{keyword: value})
    message = str(raised.value)
    assert message.startswith(f"{keyword}: expected ") and all(word in message for word in words), message
    assert "JSON" not in message


@pytest.mark.parametrize("style, data, keywords, words", [
    ("splatting-lines", BLOB, {"iso_values": 5000}, ["no surface at iso-value 5000"]),
    ("stipple", BLOB, {"scalar_window": (5000, 6000)}, ["no voxel", "window"]),
    ("splatting-lines", np.ones((8, 8, 8)), {}, ["two different finite values"]),
    ("stipple", np.ones((8, 8, 8)), {}, ["no voxel has a gradient"]),
])  # fmt: skip
def test_nothing_to_draw_is_an_error_without_a_file(tmp_path, style, data, keywords, words):
    with pytest.raises(ValueError) as raised:
        vtkink.draw(data, style, tmp_path / "out.png", **keywords)
    assert all(word in str(raised.value) for word in [f"{style}: ", *words]), raised.value
    assert not list(tmp_path.iterdir())


def style_file(tmp_path, content):
    file = tmp_path / "mine.json"
    file.write_bytes(content if isinstance(content, bytes) else json.dumps(content).encode())
    return file


def values_of(array):
    return numpy_support.vtk_to_numpy(reading.data_object(array).GetPointData().GetScalars())


@pytest.mark.parametrize("dtype", [">i2", ">f4", "<u4", "?", "f2", "g", "i8"])
def test_arrays_of_any_numbers(dtype):
    """Of foreign byte order, as FITS and NIfTI files have it, and of types that VTK does not have."""
    array = (BLOB > 100 if dtype == "?" else BLOB).astype(dtype)
    assert np.array_equal(values_of(array), array.ravel().astype(float))
    # As a part of a larger array, which is not in one piece.
    assert np.array_equal(values_of(array[:, ::2]), array[:, ::2].ravel().astype(float))


def test_an_array_is_drawn_as_it_is_in_memory():
    array = BLOB.astype("f4")
    image = reading.data_object(array)
    array[:] = 7
    assert image.GetScalarRange() == (7, 7)


@pytest.mark.parametrize("dtype, expected", [("u1", "f4"), (">i2", "f4"), ("i4", "f8"), ("f8", "f8"), ("f2", "f4")])
def test_masked_values_are_none(dtype, expected):
    array = np.ma.masked_greater(BLOB.astype(dtype), 100)
    values = values_of(array)
    assert values.dtype == expected
    assert np.array_equal(values, array.astype("f8").filled(np.nan).ravel(), equal_nan=True)
    assert np.isnan(values).any()
    whole = values_of(np.ma.masked_greater(BLOB, 1000))
    assert whole.dtype == np.uint8 and np.array_equal(whole, BLOB.ravel())


@pytest.mark.parametrize("dtype, name", [(complex, "complex128"), (object, "object"), ("U3", "str"), ("M8[s]", "datetime64")])
def test_arrays_without_numbers_are_refused(dtype, name):
    with pytest.raises(ValueError, match=f"expected an array of integers or real numbers, found one of {name}"):
        vtkink.draw(BLOB.astype(dtype))


@pytest.mark.parametrize("size", [(8193, 10), (10, 10**9)])
def test_larger_pictures_are_inks(tmp_path, size):
    with pytest.raises(ValueError, match="size: expected up to 8192 pixels a side, found .*'ink render'"):
        vtkink.draw(BLOB, output=tmp_path / "large.png", size=size)
    assert not list(tmp_path.iterdir())


def test_ink_and_python_take_the_same_reader(ink, tmp_path):
    """Also of DICOM files, whose names end in anything, and of what two readers have a suffix for."""
    ink_files.write_dicom(tmp_path / "series", BLOB[:1])
    (slice_file,) = (tmp_path / "series").iterdir()
    for suffix in (".stl", ".ply", ".dat", ".vti"):
        (tmp_path / f"slice{suffix}").write_bytes(slice_file.read_bytes())
    ink_files.write_legacy(tmp_path / "volume.vtk", BLOB)
    ink_files.write_ply(tmp_path / "mesh.ply", MESH)
    ink_files.write_ply(tmp_path / "mesh.vti", MESH)
    for path in sorted(tmp_path.iterdir()):
        said = ink("info", path)
        try:
            found = "points" if vtkink.read(path).IsA("vtkPolyData") else "dimensions"
        except ValueError as error:
            assert said.code == 1 and str(error).rstrip(".") in said.error, path
            continue
        assert said.code == 0 and found in [line.split()[0] for line in said.out.splitlines()], (path, found, said)


def test_a_style_file_says_the_style(tmp_path):
    file = style_file(tmp_path, {"style": "splatting-lines", "parameters": {"Tau": 1.125}})
    style = vtkink.draw(BLOB, style_file=file, line_width=2.5).style
    assert style.GetName() == "splatting-lines"
    assert (style.GetParameter("Tau"), style.GetParameter("LineWidth")) == (1.125, 2.5)
    assert vtkink.draw(BLOB, "splatting-lines", style_file=file).style.GetName() == "splatting-lines"
    assert vtkink.draw(BLOB).style.GetName() == "illustration"


@pytest.mark.parametrize("style, content, words", [
    ("stipple", {"style": "splatting-lines", "parameters": {}}, ['expected "stipple", found "splatting-lines"']),
    (None, {"style": "oil", "parameters": {}}, ['expected one of illustration, contours, line-art, splatting-lines, stipple, found "oil"']),
    ("stipple", {"style": "oil", "parameters": {}}, ['expected one of illustration, contours, line-art, splatting-lines, stipple, found "oil"']),
    (None, {"parameters": {}}, ['expected {"style"']),
    (None, {"style": "splatting-lines", "parameters": {"Tau": "x"}}, ["Tau: expected a number", "x"]),
    (None, {"style": "stipple", "parameters": {"Sharpnes": 0.5}}, ["'Sharpnes'", "no such parameter; did you mean 'Sharpness'?"]),
    (None, {"style": "stipple", "parameters": {"Oil": 1}}, ["'Oil'", "no such parameter; expected one of Preset, Gradient,"]),
    (None, b"\xff\xfe", ["UTF-8"]),
])  # fmt: skip
def test_wrong_style_files_are_named(tmp_path, style, content, words):
    file = style_file(tmp_path, content)
    with pytest.raises(ValueError) as raised:
        vtkink.draw(BLOB, style, style_file=file)
    assert str(raised.value).startswith(f"{file}: ") and all(word in str(raised.value) for word in words), raised.value


@pytest.fixture(scope="module")
def large(tmp_path_factory):
    """17 MiB, of which no more than 16 are read at once within 128 MiB."""
    path = tmp_path_factory.mktemp("large") / "v.nii"
    z, y, x = np.meshgrid(*[np.arange(n) for n in (34, 512, 512)], indexing="ij", sparse=True)
    ink_files.write_nifti(path, (200 - 2 * np.sqrt((x - 256) ** 2 + (y - 256) ** 2 + (5 * (z - 17)) ** 2)).astype(np.int16))
    return path


@pytest.mark.parametrize("style", ["splatting-lines", "illustration"])
def test_a_file_larger_than_memory_is_drawn_in_parts(tmp_path, large, style):
    pictures = []
    for memory in (None, "128MiB"):
        actor = vtkink.draw(large, style, tmp_path / "p.png", size=(120, 120), memory=memory, smoothing=0, subdivision=1)
        pictures.append(ink_files.read_png(tmp_path / "p.png"))
        assert actor.style.GetMaximumMemory() == (0 if memory is None else 128)
        assert "iso-value " in actor.style.GetNote(0)
    # Points of a cut come in another order, of which the last bit of a sum depends.
    assert pictures[0].min() < 200 and np.abs(pictures[0].astype(int) - pictures[1]).max() <= 1


def test_memory_that_is_none_or_too_little_is_an_error(tmp_path, large):
    for memory in ("1", "127MiB", 1024, "lots"):
        with pytest.raises(ValueError, match="memory: expected a size of 128 MiB or more"):
            vtkink.draw(large, memory=memory)
    with pytest.raises(ValueError, match="stipple needs the whole volume at once, 17 MiB: expected MaximumMemory of"):
        vtkink.draw(large, "stipple", memory="128MiB")
    (tmp_path / "v.nii").write_bytes(large.read_bytes()[:-1])
    with pytest.raises(ValueError, match="cannot read .*its header promises"):
        vtkink.draw(tmp_path / "v.nii", memory="128MiB")


@pytest.mark.parametrize("name, arguments, options", [
    ("m.ply", {}, []), ("m.obj", {}, []), ("m.ply", {"up": "-x", "azimuth": 20}, ["--up=-x", "--azimuth", 20]),
    ("m.ply", {"view": "iso", "elevation": 10}, ["--view", "iso", "--elevation", 10]), ("v.nii", {"iso_values": 100}, ["--iso", 100])])
def test_a_picture_is_seen_as_ink_sees_it(ink, tmp_path, name, arguments, options):
    """Meshes stand upright and show their largest side; what lies flat is seen from above."""
    points, normals, triangles = MESH
    FILES[name](tmp_path / name)
    if name.startswith("m."):
        mesh = (points * [1, 3, 0.4], normals, triangles)
        {"m.ply": ink_files.write_ply, "m.obj": ink_files.write_obj}[name](tmp_path / name, mesh)
    vtkink.draw(tmp_path / name, "contours", tmp_path / "a.png", size=(150, 120), **arguments)
    result = ink("render", tmp_path / name, "--style", "contours", "--size", "150x120", "-o", tmp_path / "b.png", *options)
    assert result.code == 0, result
    a, b = (ink_files.read_png(tmp_path / file)[..., :3].astype(int) for file in ("a.png", "b.png"))
    assert b.min() < 200 and np.abs(a - b).max() <= 2


@pytest.mark.parametrize("arguments, words", [
    ({"view": "side"}, "view: expected one of front, back, left, right, top, bottom, iso, found 'side'"),
    ({"up": "w"}, "up: expected one of x, y, z, -x, -y, -z, found 'w'"), ({"azimuth": "east"}, "azimuth: expected degrees from -360"),
    ({"elevation": math.nan}, "elevation: expected degrees from -360 to 360, found nan")])
def test_views_that_are_none(arguments, words):
    with pytest.raises(ValueError, match=words):
        vtkink.draw(BLOB, **arguments)
