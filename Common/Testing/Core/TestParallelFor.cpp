// SPDX-License-Identifier: BSD-3-Clause
#include "Core/ParallelFor.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <thread>
#include <vector>

namespace
{

TEST(ParallelFor, CallsEachOnce)
{
  for (const char* threads : { "1", "2", "5" })
  {
    setenv("VTK_SMP_MAX_THREADS", threads, 1);
    std::vector<std::atomic<int>> calls(1000);
    EXPECT_TRUE(ink::parallelFor(calls.size(), [&](std::size_t i) { ++calls[i]; }));
    for (const std::atomic<int>& call : calls)
    {
      EXPECT_EQ(call, 1) << threads << " threads";
    }
  }
  unsetenv("VTK_SMP_MAX_THREADS");
  EXPECT_TRUE(ink::parallelFor(0, [](std::size_t) { FAIL(); }));
}

TEST(ParallelFor, ReportsFromTheCallingThread)
{
  const std::thread::id caller = std::this_thread::get_id();
  double last = 0.0;
  int reports = 0;
  const auto progress = [&](double share)
  {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    EXPECT_GT(share, 0.0);
    EXPECT_LE(share, 1.0);
    EXPECT_GE(share, last);
    last = share;
    ++reports;
    return true;
  };
  EXPECT_TRUE(ink::parallelFor(
    500, [](std::size_t) {}, progress));
  EXPECT_GT(reports, 0);
}

TEST(ParallelFor, StopsWhenAsked)
{
  setenv("VTK_SMP_MAX_THREADS", "1", 1);
  int calls = 0;
  EXPECT_FALSE(ink::parallelFor(
    1000, [&](std::size_t) { ++calls; }, [&](double) { return calls < 10; }));
  EXPECT_EQ(calls, 10);
  unsetenv("VTK_SMP_MAX_THREADS");
}

} // namespace
