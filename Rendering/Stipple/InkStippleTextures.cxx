// SPDX-License-Identifier: BSD-3-Clause
#include "InkStippleTextures.h"

#include "InkStipplePoints.h"

#include "InkOpenGLCompat.h"

#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <sstream>

InkStippleTextures::InkStippleTextures(vtkOpenGLRenderWindow* window)
  : Window(window)
{
}

InkStippleTextures::~InkStippleTextures()
{
  for (Buffer* buffer : { &this->Shapes, &this->Values, &this->Ids, &this->Boxes, &this->Colors })
  {
    buffer->Texture->ReleaseGraphicsResources(this->Window);
    buffer->Data->ReleaseGraphicsResources();
  }
}

template <typename T>
void InkStippleTextures::Fill(
  Buffer& buffer, const std::vector<T>& values, int components, int type, unsigned int internalFormat)
{
  buffer.Texture->ReleaseGraphicsResources(this->Window);
  buffer.Filled = !values.empty();
  if (buffer.Filled)
  {
    buffer.Data->Upload(values, vtkOpenGLBufferObject::TextureBuffer);
    buffer.Texture->SetContext(this->Window);
    buffer.Texture->SetInternalFormat(internalFormat);
    buffer.Texture->CreateTextureBuffer(
      static_cast<unsigned int>(values.size()), components, type, buffer.Data);
  }
}

std::string InkStippleTextures::Upload(
  const InkStipplePoints& points, const std::vector<ink::stipple::QuantizationBox>& boxes)
{
  int most = 0;
  this->Window->GetState()->vtkglGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
  const std::size_t count = points.GetShapes().size();
  if (count > static_cast<std::size_t>(most))
  {
    std::ostringstream message;
    message << "This OpenGL can look up " << most << " elements; the input has " << count << '.';
    return message.str();
  }
  this->Fill(this->Shapes, points.GetShapes(), 4, VTK_FLOAT, GL_RGBA32F);
  this->Fill(this->Values, points.GetValues(), 2, VTK_FLOAT, GL_RG32F);
  this->Fill(this->Ids, points.GetIds(), 2, VTK_UNSIGNED_INT, GL_RG32UI);
  this->Fill(this->Boxes, boxes, 4, VTK_FLOAT, GL_RGBA32F);
  return {};
}

void InkStippleTextures::UploadColors(const std::vector<std::uint32_t>& colors)
{
  this->Fill(this->Colors, colors, 4, VTK_UNSIGNED_CHAR, GL_RGBA8);
}

void InkStippleTextures::Activate(vtkShaderProgram* program)
{
  const auto activate = [&](Buffer& buffer, const char* name)
  {
    buffer.Texture->Activate();
    program->SetUniformi(name, buffer.Texture->GetTextureUnit());
  };
  activate(this->Shapes, "elementShapes");
  activate(this->Values, "elementValues");
  activate(this->Ids, "elementIds");
  if (this->Boxes.Filled)
  {
    activate(this->Boxes, "elementBoxes");
  }
  // A sampler needs a texture of its kind, also if it is not read.
  activate(this->Colors.Filled ? this->Colors : this->Shapes, "elementColors");
  program->SetUniformi("ownColors", this->Colors.Filled);
}

void InkStippleTextures::Deactivate()
{
  for (Buffer* buffer : { &this->Shapes, &this->Values, &this->Ids, &this->Boxes, &this->Colors })
  {
    if (buffer->Filled)
    {
      buffer->Texture->Deactivate();
    }
  }
}
