// SPDX-License-Identifier: BSD-3-Clause
// How finely voxels are divided for a picture.
#include "InkIsoSurface.h"

#include "InkLongestSide.h"
#include "InkStyleProcesses.h"
#include "InkSubdivision.h"
#include "InkVolumeValues.h"

#include "vtkImageData.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{

/// An upper bound of the points of all surfaces in undivided cells, from the whole, so that it does not show
/// how many processes there are; all processes call it at once.
double CountPoints(
  InkStyleProcesses& processes, const InkWholeImages& images, const std::vector<double>& values)
{
  std::vector<double> points(1, 0.0);
  for (vtkImageData* image : images)
  {
    for (const double value : values)
    {
      points[0] += InkBoundSurfacePoints(image, value);
    }
  }
  processes.TakeOfFirst(points);
  return points[0];
}

} // namespace

int InkIsoSurface::FindSubdivision(vtkInkStyle* style, std::span<vtkImageData* const> images,
  const Whole& whole, const std::vector<double>& values) const
{
  if (this->Subdivision > 0)
  {
    return this->Subdivision;
  }
  // The finest of all processes, negated.
  double finest = std::numeric_limits<double>::lowest();
  for (vtkImageData* image : images)
  {
    for (const double spacing : std::span<const double, 3>(image->GetSpacing(), 3))
    {
      finest = std::max(finest, -std::abs(spacing));
    }
  }
  style->GetProcesses().TakeGreatest({ &finest, 1 });
  const InkSubdivision chosen =
    InkChooseSubdivision(style, -finest, InkLongestSide(images, style->GetProcesses()),
      [&] { return CountPoints(style->GetProcesses(), whole(), values); });
  TakeSubdivision(style, chosen);
  return chosen.Cells;
}

void InkIsoSurface::TakeSubdivision(vtkInkStyle* style, const InkSubdivision& chosen)
{
  style->LimitPictures(chosen.Above, chosen.UpTo);
  if (!chosen.Note.empty())
  {
    style->AddNote(chosen.Note);
  }
}
