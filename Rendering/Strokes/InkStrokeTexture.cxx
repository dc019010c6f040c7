// SPDX-License-Identifier: BSD-3-Clause
#include "InkStrokeTexture.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkShaderProgram.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <sstream>

InkStrokeTexture::InkStrokeTexture(vtkOpenGLRenderWindow* window)
  : Window(window)
{
}

InkStrokeTexture::~InkStrokeTexture()
{
  this->Texture->ReleaseGraphicsResources(this->Window);
}

std::string InkStrokeTexture::Update(vtkImageData* image)
{
  vtkDataArray* scalars = image ? image->GetPointData()->GetScalars() : nullptr;
  const vtkMTimeType time = image ? std::max(image->GetMTime(), scalars ? scalars->GetMTime() : 0) : 0;
  if (time == this->ImageTime)
  {
    return {};
  }
  this->ImageTime = time;
  this->Components = 0;
  this->Texture->ReleaseGraphicsResources(this->Window);
  if (!image)
  {
    return {};
  }
  int size[3];
  image->GetDimensions(size);
  auto* bytes = vtkUnsignedCharArray::SafeDownCast(scalars);
  const int components = bytes ? bytes->GetNumberOfComponents() : 0;
  std::ostringstream message;
  if (size[0] < 1 || size[1] < 1 || size[2] != 1 || (components != 1 && components != 4) ||
    bytes->GetNumberOfTuples() != image->GetNumberOfPoints())
  {
    message << "The texture of strokes is to be a 2D image of unsigned char with 1 or 4 components; found "
            << size[0] << " x " << size[1] << " x " << size[2] << " pixels and "
            << (scalars ? scalars->GetNumberOfTuples() : 0) << " values of "
            << (scalars ? scalars->GetDataTypeAsString() : "no array") << " with "
            << (scalars ? scalars->GetNumberOfComponents() : 0) << " components.";
    return message.str();
  }
  this->Texture->SetContext(this->Window);
  this->Texture->SetWrapS(vtkTextureObject::Repeat);
  this->Texture->SetWrapT(vtkTextureObject::ClampToEdge);
  this->Texture->SetMagnificationFilter(vtkTextureObject::Linear);
  this->Texture->SetMinificationFilter(vtkTextureObject::LinearMipmapLinear);
  this->Texture->SetGenerateMipmap(true);
  if (!this->Texture->Create2DFromRaw(static_cast<unsigned int>(size[0]), static_cast<unsigned int>(size[1]),
        components, VTK_UNSIGNED_CHAR, bytes->GetPointer(0)))
  {
    message << "This OpenGL cannot take the texture of strokes, of " << size[0] << " x " << size[1]
            << " pixels.";
    return message.str();
  }
  this->Components = components;
  return {};
}

void InkStrokeTexture::Activate(vtkShaderProgram* program, const char* sampler)
{
  this->Texture->Activate();
  program->SetUniformi(sampler, this->Texture->GetTextureUnit());
  this->Active = true;
}

void InkStrokeTexture::Deactivate()
{
  if (this->Active)
  {
    this->Texture->Deactivate();
    this->Active = false;
  }
}
