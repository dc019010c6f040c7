# SPDX-License-Identifier: BSD-3-Clause
"""vtkInkSurfaceSampler against vtkPoissonDiskSampler: processor time in one process, interleaved, and how good the samples are.

    . Utilities/env.sh paraview && $INK_PYTHON Testing/Benchmarks/surface_sampling.py [MESH.ply ...]

A VTK that lacks vtkPoissonDiskSampler (the one from PyPI does) measures vtkInk alone. vtkPoissonDiskSampler picks from the
points that it is given and has no default for these: here the mesh's own, and dense, random samplings of the mesh with 10, 40
and 200 points for each that fits, which cost it nothing. Both get the same radius. Ratio: the least distance between samples against that of a hexagonal lattice of as many.
"""

import math
import sys
import time

from vtkink import vtk, vtkInkSurfaceSampler

REPETITIONS = 5


def area_of(mesh):
    mass = vtk.vtkMassProperties()
    mass.SetInputData(mesh)
    mass.Update()
    return mass.GetSurfaceArea()


def sphere():
    source = vtk.vtkSphereSource()
    source.SetThetaResolution(200)
    source.SetPhiResolution(200)
    source.Update()
    return source.GetOutput()


def read(path):
    reader = vtk.vtkPLYReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def ink_sampler(mesh, **properties):
    sampler = vtkInkSurfaceSampler()
    sampler.SetInputData(mesh)
    for name, value in properties.items():
        getattr(sampler, f"Set{name}")(value)
    return sampler


def poisson_sampler(candidates, radius):
    sampler = vtk.vtkPoissonDiskSampler()
    sampler.SetInputData(candidates)
    sampler.SetRadius(radius)
    return sampler


def seconds(algorithm):
    algorithm.Modified()
    begin = time.process_time()
    algorithm.Update()
    return time.process_time() - begin


def ratio(samples, area, radius):
    return radius / math.sqrt(2 * area / (math.sqrt(3) * samples.GetNumberOfPoints()))


def main():
    vtk.vtkSMPTools.Initialize(1)
    meshes = [("sphere", sphere())] + [(path.rsplit("/", 1)[-1], read(path)) for path in sys.argv[1:]]
    print("| mesh | samples | sampler | ratio | ms | us a sample |\n|---|---|---|---|---|---|")
    for name, mesh in meshes:
        area = area_of(mesh)
        white = ink_sampler(mesh, Method=0, NumberOfSamples=1000000, ComputePriority=0)
        print(f"| {name} | 1000000 | vtkInk, white noise | | {1e3 * min(seconds(white) for _ in range(REPETITIONS)):.0f} | |")
        for count in (10000, 50000):
            radius = math.sqrt(0.69 * area / count)
            runs = [
                (f"vtkInk, CoverageSlack {gap}", ink_sampler(mesh, Amount=1, SampleRadius=radius, CoverageSlack=gap, ComputePriority=0))
                for gap in (0.06, 0.3)
            ]
            if hasattr(vtk, "vtkPoissonDiskSampler"):
                runs.append(("vtkPoissonDiskSampler of the mesh's points", poisson_sampler(mesh, radius)))
                for many in (10, 40, 200):
                    candidates = ink_sampler(mesh, Method=0, NumberOfSamples=many * count, ComputePriority=0)
                    candidates.Update()
                    title = f"vtkPoissonDiskSampler of {many} each"
                    runs.append((title, poisson_sampler(candidates.GetOutput(), radius)))
            times = [[] for _ in runs]
            for repetition in range(REPETITIONS):
                for i, (title, algorithm) in enumerate(runs):
                    # One that takes seconds need not be repeated.
                    if repetition == 0 or times[i][0] < 0.5:
                        times[i].append(seconds(algorithm))
            for (title, algorithm), mine in zip(runs, times):
                samples = algorithm.GetOutput()
                n = samples.GetNumberOfPoints()
                best = min(mine)
                print(f"| {name} | {n} | {title} | {ratio(samples, area, radius):.3f} | {1e3 * best:.0f} | {1e6 * best / n:.1f} |")


if __name__ == "__main__":
    main()
