// SPDX-License-Identifier: BSD-3-Clause
#include "Tone/Hatching/LocalSpacing.h"

#include "Core/IsFinite.h"
#include "Core/ParallelChunks.h"
#include "Tone/Hatching/KernelSums.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>

namespace ink::hatching
{

namespace
{

/// Two ratios, of which the second is of the smaller fraction, have one kernel.
constexpr std::size_t together = 2;
// Of the distance of strokes with that fraction:
constexpr float reach = 2.0f;
constexpr float partLength = 0.5f; ///< of strokes
constexpr float partEdge = 0.6f;   ///< of the surface
/// In a square of that edge, before these are joined.
constexpr double mostParts = 3.0;
/// Ratios are no more than this, and no less than its inverse.
constexpr float mostRatio = 2.0f;

/// Into which a segment of a stroke is cut; longer ones than any surface has are wrong.
constexpr float mostCuts = 1e6f;

constexpr std::size_t strokesPerChunk = 16;

using Fractions = std::array<float, together>;
using Ratios = std::array<float, together>;

/// Parts of the surface, whose area is the first weight, and of strokes: their length as far as they are
/// present with each fraction.
std::vector<KernelSums::Sample> samplesOf(
  const FamilyStrokes& strokes, const AreaSamples& surface, const Fractions& fractions, float longest)
{
  std::vector<KernelSums::Sample> samples;
  for (std::size_t i = 0; i < surface.size(); ++i)
  {
    samples.push_back({ surface.positions[i], surface.normals[i], { surface.areas[i], 0.0f, 0.0f } });
  }
  for (std::size_t stroke = 0; stroke < strokes.priorities.size(); ++stroke)
  {
    const glm::vec3 present(0.0f, presence(fractions[0], strokes.priorities[stroke]),
      presence(fractions[1], strokes.priorities[stroke]));
    const std::size_t end = strokes.begins[stroke + 1];
    for (std::size_t i = strokes.begins[stroke]; present.y > 0.0f && i + 1 < end; ++i)
    {
      const glm::vec3 way = strokes.points[i + 1] - strokes.points[i];
      const glm::vec3 normal = strokes.normals[i] + strokes.normals[i + 1];
      const float length = glm::length(way);
      if (!(length > 0.0f && std::isfinite(length) && isFinite(normal)))
      {
        continue;
      }
      const float parts = std::ceil(std::min(length / longest, mostCuts));
      for (float part = 0.5f; part < parts; part += 1.0f)
      {
        samples.push_back({ strokes.points[i] + part / parts * way,
          normal == glm::vec3(0.0f) ? normal : glm::normalize(normal), length / parts * present });
      }
    }
  }
  return samples;
}

/// Ratios along a stroke: at points that are a distance apart, and linear between them.
/// @param of the ratios at a point
/// @param set(point, ratios)
template <class Of, class Set>
void fillRatios(
  const FamilyStrokes& strokes, std::size_t stroke, float distance, const Of& of, const Set& set)
{
  const std::size_t first = strokes.begins[stroke];
  const std::size_t end = strokes.begins[stroke + 1];
  std::vector<float> arcs; // from the last such point on
  Ratios before{};
  for (std::size_t i = first; i < end; ++i)
  {
    const float step = i > first ? glm::distance(strokes.points[i], strokes.points[i - 1]) : 0.0f;
    arcs.push_back((arcs.empty() ? 0.0f : arcs.back()) + (std::isfinite(step) ? step : 0.0f));
    if (i > first && i + 1 < end && arcs.back() < distance)
    {
      continue;
    }
    const Ratios own = of(i);
    for (std::size_t k = 1; k < arcs.size(); ++k)
    {
      const float share = arcs.back() > 0.0f ? arcs[k] / arcs.back() : 1.0f;
      set(i + k + 1 - arcs.size(),
        { std::lerp(before[0], own[0], share), std::lerp(before[1], own[1], share) });
    }
    if (i == first)
    {
      set(i, own);
    }
    before = own;
    arcs.assign(1, 0.0f);
  }
}

} // namespace

std::vector<SpacingRatios> localSpacing(
  const FamilyStrokes& strokes, AreaSamples surface, const Progress& progress)
{
  std::vector<SpacingRatios> ratios(strokes.points.size(), evenSpacing);
  const double whole = parallelReduce(
    surface.size(), 0.0, [&](std::size_t i) { return static_cast<double>(surface.areas[i]); }, std::plus<>());
  for (std::size_t level = 0; level < evenSpacing.size(); level += together)
  {
    if (progress && !progress(static_cast<double>(level) / static_cast<double>(evenSpacing.size())))
    {
      return std::vector<SpacingRatios>(strokes.points.size(), evenSpacing);
    }
    const Fractions fractions{ spacingFraction(level), spacingFraction(level + 1) };
    const float distance = 1.0f / fractions[1];
    const float edge = partEdge * distance;
    if (static_cast<double>(surface.size()) * static_cast<double>(edge * edge) > mostParts * whole)
    {
      surface = joinSamples(surface, edge);
    }
    const KernelSums sums(samplesOf(strokes, surface, fractions, partLength * distance), reach * distance);
    const auto of = [&](std::size_t i)
    {
      Ratios own{ 1.0f, 1.0f };
      const glm::vec3& point = strokes.points[i];
      const glm::vec3& normal = strokes.normals[i];
      const glm::vec3 sum = isFinite(point) && isFinite(normal) ? sums.at(point, normal) : glm::vec3(0.0f);
      for (int k = 0; k < 2 && sum[0] > 0.0f; ++k)
      {
        const float even = drawnShare(fractions[static_cast<std::size_t>(k)]) * sum[0];
        own[static_cast<std::size_t>(k)] =
          std::clamp(even / std::max(sum[k + 1], even / mostRatio), 1.0f / mostRatio, mostRatio);
      }
      return own;
    };
    parallelForEach(
      strokes.priorities.size(),
      [&](std::size_t stroke)
      {
        // Or between the first of these fractions and the one before.
        if (level == 0 || presence(spacingFraction(level - 1), strokes.priorities[stroke]) > 0.0f)
        {
          fillRatios(strokes, stroke, distance, of,
            [&](std::size_t i, const Ratios& own)
            {
              ratios[i][level] = own[0];
              ratios[i][level + 1] = own[1];
            });
        }
      },
      strokesPerChunk);
  }
  return ratios;
}

} // namespace ink::hatching
