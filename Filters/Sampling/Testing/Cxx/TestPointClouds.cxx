// SPDX-License-Identifier: BSD-3-Clause
// What vtkInkSurfaceSampler makes of points without polygons: normals, radii of their own, and no isolated
// points.

#include "InkTestMessages.h"
#include "SamplerTestMeshes.h"

#include "vtkInkPointPriority.h"
#include "vtkInkSurfaceSampler.h"

#include "vtkIntArray.h"

#include <gtest/gtest.h>

#include <array>

namespace
{

/// A square of points, to the right of x = 10 only every fourth row and column, and one far above, named by
/// `Id`.
vtkSmartPointer<vtkPolyData> MakeUnevenCloud(bool outlier)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkIntArray> ids;
  ids->SetName("Id");
  for (int y = 0; y <= 40; ++y)
  {
    for (int x = 0; x <= 40; ++x)
    {
      if (x <= 20 || (x % 4 == 0 && y % 4 == 0))
      {
        ids->InsertNextValue(x);
        points->InsertNextPoint(1e6 + 0.5 * x, 0.5 * y, 0.0);
      }
    }
  }
  if (outlier)
  {
    ids->InsertNextValue(-1);
    points->InsertNextPoint(1e6 + 4.0, 4.0, 15.0);
  }
  auto cloud = vtkSmartPointer<vtkPolyData>::New();
  cloud->SetPoints(points);
  cloud->GetPointData()->AddArray(ids);
  return cloud;
}

} // namespace

TEST(PointClouds, RadiiFollowTheSpacing)
{
  for (const bool remove : { true, false })
  {
    vtkNew<vtkInkSurfaceSampler> sampler;
    const auto cloud = MakeUnevenCloud(true);
    sampler->SetInputData(cloud);
    sampler->SetRemoveIsolated(remove);
    sampler->Update();
    vtkPolyData* output = sampler->GetOutput();
    const vtkIdType count = output->GetNumberOfPoints();
    EXPECT_EQ(sampler->GetNumberOfIsolatedPoints(), 1) << "one isolated point";
    EXPECT_EQ(count, cloud->GetNumberOfPoints() - (remove ? 1 : 0)) << "left out if wanted";
    vtkDataArray* radius = output->GetPointData()->GetArray("Radius");
    vtkDataArray* ids = output->GetPointData()->GetArray("Id");
    EXPECT_TRUE(output->GetPointData()->GetArray("Priority") && output->GetPointData()->GetNormals())
      << "all arrays";
    for (vtkIdType i = 0; i < count; ++i)
    {
      const double x = ids->GetComponent(i, 0);
      const double r = radius->GetComponent(i, 0);
      double p[3];
      output->GetPoint(i, p);
      EXPECT_TRUE(x < 0 || p[0] == 1e6 + 0.5 * x) << "arrays stay with their points";
      const double expected = 1.25 * std::sqrt(0.5) * (x <= 20 ? 0.5 : 2.0);
      const bool known = x >= 0 && (x < 16 || x > 26);
      EXPECT_TRUE(!known || std::abs(r - expected) < 0.02 * expected)
        << "radius " << r << " at " << x << ", expected " << expected;
      EXPECT_TRUE(x >= 0 || r == 0.0) << "isolated: radius 0";
    }
  }
}

TEST(PointClouds, HaveOneRadiusWhereAskedTo)
{
  vtkNew<vtkInkSurfaceSampler> sampler;
  sampler->SetInputData(MakeUnevenCloud(true));
  sampler->UniformRadiusOn();
  sampler->Update();
  vtkDataArray* radius = sampler->GetOutput()->GetPointData()->GetArray("Radius");
  double range[2];
  radius->GetRange(range);
  EXPECT_TRUE(range[0] > 0.0 && range[0] == range[1]) << "one radius";
  EXPECT_EQ(sampler->GetNumberOfIsolatedPoints(), 0) << "no isolated points";
}

TEST(PointClouds, NormalsPointTowardsTheViewpoint)
{
  for (const double side : { 1.0, -1.0 })
  {
    vtkNew<vtkInkSurfaceSampler> sampler;
    sampler->SetInputData(MakeUnevenCloud(false));
    sampler->OrientTowardsViewpointOn();
    sampler->SetViewpoint(1e6, 0.0, 3.0 * side);
    sampler->Update();
    double range[2];
    sampler->GetOutput()->GetPointData()->GetNormals()->GetRange(range, 2);
    EXPECT_TRUE(std::abs(range[0] - side) < 1e-5 && std::abs(range[1] - side) < 1e-5)
      << "normals towards " << side;
  }
}

TEST(PointClouds, PriorityKeepsIsolatedPoints)
{
  vtkNew<vtkInkPointPriority> filter;
  const auto cloud = MakeUnevenCloud(true);
  filter->SetInputData(cloud);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), cloud->GetNumberOfPoints()) << "all points stay";
}

TEST(PointClouds, OfFewOrExtremePointsStayWhole)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::vector<std::array<double, 3>>> clouds = { { { 1, 2, 3 } },
    { { 0, 0, 0 }, { 1, 0, 0 } }, std::vector<std::array<double, 3>>(50, { 4, 4, 4 }),
    { { nan, 0, 0 }, { 1, nan, 0 } }, { { -1e300, 0, 0 }, { 1e300, 0, 0 }, { 0, 1e-300, 0 } },
    { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 } } };
  for (const auto& positions : clouds)
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const auto& position : positions)
    {
      points->InsertNextPoint(position.data());
    }
    vtkNew<vtkPolyData> cloud;
    cloud->SetPoints(points);
    vtkNew<vtkInkSurfaceSampler> sampler;
    vtkNew<InkTestMessages> messages;
    messages->Observe(sampler);
    sampler->SetInputData(cloud);
    sampler->Update();
    vtkPolyData* output = sampler->GetOutput();
    EXPECT_TRUE(messages->Messages.empty()) << "no message";
    EXPECT_EQ(output->GetNumberOfPoints(), static_cast<vtkIdType>(positions.size()))
      << "all of few points stay";
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      const double radius = output->GetPointData()->GetArray("Radius")->GetComponent(i, 0);
      EXPECT_TRUE(radius >= 0.0 && std::isfinite(radius)) << "radius " << radius;
    }
  }
}
