// SPDX-License-Identifier: BSD-3-Clause
#include "CoverageImages.h"
#include "Raster/Dash.h"
#include "Raster/Thin.h"
#include "SampledMeshes.h"

#include <gtest/gtest.h>

#include <limits>

namespace
{

using ink::test::onThreads;
using namespace ink::testing;

Picture dashed(Picture picture, float dash, float gap)
{
  Picture thin = picture;
  ink::raster::thin(thin.image(), 1);
  ink::raster::dash(picture.image(), ink::raster::trace(thin.image()), dash, gap);
  return picture;
}

double inkOf(const Picture& picture)
{
  double sum = 0.0;
  for (const unsigned char pixel : picture.pixels)
  {
    sum += pixel / 255.0;
  }
  return sum;
}

Picture ring(double halfWidth)
{
  Picture picture(201, 201);
  picture.draw([&](int x, int y) { return std::abs(std::hypot(x - 100, y - 100) - 80.0) <= halfWidth; });
  return picture;
}

} // namespace

TEST(Dash, BeginsAndEndsALineWithAWholeDash)
{
  // Five dashes of 8 and four gaps of 5 from pixel 2 to 62.
  Picture line(65, 3);
  line.draw([](int x, int y) { return y == 1 && x >= 2 && x <= 62; });
  const Picture result = dashed(line, 8.0f, 5.0f);
  for (int x = 2; x <= 62; ++x)
  {
    const int within = (x - 2) % 13;
    const bool isEnd = x == 2 || x == 62;
    const int expected = within == 0 || within == 8 ? (isEnd ? 255 : 128) : within < 8 ? 255 : 0;
    EXPECT_EQ(result.at(x, 1), expected) << x;
  }
  // A little longer or shorter for another number of them.
  EXPECT_EQ(countSpots(dashed(line, 7.8f, 5.2f)), 5);
  EXPECT_EQ(countSpots(dashed(line, 8.5f, 4.5f)), 5);
  EXPECT_EQ(countSpots(dashed(line, 3.0f, 3.0f)), 11);
}

TEST(Dash, LeavesShortLinesWhole)
{
  for (int length = 1; length <= 12; ++length)
  {
    Picture line(20, 5);
    line.draw([&](int x, int y) { return y >= 1 && y <= 3 && x >= 2 && x < 2 + length; });
    EXPECT_EQ(dashed(line, 10.0f, 8.0f), line) << length;
  }
}

TEST(Dash, CutsWideLinesAcross)
{
  Picture line(130, 21);
  line.draw([](int x, int y) { return std::abs(y - 10) <= 4 && x >= 5 && x < 125; });
  const Picture result = dashed(line, 12.0f, 8.0f);
  EXPECT_EQ(countSpots(result), 6);
  for (int x = 0; x < 130; ++x)
  {
    for (int y = 0; y < 21; ++y)
    {
      EXPECT_EQ(result.at(x, y), std::abs(y - 10) <= 4 ? result.at(x, 10) : 0) << x << ' ' << y;
    }
  }
}

TEST(Dash, GoesAroundLoops)
{
  for (const double halfWidth : { 0.6, 2.5 })
  {
    const Picture whole = ring(halfWidth);
    const Picture result = dashed(whole, 12.0f, 6.0f);
    // On the grid the circle is up to 8 % longer.
    const double period = 2 * 3.14159 * 80.0 / countSpots(result);
    EXPECT_GT(period, 16.0);
    EXPECT_LT(period, 18.5);
    EXPECT_NEAR(inkOf(result) / inkOf(whole), 2.0 / 3.0, 0.03);
  }
}

TEST(Dash, KeepsJunctions)
{
  Picture cross(101, 101);
  cross.draw([](int x, int y) { return x == 50 || y == 50; });
  const Picture result = dashed(cross, 6.0f, 6.0f);
  for (int i = 47; i <= 53; ++i)
  {
    EXPECT_EQ(result.at(50, i), 255);
    EXPECT_EQ(result.at(i, 50), 255);
  }
  EXPECT_LT(inkOf(result), 0.7 * inkOf(cross));
}

/// Dashes and gaps too short to see leave as much ink as they would.
TEST(Dash, MakesAGrayOfShortOnes)
{
  const Picture whole = ring(2.5);
  for (const auto& [dash, gap] : { std::pair(0.1f, 0.1f), { 0.3f, 0.01f }, { 0.02f, 0.08f }, { 0.7f, 0.2f } })
  {
    EXPECT_NEAR(inkOf(dashed(whole, dash, gap)) / inkOf(whole), dash / (dash + gap), 0.02)
      << dash << ' ' << gap;
  }
}

TEST(Dash, AddsNoInkAndIsTheSameOnAnyNumberOfThreads)
{
  const Picture lines = randomLines(300, 200, 3.0, 2);
  const auto run = [&] { return dashed(lines, 10.0f, 6.0f); };
  const Picture one = onThreads(1, run);
  EXPECT_EQ(one, onThreads(2, run));
  for (std::size_t i = 0; i < one.pixels.size(); ++i)
  {
    ASSERT_LE(one.pixels[i], lines.pixels[i]);
  }
  EXPECT_NEAR(inkOf(one) / inkOf(lines), 0.65, 0.08);
  EXPECT_GT(inkOf(dashed(lines, 10.0f, 3.0f)), inkOf(one));
}

TEST(Dash, OfExtremes)
{
  constexpr float infinity = std::numeric_limits<float>::infinity();
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  const Picture whole = ring(1.5);
  for (const auto& [dash, gap] : { std::pair(0.0f, 5.0f), { 5.0f, 0.0f }, { -1.0f, 5.0f }, { 5.0f, -1.0f },
         { nan, 5.0f }, { 5.0f, nan }, { infinity, 5.0f }, { 5.0f, infinity } })
  {
    EXPECT_EQ(dashed(whole, dash, gap), whole) << dash << ' ' << gap;
  }
  EXPECT_GT(dashed(whole, 1e-3f, 1e-3f).inkCount(), 0);
  Picture picture = whole;
  ink::raster::dash(picture.image(), {}, 5.0f, 5.0f); // ink without lines
  EXPECT_EQ(picture, whole);
  const std::vector<ink::raster::TracedLine> empty(2);
  ink::raster::dash(picture.image(), empty, 5.0f, 5.0f);
  EXPECT_EQ(picture, whole);
  const std::vector<ink::raster::TracedLine> outside{ { { 200, 200 }, { 201, 201 } } };
  EXPECT_THROW(ink::raster::dash(picture.image(), outside, 5.0f, 5.0f), std::invalid_argument);
  EXPECT_THROW(ink::raster::dash({ picture.pixels, 3, 3 }, {}, 5.0f, 5.0f), std::invalid_argument);
}
