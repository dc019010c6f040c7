# SPDX-License-Identifier: BSD-3-Clause
"""Every format shows the same object from the same side."""

import json
import re
import struct

import numpy as np
import pytest

import ink_files

BLOB = ink_files.blob()
# From voxel indices to NIfTI's axes (right, front, top) for a volume that lies along DICOM's (left, back, top).
AFFINE = np.array([[-1, 0, 0, 0], [0, -1, 0, 0], [0, 0, 1, 0]])


def turned_nifti(path):
    """Voxels in another order (z, x, y, with x backwards), and the affine that says so."""
    to_index = np.array([[0, -1, 0, 31], [0, 0, 1, 0], [1, 0, 0, 0], [0, 0, 0, 1]])
    ink_files.write_nifti(path, BLOB.transpose(1, 2, 0)[:, ::-1], AFFINE @ to_index)


def turned_nrrd(path):
    ink_files.write_nrrd(path, BLOB.transpose(1, 0, 2), directions="(1,0,0) (0,0,1) (0,1,0)")


def capital_nrrd(path):
    """Words in letters of the other case, as some programs write them."""
    ink_files.write_nrrd(path, BLOB, "ASCII", space="ras", directions="(-1,0,0) (0,-1,0) (0,0,1)")
    path.write_bytes(path.read_bytes().replace(b"type: uchar", b"Type: UChar").replace(b"endian", b"ENDIAN"))


def nifti_by_quaternion(path, volume, qfac):
    """A half turn around z, which is what AFFINE says, and slices that go up, or down from 31."""
    ink_files.write_nifti(path, volume)
    data = bytearray(path.read_bytes())
    struct.pack_into("<f", data, 76, qfac)
    struct.pack_into("<2h", data, 252, 1, 0)
    struct.pack_into("<6f", data, 256, 0, 0, 1, 0, 0, 0 if qfac > 0 else 31)
    path.write_bytes(data)


def numbered_slices(path, name):
    for i, image in enumerate(BLOB):
        (path.parent / name.format(i)).write_bytes(image.tobytes())
    return [name.format(i) for i in range(len(BLOB))]


def numbered_nrrd(path):
    numbered_slices(path, "slice{:03}.raw")
    path.write_text("NRRD0004\ntype: uchar\ndimension: 3\nsizes: 32 32 32\nencoding: raw\ndata file: slice%03d.raw 0 31 1\n")


def listed_metaimage(path):
    path.write_text("ObjectType = Image\nNDims = 3\nBinaryData = True\nDimSize = 32 32 32\nElementType = MET_UCHAR\n"
                    "ElementDataFile = LIST\n" + "\n".join(numbered_slices(path, "z{}.raw")) + "\n")


def text_metaimage(path):
    path.write_text("ObjectType = Image\nNDims = 3\nBinaryData = False\nDimSize = 32 32 32\nElementType = MET_FLOAT\n"
                    "ElementDataFile = LOCAL\n" + " ".join(map(str, BLOB.ravel())) + "\n")


def nifti_pair(path, magic=b"ni1\0"):
    """By either name; without the magic bytes of NIfTI it is a volume of Analyze 7.5, whose usual axes these are."""
    single = path.with_suffix(".nii")
    analyze = magic == bytes(4)
    ink_files.write_nifti(single, BLOB[:, ::-1] if analyze else BLOB, None if analyze else AFFINE)
    data = single.read_bytes()
    single.unlink()
    header = bytearray(data[:348])
    struct.pack_into("<f", header, 108, 0)
    header[344:348] = magic
    path.with_suffix(".hdr").write_bytes(header)
    path.with_suffix(".img").write_bytes(data[352:])


def tiff_folder(path):
    path.mkdir()
    for i, image in enumerate(BLOB):
        ink_files.write_tiff(path / f"z{i}.tif", image[None], compressed=True)


VOLUMES = {
    "plain.nii": lambda p: ink_files.write_nifti(p, BLOB),
    "oriented.nii.gz": lambda p: ink_files.write_nifti(p, BLOB, AFFINE),
    "turned.nii": turned_nifti,
    "raw.nrrd": lambda p: ink_files.write_nrrd(p, BLOB),
    "gzip.nrrd": lambda p: ink_files.write_nrrd(p, BLOB, "gzip"),
    "ras.nrrd": lambda p: ink_files.write_nrrd(p, BLOB, space="RAS", directions="(-1,0,0) (0,-1,0) (0,0,1)"),
    "las.nrrd": lambda p: ink_files.write_nrrd(p, BLOB, space="LAS", directions="(1,0,0) (0,-1,0) (0,0,1)"),
    "text.nrrd": lambda p: ink_files.write_nrrd(p, BLOB, "ascii"),
    "capital.nrrd": capital_nrrd,
    "numbered.nhdr": numbered_nrrd,
    "listed.mhd": listed_metaimage,
    "text.mha": text_metaimage,
    "second.nii": lambda p: ink_files.write_nifti2(p, BLOB, AFFINE),
    "quaternion.nii": lambda p: nifti_by_quaternion(p, BLOB, 1),
    "quaternion-down.nii": lambda p: nifti_by_quaternion(p, BLOB[::-1], -1),
    "pair.hdr": nifti_pair,
    "pair.img": nifti_pair,
    "analyze.hdr": lambda p: nifti_pair(p, bytes(4)),
    "turned.nrrd": turned_nrrd,
    "detached.nhdr": lambda p: ink_files.write_nrrd(p, BLOB),
    "plain.mha": lambda p: ink_files.write_metaimage(p, BLOB),
    "compressed.mha": lambda p: ink_files.write_metaimage(p, BLOB, compressed=True),
    "turned.mha": lambda p: ink_files.write_metaimage(p, BLOB[:, ::-1], matrix="1 0 0 0 -1 0 0 0 1", offset="0 31 0"),
    "separate.mhd": lambda p: ink_files.write_metaimage(p, BLOB),
    "ascii.vti": lambda p: ink_files.write_vti(p, BLOB, "ascii"),
    "binary.vti": lambda p: ink_files.write_vti(p, BLOB, "binary"),
    "appended.vti": lambda p: ink_files.write_vti(p, BLOB, "appended"),
    "cells.vti": lambda p: ink_files.write_vti(p, BLOB, where="CellData"),
    "binary.vtk": lambda p: ink_files.write_legacy(p, BLOB),
    "cells.vtk": lambda p: ink_files.write_legacy(p, BLOB, where="CELL_DATA"),
    "plain.mrc": lambda p: ink_files.write_mrc(p, BLOB.astype("int16")),
    "turned.map": lambda p: ink_files.write_mrc(p, BLOB.astype("int16").transpose(1, 2, 0), (3, 1, 2), ">"),
    "extended.ccp4": lambda p: ink_files.write_mrc(p, BLOB.astype("uint16"), extended=bytes(80)),
    "compressed.map.gz": lambda p: ink_files.write_mrc(p, BLOB.astype("float32")),
    "plain.npy": lambda p: np.save(p, BLOB),
    "fortran.npy": lambda p: np.save(p, np.asfortranarray(BLOB.astype(">i2").T)),
    "plain.mgh": lambda p: ink_files.write_mgh(p, BLOB.astype("int16")),
    "compressed.mgz": lambda p: ink_files.write_mgh(p, BLOB),
    "grid.vtr": lambda p: ink_files.write_grid(p, BLOB),
    "grid.vts": lambda p: ink_files.write_grid(p, BLOB),
    "plain.slc": lambda p: ink_files.write_slc(p, BLOB),
    "runs.slc": lambda p: ink_files.write_slc(p, BLOB, True),
    "density.cube": lambda p: ink_files.write_cube(p, BLOB),
    "orbital.cube": lambda p: ink_files.write_cube(p, BLOB, -1, "1 7\n"),
    "plain.tif": lambda p: ink_files.write_tiff(p, BLOB),
    "compressed.tiff": lambda p: ink_files.write_tiff(p, BLOB.astype("uint16"), True),
    "slices": tiff_folder,
    "ascii.vtk": lambda p: ink_files.write_legacy(p, BLOB, ascii=True),
    "axial": lambda p: ink_files.write_dicom(p, BLOB),
    "downwards": lambda p: ink_files.write_dicom(p, BLOB[::-1], origin=(0, 0, 31), step=(0, 0, -1)),
    "coronal": lambda p: ink_files.write_dicom(p, BLOB[::-1].transpose(1, 0, 2), orientation=(1, 0, 0, 0, 0, -1),
                                               origin=(0, 0, 31), step=(0, 1, 0), reverse_names=True),
    "implicit": lambda p: ink_files.write_dicom(p, BLOB, implicit=True),
    "scaled": lambda p: ink_files.write_dicom(p, BLOB.astype(int) + 1000, scale=(1, -1000)),
    "UPPER.VTI": lambda p: ink_files.write_vti(p, BLOB),
}


def difference(a, b):
    """The mean difference of two pictures between 0 and 1."""
    return np.abs(a.astype(float) - b).mean() / 255


# The style that is drawn soonest, in a view that has no mirror plane.
OPTIONS = ["--style", "splatting-lines", "--view", "iso"]


@pytest.fixture(scope="module")
def reference(tmp_path_factory, ink):
    folder = tmp_path_factory.mktemp("reference")
    ink_files.write_vti(folder / "blob.vti", BLOB)
    result = ink("render", folder / "blob.vti", "--iso", 100, *OPTIONS, "--size", "200x200", "-o", folder / "r.png")
    assert result.code == 0, result
    return ink_files.read_png(folder / "r.png")


@pytest.mark.parametrize("name", VOLUMES)
def test_every_volume_format_gives_the_same_picture(name, tmp_path, picture, reference):
    VOLUMES[name](tmp_path / name)
    drawn = picture(tmp_path / name, "--iso", 100, *OPTIONS)
    assert (reference < 128).mean() > 0.005, "the reference shows nothing"
    # A mirrored one differs by 0.017.
    assert difference(drawn, reference) < 0.001


@pytest.mark.parametrize("axes, note, expected", [
    # A and B each turn by half of what is missing to a right angle, 13.28 degrees.
    ("(0,0,2) (1,0,0) (0.5,1,0)", "not at right angles; they are taken as the nearest that are",
     [[0, 0, 1], [0.9732, -0.2298, 0], [0.2298, 0.9732, 0]]),
    ("(1,0,0) (0.5,1,0) (1,1,0.01)", "lie in a plane; they are taken as the world's", None),
])
def test_axes_that_are_not_at_right_angles_are_said(axes, note, expected, tmp_path, ink):
    header = (
        "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 4 4 4\nencoding: raw\nspace: left-posterior-superior\n"
        f"space directions: {axes}\nspace origin: (7,8,9)\n\n"
    )
    (tmp_path / "sheared.nrrd").write_bytes(header.encode() + bytes(range(64)))
    result = ink("info", "--json", tmp_path / "sheared.nrrd")
    assert result.code == 0, result
    assert note in result.out + result.err
    found = json.loads(result.out)
    found = found[0] if isinstance(found, list) else found
    if expected is None:
        assert "direction" not in found
    else:
        assert found["origin"] == [7, 8, 9]
        np.testing.assert_allclose(np.array(found["direction"]).reshape(3, 3).T, expected, atol=1e-3)


@pytest.mark.parametrize("sizes, spacings", [("4 4 4", "0.5 1 2"), ("1 4 4 4", "NaN 0.5 1 2"), ("4 4 4 1", "0.5 1 2 nan")])
def test_spacings_of_nrrd(sizes, spacings, tmp_path, ink):
    """An axis that is not of space has none."""
    header = f"NRRD0004\ntype: uchar\ndimension: {len(sizes.split())}\nsizes: {sizes}\nencoding: raw\nspacings: {spacings}\n\n"
    (tmp_path / "spaced.nrrd").write_bytes(header.encode() + bytes(range(64)))
    result = ink("info", tmp_path / "spaced.nrrd")
    assert result.code == 0, result
    assert "0.5 1 2" in result.out


@pytest.mark.parametrize("sizes, axes", [
    ("1 4 4 4", "none (0.5,0,0) (0,1,0) (0,0,2)"), ("1 4 4 4", "(0,0,0) (0.5,0,0) (0,1,0) (0,0,2)"),
    ("4 4 4 1", "(0.5,0,0) (0,1,0) (0,0,2) (0, 0, 0)"), ("4 4 4 1", "(0.5, 0, 0) (0, 1, 0) (0, 0, 2) none"),
])
def test_directions_of_nrrd(sizes, axes, tmp_path, ink):
    """An axis that is not of space has none, or, as SCIRun writes it, one of no length."""
    header = ("NRRD0004\ntype: uchar\ndimension: 4\nencoding: raw\nspace: left-posterior-superior\n"
              f"sizes: {sizes}\nspace directions: {axes}\nspace origin: (7,8,9)\n\n")
    (tmp_path / "directed.nrrd").write_bytes(header.encode() + bytes(range(64)))
    result = ink("info", tmp_path / "directed.nrrd")
    assert result.code == 0, result
    assert "4 x 4 x 4" in result.out and "0.5 1 2" in result.out and "7 8 9" in result.out


def test_an_orientation_is_told_apart(tmp_path, picture, reference):
    """The limit above is tight enough to tell a mirrored volume from the right one."""
    ink_files.write_vti(tmp_path / "mirrored.vti", np.ascontiguousarray(BLOB[:, ::-1]))
    assert difference(picture(tmp_path / "mirrored.vti", "--iso", 100, *OPTIONS), reference) > 0.01


RAW_TYPES = ["int8", "uint8", "int16", "uint16", "int32", "uint32", "int64", "uint64", "float32", "float64"]


@pytest.fixture(scope="module")
def half(tmp_path_factory, ink):
    """The picture of values that fit into all types."""
    folder = tmp_path_factory.mktemp("half")
    ink_files.write_vti(folder / "half.vti", BLOB // 2)
    result = ink("render", folder / "half.vti", "--iso", 50, *OPTIONS, "--size", "200x200", "-o", folder / "h.png")
    assert result.code == 0, result
    return ink_files.read_png(folder / "h.png")


@pytest.mark.parametrize("name, order", [(name, "<") for name in RAW_TYPES] + [("int16", ">"), ("float64", ">")])
@pytest.mark.one_build
def test_raw_files_of_every_type(name, order, tmp_path, picture, half):
    volume = (BLOB // 2).astype(np.dtype(name).newbyteorder(order))
    (tmp_path / "blob").write_bytes(volume.tobytes())
    big = ["--big-endian"] if order == ">" else []
    drawn = picture(tmp_path / "blob", "--raw", f"32x32x32:{name}", "--iso", 50, *OPTIONS, *big)
    assert difference(drawn, half) < 0.001


def test_raw_files_whose_names_say_what_is_in_them(ink, tmp_path, half):
    path = tmp_path / "blob_32x32x32_uint8.raw"
    path.write_bytes((BLOB // 2).tobytes())
    result = ink("render", path, "--iso", 50, *OPTIONS, "--size", "200x200", "-o", tmp_path / "b.png")
    assert result.code == 0 and "from its name: 32 x 32 x 32 uint8" in result.err, result
    assert difference(ink_files.read_png(tmp_path / "b.png"), half) < 0.001


def test_raw_spacing(ink, tmp_path):
    (tmp_path / "blob.raw").write_bytes(BLOB.tobytes())
    result = ink("info", tmp_path / "blob.raw", "--raw", "32x32x32:uint8", "--spacing", "0.5,1,2")
    assert result.code == 0
    assert "0.5 1 2" in result.out


def test_spacing_in_place_of_the_files(ink, tmp_path):
    for name, write in (("v.tif", ink_files.write_tiff), ("v.vti", ink_files.write_vti), ("v.nii", ink_files.write_nifti)):
        write(tmp_path / name, BLOB)
        for given in ([], ["--spacing", "0.5,1,2"]):
            result = ink("info", tmp_path / name, *given)
            assert result.code == 0
            assert ("0.5 1 2" in result.out) == bool(given)
    ink_files.write_ply(tmp_path / "m.ply", MESH)
    result = ink("info", tmp_path / "m.ply", "--spacing", "1,1,2")
    assert result.code == 2
    assert f"--spacing: only images of voxels have distances between them, '{tmp_path / 'm.ply'}' is none" in result.err


MESH = ink_files.sphere_mesh()
MESHES = {
    "little.ply": lambda p: ink_files.write_ply(p, MESH),
    "big.ply": lambda p: ink_files.write_ply(p, MESH, "binary_big_endian"),
    "ascii.ply": lambda p: ink_files.write_ply(p, MESH, "ascii"),
    "normals.ply": lambda p: ink_files.write_ply(p, MESH, normals=True),
    "binary.stl": lambda p: ink_files.write_stl(p, MESH),
    "ascii.stl": lambda p: ink_files.write_stl(p, MESH, ascii=True),
    "mesh.obj": lambda p: ink_files.write_obj(p, MESH),
    "mesh.off": lambda p: ink_files.write_off(p, MESH),
    "appended.vtp": lambda p: ink_files.write_vtp(p, MESH),
    "ascii.vtp": lambda p: ink_files.write_vtp(p, MESH, "ascii", normals=False),
    "appended.vtu": lambda p: ink_files.write_vtu(p, MESH),
    "ascii.vtu": lambda p: ink_files.write_vtu(p, MESH, "ascii"),
    "compressed.gii": lambda p: ink_files.write_gifti(p, MESH),
    "big.gii": lambda p: ink_files.write_gifti(p, MESH, "Base64Binary", big=True, columns=True),
    "ascii.gii": lambda p: ink_files.write_gifti(p, MESH, "ASCII"),
}
POINTS = {f"{form}.pcd": lambda p, form=form: ink_files.write_pcd(p, MESH, form) for form in ("ascii", "binary", "binary_compressed")}


# A sphere stands on no side of its own: OBJ's doubles would choose another one.
# Normals that a file gives curve a mesh otherwise than those that are computed.
MESH_OPTIONS = ["--style", "splatting-lines", "--no-curved-meshes", "--up", "z", "--view", "front", "--samples", 20000]


@pytest.fixture(scope="module")
def mesh_reference(tmp_path_factory, ink):
    folder = tmp_path_factory.mktemp("mesh")
    ink_files.write_vtp(folder / "reference.vtp", MESH)
    result = ink("render", folder / "reference.vtp", *MESH_OPTIONS, "--size", "200x200", "-o", folder / "r.png")
    assert result.code == 0, result
    return ink_files.read_png(folder / "r.png")


@pytest.mark.parametrize("name", MESHES)
def test_every_mesh_format_gives_the_same_picture(name, tmp_path, picture, mesh_reference):
    MESHES[name](tmp_path / name)
    drawn = picture(tmp_path / name, *MESH_OPTIONS)
    assert (mesh_reference < 200).mean() > 0.005, "the reference shows nothing"
    # 0.00007.
    assert difference(drawn, mesh_reference) < 0.00015


@pytest.mark.parametrize("name", POINTS)
def test_every_format_of_points_gives_the_same_samples(name, tmp_path, ink):
    """As those of a PLY with the same points and normals."""
    ink_files.write_ply(tmp_path / "reference.ply", (*MESH[:2], MESH[2][:0]), normals=True)
    POINTS[name](tmp_path / name)
    samples = []
    for file in (tmp_path / "reference.ply", tmp_path / name):
        assert ink("sample", file, tmp_path / "out.csv").code == 0
        samples.append(ink_files.read_points(tmp_path / "out.csv"))
    assert all(np.array_equal(samples[0][column], samples[1][column]) for column in ("x", "y", "z", "nx", "ny", "nz"))


WHOLE = {**VOLUMES, **MESHES, **POINTS}
SEVERAL_FILES = ("numbered.nhdr", "listed.mhd")


@pytest.mark.parametrize("name, data", [("numbered.nhdr", "slice030.raw"), ("listed.mhd", "z30.raw")])
def test_a_slice_that_is_cut_off_or_not_there_is_refused(name, data, tmp_path, ink):
    WHOLE[name](tmp_path / name)
    (tmp_path / data).write_bytes(bytes(1000))
    assert "1000 bytes of data" in ink("info", tmp_path / name).error
    (tmp_path / data).unlink()
    assert data in ink("info", tmp_path / name).error


def test_elements_after_the_end_of_xml(tmp_path, ink):
    """As gprMax writes those of its materials."""
    ink_files.write_vti(tmp_path / "v.vti", BLOB)
    expected = ink("info", tmp_path / "v.vti").out
    with open(tmp_path / "v.vti", "ab") as file:
        file.write(b"<gprMax>" + 100 * b'<Material name="free_space">1</Material>\n' + b"</gprMax>\n")
    assert ink("info", tmp_path / "v.vti").out == expected


def test_ply_keeps_what_its_points_have(tmp_path, ink):
    """Coordinates in double, as those of surveys need it, and arrays that are not x, y, z and a normal."""
    rows = np.zeros(3, [(n, "<f8") for n in ("x", "y", "z")] + [(n, "<f4") for n in ("nx", "ny", "nz", "Radius")])
    rows["x"] = [4500000.125, 4500000.25, 4500001.0]
    rows["y"] = [0, 1, 2]
    rows["nz"] = 1
    rows["Radius"] = 0.5
    header = "ply\nformat binary_little_endian 1.0\nelement vertex 3\n"
    header += "".join(f"property {'double' if len(n) == 1 else 'float'} {n}\n" for n in rows.dtype.names) + "end_header\n"
    (tmp_path / "survey.ply").write_bytes(header.encode() + rows.tobytes())
    assert "Radius: float, 1 component," in ink("info", tmp_path / "survey.ply").out
    result = ink("sample", tmp_path / "survey.ply", tmp_path / "out.csv")
    assert result.code == 0, result
    assert sorted(ink_files.read_points(tmp_path / "out.csv")["x"]) == sorted(rows["x"])


@pytest.mark.parametrize("end", ["\n", "\r\n"])
def test_obj_lines_go_on_after_a_backslash(tmp_path, ink, end):
    lines = ["v 0 0 0", "v 1 0 \\", "0", "v 1 1 0", "f 1 2 \\", "  3", "# the end \\"]
    (tmp_path / "m.obj").write_bytes(end.join(lines).encode())
    out = ink("info", tmp_path / "m.obj").out
    assert re.search(r"points +3\b", out) and re.search(r"cells +1\b", out), out


def test_obj_corners_with_normals_of_their_own_become_points(tmp_path, ink):
    """Two faces share an edge, where each has its normal: four vertices, two of them twice."""
    (tmp_path / "m.obj").write_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 0 1\nvt 0 0\nvn 0 0 1\nvn 0 1 0\n"
                                    "f 1/1/1 2/1/1 3/1/1\nf -4//-1 -3//-1 -1//-1\n")
    out = ink("info", tmp_path / "m.obj").out
    assert re.search(r"^points +6$", out, re.M) and re.search(r"^cells +2$", out, re.M) and "Normals: float, 3" in out


@pytest.mark.parametrize("share", [0.02, 0.5, 0.97])
@pytest.mark.parametrize("name", [name for name in WHOLE if "." in name and name not in SEVERAL_FILES])
def test_truncated_files_are_refused(name, share, tmp_path, ink):
    path = tmp_path / name
    WHOLE[name](path)
    data = path.with_suffix(".raw") if path.suffix in (".mhd", ".nhdr") else path
    content = data.read_bytes()[: int(share * data.stat().st_size)]
    if path.suffix == ".obj":
        # Nothing in an OBJ tells how long it is; that a line is cut off can be seen.
        content = content[: content.rindex(b" ")]
    data.write_bytes(content)
    result = ink("info", path)
    assert result.code == 1
    assert name in result.error
