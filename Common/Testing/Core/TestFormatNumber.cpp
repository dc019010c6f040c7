// SPDX-License-Identifier: BSD-3-Clause
#include "Core/FormatNumber.h"

#include <gtest/gtest.h>

TEST(FormatNumber, HasSevenDigitsAndNoMinusZero)
{
  EXPECT_EQ(ink::formatNumber(-0.0), "0");
  EXPECT_EQ(ink::formatNumber(1.0 / 3.0), "0.3333333");
  const int dimensions[3] = { 2, 30, 400 };
  EXPECT_EQ(ink::formatDimensions(dimensions), "2 x 30 x 400");
}
