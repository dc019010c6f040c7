"""Dependencies go one way: Common <- Filters <- IO, Common <- Rendering, all <- Plugin, Applications."""

import pathlib
import re

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
SOURCES = {".h", ".hpp", ".cpp", ".cxx"}

# Which of vtkInk's folders the files of a folder may include from.
MAY_USE = {
    "Common": {"Common"},
    "Filters": {"Common", "Filters"},
    "IO": {"Common", "Filters", "IO"},
    "Rendering": {"Common", "Rendering"},
    "Plugin": {"Common", "Filters", "IO", "Rendering", "Plugin"},
    "Applications": {"Common", "Filters", "IO", "Rendering", "Applications"},
}
LAYERS = list(MAY_USE)


def files(layer, suffixes):
    """All product files of a layer; tests may look further."""
    return [
        path
        for path in sorted((ROOT / layer).rglob("*"))
        if path.suffix in suffixes and "Testing" not in path.relative_to(ROOT).parts
    ]


def includes(path):
    return re.findall(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', path.read_text(encoding="utf-8"), re.MULTILINE)


def layer_of_header():
    """Which layer a header of ours, named as it is included, belongs to."""
    owner = {}
    for layer in LAYERS:
        for path in files(layer, {".h", ".hpp"}):
            owner[path.name] = layer
            owner[str(path.relative_to(ROOT / layer))] = layer
    return owner


def test_the_layers_are_there():
    for layer in LAYERS:
        assert files(layer, SOURCES), f"{layer} has no sources: is the path right?"


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
    owner = layer_of_header()
    found = violations(layer, lambda header: owner.get(header, layer) not in MAY_USE[layer])
    assert not found, "\n".join(found)


@pytest.mark.parametrize("layer", ["Filters", "IO"])
def test_filters_and_io_never_see_rendering(layer):
    """Neither by an include, nor by a module dependency, nor by a link."""
    rendering = re.compile(r"vtk(OpenGL|Render|Actor|Camera|Mapper|PolyDataMapper|Property|Light|Prop)")
    found = violations(layer, rendering.match)
    for name in ("vtk.module", "CMakeLists.txt"):
        for path in sorted((ROOT / layer).rglob(name)):
            if "Testing" not in path.parts and re.search(r"\w+::\w*Rendering\w*", path.read_text(encoding="utf-8")):
                found.append(f"{path.relative_to(ROOT)} names a rendering module")
    assert not found, "\n".join(found)


@pytest.mark.parametrize("layer", ["Filters", "IO", "Rendering"])
def test_module_dependencies_go_one_way(layer):
    """A vtk.module may depend on VTK and on vtkInk modules of the layers it may use, never on ParaView."""
    modules = sorted((ROOT / layer).rglob("vtk.module"))
    assert modules
    found = []
    for path in modules:
        for namespace, name in re.findall(r"^\s+(\w+)::(\w+)$", path.read_text(encoding="utf-8"), re.MULTILINE):
            if namespace != "VTK" and not (namespace == "vtkInk" and name.startswith(tuple(MAY_USE[layer]))):
                found.append(f"{path.relative_to(ROOT)} depends on {namespace}::{name}")
    assert not found, "\n".join(found)


def test_openvdb_stays_in_its_own_sources():
    """Its headers take long to compile, and nobody who does not use it should load it."""
    may = {ROOT / "Common" / "Vdb", ROOT / "Common" / "Fields" / "VdbField.cpp"}
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
        if path.name != "VdbTree.h" and (header.startswith("openvdb/") or header == "Vdb/VdbTree.h")
    ]
    assert not found, "\n".join(found)
