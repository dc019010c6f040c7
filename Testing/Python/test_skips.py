# SPDX-License-Identifier: BSD-3-Clause
"""What setup promises has to be there where CI=true: a test that is skipped for lack of it fails."""

import os
import pathlib
import shutil
import subprocess
import sys

import pytest

pytestmark = pytest.mark.one_build

HERE = pathlib.Path(__file__).resolve().parent
TESTS = """
import pytest

@pytest.mark.skipif(True, reason="PyVista is not installed")
def test_promised():
    pass

def test_promised_in_a_fixture(missing):
    pass

@pytest.fixture
def missing():
    pytest.skip("built without OpenVDB")

def test_of_another_build():
    pytest.skip("built with OpenVDB")

@pytest.mark.xfail
def test_expected():
    assert False
"""


@pytest.mark.parametrize("ci, outcomes, code", [("true", ["1 skipped", "1 xfailed", "2 errors"], 1), ("", ["3 skipped", "1 xfailed"], 0)])
def test_skips_are_failures_where_setup_is_complete(tmp_path, ci, outcomes, code):
    for name in ("conftest.py", "ink_files.py"):
        shutil.copy(HERE / name, tmp_path)
    (tmp_path / "test_some.py").write_text(TESTS)
    result = subprocess.run([sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "-p", "no:xdist", str(tmp_path)],
                            capture_output=True, text=True, env={**os.environ, "CI": ci}, cwd=tmp_path)  # fmt: skip
    assert result.stdout.splitlines()[-1].split(" in ")[0] == ", ".join(outcomes), result.stdout
    assert result.returncode == code
