// SPDX-License-Identifier: BSD-3-Clause
// Memory of filters: where there is none, one error and an empty output, and the next run works; where there
// is, outputs hold about what their points need.

#include "InkTestMemoryLimit.h"
#include "InkTestMessages.h"
#include "InkTestVolume.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInkGradient.h"
#include "vtkInkIsoSurfaceSampler.h"
#include "vtkInkPointPriority.h"
#include "vtkInkStippleGenerator.h"
#include "vtkInkSurfaceSampler.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <string>

namespace
{

/// A ball of some radius in the middle of n^3 samples: 0 on its surface, positive within.
vtkSmartPointer<vtkImageData> Ball(int n, double radius)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(n, n, n);
  image->SetOrigin(-0.5 * n, -0.5 * n, -0.5 * n);
  InkTestFill(image, VTK_FLOAT,
    [=](double x, double y, double z) { return radius - std::sqrt(x * x + y * y + z * z); });
  return image;
}

vtkSmartPointer<vtkPolyData> Sphere(int resolution)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(resolution);
  sphere->SetPhiResolution(resolution);
  sphere->Update();
  return sphere->GetOutput();
}

/// The filter's input is `small` first, which works, then `large`, for which there is not enough memory, and
/// then `small` again.
template <class Filter>
void CheckNoMemory(Filter* filter, vtkDataObject* small, vtkDataObject* large)
{
  const std::string name = filter->GetClassName();
  filter->SetInputDataObject(small);
  filter->Update();
  const vtkIdType count = filter->GetOutput()->GetNumberOfPoints();
  EXPECT_GT(count, 0) << name << ": a result with memory";
  vtkNew<InkTestMessages> messages;
  messages->Observe(filter);
  filter->SetInputDataObject(large);
  bool limited = false;
  {
    const InkTestMemoryLimit limit(1 << 20);
    limited = limit.IsSet();
    filter->Update();
  }
  EXPECT_TRUE(limited) << name << ": a limit to memory";
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0) << name << ": an empty output";
  messages->Expect(name, { "there is not enough memory" });
  filter->SetInputDataObject(small);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), count)
    << name << ": as many points as before, found " << filter->GetOutput()->GetNumberOfPoints();
}

/// What the points, their arrays and their one cell take, in bytes.
double NeededBy(vtkPolyData* points)
{
  double bytes = 0.0;
  const auto add = [&](vtkDataArray* array)
  { bytes += static_cast<double>(array->GetNumberOfValues()) * array->GetDataTypeSize(); };
  add(points->GetPoints()->GetData());
  for (int n = 0; n < points->GetPointData()->GetNumberOfArrays(); ++n)
  {
    add(points->GetPointData()->GetArray(n));
  }
  add(points->GetVerts()->GetConnectivityArray());
  return bytes;
}

void CheckSize(const std::string& name, vtkPolyData* points)
{
  const double needed = NeededBy(points);
  const double held = 1024.0 * static_cast<double>(points->GetActualMemorySize());
  constexpr double rest = 16 * 1024;
  EXPECT_GT(points->GetNumberOfPoints(), 1000) << name << ": points";
  EXPECT_LE(held, 1.3 * needed + rest)
    << name << ": " << needed << " bytes for " << points->GetNumberOfPoints() << " points, found " << held;
}

} // namespace

TEST(FilterMemory, OneErrorWhereThereIsNotEnough)
{
  if (!InkTestCanLimitMemory)
  {
    GTEST_SKIP() << "the sanitizers' memory is not limited";
  }
  // A new thread needs memory, too.
  setenv("VTK_SMP_MAX_THREADS", "1", 1);
  const auto small = Ball(16, 5.0);
  const auto large = Ball(128, 50.0);
  vtkNew<vtkInkIsoSurfaceSampler> sampler;
  sampler->SetValue(0, 0.0);
  CheckNoMemory(sampler.Get(), small, large);
  vtkNew<vtkInkGradient> gradient;
  CheckNoMemory(gradient.Get(), small, large);
  vtkNew<vtkInkStippleGenerator> generator;
  CheckNoMemory(generator.Get(), small, large);
  const auto coarse = Sphere(20);
  const auto fine = Sphere(400);
  vtkNew<vtkInkPointPriority> priority;
  CheckNoMemory(priority.Get(), coarse, fine);
  vtkNew<vtkInkSurfaceSampler> mesh;
  CheckNoMemory(mesh.Get(), coarse, fine);
}

TEST(FilterMemory, OutputsHoldWhatTheirPointsNeed)
{
  vtkNew<vtkInkIsoSurfaceSampler> sampler;
  sampler->SetInputData(Ball(128, 30.0));
  for (const double value : { 0.0, -20.0, -20.5, 15.0 })
  {
    sampler->SetNumberOfContours(1);
    sampler->SetValue(0, value);
    sampler->Update();
    CheckSize("iso-value " + std::to_string(value), sampler->GetOutput());
  }
  sampler->SetValue(1, -10.0);
  sampler->Update();
  CheckSize("two iso-values", sampler->GetOutput());

  vtkNew<vtkInkSurfaceSampler> mesh;
  mesh->SetInputData(Sphere(40));
  for (const int count : { 40'000, 30'000 })
  {
    mesh->SetNumberOfSamples(count);
    mesh->Update();
    CheckSize("a mesh", mesh->GetOutput());
  }
  vtkNew<vtkInkPointPriority> priority;
  priority->SetInputData(Sphere(60));
  priority->Update();
  CheckSize("points in order", priority->GetOutput());
}
