// SPDX-License-Identifier: BSD-3-Clause
#include "Core/ParallelChunks.h"

#include "Core/Hash.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <vector>

namespace
{

/// None, one, whole chunks, and one element more or less.
constexpr std::size_t counts[] = { 0, 1, ink::elementsPerChunk - 1, ink::elementsPerChunk,
  ink::elementsPerChunk + 1, 5 * ink::elementsPerChunk };

class ParallelChunks : public testing::TestWithParam<const char*>
{
protected:
  void SetUp() override { setenv("VTK_SMP_MAX_THREADS", this->GetParam(), 1); }
  void TearDown() override { unsetenv("VTK_SMP_MAX_THREADS"); }
};

TEST_P(ParallelChunks, HoldEachElementOnce)
{
  for (const std::size_t count : counts)
  {
    std::vector<std::atomic<int>> visits(count);
    ink::parallelForChunks(count,
      [&](std::size_t chunk, std::size_t begin, std::size_t end)
      {
        EXPECT_EQ(begin, chunk * ink::elementsPerChunk);
        EXPECT_LT(begin, end);
        for (std::size_t i = begin; i < end; ++i)
        {
          ++visits[i];
        }
      });
    for (const std::atomic<int>& some : visits)
    {
      ASSERT_EQ(some, 1) << count << " elements";
    }
  }
}

/// Rounded differently in another order.
double sumOf(std::size_t count)
{
  return ink::parallelReduce(
    count, 0.0, [](std::size_t i) { return ink::unitDouble(ink::hash(i)); }, std::plus());
}

TEST_P(ParallelChunks, AddUpToTheSameOnAnyNumberOfThreads)
{
  for (const std::size_t count : counts)
  {
    const double sum = sumOf(count);
    setenv("VTK_SMP_MAX_THREADS", "1", 1);
    EXPECT_EQ(sum, sumOf(count)) << count << " elements";
    setenv("VTK_SMP_MAX_THREADS", this->GetParam(), 1);
    const auto n = static_cast<double>(count);
    EXPECT_EQ(ink::parallelReduce(
                count, 0.0, [](std::size_t i) { return static_cast<double>(i); }, std::plus()),
      count > 0 ? 0.5 * n * (n - 1.0) : 0.0);
  }
}

TEST_P(ParallelChunks, SelectInOrder)
{
  const auto passes = [](std::size_t i) { return ink::hash(i) % 3 == 0; };
  for (const std::size_t count : counts)
  {
    std::vector<std::uint32_t> expected;
    for (std::size_t i = 0; i < count; ++i)
    {
      if (passes(i))
      {
        expected.push_back(static_cast<std::uint32_t>(i));
      }
    }
    EXPECT_EQ(ink::parallelSelect(count, passes), expected) << count << " elements";
  }
}

INSTANTIATE_TEST_SUITE_P(Threads, ParallelChunks, testing::Values("1", "2", "5"));

} // namespace
