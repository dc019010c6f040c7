// SPDX-License-Identifier: BSD-3-Clause
#include "InkSplatQuads.h"

#include "InkRenderPasses.h"
#include "InkShader.h"
#include "InkSplatImage.h"
#include "InkSplatLineWork.h"
#include "InkView.h"

#include "InkSplatCompositeFS.h"
#include "InkSplatIlluminationFS.h"
#include "InkSplatInkFS.h"

#include "InkOpenGLCompat.h"

#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderUtilities.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <list>
#include <optional>
#include <vector>

namespace
{

void SetColor(vtkShaderProgram* program, const char* name, const double* color)
{
  const float rgb[3] = { static_cast<float>(color[0]), static_cast<float>(color[1]),
    static_cast<float>(color[2]) };
  program->SetUniform3f(name, rgb);
}

} // namespace

InkSplatQuads::InkSplatQuads(vtkOpenGLRenderWindow* window)
  : Window(window)
{
}

InkSplatQuads::~InkSplatQuads() = default;

vtkOpenGLQuadHelper& InkSplatQuads::Find(
  const std::string& vertexShader, const std::string& fragmentShader, const std::string& geometryShader)
{
  std::unique_ptr<vtkOpenGLQuadHelper>& quad = this->Quads[vertexShader + geometryShader + fragmentShader];
  if (!quad)
  {
    quad = std::make_unique<vtkOpenGLQuadHelper>(
      this->Window, vertexShader.c_str(), fragmentShader.c_str(), geometryShader.c_str());
  }
  return *quad;
}

vtkShaderProgram* InkSplatQuads::Begin(vtkOpenGLQuadHelper& quad)
{
  return this->Window->GetShaderCache()->ReadyShaderProgram(quad.Program);
}

void InkSplatQuads::DrawIllumination(const InkView& view, const InkSplatImage& surface,
  const std::vector<const InkSplatImage*>& sums, const std::array<double, 2>& tolerances)
{
  const std::size_t coarse = sums.size() - 1;
  const std::string features = coarse > 0 ? "#define INK_COARSE " + std::to_string(coarse) : "";
  vtkOpenGLQuadHelper& quad = this->Find(vtkOpenGLRenderUtilities::GetFullScreenQuadVertexShader(),
    InkWithFeatures(InkSplatIlluminationFS, features), "");
  vtkShaderProgram* program = this->Begin(quad);
  if (!program)
  {
    return;
  }
  const InkSplatImage::Reading readSurface(*surface.GetTexture());
  program->SetUniformi("surface", readSurface.GetUnit());
  std::list<InkSplatImage::Reading> readSums;
  for (std::size_t level = 0; level < sums.size(); ++level)
  {
    const std::string name = level == 0 ? "sums" : "coarseSums[" + std::to_string(level - 1) + "]";
    program->SetUniformi(name.c_str(), readSums.emplace_back(*sums[level]->GetTexture()).GetUnit());
  }
  // With perspective, view units per pixel grow with the distance; that of each pixel is in the shader.
  const float limits[2] = { static_cast<float>(tolerances[0]),
    static_cast<float>(tolerances[1] * view.Pixel) };
  program->SetUniform2f("tolerances", limits);
  const float clipW[2] = { view.DepthToClip[2], view.DepthToClip[3] };
  program->SetUniform2f("depthToClipW", clipW);
  quad.Render();
}

vtkSmartPointer<vtkTextureObject> InkSplatQuads::WorkOn(const InkSplatStyle& style, int layer,
  const InkView& view, const InkSplatImage& illumination, InkSplatImage& scratch)
{
  const InkSplatLineWork work(style, layer, view);
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
  this->DrawInk(plain, layer, illumination, nullptr, nullptr, 0);

  const int width = scratch.GetWidth();
  const int height = scratch.GetHeight();
  std::vector<unsigned char> pixels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  this->Window->GetState()->vtkglPixelStorei(GL_PACK_ALIGNMENT, 1);
  scratch.BindForReading();
  glReadPixels(0, 0, width, height, GL_RED, GL_UNSIGNED_BYTE, pixels.data());
  work.Apply({ pixels, width, height });
  auto coverage = vtkSmartPointer<vtkTextureObject>::New();
  coverage->SetContext(this->Window);
  coverage->Create2DFromRaw(
    static_cast<unsigned int>(width), static_cast<unsigned int>(height), 1, VTK_UNSIGNED_CHAR, pixels.data());
  return coverage;
}

void InkSplatQuads::DrawInk(const InkSplatStyle& style, int layer, const InkSplatImage& illumination,
  const InkSplatImage* colors, vtkTextureObject* coverage, int reach)
{
  const InkSplatStyle::Layer& own = style.Layers[static_cast<std::size_t>(layer)];
  const bool scalarColors = own.ScalarColors && colors;
  std::string features;
  if (scalarColors)
  {
    features += "#define INK_COLORS\n";
  }
  if (style.ToneColors)
  {
    features += "#define INK_TONE\n";
  }
  if (coverage)
  {
    features += "#define INK_COVERAGE\n";
  }
  vtkOpenGLQuadHelper& quad = this->Find(
    vtkOpenGLRenderUtilities::GetFullScreenQuadVertexShader(), InkWithFeatures(InkSplatInkFS, features), "");
  vtkShaderProgram* program = this->Begin(quad);
  if (!program)
  {
    return;
  }
  const InkSplatImage::Reading read(*illumination.GetTexture());
  program->SetUniformi("illumination", read.GetUnit());
  std::optional<InkSplatImage::Reading> readColors;
  if (scalarColors)
  {
    program->SetUniformi("reach", reach);
    program->SetUniformi("colors", readColors.emplace(*colors->GetTexture()).GetUnit());
  }
  std::optional<InkSplatImage::Reading> readCoverage;
  if (coverage)
  {
    program->SetUniformi("coverageImage", readCoverage.emplace(*coverage).GetUnit());
  }
  program->SetUniformf("tau", static_cast<float>(style.Tau));
  program->SetUniformf("phi", static_cast<float>(style.Phi));
  program->SetUniformf("hardness", static_cast<float>(style.Hardness));
  program->SetUniformf("strength", static_cast<float>(own.Strength));
  SetColor(program, "inkColor", own.Color.data());
  SetColor(program, "toneColor", style.ToneColor.data());
  quad.Render();
}

void InkSplatQuads::DrawComposite(const InkView& view, const InkSplatImage& surface, const InkSplatImage& ink,
  const double paperColor[3], double opacity, int reach, double depthBias, vtkAbstractMapper* mapper,
  vtkActor* actor)
{
  std::string vertexShader = vtkOpenGLRenderUtilities::GetFullScreenQuadVertexShader();
  std::string fragmentShader = InkSplatCompositeFS;
  std::string geometryShader;
  const InkRenderPasses renderPasses(mapper, actor);
  renderPasses.ReplaceShaderValues(vertexShader, geometryShader, fragmentShader);
  vtkOpenGLQuadHelper& quad = this->Find(vertexShader, fragmentShader, geometryShader);
  vtkShaderProgram* program = this->Begin(quad);
  if (!program)
  {
    return;
  }

  // Culling, if the actor asks for it, concerns its surface and not this quad.
  vtkOpenGLState* state = this->Window->GetState();
  const vtkOpenGLState::ScopedglEnableDisable culling(state, GL_CULL_FACE);
  state->vtkglDisable(GL_CULL_FACE);
  const InkSplatImage::Reading readSurface(*surface.GetTexture());
  const InkSplatImage::Reading readInk(*ink.GetTexture());
  program->SetUniformi("surface", readSurface.GetUnit());
  program->SetUniformi("ink", readInk.GetUnit());
  program->SetUniformf("farthest", 2.0f * view.DepthRange[1]);
  program->SetUniform4f("depthToClip", view.DepthToClip.data());
  program->SetUniformi("paper", paperColor != nullptr);
  const double none[3] = { 0.0, 0.0, 0.0 };
  SetColor(program, "paperColor", paperColor ? paperColor : none);
  program->SetUniformf("opacity", static_cast<float>(opacity));
  program->SetUniformi("reach", reach);
  program->SetUniformi("margin", view.Margin);
  program->SetUniformf("depthBias", static_cast<float>(depthBias));
  renderPasses.SetShaderParameters(program, quad.VAO);
  quad.Render();
}
