// SPDX-License-Identifier: BSD-3-Clause
#include "InkTestMessages.h"

#include "vtkCamera.h"
#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCubeSource.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkInkContours.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkTriangleFilter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace
{

/// Around the origin, with normals.
void SetUpSphere(vtkSphereSource* sphere, int resolution = 64)
{
  sphere->SetRadius(1.0);
  sphere->SetThetaResolution(2 * resolution);
  sphere->SetPhiResolution(resolution);
}

int KindOf(vtkPolyData* lines, vtkIdType line)
{
  return static_cast<int>(lines->GetCellData()->GetArray("ContourKind")->GetTuple1(line));
}

} // namespace

TEST(Contours, OfASphereAreACircle)
{
  vtkNew<vtkSphereSource> sphere;
  SetUpSphere(sphere);
  vtkNew<vtkCamera> camera;
  camera->SetPosition(1.0, 2.0, 4.0);
  vtkNew<vtkInkContours> contours;
  contours->SetInputConnection(sphere->GetOutputPort());
  contours->SetCamera(camera);
  contours->ComputeNormalsOn();
  contours->ComputeRadialCurvatureOn();
  contours->ComputeArcLengthOn();
  contours->ComputeCellIdsOn();
  contours->Update();
  vtkPolyData* output = contours->GetOutput();
  ASSERT_EQ(output->GetNumberOfLines(), 1);
  EXPECT_EQ(KindOf(output, 0), vtkInkContours::SILHOUETTE);
  vtkIdList* ids = output->GetCell(0)->GetPointIds();
  EXPECT_EQ(ids->GetNumberOfIds(), output->GetNumberOfPoints() + 1);
  EXPECT_EQ(ids->GetId(0), ids->GetId(ids->GetNumberOfIds() - 1)); // closed
  // p.e = 1, as in the tests of ink::MeshContours.
  vtkPointData* arrays = output->GetPointData();
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double p[3];
    output->GetPoint(i, p);
    EXPECT_NEAR(p[0] + 2.0 * p[1] + 4.0 * p[2], 1.0, 0.01);
    double n[3];
    arrays->GetNormals()->GetTuple(i, n);
    EXPECT_NEAR(p[0] * n[0] + p[1] * n[1] + p[2] * n[2], 1.0, 0.01);
    EXPECT_NEAR(arrays->GetArray("RadialCurvature")->GetTuple1(i), 1.0, 0.05);
    // The middle of a segment lies near the center of its cell.
    double q[3];
    output->GetPoint(ids->GetId(i + 1), q);
    double bounds[6];
    sphere->GetOutput()->GetCellBounds(
      static_cast<vtkIdType>(arrays->GetArray("CellId")->GetTuple1(i)), bounds);
    for (int axis = 0; axis < 3; ++axis)
    {
      const double middle = 0.5 * (p[axis] + q[axis]);
      EXPECT_GE(middle, bounds[2 * axis] - 1e-6);
      EXPECT_LE(middle, bounds[2 * axis + 1] + 1e-6);
    }
  }
  const double radius = std::sqrt(1.0 - 1.0 / 21.0);
  const double length = arrays->GetArray("ArcLength")->GetTuple1(output->GetNumberOfPoints() - 1);
  EXPECT_NEAR(length, 2.0 * 3.14159265 * radius, 0.1);
}

TEST(Contours, FollowTheCamera)
{
  vtkNew<vtkSphereSource> sphere;
  SetUpSphere(sphere);
  vtkNew<vtkCamera> camera;
  camera->SetPosition(0.0, 0.0, 2.0);
  vtkNew<vtkInkContours> contours;
  contours->SetInputConnection(sphere->GetOutputPort());
  contours->SetCamera(camera);
  const auto height = [&](int axis)
  {
    contours->Update();
    double bounds[6];
    contours->GetOutput()->GetBounds(bounds);
    return 0.5 * (bounds[2 * axis] + bounds[2 * axis + 1]);
  };
  EXPECT_NEAR(height(2), 0.5, 0.01);
  camera->SetPosition(4.0, 0.0, 0.0);
  EXPECT_NEAR(height(0), 0.25, 0.01);
  camera->ParallelProjectionOn();
  EXPECT_NEAR(height(0), 0.0, 0.01);
  contours->SetEyeToPosition();
  contours->SetEyePosition(0.0, 5.0, 0.0);
  EXPECT_NEAR(height(1), 0.2, 0.01);
  contours->SetEyeToDirection();
  contours->SetEyeDirection(0.0, 7.0, 0.0);
  EXPECT_NEAR(height(1), 0.0, 0.01);
  EXPECT_EQ(contours->GetNumberOfIndexBuilds(), 1);
  // Neither a camera that is not used nor an array needs a new index.
  const vtkMTimeType time = contours->GetMTime();
  camera->SetPosition(1.0, 0.0, 0.0);
  EXPECT_EQ(contours->GetMTime(), time);
  contours->ComputeArcLengthOn();
  contours->Update();
  EXPECT_EQ(contours->GetNumberOfIndexBuilds(), 1);
  sphere->SetRadius(2.0);
  contours->Update();
  EXPECT_EQ(contours->GetNumberOfIndexBuilds(), 2);
  contours->FacetedOn();
  contours->Update();
  EXPECT_EQ(contours->GetNumberOfIndexBuilds(), 3);
}

TEST(Contours, TellKindsApart)
{
  // A cube: its sides have points of their own.
  vtkNew<vtkCubeSource> cube;
  vtkNew<vtkInkContours> contours;
  contours->SetInputConnection(cube->GetOutputPort());
  contours->SetEyeToPosition();
  contours->SetEyePosition(4.0, 5.0, 6.0);
  contours->CreasesOn();
  contours->Update();
  vtkPolyData* output = contours->GetOutput();
  ASSERT_EQ(output->GetNumberOfLines(), 13);
  EXPECT_EQ(output->GetCell(0)->GetNumberOfPoints(), 7); // a hexagon
  EXPECT_EQ(KindOf(output, 0), vtkInkContours::SILHOUETTE);
  for (vtkIdType line = 1; line < 13; ++line)
  {
    EXPECT_EQ(KindOf(output, line), vtkInkContours::CREASE);
  }
  contours->SetFeatureAngle(91.0);
  contours->Update();
  EXPECT_EQ(output->GetNumberOfLines(), 1);

  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(3, 2);
  contours->SetInputConnection(plane->GetOutputPort());
  contours->Update();
  ASSERT_EQ(output->GetNumberOfLines(), 1);
  EXPECT_EQ(KindOf(output, 0), vtkInkContours::BORDER);
  EXPECT_EQ(output->GetCell(0)->GetNumberOfPoints(), 11);
  contours->BordersOff();
  contours->Update();
  EXPECT_EQ(output->GetNumberOfLines(), 0);
}

/// Of a mesh that has both sides of each triangle: no edge has more than two faces, and the contours are the
/// same.
TEST(Contours, TrianglesTwiceCountOnce)
{
  vtkNew<vtkSphereSource> sphere;
  SetUpSphere(sphere);
  sphere->Update();
  vtkNew<vtkPolyData> twice;
  twice->DeepCopy(sphere->GetOutput());
  vtkNew<vtkCellArray> faces;
  faces->DeepCopy(twice->GetPolys());
  for (vtkIdType face = 0; face < twice->GetNumberOfPolys(); ++face)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    twice->GetPolys()->GetCellAtId(face, size, corners);
    faces->InsertNextCell({ corners[2], corners[1], corners[0] });
  }
  twice->SetPolys(faces);
  vtkNew<vtkInkContours> contours;
  contours->SetEyeToPosition();
  contours->SetEyePosition(4.0, 5.0, 6.0);
  contours->CreasesOn();
  contours->NonManifoldEdgesOn();
  vtkNew<vtkPolyData> once;
  contours->SetInputData(sphere->GetOutput());
  contours->Update();
  once->DeepCopy(contours->GetOutput());
  contours->SetInputData(twice);
  contours->Update();
  ASSERT_GT(once->GetNumberOfPoints(), 100);
  ASSERT_EQ(contours->GetOutput()->GetNumberOfLines(), once->GetNumberOfLines());
  ASSERT_EQ(contours->GetOutput()->GetNumberOfPoints(), once->GetNumberOfPoints());
  for (vtkIdType i = 0; i < once->GetNumberOfPoints(); ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      ASSERT_EQ(contours->GetOutput()->GetPoint(i)[axis], once->GetPoint(i)[axis]) << i;
    }
  }
}

TEST(Contours, HaveThePrecisionOfTheMesh)
{
  vtkNew<vtkInkContours> contours;
  contours->SetEyeToDirection();
  vtkNew<vtkSphereSource> sphere;
  contours->SetInputConnection(sphere->GetOutputPort());
  for (const auto& [precision, type] : { std::pair(vtkAlgorithm::SINGLE_PRECISION, VTK_FLOAT),
         std::pair(vtkAlgorithm::DOUBLE_PRECISION, VTK_DOUBLE) })
  {
    sphere->SetOutputPointsPrecision(precision);
    contours->Update();
    EXPECT_EQ(contours->GetOutput()->GetPoints()->GetDataType(), type);
    EXPECT_GT(contours->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_EQ(contours->GetOutput()->GetPointData()->GetNumberOfArrays(), 0); // nobody asked for any
  }
}

TEST(Contours, PrintWhatTheyAre)
{
  vtkNew<vtkInkContours> contours;
  std::ostringstream text;
  contours->Print(text);
  for (const char* line : { "Eye: Camera", "EyePosition: 0, 0, 1", "FeatureAngle: 30", "Silhouettes: 1" })
  {
    EXPECT_NE(text.str().find(line), std::string::npos) << line;
  }
}
