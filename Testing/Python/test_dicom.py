# SPDX-License-Identifier: BSD-3-Clause
"""What ink reads of DICOM files: series, files of several frames, compressed pixels."""

import json
import struct
import zlib

import ink_files
import numpy as np
import pytest

from dicom_files import compress, run_lengths, write_enhanced

BLOB = ink_files.blob()


def test_slices_with_scales_of_their_own_say_so(tmp_path, ink):
    ink_files.write_dicom(tmp_path / "series", np.full_like(BLOB, 3), scale=lambda z: (z + 1, 7))
    result = json.loads(ink("info", "--json", tmp_path / "series").out)[0]
    assert result["range"] == [10, 7 + 3 * len(BLOB)]
    assert "its stored values are rescaled, those of each slice by its own scale" in result["note"]


def notes(result):
    assert result.code == 0, result
    return json.loads(result.out)[0]["note"]


@pytest.mark.parametrize("others", [dict(volume=BLOB[:4, :16, :16]), dict(volume=BLOB[:4], orientation=(0, 1, 0, 0, 0, -1))])
def test_pictures_unlike_most_are_left_out(tmp_path, ink, others):
    """As those that a scan was planned on."""
    ink_files.write_dicom(tmp_path / "series", BLOB, first=100)
    expected = json.loads(ink("info", "--json", tmp_path / "series").out)[0]
    ink_files.write_dicom(tmp_path / "series", origin=(0, 0, 40), **others)
    result = ink("info", "--json", tmp_path / "series")
    assert any("4 of its 36 pictures have another size, type, spacing or direction than the 32 that are used" in n for n in notes(result))
    found = json.loads(result.out)[0]
    for key in ("dimensions", "spacing", "origin", "range"):
        assert found[key] == expected[key]


def test_of_a_scan_over_time_the_first_picture_of_each_place_is_used(tmp_path, ink):
    ink_files.write_dicom(tmp_path / "series", BLOB // 2, first=100)
    ink_files.write_dicom(tmp_path / "series", BLOB, reverse_names=True)
    result = ink("info", "--json", tmp_path / "series")
    assert f"its {2 * len(BLOB)} slices lie at {len(BLOB)} places; the first of each is used" in notes(result)
    found = json.loads(result.out)[0]
    assert found["dimensions"] == list(BLOB.shape[::-1]) and found["spacing"] == [1, 1, 1]
    assert found["range"] == [BLOB.min(), BLOB.max()]


def test_pictures_of_one_place_are_no_volume(tmp_path, ink):
    ink_files.write_dicom(tmp_path / "series", BLOB[:5], step=(0, 0, 0))
    result = ink("render", tmp_path / "series", "-o", tmp_path / "out.png")
    assert result.code == 1 and "the volume is a single slice" in result.error
    assert "its 5 slices lie at 1 place" in result.error


@pytest.mark.parametrize("share", [0.2, 0.5, 0.97])
def test_truncated_dicom_files_are_refused(share, tmp_path, ink):
    ink_files.write_dicom(tmp_path / "series", BLOB)
    slice_file = tmp_path / "series" / "slice007.dcm"
    slice_file.write_bytes(slice_file.read_bytes()[: int(share * slice_file.stat().st_size)])
    result = ink("info", tmp_path / "series")
    assert result.code == 1
    assert "series" in result.error


def test_one_file_stands_for_its_series(tmp_path, ink):
    """Whatever it is called, and beside another series."""
    ink_files.write_dicom(tmp_path / "series", BLOB)
    whole = ink("info", tmp_path / "series").out.splitlines()[1:]
    (tmp_path / "series" / "slice003.dcm").rename(tmp_path / "series" / "IM 0003")
    for name in ("slice007.dcm", "IM 0003"):
        result = ink("info", tmp_path / "series" / name)
        assert result.code == 0, result
        lines = result.out.splitlines()[1:]
        assert [line for line in lines if not line.startswith("note")] == [line for line in whole if not line.startswith("note")]
        assert f"it is one of {len(BLOB)} slices in its folder; all of them are read" in result.out
    (tmp_path / "series" / "words.dcm").write_text("no DICOM at all")
    assert "it is no DICOM file" in ink("info", tmp_path / "series" / "words.dcm").error


def test_broken_dicom_files_of_no_series_do_not_hide_the_others(tmp_path, ink):
    folder = tmp_path / "series"
    ink_files.write_dicom(folder, BLOB)
    expected = ink("info", folder).out
    plain = (folder / "slice000.dcm").read_bytes()
    body = plain.index(ink_files.dicom_element(8, 0x0016, "UI", "1.2.840.10008.5.1.4.1.1.2"))
    syntax = [ink_files.dicom_element(2, 0x0010, "UI", uid) for uid in ("1.2.840.10008.1.2.1", "1.2.840.10008.1.2.1.99")]
    assert syntax[0] in plain
    deflated = folder / "deflated.dcm"
    deflated.write_bytes(plain[:body].replace(*syntax) + zlib.compress(plain[body:])[2:-4])
    (folder / "ends.dcm").write_bytes(plain[: body + 5])
    result = ink("info", folder)
    problem = f"cannot read '{deflated}': all of it is compressed"
    note = f"2 of the folder's DICOM files left out: {problem}"
    assert result.code == 0 and note in result.out, result
    assert [line for line in result.out.splitlines() if note not in line] == expected.splitlines()
    assert note in ink("info", folder / "slice003.dcm").out
    assert problem in ink("info", deflated).error
    for file in folder.glob("slice*"):
        file.unlink()
    assert problem in ink("info", folder).error


def test_broken_dicom_files_of_other_series_do_not_hide_one(tmp_path, ink):
    folder = tmp_path / "series"
    ink_files.write_dicom(folder, BLOB)
    other = (folder / "slice000.dcm").read_bytes().replace(*(ink_files.dicom_element(0x20, 0x000E, "UI", uid) for uid in ("1.2.8", "1.2.7")))
    rows = ink_files.dicom_element(0x28, 0x0010, "US", struct.pack("<H", BLOB.shape[1]))
    (folder / "other.dcm").write_bytes(other[: other.index(rows) + 3])
    assert "2 series" in ink("info", folder).out
    assert ink("info", folder / "slice003.dcm").code == 0
    assert "ends within an element" in ink("info", folder / "other.dcm").error


def test_a_missing_slice_is_noted(tmp_path, ink):
    ink_files.write_dicom(tmp_path / "series", BLOB)
    assert "apart" not in ink("info", tmp_path / "series").out
    (tmp_path / "series" / "slice007.dcm").unlink()
    result = ink("info", tmp_path / "series")
    assert result.code == 0
    assert "its slices lie 1 to 2 apart; they are taken as 1 apart" in result.out


def test_slices_of_two_thicknesses(tmp_path, ink):
    """Most are none of both; the volume is as high as it is."""
    ink_files.write_dicom(tmp_path / "series", BLOB)
    ink_files.write_dicom(tmp_path / "series", BLOB, origin=(0, 0, 33), step=(0, 0, 2), first=100)
    result = ink("info", "--json", tmp_path / "series")
    distance = (33 + 2 * 31) / 63
    assert f"its slices lie 1 to 2 apart; they are taken as {distance:.7g} apart" in notes(result)


def test_slices_far_from_the_others_are_left_out(tmp_path, ink):
    ink_files.write_dicom(tmp_path / "series", BLOB)
    expected = json.loads(ink("info", "--json", tmp_path / "series").out)[0]
    ink_files.write_dicom(tmp_path / "series", BLOB[:2], origin=(0, 0, -30), first=100)
    ink_files.write_dicom(tmp_path / "series", BLOB[:1], origin=(0, 0, 60), first=200)
    result = ink("info", "--json", tmp_path / "series")
    assert "3 of its 35 slices lie far from the others and are left out" in notes(result)
    found = json.loads(result.out)[0]
    for key in ("dimensions", "spacing", "origin", "range"):
        assert found[key] == expected[key]


def test_dicom_without_preamble(tmp_path, ink):
    """Files of old begin with their elements."""
    for implicit in (False, True):
        ink_files.write_dicom(tmp_path / "series", BLOB, implicit=implicit)
        expected = ink("info", tmp_path / "series").out
        for file in (tmp_path / "series").iterdir():
            file.write_bytes(file.read_bytes()[132:])
        assert ink("info", tmp_path / "series").out == expected
    # Nor with what says how elements are written.
    meta = 12 + struct.unpack_from("<I", file.read_bytes(), 8)[0]
    for file in (tmp_path / "series").iterdir():
        file.write_bytes(file.read_bytes()[meta:])
    assert ink("info", tmp_path / "series").out == expected


def test_a_file_of_several_frames_is_a_volume(tmp_path, ink):
    ink_files.write_dicom(tmp_path / "series", BLOB[:1])
    data = (tmp_path / "series" / "slice000.dcm").read_bytes()
    image = BLOB[0].astype("<u2").tobytes()
    head = data[: data.rindex(ink_files.dicom_element(0x7FE0, 0x0010, "OW", image))]
    body = ink_files.dicom_element(0x18, 0x0088, "DS", "2.5") + ink_files.dicom_element(0x28, 0x0008, "IS", str(len(BLOB)))
    pixels = ink_files.dicom_element(0x7FE0, 0x0010, "OW", BLOB.astype("<u2").tobytes())
    (tmp_path / "frames").write_bytes(head + body + pixels)
    result = ink("info", tmp_path / "frames")
    assert result.code == 0, result
    assert f"dimensions     {BLOB.shape[2]} x {BLOB.shape[1]} x {BLOB.shape[0]}" in result.out
    assert "spacing        1 1 2.5" in result.out
    assert "it does not say where its pictures lie; they are taken as slices 2.5 apart" in result.out
    (tmp_path / "short").write_bytes(head + body + pixels[:-2])
    assert "the file ends before" in ink("info", tmp_path / "short").error


@pytest.mark.parametrize("defined", [True, False])
def test_frames_lie_where_their_functional_groups_say(tmp_path, ink, defined):
    """In any order, twice each, and turned."""
    frames = np.stack([np.full((6, 8), 10 * z + again) for again in range(2) for z in (2, 0, 3, 1)])
    places = [(5, 4 + 1.5 * z, 3) for _ in range(2) for z in (2, 0, 3, 1)]
    write_enhanced(tmp_path / "frames.dcm", frames, places, defined, orientation=(1, 0, 0, 0, 0, -1))
    result = ink("info", "--json", tmp_path / "frames.dcm")
    assert "its 8 slices lie at 4 places; the first of each is used" in notes(result)
    found = json.loads(result.out)[0]
    assert found["dimensions"] == [8, 6, 4] and found["spacing"] == [0.25, 0.5, 1.5] and found["origin"] == [5, 4, 3]
    assert found["range"] == [0, 30]


def test_frames_have_scales_of_their_own(tmp_path, ink):
    write_enhanced(tmp_path / "frames.dcm", np.full((3, 6, 8), 2), [(0, 0, z) for z in range(3)], scale=[1, 2, 4])
    result = ink("info", "--json", tmp_path / "frames.dcm")
    assert "its stored values are rescaled, those of each slice by its own scale" in notes(result)
    assert json.loads(result.out)[0]["range"] == [2 - 3, 8 - 3]


def test_functional_groups_of_more_or_fewer_frames(tmp_path, ink):
    """More are refused; of fewer it is not known which they belong to."""
    path = tmp_path / "frames.dcm"
    places = [(0, 0, 2 * z) for z in range(4)]
    write_enhanced(path, BLOB[:4], places, items=3)
    result = ink("info", "--json", path)
    assert "it says of 3 of its 4 frames where they lie, which is not used" in notes(result)
    assert json.loads(result.out)[0]["spacing"] == [0.25, 0.5, 9]
    write_enhanced(path, BLOB[:3], places)
    assert "it says 3 frames, but where more lie" in ink("info", path).error


def test_groups_that_are_in_no_item(tmp_path, ink):
    """What they say is no frame's."""
    path = tmp_path / "frames.dcm"
    write_enhanced(path, BLOB[:2], [(0, 0, 0), (0, 0, 5)], defined=False)
    data = path.read_bytes()
    groups = data.index(struct.pack("<HH", 0x5200, 0x9230)) + 12
    inner = struct.pack("<HH2s2xI", 0x2005, 0x140F, b"SQ", 0xFFFFFFFF)
    path.write_bytes(data[:groups] + inner + data[groups + 8 :])
    result = ink("info", path)
    assert result.code == 0 and "spacing        0.25 0.5 9" in result.out
    assert "it says of 1 of its 2 frames where they lie, which is not used" in result.out


def test_sequences_without_end_are_refused(tmp_path, ink):
    """Each within the one before."""
    path = tmp_path / "frames.dcm"
    write_enhanced(path, BLOB[:2], [(0, 0, 0), (0, 0, 1)])
    data = path.read_bytes()
    at = data.index(struct.pack("<HH", 0x5200, 0x9229))
    deeper = struct.pack("<HH2s2xI", 8, 0x1140, b"SQ", 0xFFFFFFFF) + struct.pack("<HHI", 0xFFFE, 0xE000, 0xFFFFFFFF)
    path.write_bytes(data[:at] + 1000 * deeper + data[at:])
    assert "sequences, each within the one before" in ink("info", path).error


@pytest.mark.parametrize("table, fragments", [(False, 1), (True, 1), (True, 2)])
def test_compressed_slices_and_frames(tmp_path, ink, table, fragments):
    volume = BLOB.astype(np.uint16) * 7
    ink_files.write_dicom(tmp_path / "series", volume)
    write_enhanced(tmp_path / "frames.dcm", volume, [(0, 0, z) for z in range(len(volume))])
    expected = [json.loads(ink("info", "--json", tmp_path / name).out)[0] for name in ("series", "frames.dcm")]
    for z, file in enumerate(sorted((tmp_path / "series").iterdir())):
        compress(file, volume[z : z + 1], table, fragments)
    compress(tmp_path / "frames.dcm", volume, table, fragments)
    found = [json.loads(ink("info", "--json", tmp_path / name).out)[0] for name in ("series", "frames.dcm")]
    assert found == expected


def test_compressed_pixels_that_cannot_be_read(tmp_path, ink):
    path = tmp_path / "frames.dcm"
    places = [(0, 0, z) for z in range(4)]

    def error(change=lambda data: data, **how):
        write_enhanced(path, BLOB[:4], places)
        compress(path, BLOB[:4].astype(np.uint16), **how)
        path.write_bytes(change(path.read_bytes()))
        return ink("info", path).error

    assert "ends within its compressed pixels" in error(end=False)
    assert "ends within its compressed pixels" in error(lambda data: data[: len(data) // 2])
    assert "8 fragments of pixels, of which 1 begin a frame; expected 4" in error(fragments=2)

    def move_third(data):
        at = data.index(struct.pack("<HHI", 0xFFFE, 0xE000, 4 * 4)) + 8 + 2 * 4
        return data[:at] + struct.pack("<I", struct.unpack_from("<I", data, at)[0] + 2) + data[at + 4 :]

    assert "8 fragments of pixels, of which 2 begin a frame; expected 4" in error(move_third, fragments=2, table=True)
    assert "something else than items" in error(lambda data: data[:-8] + b"\1" + data[-7:])
    samples = lambda n: ink_files.dicom_element(0x28, 0x0002, "US", struct.pack("<H", n))
    assert "have 2 components; expected 1 or 3" in error(lambda data: data.replace(samples(1), samples(2)))
    few = (0x7FFF).to_bytes(2, "little")
    assert "bytes of compressed pixels, but promises 4 times 2147352578" in error(
        lambda data: data.replace(ink_files.dicom_element(0x28, 0x0010, "US", struct.pack("<H", 32)), ink_files.dicom_element(0x28, 0x0010, "US", few))
        .replace(ink_files.dicom_element(0x28, 0x0011, "US", struct.pack("<H", 32)), ink_files.dicom_element(0x28, 0x0011, "US", few)))
    syntax = "1.2.840.10008.1.2.5\0"
    mpeg = "1.2.840.10008.1.2.4.100\0"
    assert f"cannot be decompressed (transfer syntax {mpeg[:-1]})" in error(
        lambda data: data.replace(ink_files.dicom_element(2, 0x0010, "UI", syntax), ink_files.dicom_element(2, 0x0010, "UI", mpeg)))


def test_signs_that_compression_left_out(tmp_path, ink):
    """Of values of 12 bits: 0xFFF is -1."""
    values = np.array([[[0xFFF, 1], [0x800, 0x7FF]]] * 2, dtype=np.uint16)
    path = tmp_path / "frames.dcm"
    write_enhanced(path, values, [(0, 0, z) for z in range(2)])
    for number, was, value in ((0x0101, 16, 12), (0x0103, 0, 1)):
        element = lambda v: ink_files.dicom_element(0x28, number, "US", struct.pack("<H", v))
        path.write_bytes(path.read_bytes().replace(element(was), element(value)))
    compress(path, values)
    found = json.loads(ink("info", "--json", path).out)[0]
    assert found["range"] == [-2048, 2047] and "short" in found["type"]


def test_run_lengths_whose_head_is_damaged(tmp_path, ink):
    path = tmp_path / "frames.dcm"
    frames = BLOB[:4].astype(np.uint16)
    for head in (bytes(64), b"\xff" * 64, struct.pack("<16I", 2, 64, 32, *[0] * 13), struct.pack("<16I", 2, 64, 1 << 20, *[0] * 13)):
        write_enhanced(path, frames, [(0, 0, z) for z in range(4)])
        compress(path, frames)
        data = path.read_bytes()
        path.write_bytes(data.replace(run_lengths(frames[1])[:64], head))
        assert "cannot be decompressed" in ink("info", path).error


def test_the_volume_is_that_of_the_named_file(tmp_path, ink):
    """Of a localizer, say: as many pictures in each direction."""
    folder = tmp_path / "series"
    ink_files.write_dicom(folder, BLOB)
    ink_files.write_dicom(folder, BLOB[:, :16], first=100)
    assert json.loads(ink("info", "--json", folder).out)[0]["dimensions"] == [32, 32, 32]
    for name, rows in (("slice007.dcm", 32), ("slice107.dcm", 16)):
        result = ink("info", "--json", folder / name)
        assert f"it is one of {len(BLOB)} slices in its folder; all of them are read" in notes(result)
        assert json.loads(result.out)[0]["dimensions"] == [32, rows, 32]


def test_a_picture_of_another_kind_that_cannot_be_read_hides_nothing(tmp_path, ink):
    folder = tmp_path / "series"
    ink_files.write_dicom(folder, BLOB)
    file = folder / "slice007.dcm"
    bits = lambda n: ink_files.dicom_element(0x28, 0x0100, "US", struct.pack("<H", n))
    file.write_bytes(file.read_bytes().replace(bits(16), bits(12)))
    result = ink("info", "--json", folder)
    assert any("1 of its 32 pictures have another size" in note for note in notes(result))
    assert "have 12 bits; expected 8, 16 or 32" in ink("info", file).error


def test_a_tilted_gantry_is_noted(tmp_path, ink):
    ink_files.write_dicom(tmp_path / "series", BLOB, step=(0, 1, 2))
    result = ink("info", "--json", tmp_path / "series")
    assert "its axes are not at right angles; they are taken as the nearest that are" in notes(result)
    assert json.loads(result.out)[0]["spacing"] == [1, 1, 2]


def test_private_sequences_of_an_unknown_type(tmp_path, ink):
    """They are written without types (PS3.5 6.2.2); and icons may be compressed."""
    folder = tmp_path / "series"
    ink_files.write_dicom(folder, BLOB)
    expected = ink("info", folder).out
    begin, end, unknown = struct.pack("<HHI", 0xFFFE, 0xE000, 0xFFFFFFFF), struct.pack("<HHI", 0xFFFE, 0xE0DD, 0), 0xFFFFFFFF
    end_of_item = struct.pack("<HHI", 0xFFFE, 0xE00D, 0)
    implicit = ink_files.dicom_element(0x2005, 0x1010, "LO", "of a scanner's ", implicit=True)
    private = struct.pack("<HH2s2xI", 0x2005, 0x140F, b"UN", unknown) + begin + implicit + end_of_item + end
    fragment = struct.pack("<HHI", 0xFFFE, 0xE000, 4) + b"icon"
    pixels = struct.pack("<HH2s2xI", 0x7FE0, 0x0010, b"OB", unknown) + fragment + end
    icon = struct.pack("<HH2s2xI", 0x0088, 0x0200, b"SQ", unknown) + begin + pixels + end_of_item + end
    main = struct.pack("<HH", 0x7FE0, 0x0010)
    for file in folder.iterdir():
        data = file.read_bytes()
        at = data.rindex(main)
        file.write_bytes(data[:at] + icon + private + data[at:])
    assert ink("info", folder).out == expected


def test_planes_of_a_dose(tmp_path, ink):
    """RT doses say how far each is from the first, and their scale, in elements of their own."""
    ink_files.write_dicom(tmp_path / "series", BLOB[:1])
    data = (tmp_path / "series" / "slice000.dcm").read_bytes()
    head = data[: data.rindex(struct.pack("<HH", 0x7FE0, 0x0010))]
    offsets = "\\".join(f"{2.5 * z:g}" for z in range(len(BLOB)))
    body = ink_files.dicom_element(0x28, 0x0008, "IS", str(len(BLOB)))
    body += ink_files.dicom_element(0x3004, 0x000C, "DS", offsets) + ink_files.dicom_element(0x3004, 0x000E, "DS", "0.5")
    (tmp_path / "dose").write_bytes(head + body + ink_files.dicom_element(0x7FE0, 0x0010, "OW", BLOB.astype("<u2").tobytes()))
    found = json.loads(ink("info", "--json", tmp_path / "dose").out)[0]
    assert found["spacing"] == [1, 1, 2.5] and found["range"] == [BLOB.min() / 2, BLOB.max() / 2]
    # Downwards.
    data = (tmp_path / "dose").read_bytes()
    downwards = "\\".join(f"{-2.5 * z:g}" for z in range(len(BLOB)))
    old, new = (ink_files.dicom_element(0x3004, 0x000C, "DS", text) for text in (offsets, downwards))
    (tmp_path / "dose").write_bytes(data.replace(old, new))
    found = json.loads(ink("info", "--json", tmp_path / "dose").out)[0]
    assert found["spacing"] == [1, 1, 2.5] and found["origin"] == [0, 0, -2.5 * (len(BLOB) - 1)]
