"""The classes as a Python programmer meets them: from a numpy array to points to a picture."""

import importlib
import pathlib
import subprocess
import sys

import numpy
import pytest

vtkink = pytest.importorskip("vtkink")
vtk = vtkink.vtk
numpy_support = importlib.import_module(f"{vtkink.VTK_PACKAGE}.util.numpy_support")

EXAMPLE = pathlib.Path(__file__).resolve().parents[2] / "Python" / "Examples" / "splatting_lines.py"
RADIUS = 10.0


def image_of(values):
    """vtkImageData around the origin with spacing 1 from an array indexed [z, y, x]."""
    image = vtk.vtkImageData()
    image.SetDimensions(values.shape[::-1])
    image.SetOrigin([-0.5 * (n - 1) for n in values.shape[::-1]])
    scalars = numpy_support.numpy_to_vtk(values.ravel(), deep=True)
    scalars.SetName("density")
    image.GetPointData().SetScalars(scalars)
    return image


def ball(size=32):
    """RADIUS - distance to the centre: denser inside, 0 on the sphere."""
    axis = numpy.arange(size) - 0.5 * (size - 1)
    z, y, x = numpy.meshgrid(axis, axis, axis, indexing="ij")
    return RADIUS - numpy.sqrt(x * x + y * y + z * z)


class Messages:
    """Collects the errors and warnings of an object."""

    def __init__(self, *observed):
        self.texts = []
        for one in observed:
            for event in ("ErrorEvent", "WarningEvent"):
                one.AddObserver(event, self)
        self.CallDataType = "string0"

    def __call__(self, caller, event, text):
        self.texts.append(text)


def sampler_of(image, *values):
    sampler = vtkink.vtkInkIsoSurfaceSampler()
    sampler.SetInputData(image)
    for i, value in enumerate(values):
        sampler.SetValue(i, value)
    return sampler


def point_array(points, name):
    return numpy_support.vtk_to_numpy(points.GetPointData().GetArray(name))


def test_sampler_places_points_on_the_sphere():
    sampler = sampler_of(image_of(ball()), 0.0)
    sampler.Update()
    points = sampler.GetOutput()
    positions = numpy_support.vtk_to_numpy(points.GetPoints().GetData())
    normals = point_array(points, "Normals")
    distance = numpy.linalg.norm(positions, axis=1)
    # The mean of a cell's crossings lies below the sphere by at most the height of a chord of a cell's diagonal.
    sagitta = RADIUS - numpy.sqrt(RADIUS**2 - 0.75)
    assert len(positions) > 4 * numpy.pi * RADIUS**2
    assert numpy.all(numpy.abs(distance - RADIUS) < sagitta)
    assert numpy.allclose(numpy.linalg.norm(normals, axis=1), 1, atol=1e-5)
    assert numpy.all(numpy.sum(normals * positions, axis=1) / distance > 0.99)
    assert numpy.all(point_array(points, "Radius") > 0)


def test_sampler_is_the_same_for_float_and_double():
    from_double, from_float = sampler_of(image_of(ball()), 0.0), sampler_of(image_of(ball().astype("f4")), 0.0)
    from_double.Update()
    from_float.Update()
    a, b = (numpy_support.vtk_to_numpy(s.GetOutput().GetPoints().GetData()) for s in (from_double, from_float))
    assert a.shape == b.shape and numpy.allclose(a, b, atol=1e-4)


def test_several_iso_values_add_up():
    image = image_of(ball())
    counts = []
    for values in ([0.0], [4.0], [0.0, 4.0]):
        sampler = sampler_of(image, *values)
        sampler.Update()
        counts.append(sampler.GetOutput().GetNumberOfPoints())
    assert counts[0] + counts[1] == counts[2] and min(counts) > 0


def test_image_without_scalars_is_an_error_and_gives_an_empty_output():
    image = vtk.vtkImageData()
    image.SetDimensions(4, 4, 4)
    sampler = sampler_of(image, 0.0)
    messages = Messages(sampler, sampler.GetExecutive())
    sampler.Update()
    assert len(messages.texts) == 1
    assert sampler.GetOutput().GetNumberOfPoints() == 0


def test_stipple_generator_gives_each_voxel_a_list():
    generator = vtkink.vtkInkStippleGenerator()
    generator.SetInputData(image_of(numpy.clip(ball(), -1, 1)))
    generator.SetMaximumStipples(5)
    generator.Update()
    stipples = generator.GetOutput()
    elements = stipples.GetNumberOfVerts()
    positions = numpy_support.vtk_to_numpy(stipples.GetPoints().GetData()).reshape(elements, 5, 3)
    cells = stipples.GetCellData()
    normals = numpy_support.vtk_to_numpy(cells.GetArray("Normals"))
    magnitudes = numpy_support.vtk_to_numpy(cells.GetArray("GradientMagnitude"))
    assert elements > 1000
    assert numpy.all(numpy.abs(positions - positions.mean(axis=1, keepdims=True)) < 1)
    assert numpy.all(numpy.abs(numpy.linalg.norm(positions, axis=2) - RADIUS) < 4)
    assert numpy.all(numpy.sum(normals * positions.mean(axis=1), axis=1) > 0.9 * (RADIUS - 4))
    assert magnitudes.min() > 0 and magnitudes.max() == 1


def test_stipple_generator_takes_meshes():
    sphere = vtk.vtkSphereSource()
    generator = vtkink.vtkInkStippleGenerator()
    generator.SetInputConnection(sphere.GetOutputPort())
    generator.SetNumberOfSurfaceStipples(1000)
    generator.Update()
    assert generator.GetOutput().GetNumberOfPoints() == 1000
    assert generator.GetOutput().GetFieldData().GetArray("ElementKind").GetTuple1(0) == 1


def drawing(points, **properties):
    """A 200 x 200 picture of points on a green background as floats [y, x, rgb], and the mapper's messages."""
    mapper = vtkink.vtkInkSplattingLinesMapper()
    for name, value in properties.items():
        getattr(mapper, f"Set{name}")(value)
    messages = Messages(mapper)
    mapper.SetInputDataObject(points)
    actor, renderer, window = vtk.vtkActor(), vtk.vtkRenderer(), vtk.vtkRenderWindow()
    actor.SetMapper(mapper)
    renderer.AddActor(actor)
    renderer.SetBackground(0, 1, 0)
    window.SetMultiSamples(0)
    window.SetOffScreenRendering(True)
    window.SetSize(200, 200)
    window.AddRenderer(renderer)
    window.Render()
    grab = vtk.vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.Update()
    pixels = numpy_support.vtk_to_numpy(grab.GetOutput().GetPointData().GetScalars())
    return pixels.reshape(200, 200, -1)[..., :3] / 255.0, messages.texts


@pytest.fixture(scope="module")
def bumpy_points():
    """Points on a sphere with a dent all around, so that there are lines inside the outline."""
    size = 48
    axis = numpy.linspace(-1.5, 1.5, size)
    z, y, x = numpy.meshgrid(axis, axis, axis, indexing="ij")
    dent = 0.15 * numpy.exp(-((y / 0.1) ** 2))
    sampler = sampler_of(image_of(1.0 - dent - numpy.sqrt(x * x + y * y + z * z)), 0.0)
    sampler.Update()
    return sampler.GetOutput()


def ink(picture):
    """How much black there is, in pixels: paper is white, the background green."""
    return float(numpy.sum(1.0 - picture[..., 1]))


def background(picture):
    return numpy.all(numpy.abs(picture - [0, 1, 0]) < 0.01, axis=-1)


def test_a_drawing_has_paper_lines_and_background(bumpy_points):
    picture, messages = drawing(bumpy_points, Phi=100.0)
    assert messages == []
    assert background(picture)[0, 0] and not background(picture)[100, 100]
    white = numpy.all(picture > 0.99, axis=-1).mean()
    dark = numpy.all(picture < 0.5, axis=-1).mean()
    assert white > 0.05 and 0.01 < dark < white


def test_more_tau_and_more_phi_are_more_ink(bumpy_points):
    by_tau = [ink(drawing(bumpy_points, Tau=tau)[0]) for tau in (0.95, 1.0, 1.05)]
    by_phi = [ink(drawing(bumpy_points, Phi=phi)[0]) for phi in (5.0, 20.0, 100.0)]
    assert by_tau[0] < by_tau[1] < by_tau[2]
    assert by_phi[0] < by_phi[1] < by_phi[2]


def test_no_phi_is_no_ink(bumpy_points):
    picture, _ = drawing(bumpy_points, Phi=0.0)
    assert ink(picture) < 1e-3 * picture.shape[0] * picture.shape[1]


def test_colours_are_those_asked_for(bumpy_points):
    picture, _ = drawing(bumpy_points, Phi=1000.0, InkColor=(0, 0, 1), PaperColor=(1, 0, 0))
    drawn = picture[~background(picture)]
    assert numpy.all(drawn[:, 1] < 0.02)
    assert numpy.any(drawn[:, 0] > 0.98) and numpy.any(drawn[:, 2] > 0.9)


def test_without_paper_the_background_shows(bumpy_points):
    with_paper, _ = drawing(bumpy_points)
    without_paper, _ = drawing(bumpy_points, PaperVisibility=False)
    assert background(without_paper).mean() > background(with_paper).mean() + 0.1
    assert not background(without_paper).all()


def test_points_without_normals_give_one_message_and_no_mark(bumpy_points):
    bare = vtk.vtkPolyData()
    bare.SetPoints(bumpy_points.GetPoints())
    picture, messages = drawing(bare)
    assert background(picture).all()
    assert len(messages) == 1 and "Normals" in messages[0]


def test_no_points_draw_nothing():
    picture, _ = drawing(vtk.vtkPolyData())
    assert background(picture).all()


def test_bounds_hold_the_whole_splats(bumpy_points):
    mapper = vtkink.vtkInkSplattingLinesMapper()
    mapper.SetInputDataObject(bumpy_points)
    radius = point_array(bumpy_points, "Radius").max()
    reach = numpy.array(mapper.GetBounds()) - bumpy_points.GetPoints().GetBounds()
    assert numpy.allclose(reach, [-radius, radius] * 3)


def test_example_is_short_and_draws(tmp_path):
    assert len(EXAMPLE.read_text().splitlines()) <= 25
    result = subprocess.run(
        [sys.executable, str(EXAMPLE)], cwd=tmp_path, capture_output=True, text=True, timeout=300
    )
    assert result.returncode == 0 and not result.stderr, result.stderr
    reader = vtk.vtkPNGReader()
    reader.SetFileName(str(tmp_path / "splatting_lines.png"))
    reader.Update()
    assert reader.GetOutput().GetDimensions() == (800, 800, 1)
    grey = numpy_support.vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())[:, :3].mean(axis=1) / 255
    assert 0.5 < numpy.mean(grey > 0.95) < 0.99 and 0.001 < numpy.mean(grey < 0.5) < 0.2
