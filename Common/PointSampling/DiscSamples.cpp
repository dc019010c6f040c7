// SPDX-License-Identifier: BSD-3-Clause
#include "PointSampling/DiscSamples.h"

#include "Core/Hash.h"
#include "Core/MortonOrder.h"
#include "Core/ParallelFor.h"
#include "Core/ParallelSort.h"
#include "PointSampling/ProgressiveBlueNoise.h"
#include "PointSampling/ProgressiveSampler.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <tuple>

namespace ink
{

namespace
{

// The part of its radius within which a disc has candidates: enough that those of a regular grid of points
// leave no holes, and no more, as positions near the rim lie farther off the surface.
constexpr float candidateReach = 0.82f;

/// Where the corner is of the cubes that name discs, in their width: not where the middles of a grid's cells
/// are, on which rounding would decide.
constexpr glm::vec3 corner(0.38f, 0.21f, 0.57f);

bool isFinite(const glm::vec3& v)
{
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

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
    for (std::size_t disc = 0; disc < discs.centers.size(); ++disc)
    {
      if (isUsable(discs, disc))
      {
        this->Order.push_back(static_cast<std::uint32_t>(disc));
        this->Largest = std::max(this->Largest, discs.radii[disc] * scale);
      }
    }
    this->sort();
    const std::size_t count = this->Order.size();
    this->Areas.resize(count);
    this->Middles.resize(count);
    this->Sides.resize(count);
    parallelFor((count + chunkSize - 1) / chunkSize,
      [&](std::size_t chunk)
      {
        for (std::size_t i = chunk * chunkSize; i < std::min((chunk + 1) * chunkSize, count); ++i)
        {
          const std::uint32_t disc = this->Order[i];
          this->Areas[i] = areaAt(discs, disc);
          this->Middles[i] = discs.centers[disc] * scale;
          this->Sides[i] = { glm::normalize(discs.normals[disc]),
            candidateReach * discs.radii[disc] * scale };
        }
      });
  }

  std::span<const double> areas() const { return this->Areas; }
  std::span<const glm::vec3> middles() const { return this->Middles; }
  std::span<const std::uint64_t> keys() const { return this->Keys; }
  float longest() const { return 2.0f * candidateReach * this->Largest; }

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
  DiscSample sample(std::size_t piece, float b1, float b2) const
  {
    const Frame at = this->frame(piece);
    return { (at.origin + b1 * at.along1 + b2 * at.along2) / this->Scale, this->Order[piece] };
  }

private:
  static constexpr std::size_t chunkSize = 1 << 13;

  /// By what discs are, not by where they stand in the input.
  void sort()
  {
    struct Key
    {
      std::uint64_t cell;
      std::uint32_t disc;
    };
    float farthest = 0.0f;
    for (const std::uint32_t disc : this->Order)
    {
      const glm::vec3 distance = glm::abs(this->Discs.centers[disc]);
      farthest = std::max({ farthest, distance.x, distance.y, distance.z });
    }
    // A power of two, as radii that differ in rounding are to have the same cubes.
    const float least = std::max(this->Largest / this->Scale, farthest * 0x1p-19f);
    const float width = std::exp2(std::floor(std::log2(least)));
    std::vector<Key> keys(this->Order.size());
    parallelFor((keys.size() + chunkSize - 1) / chunkSize,
      [&](std::size_t chunk)
      {
        for (std::size_t i = chunk * chunkSize; i < std::min((chunk + 1) * chunkSize, keys.size()); ++i)
        {
          const std::uint32_t disc = this->Order[i];
          const glm::vec3 cell = glm::clamp(
            glm::floor(this->Discs.centers[disc] / width + corner) + 0x1p20f, 0.0f, 0x1p21f - 1.0f);
          keys[i] = { mortonOf(glm::uvec3(cell)), disc };
        }
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
    this->Keys.resize(keys.size());
    std::uint64_t rank = 0;
    for (std::size_t i = 0; i < keys.size(); ++i)
    {
      rank = i > 0 && keys[i].cell == keys[i - 1].cell ? rank + 1 : 0;
      this->Order[i] = keys[i].disc;
      this->Keys[i] = hash(keys[i].cell, rank);
    }
  }

  const SurfaceDiscs& Discs;
  float Scale; ///< from the centers' unit
  float Largest = 0.0f;
  std::vector<std::uint32_t> Order;
  std::vector<std::uint64_t> Keys;
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
  double area = 0.0;
  for (std::size_t disc = 0; disc < discs.centers.size(); ++disc)
  {
    area += isUsable(discs, disc) ? areaAt(discs, disc) : 0.0;
  }
  return area;
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
  glm::vec3 high(0.0f);
  for (const glm::vec3& middle : pieces.middles())
  {
    high = glm::max(high, glm::abs(middle));
  }
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
