include(CMakePackageConfigHelpers)
configure_package_config_file(CMake/vtkInk-config.cmake.in
  "${CMAKE_BINARY_DIR}/${VTKINK_CMAKE_DESTINATION}/vtkInk-config.cmake"
  INSTALL_DESTINATION "${VTKINK_CMAKE_DESTINATION}")
write_basic_package_version_file(
  "${CMAKE_BINARY_DIR}/${VTKINK_CMAKE_DESTINATION}/vtkInk-config-version.cmake"
  COMPATIBILITY SameMinorVersion)
install(FILES
  "${CMAKE_BINARY_DIR}/${VTKINK_CMAKE_DESTINATION}/vtkInk-config.cmake"
  "${CMAKE_BINARY_DIR}/${VTKINK_CMAKE_DESTINATION}/vtkInk-config-version.cmake"
  DESTINATION "${VTKINK_CMAKE_DESTINATION}")
