// SPDX-License-Identifier: BSD-3-Clause
#include "InkTextureBuffer.h"

#include "InkOpenGLCompat.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

InkTextureBuffer::InkTextureBuffer(vtkOpenGLRenderWindow* window)
  : Window(window)
{
}

InkTextureBuffer::~InkTextureBuffer()
{
  this->Clear();
  this->Data->ReleaseGraphicsResources();
}

int InkTextureBuffer::FindMostTexels(vtkOpenGLRenderWindow* window)
{
  int most = 0;
  window->GetState()->vtkglGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
  return most;
}

void InkTextureBuffer::Clear()
{
  this->Texture->ReleaseGraphicsResources(this->Window);
  this->Filled = false;
}

void InkTextureBuffer::Create(unsigned int texels, int components, int type, unsigned int internalFormat)
{
  this->Texture->SetContext(this->Window);
  this->Texture->SetInternalFormat(internalFormat);
  this->Texture->CreateTextureBuffer(texels, components, type, this->Data);
  this->Filled = true;
}

void InkTextureBuffer::Activate(vtkShaderProgram* program, const char* sampler)
{
  this->Texture->Activate();
  this->Active = true;
  program->SetUniformi(sampler, this->Texture->GetTextureUnit());
}

void InkTextureBuffer::Deactivate()
{
  if (this->Active)
  {
    this->Texture->Deactivate();
    this->Active = false;
  }
}
