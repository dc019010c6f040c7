// SPDX-License-Identifier: BSD-3-Clause
#include "Fields/Resampling/AxisResampling.h"
#include "Fields/Resampling/TileResampler.h"
#include "SampledVolume.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace
{

using ink::AxisResampling;

/// A function of samples at positions, resampled.
template <class Function>
double resampled(const AxisResampling& axis, int position, const Function& function)
{
  double sum = 0.0;
  const int first = position / axis.subdivision() - axis.reach();
  const auto weights = axis.weights(position);
  for (int n = 0; n < axis.taps(); ++n)
  {
    EXPECT_TRUE((first + n >= 0 && first + n < axis.samples()) || weights[n] == 0.0)
      << "the weight of sample " << first + n << " at position " << position;
    sum += weights[n] * function(static_cast<double>(first + n));
  }
  return sum;
}

TEST(AxisResampling, WeightsSumToOneEverywhere)
{
  for (const double deviation : { 0.0, 0.1, 0.7, 3.0 })
  {
    for (const int subdivision : { 1, 2, 3, 8 })
    {
      for (const int samples : { 2, 3, 5, 40 })
      {
        const AxisResampling axis(deviation, subdivision, samples);
        ASSERT_EQ(axis.positions(), (samples - 1) * subdivision + 1);
        for (int p = 0; p < axis.positions(); ++p)
        {
          EXPECT_NEAR(resampled(axis, p, [](double) { return 1.0; }), 1.0, 1e-12)
            << deviation << ' ' << subdivision << ' ' << samples << " at " << p;
        }
      }
    }
  }
}

TEST(AxisResampling, WithoutSmoothingSamplesStayAndQuadraticsAreInterpolated)
{
  const auto quadratic = [](double x) { return 3.0 - 2.0 * x + 0.25 * x * x; };
  const AxisResampling axis(0.0, 4, 20);
  for (int p = 0; p < axis.positions(); ++p)
  {
    const bool atEnd = p < 4 || p > axis.positions() - 5;
    const double exact = quadratic(p / 4.0);
    EXPECT_NEAR(resampled(axis, p, quadratic), exact, p % 4 == 0 || !atEnd ? 1e-12 : 0.05) << p;
  }
  EXPECT_EQ(AxisResampling(0.0, 1, 20).taps(), 1);
}

TEST(AxisResampling, LinesStayLinesUpToTheEndsWithoutSmoothing)
{
  for (const int samples : { 2, 3, 4, 9 })
  {
    const AxisResampling axis(0.0, 3, samples);
    for (int p = 0; p < axis.positions(); ++p)
    {
      EXPECT_NEAR(resampled(axis, p, [](double x) { return 5.0 * x - 1.0; }), 5.0 * p / 3.0 - 1.0, 1e-12);
    }
  }
}

TEST(AxisResampling, HasTheGaussiansVarianceAndLeavesTheMean)
{
  for (const double deviation : { 0.3, 0.7, 1.0, 2.5 })
  {
    for (const int subdivision : { 1, 2, 5 })
    {
      const AxisResampling axis(deviation, subdivision, 60);
      for (int p = 25 * subdivision; p < 26 * subdivision; ++p)
      {
        const double x = static_cast<double>(p) / subdivision;
        EXPECT_NEAR(resampled(axis, p, [](double s) { return s; }), x, 2e-3);
        // What is cut off at the rim belongs to the largest distances.
        EXPECT_NEAR(resampled(axis, p, [x](double s) { return (s - x) * (s - x); }), deviation * deviation,
          0.02 * std::max(1.0, deviation * deviation));
      }
    }
  }
}

TEST(AxisResampling, FourthOrderKeepsParabolasAndRemovesLessNoise)
{
  for (const double deviation : { 0.5, 1.0, 2.0 })
  {
    const AxisResampling fourth(deviation, 2, 60, ink::SmoothingKernel::FourthOrder);
    const AxisResampling gaussian(deviation, 2, 60);
    const int p = 61;
    const auto square = [](double s) { return (s - 30.5) * (s - 30.5); };
    EXPECT_NEAR(resampled(fourth, p, square), 0.0, 0.03 * std::max(1.0, deviation * deviation)) << deviation;
    const auto noiseOf = [](std::span<const double> weights)
    { return std::inner_product(weights.begin(), weights.end(), weights.begin(), 0.0); };
    EXPECT_GT(noiseOf(fourth.weights(p)), noiseOf(gaussian.weights(p)));
    EXPECT_LT(noiseOf(fourth.weights(p)), 1.0);
    EXPECT_GT(fourth.gain(), gaussian.gain());
  }
}

/// Else a surface near the side of a volume has rings.
TEST(AxisResampling, IsAsSmoothNearTheEndsAsInside)
{
  for (const auto form : { ink::SmoothingKernel::Gaussian, ink::SmoothingKernel::FourthOrder })
  {
    const AxisResampling axis(1.5, 32, 60, form);
    const auto bendOf = [&](int begin, int end, double edge)
    {
      const auto step = [&](double x) { return x < edge ? 0.0 : 1.0; };
      double most = 0.0;
      for (int p = begin; p < end; ++p)
      {
        most = std::max(most,
          std::abs(
            resampled(axis, p - 1, step) - 2.0 * resampled(axis, p, step) + resampled(axis, p + 1, step)));
      }
      return most;
    };
    const double inside = bendOf(25 * 32, 35 * 32, 29.5);
    // The end and negligible weights bend it more, up to three times, and nodes that jump twenty times.
    EXPECT_LT(bendOf(1, 10 * 32, 3.5), 5.0 * inside);
    EXPECT_LT(bendOf(49 * 32, axis.positions() - 1, 55.5), 5.0 * inside);
  }
}

TEST(AxisResampling, IsSymmetric)
{
  for (const double deviation : { 0.0, 0.6, 1.7 })
  {
    for (const int samples : { 4, 30 })
    {
      const AxisResampling axis(deviation, 3, samples);
      const auto bump = [&](double x) { return std::exp(-0.1 * x * x) + 0.3 * x; };
      for (int p = 0; p < axis.positions(); ++p)
      {
        const auto mirrored = [&](double x) { return bump(samples - 1 - x); };
        EXPECT_NEAR(resampled(axis, p, bump), resampled(axis, axis.positions() - 1 - p, mirrored), 1e-12);
      }
    }
  }
}

/// So that pieces of an image agree: where no sample is missing, weights do not depend on the axis' length.
TEST(AxisResampling, PartsOfAnAxisAgreeBitwise)
{
  for (const double deviation : { 0.0, 0.7, 2.0 })
  {
    const AxisResampling whole(deviation, 3, 50);
    const int reach = whole.reach();
    for (const int begin : { 0, 7, 50 - 2 * reach - 6 })
    {
      const int samples = 2 * reach + 6;
      const AxisResampling part(deviation, 3, samples);
      for (int p = begin == 0 ? 0 : 3 * reach; p < 3 * (samples - 2 - reach); ++p)
      {
        const auto a = part.weights(p);
        const auto b = whole.weights(p + 3 * begin);
        for (int n = 0; n < part.taps(); ++n)
        {
          EXPECT_EQ(a[n], b[n]) << deviation << ' ' << begin << ' ' << p;
        }
      }
    }
  }
}

TEST(AxisResampling, GainBoundsOvershoot)
{
  EXPECT_EQ(AxisResampling(0.0, 1, 9).gain(), 1.0);
  // Half way between samples: (-1 + 9 + 9 - 1) / 16.
  EXPECT_NEAR(AxisResampling(0.0, 2, 9).gain(), 1.25, 1e-12);
  EXPECT_LT(AxisResampling(1.0, 2, 9).gain(), 1.05);
}

TEST(AxisResampling, MissingSamplesOfATileDoNotCount)
{
  ink::testing::Volume<float> volume(ink::GridGeometry({ 12, 11, 10 }), 7.0f);
  volume.at({ 5, 5, 5 }) = std::nanf("");
  volume.at({ 0, 0, 0 }) = std::nanf("");
  const ink::GridResampling resampling = { AxisResampling(0.7, 2, 12), AxisResampling(0.5, 1, 11),
    AxisResampling(0.0, 3, 10) };
  const ink::SampleBox box = { { 1, 0, 0 }, { 23, 11, 28 } };
  ink::TileResampler<float> tile;
  tile.read(volume.field(), box, { 2, 1, 3 }, { 4, 4, 4 });
  EXPECT_TRUE(tile.anyMissing());
  EXPECT_EQ(tile.least(), 7.0f);
  EXPECT_EQ(tile.greatest(), 7.0f);
  std::vector<float> values;
  tile.resample(resampling, box, values);
  ASSERT_EQ(values.size(), box.count());
  std::size_t finite = 0;
  for (const float value : values)
  {
    finite += std::isfinite(value);
    EXPECT_TRUE(std::isnan(value) || std::abs(value - 7.0f) < 1e-4f) << value;
  }
  EXPECT_GT(finite, values.size() * 9 / 10);
}

TEST(AxisResampling, RefusesWhatIsOutOfRange)
{
  EXPECT_THROW(AxisResampling(-0.1, 1, 9), std::invalid_argument);
  EXPECT_THROW(AxisResampling(std::nan(""), 1, 9), std::invalid_argument);
  EXPECT_THROW(AxisResampling(0.0, 0, 9), std::invalid_argument);
  EXPECT_THROW(AxisResampling(0.0, 1, 1), std::invalid_argument);
}

} // namespace
