// SPDX-License-Identifier: BSD-3-Clause
#include "Pattern.h"

#include <gtest/gtest.h>

namespace
{

using ink::io::Pattern;
using Groups = std::vector<std::string>;

} // namespace

TEST(Pattern, MatchesAllOfAText)
{
  const Pattern size(R"((\d+)x(\d+)(?::(\w+))?)");
  EXPECT_EQ(size.match("16x9"), (Groups{ "16x9", "16", "9", "" }));
  EXPECT_EQ(size.match("16x9:uint8"), (Groups{ "16x9:uint8", "16", "9", "uint8" }));
  EXPECT_TRUE(size.match(" 16x9").empty());
  EXPECT_TRUE(size.match("16x9 ").empty());
  EXPECT_TRUE(size.match("").empty());
}

TEST(Pattern, IgnoresCaseWhereAsked)
{
  EXPECT_TRUE(Pattern("mib").match("MiB").empty());
  EXPECT_EQ(Pattern("mib", true).match("MiB"), Groups{ "MiB" });
}

TEST(Pattern, SearchesForTheFirstPart)
{
  const Pattern number(R"((\d)\d*)");
  EXPECT_EQ(number.search("a 12 b 34"), (Groups{ "12", "1" }));
  EXPECT_TRUE(number.search("none").empty());
}

TEST(Pattern, ReplacesAllParts)
{
  EXPECT_EQ(Pattern(R"(\s*\n\s*)").replace("a \n b\nc", " "), "a b c");
}
