# SPDX-License-Identifier: BSD-3-Clause
"""DICOM files of several frames and with compressed pixels, for tests."""

import struct

import numpy as np

import ink_files


def sequence(group, element, items, defined):
    """Of items, each the bytes of its elements; with lengths or with ends."""
    start, end, rest = (struct.pack("<HH", 0xFFFE, n) for n in (0xE000, 0xE00D, 0xE0DD))
    unknown = struct.pack("<I", 0xFFFFFFFF)
    if defined:
        body = b"".join(start + struct.pack("<I", len(item)) + item for item in items)
        return struct.pack("<HH2s2xI", group, element, b"SQ", len(body)) + body
    body = b"".join(start + unknown + item + end + bytes(4) for item in items)
    return struct.pack("<HH2s2x", group, element, b"SQ") + unknown + body + rest + bytes(4)


def write_enhanced(path, frames, positions, defined=True, scale=None, orientation=(1, 0, 0, 0, 1, 0), items=None):
    """A file of several frames that says in functional groups where they lie. scale: of each its slope."""
    element = ink_files.dicom_element
    decimal = lambda values: "\\".join(f"{v:g}" for v in values)
    one = lambda group, number, *elements: sequence(group, number, [b"".join(elements)], defined)
    meta = element(2, 0x0002, "UI", "1.2.840.10008.5.1.4.1.1.4.1") + element(2, 0x0010, "UI", "1.2.840.10008.1.2.1")
    body = element(0x28, 0x0002, "US", struct.pack("<H", 1)) + element(0x28, 0x0008, "IS", str(len(frames)))
    for tag, value in ((0x0010, frames.shape[1]), (0x0011, frames.shape[2]), (0x0100, 16), (0x0101, 16), (0x0102, 15), (0x0103, 0)):
        body += element(0x28, tag, "US", struct.pack("<H", value))
    measures = element(0x18, 0x0050, "DS", "9") + element(0x28, 0x0030, "DS", "0.5\\0.25")
    # What a private group says of rows and places is not the frames'.
    private = one(0x2005, 0x140F, element(0x20, 0x0032, "DS", "7\\7\\7"), element(0x28, 0x0010, "US", struct.pack("<H", 7)))
    body += one(0x5200, 0x9229, one(0x20, 0x9116, element(0x20, 0x0037, "DS", decimal(orientation))), one(0x28, 0x9110, measures), private)
    groups = []
    for number, position in list(enumerate(positions))[:items]:
        group = one(0x20, 0x9113, element(0x20, 0x0032, "DS", decimal(position)))
        if scale:
            group += one(0x28, 0x9145, element(0x28, 0x1052, "DS", "-3"), element(0x28, 0x1053, "DS", f"{scale[number]:g}"))
        groups.append(group + private)
    body += sequence(0x5200, 0x9230, groups, defined)
    body += element(0x7FE0, 0x0010, "OW", frames.astype("<u2").tobytes())
    meta = element(2, 0x0000, "UL", struct.pack("<I", len(meta))) + meta
    path.write_bytes(bytes(128) + b"DICM" + meta + body)


def run_lengths(frame):
    """A frame of 16 bits as DICOM PS3.5 G has it: the high bytes, then the low ones, all of them literal."""
    segments = []
    for part in (frame >> 8, frame & 255):
        data = part.astype(np.uint8).tobytes()
        runs = b"".join(bytes([len(data[i : i + 128]) - 1]) + data[i : i + 128] for i in range(0, len(data), 128))
        segments.append(runs + bytes(len(runs) % 2))
    head = struct.pack("<16I", 2, 64, 64 + len(segments[0]), *[0] * 13)
    return head + b"".join(segments)


def compress(path, frames, table=False, fragments=1, end=True):
    """Replaces the pixels of a file by compressed ones. table: where frames begin; fragments: of each frame."""
    data = path.read_bytes().replace(ink_files.dicom_element(2, 0x0010, "UI", "1.2.840.10008.1.2.1"), ink_files.dicom_element(2, 0x0010, "UI", "1.2.840.10008.1.2.5\0"))
    head = data[: data.rindex(struct.pack("<HH", 0x7FE0, 0x0010))]
    item = lambda value: struct.pack("<HHI", 0xFFFE, 0xE000, len(value)) + value
    starts, items = [], b""
    for frame in frames:
        starts.append(len(items))
        whole = run_lengths(frame)
        size = -(-len(whole) // fragments) // 2 * 2 + 2
        items += b"".join(item(whole[i : i + size]) for i in range(0, len(whole), size))
    pixels = item(struct.pack(f"<{len(starts)}I", *starts) if table else b"") + items
    path.write_bytes(head + struct.pack("<HH2s2xI", 0x7FE0, 0x0010, b"OB", 0xFFFFFFFF) + pixels + (struct.pack("<HHI", 0xFFFE, 0xE0DD, 0) if end else b""))
