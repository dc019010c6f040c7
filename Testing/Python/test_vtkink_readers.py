# SPDX-License-Identifier: BSD-3-Clause
"""vtkInk's readers as a Python programmer meets them: each format, parts of volumes, and what cannot be read."""

import numpy as np
import pytest

import ink_files
from vtk_messages import Messages

vtkink = pytest.importorskip("vtkink")
vtk = vtkink.vtk
numpy_support = vtkink.numpy_support

BLOB = ink_files.blob((20, 18, 16))


def scaled_slices(path):
    """As PET has them."""
    z = np.arange(len(BLOB))[:, None, None]
    ink_files.write_dicom(path, (BLOB + z) * 2 ** (z % 3), scale=lambda z: (0.5 ** (z % 3), -z))


VOLUMES = {
    "v.nii": lambda p: ink_files.write_nifti(p, BLOB),
    "v.nii.gz": lambda p: ink_files.write_nifti(p, BLOB),
    "v.nrrd": lambda p: ink_files.write_nrrd(p, BLOB),
    "v.mha": lambda p: ink_files.write_metaimage(p, BLOB),
    "v.mrc": lambda p: ink_files.write_mrc(p, BLOB.astype("int16")),
    "v.map.gz": lambda p: ink_files.write_mrc(p, BLOB.astype("int16"), order=">"),
    "v.vti": lambda p: ink_files.write_vti(p, BLOB),
    "cells.vti": lambda p: ink_files.write_vti(p, BLOB, where="CellData"),
    "cells.vtk": lambda p: ink_files.write_legacy(p, BLOB, where="CELL_DATA"),
    "v.vtk": lambda p: ink_files.write_legacy(p, BLOB),
    "series": lambda p: ink_files.write_dicom(p, BLOB),
    "scaled": scaled_slices,
}


def values_of(image):
    """As an array [z, y, x]."""
    return numpy_support.vtk_to_numpy(image.GetPointData().GetScalars()).reshape(image.GetDimensions()[::-1])


def reader_of(path):
    reader = vtkink.vtkInkVolumeReader()
    reader.SetFileName(str(path))
    return reader


@pytest.mark.parametrize("name", VOLUMES)
def test_volumes_whole_and_in_parts(tmp_path, name):
    path = tmp_path / name
    VOLUMES[name](path)
    reader = reader_of(path)
    assert reader.CanReadFile(str(path))
    reader.UpdateExtent((3, 9, 0, 17, 4, 5))
    assert np.array_equal(values_of(reader.GetOutput()), BLOB[4:6, :, 3:10])
    reader.UpdateWholeExtent()
    assert np.array_equal(values_of(reader.GetOutput()), BLOB)
    assert reader.GetNumberOfFileComponents() == 1


def test_raw_volumes(tmp_path):
    path = tmp_path / "v.raw"
    path.write_bytes(BLOB.astype(">i2").tobytes())
    reader = reader_of(path)
    reader.RawOn()
    reader.SetRawDimensions(16, 18, 20)
    reader.SetRawScalarType(vtk.VTK_SHORT)
    reader.SetRawBigEndian(True)
    reader.SetSpacing(1, 2, 3)
    reader.Update()
    assert np.array_equal(values_of(reader.GetOutput()), BLOB)
    assert reader.GetOutput().GetSpacing() == (1, 2, 3)


@pytest.mark.parametrize("name", ["v.nrrd", "v.nii.gz", "series"])
def test_pieces_of_a_surface_are_those_of_the_whole(tmp_path, name):
    """What streams asks the reader for parts, whether the file is compressed or not."""
    VOLUMES[name](tmp_path / name)
    reader = reader_of(tmp_path / name)
    sampler = vtkink.vtkInkIsoSurfaceSampler()
    sampler.SetInputConnection(reader.GetOutputPort())
    sampler.SetValue(0, 100)

    def points(piece, pieces):
        sampler.UpdatePiece(piece, pieces, 0)
        return [tuple(sampler.GetOutput().GetPoint(n)) for n in range(sampler.GetOutput().GetNumberOfPoints())]

    whole = sorted(points(0, 1))
    assert whole
    parts = [points(piece, 3) for piece in range(3)]
    assert all(parts)
    assert sorted(sum(parts, [])) == whole


MESH = ink_files.sphere_mesh(20, 30)
MESHES = {
    "m.ply": lambda p: ink_files.write_ply(p, MESH),
    "m.obj": lambda p: ink_files.write_obj(p, MESH),
    "m.off": lambda p: ink_files.write_off(p, MESH),
    "m.stl": lambda p: ink_files.write_stl(p, MESH),
    "m.vtp": lambda p: ink_files.write_vtp(p, MESH),
    "m.vtu": lambda p: ink_files.write_vtu(p, MESH),
    "m.gii": lambda p: ink_files.write_gifti(p, MESH),
}


@pytest.mark.parametrize("name", MESHES)
def test_meshes(tmp_path, name):
    path = tmp_path / name
    MESHES[name](path)
    reader = vtkink.vtkInkMeshReader()
    assert reader.CanReadFile(str(path))
    reader.SetFileName(str(path))
    reader.Update()
    mesh = reader.GetOutput()
    assert (mesh.GetNumberOfPoints(), mesh.GetNumberOfPolys()) == (len(MESH[0]), len(MESH[2]))
    assert name[2:].upper() in reader.GetFormat().upper()


@pytest.mark.parametrize("reader", [vtkink.vtkInkVolumeReader(), vtkink.vtkInkMeshReader()], ids=["volume", "mesh"])
def test_what_cannot_be_read_is_one_error_and_an_empty_output(reader, tmp_path):
    messages = Messages(reader, reader.GetExecutive())
    for name in reader.GetFileExtensions().split():
        # Alone, as those of a pair are one.
        path = tmp_path / name[1:] / f"words{name}"
        path.parent.mkdir()
        path.write_text("These are words.\n")
        messages.texts.clear()
        reader.SetFileName(str(path))
        reader.Update()
        assert len(messages.texts) == 1 and f"cannot read '{path}': " in messages.texts[0]
        assert reader.GetOutput().GetNumberOfPoints() == 0
        assert reader.GetErrorCode() != 0
