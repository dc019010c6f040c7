# SPDX-License-Identifier: BSD-3-Clause
"""Volumes of which the truth is known: closed surfaces that become voxels as a scanner would see them.

A phantom is a list of closed meshes, each with the step that values take where one enters it. A voxel's value is the mean
of the values around it, weighted by a Gaussian point spread; then come noise and rounding.

    surfaces = phantom_surfaces.SURFACES["knot"](phantoms.cube(96))
    phantom = phantoms.voxelize(surfaces, phantoms.cube(96), "uint8", noise=0.05)
    vtkink.draw(phantoms.image(phantom), "splatting-lines", "knot.png")

Lengths are millimeters; all surfaces lie in the cube of SIDE around the origin, with z up and their front towards -y, where
`ink render` looks from. Arrays of values are indexed [z, y, x].
"""

import math
from typing import NamedTuple

import numpy as np
from vtkink import numpy_support, vtk

SIDE = 100.0
#: Standard deviation of the point spread, in voxels of each axis.
POINT_SPREAD = 0.7
#: The value around a known surface and the step that it is at most inside, for each type of voxels.
LEVELS = {"uint8": (40.0, 160.0), "int16": (-1000.0, 2000.0), "float32": (0.0, 1.0)}

_RAYS = 4  #: a voxel and axis
_FARTHEST = 4.0  #: of the point spread, in standard deviations
_CHUNK = 1 << 20


class Grid(NamedTuple):
    dimensions: tuple  #: voxels along x, y and z
    spacing: tuple
    origin: tuple  #: the center of the first voxel


class Surface(NamedTuple):
    """A closed mesh, its triangles counterclockwise as seen from outside."""

    points: np.ndarray  #: (n, 3)
    triangles: np.ndarray  #: (m, 3), indices of points
    step: float  #: how much larger values are inside
    normals: np.ndarray | None = None  #: (n, 3), unit; None where they are to be computed of the triangles


class Phantom(NamedTuple):
    values: np.ndarray
    grid: Grid
    boundary: tuple  #: the values on both sides of the outermost surface; the surface lies at their mean


def cube(n, slice_distance=1):
    """The cube of all phantoms: n x n x n voxels, or fewer slices with a distance of so many voxels."""
    slices = round(n / slice_distance)
    spacing = (SIDE / n, SIDE / n, SIDE / slices)
    return Grid((n, n, slices), spacing, tuple(-SIDE / 2 + s / 2 for s in spacing))


# ------------------------------------------------------------------------------------------------------------- voxels

_TABLE = np.linspace(-6, 6, 12001)
_TABLE_CDF = np.array([0.5 * (1 + math.erf(x / math.sqrt(2))) for x in _TABLE])


def normal_cdf(x):
    """The normal distribution's cumulative function, within 1e-7."""
    return np.interp(x, _TABLE, _TABLE_CDF)


def _kernel(n, pad, sigma):
    """How much each ray, from pad voxels before the first voxel to pad beyond the last, counts in each of n voxels."""
    edges = np.arange((n + 2 * pad) * _RAYS + 1) / _RAYS - pad - 0.5
    return np.diff(normal_cdf((edges - np.arange(n)[:, None]) / sigma), axis=1).astype(np.float32)


def _cross(a, b):
    return a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]


def _jitter(rays):
    """How far rays lie from the middles of their cells: evenly spread along rows and columns, so that walls along these
    have no steps (the R2 sequence)."""
    column, row = rays.T
    a, b = 0.7548776662466927, 0.5698402909980532
    # Not the same along the diagonal, on which edges can lie.
    return np.stack([row * a + column * b, column * a + row * b + 0.1234567], axis=1) % 1 - 0.5


def _crossings(surface, grid, pad):
    """Where rays along z enter (+step) and leave (-step) a surface: column and row of the ray, z in voxels, step."""
    voxels = (surface.points - np.array(grid.origin)) / np.array(grid.spacing)
    corners = ((voxels[:, :2] + pad + 0.5) * _RAYS - 0.5)[surface.triangles]
    ends = (np.array(grid.dimensions[:2]) + 2 * pad) * _RAYS - 1
    low = np.clip(np.ceil(corners.min(axis=1) - 0.5), 0, ends + 1).astype(int)
    high = np.clip(np.floor(corners.max(axis=1) + 0.5), -1, ends).astype(int)
    sides = np.maximum(high - low + 1, 0)
    counts = sides.prod(axis=1)
    found = []
    chunks = np.searchsorted(np.cumsum(counts), np.arange(_CHUNK, counts.sum() + _CHUNK, _CHUNK), side="left") + 1
    for first, last in zip([0, *chunks], chunks):
        some = counts[first:last]
        triangle = first + np.repeat(np.arange(len(some)), some)
        index = np.arange(len(triangle)) - np.repeat(np.cumsum(some) - some, some)
        ray = low[triangle] + np.stack([index % sides[triangle, 0], index // sides[triangle, 0]], axis=1)
        a, b, c = (corners[triangle, i] for i in range(3))
        area, along = _cross(b - a, c - a), ray + _jitter(ray) - a
        with np.errstate(divide="ignore", invalid="ignore"):
            u, v = _cross(along, c - a) / area, _cross(b - a, along) / area
            inside = (u >= 0) & (v >= 0) & (u + v <= 1)
        u, v, ray, area = u[inside], v[inside], ray[inside], area[inside]
        za, zb, zc = voxels[surface.triangles[triangle[inside]], 2].T
        z = za + u * (zb - za) + v * (zc - za)
        found.append(np.column_stack([ray, z, -np.sign(area) * surface.step]))
    return np.concatenate(found)


def _check_closed(crossings):
    _, ray = np.unique(crossings[:, 0] + 1e6 * crossings[:, 1], return_inverse=True)
    left = np.count_nonzero(abs(np.bincount(ray, crossings[:, 3])) > 1e-6 * abs(crossings[:, 3]).max(initial=0))
    if left:
        raise ValueError(f"expected closed meshes, found {left} rays that enter one more or less often than they leave it")


def blurred(surfaces, grid, point_spread=POINT_SPREAD):
    """Values on a grid, 0 outside of all surfaces, float32. Exact along z; rays are _RAYS a voxel along x and y.

    :raises ValueError: for a mesh that is not closed
    """
    nx, ny, nz = grid.dimensions
    reach = math.ceil(_FARTHEST * point_spread)
    crossings = np.concatenate([_crossings(surface, grid, reach) for surface in surfaces])
    _check_closed(crossings)
    crossings = crossings[np.argsort(crossings[:, 1], kind="stable")]
    columns, rows = _kernel(nx, reach, point_spread), _kernel(ny, reach, point_spread)
    ends = np.searchsorted(crossings[:, 1], np.arange(rows.shape[1] + 1))
    values = np.zeros((nz, ny, nx), np.float32)
    for row in np.flatnonzero(np.diff(ends)):
        ray, _, z, step = crossings[ends[row] : ends[row + 1]].T
        z = np.clip(z, -reach - 2, nz + reach + 2)
        slices = np.floor(z).astype(int)[:, None] + np.arange(-reach, reach + 2)
        rise = normal_cdf((slices - z[:, None]) / point_spread)
        rise[:, -1] = 1
        change = np.diff(rise, axis=1, prepend=0) * step[:, None]
        bins = np.clip(slices, 0, nz) * columns.shape[1] + ray[:, None].astype(int)
        changes = np.bincount(bins.ravel(), change.ravel(), (nz + 1) * columns.shape[1]).reshape(nz + 1, -1)[:nz]
        line = np.cumsum(changes, axis=0).astype(np.float32) @ columns.T
        near = np.flatnonzero(rows[:, row] > 1e-7)
        values[:, near] += rows[near, row][:, None] * line[:, None]
    return values


def as_scanned(values, dtype, noise=0.0, seed=0):
    """Values with Gaussian noise of a standard deviation, rounded and clamped to a type."""
    if noise:
        values = values + np.random.default_rng(seed).normal(0, noise, values.shape).astype(np.float32)
    if np.issubdtype(dtype, np.integer):
        values = np.clip(np.rint(values), np.iinfo(dtype).min, np.iinfo(dtype).max)
    return values.astype(dtype)


def scan(surfaces, values, grid, dtype, noise=0.0, seed=0):
    """The phantom of blurred values in the levels of a type, with noise as a share of the step."""
    low, step = LEVELS[dtype]
    values = as_scanned(low + step * values, dtype, noise * step, seed)
    return Phantom(values, grid, (low, low + surfaces[0].step * step))


def voxelize(surfaces, grid, dtype="uint8", noise=0.0, seed=0, point_spread=POINT_SPREAD):
    """The phantom of surfaces, of which the first is the outermost."""
    return scan(surfaces, blurred(surfaces, grid, point_spread), grid, dtype, noise, seed)


def image(phantom):
    """vtkImageData, which shares the phantom's memory."""
    data = vtk.vtkImageData()
    data.SetDimensions(*phantom.grid.dimensions)
    data.SetSpacing(*phantom.grid.spacing)
    data.SetOrigin(*phantom.grid.origin)
    data.GetPointData().SetScalars(numpy_support.numpy_to_vtk(phantom.values.reshape(-1)))
    return data


# ------------------------------------------------------------------------------------------------------------- meshes


def mesh(surface):
    """vtkPolyData, with normals where the surface has them."""
    data = vtk.vtkPolyData()
    points = vtk.vtkPoints()
    points.SetData(numpy_support.numpy_to_vtk(surface.points.astype(np.float32), deep=True))
    data.SetPoints(points)
    cells = vtk.vtkCellArray()
    ids = np.ascontiguousarray(surface.triangles, np.int64)
    cells.SetData(
        numpy_support.numpy_to_vtkIdTypeArray(np.arange(0, 3 * len(ids) + 1, 3, np.int64), deep=True),
        numpy_support.numpy_to_vtkIdTypeArray(ids.reshape(-1), deep=True),
    )
    data.SetPolys(cells)
    if surface.normals is not None:
        normals = numpy_support.numpy_to_vtk(surface.normals.astype(np.float32), deep=True)
        normals.SetName("Normals")
        data.GetPointData().SetNormals(normals)
    return data


def outward(points, triangles, step, normals=None):
    """The surface of triangles that all face one way, whichever it is."""
    a, b, c = (points[triangles[:, i]] for i in range(3))
    inward = np.einsum("ij,ij->", a, np.cross(b, c)) < 0
    return Surface(points, triangles[:, ::-1] if inward else triangles, step, normals)


def _of_poly_data(data, step):
    triangles = numpy_support.vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    normals = data.GetPointData().GetNormals()
    return outward(
        numpy_support.vtk_to_numpy(data.GetPoints().GetData()).astype(np.float64),
        triangles,
        step,
        None if normals is None else numpy_support.vtk_to_numpy(normals),
    )


def grid_triangles(rows, columns, closed):
    """Triangles between the points of a grid that wraps along its columns, and along its rows where it is closed."""
    i, j = np.meshgrid(np.arange(rows if closed else rows - 1), np.arange(columns), indexing="ij")
    a, b = i * columns + j, i * columns + (j + 1) % columns
    c, d = (i + 1) % rows * columns + j, (i + 1) % rows * columns + (j + 1) % columns
    return np.concatenate([np.stack([a, b, d], axis=2), np.stack([a, d, c], axis=2)]).reshape(-1, 3)


def ellipsoid(center, radii, step, rows=90, columns=180):
    """Lengths in shares of SIDE."""
    latitude = np.pi * (np.arange(rows) + 0.5) / rows
    longitude = 2 * np.pi * np.arange(columns) / columns
    rings = np.stack(
        [
            np.outer(np.sin(latitude), np.cos(longitude)),
            np.outer(np.sin(latitude), np.sin(longitude)),
            np.outer(np.cos(latitude), np.ones(columns)),
        ],
        axis=2,
    ).reshape(-1, 3)
    directions = np.concatenate([rings, [[0, 0, 1], [0, 0, -1]]])
    top = np.stack([np.full(columns, len(rings)), np.arange(columns), (np.arange(columns) + 1) % columns], axis=1)
    bottom = np.stack([np.full(columns, len(rings) + 1), *(len(rings) - columns + top[:, 1:].T)], axis=1)[:, [0, 2, 1]]
    triangles = np.concatenate([grid_triangles(rows, columns, closed=False), top, bottom])
    # Those of the grid face inwards where the caps face outwards.
    triangles[: -2 * columns] = triangles[: -2 * columns, ::-1]
    normals = directions / np.array(radii)
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    return outward(SIDE * (np.array(center) + directions * np.array(radii)), triangles, step, normals)


def iso_surface(values, grid, iso_value, step=1.0):
    """The mesh that marching cubes make of values, with the normals of their gradients."""
    contour = vtk.vtkFlyingEdges3D()
    contour.SetInputData(image(Phantom(values, grid, ())))
    contour.SetValue(0, iso_value)
    contour.ComputeScalarsOff()
    contour.Update()
    found = _of_poly_data(contour.GetOutput(), step)
    a, b, c = (found.points[found.triangles[:, i]] for i in range(3))
    facing = np.einsum("ij,ij->", np.cross(b - a, c - a), found.normals[found.triangles[:, 0]])
    return found._replace(normals=found.normals * np.sign(facing))


class Distances:
    """Signed distances on a fine grid, from which a mesh is made: negative inside, in shares of SIDE."""

    def __init__(self, voxel, half=0.47):
        """:param voxel: the smallest of the volume that the mesh is for; :param half: the grid's half side"""
        n = 2 * math.ceil(half / min(voxel / 2, 1 / 256)) + 1
        self.axis = np.linspace(-half, half, n, dtype=np.float32)
        self.values = np.full((n, n, n), 1, np.float32)

    def unite(self, distance, low=(-1, -1, -1), high=(1, 1, 1)):
        """Adds what is inside where distance(x, y, z) < 0; it is beyond the grid's spacing out of low and high."""
        (x0, y0, z0), (x1, y1, z1) = np.searchsorted(self.axis, low), np.searchsorted(self.axis, high)
        x, y = self.axis[None, x0:x1], self.axis[y0:y1, None]
        for z in range(z0, z1):
            part = self.values[z, y0:y1, x0:x1]
            np.minimum(part, distance(x, y, self.axis[z]), out=part)

    def surface(self, step):
        spacing, origin = SIDE * float(self.axis[1] - self.axis[0]), SIDE * float(self.axis[0])
        return iso_surface(self.values, Grid(self.values.shape, (spacing,) * 3, (origin,) * 3), 0.0, step)
