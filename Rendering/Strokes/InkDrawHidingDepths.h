// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkDrawHidingDepths_h
#define InkDrawHidingDepths_h

#include "InkOpenGLCompat.h"

#include "vtkOpenGLState.h"

/// Draws once more, depths alone, where ink covers so much of a pixel that it hides what is behind it.
/// @param draw takes the least coverage that is drawn
template <class Draw>
void InkDrawHidingDepths(vtkOpenGLState* state, const Draw& draw)
{
  constexpr float hidingCoverage = 0.5f;
  const vtkOpenGLState::ScopedglDepthMask depthMask(state);
  const vtkOpenGLState::ScopedglColorMask colorMask(state);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  draw(hidingCoverage);
}

#endif
