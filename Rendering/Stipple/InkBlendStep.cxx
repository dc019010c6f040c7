// SPDX-License-Identifier: BSD-3-Clause
#include "InkBlendStep.h"

#include "InkOpenGLCompat.h"

#include <cmath>

float InkFindBlendStep()
{
  int bits = 8;
  int type = GL_UNSIGNED_NORMALIZED;
  int buffer = GL_NONE;
  glGetIntegerv(GL_DRAW_BUFFER0, &buffer);
  // A window's own buffers, which only VTK's last copy draws into, have other names.
  if (buffer >= GL_COLOR_ATTACHMENT0 && buffer <= GL_COLOR_ATTACHMENT15)
  {
    glGetFramebufferAttachmentParameteriv(
      GL_DRAW_FRAMEBUFFER, buffer, GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE, &bits);
    glGetFramebufferAttachmentParameteriv(
      GL_DRAW_FRAMEBUFFER, buffer, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE, &type);
  }
  if (type == GL_FLOAT)
  {
    // Half floats have 11 bits of precision; those of single precision lose nothing that is seen.
    return bits > 16 ? 0.0f : std::ldexp(1.0f, -11);
  }
  return 1.0f / (std::ldexp(1.0f, bits) - 1.0f);
}
