# SPDX-License-Identifier: BSD-3-Clause
# The VTK to build with: ParaView's own when the plugin is wanted, otherwise the one that VTK_DIR or
# CMAKE_PREFIX_PATH names. Any VTK >= 9.2 with OpenGL2 rendering will do.
set(_ink_minimum_vtk 9.2)
# Named one by one, so that a VTK's parts that vtkInk does without need not have their own dependencies met.
set(VTKINK_VTK_COMPONENTS
  CommonColor CommonCore CommonDataModel CommonExecutionModel CommonMath CommonTransforms
  FiltersCore FiltersGeometry FiltersSources ImagingCore
  IOCore IOGeometry IOImage IOLegacy IOPLY IOXML nlohmannjson
  RenderingCore RenderingOpenGL2 vtksys)
if (VTKINK_BUILD_PLUGIN)
  find_package(ParaView 5.11 REQUIRED)
else ()
  find_package(VTK ${_ink_minimum_vtk} REQUIRED
    COMPONENTS ${VTKINK_VTK_COMPONENTS}
    OPTIONAL_COMPONENTS Python WrappingPythonCore)
endif ()
if (VTK_VERSION VERSION_LESS _ink_minimum_vtk)
  message(FATAL_ERROR "vtkInk needs VTK ${_ink_minimum_vtk} or later; found ${VTK_VERSION} in ${VTK_DIR}")
endif ()
include(InkPlainLinkInterfaces)
message(STATUS "vtkInk: VTK ${VTK_VERSION}")

# Wrapping needs VTK's own wrapping tools and the Python that this VTK asks for.
if (VTK_WRAP_PYTHON AND Python3_FOUND)
  set(_ink_can_wrap ON)
else ()
  set(_ink_can_wrap OFF)
  message(STATUS "vtkInk: without the Python classes, as this VTK's Python was not found")
endif ()
option(VTKINK_WRAP_PYTHON "Build the Python package vtkink" ${_ink_can_wrap})
