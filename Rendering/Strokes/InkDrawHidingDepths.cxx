// SPDX-License-Identifier: BSD-3-Clause
#include "InkDrawHidingDepths.h"

#include "InkFrame.h"
#include "InkHasVolumes.h"
#include "InkRenderPasses.h"

#include "InkOpenGLCompat.h"

#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <optional>

namespace
{

/// Binds the framebuffer that VTK's order-independent pass adds its own one to, while it draws into that.
class OuterFramebuffer
{
public:
  explicit OuterFramebuffer(vtkOpenGLState* state)
    : State(state)
  {
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &this->Inner);
    // The pass has put it on the state's stack, to take it from there at its end.
    this->State->PopFramebufferBindings();
  }
  ~OuterFramebuffer()
  {
    this->State->PushFramebufferBindings();
    this->State->vtkglBindFramebuffer(GL_FRAMEBUFFER, static_cast<unsigned int>(this->Inner));
  }
  OuterFramebuffer(const OuterFramebuffer&) = delete;
  void operator=(const OuterFramebuffer&) = delete;

private:
  vtkOpenGLState* State;
  int Inner = 0;
};

} // namespace

void InkDrawHidingDepths(vtkOpenGLState* state, const InkFrame& frame, const InkRenderPasses& renderPasses,
  vtkShaderProgram* program, const std::function<void(float)>& draw)
{
  constexpr float hidingCoverage = 0.5f;
  const bool independent = renderPasses.IsOrderIndependent() && !frame.Renderer->GetPass() &&
    InkHasVolumes(frame.Renderer->GetViewProps());
  if (!renderPasses.IsEmpty() && !independent)
  {
    return;
  }
  const vtkOpenGLState::ScopedglDepthMask depthMask(state);
  const vtkOpenGLState::ScopedglColorMask colorMask(state);
  const vtkOpenGLState::ScopedglViewport viewport(state);
  std::optional<OuterFramebuffer> outer;
  if (independent)
  {
    outer.emplace(state);
    InkFrame picture = frame;
    auto& [x, y, width, height] = picture.Viewport;
    frame.Renderer->GetTiledSizeAndOrigin(&width, &height, &x, &y);
    picture.SetOrigin(program);
    state->vtkglViewport(x, y, width, height);
  }
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  draw(hidingCoverage);
}
