#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Checks sources with clang-tidy, which .clang-tidy tells what to look for:  Utilities/tidy.sh [FOLDER|FILE...]
# Of folders, what the headless build compiles; by default all of that but tests. Of a folder Testing, the tests. Fails
# where anything is found.
set -euo pipefail

root="$(cd "$(dirname "$0")/.." && pwd)"
cd "$root"
commands="build/headless/compile_commands.json"
if [ ! -f "$commands" ]; then
  echo "tidy: error: no $commands, which build/headless has once it is built (make build-ink)" >&2
  exit 1
fi
[ $# -gt 0 ] || set -- Applications Common Filters IO Rendering Styles

# run-clang-tidy takes all sources that a regular expression is found in.
escaped_root="$(printf '%s' "$root" | sed 's/[][\.*^$+?(){}|]/\\&/g')"
patterns=()
for path in "$@"; do
  if [ -d "$path" ]; then
    case "/$path/" in
      */Testing/*) patterns+=("^$escaped_root/${path%/}/") ;;
      *) patterns+=("^$escaped_root/${path%/}/(?!(.*/)?Testing/)") ;;
    esac
  elif [ -f "$path" ]; then
    patterns+=("^$escaped_root/$path\$")
  else
    echo "tidy: error: no file or folder '$path' in $root" >&2
    exit 1
  fi
done

# clang cannot read the headers that GCC has precompiled; sources include what they need.
mkdir -p build/tidy
sed -e 's/ -Winvalid-pch//g' -e 's/ -include [^ ]*cmake_pch\.hxx//g' "$commands" >build/tidy/compile_commands.json

# GCC's pragmas are hints that clang may pass over. Each source's command becomes its name; clang's count of what it
# found in others' headers goes.
run-clang-tidy -quiet -p build/tidy -extra-arg=-Wno-unknown-pragmas -j "$(Utilities/jobs.sh)" "${patterns[@]}" 2>&1 |
  sed -u -e '/ warnings\{0,1\} generated\.$/d' -e "s|^[^ ]*clang-tidy.* $root/|tidy: |"
