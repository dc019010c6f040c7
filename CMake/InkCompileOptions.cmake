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
    $<$<COMPILE_LANGUAGE:CXX>:-Wall -Wextra>
    # A source's names do not hide those of another that happens to be compiled with it.
    $<$<AND:$<COMPILE_LANGUAGE:CXX>,$<NOT:$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>>>:-Wshadow>
    $<$<COMPILE_LANGUAGE:CXX>:-Wnon-virtual-dtor -Woverloaded-virtual>)
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
  ink_unity_build(${target})
endfunction ()

# Much of what a compiler does is to read headers and to compile what they define, for each source anew.
option(VTKINK_UNITY_BUILD "Compile a folder's sources together, faster from nothing and slower after a change" OFF)
# Objects of single sources are what a compiler cache is for.
set(_ink_unity_build ${VTKINK_UNITY_BUILD})
if (CMAKE_CXX_COMPILER_LAUNCHER MATCHES "cache")
  set(_ink_unity_build OFF)
endif ()

# Lets a library or program be compiled so, a dozen sources at most at once. Names in anonymous namespaces have to differ
# within a folder.
function (ink_unity_build target)
  if (NOT _ink_unity_build)
    return ()
  endif ()
  get_target_property(sources ${target} SOURCES)
  # Generated sources, which have full paths, are alike and compile on their own.
  list(FILTER sources INCLUDE REGEX "^[^/].*\\.(cpp|cxx)$")
  set(folders "")
  foreach (source IN LISTS sources)
    get_filename_component(folder "${source}" DIRECTORY)
    string(MAKE_C_IDENTIFIER "in_${folder}" folder)
    list(APPEND folders ${folder})
    list(APPEND ${folder} "${source}")
  endforeach ()
  list(REMOVE_DUPLICATES folders)
  foreach (folder IN LISTS folders)
    list(LENGTH ${folder} count)
    math(EXPR groups "(${count} + 11) / 12")
    set(index 0)
    foreach (source IN LISTS ${folder})
      math(EXPR group "${index} * ${groups} / ${count}")
      math(EXPR index "${index} + 1")
      set_source_files_properties("${source}" PROPERTIES UNITY_GROUP "${folder}_${group}")
    endforeach ()
  endforeach ()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  if (CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # It takes sources that are included for headers.
    target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
  endif ()
endfunction ()
