// SPDX-License-Identifier: BSD-3-Clause
#include "Stippling/VolumeStipples.h"

#include "AnalyticFields.h"
#include "BitHash.h"
#include "Core/Hash.h"
#include "PointStatistics.h"
#include "SampledVolume.h"
#include "Simd/SamplingKernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace
{

using namespace ink;
using namespace ink::stipple;
using namespace ink::testing;

constexpr int perVoxel = 8;

/// A step of one sample's width across the zero surface of a distance.
template <class Shape>
Volume<float> stepAcross(const Shape& shape, int side)
{
  const GridGeometry geometry(glm::ivec3(side), glm::dvec3(-0.5 * side + 0.5));
  return Volume<float>::from(
    geometry, [&](const glm::dvec3& p) { return std::clamp(-shape.distance(p), -0.5, 0.5); });
}

StippledVoxels voxelsOf(const Volume<float>& volume, const SampleBox& box, float threshold = 0.2f)
{
  StippledVoxels voxels;
  EXPECT_TRUE(findStippledVoxels(volume.field(), box, {}, { threshold }, voxels));
  return voxels;
}

SampleBox wholeOf(const Volume<float>& volume)
{
  return { glm::ivec3(0), volume.geometry.dimensions() };
}

template <class Visit>
void forEachVoxel(const StippledVoxels& voxels, const Visit& visit)
{
  const glm::ivec3 size = voxels.box.size();
  for (int row = 0; row < size.y * size.z; ++row)
  {
    for (std::size_t n = voxels.rows[row]; n < voxels.rows[row + 1]; ++n)
    {
      visit(n, glm::ivec3(voxels.x[n], voxels.box.begin.y + row % size.y, voxels.box.begin.z + row / size.y));
    }
  }
}

/// The world positions of the first `count` of each voxel's stipples.
std::vector<glm::dvec3> positions(const GridGeometry& geometry, const StippledVoxels& voxels,
  const std::vector<glm::vec3>& stipples, int count)
{
  std::vector<glm::dvec3> points;
  forEachVoxel(voxels,
    [&](std::size_t n, const glm::ivec3& sample)
    {
      for (int rank = 0; rank < count; ++rank)
      {
        points.push_back(geometry.toWorld(glm::dvec3(sample) + glm::dvec3(stipples[n * perVoxel + rank])));
      }
    });
  return points;
}

/// The points within a square of a plane through the origin, in its coordinates, the inner ones first.
struct Square
{
  std::vector<glm::dvec2> inner;
  std::vector<glm::dvec3> all;
  double density;
};

Square squareOf(const std::vector<glm::dvec3>& points, const glm::dvec3& normal, double half)
{
  const glm::dvec3 other = std::abs(normal.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 u = glm::normalize(glm::cross(normal, other));
  const glm::dvec3 v = glm::cross(normal, u);
  Square square;
  std::vector<glm::dvec3> outer;
  for (const glm::dvec3& point : points)
  {
    const glm::dvec2 position(glm::dot(point, u), glm::dot(point, v));
    // Beside the plane lies the border of the grid.
    if (std::abs(glm::dot(point, normal)) > 5.0)
    {
      continue;
    }
    if (std::max(std::abs(position.x), std::abs(position.y)) < half)
    {
      square.inner.push_back(position);
      square.all.emplace_back(position, 0.0);
    }
    else
    {
      outer.emplace_back(position, 0.0);
    }
  }
  square.density = static_cast<double>(square.inner.size()) / (4.0 * half * half);
  square.all.insert(square.all.end(), outer.begin(), outer.end());
  return square;
}

struct PlaneCase
{
  std::string name;
  glm::dvec3 normal;
};

void PrintTo(const PlaneCase& plane, std::ostream* os)
{
  *os << plane.name;
}

/// The mean power at up to half the mean frequency of points of that density. Multiples of the inverse of
/// the square's side see nothing of the square itself.
double lowPower(const Square& square)
{
  double sum = 0.0;
  int count = 0;
  const double side = std::sqrt(static_cast<double>(square.inner.size()) / square.density);
  const int cut = static_cast<int>(0.5 * std::sqrt(static_cast<double>(square.inner.size())));
  for (int a = 0; a <= cut; ++a)
  {
    for (int b = -cut; b <= cut; ++b)
    {
      if (a * a + b * b <= cut * cut && (a > 0 || b > 0))
      {
        sum += powerAt(square.inner, glm::dvec2(a, b) / side);
        ++count;
      }
    }
  }
  return sum / count;
}

class VolumeStipplesOfAPlane : public ::testing::TestWithParam<PlaneCase>
{
};

} // namespace

/// Whatever share is drawn: far from each other, fewer clumps than white noise has (less power at low
/// frequencies, where that has 1) and no trace of the grid (at its frequencies, and at those of every other
/// voxel, not a thirtieth of the power of a grid, which is the number of points).
TEST_P(VolumeStipplesOfAPlane, AreSpreadEvenlyAndShowNoGrid)
{
  const glm::dvec3 normal = glm::normalize(GetParam().normal);
  constexpr double half = 9.0;
  const Volume<float> volume = stepAcross(Plane{ glm::dvec3(0.0), normal }, 40);
  const StippledVoxels voxels = voxelsOf(volume, wholeOf(volume));
  const auto stipples = placeVolumeStipples(volume.geometry, voxels, { perVoxel });
  struct Most
  {
    int count;
    double low;
    double atGrid;
  };
  for (const Most& most : { Most{ 1, 0.5, 12.0 }, Most{ 3, 0.45, 5.0 }, Most{ 8, 0.34, 0.4 } })
  {
    const Square square = squareOf(positions(volume.geometry, voxels, stipples, most.count), normal, half);
    ASSERT_GT(square.inner.size(), 400u);
    const double distance = meanNearestDistance(square.all, square.density, square.inner.size());
    EXPECT_GT(distance, 1.22) << most.count << " a voxel";

    EXPECT_LT(lowPower(square), most.low) << most.count << " a voxel";
    if (GetParam().name == "AlongAnAxis")
    {
      for (const glm::dvec2 frequency : { glm::dvec2(1, 0), glm::dvec2(0, 1), glm::dvec2(1, 1),
             glm::dvec2(0.5, 0), glm::dvec2(0, 0.5), glm::dvec2(0.5, 0.5) })
      {
        EXPECT_LT(powerAt(square.inner, frequency), most.atGrid)
          << most.count << " a voxel at " << frequency.x << " " << frequency.y;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(VolumeStipples, VolumeStipplesOfAPlane,
  ::testing::Values(PlaneCase{ "AlongAnAxis", { 0, 0, 1 } }, PlaneCase{ "Backwards", { -1, 0, 0 } },
    PlaneCase{ "AlongAnEdge", { 0.01, 1, 1 } }, PlaneCase{ "AlongADiagonal", { 1, 1.02, 0.99 } },
    PlaneCase{ "Oblique", { 0.3, 0.2, 1 } }),
  [](const auto& test) { return test.param.name; });

/// That the measures above tell white noise and a grid from blue noise.
TEST(VolumeStipples, AreJudgedByMeasuresThatCanFail)
{
  std::vector<glm::dvec3> white;
  std::vector<glm::dvec2> grid;
  for (std::uint64_t n = 0; n < 4000; ++n)
  {
    white.emplace_back(20.0 * unitDouble(hash(1, n)) - 10.0, 20.0 * unitDouble(hash(2, n)) - 10.0, 0.0);
    grid.emplace_back(n % 20, n / 20);
  }
  const Square square = squareOf(white, { 0, 0, 1 }, 9.0);
  EXPECT_NEAR(meanNearestDistance(square.all, square.density, square.inner.size()), 1.0, 0.05);
  EXPECT_NEAR(lowPower(square), 1.0, 0.1);
  EXPECT_GT(powerAt(grid, { 1, 0 }), 3999.0);
}

TEST(VolumeStipples, OfASphereAreSpreadEvenly)
{
  const Sphere sphere{ glm::dvec3(0.3, -0.2, 0.1), 15.0 };
  const Volume<float> volume = stepAcross(sphere, 40);
  const StippledVoxels voxels = voxelsOf(volume, wholeOf(volume));
  const auto stipples = placeVolumeStipples(volume.geometry, voxels, { perVoxel });
  for (const int count : { 1, 2, 4, 8 })
  {
    auto points = positions(volume.geometry, voxels, stipples, count);
    for (glm::dvec3& point : points)
    {
      point = glm::normalize(point - sphere.center);
    }
    const double density = static_cast<double>(points.size()) / (4.0 * std::numbers::pi);
    EXPECT_GT(meanNearestDistance(points, density, points.size()), 1.22) << count << " a voxel";
  }
}

TEST(VolumeStipples, LieInTheirVoxelsBetweenThePlanes)
{
  const GridGeometry geometry(glm::ivec3(24), glm::dvec3(-6.0, -12.0, -24.0), { 0.5, -1.0, 2.0 },
    glm::dmat3(0.6, 0.8, 0.0, -0.8, 0.6, 0.0, 0.0, 0.0, 1.0));
  const auto volume =
    Volume<float>::from(geometry, [](const glm::dvec3& p) { return static_cast<float>(-glm::dot(p, p)); });
  const StippledVoxels voxels = voxelsOf(volume, wholeOf(volume));
  ASSERT_GT(voxels.size(), 10000u);
  for (const double thickness : { 0.0, 0.3, 1.0, 2.0, 1e9 })
  {
    const auto stipples = placeVolumeStipples(geometry, voxels, { perVoxel, thickness });
    double highest = 0.0;
    glm::vec3 farthest(0.0f);
    forEachVoxel(voxels,
      [&](std::size_t n, const glm::ivec3&)
      {
        // The change of the value along a step is that of the gradient per step.
        const glm::dvec3 perStep = glm::dvec3(voxels.gradients[n]) * geometry.stepToWorld();
        for (int rank = 0; rank < perVoxel; ++rank)
        {
          const glm::vec3 step = stipples[n * perVoxel + rank];
          farthest = glm::max(farthest, glm::abs(step));
          highest = std::max(highest, std::abs(glm::dot(glm::normalize(perStep), glm::dvec3(step))));
        }
      });
    EXPECT_LE(std::max({ farthest.x, farthest.y, farthest.z }), 0.5f) << thickness;
    EXPECT_GT(std::min({ farthest.x, farthest.y, farthest.z }), 0.49f) << thickness;
    EXPECT_LE(highest, 0.5 * thickness + 1e-6) << thickness;
    EXPECT_GT(highest, 0.49 * std::min(thickness, 1.3)) << thickness;
  }
}

TEST(VolumeStipples, AreTheSameOnAnyNumberOfThreads)
{
  const Volume<float> volume = stepAcross(Sphere{ glm::dvec3(0.0), 9.0 }, 24);
  const StippledVoxels voxels = voxelsOf(volume, wholeOf(volume));
  setenv("VTK_SMP_MAX_THREADS", "1", 1);
  const auto one = placeVolumeStipples(volume.geometry, voxels, { perVoxel });
  setenv("VTK_SMP_MAX_THREADS", "2", 1);
  const auto two = placeVolumeStipples(volume.geometry, voxels, { perVoxel });
  unsetenv("VTK_SMP_MAX_THREADS");
  EXPECT_EQ(one, two);
  EXPECT_NE(one, placeVolumeStipples(volume.geometry, voxels, { perVoxel, 1.0, 1 })) << "another seed";
}

/// Boxes anywhere give the stipples of the whole, to the last bit, when they know as far as stippleReach.
TEST(VolumeStipples, AreTheSameInPieces)
{
  const Volume<float> volume = stepAcross(Sphere{ glm::dvec3(0.5, 0.0, 0.2), 10.0 }, 26);
  const StippledVoxels whole = voxelsOf(volume, wholeOf(volume), 0.01f);
  const auto expected = placeVolumeStipples(volume.geometry, whole, { perVoxel });
  std::vector<std::vector<glm::vec3>> bySample(volume.values.size());
  forEachVoxel(whole,
    [&](std::size_t n, const glm::ivec3& sample)
    {
      bySample[volume.geometry.offset(sample)].assign(
        &expected[n * perVoxel], &expected[n * perVoxel] + perVoxel);
    });
  std::size_t compared = 0;
  for (const glm::ivec3 begin : { glm::ivec3(0), glm::ivec3(7, 6, 5), glm::ivec3(12, 11, 2), glm::ivec3(3) })
  {
    const SampleBox own{ begin, begin + glm::ivec3(10, 9, 8) };
    const SampleBox grown{ glm::max(own.begin - stippleReach, glm::ivec3(0)),
      glm::min(own.end + stippleReach, volume.geometry.dimensions()) };
    const StippledVoxels voxels = voxelsOf(volume, grown, 0.01f);
    const auto stipples = placeVolumeStipples(volume.geometry, voxels, { perVoxel });
    forEachVoxel(voxels,
      [&](std::size_t n, const glm::ivec3& sample)
      {
        if (glm::all(glm::greaterThanEqual(sample, own.begin)) && glm::all(glm::lessThan(sample, own.end)))
        {
          const auto& there = bySample[volume.geometry.offset(sample)];
          ASSERT_EQ(there.size(), perVoxel);
          EXPECT_TRUE(std::equal(there.begin(), there.end(), &stipples[n * perVoxel]))
            << sample.x << " " << sample.y << " " << sample.z;
          ++compared;
        }
      });
  }
  EXPECT_GT(compared, 300u);
}

/// The same part of a scene in a grid that begins elsewhere: only global indices count.
TEST(VolumeStipples, DoNotDependOnWhereTheGridBegins)
{
  const GridGeometry some(glm::ivec3(20), glm::dvec3(0.0), glm::dvec3(1.0), glm::dmat3(1.0), glm::ivec3(-7));
  const GridGeometry more(glm::ivec3(25), glm::dvec3(0.0), glm::dvec3(1.0), glm::dmat3(1.0), glm::ivec3(-10));
  const auto value = [](const glm::dvec3& p)
  { return static_cast<float>(glm::dot(p - 2.5, p - 2.5) < 25.0); };
  const auto inSome = Volume<float>::from(some, value);
  const auto inMore = Volume<float>::from(more, value);
  const auto stippled = [](const Volume<float>& volume)
  {
    const StippledVoxels voxels = voxelsOf(volume, wholeOf(volume));
    return positions(
      volume.geometry, voxels, placeVolumeStipples(volume.geometry, voxels, { perVoxel }), perVoxel);
  };
  EXPECT_EQ(stippled(inSome), stippled(inMore));
}

TEST(VolumeStipples, AreFiniteAtTheExtremes)
{
  for (const glm::dvec3 spacing :
    { glm::dvec3(1e-9), glm::dvec3(1e9), glm::dvec3(1, 1, 1000), glm::dvec3(1000, 1, 1) })
  {
    const GridGeometry geometry(glm::ivec3(6), glm::dvec3(1e7), spacing);
    const auto volume = Volume<float>::from(
      geometry, [&](const glm::dvec3& p) { return static_cast<float>(glm::length((p - 1e7) / spacing)); });
    const StippledVoxels voxels = voxelsOf(volume, wholeOf(volume), 0.0f);
    EXPECT_EQ(voxels.size(), 216u);
    const auto stipples = placeVolumeStipples(geometry, voxels, { maximumStipplesPerVoxel });
    EXPECT_EQ(stipples.size(), 216u * 64u);
    for (const glm::vec3& step : stipples)
    {
      ASSERT_LE(std::max({ std::abs(step.x), std::abs(step.y), std::abs(step.z) }), 0.5f);
    }
  }
}

TEST(VolumeStipples, RefuseWhatTheyCannotDo)
{
  const Volume<float> volume = stepAcross(Sphere{ glm::dvec3(0.0), 3.0 }, 10);
  const StippledVoxels voxels = voxelsOf(volume, wholeOf(volume));
  for (const VolumeStippleOptions options : { VolumeStippleOptions{ 0 }, VolumeStippleOptions{ 65 },
         VolumeStippleOptions{ 8, -1.0 }, VolumeStippleOptions{ 8, std::nan("") } })
  {
    EXPECT_THROW(placeVolumeStipples(volume.geometry, voxels, options), std::invalid_argument);
  }
  EXPECT_TRUE(placeVolumeStipples(volume.geometry, voxels, { 8 }, [](double) { return false; }).empty());
  StippledVoxels none;
  none.rows.assign(1, 0);
  EXPECT_TRUE(placeVolumeStipples(volume.geometry, none, { 8 }).empty());
}

TEST(VolumeStipples, AreTheSameWithEveryInstructionSet)
{
  const Volume<float> volume = stepAcross(Sphere{ glm::dvec3(0.0), 9.0 }, 24);
  const StippledVoxels voxels = voxelsOf(volume, wholeOf(volume));
  for (const int number : { 1, 3, 8, 21, 64 })
  {
    VolumeStippleOptions options;
    options.perVoxel = number;
    options.thickness = 0.3 + 0.02 * number;
    useSamplingKernels(samplingKernelsOf("baseline"));
    const auto expected = placeVolumeStipples(volume.geometry, voxels, options);
    for (const char* name : { "avx2", "avx512" })
    {
      if (const SamplingKernels* kernels = samplingKernelsOf(name))
      {
        useSamplingKernels(kernels);
        EXPECT_TRUE(placeVolumeStipples(volume.geometry, voxels, options) == expected)
          << number << ", " << name;
      }
    }
    useSamplingKernels(nullptr);
  }
}
TEST(VolumeStipples, AreTheSameOnEveryProcessor)
{
  const Volume<float> volume = stepAcross(Sphere{ glm::dvec3(0.0), 9.0 }, 24);
  std::vector<float> all;
  for (const glm::vec3& offset :
    placeVolumeStipples(volume.geometry, voxelsOf(volume, wholeOf(volume)), { 21 }))
  {
    all.insert(all.end(), { offset.x, offset.y, offset.z });
  }
  // What x86-64 gave.
  EXPECT_EQ(bitHash(all), 10406328263004095810u);
}
