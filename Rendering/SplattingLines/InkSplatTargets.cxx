// SPDX-License-Identifier: BSD-3-Clause
#include "InkSplatTargets.h"

#include "InkOpenGLCompat.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkTextureObject.h"

InkSplatTargets::InkSplatTargets(vtkOpenGLRenderWindow* window, const int size[2])
  : Window(window)
{
  this->ZBuffer->SetContext(window);
  this->ZBuffer->AllocateDepth(size[0], size[1], vtkTextureObject::Float32);
  this->Surface->SetContext(window);
  this->Surface->Allocate2D(size[0], size[1], 2, VTK_FLOAT);
  this->Light->SetContext(window);
  this->Light->Allocate2D(size[0], size[1], 4, VTK_FLOAT);

  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();

  this->SurfaceFramebuffer->SetContext(window);
  this->SurfaceFramebuffer->Bind();
  this->SurfaceFramebuffer->AddDepthAttachment(this->ZBuffer);
  this->SurfaceFramebuffer->AddColorAttachment(0, this->Surface);
  this->SurfaceFramebuffer->ActivateDrawBuffer(0);
  const char* reason = nullptr;
  this->Complete = vtkOpenGLFramebufferObject::GetFrameBufferStatus(GL_FRAMEBUFFER, reason);

  this->LightFramebuffer->SetContext(window);
  this->LightFramebuffer->Bind();
  this->LightFramebuffer->AddColorAttachment(0, this->Light);
  this->LightFramebuffer->ActivateDrawBuffer(0);
  this->Complete = vtkOpenGLFramebufferObject::GetFrameBufferStatus(GL_FRAMEBUFFER, reason) && this->Complete;

  state->PopFramebufferBindings();
}

InkSplatTargets::~InkSplatTargets()
{
  this->SurfaceFramebuffer->ReleaseGraphicsResources(this->Window);
  this->LightFramebuffer->ReleaseGraphicsResources(this->Window);
  this->ZBuffer->ReleaseGraphicsResources(this->Window);
  this->Surface->ReleaseGraphicsResources(this->Window);
  this->Light->ReleaseGraphicsResources(this->Window);
}

void InkSplatTargets::BindSurface()
{
  this->SurfaceFramebuffer->Bind();
  this->SurfaceFramebuffer->ActivateDrawBuffer(0);
}

void InkSplatTargets::BindLight()
{
  this->LightFramebuffer->Bind();
  this->LightFramebuffer->ActivateDrawBuffer(0);
}
