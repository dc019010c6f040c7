// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkScopedState_h
#define InkScopedState_h

#include "vtkOpenGLState.h"

/// Restores all of the caller's OpenGL state at its end, its framebuffer and blend equation included.
struct InkScopedState
{
  explicit InkScopedState(vtkOpenGLState* state)
    : State(state)
  {
    this->State->Push();
  }
  ~InkScopedState() { this->State->Pop(); }
  InkScopedState(const InkScopedState&) = delete;
  void operator=(const InkScopedState&) = delete;

private:
  vtkOpenGLState* State;
};

#endif
