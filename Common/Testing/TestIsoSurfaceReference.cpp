// The samples of small random volumes against an implementation of Zhang et al. 2014, section 5.1, that is as
// plain as it can be: every cell, every edge, one after the other.

#include "SampledVolume.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace
{

using namespace ink::testing;
using ink::CrossingRule;

struct ReferenceSample
{
  glm::dvec3 point;
  glm::dvec3 direction; ///< against the normal; of no use where it is about zero
};

bool crosses(double f1, double f2, double f0, CrossingRule rule)
{
  if (rule == CrossingRule::HalfOpen)
  {
    return (f1 < f0) != (f2 < f0);
  }
  return (f1 < f0 && f2 > f0) || (f1 > f0 && f2 < f0) || (f1 == f0 && f2 == f0);
}

/// The trilinear interpolation of the corners' unit gradients at the point t of a unit cell.
template <class T>
glm::dvec3 meanDirection(const ink::GridField<T>& field, const glm::ivec3& cell, const glm::dvec3& t)
{
  glm::dvec3 sum(0.0);
  for (int c = 0; c < 8; ++c)
  {
    const glm::ivec3 upper(c & 1, c >> 1 & 1, c >> 2);
    const glm::dvec3 weights = glm::mix(1.0 - t, t, glm::dvec3(upper));
    const glm::dvec3 gradient = field.geometry().gradientToWorld(field.gradientAt(cell + upper));
    const double steepness = glm::length(gradient);
    sum += steepness > 0.0 ? weights.x * weights.y * weights.z / steepness * gradient : glm::dvec3(0.0);
  }
  return sum;
}

template <class T>
std::vector<ReferenceSample> reference(const ink::GridField<T>& field, double f0, CrossingRule rule)
{
  std::vector<ReferenceSample> samples;
  const glm::ivec3 cells = field.geometry().dimensions() - 1;
  for (int k = 0; k < cells.z; ++k)
  {
    for (int j = 0; j < cells.y; ++j)
    {
      for (int i = 0; i < cells.x; ++i)
      {
        glm::dvec3 sum(0.0);
        int count = 0;
        bool complete = true;
        for (int c = 0; c < 8; ++c)
        {
          const glm::ivec3 corner = glm::ivec3(i, j, k) + glm::ivec3(c & 1, c >> 1 & 1, c >> 2);
          complete = complete && field.has(corner);
          for (int axis = 0; axis < 3; ++axis)
          {
            if (c >> axis & 1)
            {
              continue;
            }
            glm::ivec3 other = corner;
            other[axis] += 1;
            const double f1 = static_cast<double>(field.at(corner));
            const double f2 = static_cast<double>(field.at(other));
            if (crosses(f1, f2, f0, rule))
            {
              const double alpha = f1 == f2 ? 0.5 : (f1 - f0) / (f1 - f2);
              sum += (1.0 - alpha) * glm::dvec3(corner) + alpha * glm::dvec3(other);
              ++count;
            }
          }
        }
        if (complete && count > 0)
        {
          const glm::dvec3 mean = sum / static_cast<double>(count);
          const glm::ivec3 cell(i, j, k);
          samples.push_back(
            { field.geometry().toWorld(mean), meanDirection(field, cell, mean - glm::dvec3(cell)) });
        }
      }
    }
  }
  return samples;
}

template <class T>
void expectSameAsReference(unsigned seed, int missingPercent)
{
  std::mt19937 random(seed);
  const auto upTo = [&](unsigned n) { return static_cast<int>(random() % n); };
  const ink::GridGeometry geometry({ 2 + upTo(9), 2 + upTo(9), 2 + upTo(9) }, { 1, -2, 3 }, { 0.5, 2.0, 1.0 },
    { 0, 1, 0, -1, 0, 0, 0, 0, 1 }, { upTo(5), -upTo(5), 0 });
  // Few values make plateaus and many samples at the iso-value itself.
  const int values = 2 + upTo(6);
  Volume<T> volume(geometry);
  std::vector<std::uint8_t> marks(volume.values.size(), 0);
  for (std::size_t n = 0; n < volume.values.size(); ++n)
  {
    volume.values[n] = static_cast<T>(upTo(static_cast<unsigned>(values)));
    if (upTo(100) < missingPercent)
    {
      marks[n] = 2;
      if constexpr (std::is_floating_point_v<T>)
      {
        marks[n] = 0;
        volume.values[n] = upTo(2) ? std::numeric_limits<T>::quiet_NaN() : std::numeric_limits<T>::infinity();
      }
    }
  }
  const auto field = volume.field({ marks, 2 });
  for (const CrossingRule rule : { CrossingRule::HalfOpen, CrossingRule::Strict })
  {
    for (const double f0 : { 0.0, 1.0, 1.5, 2.0, 2.25, 5.0 })
    {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", iso-value " + std::to_string(f0) +
        (rule == CrossingRule::Strict ? ", strict" : ", half open"));
      const auto expected = reference(field, f0, rule);
      const auto samples = sampleIsoSurface(field, f0, rule);
      ASSERT_EQ(samples.size(), expected.size());
      for (std::size_t n = 0; n < samples.size(); ++n)
      {
        EXPECT_LT(glm::distance(samples.point(n), expected[n].point), 1e-12) << "sample " << n;
        EXPECT_NEAR(glm::length(samples.normal(n)), 1.0, 1e-6) << "sample " << n;
        const double length = glm::length(expected[n].direction);
        if (length > 1e-9)
        {
          EXPECT_LT(glm::distance(samples.normal(n), -expected[n].direction / length), 1e-6)
            << "sample " << n;
        }
      }
    }
  }
}

TEST(IsoSurfaceReference, AgreesOnRandomVolumes)
{
  for (unsigned seed = 0; seed < 100 && !HasFailure(); ++seed)
  {
    expectSameAsReference<unsigned char>(seed, 0);
    expectSameAsReference<short>(seed, 4);
    expectSameAsReference<long long>(seed, 0);
    expectSameAsReference<float>(seed, seed % 2 ? 4 : 0);
    expectSameAsReference<double>(seed, seed % 2 ? 0 : 4);
  }
}

} // namespace
