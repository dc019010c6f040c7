#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes small files of every format that `ink` reads but OpenVDB, for the fuzzer to start from:
Corpus/FORMAT/seed-*. Needs numpy:  make_seeds.py [FOLDER]"""

import gzip
import io
import struct
import sys
import tempfile
import zlib
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "Python"))
import dicom_files  # noqa: E402
import ink_files  # noqa: E402

VOLUME = ink_files.blob((4, 3, 4))
MESH = ink_files.sphere_mesh(3, 3)
AFFINE = np.array([[-1, 0, 0, 0], [0, -2, 0, 0], [0, 0, 1, 5]])


def dicom(path, implicit=False):
    with tempfile.TemporaryDirectory() as folder:
        ink_files.write_dicom(Path(folder) / "series", VOLUME[:1], implicit=implicit, scale=(2, -1) if implicit else None)
        path.write_bytes((Path(folder) / "series" / "slice000.dcm").read_bytes())


def enhanced_dicom(path, defined=True, compressed=False):
    dicom_files.write_enhanced(path, VOLUME[:2], [(0, 0, z) for z in range(2)], defined, scale=[1, 2])
    if compressed:
        dicom_files.compress(path, VOLUME[:2].astype(np.uint16), table=True)


def npy(array):
    file = io.BytesIO()
    np.save(file, array)
    return file.getvalue()


def ply(path, header, data):
    path.write_bytes(f"ply\n{header}end_header\n".encode() + data)


def point_ply(path):
    """As `ink sample` writes them, with doubles."""
    table = np.zeros(3, [(name, "<f8") for name in "xyz"] + [(name, "<f4") for name in ("nx", "ny", "nz", "Radius")])
    table["x"] = [0, 1, 2]
    table["nz"] = 1
    properties = "".join(f"property double {n}\n" for n in "xyz")
    properties += "".join(f"property float {n}\n" for n in ("nx", "ny", "nz", "Radius"))
    ply(path, f"format binary_little_endian 1.0\ncomment points\nelement vertex 3\n{properties}", table.tobytes())


def rich_ply(path):
    """Colors, lists of another name, elements besides vertices and faces, quadrilaterals."""
    ply(path,
        "format ascii 1.0\nobj_info made by hand\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
        "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 2\n"
        "property list uchar uint vertex_index\nproperty uchar intensity\nelement edge 1\nproperty int vertex1\n"
        "property int vertex2\n",
        b"0 0 0 255 0 0\n1 0 0 0 255 0\n1 1 0 0 0 255\n0 1 0.5 9 9 9\n4 0 1 2 3 7\n3 2 1 0 8\n0 1\n")


def arrays_gii(path):
    """Point arrays, one of which has a name."""
    named = ink_files.gifti_array("SHAPE", np.arange(3.0)).replace(
        "<Data>", "<MetaData><MD><Name><![CDATA[Name]]></Name><Value><![CDATA[curv]]></Value></MD></MetaData><Data>")
    arrays = [("POINTSET", np.eye(3)), ("TRIANGLE", np.array([[0, 1, 2]])), ("LABEL", np.arange(3)), ("VECTOR", np.eye(3)),
              ("TIME_SERIES", np.arange(4.0))]
    path.write_text('<?xml version="1.0"?>\n<!DOCTYPE GIFTI SYSTEM "gifti.dtd">\n<GIFTI Version="1.0">\n<MetaData/>'
                    + "".join(ink_files.gifti_array(intent, values, "ASCII") for intent, values in arrays) + named + "</GIFTI>\n")


def rich_obj(path):
    path.write_text("# comment\nmtllib a.mtl\no thing\nv 0 0 0\nv 1 0 0 1\nv 1 1 0 .5 .5 .5\nv 0 1 1e-1\nvt 0 0\nvt 1 1\n"
                    "vn 0 0 1\nvn 0 1 0\ng part\nusemtl red\ns 1\nf 1/1/1 2/2/1 3/1/1 4/2/2\nf -4//-2 -3//-1 -1//-1\nl 1 2\np 3\n")


def obj_with_normals(path):
    points, normals, triangles = MESH
    path.write_text("".join("v %g %g %g\n" % tuple(p) for p in points) + "".join("vn %g %g %g\n" % tuple(n) for n in normals)
                    + "".join("f %d//%d %d//%d %d//%d\n" % tuple(np.repeat(t + 1, 2)) for t in triangles))


def raw(path, layout, dtype):
    path.write_bytes(layout.encode() + b"\n" + VOLUME.astype(dtype).tobytes())


def compressed_vti(path):
    data = VOLUME.tobytes()
    packed = zlib.compress(data)
    block = np.array([1, len(data), len(data), len(packed)], "<u4").tobytes() + packed
    head = ('<?xml version="1.0"?>\n<VTKFile type="ImageData" version="0.1" byte_order="LittleEndian" '
            'compressor="vtkZLibDataCompressor">\n<ImageData WholeExtent="0 3 0 2 0 3" Origin="0 0 0" Spacing="1 1 1">'
            '<Piece Extent="0 3 0 2 0 3">\n<PointData Scalars="a"><DataArray type="UInt8" Name="a" format="appended" '
            'offset="0"/></PointData>\n</Piece></ImageData>\n<AppendedData encoding="raw">\n_')
    path.write_bytes(head.encode() + block + b"\n</AppendedData>\n</VTKFile>\n")


def vertex_vtp(path):
    path.write_text('<?xml version="1.0"?>\n<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" '
                    'header_type="UInt64">\n<PolyData><Piece NumberOfPoints="3" NumberOfVerts="1" NumberOfLines="1" '
                    'NumberOfStrips="1" NumberOfPolys="0">\n<Points><DataArray type="Float64" NumberOfComponents="3" '
                    'format="ascii">0 0 0 1 0 0 1 1 0</DataArray></Points>\n<PointData><DataArray type="Float32" Name="Radius" '
                    'format="ascii">1 1 1</DataArray></PointData>\n'
                    + "".join(f'<{kind}><DataArray type="Int64" Name="connectivity" format="ascii">0 1 2</DataArray>'
                              f'<DataArray type="Int64" Name="offsets" format="ascii">3</DataArray></{kind}>\n'
                              for kind in ("Verts", "Lines", "Strips"))
                    + "</Piece></PolyData></VTKFile>\n")


def grid_xml(path, kind, points):
    values = "".join(f"{v} " for v in range(18))
    path.write_text(f'<?xml version="1.0"?>\n<VTKFile type="{kind}" version="1.0" byte_order="LittleEndian" '
                    f'header_type="UInt64">\n<{kind} WholeExtent="0 2 0 2 0 1"><Piece Extent="0 2 0 2 0 1">\n'
                    f'<PointData Scalars="a"><DataArray type="Float32" Name="a" format="ascii">{values}</DataArray>'
                    f'</PointData>\n{points}\n</Piece></{kind}></VTKFile>\n')


def vtr(path):
    grid_xml(path, "RectilinearGrid", "<Coordinates>" + "".join(
        f'<DataArray type="Float64" Name="{name}" format="ascii">{row}</DataArray>'
        for name, row in (("x", "0 1 3"), ("y", "0 2 3"), ("z", "0 1"))) + "</Coordinates>")


def vts(path):
    points = "".join(f"{i % 3 + i // 9} {i // 3 % 3} {i // 9} " for i in range(18))
    grid_xml(path, "StructuredGrid",
             f'<Points><DataArray type="Float32" NumberOfComponents="3" format="ascii">{points}</DataArray></Points>')


def grid_vtk(path):
    path.write_text("# vtk DataFile Version 3.0\ntest\nASCII\nDATASET STRUCTURED_GRID\nDIMENSIONS 2 2 2\nPOINTS 8 float\n"
                    + "".join(f"{i % 2 + i // 4} {i // 2 % 2} {i // 4}\n" for i in range(8))
                    + "POINT_DATA 8\nSCALARS a float\nLOOKUP_TABLE default\n1 2 3 4 5 6 7 8\n")


def rectilinear_vtk(path):
    path.write_bytes(b"# vtk DataFile Version 3.0\ntest\nBINARY\nDATASET RECTILINEAR_GRID\nDIMENSIONS 3 2 2\n"
                     + b"".join(b"%s_COORDINATES %d float\n" % (name, len(row)) + np.array(row, ">f4").tobytes() + b"\n"
                                for name, row in ((b"X", [0, 1, 3]), (b"Y", [0, 1]), (b"Z", [1, 0])))
                     + b"POINT_DATA 12\nSCALARS a short\nLOOKUP_TABLE default\n" + np.arange(12, dtype=">i2").tobytes())


def grid_vtu(path, points, connectivity, offsets, types, more="", version="1.0"):
    path.write_text(f'<?xml version="1.0"?>\n<VTKFile type="UnstructuredGrid" version="{version}" byte_order="LittleEndian" '
                    f'header_type="UInt64">\n<UnstructuredGrid><Piece NumberOfPoints="{len(points.split()) // 3}" '
                    f'NumberOfCells="{len(types.split())}">\n<Points><DataArray type="Float64" NumberOfComponents="3" '
                    f'format="ascii">{points}</DataArray></Points>\n<CellData><DataArray type="Int32" Name="n" '
                    f'format="ascii">{types}</DataArray></CellData>\n<Cells>\n'
                    + cell_array("connectivity", connectivity) + cell_array("offsets", offsets) + cell_array("types", types)
                    + more + "</Cells>\n</Piece></UnstructuredGrid></VTKFile>\n")


def legacy_mesh(path, sections, version="3.0"):
    path.write_text(f"# vtk DataFile Version {version}\ntest\nASCII\nDATASET {sections}")


def legacy_grid(path, version="3.0", binary=False):
    """A tetrahedron and a triangle, with values."""
    def numbers(values, dtype):
        values = [int(v) for v in values.split()]
        return (np.array(values, dtype).tobytes() if binary else " ".join(map(str, values)).encode()) + b"\n"

    head = f"# vtk DataFile Version {version}\ntest\n{'BINARY' if binary else 'ASCII'}\nDATASET UNSTRUCTURED_GRID\n"
    data = head.encode() + b"POINTS 4 float\n" + numbers(TETRAHEDRON, ">f4")
    if version.startswith("5"):
        data += b"CELLS 3 7\nOFFSETS vtktypeint64\n" + numbers("0 4 7", ">i8")
        data += b"CONNECTIVITY vtktypeint64\n" + numbers("0 1 2 3 0 1 2", ">i8")
    else:
        data += b"CELLS 2 9\n" + numbers("4 0 1 2 3 3 0 1 2", ">i4")
    data += b"CELL_TYPES 2\n" + numbers("10 5", ">i4")
    data += b"POINT_DATA 4\nSCALARS a float 1\nLOOKUP_TABLE default\n" + numbers("1 2 3 4", ">f4")
    data += b"CELL_DATA 2\nFIELD FieldData 1\nb 1 2 int\n" + numbers("7 8", ">i4")
    path.write_bytes(data)


def cell_array(name, numbers):
    return f'<DataArray type="Int64" Name="{name}" format="ascii">{numbers}</DataArray>\n'


CUBE = "0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1"
TETRAHEDRON = "0 0 0 2 0 0 0 2 0 0 0 2"
MIDDLES = " 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 0 1 1"
FACES = cell_array("faces", "4 3 0 2 1 3 0 1 3 3 1 2 3 3 0 3 2") + cell_array("faceoffsets", "17 -1")
NEW_FACES = (cell_array("face_connectivity", "0 2 1 0 1 3 1 2 3 0 3 2") + cell_array("face_offsets", "3 6 9 12")
             + cell_array("polyhedron_to_faces", "0 1 2 3") + cell_array("polyhedron_offsets", "4 4"))


def field_vtk(path):
    path.write_text("# vtk DataFile Version 2.0\ntest\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 2 2\nASPECT_RATIO 1 1 1\n"
                    "ORIGIN 0 0 0\nCELL_DATA 1\nSCALARS c float\nLOOKUP_TABLE t\n1\nLOOKUP_TABLE t 1\n0 0 0 1\n"
                    "POINT_DATA 8\nVECTORS v float\n" + "1 2 3\n" * 8 + "FIELD FieldData 1\na 1 8 short\n1 2 3 4 5 6 7 8\n")


SEEDS = {
    "ply/ascii": lambda p: ink_files.write_ply(p, MESH, "ascii", normals=True),
    "ply/little": lambda p: ink_files.write_ply(p, MESH),
    "ply/big": lambda p: ink_files.write_ply(p, MESH, "binary_big_endian"),
    "ply/points": point_ply,
    "ply/rich": rich_ply,
    "obj/plain": lambda p: ink_files.write_obj(p, MESH),
    "obj/normals": obj_with_normals,
    "obj/rich": rich_obj,
    "off/plain": lambda p: ink_files.write_off(p, MESH),
    "off/normals": lambda p: ink_files.write_off(p, MESH, normals=True),
    "off/rich": lambda p: p.write_text("CNOFF 3 3 0 # rich\n0 0 0 0 0 1 255 0 0 255\n1 0 0 0 0 1 0 9 0\n0 1 0 0 0 1 1 1 1 1\n"
                                       "3 0 1 2 0.5 0 0 1\n2 0 1\n1 2\n"),
    "stl/binary": lambda p: ink_files.write_stl(p, MESH),
    "stl/ascii": lambda p: ink_files.write_stl(p, MESH, ascii=True),
    "vtp/ascii": lambda p: ink_files.write_vtp(p, MESH, "ascii"),
    "vtp/binary": lambda p: ink_files.write_vtp(p, MESH, "binary"),
    "vtp/appended": lambda p: ink_files.write_vtp(p, MESH),
    "vtp/vertices": vertex_vtp,
    "vtu/ascii": lambda p: ink_files.write_vtu(p, MESH, "ascii"),
    "vtu/binary": lambda p: ink_files.write_vtu(p, MESH, "binary"),
    "vtu/appended": lambda p: ink_files.write_vtu(p, MESH),
    "vtu/mixed": lambda p: grid_vtu(p, CUBE, "0 1 2 3 4 5 6 7 0 1 2 4 0 1 5 4 0 1 6 7 5", "8 12 15 17 20 21", "12 10 5 3 4 1"),
    "vtu/quadratic": lambda p: grid_vtu(p, TETRAHEDRON + MIDDLES, "0 1 2 3 4 5 6 7 8 9 0 1 2 4 5 6", "10 16", "24 22"),
    "vtu/polyhedron": lambda p: grid_vtu(p, TETRAHEDRON, "0 1 2 3 0 1 2", "4 7", "42 7", FACES),
    "vtu/new-polyhedron": lambda p: grid_vtu(p, TETRAHEDRON, "0 1 2 3 0 1 2", "4 7", "42 7", NEW_FACES, "2.3"),
    "vtu/lagrange": lambda p: grid_vtu(p, CUBE, "0 1 2 3 4 5 6 7", "8", "72"),
    "gii/ascii": lambda p: ink_files.write_gifti(p, MESH, "ASCII"),
    "gii/base64": lambda p: ink_files.write_gifti(p, MESH, "Base64Binary", big=True),
    "gii/compressed": lambda p: ink_files.write_gifti(p, MESH, columns=True),
    "gii/arrays": arrays_gii,
    "pcd/ascii": lambda p: ink_files.write_pcd(p, MESH, "ascii"),
    "pcd/binary": lambda p: ink_files.write_pcd(p, MESH, "binary"),
    "pcd/compressed": lambda p: ink_files.write_pcd(p, MESH),
    "pcd/repeats": lambda p: p.write_bytes(b"FIELDS x y z\nPOINTS 20\nDATA binary_compressed\n" + struct.pack("<II", 13, 240)
                                           + b"\3\0\0\x80?" b"\xe0\xc8\3" b"\xa0\3" b"\xe0\x0b\3"),
    "pcd/rich": lambda p: p.write_text(
        "# .PCD v.5\nVERSION .5\nCOLUMNS x y z rgb label _ normal_x normal_y normal_z h\nSIZE 8 8 4 4 8 1 4 4 4 4\n"
        "TYPE F F I F U U F F F F\nCOUNT 1 1 1 1 1 3 1 1 1 2\nWIDTH 1\nHEIGHT 2\nVIEWPOINT 0 0 0 1 0 0 0\nDATA ascii\n"
        "0.5 1 2 2.3e-38 7 0 0 0 0 0 1 1 2\nnan nan 0 0 7 0 0 0 nan nan nan 1 2\n"),
    "xyz/plain": lambda p: p.write_text("# x y z\n0 0 0\n1,2,3\n+1e3 -.5 2\n"),
    "xyz/normals": lambda p: p.write_text("0 0 0 0 0 1\n1 2 3 0 1 0\n"),
    "nii/plain": lambda p: ink_files.write_nifti(p, VOLUME, AFFINE),
    "nii/times": lambda p: ink_files.write_nifti(p, VOLUME.astype("int16"), times=2, slope=2, intercept=1),
    "nii/second": lambda p: ink_files.write_nifti2(p, VOLUME.astype("int16"), AFFINE),
    "nii.gz/plain": lambda p: p.write_bytes(gzip.compress(nifti_bytes(), mtime=0)),
    "nrrd/raw": lambda p: ink_files.write_nrrd(p, VOLUME),
    "nrrd/gzip": lambda p: ink_files.write_nrrd(p, VOLUME, "gzip"),
    "nrrd/vectors": lambda p: p.write_bytes(
        b"NRRD0005\n# comment\ntype: unsigned short\ndimension: 4\nsizes: 2 2 2 2\nspacings: nan 1 1 2\nkey:=value\n"
        b"encoding: raw\nendian: big\n\n" + bytes(range(32))),
    "nhdr/raw": lambda p: p.write_text("NRRD0004\ntype: uchar\ndimension: 3\nsizes: 4 4 4\nencoding: raw\n"
                                       "space: RAS\nspace directions: (1,0,0) (0,0,1) (0,1,0)\ndata file: a.raw\n"),
    "mha/plain": lambda p: ink_files.write_metaimage(p, VOLUME),
    "mha/compressed": lambda p: ink_files.write_metaimage(p, VOLUME, compressed=True),
    "mhd/separate": lambda p: p.write_text("ObjectType = Image\nNDims = 3\nBinaryData = True\nElementSpacing = 1 1 2\n"
                                           "DimSize = 4 4 4\nElementType = MET_UCHAR\nElementDataFile = a.raw\n"),
    "mrc/plain": lambda p: ink_files.write_mrc(p, VOLUME.astype("int16")),
    "mrc/extended": lambda p: ink_files.write_mrc(p, VOLUME.astype("float32"), (3, 1, 2), ">", extended=bytes(range(80))),
    "map.gz/plain": lambda p: ink_files.write_mrc(p, VOLUME.astype("uint16")),
    "npy/plain": lambda p: p.write_bytes(npy(VOLUME)),
    "npy/fortran": lambda p: p.write_bytes(npy(np.asfortranarray(VOLUME.astype(">f2")))),
    "npy/components": lambda p: p.write_bytes(npy(np.stack([VOLUME] * 3, axis=-1).astype("<i8"))),
    "mgh/plain": lambda p: ink_files.write_mgh(p, VOLUME.astype("int16")),
    "slc/plain": lambda p: ink_files.write_slc(p, VOLUME),
    "slc/runs": lambda p: ink_files.write_slc(p, VOLUME, True),
    "slc/alike": lambda p: p.write_bytes(b"11111\n9 9 2 8\n1 1 1\n1 5 0 1\n0 0 X" + b"5 X\x501\x81a\0" + b"3 X\x501\0"),
    "cube/plain": lambda p: ink_files.write_cube(p, VOLUME),
    "cube/orbitals": lambda p: p.write_text(
        "orbitals\n\n-1 0 0 0 1\n-2 0.6 0.8 0\n-2 -0.8 0.6 0\n-2 0 0 1\n1 1 0 0 0\n2 7\n8\n" + "1E-3 2.5\n" * 8),
    "tif/plain": lambda p: ink_files.write_tiff(p, VOLUME),
    "tif/compressed": lambda p: ink_files.write_tiff(p, VOLUME.astype("uint16"), True),
    "tif/imagej": lambda p: ink_files.write_tiff(
        p, VOLUME, description="ImageJ=1.53t\nimages=4\nchannels=2\nslices=2\nunit=um\nspacing=2\n"),
    "tif/ome": lambda p: ink_files.write_tiff(
        p, VOLUME, description='<OME><Pixels SizeZ="2" SizeC="1" SizeT="2" DimensionOrder="XYZTC" PhysicalSizeZ="2"/></OME>'),
    "vti/cells": lambda p: ink_files.write_vti(p, VOLUME, "ascii", where="CellData"),
    "vti/ascii": lambda p: ink_files.write_vti(p, VOLUME, "ascii"),
    "vti/binary": lambda p: ink_files.write_vti(p, VOLUME, "binary"),
    "vti/appended": lambda p: ink_files.write_vti(p, VOLUME),
    "vti/compressed": compressed_vti,
    "vtk/binary": lambda p: ink_files.write_legacy(p, VOLUME),
    "vtk/ascii": lambda p: ink_files.write_legacy(p, VOLUME, ascii=True),
    "vtk/cells": lambda p: ink_files.write_legacy(p, VOLUME, where="CELL_DATA"),
    "vtk/fields": field_vtk,
    "vtk/rectilinear": rectilinear_vtk,
    "vtk/structured": grid_vtk,
    "vtr/plain": vtr,
    "vts/plain": vts,
    "vtk/grid": legacy_grid,
    "vtk/grid-binary": lambda p: legacy_grid(p, "4.2", binary=True),
    "vtk/grid-offsets": lambda p: legacy_grid(p, "5.1"),
    "vtk/grid-offsets-binary": lambda p: legacy_grid(p, "5.1", binary=True),
    "vtk/mesh": lambda p: legacy_mesh(p, "POLYDATA\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\nPOLYGONS 1 4\n3 0 1 2\n"
                                         "LINES 1 3\n2 0 1\nPOINT_DATA 3\nNORMALS n float\n0 0 1 0 0 1 0 0 1\n"),
    "vtk/mesh-offsets": lambda p: legacy_mesh(p, "POLYDATA\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\nPOLYGONS 2 3\n"
                                                 "OFFSETS vtktypeint64\n0 3\nCONNECTIVITY vtktypeint64\n0 1 2\n", "5.1"),
    "dicom/slice": dicom,
    "dicom/implicit": lambda p: dicom(p, implicit=True),
    "dicom/enhanced": enhanced_dicom,
    "dicom/endings": lambda p: enhanced_dicom(p, defined=False),
    "dicom/compressed": lambda p: enhanced_dicom(p, compressed=True),
    "raw/bytes": lambda p: raw(p, "4x3x4:uint8", "u1"),
    "raw/doubles": lambda p: raw(p, "4x3x4:float64", "<f8"),
}


def nifti_bytes():
    with tempfile.TemporaryDirectory() as folder:
        ink_files.write_nifti(Path(folder) / "a.nii", VOLUME, AFFINE)
        return (Path(folder) / "a.nii").read_bytes()


if __name__ == "__main__":
    corpus = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent / "Corpus"
    for name, write in SEEDS.items():
        kind, seed = name.split("/")
        (corpus / kind).mkdir(parents=True, exist_ok=True)
        write(corpus / kind / f"seed-{seed}.{kind}")
