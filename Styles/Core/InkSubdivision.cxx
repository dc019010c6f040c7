// SPDX-License-Identifier: BSD-3-Clause
#include "InkSubdivision.h"

#include "vtkInkStyle.h"

#include "IsoSurface/ResampledSamples.h"

#include <algorithm>

namespace
{

/// Cells are divided until they measure no more thousandths of the picture's height than this on either side,
/// but not into more. Not pixels: lines are as broad as cells, and a picture of any size is to have the same.
constexpr double LargestCell = 4.0;
constexpr int MostSubdivision = 8;

/// More points are not made while someone waits for them.
constexpr double MostInteractivePoints = 4e6;

} // namespace

double InkGrowthOfPoints(int cells, double ratio)
{
  return static_cast<double>(cells) * ink::subdivisionAlong(ratio, cells);
}

InkSubdivision InkChooseSubdivision(vtkInkStyle* style, double voxel, double ratio, double longest,
  const std::function<double()>& countPoints, double mostPoints)
{
  // What cells measure where the longest side of all voxels is as long as the picture is high.
  const double cell = longest > 0.0 ? 1e3 * voxel / longest : 0.0;
  InkSubdivision chosen;
  if (cell <= 0.0)
  {
    return chosen;
  }
  const double size = style->GetRelativeSize();
  int wanted = 1;
  while (wanted < MostSubdivision && size * cell > LargestCell * wanted)
  {
    wanted *= 2;
  }
  const double points = wanted > 1 ? countPoints() : 0.0;
  const double most = style->GetInteractive() ? std::min(mostPoints, MostInteractivePoints) : mostPoints;
  const auto isTooFine = [&](int cells) { return points * InkGrowthOfPoints(cells, ratio) > most; };
  chosen.Cells = wanted;
  while (chosen.Cells > 1 && isTooFine(chosen.Cells))
  {
    chosen.Cells /= 2;
  }
  const auto largestSize = [&](int cells) { return LargestCell * cells / cell; };
  if (chosen.Cells > 1)
  {
    chosen.Above = largestSize(chosen.Cells / 2);
  }
  if (chosen.Cells < MostSubdivision && !isTooFine(2 * chosen.Cells))
  {
    chosen.UpTo = largestSize(chosen.Cells);
  }
  if (chosen.Cells < wanted)
  {
    chosen.Note = "voxels are divided by " + std::to_string(chosen.Cells) + ", not " +
      std::to_string(wanted) + ", along each axis, as the surface lies in " +
      std::to_string(static_cast<long long>(points)) + " of them (Subdivision)";
  }
  return chosen;
}
