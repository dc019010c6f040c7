// SPDX-License-Identifier: BSD-3-Clause
// Each way of finding normals against analytic truth, on clean volumes and on noisy ones.

#include "AnalyticFields.h"
#include "SampledVolume.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{

using namespace ink::testing;
using ink::GridGeometry;
using ink::NormalMethod;

/// Root mean square angle to the torus' normals, in degrees.
double angleOf(NormalMethod method, const glm::dvec3& spacing, double noise, ink::Arithmetic arithmetic)
{
  const Torus torus{ 16.0, 7.0 };
  std::mt19937 random(1);
  const glm::ivec3 n(glm::ceil(glm::dvec3(52.0, 52.0, 24.0) / spacing));
  const GridGeometry grid(n, -0.5 * spacing * glm::dvec3(n - 1), spacing);
  // A sharp boundary, as scanners see it: the step is some two samples wide. The noise is even, from bits, as
  // no two standard libraries agree on distributions.
  const auto volume = Volume<float>::from(grid,
    [&](auto p)
    {
      const double even = static_cast<double>(random()) / 4294967295.0 - 0.5;
      return 0.5 - 0.5 * std::tanh(torus.value(p)) + noise * even;
    });
  ink::SampleOptions options;
  options.method = method;
  options.arithmetic = arithmetic;
  const auto samples = sampleIsoSurface<float>(volume.field(), 0.5, options);
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    EXPECT_NEAR(glm::length(samples.normal(i)), 1.0, 1e-6);
    if (std::abs(torus.distance(samples.point(i))) < 1.0)
    {
      const double sine = glm::length(glm::cross(samples.normal(i), -torus.gradient(samples.point(i))));
      sum += sine * sine;
      ++count;
    }
  }
  EXPECT_GT(count, 3000u);
  return std::sqrt(sum / static_cast<double>(count)) * 180.0 / M_PI;
}

TEST(NormalMethods, AreExactOnPlanes)
{
  for (const glm::dvec3& spacing : { glm::dvec3(1.0), glm::dvec3(0.5, 1.0, -3.0) })
  {
    const Plane plane{ glm::dvec3(4.2, 4.3, 4.4) * spacing, glm::normalize(glm::dvec3(1.0, 2.0, -0.5)) };
    const auto volume =
      Volume<float>::from(GridGeometry({ 10, 10, 10 }, {}, spacing), [&](auto p) { return plane.value(p); });
    for (const NormalMethod method : { NormalMethod::Cell, NormalMethod::InterpolatedGradient,
           NormalMethod::InterpolatedNormal, NormalMethod::Regression })
    {
      ink::SampleOptions options;
      options.method = method;
      const auto samples = sampleIsoSurface<float>(volume.field(), 0.0, options);
      ASSERT_GT(samples.size(), 30u);
      for (std::size_t n = 0; n < samples.size(); ++n)
      {
        // At the border too.
        EXPECT_LT(glm::distance(samples.normal(n), -plane.normal), 1e-5) << static_cast<int>(method);
      }
    }
  }
}

TEST(NormalMethods, AreWithinDegreesOfTheTruth)
{
  struct Case
  {
    NormalMethod method;
    double clean;
    double noisy;
    double anisotropic;
  };
  for (const Case& c :
    { Case{ NormalMethod::Cell, 2.3, 5.3, 5.2 }, Case{ NormalMethod::InterpolatedGradient, 2.5, 3.5, 5.5 },
      Case{ NormalMethod::InterpolatedNormal, 2.4, 3.4, 4.7 },
      Case{ NormalMethod::Regression, 1.8, 2.2, 3.0 } })
  {
    for (const ink::Arithmetic arithmetic : { ink::Arithmetic::Single, ink::Arithmetic::Double })
    {
      SCOPED_TRACE(static_cast<int>(c.method));
      EXPECT_LT(angleOf(c.method, glm::dvec3(1.0), 0.0, arithmetic), c.clean);
      EXPECT_LT(angleOf(c.method, glm::dvec3(1.0), 0.1, arithmetic), c.noisy);
      EXPECT_LT(angleOf(c.method, glm::dvec3(1.0, 1.0, 2.0), 0.0, arithmetic), c.anisotropic);
    }
  }
}

TEST(NormalMethods, SmoothMoreTheMoreTheySee)
{
  const auto noisy = [](NormalMethod method)
  { return angleOf(method, glm::dvec3(1.0), 0.4, ink::Arithmetic::Single); };
  const double cell = noisy(NormalMethod::Cell);
  const double central = noisy(NormalMethod::InterpolatedNormal);
  const double regression = noisy(NormalMethod::Regression);
  EXPECT_LT(central, 0.8 * cell);
  EXPECT_LT(regression, 0.7 * central);
}

} // namespace
