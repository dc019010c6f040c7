# SPDX-License-Identifier: BSD-3-Clause
"""`. Utilities/env.sh` serves one Python and leaves the others as they were."""

import os
import pathlib
import shutil
import subprocess
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PRESET = os.environ.get("INK_PRESET", "headless")


def sourced(code):
    """What a fresh shell prints where the environment was sourced."""
    bash = f'. "{ROOT}/Utilities/env.sh" {PRESET} && {code}'
    # As a person has it who has not sourced it yet.
    plain = {name: value for name, value in os.environ.items() if not name.startswith("INK_") and name != "PYTHONPATH"}
    done = subprocess.run(["bash", "-c", bash], env=plain, capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, ""), done
    return done.stdout


def other_pythons():
    """Interpreters of another version than the one that runs the tests."""
    found = {}
    names = ["python3", *(f"python3.{minor}" for minor in range(8, 20))]
    for path in ["/usr/bin/python3", *map(shutil.which, names)]:
        if path and pathlib.Path(path).exists():
            version = subprocess.run([path, "-c", "import sys; print(sys.version_info[:2])"], capture_output=True, text=True).stdout
            found.setdefault(version.strip(), path)
    found.pop("", None)  # one that is only a name for others
    found.pop(str(sys.version_info[:2]), None)
    return sorted(found.values())


def test_its_own_python_finds_the_package_and_all_that_it_needs():
    pytest.importorskip("vtkink")
    assert "vtkink" in sourced('"$INK_PYTHON" -c "import numpy, vtkink, vtkink.vtk; print(vtkink.__name__)"')


# ParaView's Python is the system's.
if PRESET != "paraview":

    def test_other_pythons_see_no_package_of_this_build():
        for folder in filter(None, sourced('echo -n "$PYTHONPATH"').split(os.pathsep)):
            assert not list(pathlib.Path(folder).rglob("*.so")), folder

    @pytest.mark.parametrize("python", other_pythons())
    def test_other_pythons_work_as_before(python):
        code = f'{python} -c "import sys; print(sys.version_info[:2]); import numpy; print(numpy.__file__)" 2>/dev/null'
        before = subprocess.run(["bash", "-c", code], capture_output=True, text=True).stdout
        assert before, python
        assert sourced(f"{{ {code} || true; }}") == before
