// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Threads.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

TEST(Threads, FollowTheEnvironment)
{
  unsetenv("VTK_SMP_MAX_THREADS");
  const int available = ink::threadCount();
  EXPECT_GE(available, 1);
  setenv("VTK_SMP_MAX_THREADS", "1", 1);
  EXPECT_EQ(ink::threadCount(), 1);
  setenv("VTK_SMP_MAX_THREADS", std::to_string(available + 1).c_str(), 1);
  EXPECT_EQ(ink::threadCount(), available);
  for (const char* unusable : { "0", "-2", "many", "" })
  {
    setenv("VTK_SMP_MAX_THREADS", unusable, 1);
    EXPECT_EQ(ink::threadCount(), available) << "VTK_SMP_MAX_THREADS=" << unusable;
  }
  unsetenv("VTK_SMP_MAX_THREADS");
}
