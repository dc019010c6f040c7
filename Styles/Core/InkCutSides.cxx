// SPDX-License-Identifier: BSD-3-Clause
#include "InkCutSides.h"

#include "Core/OtherAxes.h"

#include "vtkImageData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <bitset>

namespace
{

constexpr int MostParts = 16;
constexpr double Slack = 0.5; // voxels
constexpr vtkIdType MostPoints = 1000000;

} // namespace

std::array<double, 6> InkFindCutSides(vtkImageData* image, vtkPoints* points)
{
  if (image->GetNumberOfPoints() == 0)
  {
    return {};
  }
  const int* extent = image->GetExtent();
  std::array<int, 3> cells;
  std::array<int, 3> parts;
  for (int axis = 0; axis < 3; ++axis)
  {
    cells[axis] = std::max(extent[2 * axis + 1] - extent[2 * axis], 1);
    parts[axis] = std::min(cells[axis], MostParts);
  }
  std::array<std::bitset<MostParts * MostParts>, 6> covered;
  const vtkIdType step = points->GetNumberOfPoints() / MostPoints + 1;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); i += step)
  {
    double point[3];
    double index[3];
    points->GetPoint(i, point);
    image->TransformPhysicalPointToContinuousIndex(point, index);
    std::array<int, 3> part;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double along = (index[axis] - extent[2 * axis]) / cells[axis];
      part[axis] = static_cast<int>(std::clamp(along * parts[axis], 0.0, parts[axis] - 1.0));
    }
    for (int side = 0; side < 6; ++side)
    {
      const int axis = side / 2;
      const double inside = side % 2 == 0 ? index[axis] - extent[side] : extent[side] - index[axis];
      if (inside <= Slack)
      {
        const auto [u, v] = ink::otherAxes(axis);
        covered[side].set(part[u] + MostParts * part[v]);
      }
    }
  }
  std::array<double, 6> shares;
  for (int side = 0; side < 6; ++side)
  {
    const auto [u, v] = ink::otherAxes(side / 2);
    const int all = parts[u] * parts[v];
    shares[side] = static_cast<double>(covered[side].count()) / all;
  }
  return shares;
}
