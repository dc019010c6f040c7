// SPDX-License-Identifier: BSD-3-Clause
// Each problem gives one message and a valid output.

#include "InkTestMesh.h"
#include "InkTestMessages.h"
#include "InkTestVolume.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInkPrincipalCurvature.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace
{

struct Checked
{
  Checked() { this->Messages->Observe(this->Filter); }

  void Expect(
    vtkPolyData* mesh, const std::string& name, const std::vector<std::string>& words, vtkIdType points)
  {
    this->Filter->SetInputData(mesh);
    this->Filter->Update();
    this->Messages->Expect(name, words);
    EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), points) << name;
  }

  vtkNew<vtkInkPrincipalCurvature> Filter;
  vtkNew<InkTestMessages> Messages;
};

} // namespace

TEST(PrincipalCurvatureErrors, NothingIsNoProblem)
{
  Checked run;
  run.Expect(vtkNew<vtkPolyData>(), "empty", {}, 0);
}

TEST(PrincipalCurvatureErrors, NoPolygons)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(points);
  Checked run;
  run.Expect(mesh, "points", { "1 points and no polygons or strips; expected a surface" }, 0);
}

TEST(PrincipalCurvatureErrors, AFaceWithAPointThatDoesNotExist)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  vtkNew<vtkCellArray> polys;
  polys->InsertNextCell({ 0, 1, 7 });
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(points);
  mesh->SetPolys(polys);
  Checked run;
  run.Expect(
    mesh, "face", { "The curvature cannot be computed: a face has the point 7; expected 0 to 0." }, 0);
}

TEST(PrincipalCurvatureErrors, OddMeshesHaveFiniteValues)
{
  Checked run;
  run.Filter->ComputeSourceOn();
  run.Filter->ComputeUmbilicMeasureOn();
  run.Expect(InkTestOddMesh(1.0), "odd mesh", { InkTestOddFaces }, 8);
  vtkPointData* arrays = run.Filter->GetOutput()->GetPointData();
  for (int a = 0; a < arrays->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* array = arrays->GetArray(a);
    for (vtkIdType i = 0; i < 8; ++i)
    {
      EXPECT_TRUE(std::isfinite(array->GetComponent(i, 0))) << array->GetName() << " at " << i;
    }
  }
  // The point that is not finite, which no triangle keeps.
  EXPECT_EQ(arrays->GetArray("CurvatureSource")->GetTuple1(7), vtkInkPrincipalCurvature::NONE);
  Checked none;
  none.Expect(InkTestNotFiniteMesh(), "nothing finite", { InkTestNotFiniteFaces }, 0);
}

TEST(PrincipalCurvatureErrors, ImageWithoutScalars)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 3, 3);
  Checked run;
  run.Filter->SetFieldData(image);
  run.Expect(
    sphere->GetOutput(), "no scalars", { "No point scalars in the image. Its point arrays: none." }, 0);
}

TEST(PrincipalCurvatureErrors, PointsBesideTheImage)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(100.0, 0.0, 0.0);
  sphere->Update();
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 3, 3);
  InkTestFill(image, VTK_FLOAT, [](double x, double y, double z) { return x + y + z; });
  Checked run;
  run.Filter->SetFieldData(image);
  run.Filter->ComputeSourceOn();
  run.Expect(sphere->GetOutput(), "beside", { "None of the input's 50 points lies in the image" }, 50);
  EXPECT_EQ(run.Filter->GetOutput()->GetPointData()->GetArray("k1")->GetTuple1(0), 0.0);
}

TEST(PrincipalCurvatureErrors, NoDerivativeOfFitsOfDegree2)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  Checked run;
  run.Filter->ComputeDerivativeOn();
  run.Filter->SetDegree(2);
  run.Expect(sphere->GetOutput(), "degree 2",
    { "The estimator is Jet of degree 2; expected Jet of degree 3 for ComputeDerivative" }, 50);
  EXPECT_FALSE(run.Filter->GetOutput()->GetPointData()->HasArray("CurvatureDerivative"));
}
