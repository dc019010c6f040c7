#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Configures a preset and builds all of it, or some targets only:
#   Utilities/build.sh headless|paraview|asan|tsan|aarch64 [--target NAME]... [more CMake arguments]
# What is left is built by the next call without --target, in the same tree. Utilities/jobs.sh says how many compilers
# run at once. INK_UNITY_BUILD is VTKINK_UNITY_BUILD where it makes a new tree.
set -euo pipefail

preset="${1:?usage: Utilities/build.sh headless|paraview|asan|tsan|aarch64 [--target NAME]... [CMake arguments]}"
shift
root="$(cd "$(dirname "$0")/.." && pwd)"
cd "$root"

targets=()
while [ "${1:-}" = --target ]; do
  targets+=("${2:?build.sh: --target needs a name}")
  shift 2
done

if [ "$preset" != paraview ] && [ "$preset" != aarch64 ]; then
  if python="$(Utilities/find-python.sh)"; then
    set -- "-DPython3_EXECUTABLE=$python" "$@"
  else
    echo "build: left out of $preset: the Python package vtkink, as VTK 9.7's wrapping needs Python >= 3.12 with headers" \
      "(name one in INK_HEADLESS_PYTHON)"
  fi
fi

if [ -n "${INK_UNITY_BUILD:-}" ] && [ ! -e "build/$preset/CMakeCache.txt" ]; then
  set -- "-DVTKINK_UNITY_BUILD=$INK_UNITY_BUILD" "$@"
fi

# Common is compiled once for builds with either VTK; paths below the root are relative, as build trees are named.
if [ -z "${CMAKE_CXX_COMPILER_LAUNCHER:-}" ] && command -v ccache >/dev/null; then
  set -- "-DVTKINK_COMMON_LAUNCHER=cmake;-E;env;CCACHE_DIR=$root/build/ccache;CCACHE_DEPEND=1;CCACHE_BASEDIR=$root;ccache" "$@"
fi

log="build/$preset.log"
mkdir -p build
echo "build: configuring $preset (what CMake says goes to $log)"
if ! cmake --preset "$preset" "$@" >"$log" 2>&1; then
  cat "$log" >&2
  exit 1
fi
jobs="$(Utilities/jobs.sh)"
echo "build: building ${targets[*]:-all} of $preset, $jobs at once"
# Ninja's own lines, with what part is done and after how many seconds.
export NINJA_STATUS="${NINJA_STATUS:-[%f of %t, %e s] }"
cmake --build --preset "$preset" --parallel "$jobs" ${targets[@]+--target "${targets[@]}"}
