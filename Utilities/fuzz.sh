#!/usr/bin/env bash
# Fuzzes what reads OpenVDB files for some seconds:  Utilities/fuzz.sh [SECONDS]    (INK_JOBS: how many at once)
# Needs clang with libFuzzer (Debian's clang). What it finds lies in build/fuzz/found and, once mended, belongs into
# Testing/Fuzz/Corpus, which every `make test` runs.
set -euo pipefail

seconds="${1:-60}"
root="$(cd "$(dirname "$0")/.." && pwd)"
tree="$root/build/fuzz"
if ! command -v clang++ >/dev/null; then
  echo "fuzz: there is no clang++ (Debian: apt-get install clang)" >&2
  exit 1
fi

mkdir -p "$tree"
# Of the project only Common is needed, so that no VTK has to be built with it.
cmake -S "$root/Testing/Fuzz/Standalone" -B "$tree" -G Ninja -DCMAKE_CXX_COMPILER=clang++ \
  -DCMAKE_BUILD_TYPE=RelWithDebInfo >"$tree.log" 2>&1 || { cat "$tree.log" >&2; exit 1; }
cmake --build "$tree" --parallel "${INK_JOBS:-2}" >>"$tree.log" 2>&1 || { tail -40 "$tree.log" >&2; exit 1; }

mkdir -p "$tree/corpus" "$tree/found"
# One thread each: a fuzzer's runs have to be repeatable.
export VTK_SMP_MAX_THREADS=1
export LLVM_PROFILE_FILE=/dev/null
"$tree/FuzzVdb" -max_total_time="$seconds" -rss_limit_mb=2048 -malloc_limit_mb=1024 -timeout=10 \
  -max_len=65536 -print_final_stats=1 -artifact_prefix="$tree/found/" \
  "$tree/corpus" "$root/Testing/Fuzz/Corpus" 2>"$tree/fuzz.log" || status=$?
grep -E "^stat::|SUMMARY|cov:.*(DONE|pulse|RELOAD)|DONE" "$tree/fuzz.log" | tail -12
exit "${status:-0}"
