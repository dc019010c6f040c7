# SPDX-License-Identifier: BSD-3-Clause
"""The package vtkink: what it brings with it, and what it says when VTK is not as it should be."""

import importlib.util
import os
import pathlib
import shutil
import subprocess
import sys

import pytest

vtkink = pytest.importorskip("vtkink")

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = os.environ.get("INK_BUILD")


def run(code, path=None, cwd=None):
    """Runs Python code in a process of its own; path replaces Python's search path for packages."""
    environment = dict(os.environ)
    if path is not None:
        environment["PYTHONPATH"] = os.pathsep.join(map(str, path))
    command = [sys.executable, "-c", code]
    return subprocess.run(command, env=environment, cwd=cwd, capture_output=True, text=True, timeout=120)


def copy_of_package(folder, **build):
    """Puts the package's Python files under folder, built with what the keywords say."""
    package = folder / "vtkink"
    package.mkdir()
    source = pathlib.Path(vtkink.__file__).parent
    for name in ("__init__.py", "numpy_support.py", "vtk.py"):
        (package / name).write_text((source / name).read_text())
    values = {"VERSION": vtkink.__version__, "VTK_PACKAGE": vtkink.VTK_PACKAGE, "VTK_VERSION": vtkink.VTK_VERSION}
    values.update(build)
    (package / "_build.py").write_text("".join(f"{name} = {value!r}\n" for name, value in values.items()))
    return [folder, *filter(None, os.environ.get("PYTHONPATH", "").split(os.pathsep))]


def test_version_is_the_projects():
    project = (ROOT / "CMakeLists.txt").read_text()
    assert f"project(vtkInk VERSION {vtkink.__version__} " in project


def test_classes_belong_to_vtk():
    sampler = vtkink.vtkInkIsoSurfaceSampler()
    assert isinstance(sampler, vtkink.vtk.vtkPolyDataAlgorithm)
    assert isinstance(vtkink.vtkInkSplattingLinesMapper(), vtkink.vtk.vtkPolyDataMapper)


def test_classes_are_documented():
    for cls in (vtkink.vtkInkIsoSurfaceSampler, vtkink.vtkInkSplattingLinesMapper):
        assert "Zhang" in cls.__doc__


@pytest.mark.parametrize("name", ["Lambda", "Tau", "Phi", "Sigma"])
def test_documentation_states_range_and_default(name):
    mapper = vtkink.vtkInkSplattingLinesMapper()
    text = " ".join(getattr(mapper, f"Set{name}").__doc__.split())
    low, high = (getattr(mapper, f"Get{name}{end}Value")() for end in ("Min", "Max"))
    default = getattr(mapper, f"Get{name}")()
    assert f"{low:g} to {high:g}" in text and f"default: {default:g}" in text


def test_the_import_alone_brings_opengl():
    """A renderer made after it is VTK's OpenGL one, though nobody imported vtkRenderingOpenGL2."""
    result = run(
        "import vtkink, importlib\n"
        "core = importlib.import_module(vtkink.VTK_PACKAGE + '.vtkRenderingCore')\n"
        "print(core.vtkRenderer().GetClassName(), core.vtkActor().GetClassName())"
    )
    assert result.stdout.split() == ["vtkOpenGLRenderer", "vtkOpenGLActor"], result.stderr


def test_the_import_does_not_load_all_of_vtk():
    result = run("import vtkink, sys; print(vtkink.VTK_PACKAGE + '.all' in sys.modules)")
    assert result.stdout.strip() == "False", result.stderr


@pytest.mark.parametrize(
    "code",
    [
        "import vtkink.vtk; vtkActor = vtkink.vtk.vtkActor",
        "from vtkink.vtk import vtkActor; import vtkink.vtk",
        "from vtkink import vtk; vtkActor = vtk.vtkActor; import vtkink.vtk",
        "import vtkink; vtkActor = vtkink.vtk.vtkActor; import vtkink.vtk",
    ],
)
def test_vtk_is_a_module_of_the_package(code):
    result = run(code + "\nprint(vtkActor is vtkink.vtk.vtkActor, vtkActor.__module__.split('.')[0])")
    assert result.stdout.split() == ["True", vtkink.VTK_PACKAGE], result.stderr


@pytest.mark.parametrize(
    "code",
    [
        "import vtkink.numpy_support as support",
        "from vtkink import numpy_support as support",
        "from vtkink.numpy_support import numpy_to_vtk, vtk_to_numpy; import vtkink.numpy_support as support",
        "import vtkink; support = vtkink.numpy_support",
    ],
)
def test_numpy_support_is_a_module_of_the_package(code):
    result = run(code + "\nimport numpy\n"
                 "print(support.vtk_to_numpy(support.numpy_to_vtk(numpy.arange(3.0))).sum(), support.__name__)")  # fmt: skip
    assert result.stdout.split() == ["3.0", f"{vtkink.VTK_PACKAGE}.util.numpy_support"], result.stderr


def other_vtk(folder):
    """A package that looks as VTK's own do, under a name that this build's VTK does not have."""
    name = "vtkmodules" if vtkink.VTK_PACKAGE != "vtkmodules" else "cvista"
    (folder / name).mkdir()
    (folder / name / "__init__.py").write_text("")
    (folder / name / "vtkCommonCore.py").write_text("")
    return name, [folder, *filter(None, os.environ.get("PYTHONPATH", "").split(os.pathsep))]


def test_another_vtk_that_is_loaded_is_named(tmp_path):
    name, path = other_vtk(tmp_path)
    result = run(f"import {name}.vtkCommonCore\nimport vtkink", path=path)
    assert result.returncode == 0, result.stderr
    assert result.stderr.startswith("<string>:2: RuntimeWarning: ")
    for part in (f"the VTK of the package {name} is loaded", f"works with VTK {vtkink.VTK_VERSION} of the package {vtkink.VTK_PACKAGE}",
                 "from vtkink import vtk, numpy_support", f"PYVISTA_VTK_BACKEND={vtkink.VTK_PACKAGE}"):  # fmt: skip
        assert part in result.stderr


def test_another_vtk_that_is_not_loaded_is_not_named(tmp_path):
    name, path = other_vtk(tmp_path)
    result = run(f"import {name}\nimport vtkink\nfrom vtkink import vtk", path=path)
    assert (result.returncode, result.stderr) == (0, "")


def test_libraries_are_shared_with_vtk():
    """No library of VTK is loaded twice: the classes could not talk to each other."""
    result = run(
        "import vtkink\n"
        "vtkink.vtk\n"
        "print(*{line.split()[-1] for line in open('/proc/self/maps') if 'libvtk' in line}, sep='\\n')"
    )
    names = [pathlib.PurePath(path).name for path in result.stdout.split()]
    assert names and len(names) == len(set(names)), result.stdout + result.stderr


def test_unknown_names_are_attribute_errors():
    with pytest.raises(AttributeError, match="vtkInkNothing"):
        vtkink.vtkInkNothing


def test_missing_vtk_is_named(tmp_path):
    result = run("import vtkink", path=copy_of_package(tmp_path, VTK_PACKAGE="no_such_vtk"))
    assert result.returncode == 1
    last = result.stderr.strip().splitlines()[-1]
    assert last.startswith("ImportError: vtkink ")
    assert f"needs the Python package no_such_vtk of VTK {vtkink.VTK_VERSION}" in last


def test_wrong_vtk_is_named(tmp_path):
    result = run("import vtkink", path=copy_of_package(tmp_path, VTK_VERSION="5.0"))
    assert result.returncode == 1
    last = result.stderr.strip().splitlines()[-1]
    assert "needs VTK 5.0" in last
    assert f"the package {vtkink.VTK_PACKAGE} is VTK {vtkink.VTK_VERSION}" in last


@pytest.mark.skipif(not BUILD, reason="INK_BUILD names no build tree (see Utilities/env.sh)")
def test_installed_package_works_without_the_build_tree(tmp_path):
    prefix = tmp_path / "prefix"
    install = ["cmake", "--install", BUILD, "--prefix", str(prefix)]
    subprocess.run(install, check=True, capture_output=True, timeout=120)
    (package,) = prefix.rglob("vtkink/__init__.py")
    vtk_spec = importlib.util.find_spec(vtkink.VTK_PACKAGE)
    path = [package.parents[1], pathlib.Path(vtk_spec.origin).parents[1]]
    result = run(
        "import vtkink\n"
        "vtkink.vtkInkIsoSurfaceSampler()\n"
        "print(vtkink.__file__)\n"
        "print(*{line.split()[-1] for line in open('/proc/self/maps') if 'vtkInk' in line}, sep='\\n')",
        path=path,
        cwd=tmp_path,
    )
    assert result.returncode == 0, result.stderr
    loaded = result.stdout.split()
    assert len(loaded) > 1 and all(name.startswith(str(prefix)) for name in loaded), loaded
    shutil.rmtree(prefix)  # with VTK it is hundreds of megabytes
