// SPDX-License-Identifier: BSD-3-Clause
// Parameters in the units of the shaders.
#include "vtkInkStrokeMapper.h"

#include "InkFrame.h"
#include "InkLights.h"
#include "InkShiftScale.h"
#include "InkStrokeMarks.h"
#include "InkStrokeStyle.h"
#include "InkViewUniforms.h"

#include "Tone/Hatching/StrokeWidth.h"

#include "vtkRenderer.h"

#include <glm/glm.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace
{

/// In extents of the strokes: over no less depth do they become thinner.
constexpr float LeastDepth = 0.05f;

std::array<double, 6> FindLocalBox(const InkShiftScale& frame, const double bounds[6])
{
  float low[3];
  float high[3];
  const double first[3] = { bounds[0], bounds[2], bounds[4] };
  const double last[3] = { bounds[1], bounds[3], bounds[5] };
  frame.ToLocal(first, low);
  frame.ToLocal(last, high);
  return { low[0], high[0], low[1], high[1], low[2], high[2] };
}

/// Strokes of hatching with a larger priority are drawn nowhere in a view.
float FindMostPriority(
  const InkStrokePoints& strokes, const InkViewUniforms& view, const InkStrokeStyle& style)
{
  float widest = 0.0f;
  for (const InkStrokePoints::Stroke& stroke : strokes.GetStrokes())
  {
    widest = std::max(widest, stroke.Spacing);
  }
  const bool parallel = view.Eye[3] == 0.0f;
  const float pixel = view.Pixel * (parallel ? 1.0f : std::max(style.Distances[0], view.DepthRange[0]));
  const std::array<float, 2>& spacing = style.Hatching->Spacing;
  const ink::hatching::StrokeWidth widths{ spacing[0] + spacing[1] / pixel, 0.0f,
    style.Hatching->Crosshatching };
  return widths.mostPriority(widest * view.Unit / pixel);
}

} // namespace

InkStrokeStyle vtkInkStrokeMapper::MakeStyle(const InkStrokeMarks& marks, const InkViewUniforms& view)
{
  const auto number = [](double value) { return static_cast<float>(value); };
  InkStrokeStyle style;
  const glm::mat4 toView = glm::make_mat4(view.MCVC.data());
  const std::array<double, 6>& box = marks.Strokes.GetLocalBounds();
  style.Distances = { INFINITY, -INFINITY };
  std::array<glm::vec4, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    corners[i] = toView * glm::vec4(box[i & 1 ? 1 : 0], box[i & 2 ? 3 : 2], box[i & 4 ? 5 : 4], 1.0);
    style.Distances[0] = std::min(style.Distances[0], -corners[i].z);
    style.Distances[1] = std::max(style.Distances[1], -corners[i].z);
  }
  // What hardly differs in depth is as good as equally far: rounding, say, of a circle that is seen from its
  // axis.
  const float extent = glm::distance(corners.front(), corners.back());
  style.Distances[1] =
    std::max(style.Distances[1], style.Distances[0] + std::max(LeastDepth * extent, 1e-6f * view.Unit));

  const double scale = this->SizeUnit == THOUSANDTHS ? 1e-3 * view.PictureHeight : view.TileScale;
  const bool world = this->SizeUnit == WORLD;
  style.HalfWidth = { world ? 0.0f : number(0.5 * scale * this->LineWidth),
    world ? number(0.5 * this->LineWidth) : 0.0f };
  double bounds[6];
  const double local = this->FindSizeUnit(view,
    this->GetExtent(bounds) ? FindLocalBox(marks.Strokes.GetFrame(), bounds)
                            : marks.Strokes.GetLocalBounds());
  style.Dash = { number(local * this->DashLength), number(local * (this->DashLength + this->GapLength)) };
  style.TextureLength = number(std::max(local * this->TextureLength * this->LineWidth, 1e-30));
  const bool dashes = this->GapLength > 0.0;
  style.Dashed = dashes && this->Dashed;
  style.HiddenDashed = dashes && this->HiddenParts == DASHED;
  style.HiddenOpacity = this->HiddenParts == FAINT ? number(this->HiddenOpacity) : 1.0f;

  style.Taper = number(this->Taper);
  style.DepthWidth = number(this->DepthWidth);
  style.Miter = this->Join == MITER_JOIN;
  style.MiterLimit = number(this->MiterLimit);
  style.Butt = this->Cap == BUTT_CAP;
  style.Density = number(this->Density);
  style.Lift = number(this->Lift);
  std::copy_n(this->InkColor, 3, style.Color.begin());
  return style;
}

bool vtkInkStrokeMapper::GetExtent(double*)
{
  return false;
}

double vtkInkStrokeMapper::FindSizeUnit(const InkViewUniforms& view, const std::array<double, 6>& box) const
{
  if (this->SizeUnit == WORLD)
  {
    return 1.0 / view.Unit;
  }
  const double scale = this->SizeUnit == THOUSANDTHS ? 1e-3 * view.PictureHeight : view.TileScale;
  const glm::dmat4 toView = glm::dmat4(glm::make_mat4(view.MCVC.data()));
  const glm::dvec4 middle(0.5 * (box[0] + box[1]), 0.5 * (box[2] + box[3]), 0.5 * (box[4] + box[5]), 1.0);
  const double distance =
    view.Eye[3] == 0.0f ? 1.0 : std::max(-(toView * middle).z, static_cast<double>(view.DepthRange[0]));
  return scale * view.Pixel * distance / view.Unit;
}

double vtkInkStrokeMapper::FindDashPeriod(const InkFrame& frame, const double bounds[6])
{
  if (this->GapLength <= 0.0 || !(this->Dashed || this->HiddenParts == DASHED))
  {
    return 0.0;
  }
  const InkShiftScale local = InkShiftScale::FromBounds(bounds);
  const InkViewUniforms view(frame.Renderer, frame.Actor, this, local, frame.GetSize());
  return local.Unit * this->FindSizeUnit(view, FindLocalBox(local, bounds)) *
    (this->DashLength + this->GapLength);
}

InkHatching vtkInkStrokeMapper::MakeHatching(const InkViewUniforms& view, vtkRenderer* renderer) const
{
  const auto number = [](double value) { return static_cast<float>(value); };
  InkHatching hatching;
  hatching.Intensity = { number(this->SilhouetteWeight), number(this->DiffuseTruncation),
    number(this->SilhouetteTruncation), number(this->Tone), number(this->DarkestTone) };
  hatching.Crosshatching = number(this->Crosshatching);
  const double scale = this->SizeUnit == THOUSANDTHS ? 1e-3 * view.PictureHeight : view.TileScale;
  const bool world = this->SizeUnit == WORLD;
  hatching.Spacing = { world ? 0.0f : number(scale * this->HatchSpacing),
    world ? number(this->HatchSpacing) : 0.0f };
  hatching.CullingCosine = number(this->CullingCosine);
  hatching.Lights = InkFindLights(renderer);
  return hatching;
}

int vtkInkStrokeMapper::CountPoints(
  const InkStrokeMarks& marks, const InkViewUniforms& view, const InkStrokeStyle& style, int all) const
{
  return style.Hatching ? marks.Strokes.CountPoints(FindMostPriority(marks.Strokes, view, style)) : all;
}
