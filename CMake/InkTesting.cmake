# SPDX-License-Identifier: BSD-3-Clause
find_package(GTest REQUIRED)
include(GoogleTest)
include(InkTestLabels)

# ink_add_gtest(NAME SOURCES... [LIBRARIES ...]): one GoogleTest program, each of its tests a ctest.
function (ink_add_gtest name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LIBRARIES")
  add_executable(${name} ${arg_SOURCES})
  target_include_directories(${name} PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}")
  target_link_libraries(${name} PRIVATE ${arg_LIBRARIES} GTest::gtest_main)
  ink_compile_options(${name})
  gtest_discover_tests(${name} TEST_PREFIX "${name}." DISCOVERY_TIMEOUT 60 TEST_LIST ${name}_TESTS)
  # ctest reads it after the list of tests that the program wrote.
  file(CONFIGURE OUTPUT ${name}_labels.cmake @ONLY CONTENT [[
include("@PROJECT_SOURCE_DIR@/CMake/InkTestLabels.cmake")
foreach (test IN LISTS @name@_TESTS)
  ink_label_test("${test}")
endforeach ()
]])
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES "${CMAKE_CURRENT_BINARY_DIR}/${name}_labels.cmake")
endfunction ()

# Where Mesa writes the shaders that tests compile; Testing/Shaders looks at them.
set(INK_CAPTURED_SHADERS "${CMAKE_BINARY_DIR}/Testing/Shaders/Captured")

# ink_add_vtk_tests(NAME [OPENGL] SOURCES TestA.cxx ... LIBRARIES ...): VTK-style tests, each file a function
# int TestA(int, char*[]) and a ctest "NAME.TestA". With OPENGL, the tests run once more, as "NAME.TestA.OpenGL32", with
# the oldest OpenGL that VTK takes, which Mesa has as strict as others' drivers, and leave the shaders that they compile.
function (ink_add_vtk_tests name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "OPENGL" "" "SOURCES;LIBRARIES")
  create_test_sourcelist(sources ${name}.cxx ${arg_SOURCES})
  add_executable(${name} ${sources})
  target_link_libraries(${name} PRIVATE ${arg_LIBRARIES} vtkInk::TestingSupport)
  ink_compile_options(${name})
  ink_precompiled_headers(${name})
  vtk_module_autoinit(TARGETS ${name} MODULES ${arg_LIBRARIES} VTK::RenderingOpenGL2)
  foreach (source IN LISTS arg_SOURCES)
    get_filename_component(test "${source}" NAME_WE)
    add_test(NAME "${name}.${test}" COMMAND ${name} ${test})
    ink_label_test("${name}.${test}")
    # Sanitizers would see nothing new, and take long.
    if (arg_OPENGL AND NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize")
      add_test(NAME "${name}.${test}.OpenGL32" COMMAND ${name} ${test})
      ink_label_test("${name}.${test}.OpenGL32")
      set_tests_properties("${name}.${test}.OpenGL32" PROPERTIES
        ENVIRONMENT
          "MESA_GL_VERSION_OVERRIDE=3.2;MESA_GLSL_VERSION_OVERRIDE=150;MESA_SHADER_CAPTURE_PATH=${INK_CAPTURED_SHADERS}"
        FIXTURES_REQUIRED InkCapturingShaders
        FIXTURES_SETUP InkCapturedShaders)
    endif ()
  endforeach ()
endfunction ()
