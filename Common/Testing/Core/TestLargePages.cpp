// SPDX-License-Identifier: BSD-3-Clause
#include "Core/LargePages.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <new>

namespace
{

struct alignas(64) Line
{
  std::uint64_t values[8];
};

std::uintptr_t address(const void* memory)
{
  return reinterpret_cast<std::uintptr_t>(memory);
}

} // namespace

TEST(LargePages, AlignLargeArraysToPagesAndSmallOnesToElements)
{
  constexpr std::size_t page = ink::LargePageAllocator<Line>::pageSize;
  EXPECT_EQ(address(ink::LargePageVector<Line>(3).data()) % alignof(Line), 0u);
  EXPECT_EQ(address(ink::LargePageVector<Line>(2 * page / sizeof(Line)).data()) % page, 0u);
  EXPECT_EQ(address(ink::LargePageVector<char>(2 * page + 1).data()) % page, 0u);
}

TEST(LargePages, KeepValuesWhileAnArrayGrows)
{
  constexpr std::uint32_t count = 3'000'000; // beyond what ordinary pages are kept for
  ink::LargePageVector<std::uint32_t> numbers;
  for (std::uint32_t i = 0; i < count; ++i)
  {
    numbers.push_back(i);
  }
  for (std::uint32_t i = 0; i < count; ++i)
  {
    ASSERT_EQ(numbers[i], i);
  }
}

TEST(LargePages, RefuseWhatNoMemoryHolds)
{
  ink::LargePageAllocator<Line> allocator;
  EXPECT_THROW(allocator.allocate(std::numeric_limits<std::size_t>::max() / 8), std::bad_array_new_length);
}
