"""Dependencies go one way: Common <- Filters, IO, Rendering <- Plugin, Applications, Python."""

import pathlib
import re

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
SOURCES = {".h", ".hpp", ".cpp", ".cxx"}
LAYERS = ["Common", "Filters", "IO", "Rendering"]

# Which of vtkInk's folders the files of a layer may include from or link to.
MAY_USE = {
    "Common": {"Common"},
    "Filters": {"Common", "Filters"},
    "IO": {"Common", "IO"},
    "Rendering": {"Common", "Rendering"},
}


def files(layer, suffixes):
    """All product files of a layer; tests may look further."""
    return [
        path
        for path in sorted((ROOT / layer).rglob("*"))
        if path.suffix in suffixes and "Testing" not in path.relative_to(ROOT).parts
    ]


def includes(path):
    return re.findall(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', path.read_text(), re.MULTILINE)


def layer_of_header():
    """Which layer a header of ours, named as it is included, belongs to."""
    owner = {}
    for layer in LAYERS:
        for path in files(layer, {".h", ".hpp"}):
            owner[path.name] = layer
            owner[str(path.relative_to(ROOT / layer))] = layer
    return owner


def violations(layer, allowed, owner):
    found = []
    for path in files(layer, SOURCES):
        for header in includes(path):
            user = owner.get(header)
            if user is not None and user not in allowed:
                found.append(f"{path.relative_to(ROOT)} includes {header} of {user}")
    return found


def test_common_never_sees_vtk():
    found = [
        f"{path.relative_to(ROOT)} includes {header}"
        for path in files("Common", SOURCES)
        for header in includes(path)
        if re.match(r"(.*/)?(vtk|pq|QtCore|QtGui)", header)
    ]
    assert files("Common", SOURCES), "Common has no sources: is the path right?"
    assert not found, "\n".join(found)


@pytest.mark.parametrize("layer", LAYERS)
def test_includes_go_one_way(layer):
    found = violations(layer, MAY_USE[layer], layer_of_header())
    assert not found, "\n".join(found)


@pytest.mark.parametrize("layer", ["Filters", "IO", "Rendering"])
def test_module_dependencies_go_one_way(layer):
    """A vtk.module may depend on VTK and on vtkInk modules of its own layer; filters never on rendering."""
    found = []
    for path in sorted((ROOT / layer).rglob("vtk.module")):
        for module in re.findall(r"^\s+((?:vtkInk|VTK|ParaView)::\w+)$", path.read_text(), re.MULTILINE):
            namespace, name = module.split("::")
            ours = namespace == "vtkInk" and not name.startswith(layer)
            rendering = layer in ("Filters", "IO") and namespace == "VTK" and name.startswith("Rendering")
            if ours or rendering or namespace == "ParaView":
                found.append(f"{path.relative_to(ROOT)} depends on {module}")
    assert not found, "\n".join(found)
