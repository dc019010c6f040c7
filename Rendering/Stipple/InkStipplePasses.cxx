// SPDX-License-Identifier: BSD-3-Clause
#include "InkStipplePasses.h"

#include "InkBlendStep.h"
#include "InkDrawBuffers.h"
#include "InkPackedStipples.h"
#include "InkRenderPasses.h"
#include "InkScopedState.h"
#include "InkShader.h"
#include "InkStippleOccluder.h"
#include "InkStipplePoints.h"
#include "InkStippleUniforms.h"
#include "InkStippleView.h"
#include "InkView.h"

#include "InkStippleFS.h"
#include "InkStippleIdFS.h"
#include "InkStippleResultFS.h"
#include "InkStippleVS.h"

#include "InkOpenGLCompat.h"

#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
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

/// The present on VTK's clock.
vtkMTimeType FindTime()
{
  vtkTimeStamp now;
  now.Modified();
  return now.GetMTime();
}

} // namespace

/// A form of the shaders and its binding to the buffer.
struct InkStipplePasses::Pass
{
  std::string VertexShader;
  std::string GeometryShader;
  std::string FragmentShader;
  vtkNew<vtkOpenGLVertexArrayObject> VertexArray;
  int ProgramHandle = 0;
};

InkStipplePasses::InkStipplePasses(vtkOpenGLRenderWindow* window)
  : Window(window)
  , Textures(window)
{
  float range[2] = { 1.0f, 1.0f };
  glGetFloatv(GL_POINT_SIZE_RANGE, range);
  this->LargestPoint = range[1];
  int units = 1;
  glGetIntegerv(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS, &units);
  this->LastTextureUnit = units - 1;
}

InkStipplePasses::~InkStipplePasses()
{
  for (auto& [shaders, pass] : this->Passes)
  {
    pass->VertexArray->ReleaseGraphicsResources();
  }
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
  const InkPackedStipples stipples(points);
  if (!stipples.Vertices.empty())
  {
    this->Buffer->Upload(stipples.Vertices, vtkOpenGLBufferObject::ArrayBuffer);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    this->PackedStep[axis] = stipples.Edges[axis] / static_cast<float>(ink::packedPlaceSteps);
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
  const std::vector<ink::StippleLight>& lights = scene.ToneView.Lights;
  const auto lamps = std::count_if(
    lights.begin(), lights.end(), [](const ink::StippleLight& light) { return light.isLamp(); });
  const auto define = [](const char* name, std::size_t number)
  { return std::string("#define ") + name + ' ' + std::to_string(number) + '\n'; };
  std::string features = define("INK_LIGHTS", lights.size());
  features += define("INK_SUNS", lights.size() - lamps);
  features += define("INK_PLANES", scene.View.NumberOfClippingPlanes);
  if (lamps > 0)
  {
    features += "#define INK_LAMPS\n";
  }
  if (scene.Tone.smallElements.way == ink::SmallElements::Way::probability)
  {
    features += "#define INK_PROBABILITY\n";
  }
  if (this->Textures.HasColors() || scene.Tone.warmCool.amount > 0.0f)
  {
    features += "#define INK_COLORS\n";
  }
  if (scene.Occluder)
  {
    features += "#define INK_OCCLUDED\n";
  }
  if (this->Packed)
  {
    features += "#define INK_PACKED\n";
  }
  return features;
}

InkStipplePasses::Pass& InkStipplePasses::FindPass(
  const std::string& vertexShader, const std::string& geometryShader, const std::string& fragmentShader)
{
  std::unique_ptr<Pass>& pass = this->Passes[vertexShader + geometryShader + fragmentShader];
  if (!pass)
  {
    pass = std::make_unique<Pass>();
    pass->VertexShader = vertexShader;
    pass->GeometryShader = geometryShader;
    pass->FragmentShader = fragmentShader;
  }
  return *pass;
}

void InkStipplePasses::BindAttributes(Pass& pass, vtkShaderProgram* program)
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
    using Vertex = InkPackedStipples::Vertex;
    bindInteger("packedPlace", offsetof(Vertex, Place), sizeof(Vertex));
    bindInteger("elementAndRank", offsetof(Vertex, ElementAndRank), sizeof(Vertex));
  }
  else
  {
    using Vertex = InkStipplePoints::Vertex;
    pass.VertexArray->AddAttributeArray(
      program, this->Buffer, "pointMC", offsetof(Vertex, Position), sizeof(Vertex), VTK_FLOAT, 3, false);
    bindInteger("elementAndRank", offsetof(Vertex, ElementAndRank), sizeof(Vertex));
  }
}

vtkShaderProgram* InkStipplePasses::Begin(Pass& pass, const Scene& scene)
{
  vtkShaderProgram* program = this->Window->GetShaderCache()->ReadyShaderProgram(
    pass.VertexShader.c_str(), pass.FragmentShader.c_str(), pass.GeometryShader.c_str());
  if (!program)
  {
    return nullptr;
  }
  if (pass.ProgramHandle != program->GetHandle())
  {
    // This deletes the binding: it goes before Bind.
    pass.VertexArray->ShaderProgramChanged();
    pass.VertexArray->Bind();
    this->BindAttributes(pass, program);
    pass.ProgramHandle = program->GetHandle();
  }
  else
  {
    pass.VertexArray->Bind();
  }
  const auto scale = static_cast<float>(scene.View.TileScale);
  scene.View.SetUniforms(program);
  InkSetStippleUniforms(program, scene.Tone, scene.ToneView, scale);
  this->Textures.Activate(program);
  program->SetUniformi("rankBits", scene.Points.GetRankBits());
  program->SetUniform3f("packedStep", this->PackedStep.data());
  const float color[3] = { static_cast<float>(scene.InkColor[0]), static_cast<float>(scene.InkColor[1]),
    static_cast<float>(scene.InkColor[2]) };
  program->SetUniform3f("inkColor", color);
  program->SetUniformf("largestPoint", this->LargestPoint);
  program->SetUniformf("occluderOffset", scene.OccluderOffset);
  if (scene.Occluder)
  {
    scene.Occluder->Texture->Activate();
    program->SetUniformi("occluder", scene.Occluder->Texture->GetTextureUnit());
    program->SetUniformf("occluderMargin", static_cast<float>(scene.Occluder->View->Margin));
  }
  else
  {
    // Samplers of different kinds must not share a unit, also if one of them is not looked at.
    program->SetUniformi("occluder", this->LastTextureUnit);
  }
  program->SetUniformf("leastIntensity", 0.0f);
  return program;
}

void InkStipplePasses::End(Pass& pass, const Scene& scene)
{
  if (scene.Occluder)
  {
    scene.Occluder->Texture->Deactivate();
  }
  this->Textures.Deactivate();
  pass.VertexArray->Release();
}

float InkStipplePasses::FindReach(
  const InkView& view, const ink::StippleTone& tone, const InkStippleView& toneView) const
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

void InkStipplePasses::DrawRuns(const InkStippleRuns& runs)
{
  this->Processed = runs.GetNumberOfStipples();
  if (runs.Firsts.empty())
  {
    return;
  }
  // vtkOpenGLState does not know this one.
  const bool wasEnabled = glIsEnabled(GL_PROGRAM_POINT_SIZE) == GL_TRUE;
  glEnable(GL_PROGRAM_POINT_SIZE);
  glMultiDrawArrays(GL_POINTS, runs.Firsts.data(), runs.Counts.data(), static_cast<int>(runs.Firsts.size()));
  if (!wasEnabled)
  {
    glDisable(GL_PROGRAM_POINT_SIZE);
  }
}

void InkStipplePasses::Draw(
  const Scene& scene, const int viewportOrigin[2], double opacity, const InkRenderPasses& renderPasses)
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
  Pass& pass = this->FindPass(vertexShader, geometryShader, fragmentShader);
  vtkOpenGLState* state = this->Window->GetState();
  const vtkOpenGLState::ScopedglEnableDisable culling(state, GL_CULL_FACE);
  state->vtkglDisable(GL_CULL_FACE);
  if (vtkShaderProgram* program = this->Begin(pass, scene))
  {
    const float origin[2] = { static_cast<float>(viewportOrigin[0]), static_cast<float>(viewportOrigin[1]) };
    program->SetUniform2f("viewportOrigin", origin);
    program->SetUniformf("actorOpacity", static_cast<float>(opacity));
    const float least = LeastSteps * InkFindBlendStep() / std::max(static_cast<float>(opacity), 1e-6f);
    program->SetUniformf("leastIntensity", std::min(least, 1.0f));
    renderPasses.SetShaderParameters(program, pass.VertexArray);
    this->DrawRuns(this->FindRuns(scene));
    this->End(pass, scene);
  }
}

void InkStipplePasses::DrawIds(
  const Scene& scene, const int viewportOrigin[2], int idShift, const float propColor[3])
{
  vtkOpenGLState* state = this->Window->GetState();
  const vtkOpenGLState::ScopedglEnableDisable culling(state, GL_CULL_FACE);
  state->vtkglDisable(GL_CULL_FACE);
  const std::string features = this->FindFeatures(scene) + "#define INK_IDS\n";
  Pass& pass = this->FindPass(InkWithFeatures(InkStippleVS, features), "", InkStippleIdFS);
  if (vtkShaderProgram* program = this->Begin(pass, scene))
  {
    const float origin[2] = { static_cast<float>(viewportOrigin[0]), static_cast<float>(viewportOrigin[1]) };
    program->SetUniform2f("viewportOrigin", origin);
    program->SetUniformi("idShift", idShift);
    program->SetUniform3f("propColor", propColor);
    this->DrawRuns(this->FindRuns(scene));
    this->End(pass, scene);
  }
}

std::vector<float> InkStipplePasses::FindResults(const Scene& scene, vtkIdType count)
{
  constexpr vtkIdType width = 2048;
  const vtkIdType height = (count + width - 1) / width;
  int largest = 0;
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  if (count == 0 || height > largest || width > largest)
  {
    return {};
  }
  const InkScopedState scoped(state);
  vtkNew<vtkTextureObject> images[2];
  vtkNew<vtkOpenGLFramebufferObject> framebuffer;
  framebuffer->SetContext(this->Window);
  framebuffer->Bind();
  for (unsigned int i = 0; i < 2; ++i)
  {
    images[i]->SetContext(this->Window);
    images[i]->Allocate2D(width, static_cast<unsigned int>(height), 4, VTK_FLOAT);
    framebuffer->AddColorAttachment(i, images[i]);
  }
  InkActivateDrawBuffers(framebuffer, 2);
  const char* reason = nullptr;
  std::vector<float> results;
  if (vtkOpenGLFramebufferObject::GetFrameBufferStatus(GL_FRAMEBUFFER, reason))
  {
    state->vtkglViewport(0, 0, static_cast<int>(width), static_cast<int>(height));
    state->vtkglDisable(GL_SCISSOR_TEST);
    state->vtkglDisable(GL_DEPTH_TEST);
    state->vtkglDisable(GL_BLEND);
    state->vtkglDisable(GL_STENCIL_TEST);
    state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    state->vtkglClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    state->vtkglClear(GL_COLOR_BUFFER_BIT);
    const std::string features = this->FindFeatures(scene) + "#define INK_IDS\n#define INK_RESULTS\n";
    Pass& pass = this->FindPass(
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
      for (unsigned int i = 0; i < 2; ++i)
      {
        framebuffer->ActivateReadBuffer(i);
        glReadPixels(
          0, 0, static_cast<int>(width), static_cast<int>(height), GL_RGBA, GL_FLOAT, pixels.data());
        for (std::size_t point = 0; point < static_cast<std::size_t>(count); ++point)
        {
          std::copy_n(&pixels[4 * point], 3, &results[6 * point + 3 * i]);
        }
      }
    }
  }
  framebuffer->ReleaseGraphicsResources(this->Window);
  for (auto& image : images)
  {
    image->ReleaseGraphicsResources(this->Window);
  }
  return results;
}
