#!/usr/bin/env bash
# Configures and builds one preset:  Utilities/build.sh headless|paraview|asan|tsan [more CMake arguments]
set -euo pipefail

preset="${1:?usage: Utilities/build.sh headless|paraview|asan|tsan [CMake arguments]}"
shift
root="$(cd "$(dirname "$0")/.." && pwd)"
cd "$root"

if [ "$preset" != paraview ]; then
  if python="$(Utilities/find-python.sh)"; then
    set -- "-DPython3_EXECUTABLE=$python" "$@"
  else
    echo "build: left out of $preset: the Python package vtkink, as VTK 9.7's wrapping needs Python >= 3.12 with headers" \
      "(name one in INK_HEADLESS_PYTHON)"
  fi
fi

log="build/$preset.log"
mkdir -p build
if ! cmake --preset "$preset" "$@" >"$log" 2>&1; then
  cat "$log" >&2
  exit 1
fi
# More than two compilers at once need more memory than a small machine has.
cmake --build --preset "$preset" --parallel "${INK_JOBS:-2}"
