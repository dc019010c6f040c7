# SPDX-License-Identifier: BSD-3-Clause
"""Writes small volumes and meshes in every format that `ink` reads, and reads the PNG files that it writes.

Only numpy and the standard library, so that no reader is tested against its own writer.
"""

import base64
import gzip
import re
import struct
import zlib

import numpy as np


def blob(shape=(32, 32, 32), dtype=np.uint8):
    """A ball with a bump towards +x, a smaller one towards +y and the smallest towards +z: all views differ.

    Indexed [z, y, x]; 0 far outside, 200 inside, with a soft surface at 100.
    """
    z, y, x = np.meshgrid(*[np.linspace(-1, 1, n) for n in shape], indexing="ij")
    distance = np.full(shape, np.inf)
    for center, radius in (((0, 0, 0), 0.5), ((0.5, 0, 0), 0.3), ((0, 0.5, 0), 0.25), ((0, 0, 0.55), 0.2)):
        cx, cy, cz = center
        distance = np.minimum(distance, np.sqrt((x - cx) ** 2 + (y - cy) ** 2 + (z - cz) ** 2) - radius)
    return (200 / (1 + np.exp(distance * 25))).astype(dtype)


def sphere_mesh(rows=60, columns=90):
    """Points, unit normals and triangles (outwards) of a unit sphere."""
    points = [(0.0, 0.0, 1.0)]
    for i in range(1, rows):
        a = np.pi * i / rows
        for j in range(columns):
            b = 2 * np.pi * j / columns
            points.append((np.sin(a) * np.cos(b), np.sin(a) * np.sin(b), np.cos(a)))
    points.append((0.0, 0.0, -1.0))
    at = lambda i, j: 1 + (i - 1) * columns + j % columns
    triangles = []
    for j in range(columns):
        triangles.append((0, at(1, j), at(1, j + 1)))
        triangles.append((len(points) - 1, at(rows - 1, j + 1), at(rows - 1, j)))
        for i in range(1, rows - 1):
            triangles.append((at(i, j), at(i + 1, j), at(i + 1, j + 1)))
            triangles.append((at(i, j), at(i + 1, j + 1), at(i, j + 1)))
    return np.array(points, "<f4"), np.array(points, "<f4"), np.array(triangles, "<i4")


NIFTI_TYPES = {"uint8": 2, "int16": 4, "int32": 8, "float32": 16, "float64": 64, "int8": 256, "uint16": 512}


def write_nifti(path, volume, affine=None, slope=1.0, intercept=0.0, times=1, spacing=(1, 1, 1)):
    """affine: 3x4, from voxel indices to RAS; None: no orientation."""
    header = bytearray(348)
    nz, ny, nx = volume.shape
    struct.pack_into("<i", header, 0, 348)
    struct.pack_into("<8h", header, 40, 4 if times > 1 else 3, nx, ny, nz, times, 1, 1, 1)
    struct.pack_into("<2h", header, 70, NIFTI_TYPES[volume.dtype.name], 8 * volume.dtype.itemsize)
    struct.pack_into("<8f", header, 76, 1, *spacing, 1, 1, 1, 1)
    struct.pack_into("<3f", header, 108, 352, slope, intercept)
    if affine is not None:
        struct.pack_into("<2h", header, 252, 0, 1)
        struct.pack_into("<12f", header, 280, *np.ravel(affine))
    header[344:348] = b"n+1\0"
    data = bytes(header) + b"\0\0\0\0" + volume.tobytes() * times
    path.write_bytes(gzip.compress(data, mtime=0) if path.suffix == ".gz" else data)


def write_nifti2(path, volume, affine):
    """Version 2 of the format, big endian."""
    header = bytearray(544)
    nz, ny, nx = volume.shape
    struct.pack_into(">i8sh", header, 0, 540, b"n+2\0\r\n\x1a\n", NIFTI_TYPES[volume.dtype.name])
    struct.pack_into(">8q", header, 16, 3, nx, ny, nz, 1, 1, 1, 1)
    struct.pack_into(">8d", header, 104, *[1.0] * 8)
    struct.pack_into(">q2d", header, 168, 544, 1, 0)
    struct.pack_into(">2i", header, 344, 0, 1)
    struct.pack_into(">12d", header, 400, *np.ravel(affine))
    path.write_bytes(bytes(header) + volume.byteswap().tobytes())


def write_nrrd(path, volume, encoding="raw", space="left-posterior-superior", directions="(1,0,0) (0,1,0) (0,0,1)",
               origin="(0,0,0)"):
    types = {"uint8": "uchar", "int16": "short", "float32": "float"}
    nz, ny, nx = volume.shape
    header = f"NRRD0004\ntype: {types[volume.dtype.name]}\ndimension: 3\nspace: {space}\nsizes: {nx} {ny} {nz}\n"
    header += f"space directions: {directions}\nkinds: domain domain domain\nendian: little\nencoding: {encoding}\n"
    header += f"space origin: {origin}\n"
    if encoding == "raw":
        data = volume.tobytes()
    elif encoding == "gzip":
        data = gzip.compress(volume.tobytes(), mtime=0)
    else:
        data = " ".join(str(v) for v in volume.ravel()).encode()
    if path.suffix == ".nhdr":
        header += f"data file: {path.stem}.raw\n"
        path.with_suffix(".raw").write_bytes(data)
        data = b""
    path.write_bytes(header.encode() + b"\n" + data)


def write_metaimage(path, volume, compressed=False, matrix="1 0 0 0 1 0 0 0 1", offset="0 0 0"):
    types = {"uint8": "MET_UCHAR", "int16": "MET_SHORT", "float32": "MET_FLOAT"}
    nz, ny, nx = volume.shape
    data = zlib.compress(volume.tobytes()) if compressed else volume.tobytes()
    lines = ["ObjectType = Image", "NDims = 3", "BinaryData = True", "BinaryDataByteOrderMSB = False"]
    lines += [f"CompressedData = {compressed}"]
    if compressed:
        lines += [f"CompressedDataSize = {len(data)}"]
    lines += [f"TransformMatrix = {matrix}", f"Offset = {offset}", "ElementSpacing = 1 1 1", f"DimSize = {nx} {ny} {nz}"]
    lines += [f"ElementType = {types[volume.dtype.name]}"]
    separate = path.suffix == ".mhd"
    lines += [f"ElementDataFile = {path.stem + '.raw' if separate else 'LOCAL'}", ""]
    path.write_bytes("\n".join(lines).encode() + (b"" if separate else data))
    if separate:
        path.with_suffix(".raw").write_bytes(data)


XML_TYPES = {"uint8": "UInt8", "int16": "Int16", "int32": "Int32", "float32": "Float32", "float64": "Float64"}


def data_array(name, values, form, appended, components=1):
    """A <DataArray> element; the binary data of appended ones is added to the bytearray `appended`."""
    element = f'<DataArray type="{XML_TYPES[values.dtype.name]}" Name="{name}" NumberOfComponents="{components}" '
    if form == "ascii":
        return element + 'format="ascii">\n' + " ".join(str(v) for v in values.ravel()) + "\n</DataArray>\n"
    data = struct.pack("<I", values.nbytes) + values.tobytes()
    if form == "binary":
        return element + 'format="binary">\n' + base64.b64encode(data).decode() + "\n</DataArray>\n"
    element += f'format="appended" offset="{len(appended)}"/>\n'
    appended += data
    return element


def vtk_xml(kind, content, appended):
    start = f'<?xml version="1.0"?>\n<VTKFile type="{kind}" version="0.1" byte_order="LittleEndian">\n{content}'
    if appended:
        return start.encode() + b'<AppendedData encoding="raw">\n_' + bytes(appended) + b"\n</AppendedData>\n</VTKFile>\n"
    return start.encode() + b"</VTKFile>\n"


def write_vti(path, volume, form="appended", where="PointData", **others):
    """volume: [z, y, x] or [z, y, x, component], the active array `density`; others: as it, by their names."""
    nz, ny, nx = volume.shape[:3]
    if where == "CellData":
        nx, ny, nz = nx + 1, ny + 1, nz + 1
    extent = f"0 {nx - 1} 0 {ny - 1} 0 {nz - 1}"
    appended = bytearray()
    arrays = "".join(
        data_array(name, values, form, appended, values.shape[3] if values.ndim == 4 else 1)
        for name, values in {"density": volume, **others}.items()
    )
    content = f'<ImageData WholeExtent="{extent}" Origin="0 0 0" Spacing="1 1 1"><Piece Extent="{extent}">\n'
    content += f'<{where} Scalars="density">{arrays}</{where}>\n</Piece></ImageData>\n'
    path.write_bytes(vtk_xml("ImageData", content, appended))


def write_legacy(path, volume, ascii=False, where="POINT_DATA"):
    types = {"uint8": "unsigned_char", "int16": "short", "float32": "float"}
    nz, ny, nx = volume.shape
    header = f"# vtk DataFile Version 3.0\ntest\n{'ASCII' if ascii else 'BINARY'}\nDATASET STRUCTURED_POINTS\n"
    more = 0 if where == "POINT_DATA" else 1
    header += f"DIMENSIONS {nx + more} {ny + more} {nz + more}\nORIGIN 0 0 0\nSPACING 1 1 1\n{where} {nx * ny * nz}\n"
    header += f"SCALARS density {types[volume.dtype.name]} 1\nLOOKUP_TABLE default\n"
    # Binary legacy files are big endian.
    data = " ".join(str(v) for v in volume.ravel()).encode() if ascii else volume.byteswap().tobytes()
    path.write_bytes(header.encode() + data + b"\n")


def write_mrc(path, volume, axes=(1, 2, 3), order="<", cell=None, extended=b""):
    """axes: along which of x, y and z columns, rows and sections of `volume` run, from 1."""
    nz, ny, nx = volume.shape
    along = [(nx, ny, nz)[axes.index(axis)] for axis in (1, 2, 3)]
    header = bytearray(1024)
    struct.pack_into(order + "10i", header, 0, nx, ny, nz, {"int8": 0, "int16": 1, "float32": 2, "uint16": 6}[volume.dtype.name],
                     0, 0, 0, *along)
    struct.pack_into(order + "6f3i", header, 40, *(cell or along), 90, 90, 90, *axes)
    struct.pack_into(order + "2i", header, 88, 1, len(extended))
    header[208:216] = b"MAP " + (b"\x44\x44\0\0" if order == "<" else b"\x11\x11\0\0")
    data = bytes(header) + extended + volume.astype(volume.dtype.newbyteorder(order)).tobytes()
    path.write_bytes(gzip.compress(data, mtime=0) if path.suffix == ".gz" else data)


def write_tiff(path, volume, compressed=False, description=""):
    """One page a slice of unsigned integers, each in one strip, little endian."""
    data = bytearray(b"II*\0\0\0\0\0")
    link = 4
    for image in volume:
        strip = image.astype(image.dtype.newbyteorder("<")).tobytes()
        strip = zlib.compress(strip) if compressed else strip
        text = description.encode() + b"\0"
        offset = len(data)
        data += strip + text + bytes((len(strip) + len(text)) % 2)
        struct.pack_into("<I", data, link, len(data))
        tags = [(256, 4, 1, image.shape[1]), (257, 4, 1, image.shape[0]), (258, 3, 1, 8 * image.itemsize),
                (259, 3, 1, 8 if compressed else 1), (262, 3, 1, 1), (270, 2, len(text), offset + len(strip)),
                (273, 4, 1, offset), (277, 3, 1, 1), (278, 4, 1, image.shape[0]), (279, 4, 1, len(strip))]
        data += struct.pack("<H", len(tags)) + b"".join(struct.pack("<HHII", *tag) for tag in tags)
        link = len(data)
        data += bytes(4)
    path.write_bytes(data)


def write_mgh(path, volume):
    """Along DICOM's axes; .mgz is compressed."""
    kind = {"uint8": 0, "int32": 1, "float32": 3, "int16": 4, "uint16": 10}[volume.dtype.name]
    header = struct.pack(">7ih15f", 1, *volume.shape[::-1], 1, kind, 0, 1, 1, 1, 1, -1, 0, 0, 0, -1, 0, 0, 0, 1,
                         *(-0.5 * volume.shape[2], -0.5 * volume.shape[1], 0.5 * volume.shape[0]))
    data = header.ljust(284, b"\0") + volume.astype(volume.dtype.newbyteorder(">")).tobytes()
    path.write_bytes(gzip.compress(data, mtime=0) if path.suffix == ".mgz" else data)


def write_grid(path, volume):
    """Points one apart, as a rectilinear grid (.vtr) or a structured one."""
    nz, ny, nx = volume.shape
    rectilinear = path.suffix == ".vtr"
    kind = "RectilinearGrid" if rectilinear else "StructuredGrid"
    array = '<DataArray type="Float32" Name="{}" NumberOfComponents="{}" format="ascii">{}</DataArray>'
    rows = [" ".join(map(str, range(n))) for n in (nx, ny, nz)]
    points = " ".join(f"{x} {y} {z}" for z in range(nz) for y in range(ny) for x in range(nx))
    where = ("<Coordinates>" + "".join(array.format("xyz"[i], 1, row) for i, row in enumerate(rows)) + "</Coordinates>" if rectilinear
             else "<Points>" + array.format("points", 3, points) + "</Points>")
    extent = f"0 {nx - 1} 0 {ny - 1} 0 {nz - 1}"
    values = array.format("a", 1, " ".join(map(str, volume.ravel())))
    path.write_text(f'<?xml version="1.0"?>\n<VTKFile type="{kind}" version="1.0" byte_order="LittleEndian">\n'
                    f'<{kind} WholeExtent="{extent}"><Piece Extent="{extent}"><PointData Scalars="a">{values}</PointData>\n'
                    f'{where}</Piece></{kind}></VTKFile>\n')


def write_slc(path, volume, compressed=False):
    """Slices of bytes, or of runs of values that differ."""
    data = b"11111\n%d %d %d 8\n1 1 1\n1 5 0 %d\n1 1 XRGB" % (*volume.shape[::-1], compressed)
    for image in volume:
        values = image.astype("uint8").tobytes()
        if compressed:
            parts = [values[i:i + 127] for i in range(0, len(values), 127)]
            runs = b"".join(bytes([0x80 | len(part)]) + part for part in parts) + b"\0"
            values = b"%d X" % len(runs) + runs
        data += values
    path.write_bytes(data)


def write_cube(path, volume, atoms=1, extra=""):
    """extra: the line after the atoms."""
    lines = "".join(f"{n} {step}\n" for n, step in zip(volume.shape[::-1], ("1 0 0", "0 1 0", "0 0 1")))
    values = "\n".join(" ".join(f"{v:.5E}" for v in row) for row in volume.transpose(2, 1, 0).reshape(-1, len(volume)))
    path.write_text(f"test\n\n{atoms} 0 0 0\n{lines}6 6 1 1 1\n{extra}{values}\n")


def dicom_element(group, element, vr, value, implicit=False):
    if isinstance(value, str):
        value = value.encode() + (b" " if vr != "UI" else b"\0") * (len(value) % 2)
    if implicit:
        return struct.pack("<HHI", group, element, len(value)) + value
    long = vr in ("OB", "OW")
    length = struct.pack("<2xI", len(value)) if long else struct.pack("<H", len(value))
    return struct.pack("<HH", group, element) + vr.encode() + length + value


def write_dicom(folder, volume, orientation=(1, 0, 0, 0, 1, 0), origin=(0, 0, 0), step=(0, 0, 1), spacing=1.0,
                reverse_names=False, implicit=False, scale=None, first=0):
    """One file a slice, 16 bits, little endian. orientation: of rows and columns; step: between slices; implicit:
    without the types of elements, and with a sequence; scale: slope and intercept, or of slice z scale(z); first: before
    the numbers of files and pictures."""
    folder.mkdir(exist_ok=True)
    element = lambda *arguments: dicom_element(*arguments, implicit)
    decimal = lambda values: "\\".join(f"{v:g}" for v in values)
    for z, image in enumerate(volume):
        position = [o + s * z for o, s in zip(origin, step)]
        uid = f"1.2.3.{z + 1}"
        meta = dicom_element(2, 0x0001, "OB", b"\0\1") + dicom_element(2, 0x0002, "UI", "1.2.840.10008.5.1.4.1.1.2")
        meta += dicom_element(2, 0x0003, "UI", uid) + dicom_element(2, 0x0010, "UI", "1.2.840.10008.1.2" if implicit else "1.2.840.10008.1.2.1")
        body = element(8, 0x0016, "UI", "1.2.840.10008.5.1.4.1.1.2") + element(8, 0x0018, "UI", uid)
        body += element(8, 0x0060, "CS", "CT")
        if implicit:
            # A sequence and an item in it without a length, and in that a number of rows that is not the picture's.
            item = element(0x28, 0x0010, "US", struct.pack("<H", 7))
            body += struct.pack("<HHI", 8, 0x1140, 0xFFFFFFFF) + struct.pack("<HHI", 0xFFFE, 0xE000, 0xFFFFFFFF) + item
            body += struct.pack("<HHI", 0xFFFE, 0xE00D, 0) + struct.pack("<HHI", 0xFFFE, 0xE0DD, 0)
        body += element(0x18, 0x0050, "DS", f"{spacing:g}")
        body += element(0x20, 0x000D, "UI", "1.2.9") + element(0x20, 0x000E, "UI", "1.2.8")
        body += element(0x20, 0x0013, "IS", str(first + z + 1))
        body += element(0x20, 0x0032, "DS", decimal(position)) + element(0x20, 0x0037, "DS", decimal(orientation))
        body += element(0x28, 0x0002, "US", struct.pack("<H", 1))
        body += element(0x28, 0x0004, "CS", "MONOCHROME2")
        body += element(0x28, 0x0010, "US", struct.pack("<H", image.shape[0]))
        body += element(0x28, 0x0011, "US", struct.pack("<H", image.shape[1]))
        body += element(0x28, 0x0030, "DS", "1\\1")
        body += element(0x28, 0x0100, "US", struct.pack("<H", 16)) + element(0x28, 0x0101, "US", struct.pack("<H", 16))
        body += element(0x28, 0x0102, "US", struct.pack("<H", 15)) + element(0x28, 0x0103, "US", struct.pack("<H", 0))
        if scale:
            slope, intercept = scale(z) if callable(scale) else scale
            body += element(0x28, 0x1052, "DS", f"{intercept:g}") + element(0x28, 0x1053, "DS", f"{slope:g}")
        body += element(0x7FE0, 0x0010, "OW", image.astype("<u2").tobytes())
        meta = dicom_element(2, 0x0000, "UL", struct.pack("<I", len(meta))) + meta
        number = first + (len(volume) - z if reverse_names else z)
        (folder / f"slice{number:03}.dcm").write_bytes(b"\0" * 128 + b"DICM" + meta + body)


def write_ply(path, mesh, form="binary_little_endian", normals=False):
    points, point_normals, triangles = mesh
    columns = np.hstack([points, point_normals]) if normals else points
    names = ["x", "y", "z", "nx", "ny", "nz"][: columns.shape[1]]
    header = f"ply\nformat {form} 1.0\nelement vertex {len(points)}\n"
    header += "".join(f"property float {name}\n" for name in names)
    header += f"element face {len(triangles)}\nproperty list uchar int vertex_indices\nend_header\n"
    if form == "ascii":
        data = "".join(" ".join(f"{v:.9g}" for v in row) + "\n" for row in columns)
        data += "".join("3 %d %d %d\n" % tuple(t) for t in triangles)
        path.write_bytes(header.encode() + data.encode())
        return
    order = "<" if form == "binary_little_endian" else ">"
    faces = np.empty(len(triangles), [("n", "u1"), ("i", order + "i4", 3)])
    faces["n"] = 3
    faces["i"] = triangles
    path.write_bytes(header.encode() + columns.astype(order + "f4").tobytes() + faces.tobytes())


def write_stl(path, mesh, ascii=False):
    points, _, triangles = mesh
    corners = points[triangles]
    if ascii:
        lines = ["solid test"]
        for triangle in corners:
            lines += ["facet normal 0 0 0", "outer loop"]
            lines += ["vertex %.9g %.9g %.9g" % tuple(p) for p in triangle]
            lines += ["endloop", "endfacet"]
        path.write_text("\n".join(lines + ["endsolid test", ""]))
        return
    records = np.zeros(len(triangles), [("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
    records["corners"] = corners
    path.write_bytes(b"binary".ljust(80) + struct.pack("<I", len(triangles)) + records.tobytes())


def write_obj(path, mesh):
    points, _, triangles = mesh
    # Enough digits for a reader that makes doubles of them to find the very floats.
    lines = ["v %.17g %.17g %.17g" % tuple(p) for p in points]
    lines += ["f %d %d %d" % tuple(t + 1) for t in triangles]
    path.write_text("\n".join(lines) + "\n")


def write_off(path, mesh, normals=False):
    points, point_normals, triangles = mesh
    lines = ["NOFF" if normals else "OFF", f"{len(points)} {len(triangles)} 0"]
    columns = np.concatenate([points, point_normals], axis=1) if normals else points
    lines += [" ".join("%.17g" % value for value in row) for row in columns]
    lines += ["3 %d %d %d" % tuple(t) for t in triangles]
    path.write_text("\n".join(lines) + "\n")


def gifti_array(intent, values, encoding="GZipBase64Binary", big=False, columns=False):
    """An element DataArray; columns: its numbers follow each other along columns."""
    numbers = np.asarray(values, "f4" if np.asarray(values).dtype.kind == "f" else "i4")
    data = numbers.astype(numbers.dtype.newbyteorder(">" if big else "<")).tobytes("F" if columns else "C")
    if encoding == "ASCII":
        text = " ".join("%.9g" % value for value in numbers.ravel("F" if columns else "C"))
    else:
        text = base64.b64encode(zlib.compress(data) if encoding[0] == "G" else data).decode()
    sizes = "".join(f' Dim{axis}="{size}"' for axis, size in enumerate(numbers.shape))
    return (f'<DataArray Intent="NIFTI_INTENT_{intent}" DataType="NIFTI_TYPE_{"FLOAT" if numbers.dtype.kind == "f" else "INT"}32" '
            f'ArrayIndexingOrder="{"Column" if columns else "Row"}MajorOrder" Dimensionality="{numbers.ndim}"{sizes} '
            f'Encoding="{encoding}" Endian="{"Big" if big else "Little"}Endian" ExternalFileName="" ExternalFileOffset="0">\n'
            f"<Data>{text}</Data>\n</DataArray>\n")


def write_gifti(path, mesh, encoding="GZipBase64Binary", big=False, columns=False):
    arrays = [("POINTSET", mesh[0].astype("f4")), ("TRIANGLE", mesh[2].astype("i4"))]
    content = "".join(gifti_array(intent, values, encoding, big, columns) for intent, values in arrays)
    path.write_text(f'<?xml version="1.0" encoding="UTF-8"?>\n<GIFTI Version="1.0" NumberOfDataArrays="2">\n{content}</GIFTI>\n')


def pack_lzf(data):
    """Nothing is packed: runs of up to 32 bytes as they are."""
    return b"".join(bytes([len(run) - 1]) + run for run in (data[i : i + 32] for i in range(0, len(data), 32)))


def write_pcd(path, mesh, form="binary_compressed"):
    """The points of a mesh with their normals."""
    columns = np.hstack(mesh[:2]).astype("<f4")
    count = len(columns)
    header = ("# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z normal_x normal_y normal_z\nSIZE 4 4 4 4 4 4\n"
              f"TYPE F F F F F F\nCOUNT 1 1 1 1 1 1\nWIDTH {count}\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS {count}\nDATA {form}\n")
    data = columns.tobytes("F" if form == "binary_compressed" else "C")
    if form == "ascii":
        data = "".join(" ".join("%.9g" % value for value in row) + "\n" for row in columns).encode()
    elif form == "binary_compressed":
        packed = pack_lzf(data)
        data = struct.pack("<II", len(packed), len(data)) + packed
    path.write_bytes(header.encode() + data)


def write_vtp(path, mesh, form="appended", normals=True):
    points, point_normals, triangles = mesh
    appended = bytearray()
    n = len(triangles)
    content = f'<PolyData><Piece NumberOfPoints="{len(points)}" NumberOfVerts="0" NumberOfLines="0" '
    content += f'NumberOfStrips="0" NumberOfPolys="{n}">\n'
    if normals:
        content += f'<PointData Normals="Normals">{data_array("Normals", point_normals, form, appended, 3)}</PointData>\n'
    content += f'<Points>{data_array("Points", points, form, appended, 3)}</Points>\n'
    content += f'<Polys>{data_array("connectivity", triangles, form, appended)}'
    content += f'{data_array("offsets", np.arange(3, 3 * n + 1, 3, dtype="<i4"), form, appended)}</Polys>\n'
    path.write_bytes(vtk_xml("PolyData", content + "</Piece></PolyData>\n", appended))


def write_vtu(path, mesh, form="appended"):
    """The triangles as cells of an unstructured grid."""
    points, _, triangles = mesh
    appended = bytearray()
    n = len(triangles)
    content = f'<UnstructuredGrid><Piece NumberOfPoints="{len(points)}" NumberOfCells="{n}">\n'
    content += f'<Points>{data_array("Points", points, form, appended, 3)}</Points>\n'
    content += f'<Cells>{data_array("connectivity", triangles, form, appended)}'
    content += data_array("offsets", np.arange(3, 3 * n + 1, 3, dtype="<i4"), form, appended)
    content += f'{data_array("types", np.full(n, 5, "u1"), form, appended)}</Cells>\n'
    path.write_bytes(vtk_xml("UnstructuredGrid", content + "</Piece></UnstructuredGrid>\n", appended))


def read_png(path):
    """The pixels, [row from the top, column, component], 8 bits each."""
    data = path.read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n", f"{path} is not a PNG file"
    position, compressed = 8, b""
    while position < len(data):
        length, kind = struct.unpack(">I4s", data[position : position + 8])
        chunk = data[position + 8 : position + 8 + length]
        if kind == b"IHDR":
            width, height, depth, color, _, _, interlaced = struct.unpack(">IIBBBBB", chunk)
            assert depth == 8 and color in (2, 6) and not interlaced
        elif kind == b"IDAT":
            compressed += chunk
        position += 12 + length
    components = 3 if color == 2 else 4
    rows = np.frombuffer(zlib.decompress(compressed), np.uint8).reshape(height, 1 + width * components)
    image = np.zeros((height + 1, (width + 1) * components), np.int32)
    for y, row in enumerate(rows.astype(np.int32)):
        image[y + 1, components:] = unfilter(row[0], row[1:], image[y], components)
    return image[1:, components:].astype(np.uint8).reshape(height, width, components)


def unfilter(kind, row, above, components):
    """Undoes one of PNG's five filters. above starts with one pixel of zeros."""
    if kind == 0:
        return row
    if kind == 2:
        return (row + above[components:]) & 255
    if kind == 1:
        return (np.cumsum(row.reshape(-1, components), axis=0) & 255).ravel()
    result = [0] * components
    above = above.tolist()
    for i, value in enumerate(row.tolist()):
        a, b, c = result[i], above[i + components], above[i]
        if kind == 3:
            predicted = (a + b) // 2
        else:
            p = a + b - c
            predicted = min((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c))[2]
        result.append((value + predicted) & 255)
    return np.array(result[components:])


def read_points(path):
    """What `ink sample` writes, as columns by name: x y z nx ny nz and others; those of .xyz are numbered."""
    suffix = path.suffix.lower()
    if suffix == ".xyz":
        return {str(i): column for i, column in enumerate(np.loadtxt(path, ndmin=2).T)}
    if suffix == ".csv":
        names = path.read_text().split("\n", 1)[0].split(",")
        table = dict(zip(names, np.loadtxt(path, delimiter=",", skiprows=1, ndmin=2).T))
        return {name: column.astype(int) if name == "SurfaceIndex" else column for name, column in table.items()}
    data = path.read_bytes()
    if suffix == ".ply":
        return read_ply_points(data)
    arrays = read_vtp_arrays(data) if suffix == ".vtp" else read_legacy_arrays(data)
    columns = {}
    for name, values in arrays.items():
        names = {"Points": ["x", "y", "z"], "Normals": ["nx", "ny", "nz"]}.get(name, [name])
        columns.update(zip(names, values.reshape(len(values), -1).T))
    return columns


def read_ply_points(data):
    head, records = data.split(b"end_header\n", 1)
    types = {"float": "<f4", "double": "<f8", "int": "<i4", "uint": "<u4", "short": "<i2", "ushort": "<u2", "char": "<i1", "uchar": "<u1"}
    words = [line.split() for line in head.decode().splitlines()]
    assert words[0] == ["ply"] and words[1] == ["format", "binary_little_endian", "1.0"]
    count = next(int(line[2]) for line in words if line[:2] == ["element", "vertex"])
    table = np.frombuffer(records, [(line[2], types[line[1]]) for line in words if line[0] == "property"])
    assert len(table) == count
    return {name: table[name] for name in table.dtype.names}


def read_vtp_arrays(data):
    head, appended = data.split(b'<AppendedData encoding="raw">\n_', 1)
    points = int(re.search(rb'NumberOfPoints="(\d+)"', head)[1])
    types = {"Float32": "<f4", "Float64": "<f8", "Int32": "<i4", "Int64": "<i8"}
    arrays = {}
    end = 0
    for kind, name, components, offset in re.findall(
            r'type="(\w+)" Name="(\w+)" NumberOfComponents="(\d)" format="appended" offset="(\d+)"', head.decode()):
        offset = int(offset)
        assert offset == end
        size = struct.unpack_from("<Q", appended, offset)[0]
        values = np.frombuffer(appended[offset + 8 : offset + 8 + size], types[kind])
        arrays[name] = values.reshape(-1, int(components)) if components != "1" else values
        end = offset + 8 + size
    assert appended[end:] == b"\n</AppendedData>\n</VTKFile>\n"
    assert arrays.pop("offsets").tolist() == [points]
    assert np.array_equal(arrays.pop("connectivity"), np.arange(points))
    assert {len(values) for values in arrays.values()} == {points}
    return arrays


def read_legacy_arrays(data):
    types = {b"float": ">f4", b"double": ">f8", b"int": ">i4"}
    position = 0

    def line():
        nonlocal position
        end = data.index(b"\n", position)
        words, position = data[position:end].split(), end + 1
        return words

    def block(kind, shape):
        nonlocal position
        count = int(np.prod(shape))
        values = np.frombuffer(data, types[kind], count, position).reshape(shape)
        position += values.nbytes
        assert data[position : position + 1] == b"\n"
        position += 1
        return values.astype(values.dtype.newbyteorder("="))

    assert line()[:2] == [b"#", b"vtk"]
    line()
    assert [line(), line()] == [[b"BINARY"], [b"DATASET", b"POLYDATA"]]
    _, count, kind = line()
    count = int(count)
    arrays = {"Points": block(kind, (count, 3))}
    assert line() == [b"VERTICES", b"1", str(count + 1).encode()]
    assert np.array_equal(block(b"int", (count + 1,)), [count, *range(count)])
    assert line() == [b"POINT_DATA", str(count).encode()]
    while position < len(data):
        words = line()
        if words[0] == b"NORMALS":
            arrays["Normals"] = block(words[2], (count, 3))
        elif words[0] != b"FIELD":
            arrays[words[0].decode()] = block(words[3], (count,))
    return arrays
