// SPDX-License-Identifier: BSD-3-Clause
// The arrays of vtkInkPrincipalCurvature: of meshes and of images against known surfaces.

#include "AnalyticFields.h"
#include "HashNoise.h"
#include "InkTestMessages.h"
#include "InkTestVolume.h"
#include "MachineParts.h"
#include "MeshesWithCurvature.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInkPrincipalCurvature.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace
{

vtkSmartPointer<vtkPolyData> PolyDataOf(const ink::test::Mesh& mesh)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const glm::dvec3& p : mesh.points)
  {
    points->InsertNextPoint(&p.x);
  }
  vtkNew<vtkCellArray> polys;
  for (const ink::Triangle& t : mesh.triangles)
  {
    polys->InsertNextCell({ t[0], t[1], t[2] });
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(polys);
  return data;
}

vtkDataArray* ArrayOf(vtkPolyData* data, const char* name)
{
  return data->GetPointData()->GetArray(name);
}

glm::dvec3 VectorAt(vtkDataArray* array, vtkIdType i)
{
  glm::dvec3 v;
  array->GetTuple(i, &v.x);
  return v;
}

} // namespace

TEST(PrincipalCurvature, ArraysOfATorus)
{
  const ink::test::MeshWithCurvature torus = ink::test::closedTorus(1.0, 0.4, 90, 45);
  vtkNew<vtkInkPrincipalCurvature> filter;
  filter->SetInputData(PolyDataOf(torus.mesh));
  filter->ComputeMeanCurvatureOn();
  filter->ComputeGaussCurvatureOn();
  filter->ComputeUmbilicMeasureOn();
  filter->ComputeSourceOn();
  filter->ComputeDerivativeOn();
  filter->SetOutputArraysPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  ASSERT_EQ(output->GetNumberOfPolys(), 2 * 90 * 45);
  ASSERT_EQ(output->GetPointData()->GetNumberOfArrays(), 9);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const ink::PrincipalCurvature& exact = torus.exact[static_cast<std::size_t>(i)];
    const double k1 = ArrayOf(output, "k1")->GetTuple1(i);
    const double k2 = ArrayOf(output, "k2")->GetTuple1(i);
    const glm::dvec3 d1 = VectorAt(ArrayOf(output, "PrincipalDirection1"), i);
    const glm::dvec3 d2 = VectorAt(ArrayOf(output, "PrincipalDirection2"), i);
    ASSERT_NEAR(k1, exact.k1, 0.03 * 2.5) << i;
    ASSERT_NEAR(k2, exact.k2, 0.03 * 2.5) << i;
    ASSERT_GT(std::abs(glm::dot(d1, exact.direction1)), 0.9999) << i;
    ASSERT_NEAR(glm::length(d1), 1.0, 1e-12) << i;
    ASSERT_NEAR(glm::length(d2), 1.0, 1e-12) << i;
    ASSERT_NEAR(glm::dot(d1, d2), 0.0, 1e-12) << i;
    ASSERT_DOUBLE_EQ(ArrayOf(output, "MeanCurvature")->GetTuple1(i), 0.5 * (k1 + k2)) << i;
    ASSERT_DOUBLE_EQ(ArrayOf(output, "GaussCurvature")->GetTuple1(i), k1 * k2) << i;
    ASSERT_NEAR(ArrayOf(output, "UmbilicMeasure")->GetTuple1(i), exact.umbilicMeasure(), 0.05) << i;
    ASSERT_EQ(ArrayOf(output, "CurvatureSource")->GetTuple1(i), vtkInkPrincipalCurvature::SURFACE) << i;
  }
  EXPECT_EQ(ArrayOf(output, "CurvatureDerivative")->GetNumberOfComponents(), 4);
}

TEST(PrincipalCurvature, WhatIsNotAskedForIsNotMade)
{
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkInkPrincipalCurvature> filter;
  filter->SetInputConnection(sphere->GetOutputPort());
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  // The sphere's normals and four more.
  EXPECT_EQ(output->GetPointData()->GetNumberOfArrays(), 5);
  EXPECT_TRUE(vtkFloatArray::SafeDownCast(ArrayOf(output, "k1")));
}

TEST(PrincipalCurvature, NormalsSayWhereOutsideIs)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(2.0);
  sphere->SetThetaResolution(60);
  sphere->SetPhiResolution(60);
  sphere->Update();
  vtkNew<vtkPolyData> inside;
  inside->DeepCopy(sphere->GetOutput());
  vtkDataArray* normals = inside->GetPointData()->GetNormals();
  for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      normals->SetComponent(i, c, -normals->GetComponent(i, c));
    }
  }
  vtkNew<vtkInkPrincipalCurvature> filter;
  filter->SetInputData(sphere->GetOutput());
  filter->Update();
  // Not at the poles, where the triangles are slivers.
  const vtkIdType middle = sphere->GetOutput()->GetNumberOfPoints() / 2;
  EXPECT_NEAR(ArrayOf(filter->GetOutput(), "k1")->GetTuple1(middle), 0.5, 0.005);
  EXPECT_NEAR(ArrayOf(filter->GetOutput(), "k2")->GetTuple1(middle), 0.5, 0.005);
  filter->SetInputData(inside);
  filter->Update();
  EXPECT_NEAR(ArrayOf(filter->GetOutput(), "k1")->GetTuple1(middle), -0.5, 0.005);
  EXPECT_NEAR(ArrayOf(filter->GetOutput(), "k2")->GetTuple1(middle), -0.5, 0.005);
}

TEST(PrincipalCurvature, OfTheLevelSetsOfAnImage)
{
  // The denser side is inside, so that normals point out of the ellipsoid, as those of the mesh do.
  const glm::dvec3 radii(1.0, 0.7, 0.5);
  const ink::test::MeshWithCurvature exact = ink::test::ellipsoid(radii, 3);
  vtkNew<vtkImageData> image;
  image->SetDimensions(61, 61, 61);
  image->SetOrigin(-1.2, -1.2, -1.2);
  image->SetSpacing(0.04, 0.04, 0.04);
  InkTestFill(image, VTK_FLOAT,
    [&](double x, double y, double z) {
      return ink::test::EllipsoidField{ radii }.value({ x, y, z });
    });
  vtkNew<vtkPolyData> points;
  points->SetPoints(PolyDataOf(exact.mesh)->GetPoints());
  vtkNew<vtkInkPrincipalCurvature> filter;
  filter->SetInputData(points);
  filter->SetFieldData(image);
  filter->SetFieldSmoothing(0.0);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  ASSERT_EQ(output->GetNumberOfPoints(), static_cast<vtkIdType>(exact.exact.size()));
  std::vector<ink::PrincipalCurvature> found;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    found.push_back({ ArrayOf(output, "k1")->GetTuple1(i), ArrayOf(output, "k2")->GetTuple1(i),
      VectorAt(ArrayOf(output, "PrincipalDirection1"), i),
      VectorAt(ArrayOf(output, "PrincipalDirection2"), i) });
  }
  // Differences of a quadratic are exact; what is left is the rounding of floats, over squared spacings.
  const ink::test::CurvatureErrors errors = ink::test::curvatureErrors(exact.exact, found);
  EXPECT_LT(errors.curvature, 2e-3);
  EXPECT_LT(errors.angle, 0.2);
}

TEST(PrincipalCurvature, DerivativesOfAnImage)
{
  const double radius = 1.0;
  const double tube = 0.4;
  const ink::test::MeshWithCurvature torus = ink::test::closedTorus(radius, tube, 40, 30);
  vtkNew<vtkImageData> image;
  image->SetDimensions(81, 81, 81);
  image->SetOrigin(-1.6, -1.6, -1.6);
  image->SetSpacing(0.04, 0.04, 0.04);
  InkTestFill(image, VTK_DOUBLE,
    [&](double x, double y, double z) {
      return -ink::testing::Torus{ radius, tube }.value({ x, y, z });
    });
  vtkNew<vtkPolyData> points;
  points->SetPoints(PolyDataOf(torus.mesh)->GetPoints());
  points->GetPoints()->InsertNextPoint(5.0, 0.0, 0.0); // outside the image
  vtkNew<vtkInkPrincipalCurvature> filter;
  filter->SetInputData(points);
  filter->SetFieldData(image);
  filter->SetFieldSmoothing(0.0);
  filter->SetEstimatorToExponentialMap(); // does not matter
  filter->ComputeDerivativeOn();
  filter->Update();
  vtkDataArray* found = ArrayOf(filter->GetOutput(), "CurvatureDerivative");
  ASSERT_TRUE(found);
  ASSERT_EQ(found->GetNumberOfComponents(), 4);
  for (std::size_t i = 0; i < torus.exact.size(); ++i)
  {
    // Along direction 1, around the tube, only k2 changes.
    const glm::dvec3& p = torus.mesh.points[i];
    const double out = std::hypot(p.x, p.y);
    const double exact = radius * torus.exact[i].normal().z / (out * out) / tube;
    const auto row = static_cast<vtkIdType>(i);
    ASSERT_NEAR(std::abs(found->GetComponent(row, 2)), std::abs(exact), 0.15) << i;
    ASSERT_NEAR(found->GetComponent(row, 0), 0.0, 0.15) << i;
    ASSERT_NEAR(found->GetComponent(row, 1), 0.0, 0.15) << i;
    ASSERT_NEAR(found->GetComponent(row, 3), 0.0, 0.15) << i;
  }
  EXPECT_EQ(found->GetComponent(found->GetNumberOfTuples() - 1, 2), 0.0);
}

TEST(PrincipalCurvature, TheFieldsArrayAndItsSmoothing)
{
  // A ball of radius 1 as another array than the active one, with noise of a twentieth of a voxel.
  vtkNew<vtkImageData> image;
  image->SetDimensions(41, 41, 41);
  image->SetOrigin(-2.0, -2.0, -2.0);
  image->SetSpacing(0.1, 0.1, 0.1);
  std::uint64_t index = 0;
  InkTestFill(image, VTK_FLOAT,
    [&](double x, double y, double z)
    { return 1.0 - glm::length(glm::dvec3(x, y, z)) + 0.005 * ink::testing::hashNormal(1, index++); });
  vtkDataArray* ball = image->GetPointData()->GetScalars();
  vtkNew<vtkFloatArray> flat;
  flat->SetName("Flat");
  flat->SetNumberOfTuples(image->GetNumberOfPoints());
  flat->Fill(1.0);
  image->GetPointData()->AddArray(flat);
  image->GetPointData()->SetActiveScalars("Flat");
  ASSERT_STREQ(ball->GetName(), "Density");
  vtkNew<vtkPoints> positions;
  const ink::test::Mesh sphere = ink::test::icosphere(2);
  for (const glm::dvec3& p : sphere.points)
  {
    positions->InsertNextPoint(&p.x);
  }
  vtkNew<vtkPolyData> points;
  points->SetPoints(positions);
  vtkNew<vtkInkPrincipalCurvature> filter;
  EXPECT_EQ(filter->GetFieldSmoothing(), 2.0);
  filter->SetInputData(points);
  filter->SetFieldData(image);
  const auto error = [&]
  {
    filter->Update();
    vtkDataArray* k1 = ArrayOf(filter->GetOutput(), "k1");
    vtkDataArray* k2 = ArrayOf(filter->GetOutput(), "k2");
    double sum = 0.0;
    for (vtkIdType i = 0; i < k1->GetNumberOfTuples(); ++i)
    {
      sum += std::pow(k1->GetTuple1(i) - 1.0, 2) + std::pow(k2->GetTuple1(i) - 1.0, 2);
    }
    return std::sqrt(0.5 * sum / k1->GetNumberOfTuples());
  };
  filter->SetFieldArray("Density");
  EXPECT_LT(error(), 0.1);
  filter->SetFieldSmoothing(0.0);
  EXPECT_GT(error(), 0.3);
  filter->SetInputArrayToProcess(0, 1, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Density");
  filter->SetFieldSmoothing(2.0);
  EXPECT_LT(error(), 0.1);
  // Without a name the active scalars, which have no gradient anywhere.
  filter->SetFieldArray("");
  vtkNew<InkTestMessages> messages;
  messages->Observe(filter);
  EXPECT_EQ(error(), 1.0);
  messages->Expect("constant", { "None of the input's" });
}

TEST(PrincipalCurvature, PointsJustOutsideTheImageHaveNone)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(9, 9, 9);
  InkTestFill(image, VTK_FLOAT, [](double x, double y, double z) { return x * x + y * y + z * z; });
  vtkNew<vtkPoints> positions;
  positions->InsertNextPoint(8.0, 2.0, 1.0);
  positions->InsertNextPoint(8.0 + 1.0 / 2048.0, 2.0, 1.0);
  vtkNew<vtkPolyData> points;
  points->SetPoints(positions);
  vtkNew<vtkInkPrincipalCurvature> filter;
  filter->SetInputData(points);
  filter->SetFieldData(image);
  filter->ComputeSourceOn();
  filter->Update();
  vtkDataArray* source = ArrayOf(filter->GetOutput(), "CurvatureSource");
  EXPECT_EQ(source->GetTuple1(0), vtkInkPrincipalCurvature::SURFACE);
  EXPECT_EQ(source->GetTuple1(1), vtkInkPrincipalCurvature::NONE);
}

TEST(PrincipalCurvature, GhostCellsAreNeighbors)
{
  // A torus of which half the cells are another piece's: points of this piece have the curvature of the
  // whole.
  const ink::test::MeshWithCurvature torus = ink::test::closedTorus(1.0, 0.4, 40, 20);
  const vtkSmartPointer<vtkPolyData> whole = PolyDataOf(torus.mesh);
  vtkNew<vtkPolyData> piece;
  piece->ShallowCopy(whole);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  for (vtkIdType cell = 0; cell < whole->GetNumberOfCells(); ++cell)
  {
    ghosts->InsertNextValue(cell % 80 < 40 ? vtkDataSetAttributes::DUPLICATECELL : 0);
  }
  piece->GetCellData()->AddArray(ghosts);
  vtkNew<vtkInkPrincipalCurvature> filter;
  filter->SetInputData(whole);
  filter->Update();
  vtkNew<vtkPolyData> expected;
  expected->ShallowCopy(filter->GetOutput());
  filter->SetInputData(piece);
  filter->Update();
  for (vtkIdType i = 0; i < expected->GetNumberOfPoints(); ++i)
  {
    ASSERT_EQ(ArrayOf(filter->GetOutput(), "k1")->GetTuple1(i), ArrayOf(expected, "k1")->GetTuple1(i)) << i;
  }
  EXPECT_TRUE(filter->GetOutput()->GetCellGhostArray()->GetValue(0));
}

TEST(PrincipalCurvature, StripsAndPolygonsAreSurfaces)
{
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 36; ++i)
  {
    // A cylinder of radius 2 around the y axis.
    const double angle = 0.05 * (i % 6);
    points->InsertNextPoint(2.0 * std::sin(angle), 0.1 * (i / 6), 2.0 * std::cos(angle));
  }
  vtkNew<vtkCellArray> quads;
  vtkNew<vtkCellArray> strips;
  for (vtkIdType row = 0; row < 5; ++row)
  {
    for (vtkIdType column = 0; column < 5 && row < 3; ++column)
    {
      const vtkIdType a = 6 * row + column;
      quads->InsertNextCell({ a, a + 1, a + 7, a + 6 });
    }
    if (row >= 3)
    {
      strips->InsertNextCell(12);
      for (vtkIdType column = 0; column < 6; ++column)
      {
        strips->InsertCellPoint(6 * (row + 1) + column);
        strips->InsertCellPoint(6 * row + column);
      }
    }
  }
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(points);
  mesh->SetPolys(quads);
  mesh->SetStrips(strips);
  vtkNew<vtkInkPrincipalCurvature> filter;
  filter->SetInputData(mesh);
  filter->Update();
  for (vtkIdType i = 0; i < 36; ++i)
  {
    EXPECT_NEAR(ArrayOf(filter->GetOutput(), "k1")->GetTuple1(i), 0.5, 0.04) << i;
    EXPECT_NEAR(ArrayOf(filter->GetOutput(), "k2")->GetTuple1(i), 0.0, 0.04) << i;
    EXPECT_NEAR(std::abs(VectorAt(ArrayOf(filter->GetOutput(), "PrincipalDirection2"), i).y), 1.0, 1e-3) << i;
  }
}

/// The sides of a box are flat up to its edges, and a cylinder's bends up to its caps.
TEST(PrincipalCurvature, SharpEdgesEndNeighborhoods)
{
  vtkNew<vtkInkPrincipalCurvature> filter;
  filter->SetOutputArraysPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  filter->ComputeSourceOn();
  EXPECT_EQ(filter->GetFeatureAngle(), 180.0);
  const auto update = [&](const ink::test::Mesh& mesh, double angle)
  {
    filter->SetInputData(PolyDataOf(mesh));
    filter->SetFeatureAngle(angle);
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), static_cast<vtkIdType>(mesh.points.size()));
    return filter->GetOutput();
  };
  const auto most = [](vtkPolyData* output)
  {
    const double* range = ArrayOf(output, "k1")->GetRange();
    const double largest = std::max(std::abs(range[0]), std::abs(range[1]));
    range = ArrayOf(output, "k2")->GetRange();
    return std::max({ largest, std::abs(range[0]), std::abs(range[1]) });
  };
  for (const bool welded : { false, true })
  {
    const ink::test::Mesh box = ink::test::box({ 3.0, 2.0, 1.0 }, 6, welded);
    EXPECT_GT(most(update(box, 180.0)), 1.0);
    EXPECT_LT(most(update(box, 40.0)), 1e-9);
    EXPECT_GT(most(update(box, 95.0)), 1.0) << "edges of 90 degrees are none then";
    const ink::test::Mesh drum = ink::test::cylinder(48, 12, 2.0, welded);
    vtkPolyData* output = update(drum, 40.0);
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      const glm::dvec3& p = drum.points[static_cast<std::size_t>(i)];
      const bool isOfCap = std::abs(ArrayOf(output, "k1")->GetTuple1(i)) < 1e-9;
      const bool isOnRim = p.z < 1e-9 || p.z > 2.0 - 1e-9;
      ASSERT_TRUE(isOnRim || !isOfCap) << i;
      if (!isOfCap)
      {
        ASSERT_NEAR(ArrayOf(output, "k1")->GetTuple1(i), 1.0, 0.05) << i;
        ASSERT_NEAR(ArrayOf(output, "k2")->GetTuple1(i), 0.0, 0.05) << i;
      }
      ASSERT_EQ(ArrayOf(output, "CurvatureSource")->GetTuple1(i),
        isOnRim ? vtkInkPrincipalCurvature::BORDER : vtkInkPrincipalCurvature::SURFACE)
        << i;
    }
  }
  // A surface without edges is as it is with any angle, and so is what no triangle uses.
  ink::test::MeshWithCurvature torus = ink::test::closedTorus(1.0, 0.4, 60, 30);
  torus.mesh.points.emplace_back(5.0);
  vtkNew<vtkDoubleArray> before;
  before->DeepCopy(ArrayOf(update(torus.mesh, 180.0), "k1"));
  vtkPolyData* after = update(torus.mesh, 40.0);
  for (vtkIdType i = 0; i < before->GetNumberOfTuples(); ++i)
  {
    ASSERT_NEAR(ArrayOf(after, "k1")->GetTuple1(i), before->GetTuple1(i), 1e-7) << i;
  }
  EXPECT_EQ(ArrayOf(after, "CurvatureSource")->GetTuple1(before->GetNumberOfTuples() - 1),
    vtkInkPrincipalCurvature::NONE);
}
