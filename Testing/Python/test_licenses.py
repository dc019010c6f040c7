# SPDX-License-Identifier: BSD-3-Clause
"""Every text file says under which license it is: in its first line, or after the line that names its interpreter;
JSON, which has no comments, among its first keys."""

import json
import pathlib
import re
import subprocess

import pytest

pytestmark = pytest.mark.one_build

ROOT = pathlib.Path(__file__).resolve().parents[2]
LICENSE = "SPDX-License-Identifier: BSD-3-Clause"
# A line of comment in the files whose names match.
COMMENTS = {
    "// {}": re.compile(r"\.(h|hpp|cxx|cpp|glsl)(\.in)?$"),
    "# {}": re.compile(
        r"(\.(cmake|module|plugin|py|sh|supp)(\.in)?|CMakeLists\.txt|packages/[\w-]+\.txt|Makefile|\.clang[a-z-]*|\.gitignore|\.ci/run)$"),
    "<!-- {} -->": re.compile(r"\.(xml(\.in)?|md)$"),
    "% {}": re.compile(r"\.bib$"),
}
# Data that tests read, some of it broken.
CORPUS = "Testing/Fuzz/Corpus/"


def listed_files():
    """The repository's files, those that git does not know yet included."""
    listed = subprocess.run(
        ["git", "ls-files", "--cached", "--others", "--exclude-standard"],
        cwd=ROOT, capture_output=True, text=True, check=False,
    )
    if listed.returncode == 0:
        names = listed.stdout.splitlines()
    else:
        # An unpacked archive, or git that does not trust who owns the folder.
        names = [str(path.relative_to(ROOT)) for path in ROOT.rglob("*") if path.is_file()]
    return [name for name in names if not re.match(r"(build|\.git)/", name) and (ROOT / name).is_file()]


def sources():
    """The files that can hold a comment, and how a line of it is written in them."""
    for name in listed_files():
        for comment, pattern in COMMENTS.items():
            if pattern.search(name) and not name.startswith(CORPUS):
                yield name, comment.format(LICENSE)


def test_json_names_its_license():
    tables = [name for name in listed_files() if name.endswith(".json") and not name.startswith(CORPUS)]
    assert tables
    without = []
    for name in tables:
        root = json.loads((ROOT / name).read_text(encoding="utf-8"))
        # What CMake does not know goes under "vendor".
        if {**root, **root.get("vendor", {})}.get("SPDX-License-Identifier") != "BSD-3-Clause":
            without.append(name)
    assert not without, "no SPDX-License-Identifier in:\n" + "\n".join(without)


def test_every_source_names_its_license():
    found = list(sources())
    for suffix in (".h", ".cxx", ".cpp", ".glsl", ".cmake", "CMakeLists.txt", ".py", ".sh", ".module", ".xml", ".bib", ".md"):
        assert any(name.endswith(suffix) for name, _ in found), f"no {suffix} files: is the list right?"
    without = []
    for name, comment in found:
        lines = (ROOT / name).read_text(encoding="utf-8").splitlines()
        first = lines[1:2] if lines and lines[0].startswith("#!") else lines[:1]
        if first != [comment]:
            without.append(name)
    assert not without, f"no '{LICENSE}' at the start of:\n" + "\n".join(without)
