find_package(GTest REQUIRED)
include(GoogleTest)

# ink_add_gtest(NAME SOURCES... [LIBRARIES ...]): one GoogleTest program, each of its tests a ctest.
function (ink_add_gtest name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LIBRARIES")
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE ${arg_LIBRARIES} GTest::gtest_main)
  ink_compile_options(${name})
  gtest_discover_tests(${name} TEST_PREFIX "${name}." DISCOVERY_TIMEOUT 60)
endfunction ()

# ink_add_vtk_tests(NAME SOURCES TestA.cxx ... LIBRARIES ...): VTK-style tests, each file a function
# int TestA(int, char*[]) and a ctest "NAME.TestA".
function (ink_add_vtk_tests name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LIBRARIES")
  create_test_sourcelist(sources ${name}.cxx ${arg_SOURCES})
  add_executable(${name} ${sources})
  target_link_libraries(${name} PRIVATE ${arg_LIBRARIES} vtkInk::TestingSupport)
  ink_compile_options(${name})
  vtk_module_autoinit(TARGETS ${name} MODULES ${arg_LIBRARIES} VTK::RenderingOpenGL2)
  foreach (source IN LISTS arg_SOURCES)
    get_filename_component(test "${source}" NAME_WE)
    add_test(NAME "${name}.${test}" COMMAND ${name} ${test})
  endforeach ()
endfunction ()
