# SPDX-License-Identifier: BSD-3-Clause
"""Utilities/mutate.py: which mutants it makes, and that a sample is the same whenever it is drawn."""

import importlib.util
import pathlib

import pytest

pytestmark = pytest.mark.one_build

ROOT = pathlib.Path(__file__).resolve().parents[2]
SPEC = importlib.util.spec_from_file_location("mutate", ROOT / "Utilities" / "mutate.py")
mutate = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(mutate)


def mutants(code):
    return {code[:start] + new + code[end:] for _, start, end, new in mutate.changes(mutate.code_of(code))}


def test_every_kind_of_mutant():
    assert mutants("x = a + b * f(c - 2, d);") == {
        "x = a - b * f(c - 2, d);", "x = a ;", "x = a + b / f(c - 2, d);", "x = a + b ;",
        "x = a + b * f(c + 2, d);", "x = a + b * f(c , d);", "x = a + b * f(c - 3, d);"}
    assert mutants("return a < b && !c;") == {
        "return a <= b && !c;", "return a >= b && !c;", "return a < b || !c;", "return a < b && c;"}
    assert mutants("f(std::min(a, 0.5f), 0.0);") == {
        "f(std::max(a, 0.5f), 0.0);", "f(std::min(a, 1.0f), 0.0);", "f(std::min(a, 0.5f), 1.0);"}
    assert mutants("{\n  a.b[i] += c;\n}") == {"{\n  a.b[i] -= c;\n}", "{\n  ;\n}"}


def test_what_is_not_code_is_left_alone():
    assert not mutants('// a < b\n/* 1 + 2 */ const char* s = "3 * 4";\n#if X > 5\ntemplate <int N = 2>\n')
    assert not mutants("void f(const T* a, T&& b, std::vector<int> c);\nuniform vec4 planes[6];\n")
    assert not mutants("const float4 v3 = x1;")


def test_samples_are_seeded():
    paths = ["Common/Tone", "Rendering/Stipple/Shaders"]
    names = [mutant.name for _, mutant in mutate.sample(paths, [], 5, 7)]
    assert names == [mutant.name for _, mutant in mutate.sample(paths, [], 5, 7)]
    assert names != [mutant.name for _, mutant in mutate.sample(paths, [], 5, 8)]
    assert [name.startswith("Common/Tone/") for name in names] == 5 * [True, False]
    assert [mutant.name for _, mutant in mutate.sample(names[:1], [], None, 1)] == names[:1]
    assert not any("Tone.cpp" in mutant.name
                   for _, mutant in mutate.sample(["Common/Tone"], ["Common/Tone/Stipple/Tone.cpp"], None, 1))


def test_coverage_follows_includes():
    coverage = mutate.Coverage([str(path.relative_to(ROOT)) for folder in ("Common", "Rendering", "Testing")
                                for path in (ROOT / folder).rglob("*") if path.suffix in mutate.SOURCES])
    tests = coverage.tests_of("Common/Tone/Power.cpp")
    assert tests[0].path.name == "TestToneFactors.cpp" and {test.program for test in tests} == {"CommonTests"}
    assert "TestStippleTone.cpp" in {test.path.name for test in tests}
    assert "TestThin.cpp" not in {test.path.name for test in tests}
    assert {test.program for test in coverage.tests_of("Common/Fields/Vdb/VdbField.cpp")} == {"CommonVDBTests"}
    shader = coverage.tests_of("Rendering/Stipple/Shaders/InkStippleVS.glsl")
    assert shader and {test.program for test in shader} == {"StippleTests"}
