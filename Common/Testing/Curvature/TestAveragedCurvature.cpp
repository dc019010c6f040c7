// SPDX-License-Identifier: BSD-3-Clause
// Curvature averaged over a distance: noise and spikes vanish, forms stay, the sides of a wall keep apart.

#include "Curvature/AveragedCurvature.h"

#include "HashNoise.h"
#include "SampledMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace
{

using namespace ink;
using namespace ink::test;

struct Tube
{
  Mesh mesh;
  std::vector<glm::vec3> normals;
  std::vector<PrincipalCurvature> exact;

  /// Of radius 1 around z, from -2 to 2, open.
  Tube()
  {
    this->mesh.addPatch(120, 80,
      [](double u, double v)
      {
        const double angle = 2.0 * std::numbers::pi * u;
        return glm::dvec3(std::cos(angle), std::sin(angle), 4.0 * v - 2.0);
      });
    for (const glm::dvec3& p : this->mesh.points)
    {
      this->normals.emplace_back(p.x, p.y, 0.0);
      this->exact.push_back({ 1.0, 0.0, glm::dvec3(-p.y, p.x, 0.0), glm::dvec3(0.0, 0.0, -1.0) });
    }
  }
};

double angleTo(const glm::dvec3& a, const glm::dvec3& b)
{
  return std::acos(std::min(std::abs(glm::dot(a, b)), 1.0)) * 180.0 / std::numbers::pi;
}

} // namespace

TEST(AveragedCurvature, KeepsAForm)
{
  const Tube tube;
  const auto found = averagedCurvature(tube.mesh.view(), tube.normals, tube.exact, 0.3, 10.0);
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    // Forms of neighbors that are turned by an angle count with its squared cosine.
    EXPECT_GT(found[i].k1, 0.93);
    EXPECT_LE(found[i].k1, 1.0 + 1e-6);
    EXPECT_NEAR(found[i].k2, 0.0, 1e-6);
    EXPECT_LT(angleTo(found[i].direction1, tube.exact[i].direction1), 4.0) << i;
  }
}

TEST(AveragedCurvature, NoiseVanishes)
{
  const Tube tube;
  std::vector<PrincipalCurvature> noisy;
  double before = 0.0;
  for (std::size_t i = 0; i < tube.exact.size(); ++i)
  {
    const auto noise = [i](std::uint64_t seed) { return 2.0 * ink::testing::hashNormal(seed, i); };
    noisy.push_back(principalCurvature(
      { 1.0 + noise(1), noise(2), noise(3) }, tube.exact[i].direction1, tube.exact[i].direction2));
    before += angleTo(noisy[i].direction1, tube.exact[i].direction1) > 20.0 ? 1.0 : 0.0;
  }
  const double count = static_cast<double>(noisy.size());
  EXPECT_GT(before / count, 0.4);
  const auto found = averagedCurvature(tube.mesh.view(), tube.normals, noisy, 0.5, 100.0);
  double squares = 0.0;
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    EXPECT_LT(angleTo(found[i].direction1, tube.exact[i].direction1), 30.0) << i;
    squares += std::pow(angleTo(found[i].direction1, tube.exact[i].direction1), 2);
  }
  EXPECT_LT(std::sqrt(squares / count), 8.0);
}

TEST(AveragedCurvature, SpikesAreLimited)
{
  Tube tube;
  const std::size_t spike = tube.exact.size() / 2;
  tube.exact[spike].k2 = -1e30;
  tube.exact[spike + 300].k1 = std::numeric_limits<double>::quiet_NaN();
  for (const PrincipalCurvature& at : averagedCurvature(tube.mesh.view(), tube.normals, tube.exact, 0.3, 2.0))
  {
    EXPECT_GT(at.k1, 0.8);
    EXPECT_NEAR(at.k2, 0.0, 0.2);
  }
}

TEST(AveragedCurvature, SidesOfAWallAreApart)
{
  Mesh mesh = square(20);
  const std::size_t half = mesh.points.size();
  mesh.addPatch(20, 20, [](double u, double v) { return glm::dvec3(v, u, -0.001); });
  std::vector<glm::vec3> normals;
  std::vector<PrincipalCurvature> curvatures;
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    const double side = i < half ? 1.0 : -1.0;
    normals.emplace_back(0.0, 0.0, side);
    curvatures.push_back({ 2.0 + side, side, glm::dvec3(1, 0, 0), glm::dvec3(0, side, 0) });
  }
  const auto found = averagedCurvature(mesh.view(), normals, curvatures, 0.2, 10.0);
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    EXPECT_NEAR(found[i].k1, i < half ? 3.0 : 1.0, 1e-9);
    EXPECT_NEAR(found[i].k2, i < half ? 1.0 : -1.0, 1e-9);
  }
}

TEST(AveragedCurvature, BrokenInput)
{
  Tube tube;
  tube.mesh.points[5].x = std::numeric_limits<double>::quiet_NaN();
  tube.mesh.points[700] = glm::dvec3(1e300);
  tube.mesh.points.emplace_back(0.0);
  tube.normals.emplace_back(0.0f, 0.0f, 1.0f);
  tube.normals[40] = glm::vec3(0.0f);
  tube.exact.emplace_back();
  for (const double width : { 1e-300, 0.3, 1e300 })
  {
    const auto found = averagedCurvature(tube.mesh.view(), tube.normals, tube.exact, width, 10.0);
    for (const PrincipalCurvature& at : found)
    {
      EXPECT_TRUE(std::isfinite(at.k1) && std::isfinite(at.k2));
      EXPECT_NEAR(glm::length(at.direction1), 1.0, 1e-6);
    }
    EXPECT_EQ(found[5].k1, 0.0);
    EXPECT_EQ(found[40].k1, 0.0) << "no normal";
    EXPECT_EQ(found.back().k1, 0.0) << "no triangle";
  }
  tube.exact.pop_back();
  EXPECT_THROW(
    averagedCurvature(tube.mesh.view(), tube.normals, tube.exact, 0.3, 10.0), std::invalid_argument);
  EXPECT_TRUE(averagedCurvature({}, {}, {}, 0.3, 10.0).empty());
}

TEST(AveragedCurvature, SameForAnyThreads)
{
  const Tube tube;
  const auto run = [&] { return averagedCurvature(tube.mesh.view(), tube.normals, tube.exact, 0.2, 10.0); };
  const auto one = onThreads(1, run);
  const auto three = onThreads(3, run);
  for (std::size_t i = 0; i < one.size(); ++i)
  {
    ASSERT_EQ(one[i].k1, three[i].k1);
    ASSERT_EQ(one[i].direction1, three[i].direction1);
  }
}
