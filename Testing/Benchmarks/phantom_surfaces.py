# SPDX-License-Identifier: BSD-3-Clause
"""Known surfaces that phantoms.py makes volumes of: a knot, a tree of vessels, nested shells, two materials, scanned meshes."""

import pathlib

import numpy as np
from phantoms import SIDE, Distances, ellipsoid, grid_triangles, outward
from vtkink import numpy_support, read


def knot(grid, rows=1500, columns=96):
    """A torus knot that winds twice and thrice around."""
    t = np.linspace(0, 2 * np.pi, rows, endpoint=False)
    ring, wave, radius = 0.265, 0.125, 0.055

    def curve(t):
        # The ring lies across the view.
        r = ring + wave * np.cos(3 * t)
        return np.stack([r * np.cos(2 * t), wave * np.sin(3 * t), r * np.sin(2 * t)], axis=1)

    e = 1e-4
    along = curve(t + e) - curve(t - e)
    bend = curve(t + e) - 2 * curve(t) + curve(t - e)
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    side = np.cross(along, bend)
    side /= np.linalg.norm(side, axis=1, keepdims=True)
    across = np.cross(side, along)
    a = 2 * np.pi * np.arange(columns) / columns
    normals = across[:, None] * np.cos(a)[:, None] + side[:, None] * np.sin(a)[:, None]
    points = SIDE * (curve(t)[:, None] + radius * normals)
    return [outward(points.reshape(-1, 3), grid_triangles(rows, columns, closed=True), 1.0, normals.reshape(-1, 3))]


#: Of vessels at the branches, from the trunk to the tips, in voxels.
VESSEL_DIAMETERS = (6.0, 4.6, 3.5, 2.6, 1.0)
_VESSEL_LENGTHS = (0.26, 0.23, 0.19, 0.15)


def _vessels(start, direction, across, generation):
    """All vessels from one on: start, end and generation."""
    end = start + _VESSEL_LENGTHS[generation] * direction
    found = [(start, end, generation)]
    if generation + 1 < len(_VESSEL_LENGTHS):
        angle = np.radians(38 - 2 * generation)
        for sign in (-1, 1):
            turned = np.cos(angle) * direction + sign * np.sin(angle) * across
            # The next branches spread across these.
            beside = np.cross(direction, across)
            found += _vessels(end, turned, np.cos(0.6) * beside + np.sin(0.6) * np.cross(beside, turned), generation + 1)
    return found


def vessels(grid):
    """A tree of tubes that taper from 6 voxels to 1."""
    voxel = min(grid.spacing) / SIDE
    distances = Distances(voxel)
    for a, b, generation in _vessels(np.array([0, 0, -0.385]), np.array([0, 0, 1.0]), np.array([1.0, 0, 0]), 0):
        r0, r1 = (0.5 * voxel * d for d in VESSEL_DIAMETERS[generation : generation + 2])

        def distance(x, y, z, a=a, b=b, r0=r0, r1=r1):
            d = b - a
            t = np.clip(((x - a[0]) * d[0] + (y - a[1]) * d[1] + (z - a[2]) * d[2]) / (d @ d), 0, 1)
            p = (x - a[0] - t * d[0], y - a[1] - t * d[1], z - a[2] - t * d[2])
            return np.sqrt(p[0] ** 2 + p[1] ** 2 + p[2] ** 2) - (r0 + t * (r1 - r0))

        margin = r0 + voxel
        distances.unite(distance, np.minimum(a, b) - margin, np.maximum(a, b) + margin)
    return [distances.surface(1.0)]


def _cut_sphere(radius, quarter):
    """A sphere without the eighth where x > 0 > y and z > 0.

    :param quarter: how many edges a quarter of a circle has
    :returns: points; triangles, counterclockwise as seen from outside; and three lists of indices of points along the rim, from
        the pole down to y < 0, on to x > 0, and back up
    """
    rows, columns = 2 * quarter, 4 * quarter
    # Without the poles, which come last.
    latitude = np.pi / 2 - np.pi * np.arange(1, rows)[:, None] / rows
    longitude = 2 * np.pi * np.arange(columns) / columns
    x, y, z = np.cos(latitude) * np.cos(longitude), np.cos(latitude) * np.sin(longitude), np.sin(latitude) + 0 * longitude
    points = np.concatenate([np.stack([x, y, z], axis=2).reshape(-1, 3), [[0, 0, 1], [0, 0, -1]]])
    top, bottom, here = len(points) - 2, len(points) - 1, np.arange(columns)
    there, last = (here + 1) % columns, len(points) - 2 - columns
    triangles = np.concatenate(
        [
            grid_triangles(rows - 1, columns, closed=False)[:, ::-1],
            np.stack([np.full(columns, top), here, there], axis=1),
            np.stack([last + here, np.full(columns, bottom), last + there], axis=1),
        ]
    )
    middles = points[triangles].mean(axis=1)
    triangles = triangles[~((middles[:, 0] > 0) & (middles[:, 1] < 0) & (middles[:, 2] > 0))]
    down = np.concatenate([[top], columns * np.arange(quarter) + 3 * quarter])
    on = columns * (quarter - 1) + np.arange(3 * quarter, 4 * quarter + 1) % columns
    up = np.concatenate([columns * np.arange(quarter)[::-1], [top]])
    used, triangles = np.unique(triangles, return_inverse=True)
    return radius * points[used], triangles.reshape(-1, 3), [np.searchsorted(used, rim) for rim in (down, on, up)]


def shells(grid, thickness=2.0, quarter=72):
    """Three balls in each other, hollow, of so many voxels, without the eighth that faces the viewer's right and top: exact, with
    sharp edges around the hole."""
    half = 0.5 * thickness * min(grid.spacing) / SIDE
    points, triangles, count = [], [], 0
    for radius in (0.41, 0.3, 0.19):
        outer, facing, rims = _cut_sphere(radius + half, quarter)
        inner, _, _ = _cut_sphere(radius - half, quarter)
        points += [outer, inner]
        triangles += [count + facing, count + len(outer) + facing[:, ::-1]]
        for rim in rims:
            a, b = count + rim[:-1], count + rim[1:]
            c, d = a + len(outer), b + len(outer)
            triangles += [np.stack([a, b, c], axis=1), np.stack([b, d, c], axis=1)]
        count += len(outer) + len(inner)
    return [outward(SIDE * np.concatenate(points), np.concatenate(triangles), 1.0)]


def two_materials(grid):
    """A ball of a soft material that touches a denser one and a smaller soft one."""
    balls = (((-0.14, 0.0, -0.08), 0.27), ((0.2, -0.08, 0.1), 0.19), ((-0.06, -0.1, 0.27), 0.13))
    distances = Distances(min(grid.spacing) / SIDE)
    for center, radius in balls:
        distances.unite(
            lambda x, y, z, c=center, r=radius: np.sqrt((x - c[0]) ** 2 + (y - c[1]) ** 2 + (z - c[2]) ** 2) - r
        )
    center, radius = balls[1]
    return [distances.surface(0.5), ellipsoid(center, (radius,) * 3, 0.5)]


def _close_holes(points, triangles):
    """Adds to each hole a point in its middle, and triangles to that."""
    there = np.concatenate([triangles[:, pair] for pair in ([0, 1], [1, 2], [2, 0])])
    keys, opposite = there[:, 0] * len(points) + there[:, 1], there[:, 1] * len(points) + there[:, 0]
    rim = there[~np.isin(opposite, keys)]
    hole = np.arange(len(points))
    while (hole[rim[:, 0]] != hole[rim[:, 1]]).any():
        np.minimum.at(hole, rim[:, 0], hole[rim[:, 1]])
        np.minimum.at(hole, rim[:, 1], hole[rim[:, 0]])
    holes, index = np.unique(hole[rim[:, 0]], return_inverse=True)
    middles = [points[rim[index == i, 0]].mean(axis=0) for i in range(len(holes))]
    caps = np.column_stack([rim[:, ::-1], len(points) + index])
    return np.concatenate([points, np.reshape(middles, (-1, 3))]), np.concatenate([triangles, caps])


def scanned(path, axes, signs):
    """The mesh of a file, turned so that z is up, its holes closed, as large as the cube allows.

    :param axes: the file's that become x, y and z, with a sign each
    """
    data = read(path)
    points = numpy_support.vtk_to_numpy(data.GetPoints().GetData()).astype(np.float64)[:, axes] * signs
    triangles = numpy_support.vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3).astype(np.int64)
    points, triangles = _close_holes(points, triangles)
    used = points[triangles]
    low, high = used.min(axis=(0, 1)), used.max(axis=(0, 1))
    points = (points - (low + high) / 2) * (0.86 * SIDE / (high - low).max())
    return [outward(points, triangles, 1.0)]


#: Known surfaces by name: functions that take the grid, of which some need the size of a voxel.
SURFACES = {"knot": knot, "vessels": vessels, "shells": shells, "two materials": two_materials}


def with_scans(folder):
    """SURFACES with the bunny and the horse, where they lie in a folder as bunny.ply and horse.ply."""
    turned = {"bunny": ([0, 2, 1], [1, -1, 1]), "horse": ([1, 0, 2], [-1, 1, 1])}
    scans = {}
    for name, (axes, signs) in turned.items():
        path = pathlib.Path(folder or "") / f"{name}.ply"
        if folder and path.exists():
            scans[name] = lambda grid, path=path, axes=axes, signs=signs: scanned(path, axes, signs)
    return {**scans, **SURFACES}
