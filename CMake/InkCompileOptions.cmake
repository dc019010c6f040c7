# SPDX-License-Identifier: BSD-3-Clause
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
if (NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif ()

# Same input, same marks: a compiler that fuses a*b+c on one machine and not on another would move points.
# Linked privately to every target of ours; generated wrapper code does not get the warnings.
add_library(InkOptions INTERFACE)
add_library(InkWarnings INTERFACE)
if (CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  target_compile_options(InkOptions INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-ffp-contract=off>)
  target_compile_options(InkWarnings INTERFACE
    $<$<COMPILE_LANGUAGE:CXX>:-Wall -Wextra -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual>)
  if (VTKINK_WARNINGS_AS_ERRORS)
    # With precompiled headers GCC warns of what system headers hold; sources without them find what is ours.
    target_compile_options(InkWarnings INTERFACE $<$<NOT:$<BOOL:$<TARGET_PROPERTY:INK_PRECOMPILED>>>:-Werror>)
  endif ()
endif ()

# Applies the options to a target.
function (ink_compile_options target)
  target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:InkOptions> $<BUILD_INTERFACE:InkWarnings>)
endfunction ()

# The same for a VTK module, which may also include InkVTKCompat.h in its sources.
function (ink_module_options module)
  vtk_module_link(${module} PRIVATE $<BUILD_INTERFACE:InkOptions> $<BUILD_INTERFACE:InkWarnings>)
  vtk_module_include(${module} PRIVATE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/Utilities/Compat>)
  get_target_property(target ${module} ALIASED_TARGET)
  ink_precompiled_headers(${target})
endfunction ()
