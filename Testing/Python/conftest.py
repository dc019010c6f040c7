# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of `ink` share. Run them in the environment of a build tree: . Utilities/env.sh PRESET"""

import hashlib
import os
import pathlib
import re
import subprocess
import sys
from dataclasses import dataclass

import pytest

# Processes of pytest share the cores already, and OpenBLAS's threads take them where its matrices are small, too. Before
# NumPy is loaded.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import ink_files  # noqa: E402

# What benchmarks measure with is tested, too.
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "Benchmarks"))


@dataclass
class Result:
    code: int
    out: str
    err: str

    @property
    def error(self):
        """The message, after checking that it is the one line that is promised."""
        lines = self.err.splitlines()
        assert len(lines) == 1, f"expected one line on stderr, found {self.err!r}"
        assert lines[0].startswith("ink: error: "), lines[0]
        return lines[0]


# For what hangs: runs take less than a tenth of it, also where two share a core.
TIME_LIMIT = 600


def run_ink(*arguments, env=None, **keywords):
    done = subprocess.run(["ink", *map(str, arguments)], capture_output=True, text=True, timeout=TIME_LIMIT,
                          env={**os.environ, **(env or {})}, **keywords)
    return Result(done.returncode, done.stdout, done.stderr)


def pytest_configure(config):
    config.addinivalue_line("markers", "one_build: what neither VTK's version nor its window changes; see CONTRIBUTING.md")


# What no setup brings: these tests may be skipped also where CI=true.
NOT_PROMISED = (
    "built with OpenVDB|root may read everything|this VTK draws without a display|ffmpeg lies beside ink"
    "|no pseudo-terminals here|PyVista needs a newer VTK|could not import 'vtkink'"
)


@pytest.hookimpl(hookwrapper=True)
def pytest_runtest_makereport(item, call):
    """Where CI=true, what setup brings has to be there: a test that is skipped for lack of it fails."""
    report = (yield).get_result()
    if report.skipped and not hasattr(report, "wasxfail") and os.environ.get("CI") == "true":
        reason = report.longrepr[2]
        if not re.search(NOT_PROMISED, reason):
            report.outcome, report.longrepr = "failed", f"CI=true, and {reason}"


@pytest.fixture(scope="session")
def ink():
    """Runs ink with some arguments."""
    return run_ink


@pytest.fixture(scope="session")
def shared_pictures(tmp_path_factory):
    """A folder that all processes of this run have in common."""
    folder = tmp_path_factory.getbasetemp()
    folder = (folder.parent if "PYTEST_XDIST_WORKER" in os.environ else folder) / "shared-pictures"
    folder.mkdir(exist_ok=True)
    return folder


@pytest.fixture
def picture(tmp_path, volume_file, mesh_file, shared_pictures):
    """Renders a file to 200 x 200 pixels and returns them. A picture of the files below with the same options is drawn once
    for all tests, but again where one test asks for it again."""
    seen = set()

    def render(file, *arguments, size="200x200"):
        shared = file in (volume_file, mesh_file) and not any(isinstance(argument, pathlib.Path) for argument in arguments)
        words = "\n".join(map(str, [pathlib.Path(file).name, size, *arguments]))
        kept = shared_pictures / f"{hashlib.sha256(words.encode()).hexdigest()}.png"
        if not shared or words in seen or not kept.exists():
            out = tmp_path / "picture.png"
            result = run_ink("render", file, "--size", size, "--quiet", "-o", out, *arguments)
            assert (result.code, result.out, result.err) == (0, "", ""), result
            if not shared:
                return ink_files.read_png(out)
            # In one step: another process may read it.
            out.replace(kept)
        seen.add(words)
        return ink_files.read_png(kept)

    return render


@pytest.fixture(scope="session")
def volume_file(tmp_path_factory):
    """A small volume that can be read and drawn."""
    path = tmp_path_factory.mktemp("volume") / "blob.vti"
    ink_files.write_vti(path, ink_files.blob())
    return path


@pytest.fixture(scope="session")
def mesh_file(tmp_path_factory):
    """A sphere with normals that can be read and drawn."""
    path = tmp_path_factory.mktemp("mesh") / "ball.ply"
    ink_files.write_ply(path, ink_files.sphere_mesh(), normals=True)
    return path
