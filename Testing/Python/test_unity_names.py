# SPDX-License-Identifier: BSD-3-Clause
"""Names in anonymous namespaces differ within a folder: `make test` compiles its sources together, other builds do not."""

import re

import pytest

from test_includes import text_of
from test_layering import LAYERS, ROOT, SOURCES, files

pytestmark = pytest.mark.one_build


def anonymous(code):
    """The text of a source's anonymous namespaces, without what lies deeper in braces."""
    found, depth = [], 0
    for start in re.finditer(r"^\s*namespace\s*\{", code, re.MULTILINE):
        begin, depth = start.end(), 1
        for position in range(begin, len(code)):
            depth += {"{": 1, "}": -1}.get(code[position], 0)
            if depth == 1 and code[position] != "}":
                found.append(code[position])
            if depth == 0:
                break
        found.append("\n")
    return "".join(found)


def names(path):
    """Types, constants, functions with their parameters, and aliases, of which one type may have the same in several files."""
    code = anonymous(text_of(path))
    found = set(re.findall(r"\b(?:struct|class|enum) (\w+)(?= *[\n:{])", code))
    found |= set(re.findall(r"^ *(?:constexpr|const|static)\b[\w:<>&* ]* (\w+)(?=\[| *=| *\{)", code, re.MULTILINE))
    for name, parameters in re.findall(r"^ *[\w:<>&*, ]*[\w>&*]\s+[&*]?(\w+)\(([^()]*)\)", code, re.MULTILINE):
        types = re.sub(r"[ \n]*\w+(?=,|$)", "", re.sub(r"\s+", " ", parameters)).strip()
        found.add(f"{name}({types})")
    meanings = dict.fromkeys(found, path.name)
    return meanings | {name: " ".join(type.split()) for name, type in re.findall(r"\busing (\w+) =([^;]*);", code)}


def shared(folder):
    """What several sources of a folder call alike."""
    users = {}
    for path in folder:
        for name, meaning in names(path).items():
            users.setdefault(name, {}).setdefault(meaning, path.name)
    return [f"{name}: {', '.join(sorted(paths.values()))}" for name, paths in sorted(users.items()) if len(paths) > 1]


@pytest.mark.parametrize("layer", LAYERS)
def test_sources_of_a_folder_compile_together(layer):
    folders = {}
    for path in files(layer, SOURCES - {".h", ".hpp"}):
        folders.setdefault(path.parent, []).append(path)
    found = [f"{folder.relative_to(ROOT)}: {line}" for folder, paths in folders.items() for line in shared(paths)]
    assert not found, "\n".join(found)


@pytest.mark.parametrize("first, second, expected", [
    ("template <class T>\nstruct Slices\n{\n  T at;\n};", "struct Slices\n{\n};", ["Slices"]),
    ("constexpr int most = 8;", "constexpr double most = .5;", ["most"]),
    ("int half(int whole)\n{\n  return whole / 2;\n}", "int half(\n  int all)\n{\n  return all / 2;\n}", ["half(int)"]),
    ("using Views = std::array<int, 5>;", "using Views = std::array<int, 4>;", ["Views"]),
    ("using Views = std::array<int, 5>;", "constexpr std::array Views = { 1, 2 };", ["Views"]),
    ("using Word = int;", "using  Word =\n  int;", []),
    # Functions with other parameters, names in functions and in other files.
    ("int half(int whole)\n{\n  return whole / 2;\n}", "double half(double all)\n{\n  return all / 2;\n}", []),
    ("int a()\n{\n  const int x = 1;\n  return x;\n}", "int b()\n{\n  const int x = 1;\n  return x;\n}", []),
])
def test_shared_names_are_found(tmp_path, first, second, expected):
    paths = []
    for index, code in enumerate((first, second)):
        paths.append(tmp_path / f"{index}.cpp")
        paths[-1].write_text(f"namespace ink\n{{\nnamespace\n{{\n{code}\n}}\n}}\n", encoding="utf-8")
    assert [line.split(":")[0] for line in shared(paths)] == expected
