#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Prints the path of a Python >= 3.12 with headers, or nothing and exits 1.
# INK_HEADLESS_PYTHON names one directly. A python3.12 on PATH may be a version manager's shim that refuses
# to run, so each candidate is tried.
usable()
{
  "$1" -c 'import os, sys, sysconfig
header = os.path.join(sysconfig.get_paths()["include"], "Python.h")
sys.exit(not (sys.version_info >= (3, 12) and os.path.exists(header)))' >/dev/null 2>&1
}

pyenv_root="${PYENV_ROOT:-$HOME/.pyenv}"
for candidate in "${INK_HEADLESS_PYTHON:-}" python3 python3.12 python3.13 python3.14 \
  "$pyenv_root"/versions/3.1[2-9]*/bin/python3; do
  if [ -n "$candidate" ] && usable "$candidate"; then
    "$candidate" -c 'import sys; print(sys.executable)'
    exit 0
  fi
done
exit 1
