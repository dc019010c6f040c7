# SPDX-License-Identifier: BSD-3-Clause
find_package(GTest REQUIRED)
include(GoogleTest)
include(InkTestLabels)

# Where Mesa writes the shaders that tests compile; Testing/Shaders checks them.
set(INK_CAPTURED_SHADERS "${CMAKE_BINARY_DIR}/Testing/Shaders/Captured")

# Tests run for moments: a compiler that optimizes them less is done sooner by a quarter. What they test is as it is.
add_library(InkTestOptions INTERFACE)
if (CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  target_compile_options(InkTestOptions INTERFACE $<$<CONFIG:Release>:-O1>)
endif ()

if (_ink_precompile)
  set(_ink_test_headers <gtest/gtest.h> <random> <glm/glm.hpp> ${_ink_standard_headers})
  ink_add_precompiled_headers(InkPrecompiledTests LIBRARIES InkTestOptions GTest::gtest glm::glm HEADERS ${_ink_test_headers})
  if (NOT VTKINK_COMMON_ONLY)
    ink_add_precompiled_headers(InkPrecompiledVTKTests
      LIBRARIES InkTestOptions GTest::gtest glm::glm ${_ink_data_model_libraries} HEADERS ${_ink_test_headers} ${_ink_data_model_headers})
  endif ()
endif ()

# _ink_unity_tests(OUT TARGET SOURCES...): where libraries' sources are compiled together, those of tests are, too, each
# in a namespace of its own: they may use the same names. For that a unit includes first what its sources include.
function (_ink_unity_tests out target)
  if (NOT VTKINK_UNITY_BUILD OR CMAKE_CXX_COMPILER_LAUNCHER MATCHES "cache")
    set(${out} ${ARGN} PARENT_SCOPE)
    return ()
  endif ()
  set(together "")
  set(result "")
  foreach (source IN LISTS ARGN)
    file(READ "${CMAKE_CURRENT_SOURCE_DIR}/${source}" text)
    # What declares something in a namespace of ours, or includes under a condition, is compiled alone.
    if (text MATCHES "\nnamespace [A-Za-z:]+\n|\n#if")
      list(APPEND result "${source}")
    else ()
      list(APPEND together "${source}")
    endif ()
  endforeach ()
  list(LENGTH together count)
  if (count EQUAL 0)
    set(${out} ${result} PARENT_SCOPE)
    return ()
  endif ()
  math(EXPR units "(${count} + 7) / 8")
  foreach (unit RANGE 1 ${units})
    set(includes "")
    set(bodies "")
    math(EXPR first "(${unit} - 1) * ${count} / ${units}")
    math(EXPR last "${unit} * ${count} / ${units} - 1")
    foreach (index RANGE ${first} ${last})
      list(GET together ${index} source)
      set(path "${CMAKE_CURRENT_SOURCE_DIR}/${source}")
      set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${path}")
      get_filename_component(folder "${path}" DIRECTORY)
      file(STRINGS "${path}" lines REGEX "^#include ")
      foreach (line IN LISTS lines)
        # A header beside the source is found from there.
        if (line MATCHES "\"(.+)\"")
          if (EXISTS "${folder}/${CMAKE_MATCH_1}")
            set(line "#include \"${folder}/${CMAKE_MATCH_1}\"")
          endif ()
        endif ()
        list(APPEND includes "${line}")
      endforeach ()
      get_filename_component(name "${source}" NAME_WE)
      string(APPEND bodies "namespace ${name}\n{\n#include \"${path}\"\n}\n")
    endforeach ()
    list(REMOVE_DUPLICATES includes)
    list(JOIN includes "\n" includes)
    set(file "${CMAKE_CURRENT_BINARY_DIR}/${target}_${unit}.cxx")
    file(CONFIGURE OUTPUT "${file}" @ONLY CONTENT "@includes@\n@bodies@")
    list(APPEND result "${file}")
  endforeach ()
  set(${out} ${result} PARENT_SCOPE)
endfunction ()

option(VTKINK_TEST_NEWEST_OPENGL "Run the tests that draw also with the newest OpenGL, which the programs' tests use, too" ON)

# ink_add_gtest(NAME [OPENGL] SOURCES... [LIBRARIES ...]): one GoogleTest program, each of its tests a ctest
# "NAME.SUITE.TEST". OPENGL is for tests that draw: they run once more, as "NAME.SUITE.TEST.OpenGL32", with the oldest
# OpenGL that VTK takes, which Mesa has as strict as others' drivers, and leave the shaders that they compile.
function (ink_add_gtest name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "OPENGL" "" "SOURCES;LIBRARIES")
  _ink_unity_tests(sources ${name} ${arg_SOURCES})
  add_executable(${name} ${sources})
  target_include_directories(${name} PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}")
  target_link_libraries(${name} PRIVATE ${arg_LIBRARIES} GTest::gtest_main InkTestOptions)
  ink_compile_options(${name})
  if (NOT "${sources}" STREQUAL "${arg_SOURCES}" AND CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    # GCC warns of fixtures in anonymous namespaces where it does not see that a file is the main one.
    target_compile_options(${name} PRIVATE -Wno-subobject-linkage)
  endif ()
  # Sanitizers would see nothing new with another OpenGL, and take long.
  set(oldest OFF)
  if (arg_OPENGL AND NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize")
    set(oldest ON)
  endif ()
  if (VTKINK_TEST_NEWEST_OPENGL OR NOT oldest)
    gtest_discover_tests(${name} TEST_PREFIX "${name}." DISCOVERY_TIMEOUT 60 TEST_LIST ${name}_TESTS)
  endif ()
  if (arg_LIBRARIES MATCHES "VTK::|vtkInk::TestingSupport")
    ink_precompiled_headers(${name} InkPrecompiledVTKTests)
  else ()
    ink_precompiled_headers(${name} InkPrecompiledTests)
  endif ()
  if (oldest)
    gtest_discover_tests(${name} TEST_PREFIX "${name}." TEST_SUFFIX ".OpenGL32" DISCOVERY_TIMEOUT 60
      TEST_LIST ${name}_OPENGL32_TESTS)
  endif ()
  # ctest reads it after the lists of tests that the program wrote.
  file(CONFIGURE OUTPUT ${name}_properties.cmake @ONLY CONTENT [[
include("@PROJECT_SOURCE_DIR@/CMake/InkTestLabels.cmake")
foreach (test IN LISTS @name@_TESTS @name@_OPENGL32_TESTS)
  ink_label_test("${test}")
endforeach ()
foreach (test IN LISTS @name@_OPENGL32_TESTS)
  set_tests_properties("${test}" PROPERTIES
    ENVIRONMENT
      "MESA_GL_VERSION_OVERRIDE=3.2;MESA_GLSL_VERSION_OVERRIDE=150;MESA_SHADER_CAPTURE_PATH=@INK_CAPTURED_SHADERS@"
    FIXTURES_REQUIRED InkCapturingShaders
    FIXTURES_SETUP InkCapturedShaders)
endforeach ()
]])
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES "${CMAKE_CURRENT_BINARY_DIR}/${name}_properties.cmake")
endfunction ()
