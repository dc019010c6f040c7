// SPDX-License-Identifier: BSD-3-Clause
#include "InkSplatDrawing.h"

#include "InkDrawingProgress.h"
#include "InkFrame.h"
#include "InkLinePostProcess.h"
#include "InkSplatPasses.h"
#include "InkSplatQuads.h"

#include "InkOpenGLCompat.h"
#include "InkScopedState.h"

#include "vtkActor.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProperty.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{

void Clear(vtkOpenGLState* state, float red, GLbitfield buffers)
{
  state->vtkglClearColor(red, 0.0f, 0.0f, 0.0f);
  state->vtkglClear(buffers);
}

/// Of the depth test between pixels of one surface: view units, and by slope, pixels.
std::array<double, 2> FindTolerances(const InkSplatPasses& passes, const InkViewUniforms& view)
{
  return { InkSplatTolerance * passes.GetLargestRadius() * view.Unit, InkSplatTolerance };
}

/// Parts of a picture's time, about: from where splats are drawn to where they become ink, and of a layer's
/// the part of its depth.
constexpr double SplatsBegin = 0.2;
constexpr double SplatsEnd = 0.95;
constexpr double DepthShare = 0.25;

} // namespace

double InkSplatDrawing::FindProgress(std::size_t layer, double part) const
{
  const double layers = static_cast<double>(this->Layers.size());
  return SplatsBegin + (SplatsEnd - SplatsBegin) * (static_cast<double>(layer) + part) / layers;
}

bool InkSplatDrawing::Allocate(
  InkSplatPasses& passes, const InkViewUniforms& view, const InkSplatSettings& splatting)
{
  const auto& [width, height] = view.Size;
  const bool fits = this->View && this->View->Size == view.Size && this->Splatting &&
    this->Splatting->Colors == splatting.Colors && this->Splatting->HalfFloats == splatting.HalfFloats;
  if (!fits)
  {
    this->Layers.clear();
    this->Sums.clear();
    this->ZBuffer.reset();
  }
  using Format = InkRenderTarget::Format;
  vtkOpenGLRenderWindow* window = passes.GetWindow();
  if (!this->ZBuffer)
  {
    this->ZBuffer = std::make_unique<InkRenderTarget>(window, Format::Depth, width, height);
  }
  const Format sums = splatting.HalfFloats ? Format::Half4 : Format::Float4;
  while (!this->Sums.empty() && 1 << (this->Sums.size() - 1) > splatting.MaximumDownsampling)
  {
    this->Sums.pop_back();
  }
  for (int texel = 1 << this->Sums.size(); texel <= splatting.MaximumDownsampling; texel *= 2)
  {
    this->Sums.push_back(std::make_unique<InkRenderTarget>(
      window, sums, (width + texel - 1) / texel, (height + texel - 1) / texel));
  }
  this->Layers.resize(static_cast<std::size_t>(splatting.Layers));
  return std::all_of(
    this->Sums.begin(), this->Sums.end(), [](const auto& image) { return image->IsComplete(); });
}

bool InkSplatDrawing::AllocateLayer(
  InkSplatPasses& passes, const InkViewUniforms& view, const InkSplatSettings& splatting, Layer& layer)
{
  using Format = InkRenderTarget::Format;
  const auto make = [&](Format format, InkRenderTarget* beside = nullptr, InkRenderTarget* depth = nullptr)
  {
    return std::make_unique<InkRenderTarget>(
      passes.GetWindow(), format, view.Size[0], view.Size[1], beside, depth);
  };
  if (!layer.Surface)
  {
    layer.Colors = splatting.Colors ? make(Format::Byte4) : nullptr;
    layer.Surface = make(Format::Float2, layer.Colors.get(), this->ZBuffer.get());
    layer.Illumination = make(Format::Float2);
    layer.Ink = make(Format::Byte4);
  }
  return layer.Surface->IsComplete() && layer.Illumination->IsComplete() && layer.Ink->IsComplete();
}

bool InkSplatDrawing::DrawSurface(InkSplatPasses& passes, const InkViewUniforms& view,
  const InkSplatSettings& splatting, std::size_t index, InkDrawingProgress& progress)
{
  vtkOpenGLState* state = passes.GetWindow()->GetState();
  this->Layers[index].Surface->Bind();
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LESS);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglDisable(GL_BLEND);
  Clear(state, InkNoSurface, GL_DEPTH_BUFFER_BIT | GL_COLOR_BUFFER_BIT);
  if (splatting.Colors)
  {
    const float none[4] = {};
    glClearBufferfv(GL_COLOR, 1, none);
  }
  using Sheet = InkSplatPasses::Sheet;
  const Layer& layer = this->Layers[index];
  if (index == 0)
  {
    const bool inTurn = view.BackFaces && !splatting.AsPublished;
    progress.Until(this->FindProgress(index, inTurn ? 0.5 * DepthShare : DepthShare));
    passes.DrawDepth(view, splatting, progress, inTurn ? Sheet::Front : Sheet::Whole);
    if (inTurn)
    {
      // Most of what faces away is hidden. The illumination is not drawn yet: it holds the copy.
      layer.Surface->CopyTo(*layer.Illumination);
      layer.Surface->Bind();
      progress.Until(this->FindProgress(index, DepthShare));
      passes.DrawDepth(view, splatting, progress, Sheet::Back, layer.Illumination.get());
    }
    return true;
  }
  const InkRenderTarget* before = this->Layers[index - 1].Surface.get();
  progress.Until(this->FindProgress(index, DepthShare));
  GLint current = 0;
  glGetQueryiv(GL_SAMPLES_PASSED, GL_CURRENT_QUERY, &current);
  if (current != 0)
  {
    // A render pass counts what is drawn, and OpenGL has one such query at a time.
    passes.DrawDepth(view, splatting, progress, Sheet::Hidden, before);
    std::vector<float> distances(
      static_cast<std::size_t>(view.Size[0]) * static_cast<std::size_t>(view.Size[1]));
    this->Layers[index].Surface->BindForReading();
    glReadPixels(0, 0, view.Size[0], view.Size[1], GL_RED, GL_FLOAT, distances.data());
    return std::any_of(
      distances.begin(), distances.end(), [](float distance) { return distance < InkNoSurface; });
  }
  // No layer follows an empty one.
  GLuint query = 0;
  GLuint pixels = 0;
  glGenQueries(1, &query);
  glBeginQuery(GL_SAMPLES_PASSED, query);
  passes.DrawDepth(view, splatting, progress, Sheet::Hidden, before);
  glEndQuery(GL_SAMPLES_PASSED);
  glGetQueryObjectuiv(query, GL_QUERY_RESULT, &pixels);
  glDeleteQueries(1, &query);
  return pixels > 0;
}

bool InkSplatDrawing::DrawSplats(InkSplatPasses& passes, InkSplatQuads& quads, const InkViewUniforms& view,
  const InkSplatSettings& splatting, InkDrawingProgress& progress)
{
  vtkOpenGLState* state = passes.GetWindow()->GetState();
  const std::array<int, 4> extent = passes.FindExtent(view, splatting, 0);
  this->Present = 0;
  for (std::size_t index = 0; index < this->Layers.size(); ++index)
  {
    // Only layers that there are need room.
    if (!this->AllocateLayer(passes, view, splatting, this->Layers[index]))
    {
      return false;
    }
    if (!this->DrawSurface(passes, view, splatting, index, progress))
    {
      break;
    }
    ++this->Present;
    const Layer& layer = this->Layers[index];

    state->vtkglDisable(GL_DEPTH_TEST);
    state->vtkglDepthMask(GL_FALSE);
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendEquation(GL_FUNC_ADD);
    state->vtkglBlendFunc(GL_ONE, GL_ONE);
    std::vector<const InkRenderTarget*> sums;
    for (std::size_t level = 0; level < this->Sums.size(); ++level)
    {
      const int texel = 1 << level;
      this->Sums[level]->Bind();
      Clear(state, 0.0f, GL_COLOR_BUFFER_BIT);
      const double least = InkSplatPasses::FewestTexels(splatting.Sigma) * texel;
      const bool last = level + 1 == this->Sums.size();
      const double levels = static_cast<double>(level + 1) / static_cast<double>(this->Sums.size());
      progress.Until(this->FindProgress(index, DepthShare + (1.0 - DepthShare) * levels));
      passes.DrawLight(view, splatting, progress, *layer.Surface, index > 0, texel,
        { level == 0 ? 0.0 : least, last ? HUGE_VAL : 2.0 * least });
      sums.push_back(this->Sums[level].get());
    }

    state->vtkglDisable(GL_BLEND);
    layer.Illumination->Bind();
    Clear(state, 0.0f, GL_COLOR_BUFFER_BIT);
    state->vtkglEnable(GL_SCISSOR_TEST);
    state->vtkglScissor(extent[0], extent[1], extent[2], extent[3]);
    const bool outline = index == 0 && !splatting.AsPublished;
    quads.DrawIllumination(view, *layer.Surface, sums, FindTolerances(passes, view), outline);
    state->vtkglDisable(GL_SCISSOR_TEST);
  }
  return true;
}

void InkSplatDrawing::DrawInk(
  InkSplatPasses& passes, InkSplatQuads& quads, const InkViewUniforms& view, const InkSplatStyle& style)
{
  vtkOpenGLState* state = passes.GetWindow()->GetState();
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglBlendEquation(GL_FUNC_ADD);
  state->vtkglBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  // A pixel whose middle is beyond the surface may still have some of it.
  this->Reach = this->Splatting->AsPublished ? 0 : 1;
  for (int index = 0; index < this->Present; ++index)
  {
    this->Reach = std::max(this->Reach, InkLinePostProcess(style, index, view).GetReach());
  }
  // What is farther from the discs is never read.
  const std::array<int, 4> extent = passes.FindExtent(view, *this->Splatting, this->Reach);
  state->vtkglScissor(extent[0], extent[1], extent[2], extent[3]);
  for (int index = this->Present - 1; index >= 0; --index)
  {
    Layer& layer = this->Layers[static_cast<std::size_t>(index)];
    state->vtkglDisable(GL_BLEND);
    const InkSplatQuads::Sheet sheet{ *layer.Surface, *layer.Illumination, layer.Colors.get(),
      FindTolerances(passes, view), !this->Splatting->AsPublished };
    const vtkSmartPointer<vtkTextureObject> coverage = quads.WorkOn(style, index, view, sheet, *layer.Ink);
    // With paper, all ink is in one image, nearer ink over that behind it.
    const bool over = style.Paper && index < this->Present - 1;
    (style.Paper ? this->Layers[static_cast<std::size_t>(this->Present - 1)] : layer).Ink->Bind();
    if (over)
    {
      state->vtkglEnable(GL_BLEND);
    }
    state->vtkglEnable(GL_SCISSOR_TEST);
    quads.DrawInk(style, index, view, sheet, coverage, this->Reach);
    state->vtkglDisable(GL_SCISSOR_TEST);
  }
}

bool InkSplatDrawing::Draw(InkSplatPasses& passes, InkSplatQuads& quads, const InkViewUniforms& view,
  const InkSplatSettings& splatting, const InkSplatStyle& style, const double paperColor[3],
  vtkAbstractMapper* mapper, const InkFrame& frame)
{
  const bool splatsChanged =
    this->View != view || this->Splatting != splatting || this->UploadTime != passes.GetUploadTime();
  if (splatsChanged || this->Style != style)
  {
    vtkOpenGLState* state = passes.GetWindow()->GetState();
    const InkScopedState scoped(state);
    state->vtkglDisable(GL_SCISSOR_TEST);
    state->vtkglDisable(GL_CULL_FACE);
    state->vtkglDisable(GL_STENCIL_TEST);
    state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    if (splatsChanged)
    {
      const bool allocated = this->Allocate(passes, view, splatting);
      this->View.reset();
      if (!allocated || !this->DrawSplats(passes, quads, view, splatting, frame.Progress))
      {
        return false;
      }
      this->View = view;
      this->Splatting = splatting;
      this->UploadTime = passes.GetUploadTime();
    }
    this->DrawInk(passes, quads, view, style);
    this->Style = style;
  }

  vtkActor* actor = frame.Actor;
  // Ink without paper may lie on a surface that another actor draws, and must not sink into it.
  const double bias = style.Paper ? 0.0 : InkSplatTolerance * passes.GetLargestRadius() * view.Unit;
  for (int index = style.Paper ? 0 : this->Present - 1; index >= 0; --index)
  {
    const Layer& layer = this->Layers[static_cast<std::size_t>(index)];
    const Layer& inked = style.Paper ? this->Layers[static_cast<std::size_t>(this->Present - 1)] : layer;
    quads.DrawComposite(view, *layer.Surface, *inked.Ink, style.Paper ? paperColor : nullptr,
      actor->GetProperty()->GetOpacity(), this->Reach, bias, mapper, actor);
  }
  return true;
}
