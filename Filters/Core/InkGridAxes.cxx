// SPDX-License-Identifier: BSD-3-Clause
#include "InkGridAxes.h"

#include "Core/FormatNumber.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{

// Of a step; coordinates in 4 bytes are not exact.
constexpr double notSeen = 0.01;

/// Of a part of the steps, from the finest one up.
double FineStep(std::vector<double>& steps)
{
  constexpr std::size_t quarter = 4;
  const auto fine = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / quarter);
  std::nth_element(steps.begin(), fine, steps.end());
  return *fine;
}

/// How many voxels of a size an axis has, with a limit far above what is taken.
double CountOf(const InkGridAxis& axis, double size)
{
  constexpr double most = 1e6;
  return std::min(std::ceil((axis.Last - axis.First) / size) + 1.0, most);
}

InkGridAxis AxisOf(vtkDataArray* coordinates, char name)
{
  const auto at = [coordinates](vtkIdType i) { return coordinates->GetComponent(i, 0); };
  const vtkIdType count = coordinates->GetNumberOfTuples();
  const double sign = at(count - 1) < at(0) ? -1.0 : 1.0;
  std::vector<double> steps;
  double furthest = 0.0;
  const double mean = (at(count - 1) - at(0)) / static_cast<double>(count - 1);
  for (vtkIdType i = 1; i < count; ++i)
  {
    steps.push_back(sign * (at(i) - at(i - 1)));
    if (!(steps.back() > 0.0 && std::isfinite(steps.back())))
    {
      throw std::invalid_argument(std::string("its coordinates along ") + name + " go from " +
        ink::formatNumber(at(i - 1)) + " to " + ink::formatNumber(at(i)) +
        "; expected numbers that rise, or fall, throughout");
    }
    furthest = std::max(furthest, std::abs(at(i) - at(0) - static_cast<double>(i) * mean));
  }
  InkGridAxis axis{ std::min(at(0), at(count - 1)), std::max(at(0), at(count - 1)),
    static_cast<double>(count) };
  axis.IsEven = furthest <= notSeen * std::abs(mean);
  if (!axis.IsEven)
  {
    axis.Count = CountOf(axis, FineStep(steps));
  }
  return axis;
}

/// The distances between neighbors that do not fall together, as at poles. @throws std::invalid_argument
std::vector<double> StepsOf(vtkStructuredGrid* grid)
{
  const std::array<int, 3> d = InkGridDimensions(grid);
  const std::array<vtkIdType, 3> strides{ 1, d[0], static_cast<vtkIdType>(d[0]) * d[1] };
  std::vector<double> steps;
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    double point[3];
    grid->GetPoint(i, point);
    for (const double x : point)
    {
      if (!std::isfinite(x))
      {
        throw std::invalid_argument("its point " + std::to_string(i) + " has the coordinate " +
          ink::formatNumber(x) + "; expected finite numbers");
      }
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      if ((i / strides[axis]) % d[axis] > 0)
      {
        double before[3];
        grid->GetPoint(i - strides[axis], before);
        const double step = std::sqrt(vtkMath::Distance2BetweenPoints(point, before));
        if (step > 0.0)
        {
          steps.push_back(step);
        }
      }
    }
  }
  return steps;
}

InkGridAxes AxesOf(vtkStructuredGrid* grid)
{
  std::vector<double> steps = StepsOf(grid);
  const double* bounds = grid->GetBounds();
  InkGridAxes axes;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    axes[axis].First = bounds[2 * axis];
    axes[axis].Last = bounds[2 * axis + 1];
    if (!(axes[axis].Last > axes[axis].First && std::isfinite(axes[axis].Last - axes[axis].First)))
    {
      throw std::invalid_argument("its points are from " + ink::formatNumber(axes[axis].First) + " to " +
        ink::formatNumber(axes[axis].Last) + " along " + "xyz"[axis] + "; expected a volume");
    }
  }
  // Its border is made of voxels, which leave gaps where surfaces go along it; small ones leave gaps in lines
  // along slanted borders.
  constexpr double perStep = 3.0;
  const double step = FineStep(steps) / perStep;
  for (InkGridAxis& axis : axes)
  {
    axis.Count = CountOf(axis, step);
  }
  return axes;
}

/// Takes fewer voxels where they are far more than points.
void Limit(InkGridAxes& axes, double points)
{
  constexpr double few = 1 << 21;
  constexpr double many = 1 << 27;
  constexpr double times = 8.0;
  constexpr double timesOfFew = 512.0;
  const double most =
    std::max(std::min(few, timesOfFew * points), std::min(times * points, std::max(points, many)));
  // In turns, as an axis keeps two voxels.
  for (int turn = 0; turn < 3; ++turn)
  {
    double voxels = 1.0;
    double free = 0.0;
    for (const InkGridAxis& axis : axes)
    {
      voxels *= axis.Count;
      free += !axis.IsEven && axis.Count > 2.0 ? 1.0 : 0.0;
    }
    if (voxels <= most || free == 0.0)
    {
      return;
    }
    const double share = std::pow(most / voxels, 1.0 / free);
    for (InkGridAxis& axis : axes)
    {
      axis.Count = axis.IsEven ? axis.Count : std::max(std::floor(axis.Count * share), 2.0);
    }
  }
}

/// In how many cells' bounding boxes voxels lie, all together: vtkResampleToImage looks at each cell for
/// each.
double CountLooks(vtkStructuredGrid* grid, const InkGridAxes& axes)
{
  double looks = 0.0;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    double bounds[6];
    grid->GetCellBounds(cell, bounds);
    double voxels = 1.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      voxels *= (bounds[2 * axis + 1] - bounds[2 * axis]) / axes[axis].Step() + 1.0;
    }
    looks += voxels;
  }
  return looks;
}

/// Takes fewer voxels where cells overlap, or are so long and thin, that it would take minutes.
void LimitLooks(vtkStructuredGrid* grid, InkGridAxes& axes)
{
  constexpr double few = 1 << 22;
  constexpr double perPoint = 128.0;
  const double most = std::max(few, perPoint * static_cast<double>(grid->GetNumberOfPoints()));
  constexpr int turns = 8;
  for (int turn = 0; turn < turns; ++turn)
  {
    const double looks = CountLooks(grid, axes);
    if (looks <= most)
    {
      return;
    }
    for (InkGridAxis& axis : axes)
    {
      axis.Count = std::max(std::floor(axis.Count * std::cbrt(most / looks)), 2.0);
    }
  }
}

} // namespace

std::array<int, 3> InkGridDimensions(vtkDataSet* grid)
{
  std::array<int, 3> dimensions{};
  if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(grid))
  {
    rectilinear->GetDimensions(dimensions.data());
  }
  else if (auto* structured = vtkStructuredGrid::SafeDownCast(grid))
  {
    structured->GetDimensions(dimensions.data());
  }
  return dimensions;
}

std::array<vtkDataArray*, 3> InkGridCoordinates(vtkRectilinearGrid* grid)
{
  return { grid->GetXCoordinates(), grid->GetYCoordinates(), grid->GetZCoordinates() };
}

vtkSmartPointer<vtkRectilinearGrid> InkAsRectilinear(vtkStructuredGrid* grid)
{
  if (grid->HasAnyBlankPoints() || grid->HasAnyBlankCells())
  {
    return nullptr;
  }
  const std::array<int, 3> d = InkGridDimensions(grid);
  const std::array<vtkIdType, 3> strides{ 1, d[0], static_cast<vtkIdType>(d[0]) * d[1] };
  std::array<std::vector<double>, 3> rows;
  std::array<double, 3> tolerances;
  double point[3];
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (int i = 0; i < d[axis]; ++i)
    {
      grid->GetPoint(i * strides[axis], point);
      rows[axis].push_back(point[axis]);
    }
    tolerances[axis] = notSeen * std::abs(rows[axis].back() - rows[axis].front()) / (d[axis] - 1);
  }
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    grid->GetPoint(i, point);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const auto place = static_cast<std::size_t>(i / strides[axis] % d[axis]);
      if (!(std::abs(point[axis] - rows[axis][place]) <= tolerances[axis]))
      {
        return nullptr;
      }
    }
  }
  auto rectilinear = vtkSmartPointer<vtkRectilinearGrid>::New();
  rectilinear->SetDimensions(d.data());
  const auto arrayOf = [](const std::vector<double>& row)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetNumberOfValues(static_cast<vtkIdType>(row.size()));
    std::copy(row.begin(), row.end(), array->GetPointer(0));
    return vtkSmartPointer<vtkDoubleArray>(array);
  };
  rectilinear->SetXCoordinates(arrayOf(rows[0]));
  rectilinear->SetYCoordinates(arrayOf(rows[1]));
  rectilinear->SetZCoordinates(arrayOf(rows[2]));
  return rectilinear;
}

InkGridAxes InkFindAxes(vtkRectilinearGrid* grid)
{
  const auto [x, y, z] = InkGridCoordinates(grid);
  return { AxisOf(x, 'x'), AxisOf(y, 'y'), AxisOf(z, 'z') };
}

InkGridAxes InkFindVoxels(vtkDataSet* grid)
{
  auto* structured = vtkStructuredGrid::SafeDownCast(grid);
  InkGridAxes axes = structured ? AxesOf(structured) : InkFindAxes(vtkRectilinearGrid::SafeDownCast(grid));
  Limit(axes, static_cast<double>(grid->GetNumberOfPoints()));
  if (structured)
  {
    LimitLooks(structured, axes);
  }
  return axes;
}
