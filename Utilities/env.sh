# Makes a build tree usable in this shell:  . Utilities/env.sh paraview   (or headless, asan, tsan)
# Afterwards `ink`, `$INK_PYTHON -c 'import vtkink'` and ParaView's plugin manager find what that tree holds.
# For bash and zsh; other shells pass no argument to a sourced file and set INK_PRESET before instead.
# Source it inside the repository, or set INK_ROOT to where that is.

INK_PRESET="${1:-${INK_PRESET:-headless}}"
INK_ROOT="${INK_ROOT:-$(git rev-parse --show-toplevel 2>/dev/null || pwd)}"
INK_BUILD="$INK_ROOT/build/$INK_PRESET"

if [ ! -f "$INK_BUILD/environment.sh" ]; then
  echo "env.sh: no configured build tree $INK_BUILD (try: make build-$INK_PRESET)" >&2
  return 1 2>/dev/null || exit 1
fi
. "$INK_BUILD/environment.sh"

PATH="$INK_BUILD/$INK_BUILD_BINDIR:$PATH"
INK_PYTHON="$INK_BUILD_PYTHON"
PYTHONPATH="$INK_BUILD/$INK_BUILD_PYTHONDIR${PYTHONPATH:+:$PYTHONPATH}"
# The modules of a VTK from PyPI lie beside its SDK.
if [ -d "$INK_ROOT/build/vtk-headless" ] && [ "$INK_PRESET" != paraview ]; then
  PYTHONPATH="$PYTHONPATH:$INK_ROOT/build/vtk-headless"
  # No display needed: draw with OSMesa unless the caller chose otherwise.
  VTK_DEFAULT_OPENGL_WINDOW="${VTK_DEFAULT_OPENGL_WINDOW:-vtkOSOpenGLRenderWindow}"
  export VTK_DEFAULT_OPENGL_WINDOW
fi
if [ -n "$INK_BUILD_PLUGINDIR" ]; then
  PV_PLUGIN_PATH="$INK_BUILD/$INK_BUILD_PLUGINDIR${PV_PLUGIN_PATH:+:$PV_PLUGIN_PATH}"
  export PV_PLUGIN_PATH
fi
export PATH PYTHONPATH INK_PYTHON INK_PRESET INK_ROOT INK_BUILD
