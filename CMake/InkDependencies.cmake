# SPDX-License-Identifier: BSD-3-Clause
if (NOT VTKINK_COMMON_ONLY)
  include(InkFindVTK)
endif ()

find_package(TBB REQUIRED)
find_package(glm REQUIRED)
option(VTKINK_ENABLE_OPENVDB "Build what reads, samples and writes OpenVDB files" ON)
if (VTKINK_ENABLE_OPENVDB)
  include(InkFindOpenVDB)
endif ()
find_package(Eigen3 REQUIRED NO_MODULE)
find_package(nanoflann REQUIRED)
