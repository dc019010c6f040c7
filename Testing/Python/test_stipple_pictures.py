# SPDX-License-Identifier: BSD-3-Clause
"""Stipples on pictures: where they are, that they never move, and what each slider does to the ink."""

import importlib

import numpy as np
import pytest

vtkink = pytest.importorskip("vtkink")
vtk = vtkink.vtk
numpy_support = importlib.import_module(f"{vtkink.VTK_PACKAGE}.util.numpy_support")

SIZE = 240


def image_of(values):
    """vtkImageData around the origin with spacing 1 from an array indexed [z, y, x]."""
    image = vtk.vtkImageData()
    image.SetDimensions(values.shape[::-1])
    image.SetOrigin([-0.5 * (n - 1) for n in values.shape[::-1]])
    image.GetPointData().SetScalars(numpy_support.numpy_to_vtk(values.ravel(), deep=True))
    return image


def two_balls():
    """A dense ball in front (+z) beside a less dense one behind: strong and weak boundaries, near and far."""
    z, y, x = np.meshgrid(*[np.arange(n) - (n - 1) / 2 for n in (44, 30, 54)], indexing="ij")
    ball = lambda cx, cz: 1 / (1 + np.exp(2 * (np.sqrt((x - cx) ** 2 + y**2 + (z - cz) ** 2) - 11)))
    return image_of((200 * ball(-13, 8) + 110 * ball(13, -8)).astype("f4"))


class Scene:
    def __init__(self, data, maximum=12):
        self.generator = vtkink.vtkInkStippleGenerator()
        self.generator.SetInputData(data)
        self.generator.SetMaximumStipples(maximum)
        self.generator.SetGradientPercentile(88)
        self.mapper = vtkink.vtkInkStippleMapper()
        self.mapper.SetSizeUnitToPixels()
        self.mapper.SetInputConnection(self.generator.GetOutputPort())
        self.actor = vtk.vtkActor()
        self.actor.SetMapper(self.mapper)
        self.renderer = vtk.vtkRenderer()
        self.renderer.SetBackground(1, 1, 1)
        self.renderer.AddActor(self.actor)
        self.window = vtk.vtkRenderWindow()
        self.window.SetOffScreenRendering(True)
        self.window.SetMultiSamples(0)
        self.window.SetSize(SIZE, SIZE)
        self.window.AddRenderer(self.renderer)
        self.controls = vtkink.vtkInkStippleControls()
        self.renderer.ResetCamera()
        self.camera = self.renderer.GetActiveCamera()
        self.window.Render()

    def apply(self):
        self.controls.Apply(self.mapper)
        self.mapper.SetSizeUnitToPixels()
        paper = [0, 0, 0]
        self.controls.GetPaperColor(paper)
        self.renderer.SetBackground(paper)
        return paper[0]

    def picture(self):
        """Rows from the bottom, RGB, 0 to 1."""
        self.window.Render()
        pixels = vtk.vtkUnsignedCharArray()
        self.window.GetPixelData(0, 0, SIZE - 1, SIZE - 1, 0, pixels, 0)  # VTK 9.2 asks for the last one
        return np.frombuffer(memoryview(pixels), np.uint8).reshape(SIZE, SIZE, 3) / 255

    def ink(self):
        return np.abs(self.picture() - self.renderer.GetBackground()).mean(axis=2)

    def marks(self):
        """T, opacity, diameter, red, green, blue of each stipple in the present view."""
        found = vtk.vtkFloatArray()
        assert self.mapper.EvaluateMarks(self.renderer, self.actor, found)
        return numpy_support.vtk_to_numpy(found).copy()

    def positions(self):
        return numpy_support.vtk_to_numpy(self.generator.GetOutput().GetPoints().GetData())

    def places(self):
        """Pixels at which the generator's stipples lie in the present view."""
        matrix = self.camera.GetCompositeProjectionTransformMatrix(1, -1, 1)
        to_clip = np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
        homogeneous = np.c_[self.positions(), np.ones(len(self.positions()))] @ to_clip.T
        return (homogeneous[:, :2] / homogeneous[:, 3:] + 1) / 2 * SIZE


@pytest.fixture(scope="module")
def scene():
    return Scene(two_balls())


@pytest.fixture
def plain(scene):
    """The scene with its first camera and preset."""
    scene.camera.SetPosition(0, 0, 1)
    scene.camera.SetFocalPoint(0, 0, 0)
    scene.camera.SetViewUp(0, 1, 0)
    scene.camera.SetViewAngle(30)
    scene.renderer.ResetCamera()
    scene.controls.SetPreset("anatomy")
    scene.mapper.SetSmallElements(0)
    scene.apply()
    return scene


def test_minimum_coverage_matters_with_probability_or_less_fade(plain):
    def change_by_coverage(way, fade):
        plain.mapper.SetSmallElements(way)
        plain.mapper.SetFade(fade)
        marks = []
        for coverage in (2, 9):
            plain.mapper.SetMinimumCoverage(coverage)
            plain.window.Render()
            marks.append(plain.marks()[:, 1])
        plain.mapper.SetFade(1)
        return np.abs(marks[1] - marks[0]).mean()

    plain.mapper.SetPixelsPerStipple(2)  # room for 3 stipples in a voxel
    assert change_by_coverage(plain.mapper.INTENSITY, 1) == 0
    assert change_by_coverage(plain.mapper.INTENSITY, 0.2) > 0.01
    assert change_by_coverage(plain.mapper.PROBABILITY, 1) > 0.01


VIEWS = [(0, 1), (1, 1), (40, 1), (41, 3), (200, 8)]


def look(scene, azimuth, zoom):
    scene.camera.Azimuth(azimuth)
    scene.camera.Zoom(zoom)
    scene.renderer.ResetCameraClippingRange()


@pytest.mark.parametrize("azimuth, zoom", VIEWS)
@pytest.mark.parametrize("way", [0, 1])
def test_ink_is_where_the_generator_put_stipples_and_nowhere_else(plain, azimuth, zoom, way):
    look(plain, azimuth, min(3 * zoom, 9))
    plain.mapper.SetSmallElements(way)
    plain.mapper.SetPixelsPerStipple(30)  # few enough to see one by one
    plain.mapper.SetStippleSize(4)
    plain.mapper.SetFadeBySize(False)
    ink, marks, places = plain.ink(), plain.marks(), plain.places()
    drawn = marks[:, 1] > 0
    allowed = np.zeros((SIZE, SIZE), bool)
    for (x, y), diameter in zip(places[drawn], marks[drawn, 2]):
        reach = diameter / 2 + 2
        if -reach < x < SIZE + reach and -reach < y < SIZE + reach:
            i = np.arange(max(int(y - reach), 0), min(int(y + reach) + 1, SIZE))
            j = np.arange(max(int(x - reach), 0), min(int(x + reach) + 1, SIZE))
            allowed[np.ix_(i, j)] |= np.hypot(i[:, None] + 0.5 - y, j[None, :] + 0.5 - x) < reach
    assert drawn.sum() > 50 and not ink[~allowed].any()
    seen = (marks[:, 1] > 0.05) & (marks[:, 2] > 2.5) & (places > 1).all(axis=1) & (places < SIZE - 1).all(axis=1)
    x, y = places[seen].astype(int).T
    assert seen.sum() > 20 and (ink[y, x] > 0.6 * marks[seen, 1] - 0.02).all()


@pytest.mark.parametrize("way", [0, 1])
@pytest.mark.parametrize("fade", [0, 0.5, 1])
def test_what_is_drawn_is_a_beginning_of_each_list(plain, way, fade):
    """So a smaller T draws a part of what a larger one draws, and stipples come and go one after the other."""
    plain.mapper.SetSmallElements(way)
    plain.mapper.SetFade(fade)
    plain.mapper.SetFadeBySize(False)
    length = plain.generator.GetMaximumStipples()
    for azimuth, zoom in VIEWS:
        look(plain, azimuth, zoom)
        lighter = None
        for k in (0.1, 0.4, 2):
            plain.mapper.SetBoundaryBase(k)
            plain.mapper.SetBoundaryGain(2 * k)
            opacity = plain.marks()[:, 1].reshape(-1, length)
            assert (np.diff(opacity, axis=1) <= 1e-6).all(), "no stipple before the one with priority"
            assert lighter is None or (opacity >= lighter - 1e-6).all(), "darker means more of the same"
            lighter = opacity


def test_stipples_do_not_move(plain):
    """In any view and with any parameters, the middle of each dot that is alone is where the generator put it."""
    reach = 4
    for azimuth, _ in VIEWS[::2]:
        plain.camera.SetViewAngle(30)
        look(plain, azimuth, 9)
        for gradient, size in ((0.2, 2), (0.9, 3)):
            plain.controls.SetGradient(gradient)
            plain.apply()
            plain.mapper.SetPixelsPerStipple(60)
            plain.mapper.SetStippleSize(size)
            plain.mapper.SetFadeBySize(False)
            ink, marks, places = plain.ink(), plain.marks(), plain.places()
            drawn = places[marks[:, 1] > 0]
            inside = ((places > reach + 1) & (places < SIZE - reach - 1)).all(axis=1)
            alone = [
                place
                for place in places[inside & (marks[:, 1] > 0.2)]
                if (np.abs(drawn - place).max(axis=1) < 2 * reach).sum() == 1
            ]
            assert len(alone) > 5
            for x, y in alone:
                i, j = int(y) - reach, int(x) - reach
                dot = ink[i : i + 2 * reach + 1, j : j + 2 * reach + 1]
                rows, columns = np.mgrid[: 2 * reach + 1, : 2 * reach + 1] + 0.5
                middle = np.array([(dot * columns).sum(), (dot * rows).sum()]) / dot.sum() + (j, i)
                assert np.abs(middle - (x, y)).max() < 0.125, "in pixels"


def turning(scene, fade, frames=6):
    """The greatest and the mean change of a stipple's ink from one frame to the next, in whole stipples."""
    scene.mapper.SetFade(fade)
    scene.mapper.SetFadeBySize(False)
    opacities = []
    for _ in range(frames):
        scene.camera.Azimuth(0.25)
        opacities.append(scene.marks()[:, 1])
    steps = np.abs(np.diff(opacities, axis=0))
    return steps.max(), steps.mean()


def test_fading_stipples_do_not_pop(plain):
    look(plain, 30, 6)
    plain.mapper.SetStippleSize(4)
    assert turning(plain, 0)[0] == 1
    assert turning(plain, 1)[0] < 0.25


MEASURES = {
    "Gradient": (1, lambda ink, image: ink.sum()),
    "Sharpness": (-1, lambda ink, image: ink.sum()),
    "Interior": (-1, lambda ink, image: ink[:, SIZE // 2 :].sum()),  # the weaker ball
    "Distance": (1, lambda ink, image: ink[:, : SIZE // 2].sum() / ink.sum()),  # the nearer one
    "Orientation": (1, lambda ink, image: rim(ink) / ink.sum()),
    "Color": (1, lambda ink, image: np.ptp(image, axis=2).sum()),
}


def rim(ink):
    """Ink of the outer part of the near ball."""
    near = ink[:, : SIZE // 2]
    rows, columns = np.nonzero(near > 0.02)
    y, x = (rows.min() + rows.max()) / 2, (columns.min() + columns.max()) / 2
    radius = (rows.max() - rows.min()) / 2
    distance = np.hypot(*np.ogrid[-y : near.shape[0] - y, -x : near.shape[1] - x])
    return near[distance > 0.8 * radius].sum()


@pytest.mark.parametrize("preset", ["anatomy", "bone", "soft-tissue", "engineering"])
@pytest.mark.parametrize("slider", MEASURES)
def test_sliders_move_the_ink_the_right_way(plain, slider, preset):
    direction, measure = MEASURES[slider]
    plain.controls.SetPreset(preset)
    values = []
    for position in np.linspace(0, 1, 6):
        getattr(plain.controls, f"Set{slider}")(position)
        plain.apply()
        image = plain.picture()
        ink = 1 - image.mean(axis=2)
        assert 0.0005 < ink.mean() < 0.5, f"a picture at {position}"
        values.append(float(measure(ink, image)))
    steps = direction * np.diff(values)
    assert (steps > -0.01 * max(values)).all() and steps.sum() > 0.05 * max(values), values


@pytest.mark.parametrize("preset", range(vtkink.vtkInkStippleControls.GetNumberOfPresets()))
@pytest.mark.parametrize("end", [0, 1])
def test_all_sliders_at_an_end_and_reset(plain, preset, end):
    plain.controls.SetPreset(plain.controls.GetPresetName(preset))
    plain.apply()
    first = plain.picture()
    for slider in MEASURES:
        getattr(plain.controls, f"Set{slider}")(end)
    plain.apply()
    assert (plain.picture() != plain.renderer.GetBackground()).any()
    assert np.isfinite(plain.marks()).all()
    plain.controls.Reset()
    plain.apply()
    assert (plain.picture() == first).all()


def test_sizes_are_thousandths_of_the_height_by_default(plain):
    """In a viewport of SIZE pixels; and a choice is to have them in pixels."""
    assert vtkink.vtkInkStippleMapper().GetSizeUnit() == plain.mapper.THOUSANDTHS
    plain.mapper.SetStippleSize(10)
    plain.mapper.SetPixelsPerStipple(400)
    plain.mapper.SetFadeBySize(False)
    plain.mapper.SetGrowWithZoom(False)
    diameters, tones = [], []
    for unit in (plain.mapper.PIXELS, plain.mapper.THOUSANDTHS):
        plain.mapper.SetSizeUnit(unit)
        plain.window.Render()
        marks = plain.marks()
        diameters.append(marks[:, 2].max())
        tones.append(marks[:, 0].max())
    assert diameters[1] / diameters[0] == pytest.approx(SIZE / 1000, rel=1e-4)
    assert tones[0] / tones[1] == pytest.approx((SIZE / 1000) ** 2, rel=1e-3)
