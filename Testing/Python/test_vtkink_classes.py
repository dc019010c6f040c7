# SPDX-License-Identifier: BSD-3-Clause
"""The classes as a Python programmer meets them: from a numpy array to points to a picture."""

import importlib.util
import os
import pathlib
import re
import subprocess
import sys

import numpy
import pytest

from vtk_messages import Messages

vtkink = pytest.importorskip("vtkink")
vtk = vtkink.vtk
numpy_support = vtkink.numpy_support

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
    """RADIUS - distance to the center: denser inside, 0 on the sphere."""
    axis = numpy.arange(size) - 0.5 * (size - 1)
    z, y, x = numpy.meshgrid(axis, axis, axis, indexing="ij")
    return RADIUS - numpy.sqrt(x * x + y * y + z * z)


def sampler_of(image, *values):
    sampler = vtkink.vtkInkIsoSurfaceSampler()
    sampler.SetInputData(image)
    for i, value in enumerate(values):
        sampler.SetValue(i, value)
    return sampler


def point_array(points, name):
    return numpy_support.vtk_to_numpy(points.GetPointData().GetArray(name))


def test_sampler_tells_surfaces_apart_and_keeps_an_index():
    sampler = sampler_of(image_of(ball()), 0.0, 1.0)
    assert sampler.GetIndexMemory() == 0
    sampler.Update()
    index = point_array(sampler.GetOutput(), "SurfaceIndex")
    assert set(index) == {0, 1} and all(index[1:] >= index[:-1])
    assert sampler.GetIndexMemory() > 0
    sampler.ReleaseIndex()
    assert sampler.GetIndexMemory() == 0


def test_sampler_offers_cheaper_normals():
    sampler = sampler_of(image_of(ball()), 0.0)
    sampler.Update()
    exact = point_array(sampler.GetOutput(), "Normals").copy()
    sampler.SetOutputNormalsPrecisionToChar()
    sampler.Update()
    coarse = point_array(sampler.GetOutput(), "Normals")
    assert coarse.dtype == numpy.int8
    assert abs(coarse / 127.0 - exact).max() <= 0.51 / 127.0
    sampler.SetOutputNormalsPrecisionToSingle()
    for method in (sampler.CELL, sampler.INTERPOLATED_GRADIENT, sampler.REGRESSION):
        sampler.SetNormalMethod(method)
        sampler.Update()
        assert 0.0 < abs(point_array(sampler.GetOutput(), "Normals") - exact).max() < 0.2


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


def noisy_ball():
    rough = ball() + numpy.random.default_rng(1).normal(0, 0.5, (32, 32, 32))
    return image_of(rough.astype("f4"))


def mean_angle(image, name="Gradient"):
    """To the direction into the ball, in degrees, at points near the sphere."""
    positions = numpy.array([image.GetPoint(n) for n in range(image.GetNumberOfPoints())])
    distance = numpy.linalg.norm(positions, axis=1)
    near = numpy.abs(distance - RADIUS) < 2
    gradients = point_array(image, name)[near]
    cosine = -numpy.sum(gradients * positions[near], axis=1) / distance[near] / numpy.linalg.norm(gradients, axis=1)
    return float(numpy.degrees(numpy.arccos(numpy.clip(cosine, -1, 1))).mean())


def test_gradient_by_regression_keeps_its_direction_in_noise():
    angles = []
    for method in ("CentralDifference", "Regression"):
        gradient = vtkink.vtkInkGradient()
        gradient.SetInputData(noisy_ball())
        getattr(gradient, f"SetMethodTo{method}")()
        gradient.Update()
        angles.append(mean_angle(gradient.GetOutput()))
    assert angles[0] > 5 and angles[1] < 0.4 * angles[0]


def test_gradient_makes_what_is_asked_for():
    gradient = vtkink.vtkInkGradient()
    gradient.SetInputData(image_of(ball()))
    gradient.ComputeGradientOff()
    gradient.ComputeValueOn()
    gradient.ComputeLaplacianOn()
    gradient.SetOutputArraysPrecision(vtk.vtkAlgorithm.DOUBLE_PRECISION)
    gradient.Update()
    data = gradient.GetOutput().GetPointData()
    names = {data.GetArrayName(n) for n in range(data.GetNumberOfArrays())}
    assert names == {"density", "GradientMagnitude", "Value", "Laplacian"}
    middle = 16 * (1 + 32 + 32 * 32)
    at = middle - 10  # ten points left of the middle: on the sphere, nearly
    assert abs(data.GetArray("GradientMagnitude").GetValue(at) - 1) < 0.02
    assert abs(data.GetArray("Laplacian").GetValue(at) + 2 / 9.5) < 0.02
    assert data.GetArray("Value").GetDataType() == vtk.VTK_DOUBLE


def test_gradient_of_nothing_is_an_error_and_gives_an_empty_output():
    image = vtk.vtkImageData()
    image.SetDimensions(4, 4, 4)
    gradient = vtkink.vtkInkGradient()
    gradient.SetInputData(image)
    messages = Messages(gradient, gradient.GetExecutive())
    gradient.Update()
    assert len(messages.texts) == 1
    assert gradient.GetOutput().GetNumberOfPoints() == 0


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


def test_colors_are_those_asked_for(bumpy_points):
    picture, _ = drawing(bumpy_points, Phi=1000.0, InkColor=(0, 0, 1), PaperColor=(1, 0, 0))
    inside = ~background(picture)
    # Ink shares pixels at outlines with the background.
    for axis in (0, 1):
        inside &= numpy.roll(inside, 1, axis) & numpy.roll(inside, -1, axis)
    drawn = picture[inside]
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


def ball_mesh():
    source = vtk.vtkSphereSource()
    source.SetThetaResolution(40)
    source.SetPhiResolution(40)
    source.Update()
    return source.GetOutput()


def test_surface_sampler_makes_points_with_priority():
    sampler = vtkink.vtkInkSurfaceSampler()
    sampler.SetInputData(ball_mesh())
    sampler.SetNumberOfSamples(1000)
    sampler.Update()
    points = sampler.GetOutput()
    positions = numpy_support.vtk_to_numpy(points.GetPoints().GetData())
    assert len(positions) == 1000
    assert numpy.allclose(numpy.linalg.norm(positions, axis=1), 0.5, atol=0.005)
    assert numpy.all(numpy.sum(positions * point_array(points, "Normals"), axis=1) > 0.49)
    assert numpy.array_equal(point_array(points, "Priority"), numpy.arange(1000, dtype="f4") / numpy.float32(1000))
    assert point_array(points, "Radius").min() > 0


def test_surface_samples_move_with_the_mesh():
    mesh = ball_mesh()
    sampler = vtkink.vtkInkSurfaceSampler()
    sampler.SetInputData(mesh)
    sampler.SetNumberOfSamples(300)
    sampler.KeepFacesOn()
    mover = vtkink.vtkInkSurfaceSampler()
    transform, filter = vtk.vtkTransform(), vtk.vtkTransformFilter()
    transform.Scale(2, 2, 2)
    filter.SetTransform(transform)
    filter.SetInputData(mesh)
    mover.SetInputConnection(filter.GetOutputPort())
    mover.SetFirstFrameConnection(sampler.GetOutputPort())
    mover.Update()
    before, after = (numpy_support.vtk_to_numpy(s.GetOutput().GetPoints().GetData()) for s in (sampler, mover))
    assert numpy.allclose(after, 2 * before, atol=1e-6)
    assert numpy.allclose(point_array(mover.GetOutput(), "Radius"), 2 * point_array(sampler.GetOutput(), "Radius"))


def test_point_priority_carries_arrays_along(bumpy_points):
    order = vtkink.vtkInkPointPriority()
    order.SetInputDataObject(bumpy_points)
    order.Update()
    points = order.GetOutput()
    assert points.GetNumberOfPoints() == bumpy_points.GetNumberOfPoints()
    rows = [
        numpy.hstack([numpy_support.vtk_to_numpy(one.GetPoints().GetData()), point_array(one, "Normals")])
        for one in (points, bumpy_points)
    ]
    assert numpy.array_equal(*(row[numpy.lexsort(row.T)] for row in rows))
    assert numpy.all(numpy.diff(point_array(points, "Priority")) > 0)


def test_surface_example_is_short_and_draws(tmp_path):
    example = EXAMPLE.with_name("surface_samples.py")
    assert len(example.read_text().splitlines()) <= 26
    writer = vtk.vtkPLYWriter()
    writer.SetFileName(str(tmp_path / "ball.ply"))
    writer.SetInputData(ball_mesh())
    writer.Write()
    command = [sys.executable, str(example), "ball.ply", "20000"]
    result = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=300)
    assert result.returncode == 0 and not result.stderr, result.stderr
    reader = vtk.vtkPNGReader()
    reader.SetFileName(str(tmp_path / "surface_samples.png"))
    reader.Update()
    gray = numpy_support.vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())[:, :3].mean(axis=1) / 255
    assert 0.5 < numpy.mean(gray > 0.95) < 0.999 and 0.0005 < numpy.mean(gray < 0.5) < 0.2


def test_animation_example_is_short_and_draws(tmp_path):
    example = EXAMPLE.with_name("animation.py")
    assert len(example.read_text().splitlines()) <= 45
    result = subprocess.run(
        [sys.executable, str(example), "3"], cwd=tmp_path, capture_output=True, text=True, timeout=300
    )
    assert result.returncode == 0 and not result.stderr, result.stderr
    pictures = []
    for frame in range(3):
        reader = vtk.vtkPNGReader()
        reader.SetFileName(str(tmp_path / f"animation_{frame:02d}.png"))
        reader.Update()
        scalars = reader.GetOutput().GetPointData().GetScalars()
        gray = numpy_support.vtk_to_numpy(scalars)[:, :3].mean(axis=1) / 255
        assert 0.5 < numpy.mean(gray > 0.95) < 0.999 and 0.002 < numpy.mean(gray < 0.5) < 0.2
        pictures.append(gray)
    assert not numpy.array_equal(pictures[0], pictures[1]) and not numpy.array_equal(pictures[1], pictures[2])


def test_example_is_short_and_draws(tmp_path):
    assert len(EXAMPLE.read_text().splitlines()) <= 26
    result = subprocess.run(
        [sys.executable, str(EXAMPLE)], cwd=tmp_path, capture_output=True, text=True, timeout=300
    )
    assert result.returncode == 0 and not result.stderr, result.stderr
    reader = vtk.vtkPNGReader()
    reader.SetFileName(str(tmp_path / "splatting_lines.png"))
    reader.Update()
    assert reader.GetOutput().GetDimensions() == (800, 800, 1)
    gray = numpy_support.vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())[:, :3].mean(axis=1) / 255
    assert 0.5 < numpy.mean(gray > 0.95) < 0.99 and 0.001 < numpy.mean(gray < 0.5) < 0.2


def gray_picture(file, side):
    reader = vtk.vtkPNGReader()
    reader.SetFileName(str(file))
    reader.Update()
    assert reader.GetOutput().GetDimensions() == (side, side, 1)
    return numpy_support.vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())[:, :3].mean(axis=1) / 255


def test_numpy_example_is_short_and_draws(tmp_path):
    example = EXAMPLE.with_name("numpy_volume.py")
    assert len(example.read_text().splitlines()) <= 36
    result = subprocess.run(
        [sys.executable, str(example)], cwd=tmp_path, capture_output=True, text=True, timeout=300
    )
    assert result.returncode == 0 and not result.stderr, result.stderr
    points, normals = re.fullmatch(r"(\d+) points, their normals as an array of \((\d+), 3\)\n", result.stdout).groups()
    assert points == normals and int(points) > 40000
    gray = gray_picture(tmp_path / "numpy_volume.png", 600)
    assert 0.8 < numpy.mean(gray > 0.95) < 0.99 and 0.01 < numpy.mean(gray < 0.5) < 0.05


@pytest.mark.skipif(not importlib.util.find_spec("pyvista"), reason="PyVista is not installed")
@pytest.mark.skipif(vtkink.VTK_VERSION.startswith("9.2"), reason="PyVista needs a newer VTK")
def test_pyvista_example_is_short_and_draws(tmp_path):
    example = EXAMPLE.with_name("pyvista_lines.py")
    assert len(example.read_text().splitlines()) <= 26
    environment = dict(os.environ, PYVISTA_VTK_BACKEND=vtkink.VTK_PACKAGE)
    result = subprocess.run(
        [sys.executable, str(example)], cwd=tmp_path, env=environment, capture_output=True, text=True, timeout=300
    )
    assert result.returncode == 0 and "Warning" not in result.stderr, result.stderr
    points, arrays = re.fullmatch(r"(\d+) points with (.*)\n", result.stdout).groups()
    assert int(points) > 60000 and arrays == "Normals, Radius"
    gray = gray_picture(tmp_path / "pyvista_lines.png", 600)
    assert 0.8 < numpy.mean(gray > 0.95) < 0.99 and 0.01 < numpy.mean(gray < 0.5) < 0.05


def write_nifti(path, values):
    """values: uint8, indexed [z, y, x]."""
    header = bytearray(352)
    numpy.frombuffer(header, "<i4", 1, 0)[:] = 348
    numpy.frombuffer(header, "<i2", 8, 40)[:] = [3, *values.shape[::-1], 1, 1, 1, 1]
    numpy.frombuffer(header, "<i2", 2, 70)[:] = [2, 8]
    numpy.frombuffer(header, "<f4", 9, 76)[:] = [1, 1, 1, 1, 1, 1, 1, 1, 352]
    header[344:348] = b"n+1\0"
    path.write_bytes(bytes(header) + values.tobytes())


@pytest.mark.parametrize("preset", ["anatomy", "plate-white-on-black"])
def test_stipple_example_is_short_and_draws(tmp_path, preset):
    example = EXAMPLE.with_name("stipple.py")
    assert len(example.read_text().splitlines()) <= 30
    write_nifti(tmp_path / "ball.nii", numpy.clip(128 + 40 * ball(), 0, 255).astype("u1"))
    command = [sys.executable, str(example), "ball.nii", preset]
    result = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=300)
    assert result.returncode == 0 and not result.stderr, result.stderr
    reader = vtk.vtkPNGReader()
    reader.SetFileName(str(tmp_path / "stipple.png"))
    reader.Update()
    assert reader.GetOutput().GetDimensions() == (800, 800, 1)
    gray = numpy_support.vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())[:, :3].mean(axis=1) / 255
    paper = float(preset == "anatomy")
    assert 0.4 < numpy.mean(abs(gray - paper) < 0.05) < 0.99 and 0.005 < numpy.mean(abs(gray - paper) > 0.5) < 0.4


def stippled_square(elements=10, per_element=8):
    """A square of the plane z = 0 facing +z as stipples of a surface, in the form that the mapper expects."""
    places = numpy.random.default_rng(1).random((elements, elements, per_element, 2))
    corners = numpy.stack(numpy.meshgrid(range(elements), range(elements), indexing="ij"), axis=-1)
    flat = (corners[:, :, None, :] + places).reshape(-1, 2)
    points = vtk.vtkPoints()
    points.SetData(numpy_support.numpy_to_vtk(numpy.c_[flat, numpy.zeros(len(flat))], deep=True))
    cells = vtk.vtkCellArray()
    for first in range(0, len(flat), per_element):
        cells.InsertNextCell(per_element, range(first, first + per_element))
    stipples = vtk.vtkPolyData()
    stipples.SetPoints(points)
    stipples.SetVerts(cells)
    normals = numpy_support.numpy_to_vtk(numpy.tile([0.0, 0.0, 1.0], (elements * elements, 1)), deep=True)
    normals.SetName("Normals")
    stipples.GetCellData().AddArray(normals)
    for name, value in (("ElementKind", 1), ("ElementSize", 1), ("StipplesPerElement", per_element)):
        array = vtk.vtkFloatArray()
        array.SetName(name)
        array.InsertNextValue(value)
        stipples.GetFieldData().AddArray(array)
    return stipples


def test_stipples_are_drawn_with_a_preset():
    mapper, controls = vtkink.vtkInkStippleMapper(), vtkink.vtkInkStippleControls()
    mapper.SetInputData(stippled_square())
    assert controls.SetPreset("soft-tissue") and controls.GetPreset() == "soft-tissue"
    controls.SetGradient(2.0)
    assert controls.GetGradient() == 1.0
    controls.Apply(mapper)
    mapper.LightingOff()
    actor, renderer, window = vtk.vtkActor(), vtk.vtkRenderer(), vtk.vtkRenderWindow()
    actor.SetMapper(mapper)
    renderer.AddActor(actor)
    renderer.SetBackground(1, 1, 1)
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(200, 200)
    window.AddRenderer(renderer)
    window.Render()
    marks = vtk.vtkFloatArray()
    assert mapper.EvaluateMarks(renderer, actor, marks)
    found = numpy_support.vtk_to_numpy(marks)
    assert found.shape == (800, 6) and numpy.all((found[:, 1] >= 0) & (found[:, 1] <= 1))
    assert 50 < numpy.count_nonzero(found[:, 1]) <= 800
    assert numpy.allclose(found[found[:, 1] > 0, 3:], 0)
    mapper.SetLightingExponent(-5.0)
    assert mapper.GetLightingExponent() == 0.01


needs_openvdb = pytest.mark.skipif(not hasattr(vtkink, "vtkInkVDBReader"), reason="built without OpenVDB")


@pytest.fixture
def vdb_file(tmp_path):
    """The ball as a narrow band, written by ink, and the ball itself."""
    values = ball().astype("f4")
    raw, file = tmp_path / "ball.raw", tmp_path / "ball.vdb"
    raw.write_bytes(values.tobytes())
    subprocess.run(["ink", "convert", raw, file, "--raw", "32x32x32:float32", "--around", "0"], check=True)
    return file, values


@needs_openvdb
def test_vdb_reader_and_sampler_agree_with_the_volume(vdb_file):
    file, values = vdb_file
    reader = vtkink.vtkInkVDBReader()
    messages = Messages(reader)
    reader.SetFileName(str(file))
    reader.UpdateInformation()
    assert [reader.GetNameOfGrid(i) for i in range(reader.GetNumberOfGrids())] == ["density"]
    assert reader.GetTypeOfGrid(0) == "float" and reader.GetClassOfGrid(0) == "unknown"
    reader.Update()
    band = numpy_support.vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(values.shape)
    near = numpy.abs(values) < 2
    assert near.any() and numpy.array_equal(band[near], values[near])
    assert numpy.array_equal(band >= 0, values >= 0)

    sampler = vtkink.vtkInkVDBIsoSurfaceSampler()
    sampler.SetFileName(str(file))
    sampler.SetValue(0, 0.0)
    image = image_of(values)
    image.SetOrigin(0, 0, 0)
    dense = sampler_of(image, 0.0)
    rows = []
    for one in (sampler, dense):
        one.Update()
        points = one.GetOutput()
        xyz = numpy_support.vtk_to_numpy(points.GetPoints().GetData())
        table = numpy.hstack([xyz, point_array(points, "Normals")])
        rows.append(table[numpy.lexsort(table.T)])
    assert len(rows[0]) > 1000 and numpy.array_equal(*rows)
    assert messages.texts == []


@needs_openvdb
def test_a_damaged_vdb_file_is_one_error(vdb_file, tmp_path):
    bad = tmp_path / "bad.vdb"
    bad.write_bytes(vdb_file[0].read_bytes()[:-100])
    for one in (vtkink.vtkInkVDBReader(), vtkink.vtkInkVDBIsoSurfaceSampler()):
        messages = Messages(one, one.GetExecutive())
        one.SetFileName(str(bad))
        one.Update()
        assert len(messages.texts) == 1 and "bad.vdb" in messages.texts[0]
        assert one.GetOutput().GetNumberOfPoints() == 0
