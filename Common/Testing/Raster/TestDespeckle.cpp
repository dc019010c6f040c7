// SPDX-License-Identifier: BSD-3-Clause
#include "CoverageImages.h"
#include "Raster/Despeckle.h"
#include "SampledMeshes.h"

#include <gtest/gtest.h>

namespace
{

using ink::test::onThreads;
using namespace ink::testing;

Picture without(
  Picture picture, float shortest, unsigned char threshold = 1, const ink::raster::CutBorders& cut = {})
{
  ink::raster::despeckle(picture.image(), shortest, threshold, cut);
  return picture;
}

} // namespace

TEST(Despeckle, ErasesWhatIsShorter)
{
  // Straight rows of 1 to 30 pixels, and as many pixels on diagonals, sqrt(2) as long.
  Picture rows(32, 64);
  Picture diagonals(40, 1300);
  for (int length = 1; length <= 30; ++length)
  {
    for (int i = 0; i < length; ++i)
    {
      rows.at(i, 2 * length) = 255;
      diagonals.at(i, 42 * length + i) = 255;
    }
  }
  for (int shortest = 1; shortest <= 31; ++shortest)
  {
    const Picture left = without(rows, static_cast<float>(shortest));
    EXPECT_EQ(countSpots(left), 31 - shortest) << shortest;
    EXPECT_EQ(left.inkCount(), (30 + shortest) * (31 - shortest) / 2) << shortest;
    int longEnough = 0;
    for (int length = 1; length <= 30; ++length)
    {
      longEnough += 1.0 + (length - 1) * std::sqrt(2.0) >= shortest ? 1 : 0;
    }
    EXPECT_EQ(countSpots(without(diagonals, static_cast<float>(shortest))), longEnough) << shortest;
  }
}

TEST(Despeckle, SeesThatInkHangsTogether)
{
  // A spiral is one spot, though each of its pieces is short in each row; alone, the dot in it is not.
  const Picture spiral({ "#########", "#.......#", "#.#####.#", "#.#...#.#", "#.#.#.#.#", "#.#...#.#",
    "#.###.#.#", "#.....#.#", "#######.#" });
  Picture expected = spiral;
  expected.at(4, 4) = 0;
  EXPECT_EQ(without(spiral, 8.0f), expected);
  EXPECT_EQ(without(spiral, 13.0f).inkCount(), 0);
  // By corners only.
  const Picture zigzag({ "#.#.#.#.#", ".#.#.#.#." });
  EXPECT_EQ(without(zigzag, 9.0f), zigzag);
}

TEST(Despeckle, KeepsTheRestExactly)
{
  const Picture lines = randomLines(300, 200, 2.0, 1);
  Picture dusty = lines;
  Picture dust(300, 200);
  for (int y = 2; y < 198; y += 5)
  {
    for (int x = 2; x < 298; x += 5)
    {
      int near = 0;
      for (int i = 0; i < 16; ++i)
      {
        near += lines.at(x - 1 + i % 4, y - 1 + i / 4);
      }
      if (near == 0) // 2 x 2 pixels
      {
        dusty.at(x, y) = dusty.at(x + 1, y) = dusty.at(x, y + 1) = dusty.at(x + 1, y + 1) = 200;
      }
    }
  }
  ASSERT_GT(countSpots(dusty), countSpots(lines) + 100);
  EXPECT_EQ(without(dusty, 3.0f), without(lines, 3.0f));
  EXPECT_EQ(without(without(dusty, 9.0f), 9.0f), without(dusty, 9.0f));
}

TEST(Despeckle, TreatsFaintInkAsWhatItBelongsTo)
{
  const Picture picture({ "..1111111111..1111..", ".1##########1.1##1..", "..1111111111..1111..",
    "....................", "1.11...1111111111111" });
  const Picture expected({ "..1111111111........", ".1##########1.......", "..1111111111........",
    "....................", ".......1111111111111" });
  EXPECT_EQ(without(picture, 8.0f, 100), expected);
  // Faint ink between two spots stays with the one that stays.
  const Picture bridge({ "##########111##" });
  EXPECT_EQ(without(bridge, 8.0f, 100), Picture({ "##########111.." }));
}

TEST(Despeckle, KeepsWhatReachesACutBorder)
{
  const Picture picture({ "..#..", ".....", "#.#.#", ".....", "..#.." });
  const auto left = [&](const ink::raster::CutBorders& cut) { return without(picture, 2.0f, 1, cut); };
  EXPECT_EQ(left({}).inkCount(), 0);
  EXPECT_EQ(left({ .left = true }), Picture({ ".....", ".....", "#....", ".....", "....." }));
  EXPECT_EQ(left({ .right = true }), Picture({ ".....", ".....", "....#", ".....", "....." }));
  EXPECT_EQ(left({ .bottom = true }), Picture({ "..#..", ".....", ".....", ".....", "....." }));
  EXPECT_EQ(left({ .top = true }), Picture({ ".....", ".....", ".....", ".....", "..#.." }));
  // A spot's faint rim may belong to ink beyond the border.
  EXPECT_EQ(without(Picture({ "111#...", "......." }), 3.0f, 100, { .left = true }),
    Picture({ "111....", "......." }));
}

TEST(Despeckle, IsTheSameMirroredAndOnAnyNumberOfThreads)
{
  for (const double share : { 0.02, 0.2, 0.4, 0.7 })
  {
    const Picture picture = randomPicture(333, 257, share, 5);
    const auto run = [&] { return without(picture, 6.0f, 90); };
    const Picture one = onThreads(1, run);
    EXPECT_EQ(one, onThreads(2, run));
    EXPECT_EQ(without(picture.mirrored(), 6.0f, 90).mirrored(), one);
    EXPECT_LT(one.inkCount(), picture.inkCount());
  }
}

TEST(Despeckle, OfExtremes)
{
  for (const auto& [width, height] :
    { std::pair(0, 0), { 0, 5 }, { 1, 1 }, { 1, 40 }, { 40, 1 }, { 130, 130 } })
  {
    const Picture empty(width, height);
    const Picture full(width, height, 255);
    EXPECT_EQ(without(empty, 10.0f), empty);
    EXPECT_EQ(without(full, 1.0f), full);
    EXPECT_EQ(without(full, std::numeric_limits<float>::infinity()), empty);
    EXPECT_EQ(without(full, std::numeric_limits<float>::quiet_NaN()), full);
    EXPECT_EQ(without(full, -3.0f, 0), full);
    EXPECT_EQ(without(full, 39.0f), width < 40 && height < 40 ? empty : full);
  }
  std::vector<unsigned char> pixels(5);
  EXPECT_THROW(ink::raster::despeckle({ pixels, 2, 3 }, 2.0f, 1), std::invalid_argument);
  EXPECT_THROW(ink::raster::despeckle({ pixels, -1, -5 }, 2.0f, 1), std::invalid_argument);
}
