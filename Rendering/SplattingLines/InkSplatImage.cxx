// SPDX-License-Identifier: BSD-3-Clause
#include "InkSplatImage.h"

#include "InkDrawBuffers.h"

#include "InkOpenGLCompat.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkTextureObject.h"

InkSplatImage::InkSplatImage(vtkOpenGLRenderWindow* window, Format format, int width, int height,
  InkSplatImage* beside, InkSplatImage* depth)
  : Window(window)
  , Width(width)
  , Height(height)
  , NumberOfTargets(beside ? 2 : 1)
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
      return;
  }

  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  this->Framebuffer->SetContext(window);
  this->Framebuffer->Bind();
  if (depth)
  {
    this->Framebuffer->AddDepthAttachment(depth->Texture);
  }
  this->Framebuffer->AddColorAttachment(0, this->Texture);
  if (beside)
  {
    this->Framebuffer->AddColorAttachment(1, beside->Texture);
  }
  InkActivateDrawBuffers(this->Framebuffer, this->NumberOfTargets);
  const char* reason = nullptr;
  this->Complete = vtkOpenGLFramebufferObject::GetFrameBufferStatus(GL_FRAMEBUFFER, reason);
  state->PopFramebufferBindings();
}

InkSplatImage::~InkSplatImage()
{
  this->Framebuffer->ReleaseGraphicsResources(this->Window);
  this->Texture->ReleaseGraphicsResources(this->Window);
}

void InkSplatImage::Bind()
{
  this->Framebuffer->Bind();
  InkActivateDrawBuffers(this->Framebuffer, this->NumberOfTargets);
  this->Window->GetState()->vtkglViewport(0, 0, this->Width, this->Height);
}

void InkSplatImage::BindForReading()
{
  this->Framebuffer->Bind(GL_READ_FRAMEBUFFER);
  this->Framebuffer->ActivateReadBuffer(0);
}

void InkSplatImage::CopyTo(InkSplatImage& other)
{
  this->BindForReading();
  other.Framebuffer->Bind(GL_DRAW_FRAMEBUFFER);
  other.Framebuffer->ActivateDrawBuffer(0);
  const int area[4] = { 0, this->Width, 0, this->Height };
  vtkOpenGLFramebufferObject::Blit(area, area, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

InkSplatImage::Reading::Reading(vtkTextureObject& texture)
  : Texture(&texture)
{
  this->Texture->Activate();
}

InkSplatImage::Reading::~Reading()
{
  this->Texture->Deactivate();
}

int InkSplatImage::Reading::GetUnit() const
{
  return this->Texture->GetTextureUnit();
}
