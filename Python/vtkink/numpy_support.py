# SPDX-License-Identifier: BSD-3-Clause
"""VTK's arrays as NumPy's and back: ``util.numpy_support`` of the VTK that vtkink works with."""

import sys

from . import _vtk_module

sys.modules[__name__] = _vtk_module("util.numpy_support")
