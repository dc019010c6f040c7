# SPDX-License-Identifier: BSD-3-Clause
# The OpenGL functions: the loader is another module since VTK 9.4.
if (TARGET VTK::glad)
  set(INK_OPENGL_LIBRARIES VTK::glad)
else ()
  set(INK_OPENGL_LIBRARIES VTK::glew VTK::opengl)
endif ()

# ink_add_shaders(TARGET NAME...): embeds Shaders/NAME.glsl of the current folder in a module or program, each as the
# string NAME in NAME.h, and links the OpenGL functions. `#include "FILE"` in a shader takes FILE from Shaders/ or,
# what mappers share, from Rendering/Core/Shaders, once for each shader.
function (ink_add_shaders target)
  get_target_property(real ${target} ALIASED_TARGET)
  if (NOT real)
    set(real ${target})
  endif ()
  set(folders "${CMAKE_CURRENT_SOURCE_DIR}/Shaders" "${PROJECT_SOURCE_DIR}/Rendering/Core/Shaders")
  list(TRANSFORM folders APPEND "/*.glsl" OUTPUT_VARIABLE patterns)
  file(GLOB files CONFIGURE_DEPENDS ${patterns})
  set(script "${PROJECT_SOURCE_DIR}/CMake/InkIncludeShaders.cmake")
  foreach (name IN LISTS ARGN)
    set(whole "${CMAKE_CURRENT_BINARY_DIR}/Shaders/${name}.glsl")
    add_custom_command(
      OUTPUT "${whole}"
      COMMAND "${CMAKE_COMMAND}" "-DINPUT=${CMAKE_CURRENT_SOURCE_DIR}/Shaders/${name}.glsl" "-DOUTPUT=${whole}"
        "-DFOLDERS=${folders}" -P "${script}"
      DEPENDS ${files} "${script}"
      COMMENT "Including what ${name}.glsl shares"
      VERBATIM)
    vtk_encode_string(INPUT "${whole}" HEADER_OUTPUT header SOURCE_OUTPUT source)
    target_sources(${real} PRIVATE "${header}" "${source}")
  endforeach ()
  target_include_directories(${real} PRIVATE $<BUILD_INTERFACE:${CMAKE_CURRENT_BINARY_DIR}>)
  target_link_libraries(${real} PRIVATE ${INK_OPENGL_LIBRARIES})
endfunction ()
