# SPDX-License-Identifier: BSD-3-Clause
# Finds OpenVDB: the target OpenVDB::openvdb. OpenVDB installs a module for find_package, but in a folder of its own.
find_path(OpenVDB_MODULE_DIR FindOpenVDB.cmake
  PATH_SUFFIXES
    "lib/${CMAKE_LIBRARY_ARCHITECTURE}/cmake/OpenVDB"
    lib64/cmake/OpenVDB
    lib/cmake/OpenVDB
  DOC "The folder of OpenVDB's FindOpenVDB.cmake")
mark_as_advanced(OpenVDB_MODULE_DIR)
if (NOT OpenVDB_MODULE_DIR)
  message(FATAL_ERROR "vtkInk: OpenVDB was not found. Debian has it in libopenvdb-dev; for another place set "
    "CMAKE_PREFIX_PATH, to build without it VTKINK_ENABLE_OPENVDB=OFF")
endif ()

# In a function, so that the folder's modules for other packages are not met by anyone else.
function (_ink_find_openvdb)
  list(APPEND CMAKE_MODULE_PATH "${OpenVDB_MODULE_DIR}")
  find_package(OpenVDB REQUIRED COMPONENTS openvdb)
endfunction ()
_ink_find_openvdb()
