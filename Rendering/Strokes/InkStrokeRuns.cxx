// SPDX-License-Identifier: BSD-3-Clause
#include "InkStrokeRuns.h"

#include "InkStrokePoints.h"
#include "InkViewUniforms.h"

#include "Core/ParallelFor.h"
#include "Visibility/CurveVisibility.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace
{

/// The direction in the picture of a surface's normal where the surface turns away from the eye; zero
/// elsewhere.
glm::dvec2 FindSilhouetteNormal(const float position[3], const float normal[3], const InkViewUniforms& view)
{
  constexpr double largestCosine = 0.01; // of the angle between normal and eye
  const glm::dvec3 inView =
    glm::dmat3(glm::make_mat3(view.Normal.data())) * glm::dvec3(glm::make_vec3(normal));
  const glm::dvec4 point =
    glm::dmat4(glm::make_mat4(view.MCVC.data())) * glm::dvec4(glm::dvec3(glm::make_vec3(position)), 1.0);
  const glm::dvec3 toEye =
    glm::dvec3(glm::make_vec3(view.Eye.data())) - (view.Eye[3] == 0.0f ? glm::dvec3(0.0) : glm::dvec3(point));
  const double length = glm::length(inView);
  const glm::dvec2 inPicture(inView);
  const double lengthInPicture = glm::length(inPicture);
  const bool isSilhouette = std::abs(glm::dot(inView, toEye)) <= largestCosine * length * glm::length(toEye);
  return isSilhouette && lengthInPicture > 0.0 ? inPicture / lengthInPicture : glm::dvec2(0.0);
}

} // namespace

double InkStrokeRuns::FindWithinOutline(const InkViewUniforms& view)
{
  // Of a picture's height: the same at any size, but for more than images have margins for.
  constexpr double share = 1.0 / 80.0;
  constexpr double most = 48.0;
  return std::min(share * view.PictureHeight, most);
}

void InkStrokeRuns::Add(const InkStrokePoints& strokes, int stroke, double from, double to, bool hidden)
{
  const InkStrokePoints::Stroke& own = strokes.GetStrokes()[static_cast<std::size_t>(stroke)];
  const int segments = own.Last - own.First;
  const auto run = static_cast<std::uint32_t>(this->Runs.size());
  const auto first = static_cast<std::int32_t>(this->Points.size());
  const bool whole = from == 0.0 && to == segments;
  const auto addPoint = [&](int point, double fraction)
  {
    const auto source = static_cast<std::uint32_t>(own.First + point);
    this->Points.push_back({ source, static_cast<std::uint32_t>(fraction * 0x1p32), run, 0 });
  };
  const auto addCut = [&](double position)
  {
    const int segment = static_cast<int>(position);
    addPoint(segment % segments, position - segment);
  };

  if (from != std::floor(from))
  {
    addCut(from);
  }
  for (int point = static_cast<int>(std::ceil(from)); point <= to; ++point)
  {
    if (point == segments && to > segments)
    {
      // Here arc length begins again.
      addPoint(segments, 0.0);
    }
    addPoint(point > segments || (point == segments && to > segments) ? point - segments : point, 0.0);
  }
  if (to != std::floor(to))
  {
    addCut(to);
  }
  const bool cutBegin = !whole && (from > 0.0 || own.Closed);
  const bool cutEnd = !whole && (to < segments || own.Closed);
  const int flags = (whole && own.Closed ? Closed : 0) | (cutBegin ? CutBegin : 0) | (cutEnd ? CutEnd : 0) |
    (hidden ? Hidden : 0);
  this->Runs.push_back({ first, static_cast<std::int32_t>(this->Points.size()) - 1, stroke, flags });
}

InkStrokeRuns InkStrokeRuns::FindWhole(const InkStrokePoints& strokes)
{
  InkStrokeRuns runs;
  int stroke = 0;
  for (const InkStrokePoints::Stroke& own : strokes.GetStrokes())
  {
    runs.Add(strokes, stroke++, 0.0, own.Last - own.First, false);
  }
  return runs;
}

InkStrokeRuns InkStrokeRuns::FindVisible(const InkStrokePoints& strokes, const InkViewUniforms& view,
  const std::vector<float>& depths, double tolerance, double leastRun, bool withHidden)
{
  ink::CurveOccluders occluders{ { depths, view.Size[0], view.Size[1] } };
  std::copy(view.DepthToClip.begin(), view.DepthToClip.end(), occluders.depthToClip);
  occluders.pixel = view.Pixel;
  occluders.tolerance = tolerance;
  occluders.withinOutline = FindWithinOutline(view);
  const glm::dmat4 toClip =
    glm::dmat4(glm::make_mat4(view.VCDC.data())) * glm::dmat4(glm::make_mat4(view.MCVC.data()));

  std::vector<std::vector<ink::CurveRun>> found(strokes.GetStrokes().size());
  ink::parallelFor(found.size(),
    [&](std::size_t stroke)
    {
      const InkStrokePoints::Stroke& own = strokes.GetStrokes()[stroke];
      std::vector<ink::CurvePoint> points;
      for (int i = own.First; i <= own.Last - (own.Closed ? 1 : 0); ++i)
      {
        const auto index = static_cast<std::size_t>(i);
        const float* p = strokes.GetPoints()[index].Position;
        const float curvature =
          strokes.GetRadialCurvature().empty() ? 0.0f : strokes.GetRadialCurvature()[index];
        points.push_back({ toClip * glm::dvec4(p[0], p[1], p[2], 1.0), curvature,
          FindSilhouetteNormal(p, strokes.GetShapes()[index].Normal, view) });
      }
      found[stroke] = findVisibleRuns(points, own.Closed, occluders, leastRun);
    });

  InkStrokeRuns runs;
  for (const bool hidden : { true, false })
  {
    for (std::size_t stroke = 0; stroke < found.size(); ++stroke)
    {
      for (const ink::CurveRun& run : found[stroke])
      {
        if (run.hidden == hidden && (withHidden || !hidden))
        {
          runs.Add(strokes, static_cast<int>(stroke), run.from, run.to, hidden);
        }
      }
    }
  }
  return runs;
}
