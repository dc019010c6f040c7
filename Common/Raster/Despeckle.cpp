// SPDX-License-Identifier: BSD-3-Clause
#include "Raster/Despeckle.h"

#include "Core/DisjointSets.h"
#include "Core/ParallelFor.h"
#include "Raster/RowScan.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

namespace ink::raster
{

namespace
{

constexpr int rowsPerBand = 64;

/// A run of consecutive pixels in a row that are all strong (at least the threshold) or all faint.
struct Run
{
  int y;
  int begin;
  int end;
  bool strong;
};

/// A faint run and a strong one that touch.
using Contact = std::pair<std::uint32_t, std::uint32_t>;

/// The bounding box of a component, stored with its first run.
struct Spot
{
  int low[2] = { 1 << 30, 1 << 30 };
  int high[2] = { -1, -1 };
  bool stays = false;
  bool atCut = false;
  bool touchesKept = false;
  bool touchesErased = false;

  void add(const Run& run)
  {
    this->low[0] = std::min(this->low[0], run.begin);
    this->low[1] = std::min(this->low[1], run.y);
    this->high[0] = std::max(this->high[0], run.end - 1);
    this->high[1] = std::max(this->high[1], run.y);
  }
};

void findRuns(const unsigned char* row, int y, int width, unsigned char threshold, std::vector<Run>& runs)
{
  for (int x = skipEmpty(row, 0, width); x < width; x = skipEmpty(row, x, width))
  {
    const bool strong = row[x] >= threshold;
    const int begin = x;
    while (x < width && row[x] != 0 && (row[x] >= threshold) == strong)
    {
      ++x;
    }
    runs.push_back({ y, begin, x, strong });
  }
}

struct RunsOfRows
{
  std::vector<Run> runs;
  std::vector<std::uint32_t> rowBegin; // of each row, and one more
};

RunsOfRows findRuns(const CoverageImage& image, unsigned char threshold, std::size_t bands)
{
  std::vector<std::vector<Run>> ofBand(bands);
  RunsOfRows all;
  all.rowBegin.assign(static_cast<std::size_t>(image.height) + 1, 0);
  parallelFor(bands,
    [&](std::size_t band)
    {
      const int end = std::min(static_cast<int>(band + 1) * rowsPerBand, image.height);
      for (int y = static_cast<int>(band) * rowsPerBand; y < end; ++y)
      {
        const std::size_t before = ofBand[band].size();
        findRuns(image.row(y), y, image.width, threshold, ofBand[band]);
        all.rowBegin[static_cast<std::size_t>(y) + 1] =
          static_cast<std::uint32_t>(ofBand[band].size() - before);
      }
    });
  for (std::size_t y = 1; y < all.rowBegin.size(); ++y)
  {
    all.rowBegin[y] += all.rowBegin[y - 1];
  }
  all.runs.reserve(all.rowBegin.back());
  for (const std::vector<Run>& runs : ofBand)
  {
    all.runs.insert(all.runs.end(), runs.begin(), runs.end());
  }
  return all;
}

/// Merges the runs of a row with the adjacent ones in the same row and the row below.
void joinRow(
  const RunsOfRows& all, int y, bool withBelow, DisjointSets& spots, std::vector<Contact>& contacts)
{
  const auto touch = [&](std::uint32_t a, std::uint32_t b)
  {
    if (all.runs[a].strong == all.runs[b].strong)
    {
      spots.join(a, b);
    }
    else
    {
      contacts.emplace_back(all.runs[a].strong ? b : a, all.runs[a].strong ? a : b);
    }
  };
  const auto row = static_cast<std::size_t>(y);
  const std::uint32_t end = all.rowBegin[row + 1];
  if (!withBelow)
  {
    for (std::uint32_t i = all.rowBegin[row] + 1; i < end; ++i)
    {
      if (all.runs[i - 1].end == all.runs[i].begin)
      {
        touch(i - 1, i);
      }
    }
    return;
  }
  std::uint32_t below = all.rowBegin[row - 1];
  for (std::uint32_t i = all.rowBegin[row]; i < end; ++i)
  {
    while (below < all.rowBegin[row] && all.runs[below].end < all.runs[i].begin)
    {
      ++below;
    }
    for (std::uint32_t j = below; j < all.rowBegin[row] && all.runs[j].begin <= all.runs[i].end; ++j)
    {
      touch(i, j);
    }
  }
}

} // namespace

void despeckle(const CoverageImage& image, float shortest, unsigned char threshold, const CutBorders& cut)
{
  image.check();
  if (image.pixels.empty() || !(shortest > 1.0f))
  {
    return; // no pixel is shorter
  }
  const std::size_t bands = static_cast<std::size_t>((image.height - 1) / rowsPerBand) + 1;
  const RunsOfRows all = findRuns(image, std::max<unsigned char>(threshold, 1), bands);
  DisjointSets spots(all.runs.size());
  std::vector<std::vector<Contact>> contacts(bands);
  parallelFor(bands,
    [&](std::size_t band)
    {
      const int begin = static_cast<int>(band) * rowsPerBand;
      for (int y = begin; y < std::min(begin + rowsPerBand, image.height); ++y)
      {
        joinRow(all, y, false, spots, contacts[band]);
        if (y > begin)
        {
          joinRow(all, y, true, spots, contacts[band]);
        }
      }
    });
  for (std::size_t band = 1; band < bands; ++band)
  {
    joinRow(all, static_cast<int>(band) * rowsPerBand, true, spots, contacts[band]);
  }

  std::vector<Spot> spotOf(all.runs.size());
  std::vector<std::uint32_t> firstRuns(all.runs.size()); // of the run's spot
  for (std::uint32_t i = 0; i < firstRuns.size(); ++i)
  {
    firstRuns[i] = spots.least(i);
    spotOf[firstRuns[i]].add(all.runs[i]);
  }
  for (Spot& spot : spotOf)
  {
    const double extent = 1.0 + std::hypot(spot.high[0] - spot.low[0], spot.high[1] - spot.low[1]);
    spot.atCut = (cut.left && spot.low[0] == 0) || (cut.right && spot.high[0] == image.width - 1) ||
      (cut.bottom && spot.low[1] == 0) || (cut.top && spot.high[1] == image.height - 1);
    spot.stays = spot.atCut || !(extent < static_cast<double>(shortest));
  }
  for (const std::vector<Contact>& ofBand : contacts)
  {
    for (const auto& [faint, strong] : ofBand)
    {
      Spot& spot = spotOf[firstRuns[faint]];
      (spotOf[firstRuns[strong]].stays ? spot.touchesKept : spot.touchesErased) = true;
    }
  }
  for (Spot& spot : spotOf)
  {
    if (spot.touchesKept || spot.touchesErased) // then how long the faint ink itself is does not count
    {
      spot.stays = spot.touchesKept || spot.atCut;
    }
  }
  parallelFor(bands,
    [&](std::size_t band)
    {
      const std::size_t begin = band * static_cast<std::size_t>(rowsPerBand);
      const std::size_t end = std::min(begin + rowsPerBand, static_cast<std::size_t>(image.height));
      for (std::uint32_t i = all.rowBegin[begin]; i < all.rowBegin[end]; ++i)
      {
        const Run& run = all.runs[i];
        if (!spotOf[firstRuns[i]].stays)
        {
          std::memset(image.row(run.y) + run.begin, 0, static_cast<std::size_t>(run.end - run.begin));
        }
      }
    });
}

} // namespace ink::raster
