// SPDX-License-Identifier: BSD-3-Clause
// Contours are the same to the last bit, however the samples of bricks are looked at: by the vectors of any
// instruction set, or one by one, as where values are interleaved with others.

#include "ContourTesting.h"
#include "UseKernels.h"

#include "Curves/Contours/GridContours.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace
{

using namespace ink::testing;

/// A rough ball that also touches the grid's border.
template <class T>
Volume<T> roughBall(double inside, double scale)
{
  std::uint64_t index = 0;
  return Volume<T>::from(cube(27, 2.1),
    [&](const glm::dvec3& p)
    { return inside + scale * (0.1 * (hashUniform(4, index++) - 0.5) - Ball.distance(p)); });
}

template <class T>
void expectSameByAnyKernels(const Volume<T>& volume, double isoValue)
{
  std::vector<T> pairs;
  for (const T value : volume.values)
  {
    pairs.insert(pairs.end(), { value, T() });
  }
  const ink::GridField<T> interleaved(volume.geometry, std::span<const T>(pairs), 2);
  for (const Eye& eye : { Eye::at({ 3.0, -4.0, 5.0 }), Eye::along({ -0.3, 0.5, 0.7 }) })
  {
    const Contours oneByOne = GridContours<T>(interleaved, isoValue).find(eye, all);
    EXPECT_GT(oneByOne.positions.size(), 100u);
    int sets = 0;
    for (const char* name : { "baseline", "avx2", "avx512" })
    {
      if (const ink::SamplingKernels* kernels = ink::samplingKernelsOf(name))
      {
        SCOPED_TRACE(name);
        const UseKernels use(kernels);
        expectSame(GridContours<T>(volume.field(), isoValue).find(eye, all), oneByOne);
        ++sets;
      }
    }
    EXPECT_GE(sets, 1);
  }
}

template <class T>
void expectSameByAnyKernels(double inside, double scale)
{
  SCOPED_TRACE("inside " + std::to_string(inside));
  expectSameByAnyKernels(roughBall<T>(inside, scale), inside + 0.01);
}

TEST(GridContours, SameByAnyKernels)
{
  expectSameByAnyKernels<signed char>(-20.0, 60.0);
  expectSameByAnyKernels<unsigned char>(150.0, 90.0);
  expectSameByAnyKernels<short>(-3000.0, 10000.0);
  expectSameByAnyKernels<unsigned short>(40000.0, 15000.0);
  expectSameByAnyKernels<int>(1e9, 1e8);
  expectSameByAnyKernels<unsigned int>(3e9, 1e8);
  expectSameByAnyKernels<long>(1e18, 1e17);
  expectSameByAnyKernels<unsigned long long>(1e19, 1e18);
  expectSameByAnyKernels<float>(0.0, 3.0);
  expectSameByAnyKernels<double>(0.0, 1e250);
}

TEST(GridContours, MissingSamplesAreTheSameByAnyKernels)
{
  // Far from the surface, next to it, and on it, where chains end.
  for (const double missing :
    { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
  {
    auto volume = roughBall<float>(0.0, 3.0);
    for (std::size_t n = 11; n < volume.values.size(); n += 97)
    {
      volume.values[n] = static_cast<float>(missing);
    }
    expectSameByAnyKernels(volume, 0.01);
  }
}

} // namespace
