// SPDX-License-Identifier: BSD-3-Clause
#include "Curvature/MeshCurvature.h"

#include "MeshesWithCurvature.h"

#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace
{

using namespace ink;

test::CurvatureErrors errorsOf(const test::MeshWithCurvature& mesh, const CurvatureOptions& options = {})
{
  return test::curvatureErrors(mesh.exact, estimateCurvature(mesh.mesh.view(), {}, options).points);
}

CurvatureOptions withRings(int rings, int degree)
{
  CurvatureOptions options;
  options.rings = rings;
  options.degree = degree;
  options.adaptive = false;
  return options;
}

CurvatureOptions ofThePaper()
{
  CurvatureOptions options;
  options.estimator = CurvatureEstimator::ExponentialMap;
  return options;
}

bool isFinite(const PrincipalCurvature& c)
{
  return std::isfinite(c.k1) && std::isfinite(c.k2) && std::abs(glm::length(c.direction1) - 1.0) < 1e-9 &&
    std::abs(glm::length(c.direction2) - 1.0) < 1e-9 && std::abs(glm::dot(c.direction1, c.direction2)) < 1e-9;
}

bool areEqual(const PrincipalCurvature& a, const PrincipalCurvature& b)
{
  return a.k1 == b.k1 && a.k2 == b.k2 && a.direction1 == b.direction1 && a.direction2 == b.direction2;
}

} // namespace

TEST(MeshCurvature, ConvergesInSecondOrder)
{
  // All estimators on regular meshes; on irregular ones the jet of degree 3 only.
  for (const CurvatureOptions& options :
    { CurvatureOptions(), withRings(2, 2), withRings(3, 2), withRings(3, 3), ofThePaper() })
  {
    const test::CurvatureErrors coarse = errorsOf(test::closedTorus(1.0, 0.4, 90, 45), options);
    const test::CurvatureErrors fine = errorsOf(test::closedTorus(1.0, 0.4, 180, 90), options);
    EXPECT_GT(coarse.curvature / fine.curvature, 3.5) << options.rings << ", degree " << options.degree;
    EXPECT_GT(coarse.angle / fine.angle, 3.5) << options.rings << ", degree " << options.degree;
    EXPECT_LT(fine.curvature, 0.03) << options.rings << ", degree " << options.degree;
  }
  const test::CurvatureErrors coarse = errorsOf(test::closedTorus(1.0, 0.4, 90, 45, 0.45));
  const test::CurvatureErrors fine = errorsOf(test::closedTorus(1.0, 0.4, 180, 90, 0.45));
  EXPECT_GT(coarse.curvature / fine.curvature, 3.5);
  EXPECT_GT(coarse.angle / fine.angle, 3.5);
}

TEST(MeshCurvature, TheDefaultIsBetterThanThePaperWherePointsAreIrregularOrNoisy)
{
  // Measured: 0.0083 and 0.96; 0.10 and 4.57; angles 0.025 and 6.8 degrees.
  const test::MeshWithCurvature irregular = test::closedTorus(1.0, 0.4, 180, 90, 0.45);
  EXPECT_LT(errorsOf(irregular).curvature, 0.01);
  EXPECT_LT(errorsOf(irregular).angle, 0.04);
  EXPECT_GT(errorsOf(irregular, ofThePaper()).curvature, 0.5);
  const test::MeshWithCurvature noisy = test::ellipsoid(glm::dvec3(1.0), 4, 0.01);
  EXPECT_LT(errorsOf(noisy).curvature, 0.12);
  EXPECT_GT(errorsOf(noisy, ofThePaper()).curvature, 3.0);
  // Both: 0.176 and 2.91 degrees, libigl with radius 5 0.24 and 2.95.
  const test::MeshWithCurvature both = test::closedTorus(1.0, 0.4, 180, 90, 0.45, 0.002);
  EXPECT_LT(errorsOf(both).curvature, 0.18);
  EXPECT_LT(errorsOf(both).angle, 2.95);
}

TEST(MeshCurvature, AdaptiveRingsFollowTheNoise)
{
  // Without noise as good as two rings, with noise about as good as five.
  const test::MeshWithCurvature clean = test::ellipsoid({ 1.0, 0.7, 0.5 }, 4);
  EXPECT_LT(errorsOf(clean).curvature, 1.05 * errorsOf(clean, withRings(2, 3)).curvature);
  EXPECT_LT(errorsOf(clean).curvature, 0.3 * errorsOf(clean, withRings(5, 3)).curvature);
  const test::MeshWithCurvature noisy = test::ellipsoid(glm::dvec3(1.0), 4, 0.01);
  EXPECT_LT(errorsOf(noisy).curvature, 1.2 * errorsOf(noisy, withRings(5, 3)).curvature);
  EXPECT_LT(errorsOf(noisy).curvature, 0.2 * errorsOf(noisy, withRings(2, 3)).curvature);
}

TEST(MeshCurvature, SignFollowsTheNormals)
{
  test::MeshWithCurvature ball = test::ellipsoid(glm::dvec3(2.0), 3);
  for (const CurvatureOptions& options : { CurvatureOptions(), ofThePaper() })
  {
    const MeshCurvature outward = estimateCurvature(ball.mesh.view(), {}, options);
    std::vector<glm::vec3> inwardNormals;
    for (const glm::dvec3& point : ball.mesh.points)
    {
      inwardNormals.emplace_back(-3.0 * point);
    }
    const MeshCurvature inward = estimateCurvature(ball.mesh.view(), inwardNormals, options);
    test::Mesh turned = ball.mesh;
    for (Triangle& triangle : turned.triangles)
    {
      std::swap(triangle[0], triangle[1]);
    }
    const MeshCurvature insideOut = estimateCurvature(turned.view(), {}, options);
    for (std::size_t i = 0; i < ball.mesh.points.size(); ++i)
    {
      ASSERT_NEAR(outward.points[i].k1, 0.5, 0.015) << i;
      ASSERT_NEAR(outward.points[i].k2, 0.5, 0.015) << i;
      ASSERT_GT(glm::dot(outward.points[i].normal(), ball.mesh.points[i]), 1.99) << i;
      for (const MeshCurvature* other : { &inward, &insideOut })
      {
        ASSERT_NEAR(other->points[i].k1, -outward.points[i].k2, 1e-4) << i;
        ASSERT_NEAR(other->points[i].k2, -outward.points[i].k1, 1e-4) << i;
        ASSERT_LT(glm::dot(other->points[i].normal(), ball.mesh.points[i]), -1.99) << i;
      }
    }
  }
}

TEST(MeshCurvature, UnitAndOriginDoNotMatter)
{
  const test::MeshWithCurvature one = test::ellipsoid({ 1.0, 0.7, 0.5 }, 3);
  const MeshCurvature expected = estimateCurvature(one.mesh.view(), {});
  for (const double unit : { 1e-9, 1e9, 1.0 })
  {
    test::Mesh mesh = one.mesh;
    for (glm::dvec3& point : mesh.points)
    {
      point = unit * point + (unit == 1.0 ? glm::dvec3(1e7, -1e7, 1e7) : glm::dvec3(0.0));
    }
    const MeshCurvature found = estimateCurvature(mesh.view(), {});
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
    {
      // At 1e7 positions are rounded to 2e-9.
      ASSERT_NEAR(found.points[i].k1 * unit, expected.points[i].k1, 1e-5) << unit << ", " << i;
      ASSERT_NEAR(found.points[i].k2 * unit, expected.points[i].k2, 1e-5) << unit << ", " << i;
    }
  }
}

TEST(MeshCurvature, TheSameForAnyNumberOfThreads)
{
  const test::MeshWithCurvature mesh = test::ellipsoid({ 1.0, 0.7, 0.5 }, 5, 0.002);
  CurvatureOptions options;
  options.derivatives = true;
  const auto run = [&] { return estimateCurvature(mesh.mesh.view(), {}, options); };
  const MeshCurvature one = test::onThreads(1, run);
  const MeshCurvature two = test::onThreads(2, run);
  ASSERT_EQ(one.points.size(), two.points.size());
  EXPECT_EQ(one.sources, two.sources);
  for (std::size_t i = 0; i < one.points.size(); ++i)
  {
    ASSERT_TRUE(areEqual(one.points[i], two.points[i])) << i;
    ASSERT_EQ(one.derivatives[i].c122, two.derivatives[i].c122) << i;
  }
}

TEST(MeshCurvature, DerivativesOfATorus)
{
  const std::uint32_t columns = 180;
  const std::uint32_t rows = 90;
  const test::MeshWithCurvature mesh = test::closedTorus(1.0, 0.4, columns, rows);
  CurvatureOptions options;
  options.derivatives = true;
  const MeshCurvature found = estimateCurvature(mesh.mesh.view(), {}, options);
  for (std::uint32_t row = 0; row < rows; ++row)
  {
    const std::size_t i = row * columns;
    const double t = 2.0 * glm::pi<double>() * row / rows;
    const double out = 1.0 + 0.4 * std::cos(t);
    const double exact = -std::sin(t) / (out * out) / 0.4;
    const double sign =
      glm::dot(found.points[i].direction1, glm::dvec3(-std::sin(t), 0.0, std::cos(t))) > 0.0 ? 1.0 : -1.0;
    ASSERT_NEAR(sign * found.derivatives[i].c122, exact, 0.1) << row;
    ASSERT_NEAR(found.derivatives[i].c111, 0.0, 0.1) << row;
    ASSERT_NEAR(found.derivatives[i].c112, 0.0, 0.1) << row;
    ASSERT_NEAR(found.derivatives[i].c222, 0.0, 0.1) << row;
  }
}

TEST(MeshCurvature, SeamsAreNoBorders)
{
  const test::Mesh open = test::torus(1.0, 0.4, 80, 40); // but for positions
  const MeshCurvature found = estimateCurvature(open.view(), {});
  for (std::size_t i = 0; i < open.points.size(); ++i)
  {
    ASSERT_EQ(found.sources[i], CurvatureSource::Surface) << i;
    ASSERT_NEAR(found.points[i].k1, 2.5, 0.1) << i;
  }
  // The first and last point of a row are one.
  EXPECT_TRUE(areEqual(found.points[0], found.points[80]));
}

TEST(MeshCurvature, SeamsOpenedByRoundingAreNoBorders)
{
  // As lines of curvature are traced over them.
  test::Mesh open = test::torus(1.0, 0.4, 80, 40);
  for (std::size_t i = 0; i < open.points.size(); ++i)
  {
    const auto random = [i](std::uint64_t n) { return 2.0 * ink::testing::hashUniform(n, i) - 1.0; };
    open.points[i] += 3e-7 * glm::dvec3(random(1), random(2), random(3));
  }
  const MeshCurvature found = estimateCurvature(open.view(), {});
  for (std::size_t i = 0; i < open.points.size(); ++i)
  {
    ASSERT_EQ(found.sources[i], CurvatureSource::Surface) << i;
    ASSERT_NEAR(found.points[i].k1, 2.5, 0.1) << i;
  }
}

TEST(MeshCurvature, BordersAreOneSided)
{
  // A piece of a cylinder of radius 1/2.
  test::Mesh mesh;
  mesh.addPatch(
    20, 20, [](double u, double v) { return glm::dvec3(0.5 * std::sin(u), v, 0.5 * std::cos(u)); });
  const MeshCurvature found = estimateCurvature(mesh.view(), {});
  const MeshCurvature paper = estimateCurvature(mesh.view(), {}, ofThePaper());
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    const std::size_t column = i % 21;
    const std::size_t row = i / 21;
    const bool atBorder = column == 0 || column == 20 || row == 0 || row == 20;
    ASSERT_EQ(found.sources[i], atBorder ? CurvatureSource::Border : CurvatureSource::Surface) << i;
    ASSERT_NEAR(found.points[i].k1, 2.0, 0.05) << i;
    ASSERT_NEAR(found.points[i].k2, 0.0, 0.05) << i;
    ASSERT_NEAR(std::abs(found.points[i].direction2.y), 1.0, 1e-4) << i;
    // The paper does not handle borders; the neighbors stand in, but at two corners, which have none inside.
    if (atBorder)
    {
      ASSERT_GE(paper.sources[i], CurvatureSource::Neighbors) << i;
    }
    if (paper.sources[i] != CurvatureSource::None)
    {
      ASSERT_NEAR(paper.points[i].k1, 2.0, 0.02) << i;
      ASSERT_NEAR(paper.points[i].k2, 0.0, 0.02) << i;
    }
  }
  EXPECT_EQ(std::count(paper.sources.begin(), paper.sources.end(), CurvatureSource::None), 2);
}

TEST(MeshCurvature, SmallPolyhedraHaveTheCurvatureOfTheirSpheres)
{
  test::Mesh octahedron;
  octahedron.points = { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } };
  octahedron.triangles = { { 0, 2, 4 }, { 2, 1, 4 }, { 1, 3, 4 }, { 3, 0, 4 }, { 2, 0, 5 }, { 1, 2, 5 },
    { 3, 1, 5 }, { 0, 3, 5 } };
  test::Mesh tetrahedron;
  const double s = std::sqrt(1.0 / 3.0);
  tetrahedron.points = { { s, s, s }, { s, -s, -s }, { -s, s, -s }, { -s, -s, s } };
  tetrahedron.triangles = { { 0, 1, 2 }, { 0, 3, 1 }, { 0, 2, 3 }, { 1, 3, 2 } };
  // Their neighbors face sideways or away, so that no polynomial is fitted.
  for (const test::Mesh& mesh : { octahedron, tetrahedron })
  {
    const MeshCurvature found = estimateCurvature(mesh.view(), {});
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
    {
      EXPECT_EQ(found.sources[i], CurvatureSource::Surface) << i;
      EXPECT_NEAR(found.points[i].k1, 1.0, 1e-9) << i;
      EXPECT_NEAR(found.points[i].k2, 1.0, 1e-9) << i;
    }
  }
}

TEST(MeshCurvature, SliversOfATriangularTube)
{
  // Three rows of points, which do not see each other, far apart compared to the points of a row. What is far
  // would give curvatures along the tube of up to 1000.
  const test::MeshWithCurvature tube = test::closedTorus(1.0, 0.4, 2000, 3);
  const MeshCurvature found = estimateCurvature(tube.mesh.view(), {});
  for (std::size_t i = 0; i < found.points.size(); ++i)
  {
    ASSERT_NEAR(found.points[i].k1, 2.5, 0.7) << i;
    ASSERT_NEAR(found.points[i].k2, tube.exact[i].k2, 0.7) << i;
  }
}

TEST(MeshCurvature, WhatHasNoneIsZeroAndFlagged)
{
  test::Mesh mesh = test::square(4);
  const auto isolated = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.emplace_back(5.0, 5.0, 5.0);
  const auto bad = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.emplace_back(std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
  mesh.triangles.push_back({ 0, 1, bad });
  // A triangle of points on a line, apart from all others.
  const auto line = static_cast<std::uint32_t>(mesh.points.size());
  for (int i = 0; i < 3; ++i)
  {
    mesh.points.emplace_back(9.0 + i, 9.0, 9.0);
  }
  mesh.triangles.push_back({ line, line + 1, line + 2 });
  for (const CurvatureOptions& options : { CurvatureOptions(), withRings(1, 2), ofThePaper() })
  {
    const MeshCurvature found = estimateCurvature(mesh.view(), {}, options);
    for (const std::uint32_t i : { isolated, bad, line, line + 1, line + 2 })
    {
      EXPECT_EQ(found.sources[i], CurvatureSource::None) << i;
      EXPECT_EQ(found.points[i].k1, 0.0) << i;
      EXPECT_EQ(found.points[i].k2, 0.0) << i;
    }
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
    {
      EXPECT_TRUE(isFinite(found.points[i])) << i;
      EXPECT_NEAR(found.points[i].k1, 0.0, 1e-9) << i;
    }
  }
}

TEST(MeshCurvature, LargeFansTakeNoQuadraticTime)
{
  // If each point visited all others around the center, this would take 10^9 steps.
  constexpr std::uint32_t rim = 30000;
  test::Mesh mesh;
  mesh.points.emplace_back(0.0, 0.0, 0.0);
  for (std::uint32_t i = 0; i < rim; ++i)
  {
    const double angle = 2.0 * glm::pi<double>() * i / rim;
    mesh.points.emplace_back(std::cos(angle), std::sin(angle), -0.1);
    mesh.triangles.push_back({ 0, i + 1, (i + 1) % rim + 1 });
  }
  const MeshCurvature found = estimateCurvature(mesh.view(), {});
  EXPECT_EQ(found.sources[0], CurvatureSource::Surface);
  EXPECT_TRUE(std::all_of(found.points.begin(), found.points.end(), isFinite));
}

TEST(MeshCurvature, TrianglesThatAreThereTwiceCountOnce)
{
  const test::MeshWithCurvature mesh = test::ellipsoid({ 1.0, 0.7, 0.5 }, 3);
  const MeshCurvature expected = estimateCurvature(mesh.mesh.view(), {});
  test::Mesh same = mesh.mesh;
  test::Mesh twoSided = mesh.mesh;
  test::Mesh soup; // each triangle, and each of the other side, with points of its own
  std::vector<std::size_t> original;
  for (const auto& [a, b, c] : mesh.mesh.triangles)
  {
    same.triangles.push_back({ b, c, a });
    twoSided.triangles.push_back({ c, b, a });
    for (const Triangle& side : { Triangle{ a, b, c }, Triangle{ c, b, a } })
    {
      const auto first = static_cast<std::uint32_t>(soup.points.size());
      soup.triangles.push_back({ first, first + 1, first + 2 });
      for (const std::uint32_t point : side)
      {
        soup.points.push_back(mesh.mesh.points[point]);
        original.push_back(point);
      }
    }
  }
  for (const test::Mesh* twice : { &same, &twoSided })
  {
    const MeshCurvature found = estimateCurvature(twice->view(), {});
    ASSERT_EQ(found.sources, expected.sources);
    for (std::size_t i = 0; i < found.points.size(); ++i)
    {
      ASSERT_EQ(found.points[i].k1, expected.points[i].k1) << i;
      ASSERT_EQ(found.points[i].k2, expected.points[i].k2) << i;
      ASSERT_EQ(found.points[i].direction1, expected.points[i].direction1) << i;
    }
  }
  const MeshCurvature found = estimateCurvature(soup.view(), {});
  for (std::size_t i = 0; i < original.size(); ++i)
  {
    ASSERT_EQ(found.sources[i], CurvatureSource::Surface) << i;
    ASSERT_NEAR(found.points[i].k1, expected.points[original[i]].k1, 1e-6) << i;
    ASSERT_NEAR(found.points[i].k2, expected.points[original[i]].k2, 1e-6) << i;
  }
}

TEST(MeshCurvature, CanBeStopped)
{
  const test::MeshWithCurvature mesh = test::closedTorus(1.0, 0.4, 90, 45);
  const MeshCurvature found = estimateCurvature(mesh.mesh.view(), {}, {}, [](double) { return false; });
  EXPECT_TRUE(found.points.empty());
}

TEST(MeshCurvature, WhatIsWrongIsSaid)
{
  const test::Mesh mesh = test::square(2);
  const auto message = [&](std::span<const glm::vec3> normals, const CurvatureOptions& options)
  {
    try
    {
      estimateCurvature(mesh.view(), normals, options);
    }
    catch (const std::invalid_argument& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  const std::vector<glm::vec3> few(2, glm::vec3(0.0f, 0.0f, 1.0f));
  EXPECT_EQ(message(few, {}), "there are 2 normals; expected one for each of 9 points, or none");
  EXPECT_EQ(message({}, withRings(0, 2)), "the number of rings is 0; expected 1 to 10");
  EXPECT_EQ(message({}, withRings(11, 2)), "the number of rings is 11; expected 1 to 10");
  EXPECT_EQ(message({}, withRings(2, 4)), "the degree is 4; expected 2 or 3");
  CurvatureOptions derivatives = withRings(2, 2);
  derivatives.derivatives = true;
  EXPECT_EQ(message({}, derivatives),
    "derivatives of curvature are asked for; expected the estimator Jet of degree 3");
}
