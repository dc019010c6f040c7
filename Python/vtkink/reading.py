# SPDX-License-Identifier: BSD-3-Clause
"""Data objects from what people have: files, arrays, algorithms."""

import os

from . import _vtk_module
from .vtkInkIOMesh import vtkInkMeshReader
from .vtkInkIOVolume import vtkInkVolumeReader


def _vdb_reader(path):
    try:
        from .vtkInkIOVDB import vtkInkVDBReader
    except ModuleNotFoundError:
        raise ValueError(f"cannot read {path!r}: this vtkink was built without OpenVDB") from None
    return vtkInkVDBReader()


def _reader(path):
    """The one that ``ink`` takes, too."""
    name = path.lower()
    volumes, meshes = (kind.GetFileExtensions().split() for kind in (vtkInkVolumeReader, vtkInkMeshReader))
    if os.path.isdir(path):
        return vtkInkVolumeReader()
    if name.endswith(".vdb"):
        return _vdb_reader(path)
    # Legacy VTK files of both have one suffix.
    if name.endswith(".vtk") and vtkInkMeshReader().CanReadFile(path):
        return vtkInkMeshReader()
    # DICOM files have any name.
    if name.endswith(tuple(volumes)) or vtkInkVolumeReader.IsDicomFile(path):
        return vtkInkVolumeReader()
    if name.endswith(tuple(meshes)):
        return vtkInkMeshReader()
    raise ValueError(f"{path!r}: expected a file of {' '.join(dict.fromkeys(volumes + meshes))} .vdb or a folder of DICOM or TIFF files")


class Errors:
    """The errors of an algorithm, which VTK then does not print."""

    CallDataType = "string0"

    def __init__(self, algorithm):
        self.texts = []
        for one in (algorithm, algorithm.GetExecutive()):
            one.AddObserver("ErrorEvent", self)

    def __call__(self, caller, event, text):
        # Without file, line, class and address before it.
        self.texts.append(text.partition("): ")[2].strip() or text.strip())


def reader_of(path):
    """What reads a file, or a folder of DICOM or TIFF files, and has not done so yet.

    :raises FileNotFoundError: if there is no such file
    :raises ValueError: for a file of a kind that is not read
    """
    path = os.fsdecode(path)
    if not os.path.exists(path):
        raise FileNotFoundError(f"{path!r}: no such file")
    reader = _reader(path)
    reader.SetFileName(path)
    return reader


def read(path):
    """The data object in a file, or in a folder of DICOM or TIFF files, as ``ink`` reads it: a volume in DICOM's axes and with
    its values rescaled where the file says so, or a mesh or points.

    :raises FileNotFoundError: if there is no such file
    :raises ValueError: for a file that cannot be read, with what was found and what was expected
    """
    reader = reader_of(path)
    errors = Errors(reader)
    reader.Update()
    if errors.texts:
        raise ValueError(errors.texts[0])
    data = reader.GetOutputDataObject(0)
    if data is None or data.GetNumberOfElements(0) == 0:
        raise ValueError(f"{os.fsdecode(path)!r}: there is nothing in it that {reader.GetClassName()} can read")
    return data


def _values(array):
    """An array as VTK can have it, in one piece: numbers in this machine's byte order, masked ones as NaN."""
    import numpy

    values = numpy.ma.asanyarray(array)
    if values.dtype.kind not in "biuf":
        raise ValueError(f"expected an array of integers or real numbers, found one of {values.dtype.name}")
    if numpy.ma.is_masked(values):
        # Single precision where that has all of the values.
        values = values.astype(numpy.result_type(values.dtype, numpy.float32)).filled(numpy.nan)
    elif values.dtype == bool:
        values = values.astype(numpy.uint8)
    size = values.dtype.itemsize
    if values.dtype.kind == "f" and size not in (4, 8):
        values = values.astype(numpy.float32 if size < 4 else numpy.float64)
    return numpy.ascontiguousarray(values, values.dtype.newbyteorder("="))


def _image(array):
    """Of an array of three axes, z, y and x: VTK's x runs fastest. It shares the array's memory where it can."""
    numpy_support = _vtk_module("util.numpy_support")
    if array.ndim != 3:
        raise ValueError(f"expected an array of three axes, z, y and x, found one of {array.ndim}")
    image = _vtk_module("vtkCommonDataModel").vtkImageData()
    image.SetDimensions(*array.shape[::-1])
    image.GetPointData().SetScalars(numpy_support.numpy_to_vtk(_values(array).reshape(-1)))
    return image


def data_object(data):
    """A data object as it is, or that of a path, an array or an algorithm."""
    if isinstance(data, (str, os.PathLike)):
        return read(data)
    if hasattr(data, "GetOutputDataObject"):
        data.Update()
        return data.GetOutputDataObject(0)
    if hasattr(data, "IsA"):
        return data
    if hasattr(data, "ndim"):
        return _image(data)
    raise TypeError(f"expected a VTK data object, an algorithm, a path or a NumPy array, found {type(data).__name__}")
