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
  this->Depth->SetContext(window);
  this->Depth->AllocateDepth(size[0], size[1], vtkTextureObject::Float32);
  this->Light->SetContext(window);
  this->Light->Allocate2D(size[0], size[1], 4, VTK_FLOAT);

  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();

  this->DepthFramebuffer->SetContext(window);
  this->DepthFramebuffer->Bind();
  this->DepthFramebuffer->DeactivateDrawBuffers();
  this->DepthFramebuffer->DeactivateReadBuffer();
  this->DepthFramebuffer->AddDepthAttachment(this->Depth);
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
  this->DepthFramebuffer->ReleaseGraphicsResources(this->Window);
  this->LightFramebuffer->ReleaseGraphicsResources(this->Window);
  this->Depth->ReleaseGraphicsResources(this->Window);
  this->Light->ReleaseGraphicsResources(this->Window);
}

void InkSplatTargets::BindDepth()
{
  this->DepthFramebuffer->Bind();
}

void InkSplatTargets::BindLight()
{
  this->LightFramebuffer->Bind();
  this->LightFramebuffer->ActivateDrawBuffer(0);
}
