# SPDX-License-Identifier: BSD-3-Clause
include(CMakePackageConfigHelpers)
# What find_package(vtkInk COMPONENTS ...) knows: the targets' names.
set(VTKINK_COMPONENTS ${VTKINK_MODULES})
list(TRANSFORM VTKINK_COMPONENTS REPLACE "^vtkInk::" "")
list(PREPEND VTKINK_COMPONENTS Common)
if (VTKINK_ENABLE_OPENVDB)
  list(INSERT VTKINK_COMPONENTS 1 CommonVDB)
endif ()
list(JOIN VTKINK_COMPONENTS " " VTKINK_COMPONENTS)

configure_package_config_file(CMake/vtkInkConfig.cmake.in
  "${CMAKE_BINARY_DIR}/${VTKINK_CMAKE_DESTINATION}/vtkInkConfig.cmake"
  INSTALL_DESTINATION "${VTKINK_CMAKE_DESTINATION}")
write_basic_package_version_file(
  "${CMAKE_BINARY_DIR}/${VTKINK_CMAKE_DESTINATION}/vtkInkConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(FILES CMake/InkFindGDCM.cmake CMake/InkFindOpenVDB.cmake CMake/InkPlainLinkInterfaces.cmake
  "${CMAKE_BINARY_DIR}/${VTKINK_CMAKE_DESTINATION}/vtkInkConfig.cmake"
  "${CMAKE_BINARY_DIR}/${VTKINK_CMAKE_DESTINATION}/vtkInkConfigVersion.cmake"
  DESTINATION "${VTKINK_CMAKE_DESTINATION}")
