# SPDX-License-Identifier: BSD-3-Clause
"""Every source file says in its first line, or after the line that names its interpreter, under which license it is."""

import pathlib
import re
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
LICENSE = "SPDX-License-Identifier: BSD-3-Clause"
# How a comment starts in the files whose names match.
COMMENTS = {
    "//": re.compile(r"\.(h|hpp|cxx|cpp|glsl)(\.in)?$"),
    "#": re.compile(r"(\.(cmake|py|sh)(\.in)?|CMakeLists\.txt|Makefile)$"),
}


def sources():
    """The repository's files, those that git does not know yet included, and how a comment starts in them."""
    listed = subprocess.run(
        ["git", "ls-files", "--cached", "--others", "--exclude-standard"],
        cwd=ROOT, capture_output=True, text=True, check=False,
    )
    if listed.returncode == 0:
        names = listed.stdout.splitlines()
    else:
        # An unpacked archive, or git that does not trust who owns the folder.
        names = [str(path.relative_to(ROOT)) for path in ROOT.rglob("*") if path.is_file()]
    for name in names:
        if not re.match(r"(build|\.git)/", name) and (ROOT / name).is_file():
            for mark, pattern in COMMENTS.items():
                if pattern.search(name):
                    yield name, mark


def test_every_source_names_its_license():
    found = list(sources())
    for suffix in (".h", ".cxx", ".cpp", ".glsl", ".cmake", "CMakeLists.txt", ".py", ".sh"):
        assert any(name.endswith(suffix) for name, _ in found), f"no {suffix} files: is the list right?"
    without = []
    for name, mark in found:
        lines = (ROOT / name).read_text(encoding="utf-8").splitlines()
        first = lines[1:2] if lines and lines[0].startswith("#!") else lines[:1]
        if first != [f"{mark} {LICENSE}"]:
            without.append(name)
    assert not without, f"no '{LICENSE}' at the start of:\n" + "\n".join(without)
