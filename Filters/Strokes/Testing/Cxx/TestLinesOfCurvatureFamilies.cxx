// SPDX-License-Identifier: BSD-3-Clause
// Which way the families of lines go on waves and boxes.

#include "MachineParts.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkInkLinesOfCurvature.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTriangleFilter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace
{

/// Waves along x: bent across in the crests, the other way in the troughs, straight along y.
vtkSmartPointer<vtkPolyData> Waves()
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-1.0, -1.0, 0.0);
  plane->SetPoint1(1.0, -1.0, 0.0);
  plane->SetPoint2(-1.0, 1.0, 0.0);
  plane->SetResolution(100, 60);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(plane->GetOutputPort());
  triangles->Update();
  vtkSmartPointer<vtkPolyData> waves = triangles->GetOutput();
  waves->GetPointData()->Initialize();
  for (vtkIdType i = 0; i < waves->GetNumberOfPoints(); ++i)
  {
    double p[3];
    waves->GetPoint(i, p);
    waves->GetPoints()->SetPoint(i, p[0], p[1], 0.1 * std::sin(6.0 * p[0]));
  }
  return waves;
}

/// Of the length of lines, the share that goes across the waves.
double ShareAcross(vtkPolyData* lines)
{
  double across = 0.0;
  double along = 0.0;
  vtkNew<vtkIdList> points;
  for (vtkIdType line = 0; line < lines->GetNumberOfLines(); ++line)
  {
    lines->GetCellPoints(line, points);
    for (vtkIdType i = 1; i < points->GetNumberOfIds(); ++i)
    {
      double p[3];
      double q[3];
      lines->GetPoint(points->GetId(i - 1), p);
      lines->GetPoint(points->GetId(i), q);
      across += std::hypot(q[0] - p[0], q[2] - p[2]);
      along += std::abs(q[1] - p[1]);
    }
  }
  return across / (across + along);
}

/// A box of 12 triangles without normals; faces share their points.
vtkSmartPointer<vtkPolyData> Box()
{
  const ink::test::Mesh box = ink::test::box({ 1.6, 1.0, 0.7 }, 1, true);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const glm::dvec3& p : box.points)
  {
    points->InsertNextPoint(&p.x);
  }
  vtkNew<vtkCellArray> triangles;
  for (const auto& [a, b, c] : box.triangles)
  {
    triangles->InsertNextCell({ a, b, c });
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(triangles);
  return mesh;
}

} // namespace

/// Families by the sign of curvatures are blocks at right angles to each other; combed, the first one bends.
TEST(LinesOfCurvatureFamilies, CombedFamiliesGoOn)
{
  vtkNew<vtkInkLinesOfCurvature> filter;
  filter->SetInputData(Waves());
  filter->SetSpacing(0.05);
  filter->Update();
  EXPECT_LT(ShareAcross(filter->GetOutput()), 0.92) << "by sign";
  filter->CombDirectionsOn();
  filter->Update();
  EXPECT_GT(ShareAcross(filter->GetOutput()), 0.95);
  filter->SetFamiliesToMinimum();
  filter->Update();
  EXPECT_LT(ShareAcross(filter->GetOutput()), 0.05);
}

TEST(LinesOfCurvatureFamilies, FacesOfABoxAreHatchedEvenlyAndStraight)
{
  constexpr double spacing = 0.04;
  vtkNew<vtkInkLinesOfCurvature> filter;
  filter->SetInputData(Box());
  filter->SetSpacing(spacing);
  filter->SetFamilies(vtkInkLinesOfCurvature::MAXIMUM);
  filter->SmoothDirectionsOn();
  filter->CombDirectionsOn();
  filter->Update();
  vtkPolyData* lines = filter->GetOutput();
  const double size[3] = { 1.6, 1.0, 0.7 };
  double lengths[3][2][2] = {}; // by axis, side, and half of the face before or behind its diagonal
  for (vtkIdType line = 0; line < lines->GetNumberOfLines(); ++line)
  {
    vtkNew<vtkIdList> ids;
    lines->GetCellPoints(line, ids);
    for (vtkIdType i = 1; i < ids->GetNumberOfIds(); ++i)
    {
      double a[3];
      double b[3];
      lines->GetPoint(ids->GetId(i - 1), a);
      lines->GetPoint(ids->GetId(i), b);
      int axis = 0;
      while (axis < 3 &&
        !(std::abs(a[axis] - b[axis]) < 1e-9 &&
          (std::abs(a[axis]) < 1e-9 || std::abs(a[axis] - size[axis]) < 1e-9)))
      {
        ++axis;
      }
      ASSERT_LT(axis, 3) << "a line crosses an edge";
      const double d[3] = { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
      const double length = std::hypot(d[0], d[1], d[2]);
      // Along the longest side of the face.
      EXPECT_NEAR(std::abs(d[axis == 0 ? 1 : 0]), length, 1e-6);
      const int u = (axis + 1) % 3;
      const int v = (axis + 2) % 3;
      const bool half = (a[u] + b[u]) / size[u] > (a[v] + b[v]) / size[v];
      lengths[axis][a[axis] > 0.5 * size[axis] ? 1 : 0][half ? 1 : 0] += length;
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    const double half = 0.5 * size[(axis + 1) % 3] * size[(axis + 2) % 3];
    for (int side = 0; side < 2; ++side)
    {
      for (int part = 0; part < 2; ++part)
      {
        EXPECT_NEAR(lengths[axis][side][part] * spacing / half, 1.0, 0.2) << axis << side << part;
      }
    }
  }
}
