// SPDX-License-Identifier: BSD-3-Clause
#include "InkStippleTextures.h"

#include "InkStipplePoints.h"

#include "InkOpenGLCompat.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <sstream>

InkStippleTextures::InkStippleTextures(vtkOpenGLRenderWindow* window)
  : Window(window)
  , Shapes(window)
  , Values(window)
  , Ids(window)
  , Boxes(window)
  , Colors(window)
{
}

std::string InkStippleTextures::Upload(
  const InkStipplePoints& points, const std::vector<ink::stipple::QuantizationBox>& boxes)
{
  const int most = InkTextureBuffer::FindMostTexels(this->Window);
  const std::size_t count = points.GetShapes().size();
  if (count > static_cast<std::size_t>(most))
  {
    std::ostringstream message;
    message << "This OpenGL can look up " << most << " elements; the input has " << count << '.';
    return message.str();
  }
  this->Shapes.Fill(points.GetShapes(), 4, VTK_FLOAT, GL_RGBA32F);
  this->Values.Fill(points.GetValues(), 2, VTK_FLOAT, GL_RG32F);
  this->Ids.Fill(points.GetIds(), 2, VTK_UNSIGNED_INT, GL_RG32UI);
  this->Boxes.Fill(boxes, 4, VTK_FLOAT, GL_RGBA32F);
  return {};
}

void InkStippleTextures::UploadColors(const std::vector<std::uint32_t>& colors)
{
  this->Colors.Fill(colors, 4, VTK_UNSIGNED_CHAR, GL_RGBA8);
}

void InkStippleTextures::Activate(vtkShaderProgram* program)
{
  this->Shapes.Activate(program, "elementShapes");
  this->Values.Activate(program, "elementValues");
  this->Ids.Activate(program, "elementIds");
  if (this->Boxes.IsFilled())
  {
    this->Boxes.Activate(program, "elementBoxes");
  }
  // A sampler needs a texture of its kind, also if it is not read.
  (this->Colors.IsFilled() ? this->Colors : this->Shapes).Activate(program, "elementColors");
  program->SetUniformi("ownColors", this->Colors.IsFilled());
}

void InkStippleTextures::Deactivate()
{
  for (InkTextureBuffer* buffer : { &this->Shapes, &this->Values, &this->Ids, &this->Boxes, &this->Colors })
  {
    buffer->Deactivate();
  }
}
