#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace ink
{

/// How often lengths occur. A bin is 1/128 of its lower end wide, whatever the unit of the lengths, and
/// counts are whole numbers, so that the order in which parts of the data are added does not matter.
class MagnitudeHistogram
{
public:
  MagnitudeHistogram();

  /// Negative values and NaN are passed over.
  void add(std::span<const float> magnitudes);
  void add(const MagnitudeHistogram& other);

  std::uint64_t count() const { return this->Count; }

  /// One number a bin, always as many: what another process needs to add this histogram to its own.
  std::span<const std::uint64_t> bins() const { return this->Bins; }
  /// \throws std::invalid_argument unless there are as many as bins() has
  void setBins(std::span<const std::uint64_t> bins);

  /// The lower end of the bin below which a share, in [0, 1], of the magnitudes lies. Only those in the bin
  /// of `from` and above it count. 0 without any.
  float quantile(double share, float from = 0.0f) const;

private:
  std::vector<std::uint64_t> Bins;
  std::uint64_t Count = 0;
};

} // namespace ink
