# SPDX-License-Identifier: BSD-3-Clause
# The VTK modules: found by their vtk.module files, built against vtkInk::Common.
set(_ink_module_files
  "${CMAKE_CURRENT_SOURCE_DIR}/Filters/Contours/vtk.module"
  "${CMAKE_CURRENT_SOURCE_DIR}/Filters/Core/vtk.module"
  "${CMAKE_CURRENT_SOURCE_DIR}/Filters/Curvature/vtk.module"
  "${CMAKE_CURRENT_SOURCE_DIR}/Filters/Fields/vtk.module"
  "${CMAKE_CURRENT_SOURCE_DIR}/Filters/Sampling/vtk.module"
  "${CMAKE_CURRENT_SOURCE_DIR}/Filters/Strokes/vtk.module"
  "${CMAKE_CURRENT_SOURCE_DIR}/IO/Core/vtk.module"
  "${CMAKE_CURRENT_SOURCE_DIR}/IO/Mesh/vtk.module"
  "${CMAKE_CURRENT_SOURCE_DIR}/IO/Picture/vtk.module"
  "${CMAKE_CURRENT_SOURCE_DIR}/IO/Volume/vtk.module"
  "${CMAKE_CURRENT_SOURCE_DIR}/Rendering/Core/vtk.module"
  "${CMAKE_CURRENT_SOURCE_DIR}/Rendering/SplattingLines/vtk.module"
  "${CMAKE_CURRENT_SOURCE_DIR}/Rendering/Stipple/vtk.module"
  "${CMAKE_CURRENT_SOURCE_DIR}/Rendering/Strokes/vtk.module"
  "${CMAKE_CURRENT_SOURCE_DIR}/Styles/vtk.module")
if (VTKINK_ENABLE_OPENVDB)
  list(APPEND _ink_module_files "${CMAKE_CURRENT_SOURCE_DIR}/IO/VDB/vtk.module")
endif ()
if (VTKINK_BUILD_PLUGIN)
  list(APPEND _ink_module_files
    "${CMAKE_CURRENT_SOURCE_DIR}/Plugin/Representations/vtk.module")
endif ()

vtk_module_scan(
  MODULE_FILES ${_ink_module_files}
  PROVIDES_MODULES VTKINK_MODULES
  REQUIRES_MODULES _ink_required_modules
  ENABLE_TESTS OFF
  WANT_BY_DEFAULT ON
  HIDE_MODULES_FROM_CACHE ON)

foreach (_ink_module IN LISTS _ink_required_modules)
  if (NOT TARGET "${_ink_module}")
    message(FATAL_ERROR "vtkInk needs the VTK module ${_ink_module}, which VTK ${VTK_VERSION} in ${VTK_DIR} lacks")
  endif ()
endforeach ()

# CMAKE_DESTINATION has to be relative: VTK writes build-tree files under it too.
set(VTKINK_CMAKE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/vtkInk")
vtk_module_build(
  MODULES ${VTKINK_MODULES}
  PACKAGE vtkInk
  INSTALL_EXPORT vtkInk
  TARGET_NAMESPACE vtkInk
  HEADERS_DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/vtkInk"
  CMAKE_DESTINATION "${VTKINK_CMAKE_DESTINATION}"
  LIBRARY_NAME_SUFFIX ""
  VERSION "${PROJECT_VERSION}"
  SOVERSION "${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}")
