// SPDX-License-Identifier: BSD-3-Clause
#include "CoverageImages.h"
#include "Raster/Thin.h"
#include "Raster/Trace.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <set>

namespace
{

using namespace ink::testing;
using Line = ink::raster::TracedLine;

std::vector<Line> traced(Picture picture)
{
  return ink::raster::trace(picture.image());
}

/// Every pixel with ink is in a line, no other is; points follow each other; no way is gone twice; lines end
/// with the ink, where others meet, or where they began.
void checkLines(const Picture& picture)
{
  const std::vector<Line> lines = traced(picture);
  std::set<std::pair<int, int>> covered;
  std::set<std::array<int, 4>> ways;
  std::map<std::pair<int, int>, int> meeting;
  for (const Line& line : lines)
  {
    ASSERT_FALSE(line.empty());
    for (std::size_t i = 0; i < line.size(); ++i)
    {
      ASSERT_TRUE(picture.isIn(line[i].x, line[i].y));
      ASSERT_NE(picture.at(line[i].x, line[i].y), 0);
      covered.emplace(line[i].x, line[i].y);
      if (i > 0)
      {
        const glm::ivec2 step = line[i] - line[i - 1];
        ASSERT_TRUE(std::max(std::abs(step.x), std::abs(step.y)) == 1);
        const std::pair from(line[i - 1].x, line[i - 1].y);
        const std::pair to(line[i].x, line[i].y);
        const std::pair<int, int> a = std::min(from, to);
        const std::pair<int, int> b = std::max(from, to);
        ASSERT_TRUE(ways.insert({ a.first, a.second, b.first, b.second }).second);
        ++meeting[{ line[i].x, line[i].y }];
        ++meeting[{ line[i - 1].x, line[i - 1].y }];
      }
    }
  }
  ASSERT_EQ(static_cast<std::ptrdiff_t>(covered.size()), picture.inkCount());
  for (const Line& line : lines)
  {
    const bool isClosed = line.size() > 2 && line.front() == line.back();
    for (std::size_t i = 0; i < line.size(); ++i)
    {
      const bool isEnd = i == 0 || i + 1 == line.size();
      const int ends = meeting[{ line[i].x, line[i].y }];
      ASSERT_TRUE(isEnd ? isClosed || ends != 2 : ends == 2);
    }
  }
}

} // namespace

TEST(Trace, FollowsALineFromEndToEnd)
{
  EXPECT_EQ(traced(Picture({ ".##...", "#..#..", "....##" })),
    (std::vector<Line>{ { { 0, 1 }, { 1, 0 }, { 2, 0 }, { 3, 1 }, { 4, 2 }, { 5, 2 } } })
    // begins with the first end row by row
  );
  EXPECT_EQ(traced(Picture({ "#..", "...", ".#." })), (std::vector<Line>{ { { 0, 0 } }, { { 1, 2 } } }));
  // By sides around a corner.
  EXPECT_EQ(traced(Picture({ "##", ".#" })), (std::vector<Line>{ { { 0, 0 }, { 1, 0 }, { 1, 1 } } }));
}

TEST(Trace, ClosesLoops)
{
  const auto diamond = traced(Picture({ ".#.", "#.#", ".#." }));
  EXPECT_EQ(diamond, (std::vector<Line>{ { { 1, 0 }, { 2, 1 }, { 1, 2 }, { 0, 1 }, { 1, 0 } } }));
  Picture ring(101, 101);
  ring.draw([](int x, int y) { return std::abs(std::hypot(x - 50, y - 50) - 35.0) <= 4.0; });
  ink::raster::thin(ring.image(), 1);
  const auto lines = traced(ring);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].front(), lines[0].back());
  EXPECT_EQ(static_cast<std::ptrdiff_t>(lines[0].size()), ring.inkCount() + 1);
  // On a grid a circle is up to 8 % longer.
  const float length = ink::raster::lengthsAlong(lines[0]).back();
  EXPECT_GT(length, 2 * 3.14159f * 33.0f);
  EXPECT_LT(length, 1.09f * 2 * 3.14159f * 37.0f);
}

TEST(Trace, SplitsAtJunctions)
{
  const auto cross = traced(Picture({ "...#...", "...#...", "#######", "...#...", "...#..." }));
  ASSERT_EQ(cross.size(), 4u);
  for (const Line& line : cross)
  {
    EXPECT_TRUE(line.front() == glm::ivec2(3, 2) || line.back() == glm::ivec2(3, 2));
  }
  EXPECT_EQ(traced(Picture({ "#######", "...#...", "...#..." })).size(), 3u);
  // A loop on a stalk begins and ends where that meets it.
  EXPECT_EQ(traced(Picture({ ".....", "...#.", "###.#", "...#." })),
    (std::vector<Line>{
      { { 0, 2 }, { 1, 2 }, { 2, 2 } }, { { 2, 2 }, { 3, 3 }, { 4, 2 }, { 3, 1 }, { 2, 2 } } }));
}

TEST(Trace, CoversAnyDrawing)
{
  for (std::uint64_t seed = 0; seed < 20; ++seed)
  {
    SCOPED_TRACE(seed);
    Picture lines = randomLines(200, 150, 3.0, seed);
    ink::raster::thin(lines.image(), 64);
    ASSERT_NO_FATAL_FAILURE(checkLines(lines));
    ASSERT_NO_FATAL_FAILURE(checkLines(randomPicture(60, 50, 0.05 * static_cast<double>(seed), seed)));
  }
}

TEST(Trace, OfExtremes)
{
  for (const auto& [width, height] : { std::pair(0, 0), { 0, 5 }, { 1, 1 }, { 1, 40 }, { 40, 1 } })
  {
    EXPECT_TRUE(traced(Picture(width, height)).empty());
    const auto lines = traced(Picture(width, height, 255));
    ASSERT_EQ(lines.size(), width * height == 0 ? 0u : 1u);
    EXPECT_EQ(lines.empty() ? 0u : lines[0].size(), static_cast<std::size_t>(width * height));
  }
  EXPECT_TRUE(ink::raster::lengthsAlong({}).empty());
  std::vector<unsigned char> pixels(5);
  EXPECT_THROW(ink::raster::trace({ pixels, 2, 3 }), std::invalid_argument);
}
