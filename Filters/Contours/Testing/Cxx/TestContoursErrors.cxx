// SPDX-License-Identifier: BSD-3-Clause
// Each problem gives one message and an empty, valid output.

#include "InkTestMesh.h"
#include "InkTestMessages.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkInkContours.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <limits>

namespace
{

struct Checked
{
  Checked() { this->Messages->Observe(this->Contours); }

  void Expect(vtkPolyData* mesh, const std::string& name, const std::vector<std::string>& words)
  {
    this->Messages->Messages.clear();
    this->Contours->SetInputData(mesh);
    this->Contours->Update();
    this->Messages->Expect(name, words);
  }

  vtkNew<vtkInkContours> Contours;
  vtkNew<InkTestMessages> Messages;
};

vtkSmartPointer<vtkPolyData> Sphere(bool normals)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetGenerateNormals(normals);
  sphere->Update();
  return sphere->GetOutput();
}

} // namespace

TEST(ContoursErrors, NoCamera)
{
  Checked run;
  run.Expect(Sphere(true), "no camera", { "there is no camera; expected one by SetCamera" });
  EXPECT_EQ(run.Contours->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(ContoursErrors, CameraThatIsNotFinite)
{
  Checked run;
  vtkNew<vtkCamera> camera;
  camera->SetPosition(std::numeric_limits<double>::infinity(), 0.0, 0.0);
  run.Contours->SetCamera(camera);
  run.Expect(Sphere(true), "camera", { "the eye's position is not finite" });
  EXPECT_EQ(run.Contours->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(ContoursErrors, NoNormalsAreSaidOnce)
{
  Checked run;
  run.Contours->SetEyeToDirection();
  run.Expect(Sphere(false), "no normals", { "no point normals; expected a point array \"Normals\"" });
  EXPECT_EQ(run.Contours->GetOutput()->GetNumberOfLines(), 1);
  run.Expect(Sphere(false), "again", {});
  EXPECT_EQ(run.Contours->GetOutput()->GetNumberOfLines(), 1);

  Checked faceted;
  faceted.Contours->SetEyeToDirection();
  faceted.Contours->FacetedOn();
  faceted.Expect(Sphere(false), "faceted", {});
  EXPECT_GT(faceted.Contours->GetOutput()->GetNumberOfLines(), 0);
}

TEST(ContoursErrors, NoPolygons)
{
  Checked run;
  run.Contours->SetEyeToDirection();
  vtkNew<vtkPolyData> empty;
  run.Expect(empty, "nothing", {});
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(1.0, 2.0, 3.0);
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(points);
  run.Expect(cloud, "points", { "has 1 points and no polygons or strips; expected a surface" });
  EXPECT_EQ(run.Contours->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(ContoursErrors, FacesThatAreWrong)
{
  Checked run;
  run.Contours->SetEyeToDirection();
  run.Contours->SetEyeDirection(0.3, 0.5, -1.0);
  run.Contours->FacetedOn();
  run.Contours->CreasesOn();
  run.Contours->NonManifoldEdgesOn();
  const vtkSmartPointer<vtkPolyData> odd = InkTestOddMesh(1.0);
  run.Expect(odd, "odd", { InkTestOddFaces });
  EXPECT_GT(run.Contours->GetOutput()->GetNumberOfLines(), 0);
  run.Contours->SetEyeDirection(0.3, 0.4, -1.0);
  run.Expect(odd, "another eye", {});
  run.Contours->SetFeatureAngle(10.0);
  run.Expect(odd, "another option", {});
  run.Expect(InkTestOddMesh(2.0), "another mesh", { InkTestOddFaces });
  run.Expect(InkTestNotFiniteMesh(), "nothing finite", { InkTestNotFiniteFaces });
  EXPECT_EQ(run.Contours->GetOutput()->GetNumberOfPoints(), 0);
  const vtkSmartPointer<vtkPolyData> mesh = Sphere(true);
  mesh->GetPolys()->InsertNextCell({ 0, 1, 100000 });
  run.Expect(mesh, "no such point", { "a face has the point 100000" });
  EXPECT_EQ(run.Contours->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(ContoursErrors, NumbersThatAreNotFinite)
{
  Checked run;
  run.Contours->SetEyePosition(std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
  run.Messages->Expect("position", { "EyePosition: expected three finite numbers" });
  EXPECT_EQ(run.Contours->GetEyePosition()[2], 1.0);
  run.Contours->SetEyeToDirection();
  run.Contours->SetEyeDirection(0.0, 0.0, 0.0);
  run.Expect(Sphere(true), "direction", { "the eye's direction is zero" });
}
