// SPDX-License-Identifier: BSD-3-Clause
#include "IsoSurface/ActiveCellComponents.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <queue>
#include <set>
#include <stdexcept>
#include <unordered_map>
#include <vector>

namespace
{

using ink::ActiveCellId;
using ink::activeCellId;
using Counts = std::vector<std::size_t>;

std::vector<ActiveCellId> sorted(std::vector<ActiveCellId> cells)
{
  std::sort(cells.begin(), cells.end());
  return cells;
}

/// Cells by chance, about as many as make both large and small components.
std::vector<ActiveCellId> randomCells(int size, std::uint64_t percent)
{
  std::vector<ActiveCellId> cells;
  std::uint64_t state = 1;
  for (int z = 0; z < size; ++z)
  {
    for (int y = 0; y < size; ++y)
    {
      for (int x = 0; x < size; ++x)
      {
        state = state * 6364136223846793005U + 1442695040888963407U;
        if ((state >> 33U) % 100 < percent)
        {
          cells.push_back(activeCellId({ x - 7, y, z - 20 }));
        }
      }
    }
  }
  return cells;
}

/// By flooding one component after the other.
std::vector<std::uint32_t> floodedLabels(const std::vector<ActiveCellId>& cells)
{
  std::unordered_map<ActiveCellId, std::uint32_t> labels;
  const std::set<ActiveCellId> all(cells.begin(), cells.end());
  std::uint32_t count = 0;
  for (const ActiveCellId cell : cells)
  {
    if (labels.contains(cell))
    {
      continue;
    }
    std::queue<ActiveCellId> open({ cell });
    labels[cell] = count;
    for (; !open.empty(); open.pop())
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        for (const ActiveCellId step : { -ink::activeCellStep(axis), ink::activeCellStep(axis) })
        {
          const ActiveCellId next = open.front() + step;
          if (all.contains(next) && labels.emplace(next, count).second)
          {
            open.push(next);
          }
        }
      }
    }
    ++count;
  }
  std::vector<std::uint32_t> result;
  for (const ActiveCellId cell : cells)
  {
    result.push_back(labels[cell]);
  }
  return result;
}

TEST(ActiveCellComponents, AreThoseOfAFlood)
{
  for (const std::uint64_t percent : { 5, 25, 32, 60 })
  {
    const auto cells = randomCells(60, percent);
    EXPECT_EQ(ink::findActiveCellComponents(cells).labels, floodedLabels(cells)) << percent;
  }
}

TEST(ActiveCellComponents, AreTheSameOnAnyNumberOfThreads)
{
  const auto cells = randomCells(110, 31);
  std::vector<ink::ActiveCellComponents> found;
  for (const char* threads : { "1", "2", "7" })
  {
    setenv("VTK_SMP_MAX_THREADS", threads, 1);
    found.push_back(ink::findActiveCellComponents(cells));
    EXPECT_EQ(found.back().labels, found[0].labels) << threads;
    EXPECT_EQ(found.back().counts, found[0].counts) << threads;
  }
  unsetenv("VTK_SMP_MAX_THREADS");
}

TEST(ActiveCellComponents, MeetAtFacesOnly)
{
  const auto touching =
    sorted({ activeCellId({ 0, 0, 0 }), activeCellId({ 1, 1, 0 }), activeCellId({ 1, 1, 1 }) });
  EXPECT_EQ(ink::findActiveCellComponents(touching).counts, (Counts{ 1, 2 }));
}

TEST(ActiveCellComponents, DoNotWrapAroundRows)
{
  const int last = (1 << 20) - 2;
  const auto cells = sorted({ activeCellId({ last, 0, 0 }), activeCellId({ -(1 << 20), 1, 0 }),
    activeCellId({ 0, last, 0 }), activeCellId({ 0, -(1 << 20), 1 }) });
  EXPECT_EQ(ink::findActiveCellComponents(cells).counts.size(), 4U);
}

TEST(ActiveCellComponents, OfNothingAreNone)
{
  EXPECT_TRUE(ink::findActiveCellComponents({}).counts.empty());
  EXPECT_TRUE(ink::selectComponents({}, { 0.5, 1 }).empty());
}

TEST(ActiveCellComponents, RefuseCellsOutOfOrder)
{
  const std::vector<ActiveCellId> falling{ activeCellId({ 1, 0, 0 }), activeCellId({ 0, 0, 0 }) };
  EXPECT_THROW(ink::findActiveCellComponents(falling), std::invalid_argument);
  const std::vector<ActiveCellId> twice(2, activeCellId({ 1, 0, 0 }));
  EXPECT_THROW(ink::findActiveCellComponents(twice), std::invalid_argument);
}

TEST(ActiveCellComponents, AreSelectedByTheirShareOfTheLargest)
{
  const Counts counts{ 10, 1000, 99, 100, 500 };
  using Kept = std::vector<char>;
  EXPECT_EQ(ink::selectComponents(counts, {}), (Kept{ 1, 1, 1, 1, 1 }));
  EXPECT_EQ(ink::selectComponents(counts, { 0.1, 0 }), (Kept{ 0, 1, 0, 1, 1 }));
  EXPECT_EQ(ink::selectComponents(counts, { 1.0, 0 }), (Kept{ 0, 1, 0, 0, 0 }));
  EXPECT_EQ(ink::selectComponents(counts, { 0.0, 2 }), (Kept{ 0, 1, 0, 0, 1 }));
  EXPECT_EQ(ink::selectComponents(counts, { 0.0, 9 }), (Kept{ 1, 1, 1, 1, 1 }));
  EXPECT_EQ(ink::selectComponents(Counts{ 5, 5, 5 }, { 0.0, 2 }), (Kept{ 1, 1, 0 }));
}

TEST(ActiveCellComponents, SpecksAreLeftOutAutomatically)
{
  constexpr double automatic = ink::ComponentSelection::automatic;
  using Kept = std::vector<char>;
  // A voxel by itself has eight active cells.
  EXPECT_EQ(ink::selectComponents(Counts{ 8, 12, 27, 7000 }, { automatic, 0 }), (Kept{ 0, 0, 1, 1 }));
  EXPECT_EQ(ink::selectComponents(Counts{ 99, 100, 100'000 }, { automatic, 0 }), (Kept{ 0, 1, 1 }));
  // Nothing but specks is a drawing of specks.
  EXPECT_EQ(ink::selectComponents(Counts{ 8, 12, 8 }, { automatic, 0 }), (Kept{ 1, 1, 1 }));
}

} // namespace
