# SPDX-License-Identifier: BSD-3-Clause
# Where installed libraries and programs find VTK, and what an installed package file says of it.
#   _ink_vtk_rpath          folders for the runtime search path
#   _ink_installed_vtk_dir  VTK_DIR's default in vtkInkConfig.cmake
# An install uses VTK where it lies, unless VTKINK_INSTALL_VTK names a folder that holds all of it and that can be
# moved, as a wheel's can: that one is installed as well, and the install tree can be moved.
set(VTKINK_INSTALL_VTK "" CACHE PATH "A folder with VTK and its package files to install with vtkInk; empty: none")

# VTK::vtksys, unlike VTK's modules, is a library of its own in every VTK.
if (NOT VTKINK_INSTALL_VTK)
  set(_ink_vtk_rpath "$<TARGET_FILE_DIR:VTK::vtksys>")
  set(_ink_installed_vtk_dir "${VTK_DIR}")
  return ()
endif ()

get_target_property(_ink_vtk_configurations VTK::vtksys IMPORTED_CONFIGURATIONS)
list(GET _ink_vtk_configurations 0 _ink_vtk_configuration)
get_target_property(_ink_vtk_libraries VTK::vtksys "IMPORTED_LOCATION_${_ink_vtk_configuration}")
get_filename_component(_ink_vtk_libraries "${_ink_vtk_libraries}" DIRECTORY)
file(REAL_PATH "${VTKINK_INSTALL_VTK}" _ink_vtk_folder)
get_filename_component(_ink_vtk_name "${_ink_vtk_folder}" NAME)
set(_ink_vtk_destination "${CMAKE_INSTALL_LIBDIR}/vtkInk/${_ink_vtk_name}")
foreach (_ink_path IN ITEMS _ink_vtk_libraries VTK_DIR)
  file(REAL_PATH "${${_ink_path}}" _ink_real_path)
  file(RELATIVE_PATH _ink_relative_path "${_ink_vtk_folder}" "${_ink_real_path}")
  if (_ink_relative_path MATCHES "^\\.\\.")
    message(FATAL_ERROR "vtkInk: VTKINK_INSTALL_VTK is ${VTKINK_INSTALL_VTK}; expected the folder that holds the VTK in "
      "use, whose files lie in ${_ink_real_path}")
  endif ()
  set(_ink_within_${_ink_path} "${_ink_relative_path}")
endforeach ()
file(RELATIVE_PATH _ink_bin_to_vtk "/${CMAKE_INSTALL_BINDIR}" "/${_ink_vtk_destination}/${_ink_within__ink_vtk_libraries}")
file(RELATIVE_PATH _ink_lib_to_vtk "/${CMAKE_INSTALL_LIBDIR}" "/${_ink_vtk_destination}/${_ink_within__ink_vtk_libraries}")
set(_ink_vtk_rpath "$ORIGIN/${_ink_bin_to_vtk}" "$ORIGIN/${_ink_lib_to_vtk}")
# PACKAGE_PREFIX_DIR is what @PACKAGE_INIT@ finds out where the package file is read.
set(_ink_installed_vtk_dir "\${PACKAGE_PREFIX_DIR}/${_ink_vtk_destination}/${_ink_within_VTK_DIR}")
install(DIRECTORY "${_ink_vtk_folder}/" DESTINATION "${_ink_vtk_destination}" USE_SOURCE_PERMISSIONS
  PATTERN "__pycache__" EXCLUDE)
