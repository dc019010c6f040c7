// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/Periodogram.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace ink
{
namespace
{

// A frequency counts of which a multiple is more prominent, if it is so prominent itself, and has this
// fraction of the multiple's amplitude.
constexpr double prominentToo = 6.0;
constexpr double amplitudeShare = 0.5;

/// The powers of a periodogram at evenly spaced frequencies up to .5.
class Powers
{
public:
  Powers(const Periodogram& periodogram, double lowest, int length)
    : Lowest(lowest)
    , Resolution(1.0 / length)
  {
    const auto count = static_cast<std::size_t>(perResolution * length / 2);
    for (std::size_t k = 0; k <= count; ++k)
    {
      this->All.push_back(periodogram.power(this->frequencyOf(k)));
    }
  }

  double resolution() const { return this->Resolution; }

  Periodogram::Peak highest(double low, double high) const
  {
    Periodogram::Peak best;
    for (std::size_t k = this->indexOf(low); k <= this->indexOf(high); ++k)
    {
      const double prominence = this->prominence(k);
      best = prominence > best.prominence ? Periodogram::Peak{ this->frequencyOf(k), 0.0, prominence } : best;
    }
    return best;
  }

private:
  static constexpr double perResolution = 4.0;
  /// Of the lowest frequency that is looked at: what is around it may be lower, as far as trends do not
  /// reach.
  static constexpr double trendShare = 0.75;

  double frequencyOf(std::size_t k) const
  {
    return static_cast<double>(k) * this->Resolution / perResolution;
  }
  std::size_t indexOf(double frequency) const
  {
    const double k = std::round(std::max(frequency, 0.0) * perResolution / this->Resolution);
    return std::min(static_cast<std::size_t>(k), this->All.size() - 1);
  }

  double prominence(std::size_t k) const
  {
    const double frequency = this->frequencyOf(k);
    // A Hann window makes peaks twice as wide as the resolution, to either side.
    const double inner = std::max(0.125 * frequency, 2.0 * this->Resolution);
    const double outer = std::max(0.25 * frequency, 4.0 * this->Resolution);
    std::vector<double> around;
    const auto add = [&](double from, double to)
    {
      for (std::size_t i = this->indexOf(from); i <= this->indexOf(to); ++i)
      {
        around.push_back(this->All[i]);
      }
    };
    const double trend = trendShare * this->Lowest;
    add(std::max(frequency - outer, trend), std::max(frequency - inner, trend));
    if (frequency + inner < 0.5)
    {
      add(frequency + inner, frequency + outer);
    }
    const auto middle = around.begin() + static_cast<std::ptrdiff_t>(around.size() / 2);
    std::nth_element(around.begin(), middle, around.end());
    return *middle > 0.0 ? this->All[k] / *middle : 0.0;
  }

  double Lowest;
  double Resolution;
  std::vector<double> All;
};

} // namespace

void Periodogram::add(std::size_t begin, std::vector<double> values)
{
  const auto count = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const double turn = 2.0 * std::numbers::pi * static_cast<double>(i) / (count - 1.0);
    values[i] = (values[i] - mean) * (0.5 - 0.5 * std::cos(turn));
  }
  this->All.push_back({ begin, std::move(values) });
}

double Periodogram::power(double frequency) const
{
  double sum = 0.0;
  for (const Series& series : this->All)
  {
    sum += std::norm(series.transform(frequency)) / static_cast<double>(series.values.size());
  }
  return this->All.empty() ? 0.0 : sum / static_cast<double>(this->All.size());
}

double Periodogram::amplitude(double frequency) const
{
  double sum = 0.0;
  for (const Series& series : this->All)
  {
    // A Hann window leaves half of the sum.
    sum += std::norm(4.0 * series.transform(frequency) / static_cast<double>(series.values.size()));
  }
  return this->All.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(this->All.size()));
}

double Periodogram::firstMaximum(double frequency) const
{
  std::complex<double> sum = 0.0;
  for (const Series& series : this->All)
  {
    sum += series.transform(frequency);
  }
  const double turns = -std::arg(sum) / (2.0 * std::numbers::pi);
  return (turns < 0.0 ? turns + 1.0 : turns) / frequency;
}

Periodogram::Peak Periodogram::findPeak(double lowest, double highest, int length) const
{
  if (this->All.empty())
  {
    return {};
  }
  const Powers powers(*this, lowest, length);
  Peak peak = powers.highest(lowest, highest);
  peak.amplitude = this->amplitude(peak.frequency);
  for (const double divisor : { 4.0, 3.0, 2.0 })
  {
    const double frequency = peak.frequency / divisor;
    const Peak lower = powers.highest(frequency - powers.resolution(), frequency + powers.resolution());
    if (frequency > lowest && lower.prominence > prominentToo &&
      this->amplitude(lower.frequency) > amplitudeShare * peak.amplitude)
    {
      peak.frequency = lower.frequency;
      break;
    }
  }
  const double found = peak.frequency;
  double highestPower = this->power(found);
  constexpr int refined = 64;
  for (int i = -refined; i <= refined; ++i)
  {
    const double near = found + powers.resolution() * i / refined;
    const double power = this->power(near);
    if (power > highestPower)
    {
      highestPower = power;
      peak.frequency = near;
    }
  }
  peak.amplitude = this->amplitude(peak.frequency);
  return peak;
}

std::complex<double> Periodogram::Series::transform(double frequency) const
{
  const std::complex<double> turn = std::polar(1.0, -2.0 * std::numbers::pi * frequency);
  std::complex<double> phase =
    std::polar(1.0, -2.0 * std::numbers::pi * frequency * static_cast<double>(this->begin));
  std::complex<double> sum = 0.0;
  for (const double value : this->values)
  {
    sum += value * phase;
    phase *= turn;
  }
  return sum;
}

} // namespace ink
