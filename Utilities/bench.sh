#!/usr/bin/env bash
# Runs the benchmarks of a build:  Utilities/bench.sh [headless|paraview] [benchmarks' arguments]
# Each compares vtkInk with its peers in one process; read ratios, not lone times.
set -euo pipefail

preset="${1:-headless}"
[ $# = 0 ] || shift
cd "$(dirname "$0")/.."
. Utilities/env.sh "$preset"

for benchmark in "$INK_BUILD/$INK_BUILD_BINDIR"/Benchmark*; do
  echo "bench: $(basename "$benchmark") ($preset, VTK $INK_BUILD_VTK_VERSION)"
  if [ "$preset" = paraview ]; then
    xvfb-run -a -s "-noreset -screen 0 1600x1200x24" "$benchmark" "$@"
  else
    "$benchmark" "$@"
  fi
done
