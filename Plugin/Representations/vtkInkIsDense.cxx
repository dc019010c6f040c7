// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkIsDense.h"

#include "InkStyleProcesses.h"

#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkMath.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace
{

constexpr std::int64_t EnoughPoints = 1'000'000;
constexpr double LongestEdge = 7e-3; ///< of the diagonal

/// Of a mesh's polygons, with quadrilaterals' diagonals, or of its strips: the square of its length.
double FindLongestEdge(vtkPolyData* mesh, vtkCellArray* cells)
{
  double longest = 0.0;
  const auto cell = vtk::TakeSmartPointer(cells->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cell->GetCurrentCell(count, ids);
    double points[3][3];
    for (vtkIdType i = 0; i < count; ++i)
    {
      const double* point = points[i % 3];
      mesh->GetPoint(ids[i], points[i % 3]);
      for (vtkIdType before = std::max<vtkIdType>(i - 2, 0); before < i; ++before)
      {
        longest = std::max(longest, vtkMath::Distance2BetweenPoints(points[before % 3], point));
      }
    }
  }
  return longest;
}

} // namespace

bool vtkInkIsDense(const std::vector<vtkSmartPointer<vtkPolyData>>& meshes, InkStyleProcesses& processes)
{
  std::int64_t points = 0;
  vtkBoundingBox box;
  double longest = 0.0;
  for (vtkPolyData* mesh : meshes)
  {
    points += mesh->GetNumberOfPoints();
    box.AddBounds(mesh->GetBounds());
    longest = std::max(
      { longest, FindLongestEdge(mesh, mesh->GetPolys()), FindLongestEdge(mesh, mesh->GetStrips()) });
  }
  std::size_t begin = 0;
  const std::vector<std::int64_t> ofAll = processes.GatherAll({ &points, 1 }, begin);
  // Lower corners negated.
  const double* low = box.GetMinPoint();
  const double* high = box.GetMaxPoint();
  std::array found{ -low[0], -low[1], -low[2], high[0], high[1], high[2], longest };
  processes.TakeGreatest(found);
  const double diagonal = std::hypot(found[0] + found[3], found[1] + found[4], found[2] + found[5]);
  return std::accumulate(ofAll.begin(), ofAll.end(), std::int64_t{ 0 }) >= EnoughPoints ||
    std::sqrt(found[6]) <= LongestEdge * diagonal;
}
