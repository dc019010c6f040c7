// SPDX-License-Identifier: BSD-3-Clause
// What vtkInkSurfaceSampler puts out: how many points, where, with which arrays, for each kind of face.

#include "SamplerTestMeshes.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInkSurfaceSampler.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>
#include <vector>

namespace
{

vtkSmartPointer<vtkPolyData> Sample(
  vtkPolyData* mesh, vtkIdType count, const std::function<void(vtkInkSurfaceSampler*)>& change = {})
{
  vtkNew<vtkInkSurfaceSampler> sampler;
  sampler->SetInputData(mesh);
  sampler->SetNumberOfSamples(count);
  if (change)
  {
    change(sampler);
  }
  sampler->Update();
  return sampler->GetOutput();
}

/// Triangles of a mesh, with their global ids.
vtkSmartPointer<vtkPolyData> CutOut(vtkPolyData* mesh, const std::function<bool(vtkIdType)>& isIn)
{
  vtkNew<vtkCellArray> polys;
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("Ids");
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    if (isIn(i))
    {
      polys->InsertNextCell(mesh->GetCell(i));
      ids->InsertNextValue(1000 + i);
    }
  }
  auto piece = vtkSmartPointer<vtkPolyData>::New();
  piece->SetPoints(mesh->GetPoints());
  piece->SetPolys(polys);
  piece->GetCellData()->SetGlobalIds(ids);
  return piece;
}

} // namespace

TEST(SurfaceSampler, ArraysDescribeEachSample)
{
  const auto ball = MakeBall(40, 2.0);
  for (const int method : { vtkInkSurfaceSampler::WHITE_NOISE, vtkInkSurfaceSampler::BLUE_NOISE,
         vtkInkSurfaceSampler::PROGRESSIVE_BLUE_NOISE })
  {
    const auto points = Sample(ball, 3000,
      [&](vtkInkSurfaceSampler* sampler)
      {
        sampler->SetMethod(method);
        sampler->KeepFacesOn();
      });
    EXPECT_EQ(points->GetNumberOfPoints(), 3000) << "3000 points";
    EXPECT_TRUE(points->GetNumberOfVerts() == 1 && points->GetCellType(0) == VTK_POLY_VERTEX)
      << "one poly-vertex";
    EXPECT_TRUE(IsFinite(points)) << "finite numbers";
    for (int i = 0; i < points->GetPointData()->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = points->GetPointData()->GetArray(i);
      const auto kibibytes =
        static_cast<unsigned long>(array->GetNumberOfValues() * array->GetDataTypeSize() / 1024);
      EXPECT_LE(array->GetActualMemorySize(), kibibytes + 1)
        << array->GetName() << " has memory for its values only: " << array->GetActualMemorySize() << " KiB";
    }
    vtkPointData* data = points->GetPointData();
    vtkDataArray* normals = data->GetNormals();
    vtkDataArray* radius = data->GetArray("Radius");
    vtkDataArray* priority = data->GetArray("Priority");
    ASSERT_TRUE(normals && radius && priority && data->GetArray("FaceId") && data->GetArray("FacePoints") &&
      data->GetArray("BarycentricCoordinates"))
      << "all arrays";
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      double p[3];
      double n[3];
      points->GetPoint(i, p);
      normals->GetTuple(i, n);
      const double length = std::hypot(p[0], p[1], p[2]);
      const double along = (p[0] * n[0] + p[1] * n[1] + p[2] * n[2]) / length;
      ASSERT_TRUE(std::abs(length - 2.0) < 0.01 && along > 0.998 && priority->GetComponent(i, 0) >= 0.0 &&
        priority->GetComponent(i, 0) < 1.0 &&
        (i == 0 || priority->GetComponent(i, 0) > priority->GetComponent(i - 1, 0)))
        << "point " << i << " on the ball with its normal outwards and its priority";
      const auto face = static_cast<vtkIdType>(data->GetArray("FaceId")->GetComponent(i, 0));
      vtkIdType size = 0;
      const vtkIdType* corners = nullptr;
      ball->GetPolys()->GetCellAtId(face, size, corners);
      double expected[3] = { 0, 0, 0 };
      for (int corner = 0; corner < 3; ++corner)
      {
        const double weight = data->GetArray("BarycentricCoordinates")->GetComponent(i, corner);
        double at[3];
        ball->GetPoint(corners[corner], at);
        EXPECT_TRUE(weight >= 0.0 && data->GetArray("FacePoints")->GetComponent(i, corner) == corners[corner])
          << "corner " << corner << " of point " << i;
        for (int axis = 0; axis < 3; ++axis)
        {
          expected[axis] += weight * at[axis];
        }
      }
      EXPECT_LT(std::hypot(expected[0] - p[0], expected[1] - p[1], expected[2] - p[2]), 1e-5)
        << "point " << i << " at its barycentric position";
    }
    // A length, not an area: a ball ten times as large has ten times the radius.
    const auto larger =
      Sample(MakeBall(40, 20.0), 3000, [&](vtkInkSurfaceSampler* sampler) { sampler->SetMethod(method); });
    const double ratio =
      larger->GetPointData()->GetArray("Radius")->GetComponent(0, 0) / radius->GetComponent(0, 0);
    EXPECT_LT(std::abs(ratio - 10.0), 1e-3) << "ten times the radius, found " << ratio;
  }
  const auto bare = Sample(ball, 100,
    [](vtkInkSurfaceSampler* sampler)
    {
      sampler->ComputeNormalsOff();
      sampler->ComputeRadiusOff();
      sampler->ComputePriorityOff();
      sampler->GenerateVerticesOff();
    });
  EXPECT_TRUE(bare->GetNumberOfPoints() == 100 && bare->GetPointData()->GetNumberOfArrays() == 0 &&
    bare->GetNumberOfCells() == 0)
    << "points and nothing else";
}

TEST(SurfaceSampler, NoTwoSamplesAreNearerThanTheRadius)
{
  const auto square = MakeSquare(10);
  const auto byRadius = [](vtkInkSurfaceSampler* sampler)
  {
    sampler->SetAmountToSampleRadius();
    sampler->SetSampleRadius(0.03);
  };
  const auto points = Sample(square, 1, byRadius);
  const vtkIdType count = points->GetNumberOfPoints();
  EXPECT_GT(LeastDistance(points, count), 0.03 * (1.0 - 1e-4)) << "no two points nearer than the radius";
  EXPECT_GT(0.03 / HexagonalDistance(1.0, count), 0.75) << "as many as fit, found " << count;
  const double cover = points->GetPointData()->GetArray("Radius")->GetComponent(0, 0);
  EXPECT_TRUE(cover > 0.03 && cover < 0.035) << "discs a little larger than the radius: " << cover;
}

/// Prefixes of the output are blue noise.
TEST(SurfaceSampler, PrefixesAreBlueNoise)
{
  for (const auto& [method, least] : { std::pair(vtkInkSurfaceSampler::BLUE_NOISE, 0.53),
         std::pair(vtkInkSurfaceSampler::PROGRESSIVE_BLUE_NOISE, 0.62) })
  {
    const auto points =
      Sample(MakeSquare(20), 6000, [&](vtkInkSurfaceSampler* sampler) { sampler->SetMethod(method); });
    for (const double share : { 0.05, 0.25, 0.5, 1.0 })
    {
      const auto count = static_cast<vtkIdType>(share * 6000);
      const double ratio = LeastDistance(points, count) / HexagonalDistance(1.0, count);
      EXPECT_GT(ratio, least) << "method " << method << ": distance of the first " << count
                              << " points against a hexagonal lattice's";
    }
  }
}

/// Blue noise below half a million samples and of a radius, from there on white noise.
TEST(SurfaceSampler, AutomaticIsBlueNoiseBelowHalfAMillion)
{
  const auto square = MakeSquare(4);
  const auto sample = [&](int method, vtkIdType count)
  {
    return Sample(square, count,
      [&](vtkInkSurfaceSampler* sampler)
      {
        sampler->SetMethod(method);
        sampler->ComputePriorityOff();
        sampler->SetSampleRadius(0.05);
        sampler->SetAmount(
          count == 0 ? vtkInkSurfaceSampler::SAMPLE_RADIUS : vtkInkSurfaceSampler::NUMBER_OF_SAMPLES);
      });
  };
  const std::pair<vtkIdType, int> expected[] = { { 0, vtkInkSurfaceSampler::BLUE_NOISE },
    { 2000, vtkInkSurfaceSampler::BLUE_NOISE }, { 500'000, vtkInkSurfaceSampler::WHITE_NOISE } };
  for (const auto& [count, method] : expected)
  {
    const auto points = sample(vtkInkSurfaceSampler::AUTOMATIC, count);
    const auto same = sample(method, count);
    const vtkIdType found = points->GetNumberOfPoints();
    bool equal = found > 0 && found == same->GetNumberOfPoints();
    for (vtkIdType i = 0; equal && i < found; i += 97)
    {
      double a[3];
      double b[3];
      points->GetPoint(i, a);
      same->GetPoint(i, b);
      equal = a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
    }
    EXPECT_TRUE(equal) << found << " points as by method " << method;
  }
}

/// As many as a radius has, about as far from each other.
TEST(SurfaceSampler, ProgressiveSamplesAreARadiusApart)
{
  const auto points = Sample(MakeSquare(10), 1,
    [](vtkInkSurfaceSampler* sampler)
    {
      sampler->SetMethodToProgressiveBlueNoise();
      sampler->SetAmountToSampleRadius();
      sampler->SetSampleRadius(0.02);
    });
  const double ratio = LeastDistance(points, points->GetNumberOfPoints()) / 0.02;
  EXPECT_TRUE(ratio > 0.93 && ratio < 1.07) << "the radius within one step, found " << ratio << " of it";
}

/// Triangles, quads, polygons and strips of the same square; with vertices and lines before them.
TEST(SurfaceSampler, SamplesPolygonsAndStripsByArea)
{
  auto mixed = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 8; ++i)
  {
    points->InsertNextPoint(i / 2, i % 2, 0.0);
  }
  // An L of three unit squares beside the strip, as one polygon that is not convex.
  const double corners[6][2] = { { 4, 0 }, { 6, 0 }, { 6, 1 }, { 5, 1 }, { 5, 2 }, { 4, 2 } };
  for (const auto& corner : corners)
  {
    points->InsertNextPoint(corner[0], corner[1], 0.0);
  }
  mixed->SetPoints(points);
  vtkNew<vtkCellArray> verts;
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkCellArray> polys;
  vtkNew<vtkCellArray> strips;
  verts->InsertNextCell({ 0 });
  verts->InsertNextCell({ 1 });
  lines->InsertNextCell({ 0, 1, 2 });
  polys->InsertNextCell({ 0, 2, 3, 1 });
  polys->InsertNextCell({ 8, 9, 10, 11, 12, 13 });
  strips->InsertNextCell({ 2, 3, 4, 5, 6, 7 });
  mixed->SetVerts(verts);
  mixed->SetLines(lines);
  mixed->SetPolys(polys);
  mixed->SetStrips(strips);
  const auto samples = Sample(mixed, 6000,
    [](vtkInkSurfaceSampler* sampler)
    {
      sampler->SetMethodToWhiteNoise();
      sampler->ComputePriorityOff();
      sampler->KeepFacesOn();
    });
  int perFace[6] = {};
  for (vtkIdType i = 0; i < samples->GetNumberOfPoints(); ++i)
  {
    double p[3];
    samples->GetPoint(i, p);
    const auto face = static_cast<int>(samples->GetPointData()->GetArray("FaceId")->GetComponent(i, 0));
    ASSERT_TRUE(face >= 3 && face < 6) << "a face, found " << face;
    ++perFace[face];
    const bool inside = face == 3 ? p[0] <= 1.0
      : face == 5                 ? p[0] >= 1.0 && p[0] <= 3.0
                                  : p[0] >= 4.0 && (p[0] <= 5.0 || p[1] <= 1.0);
    EXPECT_TRUE(inside) << "sample " << i << " inside face " << face;
  }
  // Areas 1, 3 and 2: 1000, 3000 and 2000 samples, give or take four deviations.
  EXPECT_TRUE(std::abs(perFace[3] - 1000) < 120 && std::abs(perFace[4] - 3000) < 160 &&
    std::abs(perFace[5] - 2000) < 150)
    << "samples by area: " << perFace[3] << ", " << perFace[4] << ", " << perFace[5];

  const auto quads = Sample(MakeSquare(30, 1.0, false), 2000);
  EXPECT_GT(LeastDistance(quads, 2000) / HexagonalDistance(1.0, 2000), 0.72) << "blue noise on quads";
}

TEST(SurfaceSampler, FollowsADensity)
{
  for (const bool ofCells : { false, true })
  {
    const auto square = MakeSquare(20);
    vtkNew<vtkFloatArray> density;
    density->SetName("Density");
    density->SetNumberOfValues(ofCells ? square->GetNumberOfCells() : square->GetNumberOfPoints());
    for (vtkIdType i = 0; i < density->GetNumberOfValues(); ++i)
    {
      double p[3];
      square->GetPoint(ofCells ? square->GetCell(i)->GetPointId(0) : i, p);
      density->SetValue(i, p[0] < 0.49 ? 1.0f : 4.0f);
    }
    (ofCells ? static_cast<vtkDataSetAttributes*>(square->GetCellData()) : square->GetPointData())
      ->AddArray(density);
    const auto points = Sample(square, 2000,
      [&](vtkInkSurfaceSampler* sampler)
      {
        sampler->SetInputArrayToProcess(0, 0, 0,
          ofCells ? vtkDataObject::FIELD_ASSOCIATION_CELLS : vtkDataObject::FIELD_ASSOCIATION_POINTS,
          "Density");
      });
    int right = 0;
    double radius[2] = {};
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      const bool isRight = points->GetPoint(i)[0] > 0.5;
      right += isRight ? 1 : 0;
      // In between, the density of points goes from one to the other.
      if (std::abs(points->GetPoint(i)[0] - 0.5) > 0.1)
      {
        radius[isRight] = points->GetPointData()->GetArray("Radius")->GetComponent(i, 0);
      }
    }
    EXPECT_EQ(points->GetNumberOfPoints(), 2000) << "2000 points";
    EXPECT_LT(std::abs(right - 1600), 80) << "four times as many on the right: " << right;
    EXPECT_LT(std::abs(radius[0] / radius[1] - 2.0), 0.01) << "discs of half the radius";
  }
}

/// Ghost cells are another piece's.
TEST(SurfaceSampler, LeavesGhostCellsOut)
{
  const auto square = MakeSquare(10);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfValues(square->GetNumberOfCells());
  for (vtkIdType i = 0; i < ghosts->GetNumberOfValues(); ++i)
  {
    ghosts->SetValue(i, i < 100 ? vtkDataSetAttributes::DUPLICATECELL : 0);
  }
  square->GetCellData()->AddArray(ghosts);
  const auto points = Sample(square, 500);
  bool outside = points->GetNumberOfPoints() == 500;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    outside = outside && points->GetPoint(i)[1] >= 0.5 - 1e-6;
  }
  EXPECT_TRUE(outside) << "samples outside ghost cells only";
  ghosts->Fill(vtkDataSetAttributes::DUPLICATECELL);
  ghosts->Modified();
  EXPECT_EQ(Sample(square, 500)->GetNumberOfPoints(), 0) << "none on ghosts alone";
}

/// Pieces of a mesh with global ids have the whole's white noise, however it is cut and whatever order its
/// cells are in.
TEST(SurfaceSampler, PiecesHaveTheSamplesOfTheWhole)
{
  const auto ball = MakeBall(30, 1.0);
  const auto sample = [](vtkPolyData* mesh)
  {
    const auto points = Sample(mesh, 1,
      [](vtkInkSurfaceSampler* sampler)
      {
        sampler->SetMethodToWhiteNoise();
        sampler->SetAmountToSampleRadius();
        sampler->SetSampleRadius(0.04);
        sampler->SetSeed(3);
      });
    std::vector<std::array<double, 3>> positions(static_cast<std::size_t>(points->GetNumberOfPoints()));
    for (std::size_t i = 0; i < positions.size(); ++i)
    {
      points->GetPoint(static_cast<vtkIdType>(i), positions[i].data());
    }
    std::sort(positions.begin(), positions.end());
    return positions;
  };
  const auto whole = sample(CutOut(ball, [](vtkIdType) { return true; }));
  const double expected = 0.697 * 4.0 * std::acos(-1.0) / (0.04 * 0.04);
  EXPECT_LT(std::abs(static_cast<double>(whole.size()) / expected - 1.0), 0.03)
    << "as many as blue noise has, found " << whole.size();
  for (const int pieces : { 2, 5 })
  {
    std::vector<std::array<double, 3>> together;
    for (int piece = 0; piece < pieces; ++piece)
    {
      const auto part = sample(CutOut(ball, [&](vtkIdType i) { return i / 7 % pieces == piece; }));
      together.insert(together.end(), part.begin(), part.end());
    }
    std::sort(together.begin(), together.end());
    EXPECT_EQ(together, whole) << pieces << " pieces have the whole's samples";
  }
}

TEST(SurfaceSampler, IsTheSameOnOneThreadAndOnTwo)
{
  const auto ball = MakeBall(30, 1.0);
  vtkSmartPointer<vtkPolyData> outputs[2];
  for (int i = 0; i < 2; ++i)
  {
    setenv("VTK_SMP_MAX_THREADS", i == 0 ? "1" : "2", 1);
    outputs[i] = Sample(ball, 5000, [](vtkInkSurfaceSampler* sampler) { sampler->KeepFacesOn(); });
  }
  unsetenv("VTK_SMP_MAX_THREADS");
  EXPECT_TRUE(AreEqual(outputs[0], outputs[1])) << "the same on one and two threads";
  const auto other = Sample(ball, 5000, [](vtkInkSurfaceSampler* sampler) { sampler->SetSeed(1); });
  EXPECT_TRUE(LeastDistance(other, 5000) > 0.0 && other->GetPoint(0)[0] != outputs[0]->GetPoint(0)[0])
    << "another seed";
}
