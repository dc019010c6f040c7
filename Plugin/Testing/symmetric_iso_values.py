# SPDX-License-Identifier: BSD-3-Clause
"""Prints the iso-values that a sampler starts with, on each process of its own, for TestParallel.py:

pvbatch --sym symmetric_iso_values.py INPUT_FOLDER"""

import sys

from paraview.simple import *

# One that only the first process has, and one that each has another part of.
for name in ("nii", "pvti"):
    volume = OpenDataFile(f"{sys.argv[1]}/volume.{name}")
    volume.UpdatePipeline()
    sampler = InkIsoSurfaceSampler(Input=volume)
    print(f"{name}: {list(sampler.Isosurfaces)}", flush=True)
