// SPDX-License-Identifier: BSD-3-Clause
// Smoothing and Subdivision of vtkInkIsoSurfaceSampler: what they change, and that pieces give the whole.

#include "SamplerTestImages.h"

#include "vtkDoubleArray.h"
#include "vtkInkIsoSurfaceSampler.h"
#include "vtkNew.h"
#include "vtkRTAnalyticSource.h"

#include <gtest/gtest.h>

#include <sstream>

namespace
{

const double IsoValue = 157.0;
const double Radius = 8.0;

double NumberOfPoints(vtkInkIsoSurfaceSampler* sampler)
{
  sampler->Update();
  return static_cast<double>(sampler->GetOutput()->GetNumberOfPoints());
}

double RadiusOf(vtkInkIsoSurfaceSampler* sampler)
{
  return sampler->GetOutput()->GetPointData()->GetArray("Radius")->GetComponent(0, 0);
}

} // namespace

TEST(IsoSurfaceSamplerSmoothing, SubdivisionMakesMoreAndSmallerPoints)
{
  vtkNew<vtkInkIsoSurfaceSampler> sampler;
  sampler->SetInputData(MakeImage(VTK_FLOAT, { -12, 12, -11, 11, -10, 10 },
    [](double x, double y, double z) { return BallDensity(x, y, z, Radius); }));
  sampler->SetValue(0, 100.0);
  const double before = NumberOfPoints(sampler);
  const double radius = RadiusOf(sampler);
  for (const int subdivision : { 2, 3 })
  {
    sampler->SetSubdivision(subdivision);
    EXPECT_NEAR(
      NumberOfPoints(sampler), subdivision * subdivision * before, 0.1 * subdivision * subdivision * before);
    EXPECT_NEAR(RadiusOf(sampler), radius / subdivision, 1e-6 * radius);
  }
  sampler->SetSubdivision(1);
  EXPECT_EQ(NumberOfPoints(sampler), before);
}

TEST(IsoSurfaceSamplerSmoothing, AllOutputsAreThere)
{
  vtkNew<vtkInkIsoSurfaceSampler> sampler;
  sampler->SetInputData(MakeImage(VTK_SHORT, { -12, 12, -11, 11, -10, 10 },
    [](double x, double y, double z) { return BallDensity(x, y, z, Radius); }, { 1.0, 1.0, 2.0 }));
  sampler->SetValue(0, 100.0);
  sampler->SetValue(1, 60.0);
  sampler->SetSmoothing(0.7);
  sampler->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  for (const int target : { vtkInkIsoSurfaceSampler::SURFACE, vtkInkIsoSurfaceSampler::NORMALS })
  {
    sampler->SetSmoothingTarget(target);
    std::vector<Sample> exact;
    for (const int precision : { int(vtkAlgorithm::SINGLE_PRECISION),
           int(vtkInkIsoSurfaceSampler::SHORT_PRECISION), int(vtkInkIsoSurfaceSampler::CHAR_PRECISION) })
    {
      sampler->SetOutputNormalsPrecision(precision);
      sampler->Update();
      const auto samples = SamplesOf(sampler->GetOutput());
      ASSERT_GT(samples.size(), 2000u);
      exact = exact.empty() ? samples : exact;
      ASSERT_EQ(samples.size(), exact.size());
      const double unit = precision == vtkAlgorithm::SINGLE_PRECISION ? 1.0
        : precision == vtkInkIsoSurfaceSampler::SHORT_PRECISION       ? 32767.0
                                                                      : 127.0;
      vtkDataArray* index = sampler->GetOutput()->GetPointData()->GetArray("SurfaceIndex");
      ASSERT_TRUE(index);
      EXPECT_EQ(index->GetComponent(0, 0), 0.0);
      EXPECT_EQ(index->GetComponent(index->GetNumberOfTuples() - 1, 0), 1.0);
      for (std::size_t n = 0; n < samples.size(); ++n)
      {
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          EXPECT_EQ(samples[n][axis], exact[n][axis]);
          EXPECT_NEAR(samples[n][3 + axis] / unit, exact[n][3 + axis], 0.51 / unit);
        }
      }
    }
  }
}

TEST(IsoSurfaceSamplerSmoothing, PiecesAreTheWhole)
{
  vtkNew<vtkRTAnalyticSource> source;
  source->SetWholeExtent(-20, 17, -11, 20, -13, 14);
  vtkNew<vtkInkIsoSurfaceSampler> sampler;
  sampler->SetValue(0, IsoValue);
  sampler->SetInputConnection(source->GetOutputPort());
  sampler->SetSmoothing(0.8);
  for (const int target : { vtkInkIsoSurfaceSampler::SURFACE, vtkInkIsoSurfaceSampler::NORMALS })
  {
    sampler->SetSmoothingTarget(target);
    for (const int subdivision : { 1, 2 })
    {
      for (const int steps : { 0, 2 })
      {
        sampler->SetSubdivision(subdivision);
        sampler->SetProjectionSteps(steps);
        const auto whole = SamplesOfPieces(sampler, 1);
        ASSERT_GT(whole.size(), 2000u);
        EXPECT_EQ(std::adjacent_find(whole.begin(), whole.end()), whole.end()) << "no point twice";
        for (const int pieces : { 2, 4 })
        {
          EXPECT_TRUE(SamplesOfPieces(sampler, pieces) == whole)
            << pieces << " pieces, target " << target << ", subdivision " << subdivision << ", steps "
            << steps;
        }
      }
    }
  }
}

TEST(IsoSurfaceSamplerSmoothing, ChangesOfTheImageAreSeen)
{
  auto image = MakeImage(VTK_FLOAT, { -12, 12, -12, 12, -12, 12 },
    [](double x, double y, double z) { return BallDensity(x, y, z, Radius); });
  vtkNew<vtkInkIsoSurfaceSampler> sampler;
  sampler->SetInputData(image);
  sampler->SetValue(0, 100.0);
  sampler->SetSmoothing(0.5);
  const double before = NumberOfPoints(sampler);
  EXPECT_GT(sampler->GetIndexMemory(), 0);
  InkTestFill(
    image, VTK_FLOAT, [](double x, double y, double z) { return BallDensity(x, y, z, 0.5 * Radius); });
  image->Modified();
  EXPECT_NEAR(NumberOfPoints(sampler), 0.25 * before, 0.05 * before);
  sampler->ReleaseIndex();
  EXPECT_EQ(sampler->GetIndexMemory(), 0);
}

TEST(IsoSurfaceSamplerSmoothing, PropertiesAreClampedAndPrinted)
{
  vtkNew<vtkInkIsoSurfaceSampler> sampler;
  EXPECT_EQ(sampler->GetSmoothing(), 0.0);
  EXPECT_EQ(sampler->GetSubdivision(), 1);
  sampler->SetSmoothing(-1.0);
  EXPECT_EQ(sampler->GetSmoothing(), 0.0);
  sampler->SetSmoothing(9.0);
  EXPECT_EQ(sampler->GetSmoothing(), 8.0);
  sampler->SetSubdivision(99);
  EXPECT_EQ(sampler->GetSubdivision(), 8);
  sampler->SetSmoothingTargetToNormals();
  EXPECT_STREQ(sampler->GetSmoothingTargetAsString(), "Normals");
  std::ostringstream printed;
  sampler->Print(printed);
  EXPECT_NE(printed.str().find("SmoothingTarget: Normals"), std::string::npos);
}
