# SPDX-License-Identifier: BSD-3-Clause
"""Machine parts, drawn with defaults: lines on their edges and nowhere else, faces of one tone, however the file has their normals."""

import numpy as np
import pytest

import ink_files

pytestmark = pytest.mark.one_build

SIZE = "300x300"
VIEW = ("--view", "front", "--azimuth", "30", "--elevation", "25", "--parallel")

CORNERS = np.array([(x, y, z) for x in (0, 1.6) for y in (0, 1) for z in (0, 0.7)])
QUADS = np.array([(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)])


def unit_square(cells):
    """Coordinates u and v of points, and triangles, of cells x cells squares."""
    u, v = [axis.ravel() for axis in np.meshgrid(*[np.linspace(0, 1, cells + 1)] * 2, indexing="ij")]
    grid = np.arange((cells + 1) ** 2).reshape(cells + 1, cells + 1)
    a, b, c, d = grid[:-1, :-1].ravel(), grid[1:, :-1].ravel(), grid[1:, 1:].ravel(), grid[:-1, 1:].ravel()
    return u, v, np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])


def box(cells, welded, noise=0.0):
    """Points and triangles of a box, its faces of cells x cells squares."""
    u, v, square = unit_square(cells)
    points, triangles = [], []
    for p, q, r, s in CORNERS[QUADS]:
        triangles.append(square + len(points) * len(u))
        points.append(np.outer((1 - u) * (1 - v), p) + np.outer(u * (1 - v), q) + np.outer(u * v, r) + np.outer((1 - u) * v, s))
    points, triangles = np.concatenate(points), np.concatenate(triangles)
    if welded:
        keys, inverse = np.unique(np.round(points, 9), axis=0, return_inverse=True)
        points, triangles = keys, inverse.reshape(-1)[triangles]
    return points + noise * np.random.default_rng(1).standard_normal(points.shape), triangles


def write(path, points, triangles, normals=None):
    """As text, without normals unless they are given."""
    rows = points if normals is None else np.concatenate([points, normals], 1)
    names = ["x", "y", "z"] + ([] if normals is None else ["nx", "ny", "nz"])
    head = ["ply", "format ascii 1.0", f"element vertex {len(rows)}", *[f"property float {name}" for name in names],
            f"element face {len(triangles)}", "property list uchar int vertex_indices", "end_header"]
    body = [" ".join(f"{x:.7g}" for x in row) for row in rows] + [f"3 {a} {b} {c}" for a, b, c in triangles]
    path.write_text("\n".join(head + body) + "\n")
    return path


def mean_normals(points):
    """Those that a modeler exports of a box with few points: the means over edges."""
    outward = np.sign(points - CORNERS.mean(axis=0))
    return outward / np.linalg.norm(outward, axis=1, keepdims=True)


@pytest.fixture(scope="module", params=["coarse", "fine", "loose", "noisy", "means"])
def part(request, tmp_path_factory):
    points, triangles = box({"fine": 24, "noisy": 24}.get(request.param, 1), request.param != "loose",
                            0.0015 if request.param == "noisy" else 0.0)
    normals = mean_normals(points) if request.param == "means" else None
    return write(tmp_path_factory.mktemp("part") / f"{request.param}.ply", points, triangles, normals)


def ink_of(image):
    return 1 - image[..., :3].mean(axis=2) / 255


def widened(mask, pixels):
    rows, columns = mask.shape
    padded = np.pad(mask, pixels)
    return np.any([padded[y:y + rows, x:x + columns] for y in range(2 * pixels + 1) for x in range(2 * pixels + 1)], axis=0)


@pytest.fixture(scope="module")
def edges(tmp_path_factory, ink):
    """Where a perfect box has its edges."""
    folder = tmp_path_factory.mktemp("edges")
    file = write(folder / "box.ply", *box(1, True))
    result = ink("render", file, "--style", "contours", "--size", SIZE, "--quiet", "-o", folder / "edges.png", *VIEW)
    assert result.code == 0, result
    return ink_of(ink_files.read_png(folder / "edges.png")) > 0.2


def test_lines_are_where_the_edges_are(part, picture, edges):
    """No arcs across faces, and no gaps in the edges, which splatting lines alone leave dashed."""
    inked = ink_of(picture(part, "--style", "splatting-lines", *VIEW, size=SIZE))
    near = widened(edges, 4)
    noise = 0.01 if part.stem == "noisy" else 0.0
    assert inked[~near].sum() <= noise * inked.sum()
    assert (edges & ~widened(inked > 0.2, 4)).sum() <= 0.01 * edges.sum()


def test_borders_are_lines(picture, tmp_path):
    """Those of a sheet that bends away from the viewer a little, but no hole of a scan; and none if they are not wanted."""
    cells = 80
    u, v, triangles = unit_square(cells)
    x, z = 2 * u - 1, 2 * v - 1
    hole = len(triangles) // 4 + cells // 2
    file = write(tmp_path / "sheet.ply", np.stack([x, 0.1 * x * x, z], 1), np.delete(triangles, hole, axis=0))
    view = ("--style", "splatting-lines", "--view", "front", "--up", "z", "--parallel", "--zoom", "0.8")
    inked = ink_of(picture(file, *view, size=SIZE)) > 0.1
    rows, columns = np.nonzero(inked)
    sheet = (slice(rows.min(), rows.max() + 1), slice(columns.min(), columns.max() + 1))
    border = inked[sheet].copy()
    assert 180 < min(border.shape) <= max(border.shape) < 260
    border[4:-4, 4:-4] = False
    assert border.sum() == inked.sum(), "nothing within, where the hole is"
    for side in (border[:4], border[-4:], border[:, :4].T, border[:, -4:].T):
        assert side.any(axis=0).all()
    # An outline of what is drawn is left.
    assert not (ink_of(picture(file, *view, "--no-sharp-edges", "--as-published", size=SIZE)) > 0.1).any()


@pytest.fixture(scope="module")
def faces(edges):
    """The inside of each visible face: pixels that edges surround."""
    free = ~widened(edges, 4)
    labels = np.zeros(free.shape, int)
    count = 0
    for start in zip(*np.nonzero(free)):
        if labels[start]:
            continue
        count += 1
        stack = [start]
        labels[start] = count
        while stack:
            y, x = stack.pop()
            for ny, nx in ((y + 1, x), (y - 1, x), (y, x + 1), (y, x - 1)):
                if 0 <= ny < free.shape[0] and 0 <= nx < free.shape[1] and free[ny, nx] and not labels[ny, nx]:
                    labels[ny, nx] = count
                    stack.append((ny, nx))
    return [labels == label for label in range(1, count + 1) if label != labels[0, 0]]


@pytest.mark.parametrize("style", ["line-art", "stipple", "illustration"])
def test_faces_have_one_tone(part, picture, faces, style):
    """No triangle stays white: all quarters of a face are as gray as it is."""
    inked = ink_of(picture(part, "--style", style, *VIEW, size=SIZE))
    assert len(faces) == 3
    for face in faces:
        rows, columns = np.nonzero(face)
        whole = inked[face].mean()
        assert whole > 0.03
        for low in (rows < np.median(rows), rows >= np.median(rows)):
            for left in (columns < np.median(columns), columns >= np.median(columns)):
                quarter = inked[rows[low & left], columns[low & left]]
                if len(quarter) > 800:
                    assert abs(quarter.mean() - whole) < 0.3 * whole, (style, part.stem)
