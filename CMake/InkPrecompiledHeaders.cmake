# SPDX-License-Identifier: BSD-3-Clause
# Most of what a compiler does for a source that uses VTK is to read the same headers of VTK and of the standard library.
# With VTKINK_PRECOMPILED_HEADERS it reads them once. Each source includes what it needs all the same: a build without
# them, as the ParaView preset's, shows where one does not.
option(VTKINK_PRECOMPILED_HEADERS "Read the headers of VTK's data model once, not for each source" OFF)

# Objects compiled with them are of no use in another build tree, which is what a compiler cache is for.
if (NOT VTKINK_PRECOMPILED_HEADERS OR CMAKE_CXX_COMPILER_LAUNCHER MATCHES "cache")
  set(_ink_precompile OFF)
else ()
  set(_ink_precompile ON)
endif ()

# ink_precompiled_headers(TARGET): for a target of VTK's data model. One file serves libraries and programs, which are
# compiled as libraries then: as position-independent code.
function (ink_precompiled_headers target)
  if (_ink_precompile)
    target_precompile_headers(${target} REUSE_FROM InkPrecompiled)
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE OFF)
    target_compile_options(${target} PRIVATE ${CMAKE_CXX_COMPILE_OPTIONS_PIC})
    if (CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      # GCC 12 warns of the standard library's own strings where it no longer knows that they are a system header's.
      target_compile_options(${target} PRIVATE -Wno-array-bounds -Wno-restrict -Wno-stringop-overflow -Wno-stringop-overread)
    endif ()
  endif ()
endfunction ()

if (_ink_precompile)
  file(CONFIGURE OUTPUT "${CMAKE_BINARY_DIR}/CMakeFiles/InkPrecompiled.cxx" CONTENT "")
  add_library(InkPrecompiled OBJECT "${CMAKE_BINARY_DIR}/CMakeFiles/InkPrecompiled.cxx")
  target_link_libraries(InkPrecompiled PRIVATE VTK::CommonCore VTK::CommonDataModel VTK::CommonExecutionModel)
  ink_compile_options(InkPrecompiled)
  target_precompile_headers(InkPrecompiled PRIVATE
    <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <iostream> <limits> <map> <memory> <mutex> <optional>
    <sstream> <string> <utility> <vector>
    <vtkCommand.h> <vtkDataArrayRange.h> <vtkFloatArray.h> <vtkImageData.h> <vtkInformation.h> <vtkNew.h> <vtkPointData.h>
    <vtkPolyDataAlgorithm.h> <vtkSmartPointer.h>)
  set_target_properties(InkPrecompiled PROPERTIES POSITION_INDEPENDENT_CODE OFF)
  target_compile_options(InkPrecompiled PRIVATE ${CMAKE_CXX_COMPILE_OPTIONS_PIC})
endif ()
