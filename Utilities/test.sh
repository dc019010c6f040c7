#!/usr/bin/env bash
# Runs all tests of one built preset:  Utilities/test.sh headless|paraview|asan|tsan [ctest arguments]
# Two at a time (INK_JOBS: how many). The paraview preset draws into an X server of its own, the others need no
# display. The last lines name what could not be tested; where CI=true, what Utilities/setup.sh installs has to be there.
set -euo pipefail

preset="${1:?usage: Utilities/test.sh headless|paraview|asan|tsan [ctest arguments]}"
shift
cd "$(dirname "$0")/.."
. Utilities/env.sh "$preset"

jobs="${INK_JOBS:-2}"
# The tests share the cores already.
export LP_NUM_THREADS="${LP_NUM_THREADS:-1}"

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

if [ "$INK_BUILD_WRAPPED" != ON ]; then
  left_out+=("the Python package vtkink: no Python that this VTK can be wrapped for, or VTKINK_WRAP_PYTHON=OFF")
elif ! "$INK_PYTHON" -c 'import vtkink'; then
  failed="$failed vtkink"
fi
[ "$INK_BUILD_OPENVDB" = ON ] || left_out+=("OpenVDB: VTKINK_ENABLE_OPENVDB=OFF")
[ "$preset" != paraview ] || [ -x "$INK_BUILD_MPIEXEC" ] || missing "ParaView on several ranks: no mpiexec"

echo "test: $preset (VTK $INK_BUILD_VTK_VERSION): C++"
on_display ctest --preset "$preset" --parallel "$jobs" "$@" || failed="$failed ctest"

if "$INK_PYTHON" -c 'import numpy, pytest, xdist' 2>/dev/null; then
  echo "test: $preset (VTK $INK_BUILD_VTK_VERSION): ink and Python"
  # Among Mesa's ending threads the leak checker crashes now and then, in one of some hundred runs of ink.
  export ASAN_OPTIONS="${ASAN_OPTIONS:-detect_leaks=0}"
  on_display "$INK_PYTHON" -m pytest -q -rs -n "$jobs" -p no:cacheprovider Testing/Python || failed="$failed pytest"
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
