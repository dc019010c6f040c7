// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Hash.h"
#include "Curves/Contours/MeshContours.h"
#include "SampledMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

using namespace ink::test;

constexpr ink::ContourArrays allArrays{ true, true, true, true };

/// Of a unit sphere about the origin.
std::vector<glm::vec3> radialNormals(const Mesh& mesh)
{
  return { mesh.points.begin(), mesh.points.end() };
}

/// The largest distance from the circle along which a view cone from `eye` touches the unit sphere.
double distanceFromCircle(const ink::Contours& contours, const ink::Eye& eye)
{
  // Hertzmann and Zorin 2000: n.(e - p) = 0 with n = p gives p.e = 1.
  const glm::dvec3 axis = glm::normalize(eye.parallel ? -eye.direction : eye.position);
  const double height = eye.parallel ? 0.0 : 1.0 / glm::length(eye.position);
  const double radius = std::sqrt(1.0 - height * height);
  double largest = 0.0;
  for (const glm::dvec3& p : contours.positions)
  {
    const double along = glm::dot(p, axis);
    largest = std::max(largest, std::hypot(along - height, glm::length(p - along * axis) - radius));
  }
  return largest;
}

/// Unit normals of a torus about the z axis.
std::vector<glm::vec3> tubeNormals(const Mesh& mesh, double radius)
{
  std::vector<glm::vec3> normals;
  for (const glm::dvec3& p : mesh.points)
  {
    const glm::dvec3 middle = radius * glm::normalize(glm::dvec3(p.x, p.y, 0.0));
    normals.emplace_back(glm::normalize(p - middle));
  }
  return normals;
}

/// A cube about the origin with four points for each of its sides, and normals to match.
Mesh splitCube(std::vector<glm::vec3>& normals)
{
  Mesh mesh;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double side : { -1.0, 1.0 })
    {
      mesh.addPatch(1, 1,
        [=](double u, double v)
        {
          glm::dvec3 p(0.0);
          p[axis] = side;
          p[(axis + 1) % 3] = side * (2.0 * u - 1.0); // so that it faces outwards
          p[(axis + 2) % 3] = 2.0 * v - 1.0;
          return p;
        });
      glm::vec3 normal(0.0f);
      normal[axis] = static_cast<float>(side);
      normals.insert(normals.end(), 4, normal);
    }
  }
  return mesh;
}

double random(std::uint64_t id)
{
  return 2.0 * ink::unitDouble(ink::hash(17, id)) - 1.0;
}

glm::dvec3 randomPoint(std::uint64_t id)
{
  return { random(3 * id), random(3 * id + 1), random(3 * id + 2) };
}

/// Near and far, inside and outside of a body of size 1, and at infinity.
ink::Eye randomEye(std::uint64_t id)
{
  const glm::dvec3 point = randomPoint(id);
  return id % 4 == 3 ? ink::Eye::along(point) : ink::Eye::at(std::pow(10.0, double(id % 4)) * point);
}

bool areEqual(const ink::Contours& a, const ink::Contours& b)
{
  return a.chains.offsets == b.chains.offsets && a.chains.closed == b.chains.closed && a.kinds == b.kinds &&
    a.positions == b.positions && a.normals == b.normals && a.radialCurvature == b.radialCurvature &&
    a.arcLength == b.arcLength && a.elements == b.elements;
}

std::size_t closedChains(const ink::Contours& contours)
{
  return static_cast<std::size_t>(
    std::count(contours.chains.closed.begin(), contours.chains.closed.end(), 1));
}

/// No point is repeated right after itself, and lengths, closed and open, are what the points say.
void expectValid(const ink::Contours& contours)
{
  ASSERT_EQ(contours.kinds.size(), contours.chains.size());
  ASSERT_EQ(contours.positions.size(), contours.chains.pointCount());
  for (std::size_t chain = 0; chain < contours.chains.size(); ++chain)
  {
    const std::size_t begin = contours.chains.offsets[chain];
    const std::size_t end = contours.chains.offsets[chain + 1];
    ASSERT_GE(end, begin + 2);
    for (std::size_t i = begin; i < end; ++i)
    {
      if (i + 1 < end || contours.chains.closed[chain])
      {
        EXPECT_NE(contours.positions[i], contours.positions[i + 1 < end ? i + 1 : begin]) << i;
      }
    }
  }
}

} // namespace

TEST(MeshContours, OfASphereIsACircle)
{
  const std::vector<ink::Eye> eyes = { ink::Eye::at({ 1.3, 2.1, 3.7 }), ink::Eye::at({ -20, 5, 3 }),
    ink::Eye::along({ 0.3, -0.5, 0.2 }) };
  for (const ink::Eye& eye : eyes)
  {
    double before = 0.0;
    for (const int rows : { 20, 40, 80 })
    {
      const Mesh mesh = sphere(2 * rows, rows);
      const ink::MeshContours finder(mesh.view(), radialNormals(mesh));
      const ink::Contours contours = finder.find(eye, allArrays);
      ASSERT_EQ(contours.chains.size(), 1u) << rows;
      EXPECT_TRUE(contours.chains.closed[0]);
      const double error = distanceFromCircle(contours, eye);
      if (before > 0.0)
      {
        EXPECT_LT(error, 0.3 * before) << rows; // second order
      }
      before = error;
      for (std::size_t i = 0; i < contours.positions.size(); ++i)
      {
        EXPECT_NEAR(glm::dot(glm::dvec3(contours.normals[i]), contours.positions[i]), 1.0, 0.02);
        EXPECT_NEAR(contours.radialCurvature[i], 1.0, 0.05);
      }
    }
    EXPECT_LT(before, 1e-3);
  }
}

TEST(MeshContours, OfATorusAreTwoClosedCurvesOutsideAndOneInside)
{
  // Analytically: with n = (cos u cos v, sin u cos v, sin v), n.(e - p) = 0 is A(u) cos v + e_z sin v = r
  // with A(u) = e.(cos u, sin u, 0) - R, which has two solutions v where A^2 + e_z^2 > r^2.
  const double radius = 1.0;
  const double tube = 0.4;
  const Mesh mesh = torus(radius, tube, 96, 64);
  const ink::MeshContours finder(mesh.view(), tubeNormals(mesh, radius));
  int inside = 0;
  for (std::uint64_t id = 0; id < 1000; ++id)
  {
    const glm::dvec3 point = (id % 2 == 0 ? 1.5 : 20.0) * randomPoint(id);
    const double distance = std::hypot(std::hypot(point.x, point.y) - radius, point.z);
    // Not where two curves nearly touch.
    if (std::abs(std::abs(point.z) - tube) < 0.1 * tube || std::abs(distance - tube) < 0.1 * tube)
    {
      continue;
    }
    const ink::Contours contours = finder.find(ink::Eye::at(point));
    expectValid(contours);
    EXPECT_EQ(contours.chains.size(), distance < tube ? 1u : 2u) << id;
    EXPECT_EQ(closedChains(contours), contours.chains.size()) << id;
    inside += distance < tube;
  }
  EXPECT_GT(inside, 10);
  // On the axis, from which the curves are circles, and at infinity there.
  for (const ink::Eye& eye :
    { ink::Eye::at({ 0, 0, 3 }), ink::Eye::at({ 0, 0, 0 }), ink::Eye::along({ 0, 0, 1 }) })
  {
    EXPECT_EQ(closedChains(finder.find(eye)), 2u);
  }
}

TEST(MeshContours, FindsByTheHierarchyWhatAnExhaustiveSearchFinds)
{
  const Mesh mesh = torus(0.7, 0.3, 30, 20);
  const std::vector<glm::vec3> smooth = tubeNormals(mesh, 0.7);
  std::vector<glm::vec3> noisy = smooth;
  for (std::size_t i = 0; i < noisy.size(); ++i)
  {
    noisy[i] += glm::vec3(0.5 * randomPoint(i));
  }
  // Faces with points of their own, some with other normals than their neighbors: sharp edges.
  Mesh soup;
  std::vector<glm::vec3> ofSoup;
  for (const ink::Triangle& triangle : mesh.triangles)
  {
    const auto first = static_cast<std::uint32_t>(soup.points.size());
    for (const std::uint32_t point : triangle)
    {
      soup.points.push_back(mesh.points[point]);
      ofSoup.push_back(first % 7 == 0 ? noisy[point] : smooth[point]);
    }
    soup.triangles.push_back({ first, first + 1, first + 2 });
  }
  struct Case
  {
    const Mesh& mesh;
    const std::vector<glm::vec3>& normals;
    bool faceted;
  };
  std::size_t found = 0;
  for (const Case& tried : { Case{ mesh, smooth, false }, Case{ mesh, noisy, false },
         Case{ soup, ofSoup, false }, Case{ mesh, smooth, true } })
  {
    ink::MeshContourOptions options;
    options.faceted = tried.faceted;
    const ink::MeshContours finder(tried.mesh.view(), tried.normals, options);
    for (std::uint64_t id = 0; id < 1000; ++id)
    {
      const ink::Eye eye = randomEye(id);
      const ink::Contours contours = finder.find(eye, allArrays);
      ASSERT_TRUE(areEqual(contours, finder.find(eye, allArrays, ink::SilhouetteSearch::Exhaustive))) << id;
      expectValid(contours);
      found += contours.chains.size();
    }
  }
  EXPECT_GT(found, 6000u);
}

TEST(MeshContours, FindsByTheHierarchyFromPointsOfTheSurface)
{
  // There v of some points is 0 or nearly so.
  const Mesh mesh = sphere(32, 16);
  const ink::MeshContours finder(mesh.view(), radialNormals(mesh));
  for (std::size_t i = 0; i < mesh.points.size(); i += 2)
  {
    for (const double away : { 1.0, 1.0 + 1e-9, 1.001, 0.999 })
    {
      const ink::Eye eye = ink::Eye::at(away * mesh.points[i]);
      const ink::Contours contours = finder.find(eye, allArrays);
      expectValid(contours);
      ASSERT_TRUE(areEqual(contours, finder.find(eye, allArrays, ink::SilhouetteSearch::Exhaustive))) << i;
    }
  }
}

TEST(MeshContours, AreTheSameForAnyNumberOfThreads)
{
  const Mesh mesh = torus(1.0, 0.4, 300, 200);
  const std::vector<glm::vec3> normals = tubeNormals(mesh, 1.0);
  ink::MeshContourOptions options;
  for (const bool faceted : { false, true })
  {
    options = { true, faceted, true, 1.0, true, true };
    const auto run = [&]
    {
      const ink::MeshContours finder(mesh.view(), normals, options);
      return std::pair(finder.find(ink::Eye::at({ 3, 1, 2 }), allArrays),
        finder.find(ink::Eye::at({ 3, 1, 2 }), allArrays, ink::SilhouetteSearch::Exhaustive));
    };
    const auto one = onThreads(1, run);
    const auto two = onThreads(2, run);
    EXPECT_TRUE(areEqual(one.first, two.first));
    EXPECT_TRUE(areEqual(one.second, two.second));
    EXPECT_GT(one.first.chains.size(), 2u);
  }
}

TEST(MeshContours, OfAnEyeInsideASphereAreNone)
{
  const Mesh mesh = sphere(40, 20);
  const ink::MeshContours finder(mesh.view(), radialNormals(mesh));
  EXPECT_EQ(finder.find(ink::Eye::at({ 0.2, -0.1, 0.3 })).chains.size(), 0u);
}

/// With n.v = 0 exactly at points, the contour runs along them once.
TEST(MeshContours, RunThroughPointsWhereTheNormalIsAtRightAngles)
{
  Mesh mesh = sphere(40, 20);
  for (glm::dvec3& point : mesh.points)
  {
    point.z = std::abs(point.z) < 1e-9 ? 0.0 : point.z;
  }
  const ink::MeshContours finder(mesh.view(), radialNormals(mesh));
  for (const double direction : { -1.0, 1.0 })
  {
    const ink::Contours contours = finder.find(ink::Eye::along({ 0, 0, direction }), allArrays);
    expectValid(contours);
    ASSERT_EQ(contours.chains.size(), 1u);
    EXPECT_TRUE(contours.chains.closed[0]);
    ASSERT_EQ(contours.positions.size(), 40u);
    for (const glm::dvec3& p : contours.positions)
    {
      EXPECT_EQ(p.z, 0.0);
    }
    EXPECT_NEAR(contours.arcLength.back(), 39.0 / 40.0 * 2.0 * std::numbers::pi, 0.01);
  }
}

TEST(MeshContours, OfACubeWithNormalsOfItsSidesAreItsEdges)
{
  std::vector<glm::vec3> normals;
  const Mesh mesh = splitCube(normals);
  const ink::MeshContours interpolated(mesh.view(), normals);
  ink::MeshContourOptions options;
  options.faceted = true;
  const ink::MeshContours faceted(mesh.view(), {}, options);
  struct View
  {
    ink::Eye eye;
    std::size_t edges;
  };
  for (const auto& [eye, edges] : { View{ ink::Eye::at({ 4, 5, 6 }), 6 },
         View{ ink::Eye::at({ 4, 5, 0 }), 6 }, View{ ink::Eye::at({ 0.3, 0.2, 9 }), 4 },
         View{ ink::Eye::along({ 1, -2, 3 }), 6 }, View{ ink::Eye::along({ 0, 0, -1 }), 4 } })
  {
    const ink::Contours contours = interpolated.find(eye, allArrays);
    ASSERT_EQ(contours.chains.size(), 1u);
    EXPECT_TRUE(contours.chains.closed[0]);
    EXPECT_EQ(contours.positions.size(), edges);
    EXPECT_EQ(contours.arcLength.back(), 2.0 * double(edges - 1));
    for (const float curvature : contours.radialCurvature)
    {
      EXPECT_GT(curvature, 0.0f);
    }
    const ink::Contours same = faceted.find(eye, allArrays);
    EXPECT_EQ(same.positions.size(), edges);
    EXPECT_EQ(same.chains.closed, contours.chains.closed);
    for (const glm::vec3& normal : same.normals)
    {
      EXPECT_NEAR(glm::length(normal), 1.0f, 1e-6f);
    }
  }
  // From inside there is nothing to see of its outside.
  EXPECT_EQ(interpolated.find(ink::Eye::at({ 0.1, 0.2, 0.3 })).chains.size(), 0u);
  EXPECT_EQ(faceted.find(ink::Eye::at({ 0.1, 0.2, 0.3 })).chains.size(), 0u);
}

/// The two lines along a can and the halves of its rims, which are sharp edges, are one closed chain.
TEST(MeshContours, FollowSharpEdgesBetweenSmoothSides)
{
  Mesh mesh;
  std::vector<glm::vec3> normals;
  const auto around = [](double u) { return u == 1.0 ? 0.0 : 2.0 * std::numbers::pi * u; };
  mesh.addPatch(50, 10,
    [&](double u, double v) { return glm::dvec3(std::cos(around(u)), std::sin(around(u)), 2.0 * v - 1.0); });
  for (const glm::dvec3& p : mesh.points)
  {
    normals.emplace_back(p.x, p.y, 0.0);
  }
  for (const double side : { -1.0, 1.0 })
  {
    mesh.addPatch(50, 5,
      [&](double u, double v) { return glm::dvec3(v * std::cos(around(u)), v * std::sin(around(u)), side); });
    normals.resize(mesh.points.size(), glm::vec3(0, 0, side));
  }
  const ink::MeshContours finder(mesh.view(), normals);
  for (std::uint64_t id = 0; id < 100; ++id)
  {
    const glm::dvec3 direction = randomPoint(id);
    const ink::Contours contours = finder.find(ink::Eye::along(direction), allArrays);
    expectValid(contours);
    ASSERT_EQ(contours.chains.size(), 1u) << id;
    EXPECT_TRUE(contours.chains.closed[0]);
    // Half of each rim, and two lines of length 2.
    double length =
      contours.arcLength.back() + glm::distance(contours.positions.front(), contours.positions.back());
    EXPECT_NEAR(length, 2.0 * std::numbers::pi + 4.0, 0.05) << id;
  }
}

TEST(MeshContours, EndAtBorders)
{
  // Half a sphere, seen from the side.
  Mesh mesh = sphere(40, 20);
  std::erase_if(mesh.triangles,
    [&](const ink::Triangle& t)
    { return mesh.points[t[0]].z + mesh.points[t[1]].z + mesh.points[t[2]].z > 0.0; });
  ink::MeshContourOptions options;
  options.borders = true;
  const ink::MeshContours finder(mesh.view(), radialNormals(mesh), options);
  const ink::Contours contours = finder.find(ink::Eye::along({ 1.0, 0.3, 0.1 }), allArrays);
  expectValid(contours);
  ASSERT_EQ(contours.chains.size(), 2u);
  EXPECT_EQ(contours.kinds, (std::vector{ ink::ContourKind::Silhouette, ink::ContourKind::Border }));
  EXPECT_EQ(contours.chains.closed, (std::vector<std::uint8_t>{ 0, 1 }));
  EXPECT_NEAR(contours.positions.front().z, 0.0, 1e-12);
  EXPECT_NEAR(contours.positions[contours.chains.offsets[1] - 1].z, 0.0, 1e-12);
  EXPECT_EQ(contours.chains.segmentCount(1), 40u);
  EXPECT_EQ(contours.radialCurvature.back(), 0.0f);
}

TEST(MeshContours, FindsCreasesByTheirAngle)
{
  std::vector<glm::vec3> normals;
  const Mesh mesh = splitCube(normals);
  ink::MeshContourOptions options;
  options.silhouettes = false;
  options.creases = true;
  for (const auto& [angle, edges] : { std::pair(0.0, 12u), std::pair(89.9, 12u), std::pair(90.1, 0u) })
  {
    options.creaseAngle = angle;
    const ink::Contours contours =
      ink::MeshContours(mesh.view(), {}, options).find(ink::Eye::at({ 4, 5, 6 }));
    EXPECT_EQ(contours.chains.size(), edges) << angle; // three meet at each corner
    EXPECT_EQ(contours.positions.size(), 2 * edges);
  }
}

TEST(MeshContours, LeavesOutCreasesThatAreSpecks)
{
  // A square of 20 x 20 steps with a ridge across and another one of two steps.
  Mesh mesh;
  constexpr int side = 21;
  for (int j = 0; j < side; ++j)
  {
    for (int i = 0; i < side; ++i)
    {
      mesh.points.push_back(
        { double(i), double(j), i == 15 || (i == 5 && std::abs(j - 5) <= 1) ? 2.0 : 0.0 });
    }
  }
  for (std::uint32_t j = 0; j + 1 < side; ++j)
  {
    for (std::uint32_t i = 0; i + 1 < side; ++i)
    {
      const std::uint32_t a = i + side * j;
      mesh.triangles.push_back({ a, a + 1, a + side });
      mesh.triangles.push_back({ a + 1, a + side + 1, a + side });
    }
  }
  ink::MeshContourOptions options;
  options.silhouettes = false;
  options.creases = true;
  options.creaseAngle = 100.0;
  const auto bounds = [&](double shortest)
  {
    options.shortestCrease = shortest;
    const ink::Contours contours =
      ink::MeshContours(mesh.view(), {}, options).find(ink::Eye::at({ 4, 5, 6 }));
    double left = 1e9;
    double right = -1e9;
    for (const glm::dvec3& p : contours.positions)
    {
      left = std::min(left, p.x);
      right = std::max(right, p.x);
    }
    return std::pair(left, right);
  };
  EXPECT_LT(bounds(0.0).first, 5.5) << "the short one";
  EXPECT_LT(bounds(0.05).first, 5.5) << "2 of a diagonal of 28.4";
  EXPECT_GT(bounds(0.3).first, 13.5);
  EXPECT_GT(bounds(1.0).second, 14.5) << "the other one ends at borders";
  for (const double wrong : { -0.1, 1.1, std::nan("") })
  {
    options.shortestCrease = wrong;
    EXPECT_THROW(ink::MeshContours(mesh.view(), {}, options), std::invalid_argument);
  }
}

TEST(MeshContours, AreDrawnOnceWhereACreaseIsASilhouette)
{
  std::vector<glm::vec3> normals;
  const Mesh mesh = splitCube(normals);
  for (const bool faceted : { false, true })
  {
    ink::MeshContourOptions options;
    options.faceted = faceted;
    options.creases = true;
    const auto count = [&](ink::ContourKind kind)
    {
      const ink::Contours contours =
        ink::MeshContours(mesh.view(), normals, options).find(ink::Eye::at({ 4, 5, 6 }));
      return std::count(contours.kinds.begin(), contours.kinds.end(), kind);
    };
    EXPECT_EQ(count(ink::ContourKind::Silhouette), 1) << "around the cube";
    options.once = true;
    EXPECT_EQ(count(ink::ContourKind::Silhouette), 0);
    EXPECT_EQ(count(ink::ContourKind::Crease), 12);
    options.creaseAngle = 100.0;
    EXPECT_EQ(count(ink::ContourKind::Silhouette), 1) << "no creases, no gaps";
  }
}

TEST(MeshContours, DoNotDependOnHowFacesRun)
{
  Mesh mesh = torus(1.0, 0.4, 40, 20);
  ink::MeshContourOptions options{ true, true, true, 25.0, true, true };
  const ink::MeshContours straight(mesh.view(), {}, options);
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3)
  {
    std::swap(mesh.triangles[i][1], mesh.triangles[i][2]);
  }
  const ink::MeshContours mixed(mesh.view(), {}, options);
  for (std::uint64_t id = 0; id < 50; ++id)
  {
    const ink::Contours a = straight.find(randomEye(id));
    const ink::Contours b = mixed.find(randomEye(id));
    EXPECT_EQ(a.positions.size(), b.positions.size());
    EXPECT_EQ(closedChains(a), closedChains(b));
  }
}

TEST(MeshContours, TakesEdgesOfManyFaces)
{
  // Three half planes on the y axis.
  Mesh mesh;
  mesh.points = { { 0, 0, 0 }, { 0, 1, 0 }, { -1, 0.5, 0 }, { 1, 0.5, 0 }, { 0, 0.5, 1 } };
  mesh.triangles = { { 0, 1, 2 }, { 1, 0, 3 }, { 0, 1, 4 } };
  ink::MeshContourOptions options{ true, true, true, 30.0, true, true };
  const ink::Contours contours =
    ink::MeshContours(mesh.view(), {}, options).find(ink::Eye::at({ 3, 4, 5 }), allArrays);
  expectValid(contours);
  ASSERT_EQ(contours.kinds.back(), ink::ContourKind::NonManifold);
  EXPECT_EQ(std::count(contours.kinds.begin(), contours.kinds.end(), ink::ContourKind::Border), 3);
  EXPECT_EQ(std::count(contours.kinds.begin(), contours.kinds.end(), ink::ContourKind::Crease), 0);
  EXPECT_EQ(contours.arcLength.back(), 1.0);
}

/// Points that are not finite or belong to no face, faces without area, and normals that are not there.
TEST(MeshContours, AreNotDisturbedByWhatIsDegenerate)
{
  Mesh mesh = sphere(40, 20);
  std::vector<glm::vec3> normals = radialNormals(mesh);
  const ink::Eye eye = ink::Eye::at({ 2, 3, 4 });
  const ink::Contours clean = ink::MeshContours(mesh.view(), normals).find(eye, allArrays);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto first = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.insert(mesh.points.end(),
    { { nan, 0, 0 }, { 0, std::numeric_limits<double>::infinity(), 0 }, { 0.1, 0.2, 0.3 } });
  normals.insert(normals.end(), 3, glm::vec3(0, 0, 1));
  mesh.triangles.insert(mesh.triangles.begin(), { 3, first, 5 });
  mesh.triangles.push_back({ first + 1, 60, 70 });
  mesh.triangles.push_back({ 100, 100, 101 });
  ink::Contours contours = ink::MeshContours(mesh.view(), normals).find(eye, allArrays);
  for (std::int64_t& element : contours.elements)
  {
    --element; // one face has been put in front
  }
  EXPECT_TRUE(areEqual(clean, contours));

  for (std::size_t i = 0; i < normals.size(); i += 11)
  {
    normals[i] = i % 2 == 0 ? glm::vec3(0.0f) : glm::vec3(static_cast<float>(nan), 0, 0);
  }
  contours = ink::MeshContours(mesh.view(), normals).find(eye, allArrays);
  EXPECT_EQ(contours.chains.size(), 1u);
  EXPECT_TRUE(contours.chains.closed[0]);
  EXPECT_LT(distanceFromCircle(contours, eye), 0.02);
}

TEST(MeshContours, OfNothingAreNone)
{
  const Mesh empty;
  EXPECT_EQ(ink::MeshContours(empty.view(), {}).find(ink::Eye::at({ 1, 2, 3 })).chains.size(), 0u);
  Mesh points;
  points.points = { { 0, 0, 0 }, { 1, 0, 0 } };
  const std::vector<glm::vec3> normals(2, glm::vec3(0, 0, 1));
  const ink::MeshContourOptions all{ true, false, true, 30.0, true, true };
  EXPECT_EQ(ink::MeshContours(points.view(), normals, all).find(ink::Eye::at({ 1, 2, 3 })).chains.size(), 0u);
}

TEST(MeshContours, KeepTheirShapeFarFromTheOrigin)
{
  Mesh mesh = sphere(80, 40);
  const std::vector<glm::vec3> normals = radialNormals(mesh);
  const glm::dvec3 far(1e7, -2e7, 3e7);
  for (glm::dvec3& point : mesh.points)
  {
    point += far;
  }
  const ink::Eye near = ink::Eye::at({ 2, 3, 4 });
  const ink::MeshContours finder(mesh.view(), normals);
  ink::Contours contours = finder.find(ink::Eye::at(near.position + far));
  ASSERT_EQ(contours.chains.size(), 1u);
  EXPECT_TRUE(contours.chains.closed[0]);
  for (glm::dvec3& point : contours.positions)
  {
    point -= far;
  }
  EXPECT_LT(distanceFromCircle(contours, near), 0.002);
}

TEST(MeshContours, NameTheFaceOfEachSegment)
{
  const Mesh mesh = torus(1.0, 0.4, 40, 20);
  const ink::MeshContours finder(mesh.view(), tubeNormals(mesh, 1.0));
  const ink::Contours contours = finder.find(ink::Eye::at({ 3, 1, 2 }), allArrays);
  for (std::size_t chain = 0; chain < contours.chains.size(); ++chain)
  {
    const std::size_t begin = contours.chains.offsets[chain];
    const std::size_t end = contours.chains.offsets[chain + 1];
    for (std::size_t i = begin; i < end; ++i)
    {
      const glm::dvec3 middle =
        0.5 * (contours.positions[i] + contours.positions[i + 1 < end ? i + 1 : begin]);
      const auto& [a, b, c] = mesh.triangles[static_cast<std::size_t>(contours.elements[i])];
      const glm::dvec3 corners[3] = { mesh.points[a], mesh.points[b], mesh.points[c] };
      const glm::dvec3 area = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
      double shares = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        shares += glm::length(glm::cross(corners[k] - middle, corners[(k + 1) % 3] - middle));
      }
      EXPECT_NEAR(shares, glm::length(area), 1e-9) << i; // inside
    }
  }
}

/// Against Euler's theorem for the torus, whose principal curvatures are 1 / r and cos v / (R + r cos v).
TEST(MeshContours, KnowTheirRadialCurvature)
{
  const double radius = 1.0;
  const double tube = 0.4;
  const Mesh mesh = torus(radius, tube, 400, 200);
  const ink::MeshContours finder(mesh.view(), tubeNormals(mesh, radius));
  const glm::dvec3 eye(2.0, 0.7, 1.2);
  const ink::Contours contours = finder.find(ink::Eye::at(eye), allArrays);
  int negative = 0;
  for (std::size_t i = 0; i < contours.positions.size(); ++i)
  {
    const glm::dvec3 p = contours.positions[i];
    const glm::dvec3 out = glm::normalize(glm::dvec3(p.x, p.y, 0.0));
    const glm::dvec3 n = glm::normalize(p - radius * out);
    const glm::dvec3 v = eye - p;
    const glm::dvec3 w = glm::normalize(v - n * glm::dot(n, v));
    const double along = glm::dot(w, glm::dvec3(-out.y, out.x, 0.0));
    const double cosine = glm::dot(n, out);
    const double k = along * along * cosine / (radius + tube * cosine) + (1.0 - along * along) / tube;
    EXPECT_NEAR(contours.radialCurvature[i], k, 0.05 / tube) << i;
    negative += k < 0.0;
  }
  EXPECT_GT(negative, 10); // in the hole
}

TEST(MeshContours, OfNormalsThatPointInwardsHaveTheSameRadialCurvature)
{
  const Mesh mesh = torus(1.0, 0.4, 60, 30);
  std::vector<glm::vec3> normals = tubeNormals(mesh, 1.0);
  const ink::Eye eye = ink::Eye::at({ 2.0, 0.7, 1.2 });
  const ink::Contours outwards = ink::MeshContours(mesh.view(), normals).find(eye, allArrays);
  for (glm::vec3& normal : normals)
  {
    normal = -normal;
  }
  const ink::Contours inwards = ink::MeshContours(mesh.view(), normals).find(eye, allArrays);
  const auto sorted = [](std::vector<float> values)
  {
    std::sort(values.begin(), values.end());
    return values;
  };
  const std::vector<float> expected = sorted(outwards.radialCurvature);
  const std::vector<float> found = sorted(inwards.radialCurvature);
  ASSERT_EQ(found.size(), expected.size());
  ASSERT_LT(expected.front(), 0.0f);
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    EXPECT_NEAR(found[i], expected[i], 1e-4) << i;
  }
}

TEST(MeshContours, SayWhatIsWrong)
{
  const Mesh mesh = square(2);
  const auto messageOf = [](const auto& run)
  {
    try
    {
      run();
    }
    catch (const std::invalid_argument& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  const std::vector<glm::vec3> normals(9, glm::vec3(0, 0, 1));
  const std::vector<glm::vec3> few(3, glm::vec3(0, 0, 1));
  EXPECT_EQ(messageOf([&] { ink::MeshContours(mesh.view(), {}); }),
    "the mesh has no normals, expected one per point for interpolated silhouettes; faceted ones need none");
  EXPECT_EQ(messageOf([&] { ink::MeshContours(mesh.view(), few); }),
    "there are 3 normals for 9 points, expected one per point");
  EXPECT_NE(messageOf(
              [&] {
                ink::MeshContours(mesh.view(), normals, { true, false, true, -1.0, false, false });
              })
              .find("expected from 0 to 180"),
    std::string::npos);
  const ink::MeshContours finder(mesh.view(), normals);
  EXPECT_EQ(messageOf(
              [&] {
                finder.find(ink::Eye::at({ 0, 1.0 / 0.0, 0 }));
              }),
    "the eye's position is not finite");
  EXPECT_EQ(messageOf(
              [&] {
                finder.find(ink::Eye::along({ 0, 0, 0 }));
              }),
    "the eye's direction is zero, expected a vector into the scene");
  EXPECT_EQ(messageOf([&] { finder.find(ink::Eye::at({ 0, 0, 1 })); }), "");
}
