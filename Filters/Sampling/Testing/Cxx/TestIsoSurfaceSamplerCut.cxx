// SPDX-License-Identifier: BSD-3-Clause
// Rims of surfaces that leave the image, as arrays and with stipples. Where they lie: TestCutSamples.

#include "SamplerTestImages.h"

#include "IsoSurface/CutSamples.h"

#include "vtkInkIsoSurfaceSampler.h"
#include "vtkInkStippleGenerator.h"
#include "vtkMath.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

constexpr double BallRadius = 14.3;

/// Half a ball, which leaves the image below.
vtkSmartPointer<vtkInkIsoSurfaceSampler> CutBall(int cut)
{
  const auto image = MakeImage(VTK_FLOAT, { -20, 20, -20, 20, 0, 20 },
    [](double x, double y, double z) { return BallDensity(x, y, z, BallRadius); });
  auto sampler = vtkSmartPointer<vtkInkIsoSurfaceSampler>::New();
  sampler->SetInputData(image);
  sampler->SetValue(0, 100.0);
  sampler->SetCut(cut);
  return sampler;
}

} // namespace

TEST(IsoSurfaceSamplerCut, InnerNormalsOfARimHaveHalfTheRadius)
{
  const auto open = CutBall(vtkInkIsoSurfaceSampler::OPEN);
  open->Update();
  const vtkIdType surface = open->GetOutput()->GetNumberOfPoints();
  for (const int precision : { vtkAlgorithm::SINGLE_PRECISION, vtkAlgorithm::DOUBLE_PRECISION })
  {
    const auto sampler = CutBall(vtkInkIsoSurfaceSampler::RIM);
    sampler->SetOutputPointsPrecision(precision);
    // Again with arrays that are kept.
    for (const double value : { 80.0, 100.0 })
    {
      sampler->SetValue(0, value);
      sampler->Update();
    }
    vtkPolyData* points = sampler->GetOutput();
    vtkDataArray* radii = points->GetPointData()->GetArray("Radius");
    ASSERT_GT(points->GetNumberOfPoints(), surface + 50 * ink::rimNormals);
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      const bool inner = i >= surface && (i - surface) % ink::rimNormals >= ink::rimOuterNormals;
      ASSERT_NEAR(radii->GetTuple1(i), (inner ? 0.5 : 1.0) * std::sqrt(0.75), 1e-6) << i;
    }
  }
}

TEST(IsoSurfaceSamplerCut, HasNoStipplesOnItsRim)
{
  const auto farthest = [](int cut)
  {
    const auto sampler = CutBall(cut);
    vtkNew<vtkInkStippleGenerator> generator;
    generator->SetInputConnection(sampler->GetOutputPort());
    generator->SetNumberOfSurfaceStipples(20000);
    generator->Update();
    double most = 0.0;
    for (vtkIdType i = 0; i < generator->GetOutput()->GetNumberOfPoints(); ++i)
    {
      double p[3];
      generator->GetOutput()->GetPoint(i, p);
      most = std::max(most, vtkMath::Norm(p));
    }
    return most;
  };
  EXPECT_LT(farthest(vtkInkIsoSurfaceSampler::RIM), BallRadius + 0.1);
  EXPECT_EQ(farthest(vtkInkIsoSurfaceSampler::RIM), farthest(vtkInkIsoSurfaceSampler::OPEN));
}
