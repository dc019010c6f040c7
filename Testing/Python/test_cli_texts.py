# SPDX-License-Identifier: BSD-3-Clause
"""What ink makes of its own options: completion in shells, and the manual page."""

import os
import pathlib
import re
import shutil
import subprocess

import pytest

pytestmark = pytest.mark.one_build


@pytest.fixture(scope="module")
def options(ink):
    """The options that the whole help of `ink render` names, of all styles."""
    found = set()
    for style in ("illustration", "contours", "line-art", "splatting-lines", "stipple"):
        found |= set(re.findall(r"^  (?:-\w,)?(--[\w-]+)", ink("render", "--style", style, "--help-all").out, re.M))
    assert len(found) > 80
    return found


def completed(ink, tmp_path, *words):
    """What bash makes of some words, the last of which is not yet whole."""
    script = tmp_path / "completion"
    script.write_text(ink("generate", "bash").out)
    code = 'source "$0"; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _ink; printf "%s\\n" "${COMPREPLY[@]}"'
    done = subprocess.run(["bash", "-c", code, script, "ink", *words], capture_output=True, text=True, cwd=tmp_path)
    assert (done.returncode, done.stderr) == (0, ""), done
    return set(filter(None, done.stdout.split("\n")))


def test_bash_completes_commands_and_options(ink, tmp_path, options):
    assert {"render", "style", "sample", "info", "generate"} <= completed(ink, tmp_path, "")
    assert completed(ink, tmp_path, "re") == {"render"}
    assert options <= completed(ink, tmp_path, "render", "--")
    assert completed(ink, tmp_path, "render", "--azi") == {"--azimuth"}
    assert "--tau" not in completed(ink, tmp_path, "info", "--")


def test_bash_completes_words_and_files(ink, tmp_path):
    assert completed(ink, tmp_path, "render", "a.nii", "--view", "") == {"back", "bottom", "front", "iso", "left", "right", "top"}
    assert completed(ink, tmp_path, "render", "a.nii", "--style", "st") == {"stipple"}
    assert {"anatomy", "bone", "engineering"} <= completed(ink, tmp_path, "render", "--preset", "")
    assert {"stipple", "splatting-lines"} <= completed(ink, tmp_path, "style", "")
    (tmp_path / "with space.nii").touch()
    assert "with space.nii" in completed(ink, tmp_path, "render", "with")


def test_zsh_reads_its_completion(ink, tmp_path, options):
    script = ink("generate", "zsh").out
    assert script.startswith("#compdef ink\n")
    assert all(f"'*{option}[" in script for option in options)
    assert "(back bottom front iso left right top)" in script
    if not shutil.which("zsh"):
        return
    (tmp_path / "_ink").write_text(script)
    assert subprocess.run(["zsh", "-n", tmp_path / "_ink"]).returncode == 0


def test_the_manual_page(ink, options):
    page = ink("generate", "man").out
    assert page.startswith('.TH INK 1 "" "vtkInk ')
    plain = page.replace("\\-", "-")
    assert all(f"\\fB{option}\\fR" in plain for option in options)
    for heading in ("NAME", "SYNOPSIS", '"INK render"', '"INK info"', '"EXIT STATUS"'):
        assert f".SH {heading}" in page
    # Every option is there once for a command, or once for each style that has it.
    render = plain.split('.SH "INK render"')[1].split(".SH")[0]
    assert render.count("\\fB--size\\fR") == 1
    found = {}
    for group in render.split(".PP\n"):
        style = re.match(r"(Contours|Illustration|Line Art|Splatting Lines|Stipple)\b|", group)[0]
        found.setdefault(style, []).extend(re.findall(r"^(?:\\fB-\w\\fR, )?\\fB(--[\w-]+)\\fR", group, re.M))
    for style, names in found.items():
        assert len(names) == len(set(names)) > 10, (style, sorted(names))
    assert {style for style, names in found.items() if "--tau" in names} == {"Illustration", "Splatting Lines"}
    # A line that begins with a dot or a quote would be a request.
    requests = {line.split()[0] for line in page.splitlines() if line[:1] in ".'"}
    assert requests <= {".TH", ".SH", ".TP", ".PP", ".B", ".RI", ".br"}


@pytest.mark.parametrize("style", ["contours", "splatting-lines", "stipple"])
def test_the_help_of_options_that_switch_off_says_so(ink, style):
    lines = " ".join(ink("render", "--style", style, "--help-all").out.split())
    negated = re.findall(r"(--no-[\w-]+) (\w+ \w+ \w+)", lines)
    assert negated and all(words in ("switch off that", "do not draw") for _, words in negated)
    assert "switch off that draw" not in lines


def test_installed_texts_are_those_of_ink(ink):
    """CMake keeps them where it installs them from."""
    build = pathlib.Path(os.environ["INK_BUILD"])
    for kind, place in (("man", "share/man/man1/ink.1"), ("bash", "share/bash-completion/completions/ink"),
                        ("zsh", "share/zsh/site-functions/_ink")):  # fmt: skip
        assert (build / place).read_text(encoding="utf-8") == ink("generate", kind).out
