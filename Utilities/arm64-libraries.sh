#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Fetches what Utilities/packages/aarch64-libraries.txt names, built for arm64, and unpacks it into
# build/libraries-aarch64. Nothing is installed and apt keeps lists of its own there, so that the machine's packages
# and architectures stay as they are; root is not needed.
set -euo pipefail

root="$(cd "$(dirname "$0")/.." && pwd)"
libraries="$root/build/libraries-aarch64"
packages="$(sed -e 's/#.*//' "$root/Utilities/packages/aarch64-libraries.txt" | sort -u)"
[ "$(cat "$libraries/installed" 2>/dev/null)" != "$packages" ] || exit 0

fresh="$libraries.new"
rm -rf "$fresh"
mkdir -p "$fresh/apt/lists/partial" "$fresh/apt/archives/partial"
apt_arm64()
{
  apt-get -q -o APT::Architecture=arm64 -o APT::Architectures=arm64 -o APT::Sandbox::User=root \
    -o Acquire::Languages=none -o Dir::State::status=/dev/null -o Dir::State::lists="$fresh/apt/lists" \
    -o Dir::Cache="$fresh/apt" "$@"
}

echo "setup: fetching libraries for arm64 into build/libraries-aarch64"
log="$(mktemp)"
cd "$fresh/apt/archives"
# shellcheck disable=SC2086
if ! { apt_arm64 update && apt_arm64 download $packages; } >"$log" 2>&1; then
  tail -n 20 "$log" >&2
  echo "setup: error: apt-get could not fetch for arm64:" $packages "(its whole output: $log)" >&2
  exit 1
fi
rm -f "$log"
for package in *.deb; do
  dpkg-deb --extract "$package" "$fresh"
done
cd "$root"
rm -rf "$fresh/apt"
echo "$packages" >"$fresh/installed"
rm -rf "$libraries"
mv "$fresh" "$libraries"
