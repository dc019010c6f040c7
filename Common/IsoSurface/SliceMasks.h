// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Simd/SamplingKernels.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

/// Internal to Common/IsoSurface.
namespace ink
{

using Word = std::uint64_t;
constexpr int WordBits = 64;
/// Rows per block.
constexpr int Rows = BrickWidth;

/// The side of the iso-value that a block of rows in one layer of samples is on.
enum class Side : std::uint8_t
{
  Below = 0,
  Above = 1,
  Both = 2
};

/// The bit masks of one layer of samples for one iso-value. Each row is followed by an empty word.
struct SliceMasks
{
  std::vector<Word> above; ///< at or above the iso-value
  std::vector<Word> over;  ///< strictly above it; only for CrossingRule::Strict
  // By blocks of rows.
  std::vector<Side> sides;
  std::vector<std::uint8_t> missing; ///< a sample may be NaN, infinite or hidden
  std::vector<std::uint8_t> filled;  ///< the bits are valid, not only the side

  SliceMasks(std::size_t words, std::size_t blocks, bool strict)
    : above(words, 0)
    , over(strict ? words : 0, 0)
    , sides(blocks)
    , missing(blocks)
    , filled(blocks)
  {
  }
};

/// The active cells of a word by CrossingRule::Strict, from the rows of their corners: (j, k), (j + 1, k),
/// (j, k + 1), (j + 1, k + 1).
inline Word activeStrict(
  const std::array<const Word*, 4>& above, const std::array<const Word*, 4>& over, int w)
{
  const auto edge = [](Word above1, Word over1, Word above2, Word over2)
  { return (~above1 & over2) | (over1 & ~above2) | (above1 & ~over1 & above2 & ~over2); };
  const auto next = [w](const Word* row) { return row[w] >> 1 | row[w + 1] << (WordBits - 1); };
  Word active = 0;
  for (int r = 0; r < 4; ++r)
  {
    active |= edge(above[r][w], over[r][w], next(above[r]), next(over[r]));
  }
  constexpr int across[4][2] = { { 0, 1 }, { 2, 3 }, { 0, 2 }, { 1, 3 } };
  for (const auto& [r, s] : across)
  {
    active |= edge(above[r][w], over[r][w], above[s][w], over[s][w]);
    active |= edge(next(above[r]), next(over[r]), next(above[s]), next(over[s]));
  }
  return active;
}

/// The bits from `begin` up to `end` in the word that starts at bit `first`.
inline Word rangeBits(int begin, int end, int first)
{
  const auto below = [](int bits) {
    return bits <= 0 ? Word(0) : bits >= WordBits ? ~Word(0) : (Word(1) << bits) - 1;
  };
  return below(end - first) & ~below(begin - first);
}

} // namespace ink
