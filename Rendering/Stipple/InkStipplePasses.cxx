// SPDX-License-Identifier: BSD-3-Clause
#include "InkStipplePasses.h"

#include "InkBlendStep.h"
#include "InkDrawingProgress.h"
#include "InkFrame.h"
#include "InkLights.h"
#include "InkOccluder.h"
#include "InkPointSize.h"
#include "InkQuantizedStipples.h"
#include "InkRenderPasses.h"
#include "InkRenderTarget.h"
#include "InkScopedState.h"
#include "InkShader.h"
#include "InkStipplePoints.h"
#include "InkStippleUniforms.h"
#include "InkStippleView.h"
#include "InkViewUniforms.h"

#include "InkStippleFS.h"
#include "InkStippleIdFS.h"
#include "InkStippleResultFS.h"
#include "InkStippleVS.h"

#include "InkOpenGLCompat.h"

#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkTimeStamp.h"

#include <algorithm>
#include <cstddef>

namespace
{

/// Dots are at least this many of the steps that blending can make, so that rounding hardly shows; paler ones
/// are drawn more rarely instead.
constexpr float LeastSteps = 8.0f;

/// As many of a picture where somebody watches it.
constexpr std::size_t ReportsOfStipples = 32;

/// The present on VTK's clock.
vtkMTimeType FindTime()
{
  vtkTimeStamp now;
  now.Modified();
  return now.GetMTime();
}

} // namespace

InkStipplePasses::InkStipplePasses(vtkOpenGLRenderWindow* window)
  : Window(window)
  , Textures(window)
{
  this->LargestPoint = InkFindLargestPoint();
  int units = 1;
  glGetIntegerv(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS, &units);
  this->LastTextureUnit = units - 1;
}

InkStipplePasses::~InkStipplePasses()
{
  this->Buffer->ReleaseGraphicsResources();
}

std::string InkStipplePasses::Upload(const InkStipplePoints& points, bool packed)
{
  this->UploadTime = FindTime();
  this->Packed = packed;
  if (!packed)
  {
    if (!points.GetVertices().empty())
    {
      this->Buffer->Upload(points.GetVertices(), vtkOpenGLBufferObject::ArrayBuffer);
    }
    return this->Textures.Upload(points, {});
  }
  const InkQuantizedStipples stipples(points);
  if (!stipples.Vertices.empty())
  {
    this->Buffer->Upload(stipples.Vertices, vtkOpenGLBufferObject::ArrayBuffer);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    this->PackedStep[axis] = stipples.Edges[axis] / static_cast<float>(ink::stipple::quantizationSteps);
  }
  return this->Textures.Upload(points, stipples.Boxes);
}

void InkStipplePasses::UploadColors(const std::vector<std::uint32_t>& colors)
{
  if (!colors.empty())
  {
    this->ColorUploadTime = FindTime();
  }
  this->Textures.UploadColors(colors);
}

std::string InkStipplePasses::FindFeatures(const Scene& scene) const
{
  std::string features = InkFindLightFeatures(scene.ToneView.Lights) + scene.View.FindFeatures();
  if (scene.Tone.smallElements.way == ink::stipple::SmallElements::Way::probability)
  {
    features += InkDefine("INK_PROBABILITY");
  }
  if (this->Textures.HasColors() || scene.Tone.warmCool.amount > 0.0f)
  {
    features += InkDefine("INK_COLORS");
  }
  if (scene.Occluder)
  {
    features += InkDefine("INK_OCCLUDED");
  }
  if (this->Packed)
  {
    features += InkDefine("INK_PACKED");
  }
  return features;
}

void InkStipplePasses::BindAttributes(vtkShaderProgram* program, vtkOpenGLVertexArrayObject* vertexArray)
{
  // vtkOpenGLVertexArrayObject would turn integers into floats.
  const auto bindInteger = [&](const char* name, std::size_t offset, std::size_t stride)
  {
    this->Buffer->Bind();
    const int location = glGetAttribLocation(program->GetHandle(), name);
    glEnableVertexAttribArray(location);
    glVertexAttribIPointer(
      location, 1, GL_UNSIGNED_INT, static_cast<int>(stride), reinterpret_cast<const void*>(offset));
    this->Buffer->Release();
  };
  if (this->Packed)
  {
    using Vertex = InkQuantizedStipples::Vertex;
    bindInteger("quantizedPosition", offsetof(Vertex, Position), sizeof(Vertex));
    bindInteger("elementAndRank", offsetof(Vertex, ElementAndRank), sizeof(Vertex));
  }
  else
  {
    using Vertex = InkStipplePoints::Vertex;
    vertexArray->AddAttributeArray(
      program, this->Buffer, "pointMC", offsetof(Vertex, Position), sizeof(Vertex), VTK_FLOAT, 3, false);
    bindInteger("elementAndRank", offsetof(Vertex, ElementAndRank), sizeof(Vertex));
  }
}

vtkShaderProgram* InkStipplePasses::Begin(InkShaderPass& pass, const Scene& scene)
{
  vtkShaderProgram* program = pass.Begin(this->Window, this->UploadTime,
    [this](vtkShaderProgram* made, vtkOpenGLVertexArrayObject* vertexArray)
    { this->BindAttributes(made, vertexArray); });
  if (!program)
  {
    return nullptr;
  }
  const auto scale = static_cast<float>(scene.View.TileScale);
  scene.View.SetUniforms(program);
  InkSetStippleUniforms(program, scene.Tone, scene.ToneView, scale);
  this->Textures.Activate(program);
  program->SetUniformi("rankBits", scene.Points.GetRankBits());
  program->SetUniform3f("packedStep", this->PackedStep.data());
  InkSetColorUniform(program, "inkColor", scene.InkColor);
  program->SetUniformf("largestPoint", this->LargestPoint);
  program->SetUniformf("occluderOffset", scene.OccluderOffset);
  program->SetUniformf("occluderPixels", scene.OccluderPixels);
  if (scene.Occluder)
  {
    vtkTextureObject* texture = scene.Occluder->Image.GetTexture();
    texture->Activate();
    program->SetUniformi("occluder", texture->GetTextureUnit());
    program->SetUniformf("occluderMargin", static_cast<float>(scene.Occluder->View->Margin));
  }
  else
  {
    // Samplers of different kinds must not share a unit, also if one of them is not read.
    program->SetUniformi("occluder", this->LastTextureUnit);
  }
  program->SetUniformf("leastIntensity", 0.0f);
  return program;
}

void InkStipplePasses::End(InkShaderPass& pass, const Scene& scene)
{
  if (scene.Occluder)
  {
    scene.Occluder->Image.GetTexture()->Deactivate();
  }
  this->Textures.Deactivate();
  pass.End();
}

float InkStipplePasses::FindReach(
  const InkViewUniforms& view, const ink::stipple::Tone& tone, const InkStippleView& toneView) const
{
  const float scale = static_cast<float>(view.TileScale);
  return 0.5f * std::min(tone.largestDiameter(toneView.Tone) * scale, this->LargestPoint) + 1.0f;
}

InkStippleRuns InkStipplePasses::FindRuns(const Scene& scene) const
{
  InkStippleRuns runs;
  runs.Find(scene.Points.GetBlocks(), scene.View, scene.Tone, scene.ToneView,
    this->FindReach(scene.View, scene.Tone, scene.ToneView));
  return runs;
}

void InkStipplePasses::DrawRuns(const InkStippleRuns& runs, InkDrawingProgress* progress)
{
  this->Processed = runs.GetNumberOfStipples();
  const InkPointSizeByShader pointSize;
  const std::size_t count = runs.Firsts.size();
  const std::size_t step =
    progress && progress->IsWatched() ? std::max<std::size_t>(count / ReportsOfStipples, 1) : count;
  for (std::size_t first = 0; first < count; first += step)
  {
    const std::size_t now = std::min(step, count - first);
    glMultiDrawArrays(
      GL_POINTS, runs.Firsts.data() + first, runs.Counts.data() + first, static_cast<int>(now));
    if (progress)
    {
      progress->Report(static_cast<double>(first + now) / static_cast<double>(count));
    }
  }
}

void InkStipplePasses::Draw(
  const Scene& scene, const InkFrame& frame, double opacity, const InkRenderPasses& renderPasses)
{
  const std::string features = this->FindFeatures(scene);
  std::string vertexShader = InkWithFeatures(InkStippleVS, features);
  std::string geometryShader;
  std::string fragmentShader = InkWithFeatures(InkStippleFS, features);
  renderPasses.ReplaceShaderValues(vertexShader, geometryShader, fragmentShader);
  // Depth peeling asks for it; without, a fragment's depth can be tested before it is shaded.
  const bool peeled = fragmentShader.find("//VTK::DepthPeeling::PreColor") == std::string::npos;
  fragmentShader =
    InkReplaceInShader(fragmentShader, "//INK::Depth", peeled ? "gl_FragDepth = gl_FragCoord.z;" : "");
  InkShaderPass& pass = this->Passes.Find(vertexShader, geometryShader, fragmentShader);
  if (vtkShaderProgram* program = this->Begin(pass, scene))
  {
    frame.SetOrigin(program);
    program->SetUniformf("actorOpacity", static_cast<float>(opacity));
    const float least = LeastSteps * InkFindBlendStep() / std::max(static_cast<float>(opacity), 1e-6f);
    program->SetUniformf("leastIntensity", std::min(least, 1.0f));
    renderPasses.SetShaderParameters(program, pass.GetVertexArray());
    frame.Progress.Until(1.0);
    this->DrawRuns(this->FindRuns(scene), &frame.Progress);
    this->End(pass, scene);
  }
}

void InkStipplePasses::DrawIds(const Scene& scene, const InkFrame& frame)
{
  const std::string features = this->FindFeatures(scene) + InkDefine("INK_IDS");
  InkShaderPass& pass = this->Passes.Find(InkWithFeatures(InkStippleVS, features), "", InkStippleIdFS);
  if (vtkShaderProgram* program = this->Begin(pass, scene))
  {
    frame.SetOrigin(program);
    frame.Ids->SetUniforms(program);
    this->DrawRuns(this->FindRuns(scene));
    this->End(pass, scene);
  }
}

std::vector<float> InkStipplePasses::FindResults(const Scene& scene, vtkIdType count)
{
  constexpr int width = 2048;
  const vtkIdType height = (count + width - 1) / width;
  int largest = 0;
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  if (count == 0 || height > largest || width > largest)
  {
    return {};
  }
  const InkScopedState scoped(state);
  using Format = InkRenderTarget::Format;
  InkRenderTarget colors(this->Window, Format::Float4, width, static_cast<int>(height));
  InkRenderTarget tones(this->Window, Format::Float4, width, static_cast<int>(height), &colors);
  std::vector<float> results;
  if (colors.IsComplete() && tones.IsComplete())
  {
    tones.Bind();
    state->vtkglDisable(GL_SCISSOR_TEST);
    state->vtkglDisable(GL_DEPTH_TEST);
    state->vtkglDisable(GL_BLEND);
    state->vtkglDisable(GL_STENCIL_TEST);
    state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    state->vtkglClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    state->vtkglClear(GL_COLOR_BUFFER_BIT);
    const std::string features = this->FindFeatures(scene) + InkDefine("INK_IDS") + InkDefine("INK_RESULTS");
    InkShaderPass& pass = this->Passes.Find(
      InkWithFeatures(InkStippleVS, features), "", InkWithFeatures(InkStippleResultFS, features));
    if (vtkShaderProgram* program = this->Begin(pass, scene))
    {
      const float size[2] = { static_cast<float>(width), static_cast<float>(height) };
      program->SetUniform2f("resultSize", size);
      InkStippleRuns runs;
      runs.Fill(static_cast<int>(scene.Points.GetNumberOfStipples()));
      this->DrawRuns(runs);
      this->End(pass, scene);
      results.resize(6 * static_cast<std::size_t>(count));
      std::vector<float> pixels(4 * static_cast<std::size_t>(width * height));
      std::size_t first = 0;
      for (InkRenderTarget* image : { &tones, &colors })
      {
        image->BindForReading();
        glReadPixels(0, 0, width, static_cast<int>(height), GL_RGBA, GL_FLOAT, pixels.data());
        for (std::size_t point = 0; point < static_cast<std::size_t>(count); ++point)
        {
          std::copy_n(&pixels[4 * point], 3, &results[6 * point + first]);
        }
        first += 3;
      }
    }
  }
  return results;
}
