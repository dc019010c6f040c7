// SPDX-License-Identifier: BSD-3-Clause
#include "InkRenderTarget.h"

#include "InkOpenGLCompat.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkTextureObject.h"

InkRenderTarget::InkRenderTarget(vtkOpenGLRenderWindow* window, Format format, int width, int height,
  InkRenderTarget* beside, InkRenderTarget* depth)
  : Window(window)
  , Width(width)
  , Height(height)
  , NumberOfColors(format == Format::Depth ? 0
        : beside                           ? 2
                                           : 1)
{
  const auto columns = static_cast<unsigned int>(width);
  const auto rows = static_cast<unsigned int>(height);
  this->Texture->SetContext(window);
  switch (format)
  {
    case Format::Float2:
      this->Texture->Allocate2D(columns, rows, 2, VTK_FLOAT);
      break;
    case Format::Half4:
      this->Texture->SetInternalFormat(GL_RGBA16F);
      [[fallthrough]];
    case Format::Float4:
      this->Texture->Allocate2D(columns, rows, 4, VTK_FLOAT);
      break;
    case Format::Byte4:
      this->Texture->Allocate2D(columns, rows, 4, VTK_UNSIGNED_CHAR);
      break;
    case Format::Depth:
      this->Texture->AllocateDepth(columns, rows, vtkTextureObject::Float32);
      depth = this;
      break;
  }

  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  this->Framebuffer->SetContext(window);
  this->Framebuffer->Bind();
  if (depth)
  {
    this->Framebuffer->AddDepthAttachment(depth->Texture);
  }
  if (this->NumberOfColors > 0)
  {
    this->Framebuffer->AddColorAttachment(0, this->Texture);
  }
  if (beside)
  {
    this->Framebuffer->AddColorAttachment(1, beside->Texture);
  }
  this->ActivateDrawBuffers();
  const char* reason = nullptr;
  this->Complete = vtkOpenGLFramebufferObject::GetFrameBufferStatus(GL_FRAMEBUFFER, reason);
  state->PopFramebufferBindings();
}

InkRenderTarget::~InkRenderTarget()
{
  this->Framebuffer->ReleaseGraphicsResources(this->Window);
  this->Texture->ReleaseGraphicsResources(this->Window);
}

void InkRenderTarget::ActivateDrawBuffers()
{
  // vtkOpenGLState takes the draw buffers of the framebuffer before for those of this one, and would leave
  // out what that one had already.
  this->Framebuffer->DeactivateDrawBuffers();
  if (this->NumberOfColors > 0)
  {
    this->Framebuffer->ActivateDrawBuffers(static_cast<unsigned int>(this->NumberOfColors));
  }
}

void InkRenderTarget::Bind()
{
  this->Framebuffer->Bind();
  this->ActivateDrawBuffers();
  this->Window->GetState()->vtkglViewport(0, 0, this->Width, this->Height);
}

void InkRenderTarget::BindForReading()
{
  this->Framebuffer->Bind(GL_READ_FRAMEBUFFER);
  if (this->NumberOfColors > 0)
  {
    this->Framebuffer->ActivateReadBuffer(0);
  }
}

void InkRenderTarget::CopyTo(InkRenderTarget& other)
{
  this->BindForReading();
  other.Framebuffer->Bind(GL_DRAW_FRAMEBUFFER);
  if (this->NumberOfColors > 0)
  {
    other.Framebuffer->ActivateDrawBuffer(0);
  }
  const int area[4] = { 0, this->Width, 0, this->Height };
  vtkOpenGLFramebufferObject::Blit(
    area, area, this->NumberOfColors > 0 ? GL_COLOR_BUFFER_BIT : GL_DEPTH_BUFFER_BIT, GL_NEAREST);
}

InkRenderTarget::Reading::Reading(vtkTextureObject& texture)
  : Texture(&texture)
{
  this->Texture->Activate();
}

InkRenderTarget::Reading::~Reading()
{
  this->Texture->Deactivate();
}

int InkRenderTarget::Reading::GetUnit() const
{
  return this->Texture->GetTextureUnit();
}
