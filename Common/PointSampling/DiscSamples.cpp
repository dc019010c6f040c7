// SPDX-License-Identifier: BSD-3-Clause
#include "PointSampling/DiscSamples.h"

#include "Core/Hash.h"
#include "Core/IsFinite.h"
#include "Core/MortonOrder.h"
#include "Core/ParallelChunks.h"
#include "Core/ParallelSort.h"
#include "PointSampling/ProgressiveBlueNoise.h"
#include "PointSampling/ProgressiveSampler.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>
#include <string>
#include <tuple>

namespace ink
{

namespace
{

bool isUsable(const SurfaceDiscs& discs, std::size_t disc)
{
  const float radius = discs.radii[disc];
  const glm::vec3& normal = discs.normals[disc];
  return radius > 0.0f && std::isfinite(radius) && isFinite(discs.centers[disc]) && isFinite(normal) &&
    glm::dot(normal, normal) > 0.0f;
}

/// Candidates of discs are not stratified, see ProgressiveSampler, so that somewhat fewer samples fit;
/// measured.
double countOfDiscs(double candidates)
{
  return 0.987 * progressiveCount(candidates);
}

double areaAt(const SurfaceDiscs& discs, std::size_t disc)
{
  return discs.areas.empty() ? areaOfDisc(discs.radii[disc]) : static_cast<double>(discs.areas[disc]);
}

/// Discs as pieces of a surface, see ProgressiveSampler, in Morton order. Lengths are in units of the
/// spacing.
class DiscPieces
{
public:
  DiscPieces(const SurfaceDiscs& discs, float scale)
    : Discs(discs)
    , Scale(scale)
  {
    this->Order =
      parallelSelect(discs.centers.size(), [&](std::size_t disc) { return isUsable(discs, disc); });
    this->Largest = this->largestOf([&](std::uint32_t disc) { return discs.radii[disc] * scale; });
    this->sort();
    const std::size_t count = this->Order.size();
    this->Areas.resize(count);
    this->Middles.resize(count);
    this->Sides.resize(count);
    parallelForEach(count,
      [&](std::size_t i)
      {
        const std::uint32_t disc = this->Order[i];
        this->Areas[i] = areaAt(discs, disc);
        this->Middles[i] = discs.centers[disc] * scale;
        this->Sides[i] = { glm::normalize(discs.normals[disc]), discs.reach * discs.radii[disc] * scale };
      });
  }

  std::span<const double> areas() const { return this->Areas; }
  std::span<const glm::vec3> middles() const { return this->Middles; }
  std::span<const std::uint64_t> ids() const { return this->Ids; }
  float longest() const { return 2.0f * this->Discs.reach * this->Largest; }

  struct Frame
  {
    glm::vec3 origin;
    glm::vec3 along1;
    glm::vec3 along2;
    glm::vec3 normal;
  };
  Frame frame(std::size_t piece) const
  {
    const auto& [n, reach] = this->Sides[piece];
    // An orthonormal basis (Duff et al. 2017). Not with 0, where rounding would decide on what is upright.
    const float s = n.z < 0.29f ? -1.0f : 1.0f;
    const float a = -1.0f / (s + n.z);
    const float b = n.x * n.y * a;
    return { this->Middles[piece], reach * glm::vec3(1.0f + s * n.x * n.x * a, s * b, -s * n.x),
      reach * glm::vec3(b, s + n.y * n.y * a, -n.y), n };
  }
  /// In the unit disc.
  static glm::vec2 coordinates(float u, float v)
  {
    const float angle = 2.0f * std::numbers::pi_v<float> * v;
    return std::sqrt(u) * glm::vec2(std::cos(angle), std::sin(angle));
  }
  DiscSample sample(const SpacedSample& spaced) const
  {
    return { spaced.position / this->Scale, spaced.normal, this->Order[spaced.piece] };
  }

private:
  /// The largest of what discs have.
  template <class Of>
  float largestOf(const Of& of) const
  {
    return parallelReduce(
      this->Order.size(), 0.0f, [&](std::size_t i) { return of(this->Order[i]); },
      [](float a, float b) { return std::max(a, b); });
  }

  /// By what discs are, not by where they stand in the input.
  void sort()
  {
    struct Key
    {
      std::uint64_t cell;
      std::uint32_t disc;
    };
    const float farthest = this->largestOf(
      [&](std::uint32_t disc)
      {
        const glm::vec3 distance = glm::abs(this->Discs.centers[disc]);
        return std::max({ distance.x, distance.y, distance.z });
      });
    // A power of two, as radii that differ in rounding are to have the same cubes.
    const float least = std::max(this->Largest / this->Scale, farthest * 0x1p-19f);
    const float width = std::exp2(std::floor(std::log2(least)));
    std::vector<Key> keys(this->Order.size());
    parallelForEach(keys.size(),
      [&](std::size_t i)
      {
        const std::uint32_t disc = this->Order[i];
        keys[i] = { mortonOfGroup(this->Discs.centers[disc] / width), disc };
      });
    const auto position = [&](const Key& key)
    {
      const glm::vec3& c = this->Discs.centers[key.disc];
      const glm::vec3& n = this->Discs.normals[key.disc];
      return std::tuple(c.x, c.y, c.z, n.x, n.y, n.z, this->Discs.radii[key.disc], key.disc);
    };
    parallelSort(keys.begin(), keys.end(),
      [&](const Key& a, const Key& b)
      { return a.cell != b.cell ? a.cell < b.cell : position(a) < position(b); });
    this->Ids.resize(keys.size());
    parallelForChunks(keys.size(),
      [&](std::size_t, std::size_t begin, std::size_t end)
      {
        // Of its cube, which may have begun in the chunk before.
        std::size_t first = begin;
        while (first > 0 && keys[first - 1].cell == keys[begin].cell)
        {
          --first;
        }
        for (std::size_t i = begin; i < end; ++i)
        {
          first = keys[i].cell == keys[first].cell ? first : i;
          this->Order[i] = keys[i].disc;
          this->Ids[i] = hash(keys[i].cell, i - first);
        }
      });
  }

  const SurfaceDiscs& Discs;
  float Scale; ///< from the centers' unit
  float Largest = 0.0f;
  std::vector<std::uint32_t> Order;
  std::vector<std::uint64_t> Ids;
  // In that order, so that what is needed together is read from one part of the memory.
  struct Side
  {
    glm::vec3 normal;
    float reach;
  };
  std::vector<double> Areas;
  std::vector<glm::vec3> Middles;
  std::vector<Side> Sides;
};

} // namespace

double areaOf(const SurfaceDiscs& discs)
{
  return parallelReduce(
    discs.centers.size(), 0.0,
    [&](std::size_t disc) { return isUsable(discs, disc) ? areaAt(discs, disc) : 0.0; }, std::plus());
}

double areaPerSample(double spacing, double candidates)
{
  return spacing * spacing / countOfDiscs(candidates);
}

double spacingForCount(const SurfaceDiscs& discs, double count, double candidates)
{
  return std::sqrt(countOfDiscs(candidates) * areaOf(discs) / count);
}

std::vector<DiscSample> sampleDiscs(
  const SurfaceDiscs& discs, double spacing, double candidates, std::uint64_t seed, const Progress& progress)
{
  const double each = std::clamp(candidates, leastCandidates, mostCandidates);
  const double expected = areaOf(discs) / areaPerSample(spacing, each);
  if (!(expected > 0.0))
  {
    return {};
  }
  const DiscPieces pieces(discs, static_cast<float>(1.0 / spacing));
  const glm::vec3 high = parallelReduce(
    pieces.middles().size(), glm::vec3(0.0f), [&](std::size_t i) { return glm::abs(pieces.middles()[i]); },
    [](const glm::vec3& a, const glm::vec3& b) { return glm::max(a, b); });
  const double widest = 2.0 * static_cast<double>(std::max({ high.x, high.y, high.z }) + pieces.longest());
  if (!(widest < 0x1p24))
  {
    throw std::invalid_argument("the surface is " + std::to_string(widest) +
      " times as wide as its samples are apart; expected less than 16777216 times, so fewer samples");
  }
  ProgressiveSampler sampler(pieces, static_cast<float>(std::max(std::numbers::sqrt3 * widest, 2.0)), seed);
  for (int octave = sampler.octaves() - 1; octave >= 0; --octave)
  {
    const double share = std::ldexp(1.0, -2 * octave);
    const Progress part =
      progress ? Progress([&](double done) { return progress((0.25 + 0.75 * done) * share); }) : Progress();
    if (!sampler.add(progressive::levelsPerOctave,
          each * std::max(expected * share, progressive::fewestPerOctave), part))
    {
      return {};
    }
  }
  return sampler.take();
}

} // namespace ink
