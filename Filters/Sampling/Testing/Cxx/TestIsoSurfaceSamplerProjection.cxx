// SPDX-License-Identifier: BSD-3-Clause
// ProjectionSteps moves points onto the surface, and nothing else changes.

#include "InkTestProgress.h"
#include "SamplerTestImages.h"

#include "vtkInformation.h"
#include "vtkInkIsoSurfaceSampler.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkRTAnalyticSource.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>
#include <string>

namespace
{

const double Radius = 8.0;

/// Nowhere below 0, which bytes do not hold.
vtkSmartPointer<vtkImageData> MakeBall(int type)
{
  return MakeImage(type, { -12, 12, -11, 11, -10, 10 },
    [](double x, double y, double z) { return std::max(BallDensity(x, y, z, Radius), 0.0); });
}

/// How far the point is from the surface of its cell's trilinear interpolation, whose slope is 10.
double DistanceOf(vtkImageData* image, const Sample& sample, double isoValue)
{
  double p[3] = { sample[0], sample[1], sample[2] };
  int index[3];
  double t[3];
  image->ComputeStructuredCoordinates(p, index, t);
  double value = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    double weight = 1.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      weight *= corner >> axis & 1 ? t[axis] : 1.0 - t[axis];
    }
    value += weight *
      image->GetScalarComponentAsDouble(
        index[0] + (corner & 1), index[1] + (corner >> 1 & 1), index[2] + (corner >> 2), 0);
  }
  return std::abs(value - isoValue) / 10.0;
}

} // namespace

TEST(IsoSurfaceSamplerProjection, MovesPointsOntoTheSurface)
{
  for (const int type : { VTK_FLOAT, VTK_DOUBLE, VTK_SHORT, VTK_UNSIGNED_CHAR, VTK_LONG_LONG })
  {
    for (const int precision : { vtkAlgorithm::SINGLE_PRECISION, vtkAlgorithm::DOUBLE_PRECISION })
    {
      // Integers are rounded, which makes for steep cells.
      const bool rounded = type != VTK_FLOAT && type != VTK_DOUBLE;
      const std::string name = "type " + std::to_string(type) + ", precision " + std::to_string(precision);
      const auto image = MakeBall(type);
      vtkNew<vtkInkIsoSurfaceSampler> sampler;
      sampler->SetInputData(image);
      // The last one has no points: no sum of counts, no place in the array may be mistaken.
      const double isoValues[] = { 100.25, 130.5, 1e6 };
      for (int n = 0; n < 3; ++n)
      {
        sampler->SetValue(n, isoValues[n]);
      }
      sampler->SetOutputPointsPrecision(precision);
      sampler->Update();
      const auto before = SamplesOf(sampler->GetOutput());
      double last = 1.0;
      for (const int steps : { 0, 1, 2, 3 })
      {
        sampler->SetProjectionSteps(steps);
        sampler->Update();
        const auto samples = SamplesOf(sampler->GetOutput());
        auto* surface =
          vtkIntArray::SafeDownCast(sampler->GetOutput()->GetPointData()->GetArray("SurfaceIndex"));
        ASSERT_TRUE(surface && samples.size() == before.size() && samples.size() > 1000)
          << name << ": as many points as before, found " << samples.size();
        double worst = 0.0;
        double moved = 0.0;
        bool sameNormals = true;
        for (std::size_t n = 0; n < samples.size(); ++n)
        {
          worst = std::max(
            worst, DistanceOf(image, samples[n], isoValues[surface->GetValue(static_cast<vtkIdType>(n))]));
          for (std::size_t axis = 0; axis < 3; ++axis)
          {
            moved = std::max(moved, std::abs(samples[n][axis] - before[n][axis]));
          }
          sameNormals =
            sameNormals && std::equal(before[n].begin() + 3, before[n].end(), samples[n].begin() + 3);
        }
        EXPECT_TRUE(sameNormals) << name << ": the normals of unmoved points after " << steps << " steps";
        EXPECT_TRUE((moved > 0.0) == (steps > 0) && moved < 0.1)
          << name << ": points that move by little, after " << steps << " steps by " << moved;
        EXPECT_TRUE(worst < 0.2 * last || worst < 1.1 * 1e-4)
          << name << ": distances a fifth or less after " << steps << " steps, found " << worst << " after "
          << last;
        last = worst;
      }
      EXPECT_LT(last, rounded ? 1e-3 : 1.1e-4) << name << ": points on the surface";
    }
  }
}

/// Points are the same on any number of threads and in any number of pieces.
TEST(IsoSurfaceSamplerProjection, IsTheSameOnAnyThreadsAndInAnyPieces)
{
  vtkNew<vtkRTAnalyticSource> source;
  source->SetWholeExtent(-20, 17, -11, 20, -13, 14);
  vtkNew<vtkInkIsoSurfaceSampler> sampler;
  sampler->SetInputConnection(source->GetOutputPort());
  sampler->SetValue(0, 157.0);
  sampler->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  // A point that moves into the next cell takes its gradient from behind that.
  const auto ghostLevels = [&]
  {
    sampler->Update();
    return source->GetOutputInformation(0)->Get(
      vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS());
  };
  EXPECT_EQ(ghostLevels(), 1) << "one ghost level for normals";
  sampler->SetProjectionSteps(8);
  setenv("VTK_SMP_MAX_THREADS", "1", 1);
  sampler->Update();
  auto whole = SamplesOf(sampler->GetOutput());
  EXPECT_EQ(ghostLevels(), 2) << "one more for points that move";
  setenv("VTK_SMP_MAX_THREADS", "2", 1);
  sampler->Modified();
  sampler->Update();
  EXPECT_EQ(SamplesOf(sampler->GetOutput()), whole) << "the same points on one thread and on two";
  unsetenv("VTK_SMP_MAX_THREADS");
  std::sort(whole.begin(), whole.end());
  for (const int pieces : { 2, 3, 8 })
  {
    const std::vector<Sample> all = SamplesOfPieces(sampler, pieces);
    EXPECT_EQ(all, whole) << "the whole's points from " << pieces << " pieces";
  }
}

TEST(IsoSurfaceSamplerProjection, StepsStayWithinRange)
{
  vtkNew<vtkInkIsoSurfaceSampler> sampler;
  EXPECT_EQ(sampler->GetProjectionSteps(), 0) << "no projection unasked";
  sampler->SetProjectionSteps(9);
  EXPECT_EQ(sampler->GetProjectionSteps(), 8) << "8 steps at most";
  sampler->SetProjectionSteps(-1);
  EXPECT_EQ(sampler->GetProjectionSteps(), 0) << "0 steps at least";
  sampler->SetProjectionSteps(2);
  std::ostringstream text;
  sampler->Print(text);
  EXPECT_NE(text.str().find("ProjectionSteps: 2"), std::string::npos) << "the steps in print";
}

TEST(IsoSurfaceSamplerProjection, CanBeAborted)
{
  vtkNew<vtkInkIsoSurfaceSampler> sampler;
  sampler->SetInputData(MakeImage(VTK_FLOAT, { -40, 40, -40, 40, -100, 100 },
    [](double x, double y, double z) { return BallDensity(x, y, z, 35.0); }));
  sampler->SetValue(0, 100.0);
  sampler->SetValue(1, 200.0);
  sampler->SetProjectionSteps(2);
  InkTestProgressAndAbort(sampler.Get());
}
