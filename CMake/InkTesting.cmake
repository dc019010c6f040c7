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

# ink_add_gtest(NAME [OPENGL] SOURCES... [LIBRARIES ...]): one GoogleTest program, each of its tests a ctest
# "NAME.SUITE.TEST". OPENGL is for tests that draw: they run once more, as "NAME.SUITE.TEST.OpenGL32", with the oldest
# OpenGL that VTK takes, which Mesa has as strict as others' drivers, and leave the shaders that they compile.
function (ink_add_gtest name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "OPENGL" "" "SOURCES;LIBRARIES")
  add_executable(${name} ${arg_SOURCES})
  target_include_directories(${name} PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}")
  target_link_libraries(${name} PRIVATE ${arg_LIBRARIES} GTest::gtest_main InkTestOptions)
  ink_compile_options(${name})
  gtest_discover_tests(${name} TEST_PREFIX "${name}." DISCOVERY_TIMEOUT 60 TEST_LIST ${name}_TESTS)
  if (arg_LIBRARIES MATCHES "VTK::|vtkInk::TestingSupport")
    ink_precompiled_headers(${name} InkPrecompiledVTKTests)
  else ()
    ink_precompiled_headers(${name} InkPrecompiledTests)
  endif ()
  # Sanitizers would see nothing new, and take long.
  if (arg_OPENGL AND NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize")
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
