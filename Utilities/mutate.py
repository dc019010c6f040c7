#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Which mistakes would the tests not notice?  Breaks sources in many small ways and runs the tests that cover them.

    Utilities/mutate.py Common/Tone Common/Fields --limit 40      # 40 mutants of each folder, drawn at random
    Utilities/mutate.py Rendering/Stipple/Shaders --time 1200     # as many as 20 minutes allow
    Utilities/mutate.py Common/Tone/Power.cpp:12                  # all of a line; --list only lists them

A mutant is one change: a comparison turned around or moved by its boundary, an operator exchanged, a term, a factor or
a statement dropped, a constant changed. It is killed when a test fails, crashes or hangs; one that survives is either
equivalent, which someone has to judge, or a test is missing. Survivors are printed as PATH:LINE:COLUMN:KIND, which is
also how to run one again.

The mutants are made in build/mutation, a copy of the sources with a build tree of its own (the headless preset at -O1):
the working tree is never touched. Tests run nearest first: those that include the changed file, then those that reach
it by other files; the program is the one of the nearest folder Testing. No known tool does this for C++ and GLSL alike:
universalmutator changes files in place, and mull works on LLVM's code.
"""

import argparse
import collections
import hashlib
import os
import pathlib
import random
import re
import resource
import shlex
import shutil
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
COPY = ROOT / "build" / "mutation"
BUILD = COPY / "build" / "headless"
SOURCES = (".h", ".cpp", ".cxx", ".glsl")
MEMORY = 16 << 30  # bytes of address space; a mutant that wants more has gone wrong
PATIENCE = 10, 30  # a test hangs after that many times its usual time, and seconds

HIDDEN = re.compile(r"//[^\n]*|/\*.*?\*/|\"(?:\\.|[^\"\\\n])*\"|'(?:\\.|[^'\\\n])+'"
                    r"|^[ \t]*#(?:[^\n]*\\\n)*[^\n]*|^[ \t]*(?:template|static_assert|layout|uniform|in|out)\b[^;{]*",
                    re.DOTALL | re.MULTILINE)
SWAPS = {
    "boundary": {"<": "<=", "<=": "<", ">": ">=", ">=": ">"},
    "negation": {"<": ">=", "<=": ">", ">": "<=", ">=": "<", "==": "!=", "!=": "==", "&&": "||", "||": "&&"},
    "operator": {"+": "-", "-": "+", "*": "/", "/": "*", "+=": "-=", "-=": "+=", "*=": "/=", "/=": "*="},
}
OPERATOR = re.compile(r"(?<=\s)(?:[<>=!]=|[-+*/]=|&&|\|\||[-+*/<>])(?=\s)")
FLOAT = re.compile(r"(?<![\w.])(\d+\.\d*(?:e[-+]?\d+)?)(f?)(?!\w)")
INTEGER = re.compile(r"(?<![\w.])(\d+)(u?)(?![\w.'])")
EXTREME = re.compile(r"\b(min|max)(?=\()")
NOT = re.compile(r"!(?=[\w(])")
STATEMENT = re.compile(r"(?<=[;{}])\s*((?:[\w.\[\]]|->)+ [-+*/|&^]?= [^;{}]*|(?:\w|\.|->|::)+\([^;{}]*\));")
# What operands consist of and what ends them.
TOKEN = re.compile(r"(?P<opening>[(\[{])|(?P<closing>[)\]}])|(?P<factor>(?<=\s)[*/](?=\s))"
                   r"|(?P<end>[,;?]|(?<!:):(?!:)|(?<=\s)(?:[-+<>=!&|%^]|[*/]=)+(?=\s))")

Mutant = collections.namedtuple("Mutant", "name path start end text")


def code_of(text):
    """The same text, with blanks for what is not to be changed."""
    return HIDDEN.sub(lambda found: re.sub(r"[^\n]", " ", found.group()), text)


def end_of_operand(code, start, is_term):
    """Where the term, or else the factor, that begins at start ends."""
    depth = 0
    for token in TOKEN.finditer(code, start):
        depth += token.lastgroup == "opening"
        depth -= token.lastgroup == "closing"
        if depth < 0 or depth == 0 and (token.lastgroup == "end" or token.lastgroup == "factor" and not is_term):
            return token.start()
    return len(code)


def changes(code):
    """All (kind, start, end, new text)."""
    for found in OPERATOR.finditer(code):
        for kind, swaps in SWAPS.items():
            if found.group() in swaps:
                yield kind, *found.span(), swaps[found.group()]
        if found.group() in "+-*":
            end = end_of_operand(code, found.end(), found.group() != "*")
            yield "drop", found.start(), len(code[:end].rstrip()), ""
    for found in FLOAT.finditer(code):
        yield "constant", *found.span(), f"{2.0 * float(found[1]) or 1.0!r}{found[2]}"
    for found in INTEGER.finditer(code):
        yield "constant", *found.span(), f"{int(found[1]) + 1}{found[2]}"
    for found in EXTREME.finditer(code):
        yield "extreme", *found.span(), "max" if found[1] == "min" else "min"
    for found in NOT.finditer(code):
        yield "not", *found.span(), ""
    for found in STATEMENT.finditer(code):
        yield "statement", *found.span(1), ""


def mutants_of(path):
    text = (ROOT / path).read_text(encoding="utf-8")
    for kind, start, end, new in sorted(changes(code_of(text))):
        line = text.count("\n", 0, start) + 1
        yield Mutant(f"{path}:{line}:{start - text.rfind(chr(10), 0, start)}:{kind}", path, start, end, new)


def begins_with(name, part):
    """Whether a mutant lies in a folder, file, line or column."""
    return name == part or name.startswith(part) and name[len(part)] in "/:"


def copy_sources():
    """Brings the copy up to date; what did not change keeps its time, and so is not built again."""
    listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard"], cwd=ROOT, check=True, capture_output=True, text=True)
    kept = {path for path in listed.stdout.splitlines() if (ROOT / path).is_file()}
    for path in kept:
        source, target = ROOT / path, COPY / path
        if not target.exists() or source.read_bytes() != target.read_bytes():
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(source, target)
    for target in COPY.rglob("*"):
        path = target.relative_to(COPY)
        if target.is_file() and path.parts[0] != "build" and str(path) not in kept:
            target.unlink()
    vtk = COPY / "build" / "vtk-headless"
    if not vtk.exists():
        vtk.parent.mkdir(parents=True, exist_ok=True)
        vtk.symlink_to((ROOT / "build" / "vtk-headless").resolve())
    return kept


def configure():
    subprocess.run(["cmake", "--preset", "headless", "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG", "-DVTKINK_WARNINGS_AS_ERRORS=OFF",
                    "-DVTKINK_BUILD_BENCHMARKS=OFF", "-DVTKINK_WRAP_PYTHON=OFF",
                    "-DCMAKE_GTEST_DISCOVER_TESTS_DISCOVERY_MODE=PRE_TEST"], cwd=COPY, check=True, stdout=subprocess.DEVNULL)


def build(program, jobs):
    return subprocess.run(["cmake", "--build", BUILD, "--target", program, "--parallel", str(jobs)], capture_output=True, text=True)


def built(program):
    """What the compiler made: the same for a mutant that it sees to be equivalent."""
    file = BUILD / "bin" / program
    loaded = subprocess.run(["ldd", file], check=True, capture_output=True, text=True).stdout
    own = re.findall(rf"{re.escape(str(BUILD))}/\S+", loaded)
    return [hashlib.sha256(pathlib.Path(part).read_bytes()).digest() for part in [file, *own]]


class Test:
    """The tests in a source file of a test program."""

    def __init__(self, program, path):
        self.program, self.path, self.seconds = program, path, 0.0
        names = re.findall(r"^(?:TYPED_)?TEST(?:_[FP])?\((\w+), (\w+)\)", path.read_text(encoding="utf-8"), re.MULTILINE)
        wanted = ":".join(f"{suite}.{name}:*/{suite}.{name}/*:{suite}/*.{name}" for suite, name in names)
        self.arguments = [f"--gtest_filter={wanted}", "--gtest_fail_fast", "--gtest_brief=1"]

    def run(self):
        """Whether it passes, and what it says."""
        command = shlex.join([str(BUILD / "bin" / self.program), *self.arguments])
        start = time.monotonic()
        process = subprocess.Popen(["bash", "-c", f". Utilities/env.sh headless && exec {command}"], cwd=COPY, text=True,
                                   errors="replace", stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                   preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY)))
        try:
            said, _ = process.communicate(timeout=PATIENCE[0] * self.seconds + PATIENCE[1] if self.seconds else None)
        except subprocess.TimeoutExpired:
            process.kill()
            process.communicate()
            return False, "hangs"
        self.seconds = self.seconds or time.monotonic() - start
        return process.returncode == 0, said


class Coverage:
    """Which tests reach a file, by includes; a header and the source (or shader) of the same name are one."""

    def __init__(self, paths):
        self.includes = collections.defaultdict(set)
        self.tests = {}
        for path in paths:
            if path.endswith(SOURCES):
                text = (ROOT / path).read_text(encoding="utf-8")
                self.includes[pathlib.Path(path).stem] |= set(re.findall(r'^#include ["<](?:[^">]*/)?(\w+)\.h[">]', text, re.MULTILINE))

    def tests_beside(self, path):
        """The tests of the nearest folder Testing."""
        for folder in path.parents:
            for testing in (folder / "Testing", folder / "Testing" / "Cxx"):
                if testing in self.tests:
                    return self.tests[testing]
                lists = testing / "CMakeLists.txt"
                if lists.exists() and (found := re.findall(r"ink_add_gtest\((\w+)\s+(?:OPENGL\s+)?SOURCES\s+((?:[\w/]+\.c\w+\s+)+)",
                                                           lists.read_text(encoding="utf-8"))):
                    self.tests[testing] = [Test(program, testing / source)
                                           for program, sources in found for source in sources.split()]
                    return self.tests[testing]
        sys.exit(f"mutate.py: no tests beside {path}")

    def distance(self, test, stem):
        reached, edge = {test}, [test]
        for steps in range(len(self.includes)):
            if stem in reached:
                return steps
            edge = {name for from_ in edge for name in self.includes.get(from_, ())} - reached
            reached |= edge
        return None

    def tests_of(self, path):
        """Of the program with the nearest test those that reach the file, nearest first; all where none does by includes."""
        stem = pathlib.Path(path).stem
        tests = self.tests_beside(ROOT / path)
        far = {test: steps for test in tests if (steps := self.distance(test.path.stem, stem)) is not None}
        found = sorted(far, key=far.get) or tests
        return [test for test in found if test.program == found[0].program]


def result_of(mutant, tests, original, jobs):
    program = tests[0].program
    if build(program, jobs).returncode != 0:
        return "no program"
    if built(program) == original[program]:
        return "equivalent"
    for test in tests:
        passed, said = test.run()
        if re.search(r"vtkShaderProgram.*\berror\b", said):
            return "no program"
        if not passed:
            return "killed"
    return "survived"


def sample(paths, without, limit, seed):
    """Of each path that many mutants, in turns, so that a run that is cut short has of each as many."""
    files = [str(file.relative_to(ROOT)) for path in paths
             for place in [ROOT / path.split(":")[0]] for file in (sorted(place.rglob("*")) if place.is_dir() else [place])
             if file.suffix in SOURCES]
    if not files:
        sys.exit(f"mutate.py: no sources in {' '.join(paths)}")
    everything = [mutant for file in dict.fromkeys(files) if not any(begins_with(file, part) for part in without)
                  for mutant in mutants_of(file)]
    drawn = []
    for path in paths:
        found = [mutant for mutant in everything if begins_with(mutant.name, path)]
        random.Random(seed).shuffle(found)
        drawn.append((path, found[:limit]))
    return [(path, found[turn]) for turn in range(max(len(found) for _, found in drawn)) for path, found in drawn if turn < len(found)]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("paths", nargs="+", metavar="PATH", help="folder, file, FILE:LINE or a mutant's name, from the repository's root")
    parser.add_argument("--without", nargs="+", default=[], metavar="PATH", help="folders or files to leave out")
    parser.add_argument("--limit", type=int, help="mutants of each path (default: all)")
    parser.add_argument("--time", type=float, default=float("inf"), help="seconds for all mutants, without the first build")
    parser.add_argument("--seed", type=int, default=1, help="of the choice of mutants (default: 1)")
    parser.add_argument("--jobs", type=int, default=int(os.environ.get("INK_JOBS", 2)), help="compilers at once (default: INK_JOBS or 2)")
    parser.add_argument("--list", action="store_true", help="only list the mutants")
    options = parser.parse_args()
    paths, without = ([path.rstrip("/") for path in some] for some in (options.paths, options.without))
    chosen = sample(paths, without, options.limit, options.seed)
    if options.list:
        print("\n".join(mutant.name for _, mutant in chosen))
        return

    coverage = Coverage(copy_sources())
    tests = {mutant.path: coverage.tests_of(mutant.path) for _, mutant in chosen}
    configure()
    original = {}
    for program in sorted({found[0].program for found in tests.values()}):
        if (done := build(program, options.jobs)).returncode != 0:
            sys.exit(done.stdout)
    for test in {test for found in tests.values() for test in found}:
        original.setdefault(test.program, built(test.program))
        passed, said = test.run()
        if not passed:
            sys.exit(f"mutate.py: {test.path.name} fails without any change\n{said}")

    os.environ["CCACHE_READONLY"] = "1"  # where there is a compiler cache, it has what is needed again
    results = collections.defaultdict(collections.Counter)
    end = time.monotonic() + options.time
    for path, mutant in chosen:
        if time.monotonic() > end:
            results[path]["not run"] += 1
            continue
        target = COPY / mutant.path
        text = target.read_text(encoding="utf-8")
        target.write_text(text[:mutant.start] + mutant.text + text[mutant.end:], encoding="utf-8")
        start = time.monotonic()
        result = result_of(mutant, tests[mutant.path], original, options.jobs)
        target.write_text(text, encoding="utf-8")
        results[path][result] += 1
        was = " ".join(text[mutant.start:mutant.end].split())
        print(f"{result:11}{time.monotonic() - start:5.0f} s  {mutant.name}  {was}  ->  {mutant.text or 'nothing'}", flush=True)

    print(f"\n{'':44}killed  survived  score  equivalent  no program  not run")
    for path, count in results.items():
        judged = count["killed"] + count["survived"]
        score = f"{100 * count['killed'] / judged:.0f}%" if judged else "-"
        print(f"{path:44}{count['killed']:6}{count['survived']:10}{score:>7}{count['equivalent']:12}{count['no program']:12}"
              f"{count['not run']:9}")


if __name__ == "__main__":
    main()
