// SPDX-License-Identifier: BSD-3-Clause
#include "Curvature/CurvatureDiffusion.h"

#include "Core/ParallelChunks.h"

#include <Eigen/Core>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ink
{

namespace
{

constexpr std::size_t sitesPerChunk = 1 << 10;

/// What a site says of curvature in coordinates of space, so that sites can be added up.
struct SpatialCurvature
{
  /// The second fundamental form's xx, yy, zz, xy, yz, zx, and its norm's square; the variance of noise; the
  /// normal, zero if nothing is known; and one more, for full vectors.
  Eigen::Array<double, 12, 1> numbers = Eigen::Array<double, 12, 1>::Zero();

  SpatialCurvature() = default;
  SpatialCurvature(const PrincipalCurvature& c, double deviation)
  {
    const glm::dvec3 normal = c.normal();
    const auto product = [&c](int i, int j)
    { return c.k1 * c.direction1[i] * c.direction1[j] + c.k2 * c.direction2[i] * c.direction2[j]; };
    this->numbers << product(0, 0), product(1, 1), product(2, 2), product(0, 1), product(1, 2), product(2, 0),
      0.0, deviation * deviation, normal.x, normal.y, normal.z, 0.0;
    this->numbers[6] = this->squareOfForm();
  }

  bool facesWith(const SpatialCurvature& other) const
  {
    return (this->numbers.tail<4>() * other.numbers.tail<4>()).sum() > 0.0;
  }

  /// Whether the forms that were averaged vary more than by noise. Those of spheres and tori with noise vary
  /// by 1 to 5 of its deviations, by up to 10 where points are uneven; those of bumps by 8 to 40.
  bool isUneven() const
  {
    constexpr double most = 9.5;
    // Also for what is not finite.
    return !(this->numbers[6] - this->squareOfForm() <= most * most * this->numbers[7]);
  }

  PrincipalCurvature principal() const
  {
    const auto& n = this->numbers;
    const auto [axis1, axis2] = tangentAxes(glm::normalize(glm::dvec3(n[8], n[9], n[10])));
    const glm::dmat3 form(n[0], n[3], n[5], n[3], n[1], n[4], n[5], n[4], n[2]);
    const glm::dvec3 image1 = form * axis1;
    const glm::dvec3 image2 = form * axis2;
    return principalCurvature(
      { glm::dot(axis1, image1), glm::dot(axis1, image2), glm::dot(axis2, image2) }, axis1, axis2);
  }

private:
  double squareOfForm() const
  {
    const Eigen::Array<double, 6, 1> occurrences(1.0, 1.0, 1.0, 2.0, 2.0, 2.0);
    return (occurrences * this->numbers.head<6>().square()).sum();
  }
};

SpatialCurvature averageAround(
  std::uint32_t site, std::span<const std::uint32_t> ring, std::span<const SpatialCurvature> values)
{
  SpatialCurvature sum = values[site];
  int count = 1;
  for (const std::uint32_t neighbor : ring)
  {
    if (values[neighbor].facesWith(values[site]))
    {
      sum.numbers += values[neighbor].numbers;
      ++count;
    }
  }
  sum.numbers *= 1.0 / count;
  return sum;
}

} // namespace

double passesToDivideNoise(double factor)
{
  constexpr double growth = 0.8; // of the squared width, by a pass
  return (std::cbrt(factor * factor) - 1.0) / growth;
}

int passesForRings(int rings)
{
  const double width = std::max(0.5 * rings, 1.0); // in widths of two rings
  return static_cast<int>(std::lround(passesToDivideNoise(width * width * width)));
}

std::vector<std::uint32_t> diffuseCurvature(
  const SurfaceRings& rings, std::span<const CurvatureNoise> noise, MeshCurvature& curvature)
{
  std::vector<std::uint32_t> active;
  int passes = 0;
  for (std::uint32_t site = 0; site < noise.size(); ++site)
  {
    if (noise[site].passes > 0 && curvature.sources[site] != CurvatureSource::None)
    {
      active.push_back(site);
      passes = std::max<int>(passes, noise[site].passes);
    }
  }
  if (active.empty())
  {
    return {};
  }
  std::vector<SpatialCurvature> before(noise.size());
  parallelForEach(noise.size(),
    [&](std::size_t site)
    {
      if (curvature.sources[site] != CurvatureSource::None)
      {
        before[site] = { curvature.points[site], noise[site].deviation };
      }
    });
  std::vector<SpatialCurvature> after = before;
  std::vector<std::uint8_t> isUneven(noise.size(), 0);
  for (int pass = 0; pass < passes; ++pass)
  {
    parallelForEach(
      active.size(),
      [&](std::size_t i)
      {
        const std::uint32_t site = active[i];
        if (noise[site].passes > pass && isUneven[site] == 0)
        {
          const SpatialCurvature average = averageAround(site, rings.ring(site), before);
          isUneven[site] = average.isUneven();
          after[site] = isUneven[site] != 0 ? before[site] : average;
        }
        else
        {
          after[site] = before[site];
        }
      },
      sitesPerChunk);
    before.swap(after);
  }
  parallelForEach(
    active.size(), [&](std::size_t i) { curvature.points[active[i]] = before[active[i]].principal(); });
  std::erase_if(active, [&](std::uint32_t site) { return isUneven[site] == 0; });
  return active;
}

} // namespace ink
