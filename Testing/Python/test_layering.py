# SPDX-License-Identifier: BSD-3-Clause
"""Dependencies go one way: Common <- Filters <- IO, Filters/Core <- Rendering, all <- Styles <- Plugin, Applications, Python."""

import pathlib
import re

import pytest

pytestmark = pytest.mark.one_build

ROOT = pathlib.Path(__file__).resolve().parents[2]
SOURCES = {".h", ".hpp", ".cpp", ".cxx"}

# Which of vtkInk's folders the files of a folder may include from.
MAY_USE = {
    "Common": {"Common"},
    "Filters": {"Common", "Filters"},
    "IO": {"Common", "Filters", "IO"},
    "Rendering": {"Common", "Filters/Core", "Rendering"},
    "Styles": {"Common", "Filters", "IO", "Rendering", "Styles"},
    "Plugin": {"Common", "Filters", "IO", "Rendering", "Styles", "Plugin"},
    "Applications": {"Common", "Filters", "IO", "Rendering", "Styles", "Applications"},
    "Python": {"Common", "Filters", "IO", "Rendering", "Styles", "Python"},
}
# Tests and benchmarks may use everything; Compat is what all modules and tests share.
EXEMPT = {"Testing", "Utilities"}


def has_sources(folder):
    return any(path.suffix in SOURCES for path in folder.rglob("*"))


LAYERS = [layer for layer in MAY_USE if (ROOT / layer).is_dir() and has_sources(ROOT / layer)]


def files(layer, suffixes):
    """All product files of a layer; tests may look further."""
    return [
        path
        for path in sorted((ROOT / layer).rglob("*"))
        if path.suffix in suffixes and "Testing" not in path.relative_to(ROOT).parts
    ]


def includes(path):
    return re.findall(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', path.read_text(encoding="utf-8"), re.MULTILINE)


def folder_of_header():
    """Which folder a header of ours, named as it is included, belongs to."""
    owner = {}
    for layer in LAYERS:
        for path in files(layer, {".h", ".hpp"}):
            owner[path.name] = owner[str(path.relative_to(ROOT / layer))] = str(path.parent.relative_to(ROOT))
    return owner


def may_use(layer, folder):
    return any(folder == allowed or folder.startswith(f"{allowed}/") for allowed in MAY_USE[layer])


def test_every_folder_with_sources_is_a_layer():
    skipped = EXEMPT | {"build"}
    folders = {path.name for path in ROOT.iterdir() if path.is_dir() and path.name[0] != "." and path.name not in skipped}
    assert {folder for folder in folders if has_sources(ROOT / folder)} == set(LAYERS)
    assert {"Common", "Filters", "IO", "Rendering", "Plugin", "Applications"} <= set(LAYERS)


def violations(layer, forbidden):
    """The includes in a layer whose header is forbidden."""
    return [
        f"{path.relative_to(ROOT)} includes {header}"
        for path in files(layer, SOURCES)
        for header in includes(path)
        if forbidden(header)
    ]


def test_common_never_sees_vtk():
    found = violations("Common", re.compile(r"(.*/)?(vtk|pq|QtCore|QtGui)").match)
    assert not found, "\n".join(found)


@pytest.mark.parametrize("layer", LAYERS)
def test_includes_go_one_way(layer):
    owner = folder_of_header()
    found = violations(layer, lambda header: not may_use(layer, owner.get(header, layer)))
    assert not found, "\n".join(found)


@pytest.mark.parametrize("layer", ["Filters", "IO"])
def test_filters_and_io_never_see_rendering(layer):
    """Neither by an include, nor by a module dependency, nor by a link; but contours are those for a camera."""
    rendering = re.compile(r"vtk(OpenGL|Render|Actor|Camera|Mapper|PolyDataMapper|Property|Light|Prop)")
    contours = "Filters/Contours"
    found = [line for line in violations(layer, rendering.match) if not re.match(f"{contours}/.* vtkCamera.h$", line)]
    for name in ("vtk.module", "CMakeLists.txt"):
        for path in sorted((ROOT / layer).rglob(name)):
            text = path.read_text(encoding="utf-8")
            if path.parent == ROOT / contours:
                text = text.replace("VTK::RenderingCore", "")
            if "Testing" not in path.parts and re.search(r"\w+::\w*Rendering\w*", text):
                found.append(f"{path.relative_to(ROOT)} names a rendering module")
    assert not found, "\n".join(found)


@pytest.mark.parametrize("layer", [layer for layer in LAYERS if layer != "Plugin" and list((ROOT / layer).rglob("vtk.module"))])
def test_module_dependencies_go_one_way(layer):
    """A vtk.module may depend on VTK and on vtkInk modules of the layers it may use, never on ParaView."""
    modules = tuple(folder.replace("/", "") for folder in MAY_USE[layer])
    found = []
    for path in sorted((ROOT / layer).rglob("vtk.module")):
        for namespace, name in re.findall(r"^\s+(\w+)::(\w+)$", path.read_text(encoding="utf-8"), re.MULTILINE):
            if namespace != "VTK" and not (namespace == "vtkInk" and name.startswith(modules)):
                found.append(f"{path.relative_to(ROOT)} depends on {namespace}::{name}")
    assert not found, "\n".join(found)


def test_openvdb_stays_in_its_own_sources():
    """Its headers take long to compile, and nobody who does not use it should load it."""
    may = {ROOT / "Common" / folder / "Vdb" for folder in ("Fields", "IsoSurface")}
    found = [
        text
        for layer in LAYERS
        for text in violations(layer, re.compile("openvdb/").match)
        if not any(str(ROOT / text.split(" ")[0]).startswith(str(one)) for one in may)
    ]
    found += [
        f"{path.relative_to(ROOT)}, a public header, includes {header}"
        for path in files("Common", {".h"})
        for header in includes(path)
        if path.name != "VdbTree.h" and (header.startswith("openvdb/") or header == "Fields/Vdb/VdbTree.h")
    ]
    assert not found, "\n".join(found)
