// SPDX-License-Identifier: BSD-3-Clause
#include "InkPointSize.h"

#include "InkOpenGLCompat.h"

float InkFindLargestPoint()
{
  float range[2] = { 1.0f, 1.0f };
  glGetFloatv(GL_POINT_SIZE_RANGE, range);
  return range[1];
}

InkPointSizeByShader::InkPointSizeByShader()
  : WasEnabled(glIsEnabled(GL_PROGRAM_POINT_SIZE) == GL_TRUE)
{
  glEnable(GL_PROGRAM_POINT_SIZE);
}

InkPointSizeByShader::~InkPointSizeByShader()
{
  if (!this->WasEnabled)
  {
    glDisable(GL_PROGRAM_POINT_SIZE);
  }
}
