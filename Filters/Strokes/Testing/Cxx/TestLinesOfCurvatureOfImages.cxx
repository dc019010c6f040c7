// SPDX-License-Identifier: BSD-3-Clause
// Lines of curvature on the iso-surface of an image, without a mesh.

#include "HashNoise.h"
#include "InkTestMessages.h"
#include "InkTestVolume.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInkLinesOfCurvature.h"
#include "vtkNew.h"
#include "vtkPlanes.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <numbers>
#include <string>
#include <vector>

namespace
{

constexpr double Radius = 2.0;
constexpr double Tube = 0.7;

/// Distances from a torus, denser inside, from 100 on its surface, with noise.
vtkSmartPointer<vtkImageData> Torus(double noise)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(61, 61, 33);
  image->SetOrigin(-3.0, -3.0, -1.6);
  image->SetSpacing(0.1, 0.1, 0.1);
  std::uint64_t index = 0;
  InkTestFill(image, VTK_FLOAT,
    [&](double x, double y, double z)
    {
      return 100.0 + Tube - std::hypot(std::hypot(x, y) - Radius, z) +
        noise * ink::testing::hashNormal(1, index++);
    });
  return image;
}

/// How far lines of a family turn around the axis, or around the tube, from their first points, on average.
double MeanTurn(vtkPolyData* lines, int family, bool aroundAxis)
{
  const auto angle = [&](vtkIdType point)
  {
    double p[3];
    lines->GetPoint(point, p);
    return aroundAxis ? std::atan2(p[1], p[0]) : std::atan2(p[2], std::hypot(p[0], p[1]) - Radius);
  };
  double sum = 0.0;
  double count = 0.0;
  for (vtkIdType line = 0; line < lines->GetNumberOfLines(); ++line)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    lines->GetLines()->GetCellAtId(line, size, ids);
    for (vtkIdType i = 0; i < size && lines->GetCellData()->GetArray("LineFamily")->GetTuple1(line) == family;
         ++i)
    {
      sum += std::abs(std::remainder(angle(ids[i]) - angle(ids[0]), 2.0 * std::numbers::pi));
      count += 1.0;
    }
  }
  return sum / count;
}

} // namespace

TEST(LinesOfCurvatureOfImages, AreTheCirclesOfATorus)
{
  vtkNew<vtkInkLinesOfCurvature> filter;
  vtkNew<InkTestMessages> messages;
  messages->Observe(filter);
  filter->SetInputData(Torus(0.0));
  filter->SetIsoValue(100.0);
  filter->SetFamiliesToBoth();
  filter->SetSpacing(0.2);
  filter->ComputeCurvaturesOn();
  filter->Update();
  messages->Expect("torus", {});
  vtkPolyData* lines = filter->GetOutput();
  ASSERT_GT(lines->GetNumberOfLines(), 50);
  EXPECT_LT(MeanTurn(lines, 0, true), 0.01);
  EXPECT_LT(MeanTurn(lines, 1, false), 0.05);
  vtkPointData* arrays = lines->GetPointData();
  double squares = 0.0;
  for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
  {
    double p[3];
    lines->GetPoint(i, p);
    const double out = std::hypot(p[0], p[1]) - Radius;
    ASSERT_NEAR(std::hypot(out, p[2]), Tube, 0.01);
    ASSERT_GT(arrays->GetNormals()->GetComponent(i, 2) * p[2] / Tube +
        (arrays->GetNormals()->GetComponent(i, 0) * p[0] + arrays->GetNormals()->GetComponent(i, 1) * p[1]) *
          out / (Tube * std::hypot(p[0], p[1])),
      0.98);
    const double error = arrays->GetArray("k1")->GetTuple1(i) - 1.0 / Tube;
    squares += error * error / static_cast<double>(lines->GetNumberOfPoints());
  }
  EXPECT_LT(std::sqrt(squares), 0.15 / Tube); // the tube is rounded by a smoothing of 0.3 of its radius
  // All of both families, each line before those that are closer to each other.
  vtkDataArray* priority = lines->GetCellData()->GetArray("Priority");
  EXPECT_EQ(priority->GetRange()[0], 0.0);
  EXPECT_LT(priority->GetRange()[1], 1.0);
}

TEST(LinesOfCurvatureOfImages, OfARegion)
{
  vtkNew<vtkInkLinesOfCurvature> filter;
  filter->SetInputData(Torus(0.0));
  filter->SetIsoValue(100.0);
  filter->SetSpacing(0.2);
  filter->Update();
  const auto all = static_cast<double>(filter->GetOutput()->GetNumberOfLines());
  vtkNew<vtkPlanes> region;
  region->SetBounds(0.0, 9.0, -9.0, 9.0, -9.0, 9.0);
  filter->SetRegion(region);
  filter->Update();
  vtkPolyData* lines = filter->GetOutput();
  EXPECT_NEAR(static_cast<double>(lines->GetNumberOfLines()), 0.5 * all, 0.1 * all);
  double bounds[6];
  lines->GetBounds(bounds);
  EXPECT_GE(bounds[0], 0.0);
  EXPECT_NEAR(bounds[1], Radius + Tube, 0.02);
}

TEST(LinesOfCurvatureOfImages, FarAwayAndOfUnequalSpacing)
{
  constexpr double origin = 1e7;
  vtkNew<vtkImageData> image;
  image->SetDimensions(61, 121, 17);
  image->SetOrigin(origin - 3.0, origin - 3.0, origin - 1.6);
  image->SetSpacing(0.1, 0.05, 0.2);
  InkTestFill(image, VTK_FLOAT,
    [&](double x, double y, double z)
    { return Tube - std::hypot(std::hypot(x - origin, y - origin) - Radius, z - origin); });
  vtkNew<vtkInkLinesOfCurvature> filter;
  vtkNew<InkTestMessages> messages;
  messages->Observe(filter);
  filter->SetInputData(image);
  filter->SetSpacing(0.2);
  filter->Update();
  messages->Expect("far away", {});
  vtkNew<vtkPolyData> lines;
  lines->DeepCopy(filter->GetOutput());
  ASSERT_GT(lines->GetNumberOfLines(), 50);
  ASSERT_EQ(lines->GetPoints()->GetDataType(), VTK_DOUBLE);
  for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
  {
    double p[3];
    lines->GetPoint(i, p);
    for (double& c : p)
    {
      c -= origin;
    }
    lines->GetPoints()->SetPoint(i, p);
    ASSERT_NEAR(std::hypot(std::hypot(p[0], p[1]) - Radius, p[2]), Tube, 0.02);
  }
  EXPECT_LT(MeanTurn(lines, 0, true), 0.02);
}

TEST(LinesOfCurvatureOfImages, SmoothingRemovesNoise)
{
  vtkNew<vtkInkLinesOfCurvature> filter;
  EXPECT_EQ(filter->GetFieldSmoothing(), 2.0);
  // Beside an array that is active.
  const vtkSmartPointer<vtkImageData> image = Torus(0.01);
  vtkNew<vtkFloatArray> other;
  other->SetName("Other");
  other->SetNumberOfTuples(image->GetNumberOfPoints());
  other->Fill(0.0);
  image->GetPointData()->AddArray(other);
  image->GetPointData()->SetActiveScalars("Other");
  filter->SetInputData(image);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Density");
  filter->SetIsoValue(100.0);
  filter->SetSpacing(0.3);
  filter->Update();
  const double smooth = MeanTurn(filter->GetOutput(), 0, true);
  filter->SetFieldSmoothing(0.0);
  filter->Update();
  EXPECT_LT(smooth, 0.1);
  EXPECT_GT(MeanTurn(filter->GetOutput(), 0, true), 2.0 * smooth);
}

TEST(LinesOfCurvatureOfImages, TheSameForAnyNumberOfThreads)
{
  const vtkSmartPointer<vtkImageData> image = Torus(0.002);
  const auto run = [&](const char* threads)
  {
    setenv("VTK_SMP_MAX_THREADS", threads, 1);
    vtkNew<vtkInkLinesOfCurvature> filter;
    filter->SetInputData(image);
    filter->SetIsoValue(100.0);
    filter->SetSpacing(0.3);
    filter->Update();
    unsetenv("VTK_SMP_MAX_THREADS");
    vtkSmartPointer<vtkPolyData> lines = filter->GetOutput();
    return lines;
  };
  const auto one = run("1");
  const auto two = run("2");
  ASSERT_EQ(one->GetNumberOfPoints(), two->GetNumberOfPoints());
  for (vtkIdType i = 0; i < one->GetNumberOfPoints(); ++i)
  {
    double a[3];
    double b[3];
    one->GetPoint(i, a);
    two->GetPoint(i, b);
    ASSERT_TRUE(std::equal(a, a + 3, b)) << i;
  }
}

TEST(LinesOfCurvatureOfImages, WhatIsWrongIsSaidOnce)
{
  vtkNew<vtkInkLinesOfCurvature> filter;
  vtkNew<InkTestMessages> messages;
  messages->Observe(filter);
  const auto expect = [&](vtkImageData* image, double isoValue, const std::vector<std::string>& words)
  {
    messages->Messages.clear();
    filter->SetInputData(image);
    filter->SetIsoValue(isoValue);
    filter->Update();
    messages->Expect(words.front(), words);
    EXPECT_EQ(filter->GetOutput()->GetNumberOfLines(), 0);
  };
  expect(Torus(0.0), 1e6, { "iso-surface at 1e+06", "no lines" });
  vtkNew<vtkImageData> corner;
  corner->SetDimensions(2, 2, 2);
  InkTestFill(corner, VTK_FLOAT, [](double x, double y, double z) { return x * y * z; });
  expect(corner, 0.5, { "iso-surface at 0.5", "no lines" });
  vtkNew<vtkImageData> slice;
  slice->SetDimensions(5, 5, 1);
  InkTestFill(slice, VTK_FLOAT, [](double x, double, double) { return x; });
  expect(slice, 1.5, { "5 x 5 x 1", "at least 2" });
  vtkNew<vtkImageData> bare;
  bare->SetDimensions(5, 5, 5);
  expect(bare, 1.5, { "scalars" });
  // Only the first piece has lines of images.
  messages->Messages.clear();
  filter->SetInputData(Torus(0.0));
  filter->SetIsoValue(100.0);
  filter->UpdatePiece(1, 2, 0);
  messages->Expect("second piece", {});
  EXPECT_EQ(filter->GetOutput()->GetNumberOfLines(), 0);
  filter->UpdatePiece(0, 2, 0);
  EXPECT_GT(filter->GetOutput()->GetNumberOfLines(), 0);
}
