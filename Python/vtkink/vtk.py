# SPDX-License-Identifier: BSD-3-Clause
"""All of the VTK that vtkink works with: this module is that VTK's own, ``cvista.all`` or ``vtkmodules.all``."""

import sys

from . import _vtk_module

sys.modules[__name__] = _vtk_module("all")
