#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Fuzzes what `ink` reads files with, each format for some seconds:  Utilities/fuzz.sh [SECONDS [FORMAT...]]
# FORMAT is a folder of Testing/Fuzz/Corpus: ply, nii, vdb, ... What it finds
# lies in build/fuzz/found/FORMAT and, once mended, belongs into that folder, which every `make test` reads.
set -euo pipefail

seconds="${1:-60}"
shift || true
root="$(cd "$(dirname "$0")/.." && pwd)"
tree="$root/build/fuzz"
corpus="$root/Testing/Fuzz/Corpus"
[ $# -gt 0 ] || set -- $(ls "$corpus")
for format in "$@"; do
  if [ ! -d "$corpus/$format" ]; then
    echo "fuzz: unknown format '$format'; expected one of $(ls "$corpus" | tr '\n' ' ')" >&2
    exit 1
  fi
done

mkdir -p "$tree"
# Only the parts of the project that read: the rest need not be built with it.
cmake -S "$root/Testing/Fuzz/Standalone" -B "$tree" -G Ninja -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ \
  -DCMAKE_BUILD_TYPE=RelWithDebInfo "-DVTK_DIR=$root/build/vtk-headless/cvista_sdk/cmake" >"$tree.log" 2>&1 ||
  { cat "$tree.log" >&2; exit 1; }
cmake --build "$tree" --parallel "$("$root/Utilities/jobs.sh")" >>"$tree.log" 2>&1 || { tail -40 "$tree.log" >&2; exit 1; }

# One thread each: a fuzzer's runs have to be repeatable.
export VTK_SMP_MAX_THREADS=1 LLVM_PROFILE_FILE=/dev/null
status=0
for format in "$@"; do
  mkdir -p "$tree/corpus/$format" "$tree/found/$format"
  if [ "$format" = vdb ]; then
    target=FuzzVdb
    unset ASAN_OPTIONS
    limits="-timeout=10 -malloc_limit_mb=1024 -max_len=65536"
  else
    target=FuzzRead
    # VTK's libraries leak where they give up. The sanitizer would look at the end, too.
    export ASAN_OPTIONS=detect_leaks=0
    limits="-timeout=5 -malloc_limit_mb=512 -max_len=4096 -detect_leaks=0"
  fi
  echo "fuzz: $format"
  INK_FUZZ_FORMAT="$format" "$tree/$target" $limits -max_total_time="$seconds" -rss_limit_mb=2048 \
    -print_final_stats=1 -artifact_prefix="$tree/found/$format/" \
    "$tree/corpus/$format" "$corpus/$format" >"$tree/$format.log" 2>&1 || status=1
  grep -aE "^stat::number_of_executed_units|^FuzzRead:|SUMMARY|runtime error" "$tree/$format.log" || true
done
exit "$status"
