// SPDX-License-Identifier: BSD-3-Clause
#include "InkImageOfGrid.h"

#include "InkActiveScalars.h"
#include "InkGridAxes.h"

#include "Core/FormatNumber.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
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
vtkSmartPointer<vtkPoints> CentersOf(vtkStructuredGrid* grid, const std::array<int, 3>& d)
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
  const std::array<int, 3> d = InkGridDimensions(grid);
  if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(grid))
  {
    const auto [x, y, z] = InkGridCoordinates(rectilinear);
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
vtkSmartPointer<vtkImageData> Resampled(vtkDataSet* grid, const InkGridAxes& axes)
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
  const vtkSmartPointer<vtkImageData> image = Resampled<Array>(points, InkFindVoxels(points));
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
  const InkGridAxes axes = InkFindAxes(grid);
  auto image = vtkSmartPointer<vtkImageData>::New();
  const std::array<int, 3> d = InkGridDimensions(grid);
  const int less = areOfCells ? 1 : 0;
  image->SetDimensions(d[0] - less, d[1] - less, d[2] - less);
  std::array<double, 3> origin;
  std::array<double, 3> spacing;
  std::array<bool, 3> falls;
  const auto coordinates = InkGridCoordinates(grid);
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
  const std::array<int, 3> d = InkGridDimensions(grid);
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
  const auto regular = structured ? InkAsRectilinear(structured) : nullptr;
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
