#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Runs all tests of one built preset:  Utilities/test.sh headless|paraview|asan|tsan [ctest arguments]
# As many at a time as Utilities/jobs.sh says. The paraview preset draws into an X server of its own, the others need no
# display. The last lines name what could not be tested; where CI=true, what Utilities/setup.sh installs has to be there.
set -euo pipefail

preset="${1:?usage: Utilities/test.sh headless|paraview|asan|tsan [ctest arguments]}"
shift
cd "$(dirname "$0")/.."
. Utilities/env.sh "$preset"

jobs="$(Utilities/jobs.sh)"
# The tests share the cores already: Mesa draws without threads of its own.
export LP_NUM_THREADS="${LP_NUM_THREADS:-0}"

on_display()
{
  if [ "$preset" = paraview ]; then
    xvfb-run -a -s "-noreset -screen 0 1600x1200x24" "$@"
  else
    "$@"
  fi
}

failed=""
left_out=()
missing()
{
  left_out+=("$1")
  [ "${CI:-}" != true ] || failed="$failed ($1)"
}

# What was skipped one by one, from the output of ctest and of pytest.
list_skipped()
{
  local line
  while read -r line; do
    left_out+=("$line")
  done < <(sed -nE 's/^[[:space:]]*[0-9]+ - (.*) \((Skipped|Disabled|Not Run)\)$/\1/p; s/^SKIPPED \[[0-9]+\] //p' "$1")
}
log="$(mktemp)"
trap 'rm -f "$log"' EXIT

if [ "$INK_BUILD_WRAPPED" != ON ]; then
  # VTK 9.7 asks for a newer Python than setup can bring everywhere; sanitizers go without one.
  wrapped="the Python package vtkink: no Python that this VTK can be wrapped for, or VTKINK_WRAP_PYTHON=OFF"
  if [ "$preset" = paraview ] || { [ "$preset" = headless ] && Utilities/find-python.sh >/dev/null; }; then
    missing "$wrapped"
  else
    left_out+=("$wrapped")
  fi
elif ! "$INK_PYTHON" -c 'import vtkink'; then
  failed="$failed vtkink"
fi
[ "$INK_BUILD_OPENVDB" = ON ] || missing "OpenVDB: VTKINK_ENABLE_OPENVDB=OFF"
command -v glslangValidator >/dev/null || missing "all forms of the shaders: no glslangValidator"
[ "$preset" != paraview ] || [ -x "$INK_BUILD_MPIEXEC" ] || missing "ParaView on several ranks: no mpiexec"

echo "test: $preset (VTK $INK_BUILD_VTK_VERSION): C++"
on_display ctest --preset "$preset" --parallel "$jobs" "$@" 2>&1 | tee "$log" || failed="$failed ctest"
list_skipped "$log"

if "$INK_PYTHON" -c 'import numpy, pytest, xdist' 2>/dev/null; then
  echo "test: $preset (VTK $INK_BUILD_VTK_VERSION): ink and Python"
  # Among Mesa's ending threads the leak checker crashes now and then, in one of some hundred runs of ink.
  export ASAN_OPTIONS="${ASAN_OPTIONS:-detect_leaks=0}"
  once=()
  if [ "$preset" = paraview ] && grep -qs "^INK_BUILD_WRAPPED='ON'" build/headless/environment.sh; then
    echo "test: $preset: the tests that are marked one_build are those of the headless build"
    once=(-m "not one_build")
  fi
  on_display "$INK_PYTHON" -m pytest -q -rs --durations=20 -n "$jobs" ${once[@]+"${once[@]}"} -p no:cacheprovider Testing/Python 2>&1 |
    tee "$log" || failed="$failed pytest"
  list_skipped "$log"
else
  missing "ink and Python: $INK_PYTHON has no numpy, pytest and pytest-xdist"
fi

for part in ${left_out[@]+"${left_out[@]}"}; do
  echo "test: $preset: not tested: $part"
done
if [ -n "$failed" ]; then
  echo "test: $preset: failed:$failed" >&2
  exit 1
fi
