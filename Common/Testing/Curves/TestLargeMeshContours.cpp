// SPDX-License-Identifier: BSD-3-Clause
// Contours of 20 million triangles, which take half a minute and 2 GiB: only where INK_LARGE_TESTS is set.
#include "Curves/Contours/MeshContours.h"
#include "SampledMeshes.h"

#include <gtest/gtest.h>

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

namespace
{

/// Processor time, in seconds.
double timeSoFar()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// The most memory that this process has had, in MiB.
double mostMemory()
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

} // namespace

TEST(LargeMeshContours, OfTwentyMillionTriangles)
{
  if (!std::getenv("INK_LARGE_TESTS"))
  {
    GTEST_SKIP() << "takes 2 GiB; runs with INK_LARGE_TESTS=1";
  }
  const double radius = 1.0;
  const double tube = 0.4;
  const ink::test::Mesh mesh = ink::test::torus(radius, tube, 5000, 2000);
  ASSERT_EQ(mesh.triangles.size(), 20'000'000u);
  const auto middleOf = [&](const glm::dvec3& p)
  { return radius * glm::normalize(glm::dvec3(p.x, p.y, 0.0)); };
  std::vector<glm::vec3> normals;
  for (const glm::dvec3& p : mesh.points)
  {
    normals.emplace_back(glm::normalize(p - middleOf(p)));
  }
  const double before = mostMemory();
  double begin = timeSoFar();
  const ink::MeshContours finder(mesh.view(), normals);
  std::printf("index: %.1f s, %.0f MiB more than the mesh's %.0f\n", timeSoFar() - begin,
    mostMemory() - before, before);
  for (const ink::Eye& eye :
    { ink::Eye::at({ 2.0, 3.0, 1.5 }), ink::Eye::at({ 0.0, 0.1, 0.2 }), ink::Eye::along({ 1.0, -0.2, 0.4 }) })
  {
    begin = timeSoFar();
    const ink::Contours contours = finder.find(eye);
    std::printf("%zu points: %.1f ms\n", contours.positions.size(), 1e3 * (timeSoFar() - begin));
    EXPECT_EQ(contours.chains.size(), 2u);
    EXPECT_EQ(std::count(contours.chains.closed.begin(), contours.chains.closed.end(), 1), 2);
    EXPECT_GT(contours.positions.size(), 10'000u);
    double largest = 0.0;
    for (const glm::dvec3& p : contours.positions)
    {
      const glm::dvec3 fromMiddle = p - middleOf(p);
      const double sine = glm::dot(glm::normalize(fromMiddle), glm::normalize(eye.from(p)));
      largest = std::max({ largest, std::abs(glm::length(fromMiddle) - tube), std::abs(sine) });
    }
    // Of second order in edges, which are .0018 long at most.
    EXPECT_LT(largest, 3e-6);
    EXPECT_EQ(contours.positions, finder.find(eye, {}, ink::SilhouetteSearch::Exhaustive).positions);
  }
}
