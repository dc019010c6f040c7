// SPDX-License-Identifier: BSD-3-Clause
#include "Core/DidYouMean.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

TEST(DidYouMean, NamesTheNearestWord)
{
  const std::vector<std::string> words{ "Sharpness", "Orientation", "Fade", "FadeBySize" };
  EXPECT_EQ(ink::didYouMean("sharpnes", words), "; did you mean 'Sharpness'?");      // a letter left out
  EXPECT_EQ(ink::didYouMean("Orietnation", words), "; did you mean 'Orientation'?"); // two swapped
  EXPECT_EQ(ink::didYouMean("Fades", words), "; did you mean 'Fade'?");              // one too many
  EXPECT_EQ(ink::didYouMean("FADEBYSIZE", words), "; did you mean 'FadeBySize'?");   // case
}

TEST(DidYouMean, SaysNothingWhereNoneIsNear)
{
  EXPECT_EQ(ink::didYouMean("Sharpness", {}), "");
  EXPECT_EQ(ink::didYouMean("xyzzy", { "Fade", "Orientation" }), "");
  // More than a third of the letters differ, or half of the known word's.
  EXPECT_EQ(ink::didYouMean("Foto", { "Fade" }), "");
  EXPECT_EQ(ink::didYouMean("q", { "no" }), "");
}
