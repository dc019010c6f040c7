// SPDX-License-Identifier: BSD-3-Clause
#include "Visibility/CurveVisibility.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ink
{

namespace
{

/// How much nearer in pixels a surface is than what it hides, whatever is beside it: a silhouette's own
/// surface is nearer by sqrt(2 r d) within d pixels, of a sphere of r.
constexpr double farBehind = 48.0;
/// How far from a silhouette, in pixels, its own surface may reach.
constexpr double beside = 2.0;
/// How much nearer in pixels all of the neighborhood is: what rounding leaves.
constexpr double behind = 0.05;
/// Of a curve that may lie behind its surface by the tolerance: how far it may lie within the outline of that
/// surface as a picture shows it, and how far behind it there, in tolerances.
constexpr double mostWithin = 0.3;
constexpr double mostBehind = 3.0;
/// In how far a curve may lie within an outline: what is longer goes along it.
constexpr double longAlong = 4.0;

struct Sample
{
  double position; ///< on the curve, as CurveRun's
  double length;   ///< pixels from the curve's begin, as far as the image shows it
  bool hidden;
  bool enters; ///< the image does not show what is before it
  /// Of hidden samples that may be meant for the outline of the surface before them: how far, in pixels, they
  /// may lie within it; otherwise 0.
  double withinOutline;
};

class Sampler
{
public:
  explicit Sampler(const CurveOccluders& occluders)
    : Occluders(occluders)
  {
  }

  /// Appends the samples of a segment, its first point and not its last, as far as the image shows it.
  void addSegment(const CurvePoint& a, const CurvePoint& b, double position)
  {
    // The part before the near plane, then within the image.
    const bool entered = std::exchange(this->Entered, false);
    double from = 0.0;
    double to = 1.0;
    if (!clip(a.clip.z + a.clip.w, b.clip.z + b.clip.w, from, to))
    {
      return;
    }
    const glm::dvec4 first = glm::mix(a.clip, b.clip, from);
    const glm::dvec4 last = glm::mix(a.clip, b.clip, to);
    if (!(first.w > 0.0) || !(last.w > 0.0))
    {
      return;
    }
    const glm::dvec2 p = this->toPixel(first);
    const glm::dvec2 q = this->toPixel(last);
    double begin = 0.0;
    double end = 1.0;
    if (!clip(p.x, q.x, begin, end) || !clip(p.y, q.y, begin, end) ||
      !clip(this->Occluders.image.width - p.x, this->Occluders.image.width - q.x, begin, end) ||
      !clip(this->Occluders.image.height - p.y, this->Occluders.image.height - q.y, begin, end))
    {
      return;
    }
    const bool enters = !entered || from > 0.0 || begin > 0.0;
    this->Entered = to == 1.0 && end == 1.0;
    const double length = (end - begin) * glm::distance(p, q);
    const int steps = static_cast<int>(std::ceil(std::max(length, 1.0)));
    for (int step = 0; step < steps; ++step)
    {
      const double share = static_cast<double>(step) / steps;
      // Even steps on the picture are uneven ones in space.
      const double onPicture = begin + (end - begin) * share;
      const double inSpace = onPicture * first.w / (last.w + onPicture * (first.w - last.w));
      const double t = from + (to - from) * inSpace;
      const double curvature = a.radialCurvature + t * (b.radialCurvature - a.radialCurvature);
      const glm::dvec4 clip = glm::mix(a.clip, b.clip, t);
      const glm::dvec2 normal = glm::mix(a.normal, b.normal, t);
      const bool turnsAway = curvature < 0.0;
      const bool hidden = turnsAway || this->isHidden(clip, normal);
      const double within = hidden && !turnsAway ? this->withinOutline(clip, normal, q - p) : 0.0;
      this->samples.push_back(
        { position + t, this->Length + share * length, hidden, enters && step == 0, within });
    }
    this->Length += length;
  }

  double length() const { return this->Length; }
  /// Whether the image shows the end of the last segment.
  bool showsEnd() const { return this->Entered; }

  std::vector<Sample> samples;

private:
  /// Narrows the part of a segment to where a linear function is positive.
  static bool clip(double a, double b, double& from, double& to)
  {
    if (!std::isfinite(a) || !std::isfinite(b))
    {
      return false;
    }
    if (a < 0.0 || b < 0.0)
    {
      const double zero = a / (a - b);
      if (a < 0.0)
      {
        from = b < 0.0 ? 1.0 : std::max(from, zero);
      }
      else
      {
        to = std::min(to, zero);
      }
    }
    return from < to;
  }

  glm::dvec2 toPixel(const glm::dvec4& clip) const
  {
    return { (0.5 * clip.x / clip.w + 0.5) * this->Occluders.image.width,
      (0.5 * clip.y / clip.w + 0.5) * this->Occluders.image.height };
  }

  /// Distance from the eye along the view.
  double toDistance(double depth) const
  {
    const double* m = this->Occluders.depthToClip;
    const double ndc = 2.0 * depth - 1.0;
    return (m[1] - ndc * m[3]) / (m[0] - ndc * m[2]);
  }

  /// The image's pixel at a position, or the nearest one.
  glm::ivec2 pixelAt(const glm::dvec2& position) const
  {
    const DepthImage& image = this->Occluders.image;
    return { std::clamp(static_cast<int>(std::floor(position.x)), 0, image.width - 1),
      std::clamp(static_cast<int>(std::floor(position.y)), 0, image.height - 1) };
  }

  double distanceAt(const glm::dvec2& position) const
  {
    const glm::ivec2 pixel = this->pixelAt(position);
    return this->toDistance(this->Occluders.image.at(pixel.x, pixel.y));
  }

  bool isHidden(const glm::dvec4& clip, const glm::dvec2& normal) const
  {
    const DepthImage& image = this->Occluders.image;
    const glm::dvec2 position = this->toPixel(clip);
    const double own = this->toDistance(0.5 * clip.z / clip.w + 0.5) - this->Occluders.tolerance;
    const double size = this->Occluders.pixel * clip.w;
    double farthest =
      std::max(this->distanceAt(position + beside * normal), this->distanceAt(position - beside * normal));
    if (farthest < own - farBehind * size)
    {
      return true;
    }
    const glm::ivec2 pixel = this->pixelAt(position);
    for (int row = std::max(pixel.y - 1, 0); row <= std::min(pixel.y + 1, image.height - 1); ++row)
    {
      for (int column = std::max(pixel.x - 1, 0); column <= std::min(pixel.x + 1, image.width - 1); ++column)
      {
        farthest = std::max(farthest, this->toDistance(image.at(column, row)));
      }
    }
    return farthest < own - behind * size;
  }

  /// Sample::withinOutline.
  /// @param along the curve's direction in the picture, of any length
  double withinOutline(const glm::dvec4& clip, const glm::dvec2& normal, const glm::dvec2& along) const
  {
    const double tolerance = this->Occluders.tolerance;
    const double reach =
      std::min(mostWithin * tolerance / (this->Occluders.pixel * clip.w), this->Occluders.withinOutline);
    if (!(reach > beside))
    {
      return 0.0;
    }
    const glm::dvec2 position = this->toPixel(clip);
    const double own = this->toDistance(0.5 * clip.z / clip.w + 0.5);
    if (this->distanceAt(position) < own - mostBehind * tolerance)
    {
      return 0.0;
    }
    const double length = glm::length(along);
    const bool isSilhouette = normal != glm::dvec2(0.0);
    const glm::dvec2 across = isSilhouette || length == 0.0 ? normal : glm::dvec2(along.y, -along.x) / length;
    const int places = std::clamp(static_cast<int>(reach / beside), 1, 16);
    for (int place = 1; place <= places; ++place)
    {
      const glm::dvec2 away = reach * place / places * across;
      if (this->distanceAt(position + away) >= own || this->distanceAt(position - away) >= own)
      {
        return reach;
      }
    }
    return 0.0;
  }

  const CurveOccluders& Occluders;
  double Length = 0.0;
  bool Entered = false;
};

/// Shows what goes along within an outline: from where the curve is seen, or what is before it is not known,
/// to where it is seen again, or far. Not what passes below the outline at an angle.
/// @param connected the last sample is followed by the first
void showOutlines(std::vector<Sample>& samples, double length, bool connected)
{
  const auto count = static_cast<std::ptrdiff_t>(samples.size());
  const auto at = [&](std::ptrdiff_t n) -> Sample&
  { return samples[static_cast<std::size_t>((n + count) % count)]; };
  const auto lengthTo = [&](std::ptrdiff_t n) { return (n < count ? 0.0 : length) + at(n).length; };
  const auto enters = [&](std::ptrdiff_t n) { return n % count == 0 ? !connected : at(n).enters; };
  const auto isWithin = [&](std::ptrdiff_t n) { return at(n).withinOutline > 0.0; };
  // Where a closed curve begins does not matter.
  std::ptrdiff_t begin = 0;
  while (connected && begin < count && isWithin(begin) && !enters(begin))
  {
    ++begin;
  }
  begin %= count;
  for (std::ptrdiff_t first = begin; first < begin + count; ++first)
  {
    if (!isWithin(first))
    {
      continue;
    }
    double reach = at(first).withinOutline;
    std::ptrdiff_t end = first + 1;
    for (; end < begin + count && isWithin(end) && !enters(end); ++end)
    {
      reach = std::max(reach, at(end).withinOutline);
    }
    const bool isSeenBefore = enters(first) || !at(first - 1).hidden;
    const bool isSeenBehind = enters(end) || !at(end).hidden;
    const bool isShown =
      (isSeenBefore && isSeenBehind) || lengthTo(end) - lengthTo(first) > longAlong * reach;
    for (std::ptrdiff_t n = first; n < end; ++n)
    {
      at(n).hidden = !isShown;
    }
    first = end - 1;
  }
}

/// Runs of samples in one state, from one sample to before another.
struct SampleRun
{
  std::size_t first;
  double length; ///< pixels
  bool hidden;
  bool goesOn; ///< where the image does not show it: nobody knows how long it is
};

std::vector<SampleRun> findSampleRuns(const std::vector<Sample>& samples, double length)
{
  std::vector<SampleRun> runs;
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    if (i > 0 && samples[i].enters)
    {
      runs.back().goesOn = true;
    }
    if (runs.empty() || samples[i].enters || runs.back().hidden != samples[i].hidden)
    {
      runs.push_back({ i, 0.0, samples[i].hidden, i > 0 && samples[i].enters });
    }
  }
  for (std::size_t i = 0; i < runs.size(); ++i)
  {
    const double end = i + 1 < runs.size() ? samples[runs[i + 1].first].length : length;
    runs[i].length = end - samples[runs[i].first].length;
  }
  return runs;
}

/// Leaves only those that are long enough or may be, one state after the other.
std::vector<SampleRun> joinShortRuns(const std::vector<SampleRun>& runs, double leastRun)
{
  double balance = 0.0; // of lengths, if none is long enough
  std::vector<SampleRun> kept;
  for (const SampleRun& run : runs)
  {
    balance += run.hidden ? run.length : -run.length;
    if ((run.length >= leastRun || run.goesOn) && (kept.empty() || kept.back().hidden != run.hidden))
    {
      kept.push_back(run);
    }
  }
  if (kept.empty())
  {
    kept.push_back({ 0, 0.0, balance > 0.0, false });
  }
  return kept;
}

} // namespace

double outlineMargin(double withinOutline)
{
  return (1.0 + longAlong) * withinOutline;
}

std::vector<CurveRun> findVisibleRuns(
  std::span<const CurvePoint> points, bool closed, const CurveOccluders& occluders, double leastRun)
{
  occluders.image.check();
  if (points.size() < 2)
  {
    return {};
  }
  const std::size_t segments = closed ? points.size() : points.size() - 1;
  Sampler sampler(occluders);
  for (std::size_t i = 0; i < segments; ++i)
  {
    sampler.addSegment(points[i], points[(i + 1) % points.size()], static_cast<double>(i));
  }
  std::vector<Sample>& samples = sampler.samples;
  const double whole = static_cast<double>(segments);
  if (samples.empty())
  {
    return { { 0.0, whole, false } };
  }

  const bool showsBegin = samples.front().position == 0.0;
  const bool connected = closed && showsBegin && sampler.showsEnd();
  showOutlines(samples, sampler.length(), connected);
  std::vector<SampleRun> runs = findSampleRuns(samples, sampler.length());
  runs.front().goesOn |= !showsBegin || (closed && !connected);
  runs.back().goesOn |= !sampler.showsEnd() || (closed && !connected);
  if (closed && runs.size() > 1)
  {
    if (connected && runs.front().hidden == runs.back().hidden)
    {
      // One run, which the begin of the curve divides.
      runs.back().length += runs.front().length;
      runs.back().goesOn |= runs.front().goesOn;
      runs.erase(runs.begin());
    }
    // One that is sure to be kept, so that the others join the same wherever the curve begins.
    std::rotate(runs.begin(),
      std::max_element(runs.begin(), runs.end(),
        [](const SampleRun& a, const SampleRun& b)
        { return std::pair(a.goesOn, a.length) < std::pair(b.goesOn, b.length); }),
      runs.end());
  }
  std::vector<SampleRun> kept = joinShortRuns(runs, leastRun);
  if (closed && kept.size() > 1 && kept.front().hidden == kept.back().hidden)
  {
    // One run, that goes on over a short one before the longest.
    kept.front().first = kept.back().first;
    kept.pop_back();
  }
  if (kept.size() == 1)
  {
    return { { 0.0, whole, kept.front().hidden } };
  }

  // A change lies between two samples.
  const auto begin = [&](const SampleRun& run)
  {
    const Sample& first = samples[run.first];
    const double before = run.first > 0 ? samples[run.first - 1].position
      : closed                          ? samples.back().position - whole
                                        : 0.0;
    const double between = run.first == 0 && !closed ? 0.0 : 0.5 * (before + first.position);
    return between < 0.0 ? between + whole : between;
  };
  std::vector<CurveRun> result;
  for (std::size_t i = 0; i < kept.size(); ++i)
  {
    const bool last = i + 1 == kept.size();
    const double from = i == 0 && !closed ? 0.0 : begin(kept[i]);
    double to = last ? (closed ? begin(kept.front()) : whole) : begin(kept[i + 1]);
    to += closed && to <= from ? whole : 0.0;
    result.push_back({ from, to, kept[i].hidden });
  }
  return result;
}

} // namespace ink
