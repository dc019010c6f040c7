#!/usr/bin/env bash
# Installs what a build preset, `make tradeoff` or `make fuzz` needs:  Utilities/setup.sh headless|paraview|tradeoff|fuzz
# From Debian the lists in Utilities/packages/; for the headless preset VTK itself, from PyPI, into
# build/vtk-headless. Needs root or sudo only if a Debian package is missing; says nothing if none is.
set -euo pipefail

preset="${1:?usage: Utilities/setup.sh headless|paraview|tradeoff|fuzz}"
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
  echo "setup: installing$missing"
  log="$(mktemp)"
  if ! { $as_root apt-get update &&
    $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends $missing; } >"$log" 2>&1
  then
    tail -n 20 "$log" >&2
    fail "apt-get could not install:$missing (its whole output: $log)"
  fi
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
  echo "setup: fetching VTK $vtk_release into build/vtk-headless"
  /usr/bin/python3 -m pip install --quiet --disable-pip-version-check --root-user-action=ignore \
    --no-deps --no-compile --ignore-requires-python --target "$fresh" \
    --only-binary=:all: --implementation cp --python-version 3.12 --abi abi3 --abi none \
    --platform "manylinux_2_28_$(uname -m)" \
    "cvista-sdk==$vtk_release" "cvista==$vtk_release" "cvista-rendering==$vtk_release" "cvista-io==$vtk_release" ||
    fail "pip could not fetch VTK $vtk_release"
  if [ -n "$python" ]; then
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
  tradeoff)
    install_debian_packages "$utilities/packages/tradeoff.txt"
    ;;
  fuzz)
    install_debian_packages "$utilities/packages/fuzz.txt"
    ;;
  *)
    fail "unknown preset '$preset'; expected headless, paraview, tradeoff or fuzz"
    ;;
esac
