#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Measures error against time where a setting trades one for the other, with the headless build, and writes
# Documentation/accuracy-and-speed.md with its plots:
#   Utilities/tradeoff.sh                    all of it
#   Utilities/tradeoff.sh TradeoffMesh ...   what these programs measure; the rest stays
set -euo pipefail

cd "$(dirname "$0")/.."
. Utilities/env.sh headless

# The system's Python has Debian's matplotlib; -E keeps the numpy of the build's Python away from it.
measure=(/usr/bin/python3 -E Testing/Benchmarks/tradeoff.py)
bin="$INK_BUILD/$INK_BUILD_BINDIR"
if [ $# -gt 0 ]; then
  "${measure[@]}" --update "${@/#/$bin/}"
else
  "${measure[@]}" "$bin"/Tradeoff*
fi
