// SPDX-License-Identifier: BSD-3-Clause
#ifndef VesselTree_h
#define VesselTree_h

#include "HashNoise.h"
#include "SampledVolume.h"

#include "Core/ParallelFor.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

/// A tree of tubes that taper from 6 voxels to 1: that of Testing/Benchmarks/phantoms.py, in a cube of voxels
/// of which one measures 1, around the origin.
class VesselTree
{
public:
  struct Tube
  {
    glm::dvec3 start;
    glm::dvec3 end;
    double startRadius;
    double endRadius;

    /// Where on the tube a position is nearest, from 0 to 1.
    double along(const glm::dvec3& p) const
    {
      const glm::dvec3 axis = this->end - this->start;
      return glm::clamp(glm::dot(p - this->start, axis) / glm::dot(axis, axis), 0.0, 1.0);
    }
    double radius(double t) const { return glm::mix(this->startRadius, this->endRadius, t); }
    /// Negative inside.
    double distance(const glm::dvec3& p) const
    {
      const double t = this->along(p);
      return glm::distance(p, glm::mix(this->start, this->end, t)) - this->radius(t);
    }
  };

  /// @param voxels along a side of the cube
  explicit VesselTree(int voxels)
    : Voxels(voxels)
  {
    this->grow({ 0.0, 0.0, -0.385 }, { 0.0, 0.0, 1.0 }, { 1.0, 0.0, 0.0 }, 0);
  }

  const std::vector<Tube>& tubes() const { return this->Tubes; }

  const Tube& nearest(const glm::dvec3& p) const
  {
    return *std::min_element(this->Tubes.begin(), this->Tubes.end(),
      [&](const Tube& a, const Tube& b) { return a.distance(p) < b.distance(p); });
  }

  /// Values as a scanner sees them: 1 inside and 0 outside, blurred by a Gaussian of .7 voxels, and noise.
  ink::testing::Volume<float> scan(double noise) const
  {
    const ink::GridGeometry grid(glm::ivec3(this->Voxels), glm::dvec3(-0.5 * (this->Voxels - 1)));
    ink::testing::Volume<float> volume(grid, 0.0f);
    const std::vector<float> fine = this->coverage();
    // Rows along x of fine voxels become ones of voxels, which are the columns then.
    std::vector<float> blurred = fine;
    for (int axis = 0; axis < 3; ++axis)
    {
      blurred = this->blurAlongX(blurred);
    }
    std::copy(blurred.begin(), blurred.end(), volume.values.begin());
    for (std::size_t i = 0; i < volume.values.size(); ++i)
    {
      volume.values[i] += static_cast<float>(noise * ink::testing::hashNormal(1, i));
    }
    return volume;
  }

private:
  static constexpr int Fine = 3; ///< parts of a voxel along an axis

  void grow(
    const glm::dvec3& start, const glm::dvec3& direction, const glm::dvec3& across, std::size_t generation)
  {
    constexpr std::array diameters = { 6.0, 4.6, 3.5, 2.6, 1.0 };
    constexpr std::array lengths = { 0.26, 0.23, 0.19, 0.15 };
    const glm::dvec3 end = start + lengths[generation] * direction;
    const double size = this->Voxels;
    this->Tubes.push_back(
      { size * start, size * end, 0.5 * diameters[generation], 0.5 * diameters[generation + 1] });
    if (generation + 1 == lengths.size())
    {
      return;
    }
    const double angle = glm::radians(38.0 - 2.0 * static_cast<double>(generation));
    for (const double sign : { -1.0, 1.0 })
    {
      const glm::dvec3 turned = std::cos(angle) * direction + sign * std::sin(angle) * across;
      // The next branches spread across these.
      const glm::dvec3 beside = glm::cross(direction, across);
      this->grow(
        end, turned, std::cos(0.6) * beside + std::sin(0.6) * glm::cross(beside, turned), generation + 1);
    }
  }

  /// How much of each part of a voxel lies inside.
  std::vector<float> coverage() const
  {
    const int n = Fine * this->Voxels;
    std::vector<float> parts(static_cast<std::size_t>(n) * n * n, 0.0f);
    const auto at = [n](double p) { return std::clamp(static_cast<int>(p), 0, n - 1); };
    const auto toPart = [n](double p) { return Fine * p + 0.5 * n - 0.5; };
    for (const Tube& tube : this->Tubes)
    {
      const double margin = tube.startRadius + 1.0;
      const glm::dvec3 low = glm::min(tube.start, tube.end) - margin;
      const glm::dvec3 high = glm::max(tube.start, tube.end) + margin;
      const int first = at(toPart(low.z));
      ink::parallelFor(static_cast<std::size_t>(at(toPart(high.z)) - first),
        [&](std::size_t layer)
        {
          const int k = first + static_cast<int>(layer);
          for (int j = at(toPart(low.y)); j < at(toPart(high.y)); ++j)
          {
            for (int i = at(toPart(low.x)); i < at(toPart(high.x)); ++i)
            {
              const glm::dvec3 p = (glm::dvec3(i, j, k) - 0.5 * (n - 1)) / static_cast<double>(Fine);
              const auto inside = static_cast<float>(std::clamp(0.5 - Fine * tube.distance(p), 0.0, 1.0));
              float& part = parts[(static_cast<std::size_t>(k) * n + j) * n + i];
              part = std::max(part, inside);
            }
          }
        });
    }
    return parts;
  }

  /// Rows of fine voxels along x, blurred at the middles of voxels; x becomes the slowest axis, y the
  /// fastest.
  std::vector<float> blurAlongX(const std::vector<float>& from) const
  {
    constexpr double spread = 0.7 * Fine;
    constexpr int reach = 4 * Fine;
    std::array<double, 2 * reach + 1> kernel;
    double sum = 0.0;
    for (int i = -reach; i <= reach; ++i)
    {
      sum += kernel[static_cast<std::size_t>(i + reach)] = std::exp(-0.5 * i * i / (spread * spread));
    }
    const int fine = Fine * this->Voxels;
    const std::size_t rows = from.size() / static_cast<std::size_t>(fine);
    std::vector<float> to(rows * static_cast<std::size_t>(this->Voxels));
    ink::parallelFor(rows,
      [&](std::size_t row)
      {
        for (int x = 0; x < this->Voxels; ++x)
        {
          double value = 0.0;
          for (int i = -reach; i <= reach; ++i)
          {
            const int part = Fine * x + Fine / 2 + i;
            value += part >= 0 && part < fine ? kernel[static_cast<std::size_t>(i + reach)] *
                from[row * static_cast<std::size_t>(fine) + part]
                                              : 0.0;
          }
          to[static_cast<std::size_t>(x) * rows + row] = static_cast<float>(value / sum);
        }
      });
    return to;
  }

  int Voxels;
  std::vector<Tube> Tubes;
};

#endif
