# SPDX-License-Identifier: BSD-3-Clause
"""How good pictures of volumes are, compared with pictures of the surfaces that the volumes were made of.

    . Utilities/env.sh headless
    $INK_PYTHON Testing/Benchmarks/picture_quality.py --quick              # some cases, in minutes
    $INK_PYTHON Testing/Benchmarks/picture_quality.py --quarter            # a fourth of them, in an hour or so
    $INK_PYTHON Testing/Benchmarks/picture_quality.py --output today.csv   # all of them
    $INK_PYTHON Testing/Benchmarks/picture_quality.py --page               # writes Documentation/picture-quality.md

Each known surface (phantom_surfaces.py) becomes volumes of different sizes, types and noise. Each volume is drawn with a
style's defaults, the iso-value included, or with what --with says, and compared (picture_metrics.py) with the surface's mesh
drawn by the same style with the same camera. The bunny and the horse of Stanford and Georgia Tech are taken from a folder
(--meshes), where they lie in one.
"""

import argparse
import itertools
import json
import multiprocessing
import os
import pathlib
import re
import sys
import time
from typing import NamedTuple

import numpy as np
import phantom_surfaces
import phantoms
import picture_metrics
import picture_quality_page
import vtkink
from picture_quality_results import NOISES, SIZES, SLICE_DISTANCES, TYPES, Case, Result, write_csv
from vtkink import numpy_support, vtk

SIZE = 1024
SUPERSAMPLING = 2
MARGIN = 0.05
VIEW_ANGLE = 30.0
#: From the front, from the right and from above.
DIRECTION = np.array([-np.sin(np.radians(30)), np.cos(np.radians(30)), -np.tan(np.radians(15))])

QUICK = (
    Case("bunny", 96, 1, "int16", 0.0),
    Case("bunny", 96, 1, "uint8", 0.05),
    Case("bunny", 48, 1, "uint8", 0.02),
    Case("horse", 96, 1, "int16", 0.02),
    Case("horse", 192, 3, "uint8", 0.0),
    Case("knot", 48, 1, "uint8", 0.0),
    Case("knot", 96, 1, "int16", 0.1),
    Case("vessels", 96, 1, "uint8", 0.05),
    Case("vessels", 192, 1, "int16", 0.02),
    Case("shells", 96, 1, "uint8", 0.02),
    Case("shells", 96, 3, "int16", 0.05),
    Case("two materials", 96, 3, "int16", 0.05),
    Case("two materials", 48, 1, "uint8", 0.1),
)
STYLES = ("splatting-lines", "stipple", "illustration")


def all_cases(surfaces):
    return [Case(*values) for values in itertools.product(surfaces, SIZES, SLICE_DISTANCES, TYPES, NOISES)]


def quarter_of_cases(surfaces):
    """Two cases of each surface and grid; of all of them each type and each noise is the same share."""
    grids = list(itertools.product(SIZES, SLICE_DISTANCES))
    return [
        Case(surface, *grid, TYPES[(i + j + k) % 2], NOISES[(i + j + 2 * k) % 4])
        for i, surface in enumerate(surfaces)
        for j, grid in enumerate(grids)
        for k in range(2)
    ]


# ----------------------------------------------------------------------------------------------------------- pictures


def fit_camera(points):
    """The camera that sees all points, in the middle of the picture and with a margin, as `ink render` does."""
    direction = DIRECTION / np.linalg.norm(DIRECTION)
    right = np.cross(direction, [0, 0, 1])
    right /= np.linalg.norm(right)
    up = np.cross(right, direction)
    center = (points.min(axis=0) + points.max(axis=0)) / 2
    tangent = (1 - MARGIN) * np.tan(np.radians(VIEW_ANGLE / 2))
    across, depth = np.abs((points - center) @ np.stack([right, up]).T), (points - center) @ direction
    distance = float((across / tangent - depth[:, None]).max())
    camera = vtk.vtkCamera()
    camera.SetViewAngle(VIEW_ANGLE)
    camera.SetFocalPoint(*center)
    camera.SetPosition(*(center - distance * direction))
    camera.SetViewUp(*up)
    return camera


def _darkness(renderer, supersampling):
    """Renders, and returns how dark pixels are, 0 to 1, from the bottom row on."""
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(SIZE * supersampling, SIZE * supersampling)
    window.AddRenderer(renderer)
    renderer.ResetCameraClippingRange()
    window.Render()
    pixels = vtk.vtkUnsignedCharArray()
    end = SIZE * supersampling - 1
    window.GetPixelData(0, 0, end, end, 0, pixels, 0)
    window.Finalize()
    shape = (SIZE, supersampling, SIZE, supersampling, 3)
    # Green stands for gray.
    return 1 - np.frombuffer(memoryview(pixels), np.uint8).reshape(shape)[..., 1].mean(axis=(1, 3)) / 255


def draw(data, style, camera, **parameters):
    """The darkness of a picture as vtkink.draw writes it, but with a camera; and the style's notes."""
    actor = vtkink.draw(data, style, size=(SIZE, SIZE), **parameters)
    made = actor.style
    renderer = vtk.vtkRenderer()
    background = [0.0, 0.0, 0.0]
    made.GetBackgroundColor(background)
    renderer.SetBackground(background)
    if made.GetLight() is not None:
        renderer.RemoveAllLights()
        renderer.AddLight(made.GetLight())
    renderer.SetActiveCamera(camera)
    renderer.AddActor(actor)
    made.SetPixelScale(SUPERSAMPLING)
    darkness = _darkness(renderer, SUPERSAMPLING)
    return darkness, [made.GetNote(index) for index in range(made.GetNumberOfNotes())]


def find_silhouette(mesh, camera):
    """Where the mesh is, an array of bool."""
    mapper, actor, renderer = vtk.vtkPolyDataMapper(), vtk.vtkActor(), vtk.vtkRenderer()
    mapper.SetInputData(mesh)
    mapper.ScalarVisibilityOff()
    actor.SetMapper(mapper)
    actor.GetProperty().LightingOff()
    actor.GetProperty().SetColor(0, 0, 0)
    renderer.SetBackground(1, 1, 1)
    renderer.SetActiveCamera(camera)
    renderer.AddActor(actor)
    return _darkness(renderer, 1) > 0.5


def write_pair(path, reference, picture):
    """A PNG file: the mesh's picture on the left, the volume's on the right."""
    pair = np.concatenate([reference, np.ones((SIZE, 4)), picture], axis=1)
    image = vtk.vtkImageData()
    image.SetDimensions(pair.shape[1], pair.shape[0], 1)
    values = np.rint(255 * (1 - pair)).astype(np.uint8)
    image.GetPointData().SetScalars(numpy_support.numpy_to_vtk(values.reshape(-1), deep=True))
    writer = vtk.vtkPNGWriter()
    writer.SetInputData(image)
    writer.SetFileName(str(path))
    writer.Write()


# ------------------------------------------------------------------------------------------------------------ measure


def _iso_error(notes, boundary):
    """How far the first iso-value that is named lies from the middle of the boundary."""
    named = re.search(r"iso-value ([-+.\de]+)", " ".join(notes))
    outside, inside = boundary
    return (float(named[1]) - (outside + inside) / 2) / (inside - outside) if named else ""


def find_ceiling(style, mesh, references):
    """What the grid lets a picture reach: the figures of the mesh of the values before noise and rounding."""
    picture, _ = draw(mesh, style, references.camera)
    if style == "splatting-lines":
        return {"f_ceiling": picture_metrics.compare_lines(picture, references.pictures[style]).f}
    found = picture_metrics.compare_stipples(picture, references.pictures[style], references.silhouette)
    return {"bare_ceiling": found.bare, "tone_ceiling": found.tone, "outside_ceiling": found.outside}


def measure(case, style, phantom, references, ceiling, pictures=None, parameters=()):
    """
    :param ceiling: of find_ceiling
    :param parameters: of the volume's picture, pairs
    :param pictures: a folder, for a PNG file of both pictures
    """
    reference = references.pictures[style]
    try:
        picture, notes = draw(phantoms.image(phantom), style, references.camera, **dict(parameters))
    except ValueError as nothing:
        print(f"{case}, {style}: {nothing}", file=sys.stderr)
        picture, notes = np.zeros((SIZE, SIZE)), []
    if pictures:
        name = f"{case}, {style}".replace(" ", "-").replace(",", "").replace(":", "").replace("%", "")
        write_pair(pathlib.Path(pictures) / f"{name}.png", reference, picture)
    found = {"iso_error": _iso_error(notes, phantom.boundary), **ceiling}
    if style == "splatting-lines":
        found.update(picture_metrics.compare_lines(picture, reference)._asdict())
    else:
        found.update(picture_metrics.compare_stipples(picture, reference, references.silhouette)._asdict())
    return Result(*case, style, **found)


class References(NamedTuple):
    """What pictures of a surface's volumes are compared with."""

    points: np.ndarray  #: of the mesh that it is
    camera: object
    silhouette: np.ndarray
    pictures: dict  #: by style: the mesh's, as darkness


def draw_references(surface, styles):
    mesh, camera = phantoms.mesh(surface), fit_camera(surface.points)
    pictures = {style: draw(mesh, style, camera)[0] for style in styles}
    return References(surface.points, camera, find_silhouette(mesh, camera), pictures)


class Group(NamedTuple):
    """Cases of one surface, those with the same grid one after the other."""

    cases: list
    styles: tuple
    meshes: str
    pictures: str
    parameters: tuple = ()  #: of volumes' pictures, pairs
    ceilings: bool = True  #: whether to measure what the grid lets pictures reach, too

    def __call__(self):
        results, of = [], None
        for (name, *grid), cases in itertools.groupby(self.cases, key=lambda case: case[:3]):
            grid = phantoms.cube(*grid)
            surfaces = phantom_surfaces.with_scans(self.meshes)[name](grid)
            # Most meshes are the same for any grid, and then so are their pictures.
            if of is None or not np.array_equal(of.points, surfaces[0].points):
                of = draw_references(surfaces[0], self.styles)
            values = phantoms.blurred(surfaces, grid)
            ceilings = dict.fromkeys(self.styles, {})
            if self.ceilings:
                sharp = phantoms.mesh(phantoms.iso_surface(values, grid, surfaces[0].step / 2))
                ceilings = {style: find_ceiling(style, sharp, of) for style in self.styles}
            for case in cases:
                phantom = phantoms.scan(surfaces, values, grid, case.type, case.noise)
                for style in self.styles:
                    results.append(measure(case, style, phantom, of, ceilings[style], self.pictures, self.parameters))
        return results


def _run(group):
    return group()


def run(cases, styles, meshes, pictures, parameters, jobs):
    groups = {}
    for case in sorted(cases, key=lambda case: case[:3]):
        groups.setdefault(case.surface, []).append(case)
    # The longest first, so that no process is left alone with it.
    groups = [Group(group, styles, meshes, pictures, parameters, not parameters) for group in groups.values()]
    groups.sort(key=lambda group: -sum(case.size for case in group.cases))
    results = []
    start = time.monotonic()
    with multiprocessing.get_context("spawn").Pool(jobs) as pool:
        for done in pool.imap_unordered(_run, groups):
            results += done
            print(f"{len(results)} of {len(cases) * len(styles)}, {time.monotonic() - start:.0f} s", file=sys.stderr)
    order = {case: index for index, case in enumerate(cases)}
    return sorted(results, key=lambda result: (styles.index(result.style), order[Case(*result[:5])]))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true", help="some cases, in minutes")
    parser.add_argument("--quarter", action="store_true", help="a fourth of them, those of the page")
    parser.add_argument("--cases", metavar="REGEX", default="", help="those whose name it finds, as '^knot 96 .*uint8'")
    parser.add_argument("--styles", default="", help="with commas; all by default")
    parser.add_argument("--meshes", metavar="FOLDER", help="with bunny.ply and horse.ply")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--pictures", metavar="FOLDER", help="to write pairs of pictures to: the mesh's and the volume's")
    parser.add_argument("--output", metavar="CSV", help="to write all figures to")
    parser.add_argument(
        "--with", dest="parameters", metavar="NAME=VALUE", action="append", default=[], help="draw volumes so, as smoothing=0"
    )
    parser.add_argument("--page", action="store_true", help="write Documentation/picture-quality.md of the files beside this one")
    arguments = parser.parse_args()
    if arguments.page:
        picture_quality_page.write()
        return
    surfaces = phantom_surfaces.with_scans(arguments.meshes)
    cases = quarter_of_cases(surfaces) if arguments.quarter else all_cases(surfaces)
    if arguments.quick:
        cases = [case for case in QUICK if case.surface in surfaces]
    cases = [case for case in cases if re.search(arguments.cases, str(case))]
    wanted = arguments.styles.split(",") if arguments.styles else STYLES
    styles = tuple(style for style in wanted if style in vtkink.styles())
    if not cases or not styles:
        parser.error("no case or no style of that name")
    if arguments.pictures:
        os.makedirs(arguments.pictures, exist_ok=True)
    parameters = tuple((name, json.loads(value)) for name, value in (text.split("=") for text in arguments.parameters))
    results = run(cases, styles, arguments.meshes, arguments.pictures, parameters, arguments.jobs)
    if arguments.output:
        write_csv(results, arguments.output)
    print(picture_quality_page.cases_table(results))


if __name__ == "__main__":
    main()
