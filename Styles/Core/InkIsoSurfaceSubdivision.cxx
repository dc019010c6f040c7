// SPDX-License-Identifier: BSD-3-Clause
// How finely voxels are divided for a picture.
#include "InkIsoSurface.h"

#include "InkLongestSide.h"
#include "InkStyleProcesses.h"
#include "InkSubdivision.h"
#include "InkVolumeValues.h"

#include "vtkImageData.h"

#include <algorithm>
#include <array>
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
  // The shortest side of all processes' voxels, negated, and the largest ratio.
  std::array voxel{ std::numeric_limits<double>::lowest(), 1.0 };
  for (vtkImageData* image : images)
  {
    const VoxelSides sides = MeasureVoxel(image);
    voxel[0] = std::max(voxel[0], -sides.Shortest);
    voxel[1] = std::max(voxel[1], sides.Ratio);
  }
  style->GetProcesses().TakeGreatest(voxel);
  double longest = InkLongestSide(images, style->GetProcesses());
  // Interactively the relative size says how large a view shows it.
  if (!style->GetInteractive() && images.size() == 1)
  {
    longest =
      FitLongest(longest, values, [&](double value) { return InkFindSurfaceLength(images.front(), value); });
  }
  const InkSubdivision chosen = InkChooseSubdivision(
    style, -voxel[0], voxel[1], longest, [&] { return CountPoints(style->GetProcesses(), whole(), values); });
  TakeSubdivision(style, chosen);
  return chosen.Cells;
}

InkIsoSurface::VoxelSides InkIsoSurface::MeasureVoxel(vtkImageData* image)
{
  const double* spacing = image->GetSpacing();
  const std::array sides{ std::abs(spacing[0]), std::abs(spacing[1]), std::abs(spacing[2]) };
  const auto [shortest, longest] = std::minmax_element(sides.begin(), sides.end());
  return { *shortest, *shortest > 0.0 ? *longest / *shortest : 1.0 };
}

double InkIsoSurface::FitLongest(
  double longest, const std::vector<double>& values, const std::function<double(double value)>& measure)
{
  // What fills half of the volume is what cells are made for, and do well enough for what is not much
  // smaller.
  constexpr double smallShare = 0.2;
  constexpr double usualShare = 0.5;
  double length = 0.0;
  for (const double value : values)
  {
    length = std::max(length, measure(value));
  }
  return length > 0.0 && length < smallShare * longest ? length / usualShare : longest;
}

void InkIsoSurface::TakeSubdivision(vtkInkStyle* style, const InkSubdivision& chosen)
{
  style->LimitPictures(chosen.Above, chosen.UpTo);
  if (!chosen.Note.empty())
  {
    style->AddNote(chosen.Note);
  }
}
