// SPDX-License-Identifier: BSD-3-Clause
#include "InkStrokePasses.h"

#include "InkDrawHidingDepths.h"
#include "InkFrame.h"
#include "InkLights.h"
#include "InkOccluder.h"
#include "InkPointSize.h"
#include "InkRenderPasses.h"
#include "InkScopedState.h"
#include "InkShader.h"
#include "InkStrokePoints.h"
#include "InkStrokeRuns.h"
#include "InkStrokeStyle.h"
#include "InkViewUniforms.h"

#include "InkStrokeFS.h"
#include "InkStrokePointFS.h"
#include "InkStrokePointVS.h"
#include "InkStrokeVS.h"

#include "InkOpenGLCompat.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkTimeStamp.h"

#include <algorithm>
#include <array>
#include <sstream>

namespace
{

/// Of the image with a pixel for each point, as InkStrokeSegment.glsl has it.
constexpr int ImageWidth = 1 << 11;

} // namespace

InkStrokeRunBuffers::InkStrokeRunBuffers(vtkOpenGLRenderWindow* window)
  : Points(window)
  , Runs(window)
{
}

void InkStrokeRunBuffers::Upload(const InkStrokeRuns& runs)
{
  this->Points.Fill(runs.Points, 4, VTK_UNSIGNED_INT, GL_RGBA32UI);
  this->Runs.Fill(runs.Runs, 4, VTK_INT, GL_RGBA32I);
  this->NumberOfPoints = static_cast<int>(runs.Points.size());
}

InkStrokePasses::InkStrokePasses(vtkOpenGLRenderWindow* window)
  : Window(window)
  , Points(window)
  , Shapes(window)
  , Strokes(window)
  , Hatches(window)
  , SpacingRatios(window)
  , Ids(window)
  , Colors(window)
  , Texture(window)
{
}

std::string InkStrokePasses::Upload(const InkStrokePoints& points)
{
  vtkTimeStamp now;
  now.Modified();
  this->UploadTime = now.GetMTime();
  const std::size_t count = points.GetPoints().size();
  // Of hatching there are two for each point.
  const int most =
    InkTextureBuffer::FindMostTexels(this->Window) / (points.GetSpacingRatios().empty() ? 1 : 2);
  if (count > static_cast<std::size_t>(most))
  {
    std::ostringstream message;
    message << "This OpenGL can look up " << most << " points of strokes; the input has " << count << '.';
    return message.str();
  }
  std::vector<std::array<float, 4>> strokes;
  std::vector<std::array<float, 2>> hatches;
  strokes.reserve(points.GetStrokes().size());
  hatches.reserve(points.GetStrokes().size());
  for (const InkStrokePoints::Stroke& stroke : points.GetStrokes())
  {
    strokes.push_back({ stroke.ArcBegin, stroke.ArcLength, stroke.Priority, stroke.Closed ? 1.0f : 0.0f });
    hatches.push_back({ stroke.Spacing, static_cast<float>(stroke.Family) });
  }
  this->Points.Fill(points.GetPoints(), 4, VTK_FLOAT, GL_RGBA32F);
  this->Shapes.Fill(points.GetShapes(), 4, VTK_FLOAT, GL_RGBA32F);
  this->Strokes.Fill(strokes, 4, VTK_FLOAT, GL_RGBA32F);
  this->Hatches.Fill(hatches, 2, VTK_FLOAT, GL_RG32F);
  std::vector<std::array<float, 4>> ratios;
  ratios.reserve(2 * points.GetSpacingRatios().size());
  for (const ink::hatching::SpacingRatios& of : points.GetSpacingRatios())
  {
    ratios.push_back({ of[0], of[1], of[2], of[3] });
    ratios.push_back({ of[4], of[5], of[6], of[7] });
  }
  this->SpacingRatios.Fill(ratios, 4, VTK_FLOAT, GL_RGBA32F);
  this->Ids.Fill(points.GetIds(), 1, VTK_UNSIGNED_INT, GL_R32UI);
  return {};
}

void InkStrokePasses::UploadColors(const std::vector<std::uint32_t>& colors)
{
  this->Colors.Fill(colors, 4, VTK_UNSIGNED_CHAR, GL_RGBA8);
}

bool InkStrokePasses::FindPoints(const Scene& scene)
{
  const int rows = (scene.NumberOfPoints + ImageWidth - 1) / ImageWidth;
  if (!this->PointPositions || this->PointPositions->GetHeight() < rows)
  {
    using Format = InkRenderTarget::Format;
    // With room for a growing number of points.
    const int height = rows + rows / 2;
    this->PointPositions.reset();
    this->PointShapes = std::make_unique<InkRenderTarget>(this->Window, Format::Float4, ImageWidth, height);
    this->PointPositions = std::make_unique<InkRenderTarget>(
      this->Window, Format::Float4, ImageWidth, height, this->PointShapes.get());
  }
  if (!this->PointPositions->IsComplete())
  {
    return false;
  }
  vtkOpenGLState* state = this->Window->GetState();
  const InkScopedState scoped(state);
  this->PointPositions->Bind();
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_STENCIL_TEST);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);

  const InkStrokeStyle& style = scene.Style;
  const std::string features = style.Voxels ? InkDefine("INK_VOXELS")
    : style.BackEdges                       ? InkDefine("INK_EDGES")
    : style.Hatching ? InkDefine("INK_HATCHING") + InkFindLightFeatures(style.Hatching->Lights)
                     : "";
  InkShaderPass& pass = this->Passes.Find(InkWithFeatures(InkStrokePointVS, features), "", InkStrokePointFS);
  vtkShaderProgram* program = pass.Begin(this->Window, this->UploadTime, [](auto*, auto*) {});
  if (!program)
  {
    return false;
  }
  scene.View.SetUniforms(program);
  const float size[2] = { static_cast<float>(ImageWidth),
    static_cast<float>(this->PointPositions->GetHeight()) };
  program->SetUniform2f("imageSize", size);
  program->SetUniform2f("halfWidth", style.HalfWidth.data());
  program->SetUniformf("depthWidth", style.DepthWidth);
  program->SetUniform2f("distances", style.Distances.data());
  program->SetUniformf("lift", style.Lift);
  scene.Runs.Points.Activate(program, "drawnPoints");
  scene.Runs.Runs.Activate(program, "runs");
  this->Points.Activate(program, "sourcePoints");
  this->Shapes.Activate(program, "sourceShapes");
  this->Strokes.Activate(program, "strokes");
  if (style.Hatching)
  {
    program->SetUniformf("taper", style.Taper);
    this->SetHatchingUniforms(program, *style.Hatching);
  }
  if (style.AreFoundByEye())
  {
    program->SetUniform4f("eyeMC", style.Eye.data());
  }
  if (style.Voxels)
  {
    program->SetUniform2f("valueBounds", style.Voxels->ValueBounds.data());
    program->SetUniformf("leastGradient", style.Voxels->LeastGradient);
    program->SetUniformf("largestCosine", style.Voxels->LargestCosine);
    program->SetUniformf("segmentLength", style.Voxels->SegmentLength);
  }
  const InkPointSizeByShader pointSize;
  glDrawArrays(GL_POINTS, 0, scene.NumberOfPoints);
  this->DeactivateTextures(scene);
  pass.End();
  return true;
}

std::vector<float> InkStrokePasses::FindWidths(const Scene& scene)
{
  std::vector<float> widths;
  if (this->FindPoints(scene))
  {
    const InkRenderTarget::Reading reading(*this->PointShapes->GetTexture());
    std::vector<std::array<float, 4>> texels(
      static_cast<std::size_t>(this->PointShapes->GetHeight()) * ImageWidth);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, texels.data());
    texels.resize(static_cast<std::size_t>(scene.NumberOfPoints));
    widths.reserve(texels.size());
    for (const std::array<float, 4>& shape : texels)
    {
      widths.push_back(2.0f * shape[0]); // half of it is there
    }
  }
  return widths;
}

void InkStrokePasses::SetHatchingUniforms(vtkShaderProgram* program, const InkHatching& hatching)
{
  const ink::hatching::Intensity& intensity = hatching.Intensity;
  program->SetUniform2f("hatchSpacing", hatching.Spacing.data());
  program->SetUniformf("crosshatching", hatching.Crosshatching);
  program->SetUniformf("silhouetteWeight", intensity.silhouetteWeight);
  const float truncations[2] = { intensity.diffuseTruncation, intensity.silhouetteTruncation };
  program->SetUniform2f("truncations", truncations);
  program->SetUniformf("toneBias", intensity.bias);
  program->SetUniformf("darkest", intensity.darkest);
  program->SetUniformf("cullingCosine", hatching.CullingCosine);
  InkSetLightUniforms(program, hatching.Lights);
  this->Hatches.Activate(program, "hatches");
  this->SpacingRatios.Activate(program, "spacingRatios");
}

void InkStrokePasses::ActivateTextures(vtkShaderProgram* program, const Scene& scene, bool ids)
{
  const auto activate = [&](vtkTextureObject* texture, const char* sampler)
  {
    texture->Activate();
    program->SetUniformi(sampler, texture->GetTextureUnit());
  };
  activate(this->PointPositions->GetTexture(), "pointPositions");
  activate(this->PointShapes->GetTexture(), "pointShapes");
  scene.Runs.Points.Activate(program, "drawnPoints");
  scene.Runs.Runs.Activate(program, "runs");
  this->Strokes.Activate(program, "strokes");
  if (scene.View.NumberOfClippingPlanes > 0)
  {
    this->Points.Activate(program, "sourcePoints");
  }
  if (ids)
  {
    this->Ids.Activate(program, "pointIds");
  }
  else if (this->Colors.IsFilled())
  {
    this->Colors.Activate(program, "pointColors");
  }
  if (this->Texture.IsFilled() && !ids)
  {
    this->Texture.Activate(program, "strokeTexture");
  }
  if (scene.Occluder)
  {
    activate(scene.Occluder->Image.GetTexture(), "occluder");
  }
}

void InkStrokePasses::DeactivateTextures(const Scene& scene)
{
  this->PointPositions->GetTexture()->Deactivate();
  this->PointShapes->GetTexture()->Deactivate();
  this->Texture.Deactivate();
  if (scene.Occluder)
  {
    scene.Occluder->Image.GetTexture()->Deactivate();
  }
  for (InkTextureBuffer* buffer : { &this->Points, &this->Shapes, &this->Strokes, &this->Hatches,
         &this->SpacingRatios, &this->Ids, &this->Colors, &scene.Runs.Points, &scene.Runs.Runs })
  {
    buffer->Deactivate();
  }
}

void InkStrokePasses::SetUniforms(
  vtkShaderProgram* program, const Scene& scene, const InkFrame& frame, double opacity)
{
  const InkStrokeStyle& style = scene.Style;
  scene.View.SetUniforms(program);
  frame.SetOrigin(program);
  program->SetUniformf("density", style.Density);
  program->SetUniformf("taper", style.Taper);
  program->SetUniformi("miter", style.Miter);
  program->SetUniformf("miterLimit", style.MiterLimit);
  program->SetUniformi("butt", style.Butt);
  program->SetUniformi("dashed", style.Dashed);
  program->SetUniformi("hiddenDashed", style.HiddenDashed);
  program->SetUniform2f("dash", style.Dash.data());
  program->SetUniformf("textureLength", style.TextureLength);
  program->SetUniformf("lift", style.Lift);
  program->SetUniformf("hiddenOpacity", style.HiddenOpacity);
  program->SetUniformf("actorOpacity", static_cast<float>(opacity));
  InkSetColorUniform(program, "inkColor", style.Color.data());
  if (scene.Occluder)
  {
    scene.Occluder->SetUniforms(program, scene.View);
  }
}

bool InkStrokePasses::Draw(
  const Scene& scene, const InkFrame& frame, double opacity, const InkRenderPasses& renderPasses)
{
  if (scene.NumberOfPoints == 0)
  {
    return true;
  }
  if (!this->FindPoints(scene))
  {
    return false;
  }
  const bool textured = this->Texture.IsFilled() && !frame.Ids;
  const bool colors = this->Colors.IsFilled() && !frame.Ids;
  const std::string features = scene.View.FindFeatures() + (frame.Ids ? InkDefine("INK_IDS") : "") +
    (colors ? InkDefine("INK_COLORS") : "") + (textured ? InkDefine("INK_TEXTURE") : "") +
    (textured && this->Texture.HasColors() ? InkDefine("INK_TINTED") : "") +
    (scene.Occluder ? InkDefine("INK_OCCLUDED") : "") +
    (scene.Occluder && (scene.Style.Hatching || scene.Style.AreFoundByEye()) ? InkDefine("INK_HIDDEN") : "") +
    (scene.Style.Miter ? InkDefine("INK_MITER") : "") +
    (scene.Style.Dashed || scene.Style.HiddenDashed ? InkDefine("INK_DASHED") : "");
  std::string vertexShader = InkStrokeVS;
  std::string geometryShader;
  std::string fragmentShader = InkWithFeatures(InkStrokeFS, features);
  if (!frame.Ids)
  {
    renderPasses.ReplaceShaderValues(vertexShader, geometryShader, fragmentShader);
  }
  InkShaderPass& pass = this->Passes.Find(vertexShader, geometryShader, fragmentShader);
  vtkShaderProgram* program = pass.Begin(this->Window, this->UploadTime, [](auto*, auto*) {});
  if (!program)
  {
    return true;
  }
  this->SetUniforms(program, scene, frame, opacity);
  this->ActivateTextures(program, scene, frame.Ids.has_value());
  // Strokes that the shader makes have two points, and nothing lies between one stroke and the next.
  const int step = scene.Style.AreFoundByEye() ? 2 : 1;
  program->SetUniformi("segmentStep", step);
  const int vertices = 6 * (scene.NumberOfPoints / step - (step == 1 ? 1 : 0));
  const auto draw = [&](float leastCoverage)
  {
    program->SetUniformf("leastCoverage", leastCoverage);
    glDrawArrays(GL_TRIANGLES, 0, vertices);
  };
  if (frame.Ids)
  {
    frame.Ids->SetUniforms(program);
    draw(0.0f);
  }
  else
  {
    renderPasses.SetShaderParameters(program, pass.GetVertexArray());
    draw(0.0f);
    InkDrawHidingDepths(this->Window->GetState(), frame, renderPasses, program, draw);
  }
  this->DeactivateTextures(scene);
  pass.End();
  return true;
}
