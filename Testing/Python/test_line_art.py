# SPDX-License-Identifier: BSD-3-Clause
"""Hatching with contours: its gray by the light, the same at any zoom, sliders, what is hidden; hard cases."""

import importlib
import pathlib
import subprocess
import sys

import numpy as np
import pytest

import ink_files
from style_scene import StyleScene

vtkink = pytest.importorskip("vtkink")
vtk = vtkink.vtk
numpy_support = importlib.import_module(f"{vtkink.VTK_PACKAGE}.util.numpy_support")

ROOT = pathlib.Path(__file__).resolve().parents[2]
SIZE = 300
# Light from where the viewer stands, and nothing but hatching by it.
FROM_VIEWER = {"light_direction": (0, 0), "silhouette_weight": 0, "diffuse_truncation": 0, "darkest_tone": 1, "contour_width": 0}


def surface(source):
    source.Update()
    return source.GetOutput()


def torus(radius=0.6, tube=0.3):
    function = vtk.vtkParametricTorus()
    function.SetRingRadius(radius)
    function.SetCrossSectionRadius(tube)
    source = vtk.vtkParametricFunctionSource()
    source.SetParametricFunction(function)
    source.SetUResolution(96)
    source.SetVResolution(48)
    source.SetWResolution(1)
    clean = vtk.vtkCleanPolyData()
    clean.SetInputConnection(source.GetOutputPort())
    return surface(clean)


def ball(cells=40, radius=0.8):
    """A distance from the middle, as an image of the cube of side 2, with iso-value 100 at a radius."""
    z, y, x = np.meshgrid(*[np.linspace(-1, 1, cells)] * 3, indexing="ij")
    image = vtk.vtkImageData()
    image.SetDimensions([cells] * 3)
    image.SetSpacing([2 / (cells - 1)] * 3)
    image.SetOrigin([-1] * 3)
    values = (100 * (1 + radius - np.sqrt(x * x + y * y + z * z))).astype("f4")
    image.GetPointData().SetScalars(numpy_support.numpy_to_vtk(values.ravel(), deep=True))
    return image


class Scene(StyleScene):
    def __init__(self, data, **parameters):
        usual = {} if "preset" in parameters else {"density": 0.3}
        super().__init__(vtkink.draw(data, "line-art", size=(SIZE, SIZE), **{**usual, **parameters}), SIZE)


def draw(data, direction=(0, 0, 1), scale=1.0, **parameters):
    return Scene(data, **parameters).draw(direction, scale)


def distances():
    """From the picture's middle, pixels."""
    y, x = np.mgrid[:SIZE, :SIZE] + 0.5 - SIZE / 2
    return np.hypot(x, y)


def test_the_gray_is_that_of_the_light():
    """A torus from above, lit from there: 1 - N.L on its tube."""
    drawn = draw(torus(), crosshatch=0, **FROM_VIEWER)
    across = np.abs(distances() * 2 / SIZE - 0.6) / 0.3
    expected = 1 - np.sqrt(np.clip(1 - across**2, 0, 1))
    for least, most in ((0.0, 0.3), (0.3, 0.5), (0.5, 0.7), (0.7, 0.9)):
        ring = (across >= least) & (across < most)
        assert drawn[ring].mean() == pytest.approx(expected[ring].mean(), abs=0.05), (least, most)
    assert drawn[across > 1.05].max() == 0


@pytest.mark.one_build
def test_the_gray_is_the_same_at_any_zoom():
    scene = Scene(torus(), **FROM_VIEWER)
    grays = []
    for scale in (2.0, 1.0, 0.5):
        drawn = scene.draw((0, 0, 1), scale)
        # What is in all pictures: the tube's inner side.
        radius = distances() * 2 * scale / SIZE
        grays.append(drawn[(radius > 0.33) & (radius < 0.48)].mean())
    assert max(grays) / min(grays) < 1.12, grays


def test_shade_and_light():
    """Lit from the upper left, a ball of voxels is white there and dark at the lower right."""
    drawn = draw(ball(), iso_values=100, light_direction=(-45, 45))
    y, x = np.mgrid[:SIZE, :SIZE] * 2 / SIZE - 1
    lit = np.hypot(x + 0.35, y - 0.5) < 0.15
    shaded = np.hypot(x - 0.4, y + 0.4) < 0.15
    assert drawn[lit].mean() < 0.02 and drawn[shaded].mean() > 0.4
    # The contour closes the outline, also where nothing is hatched.
    rim = np.abs(distances() * 2 / SIZE - 0.8) < 0.01
    angles = np.round(np.degrees(np.arctan2(y, x)[rim]) / 6)
    assert all(drawn[rim][angles == angle].max() > 0.5 for angle in np.unique(angles))


@pytest.mark.one_build
def test_sliders():
    data = torus()
    ink = lambda scene: scene.draw((0.3, 0.4, 1)).sum()
    scene = Scene(data, contour_width=0)

    def ink_with(name, value):
        """Of the same lines, which take longer than all pictures."""
        before = scene.style.GetParameter(name)
        assert scene.style.SetParameter(name, value)
        drawn = ink(scene)
        assert scene.style.SetParameter(name, before)
        return drawn

    usual = ink(scene)
    tones = [ink_with("Tone", tone) for tone in (0.2, 0.4, 0.6, 0.8)]
    assert all(a < b for a, b in zip(tones, tones[1:])), tones
    # What makes the tone changes, and not the tone.
    for name in ("Width", "Crosshatch"):
        for value in (0, 0.5) if name == "Width" else (0, 1):
            changed = ink_with(name, value)
            assert changed != usual and changed == pytest.approx(usual, rel=0.04), (name, value)
    assert ink(scene) == usual
    for density in (0.1, 0.5):
        assert ink(Scene(data, contour_width=0, density=density)) == pytest.approx(usual, rel=0.04), density
    shorter = [Scene(data, contour_width=0, length=length) for length in (100, 30)]
    assert ink(shorter[0]) == pytest.approx(usual, rel=0.04)
    strokes = [one.style.GetPiece(1).GetNumberOfCells() for one in (scene, *shorter)]
    assert strokes[0] < strokes[1] < strokes[2]
    # Lines are not traced for a family that no tone needs.
    families = [
        Scene(data, crosshatch=value).style.GetPiece(1).GetCellData().GetArray("LineFamily").GetRange()[1]
        for value in (0.0, 0.1, 0.5)
    ]
    assert families == [0, 0, 1]


def test_what_lies_behind_is_hidden():
    both = vtk.vtkAppendPolyData()
    both.AddInputData(torus())
    plane = vtk.vtkPlaneSource()
    plane.SetOrigin(-1, -1, 0.5)
    plane.SetPoint1(1, -1, 0.5)
    plane.SetPoint2(-1, 1, 0.5)
    plane.SetResolution(20, 20)
    both.AddInputData(surface(plane))
    both.Update()
    drawn = draw(both.GetOutput(), **FROM_VIEWER)
    assert drawn.max() == 0, "a lit plane that hides a torus"
    assert draw(both.GetOutput(), (0, 0, -1), **FROM_VIEWER).sum() > 1000


@pytest.mark.one_build
def test_presets_differ():
    data = torus()
    drawn = {name: draw(data, (0.3, 0.4, 1), preset=name, line_spacing=8) for name in vtkink.styles()["line-art"].presets}
    assert list(drawn) == ["engraving", "sketch", "technical"]
    for name, one in drawn.items():
        assert 0.02 < one.mean() < 0.4, name
        assert all((one != other).any() for key, other in drawn.items() if key != name), name


@pytest.mark.one_build
def test_the_same_with_one_thread_and_two(ink, tmp_path):
    file = tmp_path / "ball.nrrd"
    ink_files.write_nrrd(file, ink_files.blob())
    pictures = []
    for threads in (1, 2):
        out = tmp_path / f"{threads}.png"
        result = ink("render", file, "--style", "line-art", "--line-spacing", 8, "--subdivision", 2, "--iso", 100, "-q", "--size", "200x200", "-o", out,
                     env={"VTK_SMP_MAX_THREADS": str(threads)})  # fmt: skip
        assert (result.code, result.err) == (0, ""), result
        pictures.append(ink_files.read_png(out))
    assert (pictures[0] == pictures[1]).all()
    assert 0.02 < (pictures[0][..., 0] < 128).mean() < 0.4


def test_what_is_wrong_is_said():
    cloud = vtk.vtkPolyData()
    cloud.SetPoints(torus().GetPoints())
    for data, words in ((cloud, "points without polygons"), (vtk.vtkPolyData(), "no points"), (vtk.vtkTable(), "vtkTable"),
                        (np.ones((8, 8, 8)), "different finite values")):  # fmt: skip
        with pytest.raises(ValueError, match=words):
            vtkink.draw(data, "line-art")
    with pytest.raises(ValueError, match="no surface"):
        vtkink.draw(ink_files.blob(), "line-art", iso_values=5000)


def test_the_example_draws(tmp_path):
    nifti = tmp_path / "blob.nii.gz"
    ink_files.write_nifti(nifti, ink_files.blob())
    done = subprocess.run([sys.executable, ROOT / "Python/Examples/line_art.py", nifti], cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == 0, done
    assert 0.02 < (ink_files.read_png(tmp_path / "line_art.png") < 128).mean() < 0.4
