#!/usr/bin/env bash
# Runs all tests of one built preset:  Utilities/test.sh headless|paraview|asan|tsan [ctest arguments]
# The paraview preset draws into an X server of its own, the others need no display.
set -euo pipefail

preset="${1:?usage: Utilities/test.sh headless|paraview|asan|tsan [ctest arguments]}"
shift
cd "$(dirname "$0")/.."
. Utilities/env.sh "$preset"

on_display()
{
  if [ "$preset" = paraview ]; then
    xvfb-run -a -s "-noreset -screen 0 1600x1200x24" "$@"
  else
    "$@"
  fi
}

failed=""
echo "test: $preset (VTK $INK_BUILD_VTK_VERSION): C++"
on_display ctest --preset "$preset" "$@" || failed="$failed ctest"

if [ "$INK_BUILD_WRAPPED" != ON ]; then
  echo "test: left out of $preset: the tests of the Python package vtkink, which this build is without"
fi
if "$INK_PYTHON" -c 'import numpy, pytest' 2>/dev/null; then
  echo "test: $preset (VTK $INK_BUILD_VTK_VERSION): ink and Python"
  # Among Mesa's ending threads the leak checker crashes now and then, in one of some hundred runs of ink.
  export ASAN_OPTIONS="${ASAN_OPTIONS:-detect_leaks=0}"
  on_display "$INK_PYTHON" -m pytest -q -p no:cacheprovider Testing/Python || failed="$failed pytest"
else
  echo "test: left out of $preset: Testing/Python, as $INK_PYTHON has no numpy and pytest"
fi

if [ -n "$failed" ]; then
  echo "test: $preset: failed:$failed" >&2
  exit 1
fi
