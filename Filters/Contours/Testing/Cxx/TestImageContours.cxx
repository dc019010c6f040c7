// SPDX-License-Identifier: BSD-3-Clause
// Silhouettes of an image's iso-surfaces, straight from the samples.
#include "InkTestMessages.h"

#include "vtkCamera.h"
#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkInkContours.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace
{

/// 100 minus 10 times the distance from the middle of a cube of side 12 around the origin.
vtkSmartPointer<vtkImageData> MakeBall(int side = 49, double scale = 1.0)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(side, side, side);
  const double spacing = scale * 12.0 / (side - 1);
  image->SetSpacing(spacing, spacing, spacing);
  image->SetOrigin(-6.0 * scale, -6.0 * scale, -6.0 * scale);
  vtkNew<vtkDoubleArray> values;
  values->SetName("distance");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    values->InsertNextValue(100.0 - 10.0 * vtkMath::Norm(image->GetPoint(i)) / scale);
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

/// From where spheres around the origin have the circle p.e = r^2.
constexpr double Eye[3] = { 6.0, 9.0, 18.0 };

struct Finder
{
  explicit Finder(vtkImageData* image)
  {
    this->Messages->Observe(this->Contours);
    this->Contours->SetInputData(image);
    this->Contours->SetEyeToPosition();
    this->Contours->SetEyePosition(Eye);
    this->Contours->SetValue(0, 60.0);
  }

  vtkPolyData* Find()
  {
    this->Contours->Update();
    return this->Contours->GetOutput();
  }

  vtkNew<vtkInkContours> Contours;
  vtkNew<InkTestMessages> Messages;
};

/// The largest distance of points from that circle, of a radius.
double FindError(vtkPolyData* lines, double radius)
{
  double error = 0.0;
  for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
  {
    const double* p = lines->GetPoint(i);
    const double along = (vtkMath::Dot(p, Eye) - radius * radius) / vtkMath::Norm(Eye);
    error = std::max(error, std::hypot(vtkMath::Norm(p) - radius, along));
  }
  return error;
}

} // namespace

TEST(ImageContours, OfABallAreACircle)
{
  Finder run(MakeBall());
  run.Contours->ComputeNormalsOn();
  run.Contours->ComputeRadialCurvatureOn();
  run.Contours->ComputeArcLengthOn();
  run.Contours->ComputeCellIdsOn();
  vtkPolyData* lines = run.Find();
  ASSERT_EQ(lines->GetNumberOfLines(), 1);
  EXPECT_EQ(lines->GetCellData()->GetArray("ContourKind")->GetTuple1(0), vtkInkContours::SILHOUETTE);
  EXPECT_EQ(lines->GetCellData()->GetArray("SurfaceIndex"), nullptr);
  EXPECT_EQ(lines->GetPoints()->GetDataType(), VTK_FLOAT);
  // Cells measure 0.25; measured 0.02.
  EXPECT_LT(FindError(lines, 4.0), 0.04);
  vtkIdList* ids = lines->GetCell(0)->GetPointIds();
  EXPECT_EQ(ids->GetNumberOfIds(), lines->GetNumberOfPoints() + 1);
  EXPECT_EQ(ids->GetId(0), ids->GetId(ids->GetNumberOfIds() - 1)) << "closed";
  vtkPointData* arrays = lines->GetPointData();
  auto* image = vtkImageData::SafeDownCast(run.Contours->GetInput());
  for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
  {
    const double* p = lines->GetPoint(i);
    double n[3];
    arrays->GetNormals()->GetTuple(i, n);
    EXPECT_NEAR(vtkMath::Dot(p, n), 4.0, 0.05);
    EXPECT_NEAR(arrays->GetArray("RadialCurvature")->GetTuple1(i), 0.25, 0.03);
    double q[3];
    lines->GetPoint(ids->GetId(i + 1), q);
    double bounds[6];
    image->GetCellBounds(static_cast<vtkIdType>(arrays->GetArray("CellId")->GetTuple1(i)), bounds);
    for (int axis = 0; axis < 3; ++axis)
    {
      const double middle = 0.5 * (p[axis] + q[axis]);
      EXPECT_GE(middle, bounds[2 * axis] - 1e-5);
      EXPECT_LE(middle, bounds[2 * axis + 1] + 1e-5);
    }
  }
  const double radius = std::sqrt(16.0 - 256.0 / vtkMath::Dot(Eye, Eye));
  EXPECT_NEAR(arrays->GetArray("ArcLength")->GetTuple1(lines->GetNumberOfPoints() - 1),
    2.0 * vtkMath::Pi() * radius, 0.3);
  run.Messages->Expect("ball", {});
}

TEST(ImageContours, SeveralIsoValuesHaveTheirIndices)
{
  Finder run(MakeBall());
  run.Contours->SetValue(0, 50.0);
  run.Contours->SetValue(1, 70.0);
  run.Contours->SetValue(2, 500.0);
  EXPECT_EQ(run.Contours->GetNumberOfContours(), 3);
  vtkPolyData* lines = run.Find();
  ASSERT_EQ(lines->GetNumberOfLines(), 2);
  vtkDataArray* indices = lines->GetCellData()->GetArray("SurfaceIndex");
  ASSERT_NE(indices, nullptr);
  for (vtkIdType line = 0; line < 2; ++line)
  {
    EXPECT_EQ(indices->GetTuple1(line), line);
    double p[3];
    lines->GetPoint(lines->GetCell(line)->GetPointId(0), p);
    EXPECT_NEAR(vtkMath::Norm(p), line == 0 ? 5.0 : 3.0, 0.05);
  }
}

TEST(ImageContours, OnlyWhatChangesIsPrepared)
{
  const auto image = MakeBall();
  Finder run(image);
  vtkNew<vtkCamera> camera;
  camera->SetPosition(Eye);
  run.Contours->SetCamera(camera);
  run.Contours->SetEyeToCamera();
  EXPECT_LT(FindError(run.Find(), 4.0), 0.04);
  camera->SetPosition(-6.0, 9.0, 18.0);
  EXPECT_GT(FindError(run.Find(), 4.0), 1.0) << "another circle";
  camera->ParallelProjectionOn();
  EXPECT_GT(run.Find()->GetNumberOfLines(), 0);
  EXPECT_EQ(run.Contours->GetNumberOfIndexBuilds(), 1);
  run.Contours->SetValue(1, 50.0);
  EXPECT_EQ(run.Find()->GetNumberOfLines(), 2);
  EXPECT_EQ(run.Contours->GetNumberOfIndexBuilds(), 2);
  run.Contours->SetNumberOfContours(1);
  EXPECT_EQ(run.Find()->GetNumberOfLines(), 1);
  EXPECT_EQ(run.Contours->GetNumberOfIndexBuilds(), 2);
  // Values that are changed where they are.
  auto* values = vtkDoubleArray::SafeDownCast(image->GetPointData()->GetScalars());
  for (vtkIdType i = 0; i < values->GetNumberOfValues(); ++i)
  {
    values->SetValue(i, values->GetValue(i) + 10.0);
  }
  values->Modified();
  camera->ParallelProjectionOff();
  camera->SetPosition(Eye);
  EXPECT_LT(FindError(run.Find(), 5.0), 0.04);
  EXPECT_EQ(run.Contours->GetNumberOfIndexBuilds(), 3);
}

TEST(ImageContours, ProjectionBringsPointsOntoTheField)
{
  Finder run(MakeBall());
  const double before = FindError(run.Find(), 4.0);
  run.Contours->SetProjectionSteps(8);
  // The interpolated ball is no ball itself: points come closer to that only as far as it does.
  EXPECT_LT(FindError(run.Find(), 4.0), 1.5 * before);
  run.Contours->SetProjectionSteps(-3);
  EXPECT_EQ(run.Contours->GetProjectionSteps(), 0);
  run.Contours->SetProjectionSteps(1000);
  EXPECT_EQ(run.Contours->GetProjectionSteps(), 20);
}

TEST(ImageContours, ScalesComponentsAndArrays)
{
  for (const double scale : { 1e-9, 1e9 })
  {
    Finder run(MakeBall(49, scale));
    run.Contours->SetEyePosition(scale * Eye[0], scale * Eye[1], scale * Eye[2]);
    vtkPolyData* lines = run.Find();
    ASSERT_EQ(lines->GetNumberOfLines(), 1) << scale;
    EXPECT_NEAR(vtkMath::Norm(lines->GetPoint(0)), 4.0 * scale, 0.02 * scale);
    run.Messages->Expect("scale", {});
  }
  // The second component of an array that is not the active one.
  const auto image = MakeBall(33);
  vtkNew<vtkFloatArray> both;
  both->SetName("both");
  both->SetNumberOfComponents(2);
  both->SetNumberOfTuples(image->GetNumberOfPoints());
  both->FillComponent(0, 0.0);
  both->CopyComponent(1, image->GetPointData()->GetScalars(), 0);
  image->GetPointData()->AddArray(both);
  Finder run(image);
  run.Contours->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "both");
  run.Contours->SetArrayComponent(1);
  EXPECT_LT(FindError(run.Find(), 4.0), 0.08);
  run.Contours->SetArrayComponent(2);
  EXPECT_EQ(run.Find()->GetNumberOfPoints(), 0);
  run.Messages->Expect("component", { "Component 2" });
}

TEST(ImageContours, HiddenCellsAndMissingValuesHaveNone)
{
  const auto image = MakeBall();
  auto* values = vtkDoubleArray::SafeDownCast(image->GetPointData()->GetScalars());
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfTuples(image->GetNumberOfCells());
  ghosts->Fill(0);
  for (vtkIdType cell = 0; cell < image->GetNumberOfCells(); ++cell)
  {
    double bounds[6];
    image->GetCellBounds(cell, bounds);
    if (bounds[0] >= 0.0 && bounds[2] >= 0.0)
    {
      ghosts->SetValue(cell, vtkDataSetAttributes::HIDDENCELL);
    }
  }
  image->GetCellData()->AddArray(ghosts);
  Finder hidden(image);
  vtkPolyData* lines = hidden.Find();
  ASSERT_GT(lines->GetNumberOfLines(), 0);
  for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
  {
    const double* p = lines->GetPoint(i);
    EXPECT_FALSE(p[0] > 1e-5 && p[1] > 1e-5);
  }
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    if (image->GetPoint(i)[0] < -1.0)
    {
      values->SetValue(i, std::numeric_limits<double>::quiet_NaN());
    }
  }
  values->Modified();
  lines = hidden.Find();
  ASSERT_GT(lines->GetNumberOfLines(), 0);
  for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
  {
    EXPECT_GE(lines->GetPoint(i)[0], -1.0 - 1e-5);
  }
}

TEST(ImageContours, WhatIsWrongIsSaid)
{
  const auto image = MakeBall(17);
  const auto expect = [](Finder& run, const std::string& name, const std::vector<std::string>& words)
  {
    run.Messages->Messages.clear();
    EXPECT_EQ(run.Find()->GetNumberOfPoints(), 0) << name;
    run.Messages->Expect(name, words);
  };
  Finder none(image);
  none.Contours->SetNumberOfContours(0);
  expect(none, "no iso-value", { "No iso-value is set, so there are no contours" });
  Finder outside(image);
  outside.Contours->SetValue(0, 1000.0);
  expect(outside, "outside", { "No voxel lies on the iso-surface of 1000. Expected a value above" });
  Finder nan(image);
  nan.Contours->SetValue(0, std::numeric_limits<double>::quiet_NaN());
  expect(nan, "NaN", { "not a number (NaN)" });
  Finder missing(image);
  missing.Contours->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "density");
  expect(missing, "array", { "No numeric point array \"density\"" });
  Finder eye(image);
  eye.Contours->SetEyeToCamera();
  expect(eye, "no camera", { "The contours of the image cannot be found: there is no camera" });
  vtkNew<vtkImageData> flat;
  flat->SetDimensions(8, 8, 1);
  flat->AllocateScalars(VTK_DOUBLE, 1);
  Finder thin(flat);
  expect(thin, "flat", { "The image has 8 x 8 x 1 samples" });
  vtkNew<vtkImageData> empty;
  Finder nothing(empty);
  expect(nothing, "empty", {});
  Finder off(image);
  off.Contours->SilhouettesOff();
  expect(off, "off", {});
  std::ostringstream text;
  off.Contours->Print(text);
  EXPECT_NE(text.str().find("ProjectionSteps: 0"), std::string::npos);
}
