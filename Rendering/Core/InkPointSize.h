// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkPointSize_h
#define InkPointSize_h

#include "vtkInkRenderingCoreModule.h" // for the export macro

/// The diameter in pixels of the largest point that the current OpenGL draws.
VTKINKRENDERINGCORE_EXPORT float InkFindLargestPoint();

/// Lets vertex shaders set gl_PointSize while it lives. (vtkOpenGLState does not know this state.)
class VTKINKRENDERINGCORE_EXPORT InkPointSizeByShader
{
public:
  InkPointSizeByShader();
  ~InkPointSizeByShader();
  InkPointSizeByShader(const InkPointSizeByShader&) = delete;
  void operator=(const InkPointSizeByShader&) = delete;

private:
  bool WasEnabled;
};

#endif
