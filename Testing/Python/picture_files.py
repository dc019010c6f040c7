# SPDX-License-Identifier: BSD-3-Clause
"""What tests read of pictures' files beside the pixels of PNGs."""

import struct
import zlib

import numpy as np


def png_chunks(data):
    position = 8
    while position < len(data):
        length, kind = struct.unpack(">I4s", data[position : position + 8])
        yield kind, data[position + 8 : position + 8 + length]
        position += 12 + length


def read_tiff(path):
    """Pixels and tags of a little-endian TIFF in strips, compressed by Deflate with differences of neighbors."""
    data = path.read_bytes()
    assert data[:4] == b"II*\0"
    offset = struct.unpack_from("<I", data, 4)[0]
    sizes = {3: ("H", 2), 4: ("I", 4), 5: ("II", 8)}
    tags = {}
    for i in range(struct.unpack_from("<H", data, offset)[0]):
        tag, kind, count = struct.unpack_from("<HHI", data, offset + 2 + 12 * i)
        letters, size = sizes[kind]
        at = offset + 2 + 12 * i + 8
        at = at if size * count <= 4 else struct.unpack_from("<I", data, at)[0]
        tags[tag] = struct.unpack_from("<" + letters * count, data, at)
    assert tags[259] == (8,) and tags[317] == (2,)
    strips = b"".join(zlib.decompress(data[at : at + size]) for at, size in zip(tags[273], tags[279]))
    pixels = np.frombuffer(strips, np.uint8).reshape(tags[257][0], tags[256][0], tags[277][0])
    return np.cumsum(pixels, axis=1, dtype=np.uint8), tags
