# SPDX-License-Identifier: BSD-3-Clause
"""How many compilers and tests Utilities/jobs.sh lets run at once."""

import os
import pathlib
import subprocess

import pytest

pytestmark = pytest.mark.one_build

JOBS = pathlib.Path(__file__).resolve().parents[2] / "Utilities" / "jobs.sh"


def jobs(tmp_path, processors, memory, **environment):
    """What jobs.sh prints on a machine of so many processors and GiB."""
    (tmp_path / "nproc").write_text(f"#!/bin/sh\necho {processors}\n")
    (tmp_path / "nproc").chmod(0o755)
    # The kernel keeps some of a machine's memory to itself.
    (tmp_path / "meminfo").write_text(f"MemTotal: {int(memory * 1024 * 1024 * 0.96)} kB\nMemFree: 1 kB\n")
    environment = {
        "PATH": f"{tmp_path}:{os.environ['PATH']}",
        "INK_MEMINFO": str(tmp_path / "meminfo"),
        "INK_MEMORY_LIMIT": str(tmp_path / "limit"),
    } | environment
    return int(subprocess.run([str(JOBS)], env=environment, capture_output=True, text=True, check=True).stdout)


def test_each_processor_where_memory_allows(tmp_path):
    assert jobs(tmp_path, 8, 64) == 8
    assert jobs(tmp_path, 2, 4) == 2


def test_two_gibibytes_each(tmp_path):
    assert jobs(tmp_path, 8, 8) == 4
    assert jobs(tmp_path, 64, 16) == 8


def test_one_at_least(tmp_path):
    assert jobs(tmp_path, 4, 1) == 1


def test_what_a_container_is_allowed(tmp_path):
    (tmp_path / "limit").write_text(f"{6 * 2**30}\n")
    assert jobs(tmp_path, 8, 64) == 3
    (tmp_path / "limit").write_text("max\n")
    assert jobs(tmp_path, 8, 64) == 8
    (tmp_path / "limit").write_text("9223372036854771712\n")
    assert jobs(tmp_path, 8, 64) == 8


def test_ink_jobs_wins(tmp_path):
    assert jobs(tmp_path, 8, 64, INK_JOBS="11") == 11
