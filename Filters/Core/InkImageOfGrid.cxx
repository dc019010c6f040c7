// SPDX-License-Identifier: BSD-3-Clause
#include "InkImageOfGrid.h"

#include "InkActiveScalars.h"

#include "Core/FormatNumber.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkResampleToImage.h"
#include "vtkSMPTools.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{

using Dimensions = std::array<int, 3>;

Dimensions DimensionsOf(vtkDataSet* grid)
{
  Dimensions dimensions{};
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

std::array<vtkDataArray*, 3> CoordinatesOf(vtkRectilinearGrid* grid)
{
  return { grid->GetXCoordinates(), grid->GetYCoordinates(), grid->GetZCoordinates() };
}

/// The middles between neighbors.
vtkSmartPointer<vtkDoubleArray> MiddlesOf(vtkDataArray* coordinates)
{
  auto middles = vtkSmartPointer<vtkDoubleArray>::New();
  for (vtkIdType i = 1; i < coordinates->GetNumberOfTuples(); ++i)
  {
    constexpr double half = 0.5;
    middles->InsertNextValue(half * (coordinates->GetComponent(i - 1, 0) + coordinates->GetComponent(i, 0)));
  }
  return middles;
}

/// The means of the eight corners of cells.
vtkSmartPointer<vtkPoints> CentersOf(vtkStructuredGrid* grid, const Dimensions& d)
{
  auto centers = vtkSmartPointer<vtkPoints>::New();
  centers->SetDataTypeToDouble();
  centers->SetNumberOfPoints(grid->GetNumberOfCells());
  const std::array<vtkIdType, 3> steps{ 1, d[0], static_cast<vtkIdType>(d[0]) * d[1] };
  vtkIdType cell = 0;
  for (int z = 0; z + 1 < d[2]; ++z)
  {
    for (int y = 0; y + 1 < d[1]; ++y)
    {
      for (int x = 0; x + 1 < d[0]; ++x)
      {
        std::array<double, 3> center{};
        constexpr int corners = 8;
        for (int corner = 0; corner < corners; ++corner)
        {
          double point[3];
          grid->GetPoint(
            x + (corner & 1) + (y + (corner >> 1 & 1)) * steps[1] + (z + (corner >> 2)) * steps[2], point);
          std::transform(point, point + 3, center.begin(), center.begin(),
            [](double one, double sum) { return sum + one / corners; });
        }
        centers->SetPoint(cell++, center.data());
      }
    }
  }
  return centers;
}

/// A grid without values of the centers of another one's cells.
vtkSmartPointer<vtkDataSet> GridOfCenters(vtkDataSet* grid)
{
  const Dimensions d = DimensionsOf(grid);
  if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(grid))
  {
    const auto [x, y, z] = CoordinatesOf(rectilinear);
    auto centers = vtkSmartPointer<vtkRectilinearGrid>::New();
    centers->SetDimensions(d[0] - 1, d[1] - 1, d[2] - 1);
    centers->SetXCoordinates(MiddlesOf(x));
    centers->SetYCoordinates(MiddlesOf(y));
    centers->SetZCoordinates(MiddlesOf(z));
    return centers;
  }
  auto centers = vtkSmartPointer<vtkStructuredGrid>::New();
  centers->SetDimensions(d[0] - 1, d[1] - 1, d[2] - 1);
  centers->SetPoints(CentersOf(vtkStructuredGrid::SafeDownCast(grid), d));
  return centers;
}

// Of a step; coordinates in 4 bytes are not exact.
constexpr double notSeen = 0.01;

/// A structured grid whose rows lie along x, y and z as one that says so; null if they do not.
vtkSmartPointer<vtkRectilinearGrid> AsRectilinear(vtkStructuredGrid* grid)
{
  if (grid->HasAnyBlankPoints() || grid->HasAnyBlankCells())
  {
    return nullptr;
  }
  const Dimensions d = DimensionsOf(grid);
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

/// Where an image has its voxels along an axis.
struct Axis
{
  double First = 0.0;
  double Last = 0.0;
  double Count = 0.0;
  bool IsEven = false; ///< where the grid has its points

  double Step() const { return (this->Last - this->First) / (this->Count - 1.0); }
};

/// Of a part of the steps, from the finest one up.
double FineStep(std::vector<double>& steps)
{
  constexpr std::size_t quarter = 4;
  const auto fine = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / quarter);
  std::nth_element(steps.begin(), fine, steps.end());
  return *fine;
}

/// How many voxels of a size an axis has, with a limit far above what is taken.
double countOf(const Axis& axis, double size)
{
  constexpr double most = 1e6;
  return std::min(std::ceil((axis.Last - axis.First) / size) + 1.0, most);
}

Axis AxisOf(vtkDataArray* coordinates, char name)
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
  Axis axis{ std::min(at(0), at(count - 1)), std::max(at(0), at(count - 1)), static_cast<double>(count) };
  axis.IsEven = furthest <= notSeen * std::abs(mean);
  if (!axis.IsEven)
  {
    axis.Count = countOf(axis, FineStep(steps));
  }
  return axis;
}

using Axes = std::array<Axis, 3>;

Axes AxesOf(vtkRectilinearGrid* grid)
{
  const auto [x, y, z] = CoordinatesOf(grid);
  return { AxisOf(x, 'x'), AxisOf(y, 'y'), AxisOf(z, 'z') };
}

/// The distances between neighbors that do not fall together, as at poles. @throws std::invalid_argument
std::vector<double> StepsOf(vtkStructuredGrid* grid)
{
  const Dimensions d = DimensionsOf(grid);
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

Axes AxesOf(vtkStructuredGrid* grid)
{
  std::vector<double> steps = StepsOf(grid);
  const double* bounds = grid->GetBounds();
  Axes axes;
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
  for (Axis& axis : axes)
  {
    axis.Count = countOf(axis, step);
  }
  return axes;
}

/// Takes fewer voxels where they are far more than points.
void Limit(Axes& axes, double points)
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
    for (const Axis& axis : axes)
    {
      voxels *= axis.Count;
      free += !axis.IsEven && axis.Count > 2.0 ? 1.0 : 0.0;
    }
    if (voxels <= most || free == 0.0)
    {
      return;
    }
    const double share = std::pow(most / voxels, 1.0 / free);
    for (Axis& axis : axes)
    {
      axis.Count = axis.IsEven ? axis.Count : std::max(std::floor(axis.Count * share), 2.0);
    }
  }
}

/// In how many cells' bounding boxes voxels lie, all together: vtkResampleToImage looks at each cell for
/// each.
double CountLooks(vtkStructuredGrid* grid, const Axes& axes)
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
void LimitLooks(vtkStructuredGrid* grid, Axes& axes)
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
    for (Axis& axis : axes)
    {
      axis.Count = std::max(std::floor(axis.Count * std::cbrt(most / looks)), 2.0);
    }
  }
}

constexpr const char* hiddenCells = "hidden";
constexpr unsigned char hiddenCell = vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::REFINEDCELL;

/// The first components as float or double, NaN where marked as hidden.
template <class Array>
vtkSmartPointer<Array> VisibleValues(vtkDataArray* values, vtkUnsignedCharArray* marks, unsigned char hidden)
{
  auto visible = vtkSmartPointer<Array>::New();
  visible->SetName("values");
  visible->SetNumberOfValues(values->GetNumberOfTuples());
  using Value = typename Array::ValueType;
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    visible->SetValue(i,
      marks && (marks->GetValue(i) & hidden) != 0 ? std::numeric_limits<Value>::quiet_NaN()
                                                  : static_cast<Value>(values->GetComponent(i, 0)));
  }
  return visible;
}

/// Gives voxels outside of a grid the mean of those around them, as a surface ends where one of a cell's
/// corners has no value, and cells that are cut by the border have such.
template <class Array>
void GoOutside(Array* values, const std::vector<vtkIdType>& outside, vtkImageData* image)
{
  const int* d = image->GetDimensions();
  std::vector<double> means;
  means.reserve(outside.size());
  for (const vtkIdType voxel : outside)
  {
    const int x = static_cast<int>(voxel % d[0]);
    const int y = static_cast<int>(voxel / d[0] % d[1]);
    const int z = static_cast<int>(voxel / d[0] / d[1]);
    double sum = 0.0;
    int count = 0;
    for (int k = std::max(z - 1, 0); k <= std::min(z + 1, d[2] - 1); ++k)
    {
      for (int j = std::max(y - 1, 0); j <= std::min(y + 1, d[1] - 1); ++j)
      {
        for (int i = std::max(x - 1, 0); i <= std::min(x + 1, d[0] - 1); ++i)
        {
          const double value = values->GetValue(i + d[0] * (j + static_cast<vtkIdType>(d[1]) * k));
          if (!std::isnan(value))
          {
            sum += value;
            ++count;
          }
        }
      }
    }
    means.push_back(sum / count);
  }
  for (std::size_t i = 0; i < outside.size(); ++i)
  {
    values->SetValue(outside[i], static_cast<typename Array::ValueType>(means[i]));
  }
}

template <class Array>
vtkSmartPointer<vtkImageData> Resampled(vtkDataSet* grid, const Axes& axes)
{
  vtkNew<vtkResampleToImage> resample;
  resample->SetInputDataObject(grid);
  resample->UseInputBoundsOff();
  double bounds[6];
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    // Rounding moves no voxel on the border outside.
    constexpr double within = 1e-6;
    bounds[2 * axis] = axes[axis].First + within * axes[axis].Step();
    bounds[2 * axis + 1] = axes[axis].Last - within * axes[axis].Step();
  }
  resample->SetSamplingBounds(bounds);
  resample->SetSamplingDimensions(
    static_cast<int>(axes[0].Count), static_cast<int>(axes[1].Count), static_cast<int>(axes[2].Count));
  // In threads it is chance which of two cells has a voxel that lies between them.
  vtkSMPTools::LocalScope(
    vtkSMPTools::Config(std::string("Sequential")), [&resample] { resample->Update(); });
  vtkPointData* sampled = resample->GetOutput()->GetPointData();
  auto* values = Array::SafeDownCast(sampled->GetArray("values"));
  vtkDataArray* valid = sampled->GetArray(resample->GetMaskArrayName());
  vtkDataArray* hidden = sampled->GetArray(hiddenCells);
  if (!values || !valid)
  {
    throw std::invalid_argument("none of its cells has room for a voxel");
  }
  std::vector<vtkIdType> outside;
  for (vtkIdType i = 0; i < values->GetNumberOfValues(); ++i)
  {
    const bool isOutside = valid->GetComponent(i, 0) == 0.0;
    if (isOutside)
    {
      outside.push_back(i);
    }
    if (isOutside || (hidden && hidden->GetComponent(i, 0) != 0.0))
    {
      values->SetValue(i, std::numeric_limits<typename Array::ValueType>::quiet_NaN());
    }
  }
  GoOutside(values, outside, resample->GetOutput());
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(resample->GetOutput()->GetDimensions());
  image->SetOrigin(resample->GetOutput()->GetOrigin());
  image->SetSpacing(resample->GetOutput()->GetSpacing());
  image->GetPointData()->SetScalars(values);
  return image;
}

template <class Array>
vtkSmartPointer<vtkImageData> Resampled(vtkDataSet* grid, vtkDataArray* values, bool areOfCells)
{
  vtkSmartPointer<vtkDataSet> points =
    areOfCells ? GridOfCenters(grid) : vtk::TakeSmartPointer(grid->NewInstance());
  using Marks = vtkDataSetAttributes;
  const auto marksOf = [](vtkDataSetAttributes* attributes)
  { return vtkUnsignedCharArray::SafeDownCast(attributes->GetAbstractArray(Marks::GhostArrayName())); };
  if (!areOfCells)
  {
    points->CopyStructure(grid);
    // VTK's versions differ in what they do with marks, and the structure may have them.
    points->GetPointData()->Initialize();
    points->GetCellData()->Initialize();
    if (vtkUnsignedCharArray* marks = marksOf(grid->GetCellData()))
    {
      // Each voxel gets that of the cell that it is in.
      vtkNew<vtkUnsignedCharArray> hidden;
      hidden->SetName(hiddenCells);
      hidden->SetNumberOfValues(marks->GetNumberOfValues());
      std::transform(marks->GetPointer(0), marks->GetPointer(marks->GetNumberOfValues()),
        hidden->GetPointer(0),
        [](unsigned char mark) { return static_cast<unsigned char>(mark & hiddenCell); });
      points->GetCellData()->AddArray(hidden);
    }
  }
  const auto visible = areOfCells
    ? VisibleValues<Array>(values, marksOf(grid->GetCellData()), hiddenCell)
    : VisibleValues<Array>(values, marksOf(grid->GetPointData()), Marks::HIDDENPOINT);
  points->GetPointData()->SetScalars(visible);
  auto* rectilinear = vtkRectilinearGrid::SafeDownCast(points);
  auto* structured = vtkStructuredGrid::SafeDownCast(points);
  Axes axes = rectilinear ? AxesOf(rectilinear) : AxesOf(structured);
  Limit(axes, static_cast<double>(points->GetNumberOfPoints()));
  if (structured)
  {
    LimitLooks(structured, axes);
  }
  const vtkSmartPointer<vtkImageData> image = Resampled<Array>(points, axes);
  image->GetPointData()->GetScalars()->SetName(values->GetName());
  return image;
}

/// Values of points, along some axes the last one first.
vtkSmartPointer<vtkDataArray> Turned(vtkDataArray* values, const int d[3], const std::array<bool, 3>& turns)
{
  auto turned = vtk::TakeSmartPointer(values->NewInstance());
  turned->SetName(values->GetName());
  turned->SetNumberOfComponents(values->GetNumberOfComponents());
  turned->SetNumberOfTuples(values->GetNumberOfTuples());
  vtkIdType to = 0;
  const auto place = [&](int axis, int i)
  { return turns[static_cast<std::size_t>(axis)] ? d[axis] - 1 - i : i; };
  for (int z = 0; z < d[2]; ++z)
  {
    for (int y = 0; y < d[1]; ++y)
    {
      for (int x = 0; x < d[0]; ++x)
      {
        turned->SetTuple(
          to++, place(0, x) + d[0] * (place(1, y) + static_cast<vtkIdType>(d[1]) * place(2, z)), values);
      }
    }
  }
  return turned;
}

/// A rectilinear grid that is an image as it is; null if it is none.
vtkSmartPointer<vtkImageData> Same(vtkRectilinearGrid* grid, vtkDataArray* values, bool areOfCells)
{
  if (grid->HasAnyBlankPoints() || grid->HasAnyBlankCells())
  {
    return nullptr;
  }
  const Axes axes = AxesOf(grid);
  auto image = vtkSmartPointer<vtkImageData>::New();
  const Dimensions d = DimensionsOf(grid);
  const int less = areOfCells ? 1 : 0;
  image->SetDimensions(d[0] - less, d[1] - less, d[2] - less);
  std::array<double, 3> origin;
  std::array<double, 3> spacing;
  std::array<bool, 3> falls;
  const auto coordinates = CoordinatesOf(grid);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (!axes[axis].IsEven)
    {
      return nullptr;
    }
    falls[axis] = coordinates[axis]->GetComponent(0, 0) != axes[axis].First;
    constexpr double half = 0.5;
    spacing[axis] = axes[axis].Step();
    origin[axis] = axes[axis].First + half * less * spacing[axis];
  }
  image->SetOrigin(origin.data());
  image->SetSpacing(spacing.data());
  const bool anyFalls = std::any_of(falls.begin(), falls.end(), [](bool one) { return one; });
  image->GetPointData()->SetScalars(
    anyFalls ? Turned(values, image->GetDimensions(), falls) : vtkSmartPointer<vtkDataArray>(values));
  return InkWithFirstComponent(image);
}

} // namespace

InkGridImage InkImageOfGrid(vtkDataSet* grid, vtkDataArray* values)
{
  const Dimensions d = DimensionsOf(grid);
  const bool areOfCells = values->GetNumberOfTuples() == grid->GetNumberOfCells();
  // Fewer have no steps between them.
  const int least = areOfCells ? 3 : 2;
  if (*std::min_element(d.begin(), d.end()) < least)
  {
    throw std::invalid_argument("its grid has " + ink::formatDimensions(d.data()) + " points; expected " +
      std::to_string(least) + " or more along each axis");
  }
  if (!areOfCells && values->GetNumberOfTuples() != grid->GetNumberOfPoints())
  {
    throw std::invalid_argument("it holds " + std::to_string(values->GetNumberOfTuples()) + " values for " +
      std::to_string(grid->GetNumberOfPoints()) + " points");
  }
  auto* structured = vtkStructuredGrid::SafeDownCast(grid);
  const auto regular = structured ? AsRectilinear(structured) : nullptr;
  grid = regular ? regular.Get() : grid;
  auto* rectilinear = vtkRectilinearGrid::SafeDownCast(grid);
  if (const auto same = rectilinear ? Same(rectilinear, values, areOfCells) : nullptr)
  {
    return { same, false };
  }
  // Integers of up to 16 bits are numbers of float.
  const int type = values->GetDataType();
  const bool fits = type == VTK_FLOAT || values->GetDataTypeSize() < static_cast<int>(sizeof(float));
  return { fits ? Resampled<vtkFloatArray>(grid, values, areOfCells)
                : Resampled<vtkDoubleArray>(grid, values, areOfCells),
    true };
}
