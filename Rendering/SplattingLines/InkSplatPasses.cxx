// SPDX-License-Identifier: BSD-3-Clause
#include "InkSplatPasses.h"

#include "InkRenderPasses.h"
#include "InkScopedState.h"
#include "InkSplatPoints.h"
#include "InkSplatTargets.h"
#include "InkView.h"

#include "InkSplatCompositeFS.h"
#include "InkSplatDepthFS.h"
#include "InkSplatGS.h"
#include "InkSplatIdFS.h"
#include "InkSplatLightFS.h"
#include "InkSplatVS.h"

#include "InkOpenGLCompat.h"

#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderUtilities.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{

/// The least radii of depth and illumination splats in pixels. The first leaves no pixel between discs that
/// are far away or seen edge-on; the second also sets how thin a line can be.
constexpr double MinimumDepthRadius = 0.75;
constexpr double MinimumLightRadius = 3.0;

/// The same for splats as published, of which the paper says nothing: only so that no disc is degenerate.
constexpr double PublishedMinimumRadius = 0.01;

/// Splats count as being on the visible surface within this fraction of their point's radius from what the
/// depth splats show (Zhang et al. 2014, section 3.1, has an offset instead).
constexpr double Tolerance = 1.5;

/// Discs beyond a contour take part in the illumination near it as long as f_i is greater than this.
constexpr double MinimumLight = -0.3;

/// The distance of what is not there.
constexpr float NoSurface = std::numeric_limits<float>::max();

/// sigma_max over sigma_min (Zhang et al. 2014, section 3.2).
constexpr double WideOverNarrow = 1.6;

/// How large in pixels a splat of some radius (in the points' unit), grown by another (in pixels), may be
/// anywhere beyond the near plane.
double LargestSplat(const InkView& view, double radius, double minimumRadius)
{
  const double nearW = view.DepthToClip[3] - view.DepthToClip[2] * view.DepthRange[0];
  const double pixels = std::hypot(radius * view.Unit / (view.Pixel * nearW), minimumRadius);
  // Twice, because perspective stretches splats towards the corners; the vertex shader cuts them to the
  // viewport.
  const double viewport = std::max(view.Size[0], view.Size[1]);
  return std::min(viewport, 2.0 * 2.0 * pixels);
}

} // namespace

/// A fragment shader's program and its binding to the buffers.
struct InkSplatPasses::Pass
{
  explicit Pass(const char* fragmentShader)
    : FragmentShader(fragmentShader)
  {
  }

  const char* FragmentShader;
  vtkNew<vtkOpenGLVertexArrayObject> VertexArray;
  int ProgramHandle = 0;
  vtkMTimeType BufferTime = 0;
};

InkSplatPasses::InkSplatPasses(vtkOpenGLRenderWindow* window)
  : Window(window)
  , DepthPass(std::make_unique<Pass>(InkSplatDepthFS))
  , LightPass(std::make_unique<Pass>(InkSplatLightFS))
  , IdPass(std::make_unique<Pass>(InkSplatIdFS))
{
  float range[2] = { 1.0f, 1.0f };
  glGetFloatv(GL_POINT_SIZE_RANGE, range);
  this->LargestSprite = range[1];
}

InkSplatPasses::~InkSplatPasses()
{
  this->Buffers->ReleaseGraphicsResources(this->Window);
  for (Pass* pass : { this->DepthPass.get(), this->LightPass.get(), this->IdPass.get() })
  {
    pass->VertexArray->ReleaseGraphicsResources();
  }
}

void InkSplatPasses::Upload(InkSplatPoints& points)
{
  // Appending, unlike caching, does not keep the arrays alive.
  this->Buffers->ClearAllVBOs();
  this->Buffers->AppendDataArray("pointMC", points.GetPositions(), VTK_FLOAT);
  this->Buffers->AppendDataArray("normalRadiusMC", points.GetNormalsAndRadii(), VTK_FLOAT);
  this->Buffers->BuildAllVBOs(static_cast<vtkOpenGLVertexBufferObjectCache*>(nullptr));
  this->Buffers->Modified();
  this->NumberOfPoints = static_cast<int>(points.GetPositions()->GetNumberOfTuples());
  this->LargestRadius = points.GetLargestRadius();
}

vtkMTimeType InkSplatPasses::GetUploadTime() const
{
  return this->NumberOfPoints > 0 ? this->Buffers->GetMTime() : 0;
}

vtkShaderProgram* InkSplatPasses::Begin(
  Pass& pass, const InkView& view, double radiusScale, double minimumRadius)
{
  const bool sprites =
    LargestSplat(view, radiusScale * this->LargestRadius, minimumRadius) <= this->LargestSprite;
  vtkShaderProgram* program = this->Window->GetShaderCache()->ReadyShaderProgram(
    InkSplatVS, pass.FragmentShader, sprites ? "" : InkSplatGS);
  if (!program)
  {
    return nullptr;
  }
  if (pass.ProgramHandle != program->GetHandle() || pass.BufferTime < this->Buffers->GetMTime())
  {
    // This deletes the binding: it goes before Bind.
    pass.VertexArray->ShaderProgramChanged();
    pass.VertexArray->Bind();
    this->Buffers->AddAllAttributesToVAO(program, pass.VertexArray);
    pass.ProgramHandle = program->GetHandle();
    pass.BufferTime = this->Buffers->GetMTime();
  }
  else
  {
    pass.VertexArray->Bind();
  }
  view.SetUniforms(program);
  program->SetUniformf("radiusScale", static_cast<float>(radiusScale));
  program->SetUniformf("minimumRadius", static_cast<float>(minimumRadius));
  program->SetUniformf("minimumLight", 0.0f);
  program->SetUniformf("tolerance", static_cast<float>(Tolerance));
  program->SetUniformi("cullHidden", 0);
  return program;
}

void InkSplatPasses::DrawPoints()
{
  // vtkOpenGLState does not know this one.
  const bool wasEnabled = glIsEnabled(GL_PROGRAM_POINT_SIZE) == GL_TRUE;
  glEnable(GL_PROGRAM_POINT_SIZE);
  glDrawArrays(GL_POINTS, 0, this->NumberOfPoints);
  if (!wasEnabled)
  {
    glDisable(GL_PROGRAM_POINT_SIZE);
  }
}

void InkSplatPasses::DrawSplats(const InkView& view, InkSplatTargets& targets, const Splatting& splatting)
{
  vtkOpenGLState* state = this->Window->GetState();
  const InkScopedState scoped(state);
  state->vtkglViewport(0, 0, view.Size[0], view.Size[1]);
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglDisable(GL_STENCIL_TEST);

  targets.BindSurface();
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LESS);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglDisable(GL_BLEND);
  state->vtkglClearColor(NoSurface, 0.0f, 0.0f, 0.0f);
  state->vtkglClear(GL_DEPTH_BUFFER_BIT | GL_COLOR_BUFFER_BIT);
  if (this->Begin(
        *this->DepthPass, view, 1.0, splatting.AsPublished ? PublishedMinimumRadius : MinimumDepthRadius))
  {
    this->DrawPoints();
    this->DepthPass->VertexArray->Release();
  }

  targets.BindLight();
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  state->vtkglClear(GL_COLOR_BUFFER_BIT);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFunc(GL_ONE, GL_ONE);
  state->vtkglBlendEquation(GL_FUNC_ADD);
  const double minimumRadius =
    splatting.AsPublished ? PublishedMinimumRadius : MinimumLightRadius * view.TileScale;
  if (vtkShaderProgram* program = this->Begin(*this->LightPass, view, splatting.Lambda, minimumRadius))
  {
    targets.GetSurface()->Activate();
    program->SetUniformi("surface", targets.GetSurface()->GetTextureUnit());
    program->SetUniformi("cullHidden", 1);
    program->SetUniformf("minimumLight", splatting.AsPublished ? 0.0f : static_cast<float>(MinimumLight));
    const double narrow = splatting.Sigma;
    const double wide = WideOverNarrow * narrow;
    const float falloff[2] = { static_cast<float>(0.5 / (narrow * narrow)),
      static_cast<float>(0.5 / (wide * wide)) };
    float rim[2] = { 0.0f, 0.0f };
    if (!splatting.AsPublished)
    {
      rim[0] = std::exp(-falloff[0]);
      rim[1] = std::exp(-falloff[1]);
    }
    program->SetUniform2f("falloff", falloff);
    program->SetUniform2f("rim", rim);
    this->DrawPoints();
    this->LightPass->VertexArray->Release();
    targets.GetSurface()->Deactivate();
  }
}

void InkSplatPasses::DrawComposite(const InkView& view, InkSplatTargets& targets, const Style& style,
  vtkAbstractMapper* mapper, vtkActor* actor)
{
  std::string vertexShader = vtkOpenGLRenderUtilities::GetFullScreenQuadVertexShader();
  std::string fragmentShader = InkSplatCompositeFS;
  std::string geometryShader;
  const InkRenderPasses renderPasses(mapper, actor);
  renderPasses.ReplaceShaderValues(vertexShader, geometryShader, fragmentShader);

  std::unique_ptr<vtkOpenGLQuadHelper>& quad = this->Composites[fragmentShader];
  if (!quad)
  {
    quad = std::make_unique<vtkOpenGLQuadHelper>(
      this->Window, vertexShader.c_str(), fragmentShader.c_str(), geometryShader.c_str());
  }
  vtkShaderProgram* program = this->Window->GetShaderCache()->ReadyShaderProgram(quad->Program);
  if (!program)
  {
    return;
  }

  // Culling, if the actor asks for it, concerns its surface and not this quad.
  vtkOpenGLState* state = this->Window->GetState();
  const vtkOpenGLState::ScopedglEnableDisable culling(state, GL_CULL_FACE);
  state->vtkglDisable(GL_CULL_FACE);
  targets.GetSurface()->Activate();
  targets.GetLight()->Activate();
  program->SetUniformi("surface", targets.GetSurface()->GetTextureUnit());
  program->SetUniformi("lightSums", targets.GetLight()->GetTextureUnit());
  program->SetUniformf("farthest", 2.0f * view.DepthRange[1]);
  program->SetUniform4f("depthToClip", view.DepthToClip.data());
  program->SetUniformf("tau", static_cast<float>(style.Tau));
  program->SetUniformf("phi", static_cast<float>(style.Phi));
  const auto setColor = [program](const char* name, const double* color)
  {
    const float rgb[3] = { static_cast<float>(color[0]), static_cast<float>(color[1]),
      static_cast<float>(color[2]) };
    program->SetUniform3f(name, rgb);
  };
  setColor("inkColor", style.InkColor);
  setColor("paperColor", style.PaperColor);
  program->SetUniformi("paper", style.Paper);
  program->SetUniformf("opacity", static_cast<float>(style.Opacity));
  // Ink without paper may lie on a surface that another actor draws, and must not sink into it.
  const double bias = style.Paper ? 0.0 : Tolerance * this->LargestRadius * view.Unit;
  program->SetUniformf("depthBias", static_cast<float>(bias));
  renderPasses.SetShaderParameters(program, quad->VAO);
  quad->Render();
  targets.GetLight()->Deactivate();
  targets.GetSurface()->Deactivate();
}

void InkSplatPasses::DrawIds(
  const InkView& view, const int viewportOrigin[2], int idShift, const float propColor[3])
{
  vtkOpenGLState* state = this->Window->GetState();
  const vtkOpenGLState::ScopedglEnableDisable culling(state, GL_CULL_FACE);
  state->vtkglDisable(GL_CULL_FACE);
  if (vtkShaderProgram* program = this->Begin(*this->IdPass, view, 1.0, MinimumDepthRadius))
  {
    const float origin[2] = { static_cast<float>(viewportOrigin[0]), static_cast<float>(viewportOrigin[1]) };
    program->SetUniform2f("viewportOrigin", origin);
    program->SetUniform4f("depthToClip", view.DepthToClip.data());
    program->SetUniformi("idShift", idShift);
    program->SetUniform3f("propColor", propColor);
    this->DrawPoints();
    this->IdPass->VertexArray->Release();
  }
}
