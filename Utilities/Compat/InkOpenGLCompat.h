// SPDX-License-Identifier: BSD-3-Clause
/// The OpenGL functions of the versions of VTK that vtkInk builds with. Only source files include this
/// header.
#ifndef InkOpenGLCompat_h
#define InkOpenGLCompat_h

// The OpenGL functions: GLEW up to VTK 9.3, glad from 9.4 on.
#if __has_include("vtk_glad.h")
#  include "vtk_glad.h" // IWYU pragma: export
#elif __has_include("vtk_glew.h")
#  include "vtk_glew.h" // IWYU pragma: export
#endif

#endif
