# SPDX-License-Identifier: BSD-3-Clause
"""`ink sample`: points on the surface of a volume, in files that others read."""

import csv
import os
import subprocess

import numpy as np
import pytest

import ink_files

OLD = b"old points"


@pytest.fixture
def sampled(ink, tmp_path):
    """Samples a file and returns the points as columns by name."""

    def run(file, *arguments, name="out.vtp", quiet=True):
        out = tmp_path / name
        result = ink("sample", file, out, *arguments, *(["--quiet"] if quiet else []))
        assert (result.code, result.out) == (0, ""), result
        assert not quiet or result.err == "", result
        return ink_files.read_points(out)

    return run


def test_points_lie_on_the_surface(sampled, tmp_path):
    """The blob's surface at 100, and normals out of it."""
    n = 48
    x, y, z = (np.arange(n) - (n - 1) / 2 for _ in range(3))
    distance = np.sqrt(z[:, None, None] ** 2 + y[None, :, None] ** 2 + x[None, None, :] ** 2)
    ink_files.write_vti(tmp_path / "ball.vti", (100 - 4 * (distance - 15)).astype(np.float32))
    columns = sampled(tmp_path / "ball.vti", "--iso", 100)
    points = np.stack([columns[name] for name in "xyz"], axis=1) - (n - 1) / 2
    normals = np.stack([columns["n" + name] for name in "xyz"], axis=1)
    radius = np.linalg.norm(points, axis=1)
    assert len(points) > 4 * np.pi * 15**2
    assert abs(radius - 15).max() < 0.1
    assert ((points / radius[:, None] * normals).sum(axis=1) > 0.995).all()
    assert np.allclose(columns["Radius"], np.sqrt(3) / 2)


@pytest.mark.parametrize("name", ["out.vtk", "out.ply", "out.csv", "OUT.PLY"])
@pytest.mark.parametrize("arguments", [[], ["--precision", "double"], ["--arrays", "none"], ["--arrays", "Radius"],
                                       ["--iso", 50], ["--arrays", "SurfaceIndex,Normals"]],
                         ids=lambda arguments: "".join(map(str, arguments)) or "default")
def test_formats_hold_the_same(sampled, volume_file, name, arguments):
    reference = sampled(volume_file, "--iso", 100, *arguments)
    other = sampled(volume_file, "--iso", 100, *arguments, name=name)
    assert set(other) == set(reference)
    for column in reference:
        assert other[column].dtype.kind == reference[column].dtype.kind
        assert np.array_equal(other[column].astype(reference[column].dtype), reference[column]), column


def test_xyz_is_coordinates_and_normals(sampled, volume_file):
    reference = sampled(volume_file, "--iso", 100)
    values = sampled(volume_file, "--iso", 100, name="out.xyz")
    for i, column in enumerate(["x", "y", "z", "nx", "ny", "nz"]):
        assert np.array_equal(values[str(i)].astype(np.float32), reference[column])
    assert len(values) == 6


def test_arrays_are_those_asked_for(sampled, volume_file):
    coordinates, normals = {"x", "y", "z"}, {"nx", "ny", "nz"}
    assert set(sampled(volume_file)) == coordinates | normals | {"Radius"}
    assert set(sampled(volume_file, "--arrays", "none")) == coordinates
    assert set(sampled(volume_file, "--arrays", "Normals")) == coordinates | normals
    assert set(sampled(volume_file, "--arrays", "SurfaceIndex,Radius")) == coordinates | {"Radius", "SurfaceIndex"}


def test_several_iso_values_come_one_after_the_other(sampled, volume_file):
    parts = [sampled(volume_file, "--iso", value) for value in (150, 50)]
    both = sampled(volume_file, "--iso", 150, "--iso", 50)
    assert both["SurfaceIndex"].dtype == np.int32
    assert np.array_equal(both["SurfaceIndex"], np.repeat([0, 1], [len(part["x"]) for part in parts]))
    for column in parts[0]:
        assert np.array_equal(both[column], np.concatenate([part[column] for part in parts]))


def test_precision(sampled, tmp_path):
    ink_files.write_metaimage(tmp_path / "near.mha", ink_files.blob())
    ink_files.write_metaimage(tmp_path / "far.mha", ink_files.blob(), offset="10000000 0 0")
    assert sampled(tmp_path / "near.mha")["x"].dtype == np.float32
    assert sampled(tmp_path / "near.mha", "--precision", "double")["x"].dtype == np.float64
    assert sampled(tmp_path / "far.mha")["x"].dtype == np.float64
    assert sampled(tmp_path / "far.mha", "--precision", "float")["x"].dtype == np.float32
    near, far = (sampled(tmp_path / name, "--precision", "double")["x"] for name in ("near.mha", "far.mha"))
    assert np.allclose(near + 1e7, far, rtol=0, atol=1e-6)


def test_rules(sampled, tmp_path):
    """Where the surface goes through voxels, the published rule finds flat pieces twice."""
    volume = np.zeros((6, 7, 8), np.uint8)
    volume[3:] = 100
    volume[2] = 50
    ink_files.write_vti(tmp_path / "step.vti", volume)
    assert len(sampled(tmp_path / "step.vti", "--iso", 50)["x"]) == 6 * 7
    assert len(sampled(tmp_path / "step.vti", "--iso", 50, "--rule", "strict")["x"]) == 2 * 6 * 7


def test_the_chosen_iso_value_is_named(ink, sampled, volume_file, tmp_path):
    result = ink("sample", volume_file, tmp_path / "a.vtp")
    assert result.code == 0 and result.err.startswith("ink: iso-value "), result
    chosen = result.err.split()[2].rstrip(":")
    sampled(volume_file, "--iso", chosen, name="b.vtp")
    assert (tmp_path / "a.vtp").read_bytes() == (tmp_path / "b.vtp").read_bytes()


def test_same_input_same_bytes(ink, volume_file, tmp_path):
    for name, threads in (("a.vtp", "1"), ("b.vtp", "2")):
        assert ink("sample", volume_file, "-q", "-o", tmp_path / name, env={"VTK_SMP_MAX_THREADS": threads}).code == 0
    assert (tmp_path / "a.vtp").read_bytes() == (tmp_path / "b.vtp").read_bytes()


@pytest.mark.parametrize("suffix, reader", [("vtp", "vtkXMLPolyDataReader"), ("vtk", "vtkPolyDataReader"), ("ply", "vtkPLYReader")])
@pytest.mark.parametrize("precision", ["float", "double"])
def test_vtk_reads_it(sampled, volume_file, tmp_path, suffix, reader, precision):
    vtkink = pytest.importorskip("vtkink")
    columns = sampled(volume_file, "--iso", 100, "--iso", 50, "--precision", precision, name="out." + suffix)
    reader = getattr(vtkink.vtk, reader)()
    reader.SetFileName(str(tmp_path / ("out." + suffix)))
    reader.Update()
    data = reader.GetOutput()
    assert data.GetNumberOfPoints() == len(columns["x"])
    normals = data.GetPointData().GetNormals()
    assert normals is not None
    for n in (0, 1, len(columns["x"]) - 1):
        # VTK's PLY reader has float points whatever is in the file.
        assert np.allclose(data.GetPoint(n), [columns[name][n] for name in "xyz"], rtol=1e-6)
        assert np.allclose(normals.GetTuple(n), [columns["n" + name][n] for name in "xyz"])
    if suffix != "ply":
        assert data.GetVerts().GetNumberOfConnectivityIds() == data.GetNumberOfPoints()
        assert data.GetNumberOfCells() == 1
        assert data.GetPointData().GetArray("Radius").GetTuple1(0) == pytest.approx(columns["Radius"][0])
        assert data.GetPointData().GetArray("SurfaceIndex").GetTuple1(data.GetNumberOfPoints() - 1) == 1


def test_ink_draws_its_own_points(ink, sampled, volume_file, tmp_path):
    sampled(volume_file, "--iso", 100, name="points.vtp")
    pictures = []
    # As `ink sample` samples: points are not smoothed and subdivided before they are drawn.
    for source, arguments in (
        (volume_file, ["--iso", 100, "--smoothing", 0, "--subdivision", 1]), (tmp_path / "points.vtp", [])):
        out = tmp_path / "picture.png"
        assert ink("render", source, *arguments, "--style", "splatting-lines", "--size", "150x150", "-q", "-o", out).code == 0
        pictures.append(ink_files.read_png(out))
    assert pictures[0].min() < 100
    assert np.array_equal(*pictures)


@pytest.fixture
def refused(ink, tmp_path):
    """Runs a sampling that has to fail and returns its message."""

    def run(code, *arguments, name="out.vtp"):
        out = tmp_path / "kept" / name
        out.parent.mkdir(exist_ok=True)
        for other in out.parent.iterdir():
            other.unlink()
        out.write_bytes(OLD)
        result = ink("sample", arguments[0], out, *arguments[1:])
        assert result.code == code, result
        assert result.out == ""
        assert out.read_bytes() == OLD
        assert os.listdir(out.parent) == [name], "a temporary file is left"
        return result.error

    return run


def test_bad_arguments(refused, volume_file):
    assert "--iso 1000: expected a value above 0 and up to" in refused(2, volume_file, "--iso", 1000)
    assert "--iso" in refused(2, volume_file, "--iso", "nan")
    assert "--arrays" in refused(2, volume_file, "--arrays", "Color")
    assert "--arrays" in refused(2, volume_file, "--arrays", "none,Radius")
    assert "--precision" in refused(2, volume_file, "--precision", "half")
    assert "--rule" in refused(2, volume_file, "--rule", "loose")
    message = refused(2, volume_file, name="out.obj")
    assert "out.obj" in message and ".vtp .vtk .ply .csv .xyz" in message


def test_bad_files(refused, ink, volume_file, tmp_path):
    assert "no such file" in refused(1, tmp_path / "absent.nrrd")
    ink_files.write_vti(tmp_path / "flat.vti", np.full((4, 4, 4), 7, np.uint8))
    assert "all voxels have the value 7" in refused(1, tmp_path / "flat.vti")
    ink_files.write_vti(tmp_path / "nan.vti", np.full((4, 4, 4), np.nan, np.float32))
    assert "no voxel has a finite value" in refused(1, tmp_path / "nan.vti")
    ink_files.write_vti(tmp_path / "slice.vti", ink_files.blob()[15:16])
    message = refused(1, tmp_path / "slice.vti", "--iso", 50)
    assert "single slice, 32 x 32 x 1 voxels: expected two slices or more" in message
    assert "no directory" in ink("sample", volume_file, tmp_path / "absent" / "out.vtp").error
    assert ink("sample", volume_file).code == 2
    (tmp_path / "full.vtp").symlink_to("/dev/full")
    result = ink("sample", volume_file, "-q", tmp_path / "full.vtp")
    assert result.code == 1 and "No space left" in result.error


def test_to_a_pipe(ink, sampled, volume_file, tmp_path):
    sampled(volume_file, "--iso", 100, name="points.xyz")
    os.mkfifo(tmp_path / "pipe.xyz")
    with subprocess.Popen(["cat", tmp_path / "pipe.xyz"], stdout=subprocess.PIPE) as reader:
        assert ink("sample", volume_file, "--iso", 100, "-q", tmp_path / "pipe.xyz").code == 0
        assert reader.stdout.read() == (tmp_path / "points.xyz").read_bytes()


@pytest.fixture
def mesh_file(tmp_path):
    ink_files.write_ply(tmp_path / "ball.ply", ink_files.sphere_mesh())
    return tmp_path / "ball.ply"


def coordinates_of(columns):
    return np.stack([columns[name] for name in "xyz"], axis=1).astype(float)


def least_distance(points):
    squared = ((points[:, None] - points[None]) ** 2).sum(axis=2)
    np.fill_diagonal(squared, np.inf)
    return np.sqrt(squared.min())


@pytest.mark.parametrize("noise, least, most", [("white", 0, 0.3), ("blue", 0.7, 1), ("progressive", 0.6, 0.7)])
def test_a_mesh_is_sampled(sampled, mesh_file, noise, least, most):
    columns = sampled(mesh_file, "--count", 900, "--noise", noise)
    points = coordinates_of(columns)
    normals = np.stack([columns["n" + name] for name in "xyz"], axis=1)
    assert len(points) == 900
    assert abs(np.linalg.norm(points, axis=1) - 1).max() < 0.01
    assert ((points * normals).sum(axis=1) > 0.99).all()
    assert (np.diff(columns["Priority"]) > 0).all() and columns["Priority"][0] == 0 and columns["Priority"][-1] < 1
    hexagonal = np.sqrt(2 * 4 * np.pi / (np.sqrt(3) * 900))
    ratio = least_distance(points) / hexagonal
    assert least <= ratio < most


def test_a_mesh_by_radius(sampled, mesh_file):
    columns = sampled(mesh_file, "--radius", 0.1, "--arrays", "Normals")
    assert set(columns) == {"x", "y", "z", "nx", "ny", "nz"}
    points = coordinates_of(columns)
    assert 0.098 < least_distance(points) < 0.11
    assert abs(len(points) * 0.1**2 / (4 * np.pi) - 0.69) < 0.05


def test_a_mesh_by_default(sampled, mesh_file):
    assert len(sampled(mesh_file)["x"]) == 200000


def test_another_seed(ink, mesh_file, tmp_path):
    for name, seed, threads in (("a", 0, "1"), ("b", 0, "2"), ("c", 1, "1")):
        arguments = ("--count", 500, "--seed", seed, "-q")
        result = ink("sample", mesh_file, tmp_path / f"{name}.vtp", *arguments, env={"VTK_SMP_MAX_THREADS": threads})
        assert result.code == 0, result
    a, b, c = ((tmp_path / f"{name}.vtp").read_bytes() for name in "abc")
    assert a == b and a != c


def test_points_without_polygons_are_kept(ink, tmp_path):
    points, normals, _ = ink_files.sphere_mesh(20, 30)
    ink_files.write_ply(tmp_path / "cloud.ply", (points, normals, np.empty((0, 3), int)))
    result = ink("sample", tmp_path / "cloud.ply", tmp_path / "out.vtp")
    assert result.code == 0 and "no polygons" in result.err and "estimated" in result.err, result
    columns = ink_files.read_points(tmp_path / "out.vtp")
    found = coordinates_of(columns)
    estimated = np.stack([columns["n" + name] for name in "xyz"], axis=1)
    assert len(found) == len(points) and {"Radius", "Priority"} <= set(columns)
    assert ((found * estimated).sum(axis=1) > 0.95).all()


# What is written of points beside their coordinates: type in a legacy VTK file, components.
CLOUD_ARRAYS = {"id": ("int", 1), "R&D": ("unsigned_short", 1), "a, b": ("short", 2), '<"q">': ("vtktypeint64", 1),
                "a,_b_0": ("unsigned_int", 1), "nx": ("signed_char", 1), "byte": ("unsigned_char", 1), "bit": ("bit", 1),
                "large": ("vtktypeuint64", 1), "real": ("double", 1)}  # fmt: skip


@pytest.fixture
def cloud_file(tmp_path):
    """Points with arrays of many types and names, and one of text. Each value is `id`, modulo 2 where it is a bit."""
    points = ink_files.sphere_mesh(9, 10)[0][:60]
    ids = range(len(points))
    text = f"# vtk DataFile Version 3.0\ntest\nASCII\nDATASET POLYDATA\nPOINTS {len(points)} float\n"
    text += "\n".join(" ".join(map(str, point)) for point in points)
    text += f"\nPOINT_DATA {len(points)}\nFIELD f {len(CLOUD_ARRAYS) + 1}\nlabel 1 {len(points)} string\n" + "\n".join("abcdef" for _ in ids)
    for name, (kind, components) in CLOUD_ARRAYS.items():
        encoded = "".join(c if c not in ' "%' else f"%{ord(c):02X}" for c in name)
        text += f"\n{encoded} {components} {len(points)} {kind}\n"
        text += " ".join(str(n % 2 if kind == "bit" else n) for n in ids for _ in range(components))
    (tmp_path / "cloud.vtk").write_text(text + "\n")
    return tmp_path / "cloud.vtk"


@pytest.mark.parametrize("suffix, reader", [("vtp", "vtkXMLPolyDataReader"), ("vtk", "vtkPolyDataReader")])
def test_arrays_of_numbers_are_kept(ink, cloud_file, tmp_path, suffix, reader):
    vtkink = pytest.importorskip("vtkink")
    result = ink("sample", cloud_file, tmp_path / f"out.{suffix}")
    assert result.code == 0 and "the point array 'label' is left out: its values are of type string" in result.err, result
    reader = getattr(vtkink.vtk, reader)()
    reader.SetFileName(str(tmp_path / f"out.{suffix}"))
    reader.Update()
    data = reader.GetOutput().GetPointData()
    arrays = {data.GetArrayName(i): data.GetArray(i) for i in range(data.GetNumberOfArrays())}
    assert set(arrays) == {*CLOUD_ARRAYS, "Normals", "Radius", "Priority"}
    values = {name: vtkink.numpy_support.vtk_to_numpy(array).astype(int) for name, array in arrays.items()}
    assert sorted(values["id"]) == list(range(60))
    for name, (kind, components) in CLOUD_ARRAYS.items():
        assert arrays[name].GetNumberOfComponents() == components
        expected = values["id"] % 2 if kind == "bit" else values["id"]
        assert all(np.array_equal(column, expected) for column in values[name].reshape(60, -1).T), name
    whole = {name: array.GetDataTypeSize() for name, array in arrays.items() if array.GetDataTypeAsString() not in ("float", "double")}
    assert whole == {"id": 4, "R&D": 2, "a, b": 2, '<"q">': 8, "a,_b_0": 4, "nx": 1, "byte": 1, "bit": 1, "large": 8}


def test_columns_of_tables_have_a_name_each(ink, cloud_file, tmp_path):
    names = {"csv": {"R&D", "a, b_0", "a, b_1", '<"q">', "a,_b_0", "nx_", "byte", "bit", "large", "real"},
             "ply": {"R&D", "a,_b_0", "a,_b_1", '<"q">', "a,_b_0_", "nx_", "byte", "bit", "large", "real"}}
    for suffix, expected in names.items():
        result = ink("sample", cloud_file, tmp_path / f"out.{suffix}")
        assert result.code == 0 and "'label' is left out" in result.err, result
        assert ("'large' is written in double precision: PLY has no" in result.err) == (suffix == "ply")
    head, *rows = csv.reader((tmp_path / "out.csv").read_text().splitlines())
    tables = {"csv": dict(zip(head, np.array(rows, float).T)), "ply": ink_files.read_points(tmp_path / "out.ply")}
    assert len(head) == len(set(head))
    for suffix, table in tables.items():
        assert set(table) == {"x", "y", "z", "nx", "ny", "nz", "id", "Radius", "Priority"} | names[suffix]
        for name in names[suffix]:
            assert np.array_equal(table[name], table["id"] % 2 if name == "bit" else table["id"]), name
    assert tables["ply"]["R&D"].dtype == np.uint16


@pytest.mark.parametrize("arguments, words", [
    (["--count", 0], ["--count"]), (["--radius", 0], ["--radius"]), (["--radius", -1], ["--radius"]),
    (["--count", 10, "--radius", 1], ["--count"]), (["--noise", "pink"], ["pink"]), (["--iso", 1], ["mesh"]),
])
def test_wrong_usage_on_a_mesh(ink, mesh_file, tmp_path, arguments, words):
    result = ink("sample", mesh_file, tmp_path / "out.vtp", *arguments)
    assert result.code == 2 and result.err.count("\n") == 1 and all(word in result.err for word in words), result
    assert not (tmp_path / "out.vtp").exists()


def test_more_points_than_memory(ink, mesh_file, tmp_path):
    result = ink("sample", mesh_file, tmp_path / "out.vtp", "--count", 10**12)
    assert result.code == 1 and "GiB" in result.err and result.err.count("\n") == 1, result
    assert not (tmp_path / "out.vtp").exists()


def test_options_of_a_mesh_on_a_volume(ink, volume_file, tmp_path):
    for arguments in (["--count", 10], ["--noise", "blue"], ["--arrays", "Priority"]):
        result = ink("sample", volume_file, tmp_path / "out.vtp", *arguments)
        assert result.code == 2 and arguments[0] in result.err and "volume" in result.err, result
