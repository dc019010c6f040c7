#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Installs what a build preset, `make tradeoff`, `make window-pictures`, `make fuzz` or `make tidy` needs:
#   Utilities/setup.sh headless|paraview|aarch64|tradeoff|window-pictures|fuzz|tidy
# From Debian the lists in Utilities/packages/; for the headless preset VTK itself, from PyPI, into
# build/vtk-headless. Needs root or sudo only if a Debian package is missing; says nothing if none is. Where another
# program is installing packages, waits for it.
set -euo pipefail

preset="${1:?usage: Utilities/setup.sh headless|paraview|aarch64|tradeoff|window-pictures|fuzz|tidy}"
root="$(cd "$(dirname "$0")/.." && pwd)"
utilities="$root/Utilities"
vtk_release="9.7.0.5"
pyvista_release="0.49.1"
vtk_site="$root/build/vtk-headless"

fail()
{
  echo "setup: error: $*" >&2
  exit 1
}

# Runs apt-get as root, its output in $log. apt has an option that waits for dpkg's lock, but none for its own two.
apt_get()
{
  local tries
  for tries in $(seq 200); do
    # shellcheck disable=SC2086
    ! $as_root env DEBIAN_FRONTEND=noninteractive LC_ALL=C apt-get "$@" >"$log" 2>&1 || return 0
    grep -q "Could not get lock" "$log" || return 1
    [ "$tries" != 1 ] || echo "setup: waiting for another program that installs packages ($(grep -om1 'held by .*' "$log"))"
    sleep 3
  done
  return 1
}

# Says how far apt-get is, from the log that it writes: at each fifth of that many packages.
show_progress()
{
  local packages="$1" ready said=0
  while sleep 1 && kill -0 $$ 2>/dev/null; do
    ready="$(grep -c '^Setting up ' "$log" 2>/dev/null || true)"
    if [ "$((${ready:-0} * 5 / packages))" -gt "$said" ]; then
      said="$((ready * 5 / packages))"
      echo "setup: $ready of $packages packages installed"
    fi
  done
}

could_not_install()
{
  tail -n 20 "$log" >&2
  fail "apt-get could not install:$missing (its whole output: $log)"
}

install_debian_packages()
{
  wanted="$(sed -e 's/#.*//' "$@" | sort -u)"
  installed="$(dpkg-query -W -f='${Package} ${Status}\n' 2>/dev/null | sed -n 's/ install ok installed$//p')"
  missing=""
  for package in $wanted; do
    printf '%s\n' "$installed" | grep -qx "$package" || missing="$missing $package"
  done
  [ -n "$missing" ] || return 0

  command -v apt-get >/dev/null || fail "these packages are missing and there is no apt-get:$missing"
  if [ "$(id -u)" = 0 ]; then
    as_root=""
  else
    command -v sudo >/dev/null || fail "root or sudo is needed to install:$missing"
    as_root="sudo"
  fi
  log="$(mktemp)"
  echo "setup: updating Debian's lists of packages"
  apt_get update || could_not_install
  # shellcheck disable=SC2086
  LC_ALL=C apt-get install -y --no-install-recommends --print-uris $missing >"$log" 2>&1 || could_not_install
  # What apt has in its cache is not fetched.
  megabytes="$(awk '/^\x27/ { bytes += $3 } END { printf "%d", bytes / 1e6 }' "$log")"
  # shellcheck disable=SC2086
  LC_ALL=C apt-get install --simulate --no-install-recommends $missing >"$log" 2>&1 || could_not_install
  packages="$(grep -c '^Inst ' "$log" || true)"
  echo "setup: installing Debian's$missing ($packages packages with what they need, $megabytes MB to fetch)"
  : >"$log"
  show_progress "$((packages > 0 ? packages : 1))" &
  progress=$!
  installed=yes
  # shellcheck disable=SC2086
  apt_get install -y --no-install-recommends $missing || installed=no
  kill "$progress"
  wait "$progress" 2>/dev/null || true
  [ "$installed" = yes ] || could_not_install
  rm -f "$log"
}

# Errors alone are shown: pip warns of each folder that two packages share.
pip_into_fresh()
{
  "$python" -m pip install -qq --disable-pip-version-check --root-user-action=ignore --target "$fresh" "$@"
}

# The wheels unpack with any pip; the modules in them need Python >= 3.12, which find-python.sh looks for.
install_vtk_wheels()
{
  python="$("$utilities/find-python.sh" || true)"
  # PyVista is there for its example, and what it imports; pip would bring another VTK and more along.
  packages="numpy pytest pytest-xdist matplotlib pillow pooch scooby typing-extensions certifi"
  alone="pyvista==$pyvista_release pyvista-validation"
  contents="vtk $vtk_release${python:+, $packages $alone for $python}"
  [ "$(cat "$vtk_site/installed" 2>/dev/null)" != "$contents" ] || return 0

  fresh="$vtk_site.new"
  rm -rf "$fresh"
  mkdir -p "$fresh"
  echo "setup: fetching VTK $vtk_release from PyPI into build/vtk-headless"
  /usr/bin/python3 -m pip install --disable-pip-version-check --root-user-action=ignore \
    --no-deps --no-compile --ignore-requires-python --target "$fresh" \
    --only-binary=:all: --implementation cp --python-version 3.12 --abi abi3 --abi none \
    --platform "manylinux_2_28_$(uname -m)" \
    "cvista-sdk==$vtk_release" "cvista==$vtk_release" "cvista-rendering==$vtk_release" "cvista-io==$vtk_release" ||
    fail "pip could not fetch VTK $vtk_release"
  if [ -n "$python" ]; then
    echo "setup: fetching what its tests need for $python"
    pip_into_fresh $packages && pip_into_fresh --no-deps $alone ||
      fail "pip could not fetch $packages $alone for $python"
  fi
  echo "$contents" >"$fresh/installed"
  rm -rf "$vtk_site"
  mv "$fresh" "$vtk_site"
}

case "$preset" in
  headless)
    install_debian_packages "$utilities/packages/build.txt" "$utilities/packages/headless.txt"
    install_vtk_wheels
    ;;
  paraview)
    install_debian_packages "$utilities/packages/build.txt" "$utilities/packages/paraview.txt"
    ;;
  aarch64)
    install_debian_packages "$utilities/packages/aarch64.txt"
    "$utilities/arm64-libraries.sh"
    ;;
  tradeoff)
    install_debian_packages "$utilities/packages/tradeoff.txt"
    ;;
  window-pictures)
    install_debian_packages "$utilities/packages/window-pictures.txt"
    ;;
  fuzz)
    install_debian_packages "$utilities/packages/fuzz.txt"
    ;;
  tidy)
    install_debian_packages "$utilities/packages/tidy.txt"
    ;;
  *)
    fail "unknown preset '$preset'; expected headless, paraview, aarch64, tradeoff, window-pictures, fuzz or tidy"
    ;;
esac
