// SPDX-License-Identifier: BSD-3-Clause
// Samples that were repeated: found by whatever factor, where they were; nothing where nothing was.
#include "Statistics/RepeatedSamples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <vector>

namespace
{

using Size = std::array<int, 3>;

template <class Sample>
struct Grid
{
  Size size;
  std::vector<Sample> samples;

  Grid(const Size& dimensions)
    : size(dimensions)
    , samples(static_cast<std::size_t>(dimensions[0]) * dimensions[1] * dimensions[2])
  {
  }
  std::size_t index(int x, int y, int z) const
  {
    return (static_cast<std::size_t>(z) * this->size[1] + y) * this->size[0] + x;
  }
  /// @param of the sample at x, y, z
  template <class Of>
  Grid(const Size& dimensions, const Of& of)
    : Grid(dimensions)
  {
    for (int z = 0; z < this->size[2]; ++z)
    {
      for (int y = 0; y < this->size[1]; ++y)
      {
        for (int x = 0; x < this->size[0]; ++x)
        {
          this->at(x, y, z) = static_cast<Sample>(of(x, y, z));
        }
      }
    }
  }
  Sample& at(int x, int y, int z) { return this->samples[this->index(x, y, z)]; }
  Sample at(int x, int y, int z) const { return this->samples[this->index(x, y, z)]; }
  std::array<ink::OriginalSamples, 3> find() const
  {
    return ink::findRepeatedSamples(this->samples.data(), sizeof(Sample), this->size);
  }
};

/// Two labels, side by side in a ball.
template <class Sample>
Grid<Sample> makeBall(const Size& size)
{
  const auto away = [&](int index, std::size_t axis) { return (2 * index + 1.0) / size[axis] - 1.0; };
  return { size,
    [&](int x, int y, int z)
    {
      const double radius = std::hypot(away(x, 0), away(y, 1), away(z, 2));
      return radius < 0.8 ? (x < size[0] / 2 ? 1 : 2) : 0;
    } };
}

/// As resampling by nearest neighbors does it.
template <class Sample>
Grid<Sample> enlarge(const Grid<Sample>& small, const Size& size)
{
  const auto from = [&](int index, std::size_t axis)
  { return static_cast<int>((index + 0.5) * small.size[axis] / size[axis]); };
  return { size, [&](int x, int y, int z) { return small.at(from(x, 0), from(y, 1), from(z, 2)); } };
}

template <class Sample>
void expectFound(const Size& from, const Size& to)
{
  Grid<Sample> small = makeBall<Sample>(from);
  Grid<Sample> large = enlarge(small, to);
  const std::array found = large.find();
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double step = static_cast<double>(to[axis]) / from[axis];
    EXPECT_NEAR(found[axis].step, step, 0.02 * step) << axis;
    EXPECT_NEAR(found[axis].first, 0.5 * step - 0.5, 0.5) << axis; // as borders are those of samples
    ASSERT_EQ(found[axis].count, from[axis]) << axis;
  }
  // Taken apart they are the samples that were repeated.
  const std::vector<int> xs = found[0].indices(large.size[0]);
  const std::vector<int> ys = found[1].indices(large.size[1]);
  const std::vector<int> zs = found[2].indices(large.size[2]);
  for (int z = 0; z < from[2]; ++z)
  {
    for (int y = 0; y < from[1]; ++y)
    {
      for (int x = 0; x < from[0]; ++x)
      {
        ASSERT_EQ(large.at(xs[static_cast<std::size_t>(x)], ys[static_cast<std::size_t>(y)],
                    zs[static_cast<std::size_t>(z)]),
          small.at(x, y, z))
          << x << ' ' << y << ' ' << z;
      }
    }
  }
}

} // namespace

TEST(RepeatedSamples, FoundByWhateverFactor)
{
  expectFound<std::uint8_t>({ 24, 24, 24 }, { 48, 48, 48 });
  expectFound<std::int16_t>({ 40, 36, 32 }, { 86, 77, 70 });
  expectFound<float>({ 24, 30, 26 }, { 150, 188, 160 });
  expectFound<double>({ 26, 26, 26 }, { 78, 65, 104 });
}

TEST(RepeatedSamples, AlongTwoAxes)
{
  expectFound<std::uint8_t>({ 40, 40, 30 }, { 160, 120, 30 });
  const std::array found = enlarge(makeBall<std::uint8_t>({ 40, 40, 30 }), { 160, 120, 30 }).find();
  EXPECT_EQ(found[2].step, 1.0);
  EXPECT_EQ(found[2].first, 0.0);
}

TEST(RepeatedSamples, WhereAPartWasCutOut)
{
  const Grid<std::uint8_t> whole = enlarge(makeBall<std::uint8_t>({ 40, 40, 40 }), { 160, 160, 160 });
  const Grid<std::uint8_t> part(
    { 100, 160, 160 }, [&](int x, int y, int z) { return whole.at(x + 30, y, z); });
  const ink::OriginalSamples found = part.find()[0];
  // Blocks begin at 32, 36, ...; of the one before, two samples are left, whose middle is at the border.
  EXPECT_EQ(found.step, 4.0);
  EXPECT_NEAR(std::fmod(found.first + 30.0 - 1.5, 4.0), 0.0, 1e-12);
}

TEST(RepeatedSamples, NothingWhereNothingWas)
{
  const auto expectNone = [](const auto& grid)
  {
    for (const ink::OriginalSamples& found : grid.find())
    {
      EXPECT_EQ(found.step, 1.0);
      EXPECT_EQ(found.first, 0.0);
    }
  };
  expectNone(makeBall<std::uint8_t>({ 48, 40, 44 }));
  Grid<float> noise({ 20, 21, 22 });
  std::mt19937 random(1);
  std::generate(noise.samples.begin(), noise.samples.end(), [&] { return static_cast<float>(random()); });
  expectNone(noise);
  // Shapes whose flat sides stand on a regular grid because that is how they were made.
  const Size size{ 192, 192, 192 };
  const auto expectNoneOf = [&](const auto& isInside)
  { expectNone(Grid<std::uint8_t>(size, [&](int x, int y, int z) { return isInside(x, y, z) ? 1 : 0; })); };
  const auto inside = [](int x, int y, int z)
  { return x >= 10 && x < 180 && y >= 10 && y < 180 && z >= 10 && z < 180; };
  const auto odd = [](int x, int y, int z) { return (x / 4) % 2 + (y / 4) % 2 + (z / 4) % 2; };
  const auto fins = [&](int x, int y, int z) { return inside(x, y, z) && (z < 40 || (x / 4) % 2 > 0); };
  const auto lattice = [&](int x, int y, int z) { return odd(x, y, z) > 1; };
  const auto board = [&](int x, int y, int z) { return odd(x, y, z) % 2 > 0; };
  const auto stairs = [&](int x, int y, int z) { return inside(x, y, z) && z / 4 < x / 4; };
  expectNoneOf(fins);
  expectNoneOf(lattice);
  expectNoneOf(board);
  expectNoneOf(stairs);
  // Repeated along one axis alone, as by slices that were copied.
  expectNone(enlarge(makeBall<std::uint8_t>({ 40, 40, 30 }), { 40, 40, 90 }));
  // Too few borders, and too few of a grid with this one and that one.
  Grid<std::uint8_t> boxes({ 64, 64, 64 });
  for (const int x : { 4, 10, 40, 60 })
  {
    boxes.at(x, x, x) = 1;
    boxes.at(x + 1, x, x) = 1;
  }
  expectNone(boxes);
  expectNone(Grid<std::uint8_t>({ 32, 32, 32 }));
  expectNone(Grid<std::uint8_t>({ 1, 1, 1 }));
  expectNone(makeBall<std::uint8_t>({ 3, 2, 1 }));
  // One voxel that somebody has changed since.
  Grid<std::uint8_t> changed = enlarge(makeBall<std::uint8_t>({ 24, 24, 24 }), { 72, 72, 72 });
  changed.at(31, 31, 31) = 7;
  expectNone(changed);
}

TEST(RepeatedSamples, OtherSizesAreRefused)
{
  EXPECT_THROW(ink::findRepeatedSamples("abc", 3, { 1, 1, 1 }), std::invalid_argument);
}
