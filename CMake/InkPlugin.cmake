# SPDX-License-Identifier: BSD-3-Clause
# The ParaView plugin vtkInk, from Plugin/. It is laid out as ParaView's own plugins are, in the build tree
# and where it is installed: VTKINK_PLUGIN_DESTINATION holds vtkInk/vtkInk.so and belongs on PV_PLUGIN_PATH.
paraview_plugin_scan(
  PLUGIN_FILES "${CMAKE_CURRENT_SOURCE_DIR}/Plugin/paraview.plugin"
  PROVIDES_PLUGINS _ink_plugins
  REQUIRES_MODULES _ink_plugin_modules
  ENABLE_BY_DEFAULT ON
  HIDE_PLUGINS_FROM_CACHE ON)

set(_ink_plugin_subdirectory "paraview-${ParaView_VERSION_MAJOR}.${ParaView_VERSION_MINOR}/plugins")
set(VTKINK_PLUGIN_DESTINATION "${CMAKE_INSTALL_LIBDIR}/${_ink_plugin_subdirectory}")
paraview_plugin_build(
  PLUGINS ${_ink_plugins}
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  LIBRARY_SUBDIRECTORY "${_ink_plugin_subdirectory}")

if (VTKINK_BUILD_TESTING)
  add_subdirectory(Plugin/Testing)
endif ()
