# SPDX-License-Identifier: BSD-3-Clause
"""Each source includes what it needs, itself or through its headers: `make test` compiles the sources of a folder together,
where one would get by with what those before it include."""

import functools
import pathlib
import re

import pytest

from test_layering import LAYERS, ROOT, SOURCES, files

pytestmark = pytest.mark.one_build

# What declares a name of the standard library.
STANDARD = {
    "accumulate": "numeric", "array": "array", "atomic": "atomic", "deque": "deque", "filesystem": "filesystem",
    "function": "functional", "ifstream": "fstream", "inner_product": "numeric", "iota": "numeric", "istringstream": "sstream",
    "lower_bound": "algorithm", "map": "map", "mt19937": "random", "mutex": "mutex", "nth_element": "algorithm", "ofstream": "fstream",
    "optional": "optional", "ostringstream": "sstream", "queue": "queue", "set": "set", "sort": "algorithm", "span": "span",
    "stringstream": "sstream", "thread": "thread", "unordered_map": "unordered_map",
    "unordered_set": "unordered_set", "variant": "variant", "vector": "vector",
}


@functools.cache
def headers():
    """Paths of our headers by all names that they may be included by."""
    found = {}
    for layer in LAYERS:
        for path in files(layer, {".h", ".hpp"}):
            for folder in path.parents:
                found.setdefault(str(path.relative_to(folder)), []).append(path)
                if folder == ROOT:
                    break
    return found


@functools.cache
def text_of(path):
    """The code, without comments and texts."""
    code = path.read_text(encoding="utf-8")
    return re.sub(r'//[^\n]*|/\*.*?\*/|(?<!#include )"(?:\\.|[^"\\\n])*"', "", code, flags=re.DOTALL)


@functools.cache
def included(path):
    """All names that a file includes, itself or through our headers."""
    names, todo = set(), [path]
    while todo:
        file = todo.pop()
        for name in re.findall(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', text_of(file), re.MULTILINE):
            beside = file.parent / name
            if name not in names:
                names.add(name)
                todo += [beside] if beside.is_file() else headers().get(name, [])
    return names


@functools.cache
def declared():
    """The header of each type and function of ours that only one declares."""
    found = {}
    for paths in headers().values():
        for path in paths:
            names = re.findall(r"^(?:template[^\n]*\n)?(?:class \w+_EXPORT|class|struct|enum class) (\w+)(?! *;|\w)", text_of(path), re.MULTILINE)
            names += re.findall(r"^using (\w+) =", text_of(path), re.MULTILINE)
            names += re.findall(r"^(?:\[\[\w+\]\] )?[\w:<>, &*]+ [&*]?([a-z]\w*[A-Z]\w*)\(", text_of(path), re.MULTILINE)
            for name in names:
                found.setdefault(name, set()).add(path)
    return {name: next(iter(paths)) for name, paths in found.items() if len(paths) == 1 and len(name) > 7}


def reaches(path, header):
    return path == header or any(header in headers().get(name, []) or path.parent / name == header for name in included(path))


def missing(path):
    """What a source uses and does not include."""
    code = text_of(path)
    found = []
    for name in set(re.findall(r"(?<![\w.>:])(?:ink::)?(?:\w+::)*([A-Za-z]\w{7,})(?=[({:<> ,;&])", code)) & set(declared()):
        # Its own functions may be called as another's are, and pointers need no more than a declaration.
        own = re.search(rf"\b(?:class|struct|enum class|using) {name}\b|^[\w:<>, &*]+ [&*]?(?:\w+::)?{name}\(|\b{name} =|[\w>&*] {name}[;,)({{=]",
                        code, re.MULTILINE)
        # What a type qualifies is that type's own.
        used = any(not re.search(r"\b[A-Z]\w*::$", code[max(use.start() - 80, 0):use.start()])
                   for use in re.finditer(rf"\b{name}(?:::|\(|\{{| \w+[;({{=])", code))
        if used and not own and not reaches(path, declared()[name]):
            found.append(f"{name} ({declared()[name].name})")
    for name in set(re.findall(r"\bvtkNew<(vtk\w+)> \w+;", code)):
        if f"{name}.h" not in {path.name, path.with_suffix(".h").name} | included(path):
            found.append(f"{name}.h")
    for name in set(re.findall(r"\bstd::(\w+)", code)) & set(STANDARD):
        if STANDARD[name] not in included(path):
            found.append(f"<{STANDARD[name]}> for std::{name}")
    return found


@pytest.mark.parametrize("layer", LAYERS)
def test_sources_include_what_they_need(layer):
    lacking = [f"{path.relative_to(ROOT)}: {name}" for path in files(layer, SOURCES - {".h", ".hpp"}) for name in missing(path)]
    assert not lacking, "\n".join(lacking)


@pytest.mark.parametrize("code, expected", [
    ("std::vector<int> numbers;", ["<vector> for std::vector"]),
    ("#include <vector>\nstd::vector<int> numbers;", []),
    ("vtkNew<vtkSphereSource> source;", ["vtkSphereSource.h"]),
    ('#include "vtkSphereSource.h"\nvtkNew<vtkSphereSource> source;', []),
    ("const double gray = ink::unitDouble(7);", ["unitDouble (Hash.h)"]),
    ('#include "Core/Hash.h"\nconst double gray = ink::unitDouble(7);', []),
    ("const auto kind = IsoSuggestion::Boundary::None;", []),
    ("const Boundary boundary;", ["Boundary (Boundary.h)"]),
    # Through another of our headers.
    ('#include "Curves/Streamlines/CombDirections.h"\nstd::vector<int> numbers;', []),
])
def test_what_is_missing_is_found(tmp_path, code, expected):
    source = tmp_path / "Source.cxx"
    source.write_text(f"{code}\n", encoding="utf-8")
    assert missing(source) == expected
