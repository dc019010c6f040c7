// SPDX-License-Identifier: BSD-3-Clause
// vtkInkPointPriority: an order with all arrays carried along, for iso-surface points and for raw point
// clouds.

#include "InkTestMessages.h"
#include "SamplerTestImages.h"
#include "SamplerTestMeshes.h"

#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInkIsoSurfaceSampler.h"
#include "vtkInkPointPriority.h"
#include "vtkInkSurfaceSampler.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace
{

template <class Filter>
class PointFilters : public testing::Test
{
};
using Filters = testing::Types<vtkInkPointPriority, vtkInkSurfaceSampler>;
TYPED_TEST_SUITE(PointFilters, Filters);

} // namespace

TEST(PointPriority, IsBlueNoiseOnAnIsoSurface)
{
  auto image = MakeImage(VTK_FLOAT, { -20, 20, -20, 20, -20, 20 },
    [](double x, double y, double z) { return BallDensity(x, y, z, 15.0); });
  vtkNew<vtkInkIsoSurfaceSampler> sampler;
  sampler->SetInputData(image);
  sampler->SetValue(0, 100.0);
  sampler->Update();
  vtkNew<vtkPolyData> numbered;
  numbered->ShallowCopy(sampler->GetOutput());
  const vtkIdType count = numbered->GetNumberOfPoints();
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("Id");
  for (vtkIdType i = 0; i < count; ++i)
  {
    ids->InsertNextValue(i);
  }
  numbered->GetPointData()->AddArray(ids);

  vtkNew<vtkInkPointPriority> order;
  order->SetInputData(numbered);
  order->Update();
  vtkPolyData* output = order->GetOutput();
  vtkPointData* data = output->GetPointData();
  ASSERT_TRUE(count > 1000 && output->GetNumberOfPoints() == count && data->GetNormals() &&
    data->GetArray("Radius") && data->GetArray("Priority") && data->GetArray("Id"))
    << "all points with all arrays";
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i);
    const auto kibibytes =
      static_cast<unsigned long>(array->GetNumberOfValues() * array->GetDataTypeSize() / 1024);
    EXPECT_LE(array->GetActualMemorySize(), kibibytes + 1)
      << array->GetName() << " has memory for its values only: " << array->GetActualMemorySize() << " KiB";
  }
  std::vector<bool> seen(static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    const auto id = static_cast<vtkIdType>(data->GetArray("Id")->GetComponent(i, 0));
    seen[static_cast<std::size_t>(id)] = true;
    double a[3];
    double b[3];
    double m[3];
    double n[3];
    output->GetPoint(i, a);
    numbered->GetPoint(id, b);
    data->GetNormals()->GetTuple(i, m);
    numbered->GetPointData()->GetNormals()->GetTuple(id, n);
    ASSERT_TRUE(std::equal(a, a + 3, b) && std::equal(m, m + 3, n))
      << "point " << i << " with its own normal";
  }
  EXPECT_EQ(std::find(seen.begin(), seen.end(), false), seen.end()) << "each point once";
  const double area = 4.0 * std::acos(-1.0) * 15.0 * 15.0;
  for (const double share : { 0.05, 0.25 })
  {
    const auto some = static_cast<vtkIdType>(share * static_cast<double>(count));
    const double ratio = LeastDistance(output, some) / HexagonalDistance(area, some);
    EXPECT_GT(ratio, 0.5) << "the first " << some << " are blue noise: " << ratio << ", before "
                          << LeastDistance(numbered, some) / HexagonalDistance(area, some);
  }
}

/// Points without normals get them, by either filter.
TYPED_TEST(PointFilters, OrientsPointsWithoutNormals)
{
  vtkNew<vtkInkSurfaceSampler> sampler;
  sampler->SetInputData(MakeBall(40, 3.0, { 1e7, -1e7, 5.0 }, VTK_DOUBLE));
  sampler->SetNumberOfSamples(2500);
  sampler->Update();
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(sampler->GetOutput()->GetPoints());
  vtkSmartPointer<vtkPolyData> outputs[2];
  for (int i = 0; i < 2; ++i)
  {
    setenv("VTK_SMP_MAX_THREADS", i == 0 ? "1" : "2", 1);
    vtkNew<TypeParam> filter;
    filter->SetInputData(cloud);
    filter->Update();
    outputs[i] = filter->GetOutput();
  }
  unsetenv("VTK_SMP_MAX_THREADS");
  EXPECT_TRUE(AreEqual(outputs[0], outputs[1])) << "the same on one and two threads";
  vtkPolyData* output = outputs[0];
  vtkDataArray* normals = output->GetPointData()->GetNormals();
  vtkDataArray* radius = output->GetPointData()->GetArray("Radius");
  ASSERT_TRUE(
    output->GetNumberOfPoints() == 2500 && normals && radius && output->GetPointData()->GetArray("Priority"))
    << "points with normals, radius and priority";
  const double spacing = std::sqrt(4.0 * std::acos(-1.0) * 9.0 / 2500.0);
  EXPECT_TRUE(radius->GetComponent(0, 0) > 0.8 * spacing && radius->GetComponent(0, 0) < 2.0 * spacing)
    << "a radius like the spacing " << spacing << ", found " << radius->GetComponent(0, 0);
  for (vtkIdType i = 0; i < 2500; ++i)
  {
    double p[3];
    double n[3];
    output->GetPoint(i, p);
    normals->GetTuple(i, n);
    const double out = ((p[0] - 1e7) * n[0] + (p[1] + 1e7) * n[1] + (p[2] - 5.0) * n[2]) / 3.0;
    ASSERT_GT(out, 0.98) << "normal " << i << " outwards";
  }
}

/// What vtkGhostType marks as hidden or duplicate counts for nothing and is left out.
TYPED_TEST(PointFilters, LeavesGhostsOut)
{
  vtkNew<vtkInkSurfaceSampler> sampler;
  sampler->SetInputData(MakeBall(40, 3.0, { 0.0, 0.0, 0.0 }, VTK_DOUBLE));
  sampler->SetNumberOfSamples(1000);
  sampler->Update();
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(sampler->GetOutput()->GetPoints());
  vtkNew<vtkPolyData> marked;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
  {
    double p[3];
    cloud->GetPoint(i, p);
    points->InsertNextPoint(p);
    ghosts->InsertNextValue(0);
    // Around the ball, and right beside its points.
    points->InsertNextPoint(5.0 * p[0], 5.0 * p[1], 5.0 * p[2]);
    ghosts->InsertNextValue(vtkDataSetAttributes::HIDDENPOINT);
    points->InsertNextPoint(1.01 * p[0], 0.99 * p[1], p[2]);
    ghosts->InsertNextValue(vtkDataSetAttributes::DUPLICATEPOINT);
  }
  marked->SetPoints(points);
  marked->GetPointData()->AddArray(ghosts);
  vtkNew<TypeParam> filter;
  filter->SetInputData(cloud);
  filter->Update();
  vtkNew<TypeParam> other;
  other->SetInputData(marked);
  other->Update();
  EXPECT_TRUE(
    filter->GetOutput()->GetNumberOfPoints() == 1000 && AreEqual(filter->GetOutput(), other->GetOutput()))
    << "the same with ghosts as without, " << other->GetOutput()->GetNumberOfPoints() << " points";
  ghosts->Fill(vtkDataSetAttributes::HIDDENPOINT);
  marked->Modified();
  other->Update();
  EXPECT_EQ(other->GetOutput()->GetNumberOfPoints(), 0) << "nothing of ghosts only";
}

TEST(PointPriority, PutsWhatIsNotFiniteLastAndRefusesBadRadii)
{
  vtkNew<vtkPolyData> cloud;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0, 0, 0);
  points->InsertNextPoint(1, 0, 0);
  points->InsertNextPoint(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  cloud->SetPoints(points);
  vtkNew<vtkInkPointPriority> order;
  vtkNew<InkTestMessages> messages;
  messages->Observe(order);
  order->SetInputData(cloud);
  order->Update();
  EXPECT_TRUE(order->GetOutput()->GetNumberOfPoints() == 3 &&
    std::isnan(order->GetOutput()->GetPoint(2)[0]) && messages->Messages.empty())
    << "what is not finite comes last";
  vtkNew<vtkFloatArray> radius;
  radius->SetName("Radius");
  radius->SetNumberOfComponents(2);
  radius->SetNumberOfTuples(3);
  radius->Fill(1.0);
  cloud->GetPointData()->AddArray(radius);
  order->Modified();
  order->Update();
  EXPECT_TRUE(order->GetOutput()->GetNumberOfPoints() == 0 && messages->Messages.size() == 1 &&
    messages->Messages[0].find("Radius has 3 values of 2 components") != std::string::npos)
    << "one message on a radius of two components";
  vtkNew<vtkPolyData> nothing;
  order->SetInputData(nothing);
  order->Update();
  EXPECT_TRUE(order->GetOutput()->GetNumberOfPoints() == 0 && messages->Messages.size() == 1)
    << "nothing of nothing";
}
