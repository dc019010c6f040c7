// SPDX-License-Identifier: BSD-3-Clause
#include "InkSplatQuads.h"

#include "InkLinePostProcess.h"
#include "InkRenderPasses.h"
#include "InkRenderTarget.h"
#include "InkShader.h"
#include "InkViewUniforms.h"

#include "InkSplatCompositeFS.h"
#include "InkSplatIlluminationFS.h"
#include "InkSplatInkFS.h"

#include "InkOpenGLCompat.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <list>
#include <optional>
#include <vector>

namespace
{

/// How far beyond the surface is looked for its border, in heights of the picture: about as wide as contours.
constexpr double OutlineReach = 0.0025;

/// With perspective, view units per pixel grow with the distance; that of each pixel is in the shader.
void SetTolerances(
  vtkShaderProgram* program, const InkViewUniforms& view, const std::array<double, 2>& tolerances)
{
  const float limits[2] = { static_cast<float>(tolerances[0]),
    static_cast<float>(tolerances[1] * view.Pixel) };
  program->SetUniform2f("tolerances", limits);
}

} // namespace

InkSplatQuads::InkSplatQuads(vtkOpenGLRenderWindow* window)
  : Passes(window)
{
}

void InkSplatQuads::DrawIllumination(const InkViewUniforms& view, const InkRenderTarget& surface,
  const std::vector<const InkRenderTarget*>& sums, const std::array<double, 2>& tolerances, bool outline)
{
  const std::size_t coarse = sums.size() - 1;
  const std::string features =
    (coarse > 0 ? InkDefine("INK_COARSE", coarse) : "") + (outline ? InkDefine("INK_OUTLINE") : "");
  vtkShaderProgram* program = this->Passes.Begin(InkWithFeatures(InkSplatIlluminationFS, features));
  if (!program)
  {
    return;
  }
  const InkRenderTarget::Reading readSurface(*surface.GetTexture());
  program->SetUniformi("surface", readSurface.GetUnit());
  std::list<InkRenderTarget::Reading> readSums;
  for (std::size_t level = 0; level < sums.size(); ++level)
  {
    const std::string name = level == 0 ? "sums" : "coarseSums[" + std::to_string(level - 1) + "]";
    program->SetUniformi(name.c_str(), readSums.emplace_back(*sums[level]->GetTexture()).GetUnit());
  }
  SetTolerances(program, view, tolerances);
  if (outline)
  {
    program->SetUniformf("outline", static_cast<float>(std::max(OutlineReach * view.PictureHeight, 1.0)));
  }
  view.SetUniforms(program);
  this->Passes.Draw();
}

vtkSmartPointer<vtkTextureObject> InkSplatQuads::WorkOn(const InkSplatStyle& style, int layer,
  const InkViewUniforms& view, const Sheet& sheet, InkRenderTarget& scratch)
{
  const InkLinePostProcess work(style, layer, view);
  if (!work.IsNeeded())
  {
    return nullptr;
  }
  InkSplatStyle plain = style;
  plain.ToneColors = false;
  InkSplatStyle::Layer& own = plain.Layers[static_cast<std::size_t>(layer)];
  own.ScalarColors = false;
  own.Strength = 1.0;
  own.Color = { 1.0, 1.0, 1.0 };
  scratch.Bind();
  this->DrawInk(plain, layer, view, sheet, nullptr, 0);

  const int width = scratch.GetWidth();
  const int height = scratch.GetHeight();
  std::vector<unsigned char> pixels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  this->Passes.GetWindow()->GetState()->vtkglPixelStorei(GL_PACK_ALIGNMENT, 1);
  scratch.BindForReading();
  glReadPixels(0, 0, width, height, GL_RED, GL_UNSIGNED_BYTE, pixels.data());
  work.Apply({ pixels, width, height });
  auto coverage = vtkSmartPointer<vtkTextureObject>::New();
  coverage->SetContext(this->Passes.GetWindow());
  coverage->Create2DFromRaw(
    static_cast<unsigned int>(width), static_cast<unsigned int>(height), 1, VTK_UNSIGNED_CHAR, pixels.data());
  return coverage;
}

void InkSplatQuads::DrawInk(const InkSplatStyle& style, int layer, const InkViewUniforms& view,
  const Sheet& sheet, vtkTextureObject* coverage, int reach)
{
  const InkSplatStyle::Layer& own = style.Layers[static_cast<std::size_t>(layer)];
  const bool scalarColors = own.ScalarColors && sheet.Colors;
  std::string features;
  if (scalarColors)
  {
    features += InkDefine("INK_COLORS");
  }
  if (style.ToneColors)
  {
    features += InkDefine("INK_TONE");
  }
  if (coverage)
  {
    features += InkDefine("INK_COVERAGE");
  }
  else if (sheet.Averaged)
  {
    features += InkDefine("INK_AREA");
  }
  vtkShaderProgram* program = this->Passes.Begin(InkWithFeatures(InkSplatInkFS, features));
  if (!program)
  {
    return;
  }
  const InkRenderTarget::Reading read(*sheet.Illumination.GetTexture());
  program->SetUniformi("illumination", read.GetUnit());
  std::optional<InkRenderTarget::Reading> readSurface;
  if (sheet.Averaged && !coverage)
  {
    program->SetUniformi("surface", readSurface.emplace(*sheet.Surface.GetTexture()).GetUnit());
    SetTolerances(program, view, sheet.Tolerances);
    view.SetUniforms(program);
  }
  std::optional<InkRenderTarget::Reading> readColors;
  if (scalarColors)
  {
    program->SetUniformi("reach", reach);
    program->SetUniformi("colors", readColors.emplace(*sheet.Colors->GetTexture()).GetUnit());
  }
  std::optional<InkRenderTarget::Reading> readCoverage;
  if (coverage)
  {
    program->SetUniformi("coverageImage", readCoverage.emplace(*coverage).GetUnit());
  }
  program->SetUniformf("tau", static_cast<float>(style.Tau));
  program->SetUniformf("phi", static_cast<float>(style.Phi));
  program->SetUniformf("hardness", static_cast<float>(style.Hardness));
  program->SetUniformf("strength", static_cast<float>(own.Strength));
  InkSetColorUniform(program, "inkColor", own.Color.data());
  InkSetColorUniform(program, "toneColor", style.ToneColor.data());
  this->Passes.Draw();
}

void InkSplatQuads::DrawComposite(const InkViewUniforms& view, const InkRenderTarget& surface,
  const InkRenderTarget& ink, const double paperColor[3], double opacity, int reach, double depthBias,
  vtkAbstractMapper* mapper, vtkActor* actor)
{
  const InkRenderPasses renderPasses(mapper, actor);
  vtkShaderProgram* program = this->Passes.Begin(InkSplatCompositeFS, &renderPasses);
  if (!program)
  {
    return;
  }
  const InkRenderTarget::Reading readSurface(*surface.GetTexture());
  const InkRenderTarget::Reading readInk(*ink.GetTexture());
  program->SetUniformi("surface", readSurface.GetUnit());
  program->SetUniformi("ink", readInk.GetUnit());
  program->SetUniformf("farthest", 2.0f * view.DepthRange[1]);
  view.SetUniforms(program);
  program->SetUniformi("paper", paperColor != nullptr);
  const double none[3] = { 0.0, 0.0, 0.0 };
  InkSetColorUniform(program, "paperColor", paperColor ? paperColor : none);
  program->SetUniformf("opacity", static_cast<float>(opacity));
  program->SetUniformi("reach", reach);
  program->SetUniformi("margin", view.Margin);
  program->SetUniformf("depthBias", static_cast<float>(depthBias));
  this->Passes.Draw();
}
