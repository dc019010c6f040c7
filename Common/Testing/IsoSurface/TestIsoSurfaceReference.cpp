// SPDX-License-Identifier: BSD-3-Clause
// The samples of small random volumes against a plain implementation.

#include "IsoSurfaceReference.h"
#include "SampledVolume.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <string>
#include <vector>

namespace
{

using namespace ink::testing;
using ink::CrossingRule;

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
      const auto expected = referenceSamples(field, f0, rule);
      const auto samples = sampleIsoSurface(field, f0, rule);
      ASSERT_EQ(samples.size(), expected.size());
      for (std::size_t n = 0; n < samples.size(); ++n)
      {
        EXPECT_LT(glm::distance(samples.point(n), field.geometry().toWorld(expected[n].index)), 1e-12)
          << "sample " << n;
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
