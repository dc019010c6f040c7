// SPDX-License-Identifier: BSD-3-Clause
// The stipples of meshes: as many as the area asks for, however the surface is cut into polygons.

#include "SamplerTestImages.h"
#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkInkIsoSurfaceSampler.h"
#include "vtkInkStippleGenerator.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace
{

double Field(vtkPolyData* data, const char* name)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  return array && array->GetNumberOfTuples() == 1 ? array->GetComponent(0, 0) : -1.0;
}

/// Lists in priority order, all points in order, arrays of one tuple an element.
void CheckContract(vtkPolyData* data)
{
  vtkDataArray* priority = data->GetPointData()->GetArray("Priority");
  vtkDataArray* normals = data->GetCellData()->GetNormals();
  ASSERT_TRUE(priority && normals) << "the arrays Priority and Normals";
  vtkIdType next = 0;
  for (vtkIdType e = 0; e < data->GetNumberOfCells(); ++e)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    data->GetVerts()->GetCellAtId(e, size, ids);
    double before = -1.0;
    bool ordered = size > 0 && data->GetCellType(e) == (size == 1 ? VTK_VERTEX : VTK_POLY_VERTEX);
    for (vtkIdType i = 0; i < size; ++i)
    {
      ordered = ordered && ids[i] == next++ && priority->GetComponent(ids[i], 0) >= before;
      before = priority->GetComponent(ids[i], 0);
    }
    EXPECT_TRUE(ordered) << "element " << e << " to hold the next points in order of priority";
    EXPECT_LT(std::abs(vtkMath::Norm(normals->GetTuple3(e)) - 1.0), 1e-5) << "a unit normal";
  }
  EXPECT_EQ(next, data->GetNumberOfPoints()) << "all points in lists";
  EXPECT_EQ(Field(data, "ElementKind"), 1.0) << "surface elements";
}

/// A unit square in the plane z = 0, all of it one polygon or n x n.
vtkSmartPointer<vtkPolyData> MakeSquare(int n)
{
  vtkNew<vtkPlaneSource> source;
  source->SetResolution(n, n);
  source->Update();
  return source->GetOutput();
}

vtkSmartPointer<vtkPolyData> Stipple(vtkPolyData* mesh, vtkIdType count, bool colors = false)
{
  vtkNew<vtkInkStippleGenerator> generator;
  generator->SetInputData(mesh);
  generator->SetNumberOfSurfaceStipples(count);
  generator->SetPassScalars(colors);
  generator->Update();
  return generator->GetOutput();
}

/// The least and the mean distance to the nearest other, in units of 1 / (2 sqrt(density)), of the points
/// below a priority in the unit square.
void NearestDistances(vtkPolyData* data, double below, double& least, double& mean)
{
  std::vector<std::array<double, 3>> points;
  for (vtkIdType n = 0; n < data->GetNumberOfPoints(); ++n)
  {
    if (data->GetPointData()->GetArray("Priority")->GetComponent(n, 0) < below)
    {
      points.emplace_back();
      data->GetPoint(n, points.back().data());
    }
  }
  const double unit = 2.0 * std::sqrt(static_cast<double>(points.size()));
  least = 1e9;
  mean = 0.0;
  for (std::size_t a = 0; a < points.size(); ++a)
  {
    double nearest = 1e9;
    for (std::size_t b = 0; b < points.size(); ++b)
    {
      nearest = a == b
        ? nearest
        : std::min(nearest, std::hypot(points[a][0] - points[b][0], points[a][1] - points[b][1]));
    }
    least = std::min(least, nearest * unit);
    mean += nearest * unit / static_cast<double>(points.size());
  }
}

/// Strips of widths 1 to 4, together 10.
vtkSmartPointer<vtkPolyData> MakeStrips()
{
  auto strips = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> polygons;
  vtkNew<vtkFloatArray> colors;
  colors->SetName("Width");
  for (int strip = 0; strip < 4; ++strip)
  {
    const double begin = 0.5 * strip * (strip + 1);
    const double end = begin + strip + 1.0;
    const vtkIdType first = points->InsertNextPoint(begin, 0.0, 0.0);
    points->InsertNextPoint(end, 0.0, 0.0);
    points->InsertNextPoint(end, 5.0, 0.0);
    points->InsertNextPoint(begin, 5.0, 0.0);
    polygons->InsertNextCell({ first, first + 1, first + 2, first + 3 });
    colors->InsertNextValue(static_cast<float>(strip + 1));
  }
  strips->SetPoints(points);
  strips->SetPolys(polygons);
  strips->GetCellData()->SetScalars(colors);
  return strips;
}

} // namespace

/// However cut, the square has the same spacing, whatever share is drawn, across borders too: white noise
/// has a mean of 1 and a least distance near 0.
TEST(StippleGeneratorSurface, HoweverASquareIsCutItHasTheSameSpacing)
{
  for (const int n : { 1, 7, 40 })
  {
    const auto stipples = Stipple(MakeSquare(n), 2000);
    CheckContract(stipples);
    EXPECT_EQ(stipples->GetNumberOfPoints(), 2000) << "2000 stipples";
    const double size = Field(stipples, "ElementSize");
    const double perElement = Field(stipples, "StipplesPerElement");
    EXPECT_LT(std::abs(2000.0 * size * size / perElement - 1.0), 1e-6) << "the stipples' density";
    if (n < 40)
    {
      EXPECT_LT(std::abs(perElement * n * n - 2000.0), 1e-6) << "as many a polygon";
    }
    else
    {
      EXPECT_LT(std::abs(perElement - 8.0), 3.0) << "lists of neighbors, as 1.25 a polygon would be dust";
    }
    for (const double below : { 0.1, 0.5, 1.0 })
    {
      double least = 0.0;
      double mean = 0.0;
      NearestDistances(stipples, below, least, mean);
      EXPECT_TRUE(mean > 1.4 && least > 0.8)
        << n << " x " << n << " polygons, " << below << " of the stipples: distances of " << least
        << " at least and " << mean << " on average";
    }
  }
}

TEST(StippleGeneratorSurface, PolygonsHaveStipplesInProportionToTheirArea)
{
  vtkNew<vtkInkStippleGenerator> generator;
  generator->SetInputData(MakeStrips());
  generator->SetMaximumStipples(50);
  generator->PassScalarsOn();
  generator->SetInputArrayToProcess(1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Width");
  generator->Update();
  vtkPolyData* inStrips = generator->GetOutput();
  CheckContract(inStrips);
  EXPECT_EQ(inStrips->GetNumberOfPoints(), 200) << "50 stipples a polygon";
  vtkDataArray* widths = inStrips->GetCellData()->GetScalars();
  ASSERT_TRUE(widths && inStrips->GetNumberOfCells() == 4) << "four elements with their widths";
  for (vtkIdType e = 0; e < 4; ++e)
  {
    const vtkIdType size = inStrips->GetVerts()->GetCellSize(e);
    const double width = widths->GetComponent(e, 0);
    // The narrow ones have few stipples, and the outer ones more of the mesh's border, where stipples may
    // lie closer.
    EXPECT_LT(std::abs(static_cast<double>(size) / width - 20.0), 3.0 + 3.0 / width)
      << "20 stipples for 1 of width " << width << ", found " << size;
    EXPECT_EQ(inStrips->GetCellData()->GetNormals()->GetTuple3(e)[2], 1.0) << "a normal along z";
  }
}

/// The longest side, 10, measures 300 pixels; a number given wins.
TEST(StippleGeneratorSurface, ProjectedMeshesHaveAStippleAPixel)
{
  vtkNew<vtkInkStippleGenerator> generator;
  generator->SetInputData(MakeStrips());
  generator->SetMaximumStipples(50);
  generator->SetMaximumStipplesModeToProjected();
  generator->SetPictureSize(300.0);
  generator->Update();
  vtkPolyData* inStrips = generator->GetOutput();
  EXPECT_EQ(inStrips->GetNumberOfPoints(), 300 * 150) << "45,000 stipples";
  CheckContract(inStrips);
  for (vtkIdType e = 0; e < inStrips->GetNumberOfCells(); ++e)
  {
    const double pixels = 30.0 * static_cast<double>(e + 1) * 150.0;
    const auto size = static_cast<double>(inStrips->GetVerts()->GetCellSize(e));
    EXPECT_LT(std::abs(size / pixels - 1.0), 0.03)
      << pixels << " stipples by the polygon's area, found " << size;
  }
  generator->SetNumberOfSurfaceStipples(700);
  generator->Update();
  EXPECT_EQ(inStrips->GetNumberOfPoints(), 700) << "the number given";
}

TEST(StippleGeneratorSurface, NormalsPointOutOfASphere)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(2.0);
  sphere->SetThetaResolution(40);
  sphere->SetPhiResolution(30);
  sphere->Update();
  const auto onSphere = Stipple(sphere->GetOutput(), 5000);
  CheckContract(onSphere);
  for (vtkIdType e = 0; e < onSphere->GetNumberOfCells(); ++e)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    onSphere->GetVerts()->GetCellAtId(e, size, ids);
    double point[3];
    double normal[3];
    onSphere->GetPoint(ids[0], point);
    onSphere->GetCellData()->GetNormals()->GetTuple(e, normal);
    EXPECT_GT(vtkMath::Dot(point, normal), 1.97) << "a normal out of the sphere";
  }
}

/// On a plane along slices that are three voxels apart, whose samples stand in rows.
TEST(StippleGeneratorSurface, RowsOfThickSlicesLeaveNoGaps)
{
  const auto image = MakeImage(
    VTK_FLOAT, { 0, 9, 0, 40, 0, 14 }, [](double x, double, double) { return x; }, { 1.0, 1.0, 3.0 });
  vtkNew<vtkInkIsoSurfaceSampler> sampler;
  sampler->SetInputData(image);
  sampler->SetValue(0, 4.5);
  sampler->Update();
  const auto onPlane = Stipple(sampler->GetOutput(), 30000);
  // One in the middle between two rows.
  std::array<double, 11> counts{};
  for (vtkIdType i = 0; i < onPlane->GetNumberOfPoints(); ++i)
  {
    double point[3];
    onPlane->GetPoint(i, point);
    const double along = point[2] / 3.0 - 0.5;
    if (along > 1.0 && along < 12.0)
    {
      ++counts[static_cast<std::size_t>(11.0 * (along - std::floor(along)))];
    }
  }
  const auto [least, most] = std::minmax_element(counts.begin(), counts.end());
  EXPECT_GT(*least, 0.8 * *most);
}

/// Stipples of polygons that are smaller than these share lists, whose normals are theirs.
TEST(StippleGeneratorSurface, SmallPolygonsShareLists)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(2.0);
  sphere->SetThetaResolution(200);
  sphere->SetPhiResolution(100);
  sphere->Update();
  const auto onSphere = Stipple(sphere->GetOutput(), 5000);
  CheckContract(onSphere);
  EXPECT_EQ(onSphere->GetNumberOfPoints(), 5000);
  EXPECT_NEAR(5000.0 / static_cast<double>(onSphere->GetNumberOfCells()), 8.0, 3.0);
  for (vtkIdType e = 0; e < onSphere->GetNumberOfCells(); ++e)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    onSphere->GetVerts()->GetCellAtId(e, size, ids);
    double normal[3];
    onSphere->GetCellData()->GetNormals()->GetTuple(e, normal);
    for (vtkIdType i = 0; i < size; ++i)
    {
      double point[3];
      onSphere->GetPoint(ids[i], point);
      EXPECT_GT(vtkMath::Dot(point, normal), 1.97) << "eight stipples are .13 long";
    }
  }
}

/// Beside small polygons, a large one has the list that it has alone; colors are those of a list's side.
TEST(StippleGeneratorSurface, LargePolygonsKeepTheirLists)
{
  vtkNew<vtkAppendPolyData> both;
  for (const int n : { 1, 40 })
  {
    vtkNew<vtkPlaneSource> plane;
    plane->SetResolution(n, n);
    plane->SetCenter(n == 1 ? -2.0 : 2.0, 0.0, 0.0);
    plane->Update();
    vtkNew<vtkFloatArray> colors;
    colors->SetName("Side");
    colors->SetNumberOfTuples(plane->GetOutput()->GetNumberOfCells());
    colors->FillValue(static_cast<float>(n));
    plane->GetOutput()->GetCellData()->SetScalars(colors);
    both->AddInputData(plane->GetOutput());
  }
  vtkNew<vtkInkStippleGenerator> generator;
  generator->SetInputConnection(both->GetOutputPort());
  generator->SetNumberOfSurfaceStipples(4000);
  generator->PassScalarsOn();
  generator->SetInputArrayToProcess(1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Side");
  generator->Update();
  vtkPolyData* stipples = generator->GetOutput();
  CheckContract(stipples);
  vtkDataArray* sides = stipples->GetCellData()->GetScalars();
  ASSERT_TRUE(sides && stipples->GetNumberOfCells() > 100);
  EXPECT_NEAR(static_cast<double>(stipples->GetVerts()->GetCellSize(0)), 2000.0, 40.0) << "the large one's";
  for (vtkIdType e = 0; e < stipples->GetNumberOfCells(); ++e)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    stipples->GetVerts()->GetCellAtId(e, size, ids);
    EXPECT_TRUE(e == 0 || size < 30) << size;
    for (vtkIdType i = 0; i < size; ++i)
    {
      EXPECT_EQ(sides->GetComponent(e, 0), stipples->GetPoint(ids[i])[0] < 0.0 ? 1.0 : 40.0);
    }
  }
}

/// Longer cells stand for more of the surface, and in other directions for less.
TEST(StippleGeneratorSurface, SamplesOfLongCellsHaveAsManyStipplesAsTheirSurface)
{
  for (const double longest : { 1.0, 3.0 })
  {
    const int half = static_cast<int>(std::ceil(34.0 / longest));
    const auto image = MakeImage(VTK_FLOAT, { -34, 34, -34, 34, -half, half },
      [](double x, double y, double z) { return BallDensity(x, y, z, 30.0); }, { 1.0, 1.0, longest });
    vtkNew<vtkInkIsoSurfaceSampler> sampler;
    sampler->SetInputData(image);
    sampler->SetValue(0, 100.0);
    sampler->Update();
    constexpr double asked = 20000.0;
    const auto stipples = Stipple(sampler->GetOutput(), static_cast<vtkIdType>(asked));
    EXPECT_NEAR(static_cast<double>(stipples->GetNumberOfPoints()), asked, 0.02 * asked) << longest;
    double size = 0.0;
    double area = 0.0;
    for (vtkIdType i = 0; i < stipples->GetNumberOfPoints(); ++i)
    {
      // As even towards the slices as along them.
      double p[3];
      stipples->GetPoint(i, p);
      area += std::abs(p[2]) > 15.0 ? 1.0 : 0.0;
      size = std::max(size, vtkMath::Norm(p));
    }
    EXPECT_NEAR(area / asked, 0.5, 0.015) << longest;
    EXPECT_LT(size, 30.3) << longest;
  }
}
