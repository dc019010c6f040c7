// SPDX-License-Identifier: BSD-3-Clause
#include "Words.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

TEST(Words, LinesComeWithoutTheirEnds)
{
  std::string_view text = "one\r\n\ntwo";
  std::vector<std::string> lines;
  for (std::string_view line; ink::io::nextLine(text, line);)
  {
    lines.emplace_back(line);
  }
  EXPECT_EQ(lines, (std::vector<std::string>{ "one", "", "two" }));
}

TEST(Words, AreWhatStandsBetweenSpaces)
{
  std::string_view text = " \tsolid\n  box ";
  EXPECT_EQ(ink::io::nextWord(text), "solid");
  EXPECT_EQ(ink::io::nextWord(text), "box");
  EXPECT_EQ(ink::io::nextWord(text), "");
}

TEST(Words, NumbersAreAllOfAWord)
{
  EXPECT_EQ(ink::io::numberIn("+1.5e2"), 150.0);
  EXPECT_TRUE(std::isnan(ink::io::numberIn("nan").value()));
  // Too large and too small for a double: as near as it gets.
  EXPECT_EQ(ink::io::numberIn("1e999"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(ink::io::numberIn("1e-999"), 0.0);
  for (const char* word : { "", "1.5x", "1,5", "x", "+" })
  {
    EXPECT_FALSE(ink::io::numberIn(word)) << word;
  }
}

TEST(Words, AreShortenedAndMadePrintable)
{
  EXPECT_EQ(ink::io::shortened("a\tb\x01"), "a?b?");
  EXPECT_EQ(ink::io::shortened(std::string(40, 'x')), std::string(40, 'x'));
  EXPECT_EQ(ink::io::shortened(std::string(41, 'x')), std::string(40, 'x') + "...");
}
