// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkDrawBuffers_h
#define InkDrawBuffers_h

#include "vtkOpenGLFramebufferObject.h"

/// Draws into the first color attachments of the framebuffer that is bound. vtkOpenGLState takes the draw
/// buffers of the framebuffer before for those of this one, and would leave out what that one had already.
inline void InkActivateDrawBuffers(vtkOpenGLFramebufferObject* framebuffer, int number)
{
  framebuffer->DeactivateDrawBuffers();
  framebuffer->ActivateDrawBuffers(static_cast<unsigned int>(number));
}

#endif
