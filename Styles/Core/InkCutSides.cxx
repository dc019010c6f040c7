// SPDX-License-Identifier: BSD-3-Clause
#include "InkCutSides.h"

#include "Core/OtherAxes.h"

#include "vtkImageData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <cstddef>
#include <limits>

namespace
{

constexpr int MostParts = 16;
constexpr double Slack = 0.5; // voxels
constexpr vtkIdType MostPoints = 1000000;

/// In voxels: the lower and the upper end along each axis.
using Box = std::array<double, 6>;

/// Calls visit(index) with where each of the points, or of a million of them, lies among the voxels.
template <class Visit>
void VisitIndices(vtkImageData* image, vtkPoints* points, const Visit& visit)
{
  const vtkIdType step = points->GetNumberOfPoints() / MostPoints + 1;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); i += step)
  {
    double point[3];
    std::array<double, 3> index;
    points->GetPoint(i, point);
    image->TransformPhysicalPointToContinuousIndex(point, index.data());
    visit(index);
  }
}

std::array<double, 6> FindCoveredSides(vtkImageData* image, vtkPoints* points, const Box& box)
{
  std::array<double, 3> cells;
  std::array<int, 3> parts;
  for (int axis = 0; axis < 3; ++axis)
  {
    cells[axis] = std::max(box[2 * axis + 1] - box[2 * axis], 1.0);
    parts[axis] = static_cast<int>(std::min<double>(cells[axis], MostParts));
  }
  std::array<std::bitset<MostParts * MostParts>, 6> covered;
  VisitIndices(image, points,
    [&](const std::array<double, 3>& index)
    {
      std::array<int, 3> part;
      for (int axis = 0; axis < 3; ++axis)
      {
        const double along = (index[axis] - box[2 * axis]) / cells[axis];
        part[axis] = static_cast<int>(std::clamp(along * parts[axis], 0.0, parts[axis] - 1.0));
      }
      for (int side = 0; side < 6; ++side)
      {
        const int axis = side / 2;
        const double inside = side % 2 == 0 ? index[axis] - box[side] : box[side] - index[axis];
        if (inside <= Slack)
        {
          const auto [u, v] = ink::otherAxes(axis);
          covered[side].set(part[u] + MostParts * part[v]);
        }
      }
    });
  std::array<double, 6> shares;
  for (int side = 0; side < 6; ++side)
  {
    const auto [u, v] = ink::otherAxes(side / 2);
    const int all = parts[u] * parts[v];
    shares[side] = static_cast<double>(covered[side].count()) / all;
  }
  return shares;
}

} // namespace

std::array<double, 6> InkFindCutSides(vtkImageData* image, vtkPoints* points)
{
  Box box;
  std::copy_n(image->GetExtent(), box.size(), box.begin());
  return image->GetNumberOfPoints() > 0 ? FindCoveredSides(image, points, box) : std::array<double, 6>();
}

std::array<double, 6> InkFindFlatSides(vtkImageData* image, vtkPoints* points)
{
  constexpr double none = std::numeric_limits<double>::infinity();
  Box box{ none, -none, none, -none, none, -none };
  VisitIndices(image, points,
    [&](const std::array<double, 3>& index)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        box[2 * axis] = std::min(box[2 * axis], index[axis]);
        box[2 * axis + 1] = std::max(box[2 * axis + 1], index[axis]);
      }
    });
  const bool isThick = box[1] - box[0] >= 1.0 && box[3] - box[2] >= 1.0 && box[5] - box[4] >= 1.0;
  return isThick ? FindCoveredSides(image, points, box) : std::array<double, 6>();
}
