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
    EXPECT_TRUE(ink::parallelForEach(count, [&](std::size_t i) { ++visits[i]; }));
    for (const std::atomic<int>& some : visits)
    {
      ASSERT_EQ(some, 2) << count << " elements";
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

TEST_P(ParallelChunks, GatherInOrder)
{
  constexpr std::size_t perChunk = 3;
  for (const std::size_t count : { 0, 1, 3, 10 })
  {
    std::vector<std::size_t> expected;
    for (std::size_t i = 0; i < count; ++i)
    {
      expected.insert(expected.end(), i % 4, i);
    }
    EXPECT_EQ(
      ink::parallelGather<std::size_t>(
        count, [](std::size_t i, std::vector<std::size_t>& found) { found.insert(found.end(), i % 4, i); },
        perChunk),
      expected)
      << count << " elements";
  }
}

TEST_P(ParallelChunks, StopWhenAsked)
{
  constexpr std::size_t count = 1000;
  const ink::Progress stop = [](double) { return false; };
  std::atomic<std::size_t> visits = 0;
  EXPECT_FALSE(ink::parallelForEach(
    count, [&](std::size_t) { ++visits; }, 1, stop));
  EXPECT_LT(visits, count);
  const auto add = [](std::size_t i, std::vector<std::size_t>& found) { found.push_back(i); };
  EXPECT_TRUE(ink::parallelGather<std::size_t>(count, add, 1, stop).empty());
  EXPECT_EQ(ink::parallelGather<std::size_t>(count, add, 1, [](double) { return true; }).size(), count);
}

INSTANTIATE_TEST_SUITE_P(Threads, ParallelChunks, testing::Values("1", "2", "5"));

} // namespace
