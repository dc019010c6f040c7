# SPDX-License-Identifier: BSD-3-Clause
# Installs the build tree, moves what was installed, then configures, builds and runs the outside project against it.
#   cmake -DSOURCE_TREE=... -DBUILD_TREE=... -DVTK_FOLDER=... -DSOURCE=... -DWORK=... -DGENERATOR=... -DCXX_FLAGS=...
#         -P run.cmake
# VTK_FOLDER is the VTK that is installed as well; without one, VTK stays where it is.
cmake_minimum_required(VERSION 3.22)

function (step)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if (NOT result EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "failed (${result}): ${command}\n${output}")
  endif ()
endfunction ()

# Fails where one of the paths lies in the source or the build tree, or in the VTK that was copied.
function (expect_elsewhere who)
  file(REAL_PATH "${WORK}" work)
  foreach (path IN LISTS ARGN)
    file(REAL_PATH "${path}" path)
    foreach (folder IN ITEMS "${SOURCE_TREE}" "${BUILD_TREE}" "${VTK_FOLDER}")
      if (folder)
        file(REAL_PATH "${folder}" folder)
        string(FIND "${path}/" "${folder}/" in_folder)
        string(FIND "${path}/" "${work}/" in_work)
        if (in_folder EQUAL 0 AND NOT in_work EQUAL 0)
          message(FATAL_ERROR "${who} uses ${path}, which lies in ${folder}")
        endif ()
      endif ()
    endforeach ()
  endforeach ()
endfunction ()

file(REMOVE_RECURSE "${WORK}")
step("${CMAKE_COMMAND}" --install "${BUILD_TREE}" --prefix "${WORK}/prefix")
file(RENAME "${WORK}/prefix" "${WORK}/moved")

# Nothing that was installed names these trees, but for what the compiler wrote into libraries as source files' names.
file(GLOB_RECURSE texts "${WORK}/moved/*.cmake" "${WORK}/moved/*.py" "${WORK}/moved/*.h" "${WORK}/moved/*.xml"
  "${WORK}/moved/*.json")
foreach (tree IN ITEMS "${SOURCE_TREE}" "${BUILD_TREE}" "${VTK_FOLDER}")
  foreach (text IN LISTS texts)
    if (tree)
      file(READ "${text}" content)
      string(FIND "${content}" "${tree}" found)
      if (NOT found EQUAL -1)
        message(FATAL_ERROR "${text} names ${tree}")
      endif ()
    endif ()
  endforeach ()
endforeach ()

set(configure "${CMAKE_COMMAND}" -G "${GENERATOR}" -S "${SOURCE}" "-DCMAKE_PREFIX_PATH=${WORK}/moved"
  "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}" -DCMAKE_BUILD_TYPE=Release)
step(${configure} -B "${WORK}/build")
step("${CMAKE_COMMAND}" --build "${WORK}/build")
step("${WORK}/build/outside")

set(programs "${WORK}/build/outside")
file(GLOB installed_programs "${WORK}/moved/bin/*")
file(GLOB installed_libraries "${WORK}/moved/lib*/libvtkInk*.so")
file(GET_RUNTIME_DEPENDENCIES
  EXECUTABLES ${programs} ${installed_programs}
  LIBRARIES ${installed_libraries}
  RESOLVED_DEPENDENCIES_VAR used
  UNRESOLVED_DEPENDENCIES_VAR missing)
list(FILTER missing EXCLUDE REGEX "^ld-linux")
if (missing)
  message(FATAL_ERROR "not found: ${missing}")
endif ()
list(LENGTH used count)
if (count EQUAL 0)
  message(FATAL_ERROR "no library was found of ${programs} ${installed_programs} ${installed_libraries}")
endif ()
expect_elsewhere("what was installed" ${used})

# ink finds the library that it loads for files of OpenVDB.
if (installed_libraries MATCHES "/libvtkInkProgramVDB.so")
  file(WRITE "${WORK}/words.vdb" "no voxels here")
  execute_process(COMMAND "${WORK}/moved/bin/ink" info "${WORK}/words.vdb" ERROR_VARIABLE output)
  if (NOT output MATCHES "not an OpenVDB file")
    message(FATAL_ERROR "expected an error of the reader of OpenVDB files, found: ${output}")
  endif ()
endif ()

# A component that is not there is named, and so are those that are.
execute_process(COMMAND ${configure} -B "${WORK}/unknown" -DMORE_COMPONENTS=FiltersKnitting
  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
string(REGEX REPLACE "[ \n]+" " " output "${output}")
foreach (part IN ITEMS "vtkInk has no component FiltersKnitting. Its components: Common" " FiltersSampling")
  string(FIND "${output}" "${part}" found)
  if (result EQUAL 0 OR found EQUAL -1)
    message(FATAL_ERROR "expected an error with \"${part}\", found (${result}): ${output}")
  endif ()
endforeach ()

# With VTK it is hundreds of megabytes.
file(REMOVE_RECURSE "${WORK}")
