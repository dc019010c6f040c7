# SPDX-License-Identifier: BSD-3-Clause
# Included files stand where they are asked for first, whatever characters they have; a missing one is an error that
# names it.
cmake_minimum_required(VERSION 3.22)
file(WRITE "${WORK}/a/outer.glsl" "first;\n#include \"inner.glsl\"\n#include \"shared.glsl\"\nlast[0];\n")
file(WRITE "${WORK}/a/inner.glsl" "inner \\n;\n#include \"shared.glsl\"\n")
file(WRITE "${WORK}/b/shared.glsl" "shared [ ] \${x};\n")
file(WRITE "${WORK}/a/broken.glsl" "#include \"nowhere.glsl\"\n")

function (include_shaders name)
  execute_process(
    COMMAND "${CMAKE_COMMAND}" "-DINPUT=${WORK}/a/${name}.glsl" "-DOUTPUT=${WORK}/${name}.glsl"
      "-DFOLDERS=${WORK}/a;${WORK}/b" -P "${SCRIPT}"
    RESULT_VARIABLE result ERROR_VARIABLE error)
  set(result "${result}" PARENT_SCOPE)
  set(error "${error}" PARENT_SCOPE)
endfunction ()

include_shaders(outer)
file(READ "${WORK}/outer.glsl" text)
set(expected "first;\ninner \\n;\nshared [ ] \${x};\nlast[0];\n// outer.glsl\n")
if (NOT text STREQUAL expected)
  message(FATAL_ERROR "Expected\n${expected}found\n${text}${error}")
endif ()

include_shaders(broken)
if (result EQUAL 0 OR NOT error MATCHES "nowhere.glsl")
  message(FATAL_ERROR "Expected an error that names nowhere.glsl, found ${result}: ${error}")
endif ()
