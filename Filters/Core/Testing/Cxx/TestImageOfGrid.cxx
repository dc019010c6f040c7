// SPDX-License-Identifier: BSD-3-Clause
// Rectilinear and structured grids as images: what is one already stays as it is, others have the grid's
// function between its points, and nothing outside.

#include "InkImageOfGrid.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkShortArray.h"
#include "vtkStructuredGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{

/// What trilinear interpolation has exactly, also of positions that are.
double Linear(const double p[3])
{
  return 3.0 + p[0] - 2.0 * p[1] + 0.5 * p[2];
}

using Coordinates = std::vector<double>;

vtkSmartPointer<vtkRectilinearGrid> Rectilinear(
  const Coordinates& x, const Coordinates& y, const Coordinates& z)
{
  auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
  grid->SetDimensions(static_cast<int>(x.size()), static_cast<int>(y.size()), static_cast<int>(z.size()));
  const auto array = [](const Coordinates& coordinates)
  {
    auto values = vtkSmartPointer<vtkDoubleArray>::New();
    for (const double value : coordinates)
    {
      values->InsertNextValue(value);
    }
    return values;
  };
  grid->SetXCoordinates(array(x));
  grid->SetYCoordinates(array(y));
  grid->SetZCoordinates(array(z));
  return grid;
}

Coordinates Even(double first, double step, int count)
{
  Coordinates coordinates;
  for (int i = 0; i < count; ++i)
  {
    coordinates.push_back(first + i * step);
  }
  return coordinates;
}

/// A shell of half a ball's, from radius 1 to 2, whose cells at the poles are prisms.
vtkSmartPointer<vtkStructuredGrid> Shell()
{
  auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
  grid->SetDimensions(9, 25, 13);
  vtkNew<vtkPoints> points;
  for (int k = 0; k < 13; ++k)
  {
    for (int j = 0; j < 25; ++j)
    {
      for (int i = 0; i < 9; ++i)
      {
        const double r = 1.0 + i / 8.0;
        const double polar = std::numbers::pi * k / 12.0;
        const double around = std::numbers::pi * j / 24.0;
        points->InsertNextPoint(r * std::sin(polar) * std::cos(around),
          r * std::sin(polar) * std::sin(around), r * std::cos(polar));
      }
    }
  }
  grid->SetPoints(points);
  return grid;
}

vtkSmartPointer<vtkDoubleArray> ValuesOf(vtkDataSet* grid)
{
  auto values = vtkSmartPointer<vtkDoubleArray>::New();
  values->SetName("f");
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    values->InsertNextValue(Linear(grid->GetPoint(i)));
  }
  return values;
}

/// The largest distance from Linear where there are values. @param share of voxels that have one
double ErrorOf(vtkImageData* image, double& share)
{
  double error = 0.0;
  vtkIdType found = 0;
  vtkDataArray* values = image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    if (const double value = values->GetComponent(i, 0); !std::isnan(value))
    {
      ++found;
      error = std::max(error, std::abs(value - Linear(image->GetPoint(i))));
    }
  }
  share = static_cast<double>(found) / static_cast<double>(image->GetNumberOfPoints());
  return error;
}

void ExpectRefused(vtkDataSet* grid, const std::vector<std::string>& words)
{
  try
  {
    InkImageOfGrid(grid, ValuesOf(grid));
    ADD_FAILURE() << words.front();
  }
  catch (const std::invalid_argument& error)
  {
    for (const std::string& word : words)
    {
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
  }
}

} // namespace

TEST(ImageOfGrid, EvenPointsAreThoseOfAnImage)
{
  const auto grid = Rectilinear(Even(1.0, 0.5, 5), Even(-2.0, 1.0, 4), Even(7.0, 0.1, 3));
  const auto values = ValuesOf(grid);
  const auto image = InkImageOfGrid(grid, values).Image;
  EXPECT_EQ(image->GetPointData()->GetScalars(), values);
  EXPECT_EQ(image->GetNumberOfPoints(), grid->GetNumberOfPoints());
  double share;
  EXPECT_LT(ErrorOf(image, share), 1e-12);
}

TEST(ImageOfGrid, ValuesOfEvenCellsAreInTheirCenters)
{
  const auto grid = Rectilinear(Even(1.0, 0.5, 5), Even(-2.0, 1.0, 4), Even(7.0, 0.1, 3));
  vtkNew<vtkShortArray> values;
  values->SetNumberOfValues(grid->GetNumberOfCells());
  const auto image = InkImageOfGrid(grid, values).Image;
  EXPECT_EQ(image->GetPointData()->GetScalars(), values);
  EXPECT_EQ(image->GetNumberOfPoints(), grid->GetNumberOfCells());
  EXPECT_DOUBLE_EQ(image->GetOrigin()[0], 1.25);
  EXPECT_DOUBLE_EQ(image->GetOrigin()[1], -1.5);
  EXPECT_DOUBLE_EQ(image->GetOrigin()[2], 7.05);
}

TEST(ImageOfGrid, UnevenPointsAreResampled)
{
  const auto grid = Rectilinear({ 0.0, 0.1, 0.25, 0.5, 1.0, 2.0 }, Even(0.0, 0.3, 6), Even(-1.0, 0.7, 4));
  const auto [image, isResampled] = InkImageOfGrid(grid, ValuesOf(grid));
  EXPECT_TRUE(isResampled);
  // A quarter of the steps along x is at most .15.
  EXPECT_EQ(image->GetDimensions()[0], 15);
  EXPECT_EQ(image->GetDimensions()[1], 6);
  EXPECT_EQ(image->GetDimensions()[2], 4);
  EXPECT_EQ(image->GetScalarType(), VTK_DOUBLE);
  double share;
  EXPECT_LT(ErrorOf(image, share), 1e-12);
  EXPECT_EQ(share, 1.0);
}

TEST(ImageOfGrid, CoordinatesMayFall)
{
  // As those of Chebyshev's points.
  Coordinates falling;
  for (int i = 0; i < 9; ++i)
  {
    falling.push_back(std::cos(std::numbers::pi * i / 8.0));
  }
  for (const Coordinates& y : { falling, Even(3.0, -0.5, 7) })
  {
    const auto grid = Rectilinear(Even(0.0, 1.0, 5), y, Even(0.0, 1.0, 3));
    const auto image = InkImageOfGrid(grid, ValuesOf(grid)).Image;
    double share;
    EXPECT_LT(ErrorOf(image, share), 1e-12);
    EXPECT_EQ(share, 1.0);
    EXPECT_GT(image->GetSpacing()[1], 0.0);
  }
}

TEST(ImageOfGrid, EvenCoordinatesThatFallKeepTheValues)
{
  for (int falling = 0; falling < 8; ++falling)
  {
    const auto row = [falling](int axis, int count, double step)
    { return falling >> axis & 1 ? Even(3.0 + step * (count - 1), -step, count) : Even(3.0, step, count); };
    const auto grid = Rectilinear(row(0, 5, 1.0), row(1, 4, 0.5), row(2, 3, 2.0));
    vtkNew<vtkShortArray> values;
    values->SetName("labels");
    for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
    {
      values->InsertNextValue(static_cast<short>(2.0 * Linear(grid->GetPoint(i))));
    }
    const auto [image, isResampled] = InkImageOfGrid(grid, values);
    EXPECT_FALSE(isResampled) << falling;
    ASSERT_EQ(image->GetScalarType(), VTK_SHORT) << falling;
    EXPECT_STREQ(image->GetPointData()->GetScalars()->GetName(), "labels") << falling;
    for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
    {
      EXPECT_EQ(image->GetPointData()->GetScalars()->GetComponent(i, 0), 2.0 * Linear(image->GetPoint(i)))
        << falling;
    }
  }
}

TEST(ImageOfGrid, CellsThatOverlapTakeFewerVoxels)
{
  // Points all over a cube, but for steps along x of a ten thousandth.
  auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
  grid->SetDimensions(16, 16, 16);
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 16 * 16 * 16; ++i)
  {
    const auto at = [row = i / 16](int prime) { return static_cast<double>(row * prime % 251) / 251.0; };
    points->InsertNextPoint(at(89) + 1e-4 * (i % 16), at(131), at(177));
  }
  grid->SetPoints(points);
  EXPECT_LT(InkImageOfGrid(grid, ValuesOf(grid)).Image->GetNumberOfPoints(), 200000);
}

TEST(ImageOfGrid, ValuesOfUnevenCellsAreThoseOfTheirCenters)
{
  const auto grid = Rectilinear({ 0.0, 0.2, 0.6, 1.0, 2.0 }, Even(0.0, 0.3, 6), Even(-1.0, 0.7, 4));
  const auto centers = Rectilinear({ 0.1, 0.4, 0.8, 1.5 }, Even(0.15, 0.3, 5), Even(-0.65, 0.7, 3));
  const auto image = InkImageOfGrid(grid, ValuesOf(centers)).Image;
  EXPECT_NEAR(image->GetOrigin()[0], 0.1, 1e-5);
  double share;
  EXPECT_LT(ErrorOf(image, share), 1e-12);
  EXPECT_EQ(share, 1.0);
}

TEST(ImageOfGrid, ACurvilinearGridHasValuesUpToTheNextVoxelOutside)
{
  const auto grid = Shell();
  const auto image = InkImageOfGrid(grid, ValuesOf(grid)).Image;
  vtkDataArray* values = image->GetPointData()->GetScalars();
  const double voxel = *std::max_element(image->GetSpacing(), image->GetSpacing() + 3);
  // Faces are flat between points that are up to .26 apart on the outside.
  constexpr double sag = 0.04;
  int inside = 0;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double* p = image->GetPoint(i);
    const double r = std::hypot(p[0], p[1], p[2]);
    const double beyond = std::max({ 1.0 - r, r - 2.0, -p[1] });
    const double value = values->GetComponent(i, 0);
    if (beyond < -sag)
    {
      ++inside;
      EXPECT_NEAR(value, Linear(p), 1e-9);
    }
    else if (beyond > sag + std::sqrt(3.0) * voxel)
    {
      EXPECT_TRUE(std::isnan(value));
    }
    else
    {
      EXPECT_FALSE(beyond < voxel / 2.0 && std::abs(value - Linear(p)) > 3.0 * voxel) << value;
    }
  }
  EXPECT_GT(inside, 10000);
}

TEST(ImageOfGrid, AStructuredGridOfEvenPointsIsAnImage)
{
  auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
  grid->SetDimensions(5, 4, 3);
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 60; ++i)
  {
    points->InsertNextPoint(1.0 + 0.5 * (i % 5), i / 5 % 4, 3.0 + 0.1 * (i / 20));
  }
  grid->SetPoints(points);
  const auto values = ValuesOf(grid);
  const auto image = InkImageOfGrid(grid, values).Image;
  EXPECT_EQ(image->GetPointData()->GetScalars(), values);
  double share;
  EXPECT_LT(ErrorOf(image, share), 1e-6);
}

TEST(ImageOfGrid, ValuesOfAStructuredGridsCellsAreThoseOfTheirCenters)
{
  auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
  grid->SetDimensions(6, 5, 4);
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> values;
  for (int k = 0; k < 4; ++k)
  {
    for (int j = 0; j < 5; ++j)
    {
      for (int i = 0; i < 6; ++i)
      {
        points->InsertNextPoint(i + 0.3 * j, j, k + 0.2 * i);
        const double center[3] = { i + 0.5 + 0.3 * (j + 0.5), j + 0.5, k + 0.5 + 0.2 * (i + 0.5) };
        if (i < 5 && j < 4 && k < 3)
        {
          values->InsertNextValue(static_cast<float>(Linear(center)));
        }
      }
    }
  }
  grid->SetPoints(points);
  const auto image = InkImageOfGrid(grid, values).Image;
  EXPECT_EQ(image->GetScalarType(), VTK_FLOAT);
  vtkDataArray* sampled = image->GetPointData()->GetScalars();
  int inside = 0;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    // Where it is among the cells.
    const double* p = image->GetPoint(i);
    const double x = p[0] - 0.3 * p[1] - 0.5;
    const double z = p[2] - 0.2 * (x + 0.5) - 0.5;
    if (x > 0.01 && x < 3.99 && p[1] > 0.51 && p[1] < 3.49 && z > 0.01 && z < 1.99)
    {
      ++inside;
      EXPECT_NEAR(sampled->GetComponent(i, 0), Linear(p), 1e-5);
    }
  }
  EXPECT_GT(inside, 100);
}

TEST(ImageOfGrid, HiddenPointsAndCellsHaveNoValue)
{
  const auto structured = []
  {
    auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
    grid->SetDimensions(7, 7, 7);
    vtkNew<vtkPoints> points;
    for (int i = 0; i < 7 * 7 * 7; ++i)
    {
      // Voxels are within cells.
      points->InsertNextPoint(
        i % 7 + 0.25 * (i / 49), i / 7 % 7 + 0.3 * (i % 7), 1.2 * (i / 49) + 0.3 * (i % 7));
    }
    grid->SetPoints(points);
    return grid;
  };
  const auto point = structured();
  point->BlankPoint(3 + 3 * 7 + 3 * 49);
  const auto cell = structured();
  cell->BlankCell(3 + 3 * 6 + 3 * 36);
  for (const auto& grid : { point, cell })
  {
    const auto image = InkImageOfGrid(grid, ValuesOf(grid)).Image;
    double all;
    double left;
    ErrorOf(InkImageOfGrid(structured(), ValuesOf(grid)).Image, all);
    ErrorOf(image, left);
    const double* spacing = image->GetSpacing();
    const double hidden =
      (all - left) * static_cast<double>(image->GetNumberOfPoints()) * spacing[0] * spacing[1] * spacing[2];
    // The steps' determinant; a point is a corner of eight cells.
    const double expected = 1.125 * (grid == point ? 8.0 : 1.0);
    EXPECT_NEAR(hidden, expected, 0.2 * expected) << (grid == point ? "point" : "cell");
  }
}

TEST(ImageOfGrid, TakesNoMoreVoxelsThanHelp)
{
  // One step in ten thousandth of the others'.
  Coordinates fine{ 0.0 };
  for (int i = 0; i < 40; ++i)
  {
    fine.push_back(fine.back() + (i % 2 == 0 ? 1e-4 : 1.0));
  }
  const auto grid = Rectilinear(fine, fine, fine);
  EXPECT_LE(InkImageOfGrid(grid, ValuesOf(grid)).Image->GetNumberOfPoints(), 1 << 21);
}

TEST(ImageOfGrid, RefusesWhatIsNoVolume)
{
  const double nan = std::nan("");
  ExpectRefused(Rectilinear(Even(0.0, 1.0, 5), Even(0.0, 1.0, 5), { 0.0 }), { "5 x 5 x 1", "2 or more" });
  ExpectRefused(
    Rectilinear({ 0.0, 1.0, 0.5 }, Even(0.0, 1.0, 5), Even(0.0, 1.0, 5)), { "along x", "1 to 0.5" });
  ExpectRefused(
    Rectilinear(Even(0.0, 1.0, 5), { 0.0, 0.0, 1.0 }, Even(0.0, 1.0, 5)), { "along y", "0 to 0" });
  ExpectRefused(Rectilinear(Even(0.0, 1.0, 5), Even(0.0, 1.0, 5), { 0.0, nan, 1.0 }), { "along z", "nan" });
  auto flat = Shell();
  for (vtkIdType i = 0; i < flat->GetNumberOfPoints(); ++i)
  {
    flat->GetPoints()->SetPoint(i, flat->GetPoint(i)[0], flat->GetPoint(i)[1], 4.0);
  }
  flat->Modified();
  ExpectRefused(flat, { "4 to 4 along z", "volume" });
  auto broken = Shell();
  broken->GetPoints()->SetPoint(17, 0.0, nan, 0.0);
  ExpectRefused(broken, { "point 17", "nan" });
  const auto grid = Rectilinear(Even(0.0, 1.0, 5), Even(0.0, 1.0, 5), Even(0.0, 1.0, 5));
  vtkNew<vtkDoubleArray> few;
  few->SetNumberOfValues(3);
  EXPECT_THROW(InkImageOfGrid(grid, few), std::invalid_argument);
}
