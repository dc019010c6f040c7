# SPDX-License-Identifier: BSD-3-Clause
# Makes a build tree usable in this shell:  . Utilities/env.sh paraview   (or headless, asan, tsan)
# Afterwards `ink`, `$INK_PYTHON -c 'import vtkink'` and ParaView's plugin manager find what that tree holds.
# For bash and zsh. Sourcing it again, here or in another clone, replaces what it did before.

if [ -n "${INK_BUILD:-}" ]; then
  PATH="$INK_OUTER_PATH"
  PYTHONPATH="$INK_OUTER_PYTHONPATH"
  PV_PLUGIN_PATH="$INK_OUTER_PV_PLUGIN_PATH"
  VTK_DEFAULT_OPENGL_WINDOW="$INK_OUTER_WINDOW"
fi
INK_OUTER_PATH="$PATH"
INK_OUTER_PYTHONPATH="${PYTHONPATH:-}"
INK_OUTER_PV_PLUGIN_PATH="${PV_PLUGIN_PATH:-}"
INK_OUTER_WINDOW="${VTK_DEFAULT_OPENGL_WINDOW:-}"

INK_PRESET="${1:-${INK_PRESET:-headless}}"
INK_ROOT="$(cd "$(dirname "${BASH_SOURCE:-$0}")/.." && pwd)"
INK_BUILD="$INK_ROOT/build/$INK_PRESET"

if [ ! -f "$INK_BUILD/environment.sh" ]; then
  echo "env.sh: no configured build tree $INK_BUILD (try: make build-$INK_PRESET)" >&2
  return 1 2>/dev/null || exit 1
fi
. "$INK_BUILD/environment.sh"

PATH="$INK_BUILD/$INK_BUILD_BINDIR:$PATH"
if [ -d "$INK_ROOT/build/vtk-headless" ] && [ "$INK_PRESET" != paraview ]; then
  INK_VTK="$INK_ROOT/build/vtk-headless"
  # No display needed: draw with OSMesa unless the caller chose otherwise.
  VTK_DEFAULT_OPENGL_WINDOW="${VTK_DEFAULT_OPENGL_WINDOW:-vtkOSOpenGLRenderWindow}"
  export VTK_DEFAULT_OPENGL_WINDOW
else
  INK_VTK=""
fi
if [ "$INK_BUILD_WRAPPED" != ON ]; then
  # Without vtkink, Python still runs the tests of ink.
  INK_PYTHON="$("$INK_ROOT/Utilities/find-python.sh" || echo /usr/bin/python3)"
elif [ -n "$INK_VTK" ]; then
  # The modules of a VTK from PyPI lie beside its SDK, with NumPy and more for one version of Python: in an environment of
  # that Python's (PEP 405), vtkink too, since all others would find them on PYTHONPATH and fail.
  INK_PYTHON="$("$INK_ROOT/Utilities/python-environment.sh" "$INK_BUILD_PYTHON" "$INK_BUILD/python" \
    "$INK_BUILD/$INK_BUILD_PYTHONDIR" "$INK_VTK")"
else
  INK_PYTHON="$INK_BUILD_PYTHON"
  PYTHONPATH="$INK_BUILD/$INK_BUILD_PYTHONDIR${PYTHONPATH:+:$PYTHONPATH}"
fi
unset INK_VTK
if [ -n "$INK_BUILD_PLUGINDIR" ]; then
  PV_PLUGIN_PATH="$INK_BUILD/$INK_BUILD_PLUGINDIR${PV_PLUGIN_PATH:+:$PV_PLUGIN_PATH}"
  export PV_PLUGIN_PATH
fi
if [ "$INK_PRESET" = asan ]; then
  LSAN_OPTIONS="${LSAN_OPTIONS:-suppressions=$INK_ROOT/Utilities/leaks.supp:print_suppressions=0}"
  export LSAN_OPTIONS
fi
# Files are UTF-8 in any locale.
export PYTHONUTF8=1
export PATH PYTHONPATH INK_PYTHON INK_PRESET INK_ROOT INK_BUILD
export INK_OUTER_PATH INK_OUTER_PYTHONPATH INK_OUTER_PV_PLUGIN_PATH INK_OUTER_WINDOW
