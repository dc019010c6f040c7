// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace ink
{

/// A histogram of magnitudes. The width of a bin is 1/128 of its lower end, so that any unit works, and
/// counts are integers, so that the order in which parts of the data are added does not matter.
class MagnitudeHistogram
{
public:
  MagnitudeHistogram();

  /// Negative values and NaN are ignored.
  void add(std::span<const float> magnitudes);
  void add(const MagnitudeHistogram& other);

  std::uint64_t count() const { return this->Count; }

  /// The counts of all bins, a fixed number: what another process needs to add this histogram to its own.
  std::span<const std::uint64_t> bins() const { return this->Bins; }
  /// @throws std::invalid_argument unless `bins` has as many values as bins()
  void setBins(std::span<const std::uint64_t> bins);

  /// The lower end of the bin below which a fraction `share`, in [0, 1], of the magnitudes lies. Only
  /// magnitudes in the bin of `from` and above count. 0 if there are none.
  float quantile(double share, float from = 0.0f) const;

private:
  std::vector<std::uint64_t> Bins;
  std::uint64_t Count = 0;
};

} // namespace ink
