#include "Parallel/Threads.h"

#include <gtest/gtest.h>

#include <cstdlib>

TEST(Threads, FollowTheEnvironment)
{
  setenv("VTK_SMP_MAX_THREADS", "3", 1);
  EXPECT_EQ(ink::threadCount(), 3);
  for (const char* unusable : { "0", "-2", "many", "" })
  {
    setenv("VTK_SMP_MAX_THREADS", unusable, 1);
    EXPECT_GE(ink::threadCount(), 1) << "VTK_SMP_MAX_THREADS=" << unusable;
  }
  unsetenv("VTK_SMP_MAX_THREADS");
  EXPECT_GE(ink::threadCount(), 1);
}
