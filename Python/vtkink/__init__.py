# SPDX-License-Identifier: BSD-3-Clause
"""Pen-and-ink illustration of volumes, meshes and point clouds in VTK.

vtkInk's classes work with those of the VTK that they were built with, whatever its Python package is called;
``vtkink.vtk`` has all of them under one name, and ``vtkink.numpy_support`` turns its arrays into NumPy's and back::

    from vtkink import numpy_support, vtk, vtkInkIsoSurfaceSampler, vtkInkSplattingLinesMapper
    from vtkink.vtk import vtkActor

``draw`` draws a file, a data object or an array in one call, ``styles`` lists the styles and their parameters, and
``read`` reads a file as ``ink`` does::

    vtkink.draw("engine.nii.gz", style="stipple", preset="bone", sharpness=0.7, output="engine.png")

``help()`` of a class says what its properties do, their ranges and defaults.
"""

import importlib
import sys
import warnings

from ._build import VERSION as __version__, VTK_PACKAGE, VTK_VERSION


def _vtk_module(name):
    try:
        return importlib.import_module(f"{VTK_PACKAGE}.{name}")
    except ImportError as error:
        raise ImportError(
            f"vtkink {__version__} needs the Python package {VTK_PACKAGE} of VTK {VTK_VERSION} "
            f"on Python's path: {error}"
        ) from error


def _check_vtk_version():
    version = _vtk_module("vtkCommonCore").vtkVersion
    found = f"{version.GetVTKMajorVersion()}.{version.GetVTKMinorVersion()}"
    if found != VTK_VERSION:
        raise ImportError(f"vtkink {__version__} needs VTK {VTK_VERSION}; the package {VTK_PACKAGE} is VTK {found}")


def _warn_of_other_vtks():
    """Objects of two VTKs do not work together, and VTK does not say why it refuses them."""
    others = {name.rpartition(".")[0] for name in sys.modules if name.endswith(".vtkCommonCore")} - {VTK_PACKAGE, __name__}
    for other in sorted(others):
        warnings.warn(
            f"the VTK of the package {other} is loaded, too: vtkink {__version__} works with VTK {VTK_VERSION} of the "
            f"package {VTK_PACKAGE}, whose classes refuse the other's objects (TypeError: SetInputData argument 1). "
            f"Take VTK's classes from vtkink (from vtkink import vtk, numpy_support) instead of {other}; for PyVista "
            f"set PYVISTA_VTK_BACKEND={VTK_PACKAGE}",
            RuntimeWarning,
            stacklevel=3,
        )


# VTK comes first, so that vtkInk uses the libraries that VTK's own package loads, and with it the OpenGL classes
# that stand behind vtkRenderer and vtkRenderWindow.
_check_vtk_version()
_warn_of_other_vtks()
_vtk_module("vtkRenderingOpenGL2")

from .vtkInkFiltersContours import *
from .vtkInkFiltersCurvature import *
from .vtkInkFiltersFields import *
from .vtkInkFiltersSampling import *
from .vtkInkFiltersStrokes import *
from .vtkInkIOMesh import *
from .vtkInkIOPicture import *
from .vtkInkIOVolume import *

try:
    from .vtkInkIOVDB import *
except ModuleNotFoundError as error:
    # A build without OpenVDB has no such module; one that is there but cannot be loaded is an error.
    if error.name != f"{__name__}.vtkInkIOVDB":
        raise

from .vtkInkRenderingSplattingLines import *
from .vtkInkRenderingStipple import *
from .vtkInkRenderingStrokes import *
from .vtkInkStyles import *


from .drawing import draw, styles
from .reading import read


def __getattr__(name):
    # Only on demand: loading all of VTK takes a while, and NumPy may be missing.
    if name in ("vtk", "numpy_support"):
        return importlib.import_module(f"{__name__}.{name}")
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
