// SPDX-License-Identifier: BSD-3-Clause
#include "CoverageImages.h"
#include "Raster/Dilate.h"
#include "SampledMeshes.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>

namespace
{

using ink::test::onThreads;
using namespace ink::testing;

Picture grown(Picture picture, float radius)
{
  ink::raster::dilate(picture.image(), radius);
  return picture;
}

/// How wide the ink of a column is, in pixels.
double widthAt(const Picture& picture, int x)
{
  double width = 0.0;
  for (int y = 0; y < picture.height; ++y)
  {
    width += picture.at(x, y) / 255.0;
  }
  return width;
}

} // namespace

TEST(Dilate, WidensALineByTwiceTheRadius)
{
  Picture line(60, 60);
  line.draw([](int, int y) { return std::abs(y - 30) <= 4; });
  const auto middleWidth = [&](float radius) { return widthAt(grown(line, radius), 30); };
  for (const float radius : { 0.0f, 0.25f, 0.5f, 1.0f, 1.75f, 6.0f, 20.0f, -0.25f, -0.5f, -1.0f, -3.25f })
  {
    EXPECT_NEAR(middleWidth(radius), 9.0 + 2.0 * radius, 0.02) << radius;
  }
  EXPECT_EQ(middleWidth(-5.5f), 0.0);
}

TEST(Dilate, MakesOfAPointADisc)
{
  Picture point(41, 41);
  point.at(20, 20) = 200;
  for (const float radius : { 0.3f, 1.0f, 2.5f, 7.0f, 15.9f })
  {
    const Picture disc = grown(point, radius);
    for (int y = 0; y < 41; ++y)
    {
      for (int x = 0; x < 41; ++x)
      {
        const double expected = 200 * std::clamp(radius + 1.0 - std::hypot(x - 20, y - 20), 0.0, 1.0);
        ASSERT_NEAR(disc.at(x, y), expected, 1.5) << radius << ' ' << x << ' ' << y;
      }
    }
  }
}

TEST(Dilate, IsTheLargestInkWithinTheRadiusOfAnyPicture)
{
  for (const double share : { 0.05, 0.5, 1.0 })
  {
    const Picture picture = randomPicture(70, 50, share, 7);
    const float radius = 2.6f;
    const Picture more = grown(picture, radius);
    for (int y = 0; y < 50; ++y)
    {
      for (int x = 0; x < 70; ++x)
      {
        double most = 0.0;
        for (int v = 0; v < 50; ++v)
        {
          for (int u = 0; u < 70; ++u)
          {
            most = std::max(
              most, picture.at(u, v) * std::clamp(radius + 1.0 - std::hypot(u - x, v - y), 0.0, 1.0));
          }
        }
        ASSERT_NEAR(more.at(x, y), most, 1.5) << share << ' ' << x << ' ' << y;
      }
    }
  }
}

TEST(Dilate, NeverLosesInkWithALargerRadius)
{
  for (const double share : { 0.05, 0.5, 0.95 })
  {
    Picture before = randomPicture(120, 90, share, 3);
    const Picture picture = before;
    before = grown(picture, -8.0f);
    for (float radius = -7.9f; radius < 5.0f; radius += 0.17f)
    {
      const Picture now = grown(picture, radius);
      for (std::size_t i = 0; i < now.pixels.size(); ++i)
      {
        ASSERT_GE(now.pixels[i], before.pixels[i]) << radius;
      }
      before = now;
    }
  }
}

TEST(Dilate, IsTheSameMirroredAndOnAnyNumberOfThreads)
{
  const Picture picture = randomLines(300, 200, 2.5, 4);
  for (const float radius : { 1.3f, -0.6f })
  {
    const auto run = [&] { return grown(picture, radius); };
    const Picture one = onThreads(1, run);
    EXPECT_EQ(one, onThreads(2, run));
    EXPECT_EQ(grown(picture.mirrored(), radius).mirrored(), one);
    EXPECT_NE(one, picture);
  }
}

TEST(Dilate, OfExtremes)
{
  constexpr float infinity = std::numeric_limits<float>::infinity();
  for (const auto& [width, height] :
    { std::pair(0, 0), { 0, 5 }, { 1, 1 }, { 1, 40 }, { 40, 1 }, { 30, 30 } })
  {
    const Picture empty(width, height);
    const Picture full(width, height, 255);
    for (const float radius : { -infinity, -2.0f, 0.0f, 0.4f, 3.0f, infinity })
    {
      EXPECT_EQ(grown(empty, radius), empty);
      EXPECT_EQ(grown(full, radius), full);
    }
    Picture one(width, height);
    if (!one.pixels.empty())
    {
      one.pixels[0] = 255;
      EXPECT_EQ(grown(one, infinity), full);
      EXPECT_EQ(grown(one, -infinity), width * height == 1 ? full : empty);
      EXPECT_EQ(grown(one, std::numeric_limits<float>::quiet_NaN()), one);
    }
  }
  std::vector<unsigned char> pixels(5);
  EXPECT_THROW(ink::raster::dilate({ pixels, 2, 3 }, 1.0f), std::invalid_argument);
}
