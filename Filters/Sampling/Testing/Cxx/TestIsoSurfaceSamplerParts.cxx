// SPDX-License-Identifier: BSD-3-Clause
// Parts of surfaces that are left out: floaters, and all but the largest.

#include "SamplerTestImages.h"

#include "IsoSurface/ActiveCellId.h"

#include "vtkInkIsoSurfaceSampler.h"
#include "vtkNew.h"
#include "vtkRTAnalyticSource.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace
{

constexpr std::array<int, 6> Extent{ -20, 20, -10, 10, -10, 10 };

/// A large ball to the left, a smaller one to the right and a single voxel between them: 100 on their
/// surfaces.
vtkSmartPointer<vtkImageData> MakeBalls()
{
  return MakeImage(VTK_FLOAT, Extent,
    [](double x, double y, double z)
    {
      const double balls = std::max(BallDensity(x + 10, y, z, 8), BallDensity(x - 12, y, z, 4));
      return x == 2 && y == 5 && z == 5 ? 150.0 : std::min(balls, 200.0);
    });
}

/// Those of the points whose x lies between two numbers.
vtkIdType CountWithin(vtkPolyData* points, double least, double greatest)
{
  vtkIdType count = 0;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    const double x = points->GetPoint(i)[0];
    count += x >= least && x <= greatest ? 1 : 0;
  }
  return count;
}

struct Parts
{
  vtkIdType Large;
  vtkIdType Speck;
  vtkIdType Small;

  bool operator==(const Parts&) const = default;
};

Parts CountParts(vtkPolyData* points)
{
  return { CountWithin(points, -20, -1), CountWithin(points, 0.5, 3.5), CountWithin(points, 7, 20) };
}

vtkSmartPointer<vtkInkIsoSurfaceSampler> MakeSampler(vtkImageData* image)
{
  auto sampler = vtkSmartPointer<vtkInkIsoSurfaceSampler>::New();
  sampler->SetInputData(image);
  sampler->SetValue(0, 100.0);
  return sampler;
}

} // namespace

TEST(IsoSurfaceSamplerParts, AreAllThereByDefault)
{
  const auto sampler = MakeSampler(MakeBalls());
  sampler->Update();
  const Parts parts = CountParts(sampler->GetOutput());
  EXPECT_EQ(parts.Speck, 8) << "the cells around one voxel";
  EXPECT_EQ(parts.Large + parts.Speck + parts.Small, sampler->GetOutput()->GetNumberOfPoints());
  EXPECT_GT(parts.Large, 3 * parts.Small);
}

TEST(IsoSurfaceSamplerParts, SmallOnesAreLeftOut)
{
  const auto sampler = MakeSampler(MakeBalls());
  sampler->Update();
  const Parts all = CountParts(sampler->GetOutput());
  for (const double automatic : { -1.0, 0.02 })
  {
    sampler->SetSmallestPart(automatic);
    sampler->Update();
    EXPECT_EQ(CountParts(sampler->GetOutput()), (Parts{ all.Large, 0, all.Small })) << automatic;
  }
  sampler->SetSmallestPart(0.5);
  sampler->Update();
  EXPECT_EQ(CountParts(sampler->GetOutput()), (Parts{ all.Large, 0, 0 }));
  sampler->SetSmallestPart(0.0);
  sampler->Update();
  EXPECT_EQ(CountParts(sampler->GetOutput()), all);
}

TEST(IsoSurfaceSamplerParts, TheLargestAreKept)
{
  const auto sampler = MakeSampler(MakeBalls());
  sampler->Update();
  const Parts all = CountParts(sampler->GetOutput());
  sampler->SetLargestParts(2);
  sampler->Update();
  EXPECT_EQ(CountParts(sampler->GetOutput()), (Parts{ all.Large, 0, all.Small }));
  sampler->SetLargestParts(1);
  sampler->Update();
  EXPECT_EQ(CountParts(sampler->GetOutput()), (Parts{ all.Large, 0, 0 }));
}

TEST(IsoSurfaceSamplerParts, PointsThatAreLeftAreWhatTheyWere)
{
  for (const int precision : { vtkAlgorithm::SINGLE_PRECISION, vtkAlgorithm::DOUBLE_PRECISION })
  {
    const auto sampler = MakeSampler(MakeBalls());
    sampler->SetOutputPointsPrecision(precision);
    sampler->Update();
    std::vector<Sample> wanted = SamplesOf(sampler->GetOutput());
    std::erase_if(wanted, [](const Sample& sample) { return sample[0] > 0.0; });
    sampler->SetLargestParts(1);
    sampler->Update();
    EXPECT_EQ(SamplesOf(sampler->GetOutput()), wanted);
    EXPECT_EQ(
      sampler->GetOutput()->GetVerts()->GetNumberOfConnectivityIds(), static_cast<vtkIdType>(wanted.size()));
    EXPECT_EQ(sampler->GetOutput()->GetPointData()->GetArray("Radius")->GetNumberOfTuples(),
      static_cast<vtkIdType>(wanted.size()));
  }
}

TEST(IsoSurfaceSamplerParts, BelongToTheirSurface)
{
  // At 60 each ball is larger by four.
  const auto sampler = MakeSampler(MakeBalls());
  sampler->SetLargestParts(1);
  std::vector<Sample> each;
  for (const double value : { 100.0, 60.0 })
  {
    sampler->SetValue(0, value);
    sampler->Update();
    const auto samples = SamplesOf(sampler->GetOutput());
    each.insert(each.end(), samples.begin(), samples.end());
  }
  sampler->SetValue(0, 100.0);
  sampler->SetValue(1, 60.0);
  sampler->Update();
  EXPECT_EQ(SamplesOf(sampler->GetOutput()), each);
  vtkDataArray* index = sampler->GetOutput()->GetPointData()->GetArray("SurfaceIndex");
  ASSERT_TRUE(index);
  EXPECT_EQ(index->GetNumberOfTuples(), sampler->GetOutput()->GetNumberOfPoints());
}

TEST(IsoSurfaceSamplerParts, CellIdsAreThoseOfTheWhole)
{
  vtkNew<vtkRTAnalyticSource> source;
  source->SetWholeExtent(-20, 17, -11, 20, -13, 14);
  std::vector<vtkTypeInt64> whole;
  for (const int pieces : { 1, 3 })
  {
    std::vector<vtkTypeInt64> ids;
    vtkNew<vtkInkIsoSurfaceSampler> sampler;
    sampler->SetInputConnection(source->GetOutputPort());
    sampler->SetValue(0, 157.0);
    sampler->ComputeCellIdsOn();
    for (int piece = 0; piece < pieces; ++piece)
    {
      sampler->UpdatePiece(piece, pieces, 0);
      vtkDataArray* array = sampler->GetOutput()->GetPointData()->GetArray("CellId");
      ASSERT_TRUE(array);
      ASSERT_EQ(array->GetNumberOfTuples(), sampler->GetOutput()->GetNumberOfPoints());
      for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
      {
        const auto id = static_cast<vtkTypeInt64*>(array->GetVoidPointer(0))[i];
        const double* p = sampler->GetOutput()->GetPoint(i);
        // A point lies in its cell, upper faces included.
        const auto cellOf = [](double x) { return static_cast<int>(std::ceil(x)) - 1; };
        const auto floorOf = [](double x) { return static_cast<int>(std::floor(x)); };
        EXPECT_LE(id, ink::activeCellId({ floorOf(p[0]), floorOf(p[1]), floorOf(p[2]) }));
        EXPECT_GE(id, ink::activeCellId({ cellOf(p[0]), cellOf(p[1]), cellOf(p[2]) }));
        ids.push_back(id);
      }
    }
    std::sort(ids.begin(), ids.end());
    whole = pieces == 1 ? ids : whole;
    EXPECT_EQ(ids, whole);
  }
}

TEST(IsoSurfaceSamplerParts, AreTheSameOnAnyNumberOfThreads)
{
  const auto image = MakeBalls();
  std::vector<std::vector<Sample>> found;
  for (const char* threads : { "1", "2" })
  {
    setenv("VTK_SMP_MAX_THREADS", threads, 1);
    const auto sampler = MakeSampler(image);
    sampler->SetLargestParts(1);
    sampler->Update();
    found.push_back(SamplesOf(sampler->GetOutput()));
  }
  unsetenv("VTK_SMP_MAX_THREADS");
  EXPECT_EQ(found[0], found[1]);
}

TEST(IsoSurfaceSamplerParts, NoNumberIsNoShare)
{
  vtkNew<vtkInkIsoSurfaceSampler> sampler;
  sampler->SetSmallestPart(-7.0);
  EXPECT_EQ(sampler->GetSmallestPart(), -1.0);
  sampler->SetSmallestPart(7.0);
  EXPECT_EQ(sampler->GetSmallestPart(), 1.0);
}
