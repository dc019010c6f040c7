# SPDX-License-Identifier: BSD-3-Clause
"""Phantoms with the histograms of real scans, for what is chosen automatically: iso-values, parts, the frame.

Each function returns a Scan: a phantom and its surfaces by name, with the values on both sides. An iso-value shows a surface
well if it lies well between the two.
"""

from typing import NamedTuple

import numpy as np
import phantoms
from phantoms import SIDE, Phantom, ellipsoid

AIR = -1000.0


class Scan(NamedTuple):
    phantom: Phantom
    surfaces: dict  #: values outside and inside of each surface, by name


def _scan(surfaces, grid, outside, dtype, noise, seed, named, change=None):
    values = phantoms.blurred(surfaces, grid) + np.float32(outside)
    if change:
        values = change(values)
    values = phantoms.as_scanned(values, dtype, noise, seed)
    return Scan(Phantom(values, grid, next(iter(named.values()))), named)


def _positions(grid):
    """x, y and z of the voxels in shares of SIDE, to be broadcast against each other."""
    axes = [o + s * np.arange(n) for n, s, o in zip(*grid)]
    return np.meshgrid(*(axis / SIDE for axis in reversed(axes)), indexing="ij", sparse=True)[::-1]


def _headrest(step):
    """A cradle behind the head, far thinner than it, which touches nothing."""
    distances = phantoms.Distances(1 / 128, half=0.49)

    def distance(x, y, z):
        bowl = abs(np.sqrt(x * x + (y - 0.02) ** 2) - 0.445) - 0.012
        return np.max(np.broadcast_arrays(bowl, 0.24 - y, abs(z + 0.06) - 0.24), axis=0)

    distances.unite(distance)
    return distances.surface(step)


def head_ct(n=96, slice_distance=1, noise=15.0, seed=0, headrest=True):
    """A head in Hounsfield units, int16: air, fat under the skin, muscle, skull, brain, ventricles, sinuses, headrest."""
    center = np.array([0, -0.02, 0.02])

    def part(radii, outside, inside, offset=(0, 0, 0)):
        return ellipsoid(center + offset, radii, inside - outside)

    surfaces = [
        part((0.32, 0.40, 0.42), AIR, -100),
        part((0.30, 0.38, 0.40), -100, 50),
        part((0.275, 0.345, 0.365), 50, 1100),
        part((0.235, 0.305, 0.325), 1100, 35),
        part((0.05, 0.1, 0.06), 35, 8, (-0.06, 0.02, 0.05)),
        part((0.05, 0.1, 0.06), 35, 8, (0.06, 0.02, 0.05)),
        # Sinuses, within the skull's wall, and the throat, in the muscle below it.
        part((0.035, 0.014, 0.03), 1100, AIR, (0.05, -0.324, 0.02)),
        part((0.035, 0.014, 0.03), 1100, AIR, (-0.05, -0.324, 0.02)),
    ]
    if headrest:
        surfaces.append(_headrest(-150 - AIR))
    named = {"skin": (AIR, -100.0), "skull": (50.0, 1100.0)}
    return _scan(surfaces, phantoms.cube(n, slice_distance), AIR, "int16", noise, seed, named)


def zeroed_mask(n=96, noise=4.0, seed=0):
    """A magnetic resonance scan, uint8: an organ with a core in faint tissue, all zero out of a ball around it."""
    surfaces = [ellipsoid((0, 0, 0), (0.27, 0.22, 0.3), 90), ellipsoid((0.06, 0, 0.05), (0.1, 0.1, 0.12), 70)]
    grid = phantoms.cube(n)
    x, y, z = _positions(grid)
    kept = x * x + y * y + z * z < 0.42**2
    scan = _scan(surfaces, grid, 45, "uint8", noise, seed, {"organ": (45.0, 135.0), "core": (135.0, 205.0)})
    scan.phantom.values[~kept] = 0
    return scan


def two_materials(n=96, noise=5.0, seed=0):
    """uint8: a body with a denser core."""
    surfaces = [ellipsoid((0, 0, 0), (0.36, 0.3, 0.4), 80), ellipsoid((0.05, 0, 0.05), (0.2, 0.18, 0.2), 100)]
    named = {"body": (20.0, 100.0), "core": (100.0, 200.0)}
    return _scan(surfaces, phantoms.cube(n), 20, "uint8", noise, seed, named)


def three_materials(n=96, noise=5.0, seed=0):
    """uint8: a body, an organ in it, and bones in that."""
    surfaces = [
        ellipsoid((0, 0, 0), (0.4, 0.32, 0.42), 60),
        ellipsoid((0.02, 0, 0.02), (0.3, 0.22, 0.3), 70),
        ellipsoid((-0.08, 0, 0.02), (0.09, 0.1, 0.2), 80),
        ellipsoid((0.14, 0, 0.02), (0.07, 0.08, 0.16), 80),
    ]
    named = {"body": (15.0, 75.0), "organ": (75.0, 145.0), "bones": (145.0, 225.0)}
    return _scan(surfaces, phantoms.cube(n), 15, "uint8", noise, seed, named)


def fragment(n=96, noise=4.0, seed=0):
    """int16: a body, and a piece of metal in it of a thousandth of its volume and five times its value."""
    surfaces = [ellipsoid((0, 0, 0), (0.36, 0.3, 0.4), 500), ellipsoid((0.2, -0.05, 0.1), (0.033, 0.033, 0.033), 2000)]
    named = {"body": (0.0, 500.0), "metal": (500.0, 2500.0)}
    return _scan(surfaces, phantoms.cube(n), 0, "int16", 5 * noise, seed, named)


def floaters(n=96, noise=4.0, seed=0, count=60):
    """uint8: a body, and specks around it of a few voxels each."""
    place = np.random.default_rng(seed)
    directions = place.normal(size=(count, 3))
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    radius = 1.7 / n
    surfaces = [ellipsoid((0, 0, 0), (0.3, 0.25, 0.3), 120)]
    surfaces += [ellipsoid(0.42 * d, (radius,) * 3, 120, 12, 24) for d in directions]
    return _scan(surfaces, phantoms.cube(n), 30, "uint8", noise, seed, {"body": (30.0, 150.0)})


def cut(n=96, noise=4.0, seed=0):
    """uint8: a body with a hollow that leaves the volume below and on the viewer's right."""
    surfaces = [ellipsoid((0.2, 0, -0.3), (0.5, 0.33, 0.55), 120), ellipsoid((0.2, 0, -0.3), (0.38, 0.22, 0.42), -120)]
    return _scan(surfaces, phantoms.cube(n), 30, "uint8", noise, seed, {"body": (30.0, 150.0)})


def simulation(dimensions=(64, 33, 32), seed=3):
    """float32: a smooth quantity in a small box, with no step anywhere, as of a fluid in turns."""
    x, y, z = (np.linspace(0, 2 * np.pi * n / 32, n) for n in dimensions)
    z, y, x = np.meshgrid(z, y, x, indexing="ij", sparse=True)
    values = np.zeros(dimensions[::-1])
    place = np.random.default_rng(seed)
    for _ in range(24):
        wave = place.integers(-3, 4, 3) * 0.5
        values += place.normal() * np.cos(wave[0] * x + wave[1] * y + wave[2] * z + place.uniform(0, 2 * np.pi))
    spacing = (SIDE / max(dimensions),) * 3
    grid = phantoms.Grid(dimensions, spacing, tuple(-s * (n - 1) / 2 for s, n in zip(spacing, dimensions)))
    values = values.astype(np.float32)
    return Scan(Phantom(values, grid, (float(values.min()), float(values.max()))), {})


SCANS = {
    function.__name__: function
    for function in (head_ct, zeroed_mask, two_materials, three_materials, fragment, floaters, cut, simulation)
}
