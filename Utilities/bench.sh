#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Runs the benchmarks of a build:  Utilities/bench.sh [headless|paraview] [benchmarks' arguments]
# Each compares vtkInk with its peers in one process; read ratios, not lone times.
set -euo pipefail

preset="${1:-headless}"
[ $# = 0 ] || shift
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

for benchmark in "$INK_BUILD/$INK_BUILD_BINDIR"/Benchmark*; do
  echo "bench: $(basename "$benchmark") ($preset, VTK $INK_BUILD_VTK_VERSION)"
  case "$benchmark" in
    */BenchmarkSplattingLines) on_display "$benchmark" --quick "$@" ;; # all rows take the better part of an hour
    *) on_display "$benchmark" "$@" ;;
  esac
done

# Two frames of each motion; more of them change little.
for script in stipple_coherence.py lines_coherence.py contours_coherence.py hatching_coherence.py; do
  if "$INK_PYTHON" -c 'import numpy, vtkink' 2>/dev/null; then
    echo "bench: $script ($preset, VTK $INK_BUILD_VTK_VERSION)"
    on_display "$INK_PYTHON" "Testing/Benchmarks/$script" 2
  else
    echo "bench: left out of $preset: $script, as $INK_PYTHON has no numpy or no vtkink"
  fi
done
