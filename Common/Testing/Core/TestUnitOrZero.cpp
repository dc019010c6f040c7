// SPDX-License-Identifier: BSD-3-Clause
#include "Core/UnitOrZero.h"

#include <gtest/gtest.h>

#include <limits>

TEST(UnitOrZero, HasLengthOneOrNone)
{
  EXPECT_EQ(ink::unitOrZero(glm::dvec3(3.0, 0.0, -4.0)), glm::dvec3(0.6, 0.0, -0.8));
  EXPECT_EQ(ink::unitOrZero(glm::vec3(0.0f, -1e-15f, 0.0f)), glm::vec3(0.0f, -1.0f, 0.0f));
  EXPECT_EQ(ink::unitOrZero(glm::vec3(0.0f)), glm::vec3(0.0f));
  // Squares are below and above what there are numbers for.
  EXPECT_EQ(ink::unitOrZero(glm::dvec3(1e-200)), glm::dvec3(0.0));
  EXPECT_EQ(ink::unitOrZero(glm::dvec3(1e200)), glm::dvec3(0.0));
  for (const double bad :
    { std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN() })
  {
    EXPECT_EQ(ink::unitOrZero(glm::dvec3(1.0, bad, 0.0)), glm::dvec3(0.0));
  }
}
