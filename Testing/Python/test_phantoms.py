# SPDX-License-Identifier: BSD-3-Clause
"""Volumes of known surfaces: what they say of the surfaces is true."""

import numpy as np
import pytest

pytestmark = pytest.mark.one_build

pytest.importorskip("vtkink")
import phantom_surfaces  # noqa: E402
import phantoms  # noqa: E402
import scan_phantoms  # noqa: E402

SIDE = phantoms.SIDE


@pytest.mark.parametrize("slices", [1, 3])
def test_a_volume_holds_as_much_as_its_surface(slices):
    radii = (0.31, 0.22, 0.27)
    grid = phantoms.cube(48, slices)
    values = phantoms.blurred([phantoms.ellipsoid((0.03, -0.02, 0.01), radii, 1.0)], grid)
    expected = 4 / 3 * np.pi * np.prod(radii) * SIDE**3
    assert values.sum(dtype=float) * np.prod(grid.spacing) == pytest.approx(expected, rel=1e-3)


@pytest.mark.parametrize("slices", [1, 3])
@pytest.mark.parametrize("axis", [0, 1, 2])
def test_a_boundary_is_as_wide_as_the_point_spread(axis, slices):
    """Across a face that is all but flat, values follow the normal distribution, from a place between voxels on."""
    radius = 0.4017
    grid = phantoms.cube(96, slices)
    values = phantoms.blurred([phantoms.ellipsoid((0, 0, 0), (radius,) * 3, 1.0, 180, 360)], grid)
    middle = [n // 2 for n in reversed(grid.dimensions)]
    index = tuple(slice(None) if 2 - i == axis else middle[i] for i in range(3))
    along = grid.origin[axis] + grid.spacing[axis] * np.arange(grid.dimensions[axis])
    others = np.array([grid.spacing[i] for i in range(3) if i != axis])
    # The mean of the sphere's depth within the point spread, beside the line of voxels.
    depth = sum((others / 2) ** 2 + (phantoms.POINT_SPREAD * others) ** 2) / (2 * radius * SIDE)
    distance = (radius * SIDE - depth - abs(along)) / grid.spacing[axis]
    expected = phantoms.normal_cdf(distance / phantoms.POINT_SPREAD)
    assert abs(values[index] - expected).max() < 0.015


def test_steps_add_up_inside_of_each_other():
    surfaces = [phantoms.ellipsoid((0, 0, 0), (r,) * 3, step) for r, step in ((0.4, 0.5), (0.3, 0.25), (0.2, -0.75))]
    line = phantoms.blurred(surfaces, phantoms.cube(48))[24, 24]
    at = lambda x: line[round((x + 0.5) * 48 - 0.5)]
    found = [at(x) for x in (-0.47, -0.35, -0.25, 0.0, 0.25, 0.35, 0.47)]
    assert found == pytest.approx([0, 0.5, 0.75, 0, 0.75, 0.5, 0], abs=0.003)


def test_a_surface_that_leaves_the_volume_is_cut():
    values = phantoms.blurred([phantoms.ellipsoid((0, 0, 0), (0.7, 0.9, 0.8), 1.0)], phantoms.cube(24))
    assert np.allclose(values[:, 12, 12], 1, atol=1e-6) and values[12, 0, 0] == pytest.approx(1, abs=1e-3)
    assert values[0, 0, 0] < 0.1


@pytest.mark.parametrize("name", phantom_surfaces.SURFACES)
@pytest.mark.parametrize("slices", [1, 3])
def test_known_surfaces_are_closed_and_fit(name, slices):
    grid = phantoms.cube(48, slices)
    surfaces = phantom_surfaces.SURFACES[name](grid)
    for surface in surfaces:
        edges = np.concatenate([surface.triangles[:, pair] for pair in ([0, 1], [1, 2], [2, 0])])
        there, back = edges[:, 0] * len(surface.points) + edges[:, 1], edges[:, 1] * len(surface.points) + edges[:, 0]
        assert np.array_equal(np.sort(there), np.sort(back)), "each edge has a triangle on both sides"
        assert abs(surface.points).max() < SIDE / 2 - 2 * min(grid.spacing)
        corners = surface.points[surface.triangles]
        faces = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        assert np.einsum("ij,ij->", corners[:, 0], faces) > 0, "it faces outwards"
        if surface.normals is not None:
            assert (np.einsum("ij,ij->i", faces, surface.normals[surface.triangles[:, 0]]) >= -1e-6).mean() > 0.99
    values = phantoms.blurred(surfaces, grid)
    assert values.min() > -1e-4 and 0.5 < values.max() < 1.0001


def test_an_open_mesh_is_refused():
    whole = phantoms.ellipsoid((0, 0, 0), (0.3,) * 3, 1.0)
    with pytest.raises(ValueError, match="expected closed meshes, found [0-9]+ rays"):
        phantoms.blurred([whole._replace(triangles=whole.triangles[1000:])], phantoms.cube(24))


def test_vessels_taper_from_six_voxels_to_one():
    """Where a line along z crosses the trunk at its foot, it is as wide at each size of the volume."""
    for n in (48, 96):
        points = phantom_surfaces.vessels(phantoms.cube(n))[0].points
        foot = points[abs(points[:, 2] + 0.38 * SIDE) < 0.6 * SIDE / n]
        assert np.ptp(foot[:, 0]) * n / SIDE == pytest.approx(phantom_surfaces.VESSEL_DIAMETERS[0], abs=0.3)


def test_shells_are_seven_eighths_of_hollow_balls():
    grid, half = phantoms.cube(64), 1 / 64
    values = phantoms.blurred(phantom_surfaces.shells(grid), grid)
    expected = sum(7 / 6 * np.pi * ((r + half) ** 3 - (r - half) ** 3) for r in (0.41, 0.3, 0.19))
    assert values.mean(dtype=float) == pytest.approx(expected, rel=2e-3)
    # Beyond the blur along its sides.
    hole = values[35:, :29, 35:]
    assert hole.max() < 0.01 < 0.5 < min(values[:29, 35:, :29].max(), values[35:, 35:, 35:].max(), values[:29, :29, 35:].max())


@pytest.mark.parametrize("dtype", ["uint8", "int16"])
def test_noise_is_a_share_of_the_step(dtype):
    surfaces = [phantoms.ellipsoid((0, 0, 0), (0.3,) * 3, 1.0)]
    clean, noisy, again, other = (
        phantoms.voxelize(surfaces, phantoms.cube(48), dtype, noise, seed).values.astype(float)
        for noise, seed in ((0, 0), (0.05, 1), (0.05, 1), (0.05, 2))
    )
    low, step = phantoms.LEVELS[dtype]
    assert np.std(noisy - clean) == pytest.approx(0.05 * step, rel=0.02)
    assert np.array_equal(noisy, again) and not np.array_equal(noisy, other)
    assert (clean.min(), clean.max()) == (low, low + step)


def test_values_stay_in_their_type():
    values = phantoms.as_scanned(np.array([[[-40.0, 3.5, 900.0]]], np.float32), "uint8")
    assert values.tolist() == [[[0, 4, 255]]] and values.dtype == np.uint8


def test_an_image_lies_where_the_surface_does():
    grid = phantoms.cube(24, 3)
    image = phantoms.image(phantoms.voxelize([phantoms.ellipsoid((0.1, 0, 0.2), (0.2,) * 3, 1.0)], grid))
    assert image.GetDimensions() == (24, 24, 8) and image.GetScalarTypeAsString() == "unsigned char"
    value = image.GetPointData().GetScalars().GetTuple1
    assert value(image.FindPoint(0.1 * SIDE, 0, 0.2 * SIDE)) > 180 > value(image.FindPoint(0.1 * SIDE, 0, -0.2 * SIDE)) + 130
    assert image.GetBounds() == pytest.approx(sum(((o, -o) for o in grid.origin), ()))


@pytest.mark.parametrize("name", scan_phantoms.SCANS)
def test_scans_have_the_values_that_they_name(name):
    """Each surface's value outside and inside, or what lies nearest to it with the noise, is the value of many voxels."""
    # The fragment would be blurred away in fewer voxels.
    scan = scan_phantoms.SCANS[name](**({} if name in ("simulation", "fragment") else {"n": 64}))
    values = scan.phantom.values
    assert np.isfinite(values).all()
    assert values.shape == scan.phantom.grid.dimensions[::-1]
    for outside, inside in scan.surfaces.values():
        width = 0.1 * abs(inside - outside)
        for level in (outside, inside):
            assert np.count_nonzero(abs(values - level) < width) > 5, (name, level)
