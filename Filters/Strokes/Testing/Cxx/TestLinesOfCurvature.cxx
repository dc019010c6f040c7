// SPDX-License-Identifier: BSD-3-Clause
// The filter's arrays, its options, and what it says where something is wrong.

#include "InkTestMesh.h"
#include "InkTestMessages.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCylinderSource.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkInkHatching.h"
#include "vtkInkLinesOfCurvature.h"
#include "vtkNew.h"
#include "vtkParametricFunctionSource.h"
#include "vtkParametricTorus.h"
#include "vtkPlaneSource.h"
#include "vtkPlanes.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkReverseSense.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>

namespace
{

constexpr double Radius = 2.0;
constexpr double Tube = 0.7;

vtkSmartPointer<vtkPolyData> Torus()
{
  vtkNew<vtkParametricTorus> torus;
  torus->SetRingRadius(Radius);
  torus->SetCrossSectionRadius(Tube);
  vtkNew<vtkParametricFunctionSource> source;
  source->SetParametricFunction(torus);
  source->SetUResolution(90);
  source->SetVResolution(30);
  source->Update();
  return source->GetOutput();
}

double Coordinate(vtkPolyData* lines, vtkIdType point, bool aroundAxis)
{
  double p[3];
  lines->GetPoint(point, p);
  return aroundAxis ? std::atan2(p[1], p[0]) : std::atan2(p[2], std::hypot(p[0], p[1]) - Radius);
}

double LengthAt(vtkDataArray* vectors, vtkIdType point)
{
  const double* v = vectors->GetTuple3(point);
  return std::hypot(v[0], v[1], v[2]);
}

} // namespace

TEST(LinesOfCurvature, OfATorusWithTheirArrays)
{
  vtkNew<vtkInkLinesOfCurvature> filter;
  filter->SetInputData(Torus());
  filter->SetFamiliesToBoth();
  filter->SetSpacing(0.1);
  filter->ComputeCurvaturesOn();
  filter->Update();
  vtkPolyData* lines = filter->GetOutput();
  ASSERT_GT(lines->GetNumberOfLines(), 150);
  vtkDataArray* priority = lines->GetCellData()->GetArray("Priority");
  vtkDataArray* family = lines->GetCellData()->GetArray("LineFamily");
  vtkDataArray* normals = lines->GetPointData()->GetNormals();
  vtkDataArray* arc = lines->GetPointData()->GetArray("ArcLength");
  vtkDataArray* k1 = lines->GetPointData()->GetArray("k1");
  vtkDataArray* k2 = lines->GetPointData()->GetArray("k2");
  ASSERT_TRUE(priority && family && normals && arc && k1 && k2);
  EXPECT_EQ(priority->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(family->GetDataType(), VTK_UNSIGNED_CHAR);
  EXPECT_EQ(normals->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(lines->GetPoints()->GetDataType(), VTK_FLOAT);
  vtkIdType counts[2] = { 0, 0 };
  vtkIdType closed = 0;
  double largest = 0.0;
  double before = 0.0;
  vtkNew<vtkIdList> points;
  for (vtkIdType line = 0; line < lines->GetNumberOfLines(); ++line)
  {
    lines->GetCellPoints(line, points);
    const bool maximum = family->GetComponent(line, 0) == 0.0;
    before = maximum || counts[1] > 0 ? before : 0.0; // families have priorities of their own
    ++counts[maximum ? 0 : 1];
    EXPECT_GE(priority->GetComponent(line, 0), before);
    EXPECT_LT(priority->GetComponent(line, 0), 1.0);
    before = priority->GetComponent(line, 0);
    const vtkIdType last = points->GetNumberOfIds() - 1;
    closed += points->GetId(0) == points->GetId(last) ? 1 : 0;
    EXPECT_EQ(arc->GetComponent(points->GetId(0), 0), 0.0);
    for (vtkIdType i = 0; i <= last; ++i)
    {
      const vtkIdType point = points->GetId(i);
      // Meridians have a constant angle around the axis, parallels around the tube.
      const double turn =
        std::remainder(Coordinate(lines, point, maximum) - Coordinate(lines, points->GetId(0), maximum),
          2.0 * std::numbers::pi);
      largest = std::max(largest, std::abs(turn) * (maximum ? Radius : Tube));
      EXPECT_NEAR(std::hypot(normals->GetComponent(point, 0), normals->GetComponent(point, 1),
                    normals->GetComponent(point, 2)),
        1.0, 1e-5);
      // Measured: 0.156 at the seam, which rounding opens, so that fits are one-sided; 0.073 elsewhere.
      EXPECT_NEAR(k1->GetComponent(point, 0), 1.0 / Tube, 0.17);
      const double cosine = std::cos(Coordinate(lines, point, false));
      EXPECT_NEAR(k2->GetComponent(point, 0), cosine / (Radius + Tube * cosine), 0.1);
    }
  }
  EXPECT_GT(counts[0], 100);
  EXPECT_GT(counts[1], 30);
  EXPECT_GT(closed, 30);
  EXPECT_LT(largest, 0.1);
}

TEST(LinesOfCurvature, ArraysOfTheInputAreUsed)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(10, 10);
  plane->Update();
  vtkNew<vtkPolyData> mesh;
  mesh->ShallowCopy(plane->GetOutput());
  for (const char* name : { "k1", "k2", "PrincipalDirection1", "PrincipalDirection2" })
  {
    vtkNew<vtkDoubleArray> array;
    const std::string text = name;
    array->SetName(name);
    array->SetNumberOfComponents(text[0] == 'k' ? 1 : 3);
    array->SetNumberOfTuples(mesh->GetNumberOfPoints());
    array->Fill(0.0);
    array->FillComponent(text == "PrincipalDirection2" ? 1 : 0, text == "k2" ? 0.0 : 1.0);
    mesh->GetPointData()->AddArray(array);
  }
  vtkNew<vtkInkLinesOfCurvature> filter;
  filter->SetInputData(mesh);
  for (const bool maximum : { true, false })
  {
    filter->SetFamilies(maximum ? vtkInkLinesOfCurvature::MAXIMUM : vtkInkLinesOfCurvature::MINIMUM);
    filter->SetSpacing(0.05);
    filter->Update();
    vtkPolyData* lines = filter->GetOutput();
    ASSERT_GT(lines->GetNumberOfLines(), 15);
    vtkNew<vtkIdList> points;
    for (vtkIdType line = 0; line < lines->GetNumberOfLines(); ++line)
    {
      lines->GetCellPoints(line, points);
      double first[3];
      double last[3];
      lines->GetPoint(points->GetId(0), first);
      lines->GetPoint(points->GetId(points->GetNumberOfIds() - 1), last);
      EXPECT_NEAR(std::abs(last[maximum ? 0 : 1] - first[maximum ? 0 : 1]), 1.0, 1e-5);
      EXPECT_NEAR(last[maximum ? 1 : 0], first[maximum ? 1 : 0], 1e-5);
    }
  }
}

TEST(LinesOfCurvature, OfSpheresAndPlanesAreSmoothed)
{
  // Nothing but umbilics: smoothed directions still cover the surface with long lines.
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(60);
  sphere->SetPhiResolution(30);
  vtkNew<vtkInkLinesOfCurvature> filter;
  filter->SetInputConnection(sphere->GetOutputPort());
  filter->SetSpacing(0.05);
  const auto length = [&]
  {
    filter->Update();
    double sum = 0.0;
    vtkPolyData* lines = filter->GetOutput();
    vtkNew<vtkIdList> points;
    for (vtkIdType line = 0; line < lines->GetNumberOfLines(); ++line)
    {
      lines->GetCellPoints(line, points);
      sum += lines->GetPointData()
               ->GetArray("ArcLength")
               ->GetComponent(points->GetId(points->GetNumberOfIds() - 1), 0);
    }
    return sum;
  };
  EXPECT_GT(length(), 0.7 * std::numbers::pi / 0.05);
  // As published and with a limit of the umbilic measure, there are none.
  filter->SmoothDirectionsOff();
  filter->SetUmbilicLimit(0.3);
  vtkNew<InkTestMessages> messages;
  messages->Observe(filter);
  EXPECT_LT(length(), 0.1 * std::numbers::pi / 0.05);
}

TEST(LinesOfCurvature, AreaScatterHasAboutAsManyLines)
{
  vtkNew<vtkInkLinesOfCurvature> filter;
  filter->SetInputData(Torus());
  filter->SetSeedingToAreaScatter();
  filter->SetIntegratorToEuler();
  filter->SmoothDirectionsOff();
  filter->SetStepFactor(1.0);
  filter->SetNumberOfSeeds(2000);
  filter->SetMaximumLength(0.5);
  filter->Update();
  EXPECT_NEAR(static_cast<double>(filter->GetOutput()->GetNumberOfLines()), 2000.0, 150.0);
  vtkDataArray* arc = filter->GetOutput()->GetPointData()->GetArray("ArcLength");
  EXPECT_LE(arc->GetRange()[1], 0.5 + 1e-9);
}

TEST(LinesOfCurvature, TheSameForAnyNumberOfThreads)
{
  const auto run = [](const char* threads)
  {
    setenv("VTK_SMP_MAX_THREADS", threads, 1);
    vtkNew<vtkInkLinesOfCurvature> filter;
    filter->SetInputData(Torus());
    filter->SetFamiliesToBoth();
    filter->Update();
    unsetenv("VTK_SMP_MAX_THREADS");
    vtkSmartPointer<vtkPolyData> lines = filter->GetOutput();
    return lines;
  };
  const auto one = run("1");
  const auto two = run("2");
  ASSERT_EQ(one->GetNumberOfPoints(), two->GetNumberOfPoints());
  ASSERT_EQ(one->GetNumberOfLines(), two->GetNumberOfLines());
  for (vtkIdType i = 0; i < one->GetNumberOfPoints(); ++i)
  {
    double a[3];
    double b[3];
    one->GetPoint(i, a);
    two->GetPoint(i, b);
    ASSERT_TRUE(std::equal(a, a + 3, b)) << i;
  }
}

TEST(LinesOfCurvature, OutsideIsOutsideHoweverPolygonsRun)
{
  // Lines along maximum curvature go around the tube, of which k1 is the larger one outside only.
  vtkNew<vtkPolyData> bare;
  bare->DeepCopy(Torus());
  bare->GetPointData()->Initialize();
  vtkNew<vtkReverseSense> turn;
  turn->SetInputData(bare);
  turn->Update();
  vtkPolyData* meshes[] = { bare, turn->GetOutput() };
  for (vtkPolyData* mesh : meshes)
  {
    vtkNew<vtkInkLinesOfCurvature> filter;
    filter->SetInputData(mesh);
    filter->SetSpacing(0.3);
    filter->ComputeCurvaturesOn();
    filter->Update();
    vtkPolyData* lines = filter->GetOutput();
    ASSERT_GT(lines->GetNumberOfLines(), 10);
    EXPECT_NEAR(lines->GetPointData()->GetArray("k1")->GetTuple1(0), 1.0 / Tube, 0.1);
    vtkNew<vtkIdList> ids;
    lines->GetCellPoints(0, ids);
    const double begin = Coordinate(lines, ids->GetId(0), true);
    const double middle = Coordinate(lines, ids->GetId(ids->GetNumberOfIds() / 2), true);
    EXPECT_LT(std::abs(std::remainder(middle - begin, 2.0 * std::numbers::pi)), 0.05);
  }
}

TEST(LinesOfCurvature, WhatIsWrongIsSaidOnce)
{
  vtkNew<vtkInkLinesOfCurvature> filter;
  vtkNew<InkTestMessages> messages;
  messages->Observe(filter);
  const auto expect = [&](vtkPolyData* mesh, const std::string& name, const std::vector<std::string>& words)
  {
    messages->Messages.clear();
    filter->SetInputData(mesh);
    filter->Update();
    messages->Expect(name, words);
    EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0) << name;
  };
  vtkNew<vtkPolyData> empty;
  expect(empty, "empty", {});

  vtkNew<vtkPoints> some;
  some->InsertNextPoint(0.0, 0.0, 0.0);
  some->InsertNextPoint(1.0, 0.0, 0.0);
  some->InsertNextPoint(2.0, 0.0, 0.0);
  vtkNew<vtkPolyData> points;
  points->SetPoints(some);
  expect(points, "points", { "3 points and no polygons or strips; expected a surface" });

  vtkNew<vtkPolyData> flat;
  vtkNew<vtkCellArray> faces;
  faces->InsertNextCell({ 0, 1, 2 });
  flat->SetPoints(some);
  flat->SetPolys(faces);
  expect(flat, "no area", { "have no area; expected faces with three different points" });
  vtkNew<vtkPoints> near;
  near->InsertNextPoint(0.0, 0.0, 0.0);
  near->InsertNextPoint(1.0, 0.0, 0.0);
  near->InsertNextPoint(0.0, 1e-11, 0.0);
  flat->SetPoints(near);
  expect(flat, "less area than rounding tells", { "have no area; expected faces with three" });

  vtkNew<vtkPolyData> wrong;
  vtkNew<vtkCellArray> missing;
  missing->InsertNextCell({ 0, 1, 7 });
  wrong->SetPoints(some);
  wrong->SetPolys(missing);
  expect(wrong, "missing point", { "a face has the point 7; expected 0 to 2" });

  expect(InkTestNotFiniteMesh(), "nothing finite", { InkTestNotFiniteFaces });

  const vtkSmartPointer<vtkPolyData> torus = Torus();
  vtkNew<vtkPolyData> arrays;
  arrays->ShallowCopy(torus);
  for (const char* name : { "k1", "k2", "PrincipalDirection1", "PrincipalDirection2" })
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->SetNumberOfTuples(arrays->GetNumberOfPoints());
    array->Fill(1.0);
    arrays->GetPointData()->AddArray(array);
  }
  expect(arrays, "components", { "\"PrincipalDirection1\" has", "tuples of 1 components; expected", "of 3" });

  filter->SetSpacing(1e-7);
  expect(torus, "spacing", { "samples of lines at a spacing of", "larger spacing" });

  filter->SetSpacing(100.0);
  expect(torus, "no room", { "The surface has no lines", "expected more than 200" });

  messages->Messages.clear();
  filter->SetSpacing(std::nan(""));
  EXPECT_EQ(filter->GetSpacing(), 100.0);
  EXPECT_EQ(messages->Messages.size(), 1u);
}

/// Lines only where they are wanted: as even as all over the surface, along the same directions.
TEST(LinesOfCurvature, OfARegion)
{
  constexpr double spacing = 0.1;
  constexpr double begin = 0.5;
  const vtkSmartPointer<vtkPolyData> torus = Torus();
  vtkNew<vtkPlanes> region;
  vtkNew<vtkPoints> origins;
  origins->InsertNextPoint(begin, 0.0, 0.0);
  vtkNew<vtkDoubleArray> normals;
  normals->SetNumberOfComponents(3);
  normals->InsertNextTuple3(-1.0, 0.0, 0.0);
  region->SetPoints(origins);
  region->SetNormals(normals);
  vtkNew<vtkInkLinesOfCurvature> filter;
  vtkNew<vtkInkHatching> hatching;
  filter->SetInputData(torus);
  filter->SetSpacing(spacing);
  hatching->SetInputConnection(filter->GetOutputPort());
  hatching->SetSurfaceData(torus);
  hatching->Update();
  const double whole = hatching->GetOutput()->GetCellData()->GetArray("Spacing")->GetTuple1(0);
  EXPECT_NEAR(whole, spacing, 0.15 * spacing);
  filter->SetRegion(region);
  hatching->SetRegion(region);
  hatching->Update();
  vtkPolyData* lines = filter->GetOutput();
  ASSERT_GT(lines->GetNumberOfLines(), 20);
  double least = Radius;
  vtkNew<vtkIdList> ids;
  for (vtkIdType line = 0; line < lines->GetNumberOfLines(); ++line)
  {
    lines->GetCellPoints(line, ids);
    const double first = Coordinate(lines, ids->GetId(0), true);
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      least = std::min(least, lines->GetPoint(ids->GetId(i))[0]);
      ASSERT_NEAR(
        std::remainder(Coordinate(lines, ids->GetId(i), true) - first, 2.0 * std::numbers::pi), 0.0, 0.01);
    }
  }
  // A triangle's edge beyond.
  EXPECT_LT(least, begin + spacing);
  EXPECT_GT(least, begin - 0.3);
  EXPECT_NEAR(hatching->GetOutput()->GetCellData()->GetArray("Spacing")->GetTuple1(0), whole, 0.1 * whole);
  hatching->SetRegion(nullptr);
  hatching->Update();
  EXPECT_GT(hatching->GetOutput()->GetCellData()->GetArray("Spacing")->GetTuple1(0), 2.0 * whole);
  // Where the surface is not, nothing, and nothing to say.
  vtkNew<InkTestMessages> messages;
  messages->Observe(filter);
  origins->SetPoint(0, 50.0, 0.0, 0.0);
  region->Modified();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfLines(), 0);
  EXPECT_TRUE(messages->Messages.empty());
  // Seeds by chance are as dense as all over the surface.
  filter->SetSeedingToAreaScatter();
  filter->SetNumberOfSeeds(2000);
  origins->SetPoint(0, 0.0, 0.0, 0.0);
  region->Modified();
  filter->Update();
  EXPECT_NEAR(static_cast<double>(filter->GetOutput()->GetNumberOfLines()), 1000.0, 150.0);
}

/// Far from the origin, and stretched: a torus's lines stay on it, are as many, and cover all of it.
TEST(LinesOfCurvature, FarAwayAndStretched)
{
  const auto linesOf = [](double origin, const double(&stretch)[3], double spacing)
  {
    const vtkSmartPointer<vtkPolyData> torus = Torus();
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (vtkIdType i = 0; i < torus->GetNumberOfPoints(); ++i)
    {
      double p[3];
      torus->GetPoint(i, p);
      points->InsertNextPoint(
        origin + stretch[0] * p[0], origin + stretch[1] * p[1], origin + stretch[2] * p[2]);
    }
    torus->SetPoints(points);
    torus->GetPointData()->Initialize();
    vtkNew<vtkInkLinesOfCurvature> filter;
    vtkNew<InkTestMessages> messages;
    messages->Observe(filter);
    filter->SetInputData(torus);
    filter->SetSpacing(spacing);
    filter->Update();
    EXPECT_TRUE(messages->Messages.empty());
    return vtkSmartPointer<vtkPolyData>(filter->GetOutput());
  };
  const double usual[3] = { 1.0, 1.0, 1.0 };
  const vtkSmartPointer<vtkPolyData> here = linesOf(0.0, usual, 0.1);
  const vtkSmartPointer<vtkPolyData> away = linesOf(1e7, usual, 0.1);
  EXPECT_NEAR(static_cast<double>(away->GetNumberOfLines()), static_cast<double>(here->GetNumberOfLines()),
    0.05 * static_cast<double>(here->GetNumberOfLines()));
  for (vtkIdType i = 0; i < away->GetNumberOfPoints(); ++i)
  {
    double p[3];
    away->GetPoint(i, p);
    const double out = std::hypot(p[0] - 1e7, p[1] - 1e7) - Radius;
    ASSERT_NEAR(std::hypot(out, p[2] - 1e7), Tube, 0.01);
  }
  // A thousand times as long or as wide: no number that is none, on the stretched torus.
  for (int axis = 0; axis < 3; ++axis)
  {
    double stretch[3] = { 1.0, 1.0, 1.0 };
    stretch[axis] = 1000.0;
    const vtkSmartPointer<vtkPolyData> lines = linesOf(0.0, stretch, 1.0);
    ASSERT_GT(lines->GetNumberOfLines(), 0) << axis;
    double bounds[6];
    lines->GetBounds(bounds);
    EXPECT_GT(bounds[2 * axis + 1] - bounds[2 * axis], 1000.0 * (axis == 2 ? Tube : Radius)) << axis;
    for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
    {
      double p[3];
      lines->GetPoint(i, p);
      const double out = std::hypot(p[0] / stretch[0], p[1] / stretch[1]) - Radius;
      ASSERT_NEAR(std::hypot(out, p[2] / stretch[2]), Tube, 0.02) << axis;
      ASSERT_NEAR(LengthAt(lines->GetPointData()->GetNormals(), i), 1.0, 1e-5) << axis;
    }
  }
}

TEST(LinesOfCurvature, OddMeshesOfAnySize)
{
  for (const double scale : { 1e-9, 1.0, 1e9 })
  {
    vtkNew<vtkInkLinesOfCurvature> filter;
    vtkNew<InkTestMessages> messages;
    messages->Observe(filter);
    filter->SetInputData(InkTestOddMesh(scale));
    filter->SetFamiliesToBoth();
    filter->Update();
    vtkPolyData* lines = filter->GetOutput();
    messages->Expect("scale " + std::to_string(scale), { InkTestOddFaces });
    EXPECT_GT(lines->GetNumberOfLines(), 0) << scale;
    for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
    {
      double p[3];
      lines->GetPoint(i, p);
      ASSERT_TRUE(std::isfinite(p[0] + p[1] + p[2])) << scale;
      ASSERT_TRUE(std::isfinite(lines->GetPointData()->GetNormals()->GetComponent(i, 0))) << scale;
    }
  }
}
