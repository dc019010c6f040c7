# SPDX-License-Identifier: BSD-3-Clause
# Most of what a compiler does for a source that uses VTK, and for a test, is to read the same headers of VTK, of
# GoogleTest and of the standard library. VTKINK_PRECOMPILED_HEADERS says for which sources it reads them once. Each source
# includes what it needs all the same (Testing/Python/test_includes.py): they are not precompiled in the ParaView preset's
# libraries and in builds through a compiler cache.
set(VTKINK_PRECOMPILED_HEADERS OFF CACHE STRING "Read common headers once, not for each source: ON, TESTS (of tests alone) or OFF")
set_property(CACHE VTKINK_PRECOMPILED_HEADERS PROPERTY STRINGS ON TESTS OFF)

# Objects compiled with them are of no use in another build tree, which is what a compiler cache is for.
if (NOT VTKINK_PRECOMPILED_HEADERS OR CMAKE_CXX_COMPILER_LAUNCHER MATCHES "cache")
  set(_ink_precompile "")
elseif (VTKINK_PRECOMPILED_HEADERS STREQUAL "TESTS")
  set(_ink_precompile TESTS)
else ()
  set(_ink_precompile TESTS LIBRARIES)
endif ()

# What compiles headers and what uses them is compiled as libraries are, as position-independent code: one file serves
# libraries and programs.
function (_ink_as_libraries target)
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE OFF INK_PRECOMPILED ON)
  target_compile_options(${target} PRIVATE ${CMAKE_CXX_COMPILE_OPTIONS_PIC})
endfunction ()

# ink_add_precompiled_headers(NAME LIBRARIES targets ... HEADERS <header> ...)
function (ink_add_precompiled_headers name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "LIBRARIES;HEADERS")
  file(CONFIGURE OUTPUT "${CMAKE_BINARY_DIR}/CMakeFiles/${name}.cxx" CONTENT "")
  add_library(${name} OBJECT "${CMAKE_BINARY_DIR}/CMakeFiles/${name}.cxx")
  target_link_libraries(${name} PRIVATE ${arg_LIBRARIES})
  ink_compile_options(${name})
  target_precompile_headers(${name} PRIVATE ${arg_HEADERS})
  _ink_as_libraries(${name})
endfunction ()

# ink_precompiled_headers(TARGET [NAME]): lets a target use them, by default those of VTK's data model.
function (ink_precompiled_headers target)
  set(names InkPrecompiled ${ARGN})
  list(GET names -1 name)
  if (TARGET ${name})
    target_precompile_headers(${target} REUSE_FROM ${name})
    _ink_as_libraries(${target})
    if (CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      # GCC 12 warns of the standard library's own strings where it no longer knows that they are a system header's.
      target_compile_options(${target} PRIVATE -Wno-array-bounds -Wno-restrict -Wno-stringop-overflow -Wno-stringop-overread)
    endif ()
  endif ()
endfunction ()

set(_ink_standard_headers
  <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <iostream> <limits> <map> <memory> <mutex> <optional>
  <sstream> <string> <utility> <vector>)
if (NOT VTKINK_COMMON_ONLY)
  set(_ink_data_model_libraries VTK::CommonCore VTK::CommonDataModel VTK::CommonExecutionModel)
  set(_ink_data_model_headers
    <vtkCommand.h> <vtkDataArrayRange.h> <vtkFloatArray.h> <vtkImageData.h> <vtkInformation.h> <vtkNew.h> <vtkPointData.h>
    <vtkPolyDataAlgorithm.h> <vtkSmartPointer.h>)
  if ("LIBRARIES" IN_LIST _ink_precompile)
    ink_add_precompiled_headers(InkPrecompiled
      LIBRARIES ${_ink_data_model_libraries} HEADERS ${_ink_standard_headers} ${_ink_data_model_headers})
  endif ()
endif ()
