#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Prints how many compilers or tests to run at once: INK_JOBS where it is set, otherwise one for each processor that this
# process may use and each 2 GiB of memory that it is allowed, which the largest sources take with room to spare.
set -euo pipefail

if [ -n "${INK_JOBS:-}" ]; then
  echo "$INK_JOBS"
  exit 0
fi

# Tests name other files.
meminfo="${INK_MEMINFO:-/proc/meminfo}"
limits="${INK_MEMORY_LIMIT:-/sys/fs/cgroup/memory.max /sys/fs/cgroup/memory/memory.limit_in_bytes}"

mebibytes="$(awk '$1 == "MemTotal:" { print int($2 / 1024) }' "$meminfo" 2>/dev/null || true)"
mebibytes="${mebibytes:-4096}"
# A container may be allowed less than the machine has; a word or more bytes than machines have stands for no limit.
for limit in $limits; do
  bytes="$(cat "$limit" 2>/dev/null || true)"
  case "$bytes" in
    '' | *[!0-9]* | ????????????????*) ;;
    *) [ "$((bytes / 1048576))" -ge "$mebibytes" ] || mebibytes="$((bytes / 1048576))" ;;
  esac
done

processors="$(nproc 2>/dev/null || getconf _NPROCESSORS_ONLN)"
# Rounded, as a machine's kernel keeps some of its memory to itself.
jobs="$(((mebibytes + 1024) / 2048))"
[ "$jobs" -le "$processors" ] || jobs="$processors"
[ "$jobs" -ge 1 ] || jobs=1
echo "$jobs"
