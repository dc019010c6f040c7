// SPDX-License-Identifier: BSD-3-Clause
#include "CoverageImages.h"
#include "Raster/Thin.h"
#include "SampledMeshes.h"

#include <gtest/gtest.h>

namespace
{

using ink::test::onThreads;
using namespace ink::testing;

Picture thinned(Picture picture, unsigned char threshold = 1)
{
  ink::raster::thin(picture.image(), threshold);
  return picture;
}

/// The largest number of neighbors, by sides or corners, of any pixel with ink: 2 in a line without
/// branches.
int mostNeighbors(const Picture& picture)
{
  int most = 0;
  for (int y = 0; y < picture.height; ++y)
  {
    for (int x = 0; x < picture.width; ++x)
    {
      int neighbors = picture.at(x, y) != 0 ? -1 : -10;
      for (int i = 0; i < 9; ++i)
      {
        const int nx = x - 1 + i % 3;
        const int ny = y - 1 + i / 3;
        neighbors += picture.isIn(nx, ny) && picture.at(nx, ny) != 0 ? 1 : 0;
      }
      most = std::max(most, neighbors);
    }
  }
  return most;
}

} // namespace

TEST(Thin, LeavesOfThickLinesTheMiddle)
{
  for (const double degrees : { 0.0, 10.0, 30.0, 45.0, 77.0, 90.0, 135.0 })
  {
    for (const double width : { 3.0, 5.0, 9.0 })
    {
      const double angle = degrees * 3.141592653589793 / 180.0;
      const double c = std::cos(angle);
      const double s = std::sin(angle);
      Picture line(121, 121);
      line.draw(
        [&](int x, int y)
        {
          const double along = c * (x - 60) + s * (y - 60);
          const double across = -s * (x - 60) + c * (y - 60);
          return std::abs(along) <= 50 && std::abs(across) <= 0.5 * width;
        });
      const Picture thin = thinned(line);
      SCOPED_TRACE(::testing::PrintToString(degrees) + " degrees, width " + ::testing::PrintToString(width));
      EXPECT_EQ(mostNeighbors(thin), 2); // one line, without branches or staircases
      EXPECT_EQ(countSpots(thin), 1);
      double furthest = 0.0;
      double longest = 0.0;
      for (int y = 0; y < 121; ++y)
      {
        for (int x = 0; x < 121; ++x)
        {
          if (thin.at(x, y) != 0)
          {
            const double along = std::abs(c * (x - 60) + s * (y - 60));
            // The ends of a skeleton may run into a corner.
            furthest = along < 45 ? std::max(furthest, std::abs(-s * (x - 60) + c * (y - 60))) : furthest;
            longest = std::max(longest, along);
          }
        }
      }
      EXPECT_LE(furthest, 1.0);
      EXPECT_GE(longest, 50.0 - width);
    }
  }
}

TEST(Thin, LeavesOfARingARing)
{
  Picture ring(101, 101);
  ring.draw([](int x, int y) { return std::abs(std::hypot(x - 50, y - 50) - 35.0) <= 4.0; });
  const Picture thin = thinned(ring);
  EXPECT_EQ(countSpots(thin), 1);
  EXPECT_EQ(countHoles(thin), 1);
  EXPECT_EQ(mostNeighbors(thin), 2);
  for (int y = 0; y < 101; ++y)
  {
    for (int x = 0; x < 101; ++x)
    {
      if (thin.at(x, y) != 0)
      {
        EXPECT_NEAR(std::hypot(x - 50, y - 50), 35.0, 2.0) << x << ' ' << y;
      }
    }
  }
}

TEST(Thin, LeavesOfADiscAPoint)
{
  for (const double radius : { 0.0, 1.0, 2.3, 8.0, 20.0 })
  {
    Picture disc(61, 61);
    disc.draw([&](int x, int y) { return std::hypot(x - 30, y - 30) <= radius; });
    const Picture thin = thinned(disc);
    EXPECT_EQ(countSpots(thin), 1);
    EXPECT_LE(thin.inkCount(), 2) << ::testing::PrintToString(thin);
    EXPECT_NE(thin.at(30, 30), 0) << radius;
  }
}

TEST(Thin, KeepsJunctions)
{
  Picture junction(81, 81);
  junction.draw(
    [](int x, int y) {
      return (std::abs(y - 40) <= 2 && x >= 5 && x <= 75) || (std::abs(x - 40) <= 2 && y >= 40 && y <= 75);
    });
  const Picture thin = thinned(junction);
  EXPECT_EQ(countSpots(thin), 1);
  EXPECT_EQ(countHoles(thin), 0);
  for (int i = 10; i <= 70; ++i) // two arms along the middle, which may sag by a pixel where the third begins
  {
    EXPECT_TRUE(thin.at(i, 39) != 0 || thin.at(i, 40) != 0 || thin.at(i, 41) != 0) << i;
    if (i > 43)
    {
      EXPECT_NE(thin.at(40, i), 0) << i;
    }
  }
}

TEST(Thin, KeepsTheInkOfWhatStays)
{
  Picture line(50, 9);
  for (int x = 2; x < 48; ++x)
  {
    for (int y = 2; y < 7; ++y)
    {
      line.at(x, y) = static_cast<unsigned char>(y == 4 ? 50 + 4 * x : 30);
    }
  }
  const Picture all = thinned(line);
  const Picture strong = thinned(line, 50); // one pixel wide already
  for (int x = 5; x < 45; ++x)
  {
    EXPECT_EQ(all.at(x, 4), 50 + 4 * x);
  }
  for (int x = 2; x < 48; ++x)
  {
    EXPECT_EQ(strong.at(x, 4), 50 + 4 * x);
  }
  EXPECT_EQ(strong.inkCount(), 46);
}

TEST(Thin, KeepsTheTopologyOfAnything)
{
  const auto check = [](const Picture& picture)
  {
    const Picture thin = thinned(picture);
    ASSERT_EQ(countSpots(thin), countSpots(picture)) << ::testing::PrintToString(picture);
    ASSERT_EQ(countHoles(thin), countHoles(picture)) << ::testing::PrintToString(picture);
    ASSERT_EQ(thinned(thin), thin) << ::testing::PrintToString(picture);
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
    {
      ASSERT_TRUE(thin.pixels[i] == 0 || thin.pixels[i] == picture.pixels[i]);
    }
  };
  // Every picture of 4 x 4 pixels.
  for (unsigned bits = 0; bits < 65536; ++bits)
  {
    Picture picture(4, 4);
    for (unsigned i = 0; i < 16; ++i)
    {
      picture.pixels[i] = bits >> i & 1 ? 255 : 0;
    }
    ASSERT_NO_FATAL_FAILURE(check(picture));
  }
  for (std::uint64_t seed = 0; seed < 20; ++seed)
  {
    ASSERT_NO_FATAL_FAILURE(check(randomPicture(90, 70, 0.1 + 0.04 * static_cast<double>(seed), seed)));
    ASSERT_NO_FATAL_FAILURE(check(randomLines(200, 150, 1.0 + 0.2 * static_cast<double>(seed), seed)));
  }
}

TEST(Thin, IsTheSameOnAnyNumberOfThreads)
{
  const Picture picture = randomLines(500, 400, 7.0, 3);
  const auto run = [&] { return thinned(picture); };
  EXPECT_EQ(onThreads(1, run), onThreads(2, run));
}

TEST(Thin, OfExtremes)
{
  for (const auto& [width, height] : { std::pair(0, 0), { 0, 5 }, { 1, 1 }, { 2, 2 }, { 1, 40 }, { 40, 1 } })
  {
    const Picture empty(width, height);
    EXPECT_EQ(thinned(empty), empty);
    const Picture full(width, height, 255);
    const Picture thin = thinned(full);
    EXPECT_EQ(countSpots(thin), full.pixels.empty() ? 0 : 1);
    if (std::min(width, height) == 1)
    {
      EXPECT_EQ(thin, full); // a line already
    }
  }
  EXPECT_LE(thinned(Picture(200, 200, 255)).inkCount(), 2);
  const Picture faint(20, 20, 99);
  EXPECT_EQ(thinned(faint, 100), Picture(20, 20));
  EXPECT_EQ(thinned(faint, 0), thinned(faint, 1));
  std::vector<unsigned char> pixels(5);
  EXPECT_THROW(ink::raster::thin({ pixels, 2, 3 }, 1), std::invalid_argument);
}
