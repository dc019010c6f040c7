// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/MagnitudeHistogram.h"

#include <algorithm>
#include <bit>
#include <functional>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>

namespace ink
{
namespace
{

// Nonnegative floats have the order of their bits: the upper half, the exponent and seven bits of the
// mantissa, is the bin.
constexpr int binShift = 16;

std::size_t binOf(float magnitude)
{
  return std::bit_cast<std::uint32_t>(magnitude) >> binShift;
}

} // namespace

MagnitudeHistogram::MagnitudeHistogram()
  : Bins(binOf(std::numeric_limits<float>::infinity()) + 1)
{
}

void MagnitudeHistogram::add(std::span<const float> magnitudes)
{
  for (const float magnitude : magnitudes)
  {
    if (magnitude >= 0.0f)
    {
      // The sum turns -0 to 0.
      ++this->Bins[binOf(magnitude + 0.0f)];
      ++this->Count;
    }
  }
}

void MagnitudeHistogram::add(const MagnitudeHistogram& other)
{
  std::transform(this->Bins.begin(), this->Bins.end(), other.Bins.begin(), this->Bins.begin(), std::plus<>());
  this->Count += other.Count;
}

void MagnitudeHistogram::setBins(std::span<const std::uint64_t> bins)
{
  if (bins.size() != this->Bins.size())
  {
    throw std::invalid_argument("a histogram of magnitudes has " + std::to_string(this->Bins.size()) +
      " bins; found " + std::to_string(bins.size()));
  }
  this->Bins.assign(bins.begin(), bins.end());
  this->Count = std::accumulate(bins.begin(), bins.end(), std::uint64_t(0));
}

float MagnitudeHistogram::quantile(double share, float from) const
{
  const std::size_t first = binOf(std::max(from, 0.0f) + 0.0f);
  std::uint64_t total = 0;
  for (std::size_t bin = first; bin < this->Bins.size(); ++bin)
  {
    total += this->Bins[bin];
  }
  if (total == 0)
  {
    return 0.0f;
  }
  std::uint64_t below = 0;
  std::size_t last = first;
  for (std::size_t bin = first; bin < this->Bins.size(); ++bin)
  {
    if (this->Bins[bin] > 0)
    {
      last = bin;
      below += this->Bins[bin];
      if (static_cast<double>(below) > share * static_cast<double>(total))
      {
        break;
      }
    }
  }
  return std::bit_cast<float>(static_cast<std::uint32_t>(last) << binShift);
}

} // namespace ink
