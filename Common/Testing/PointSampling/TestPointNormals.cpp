// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Hash.h"
#include "Core/KdTree.h"
#include "PointSampling/PointCloud/PointNormals.h"
#include "PointSampling/PoissonDisk.h"
#include "PointSampling/WhiteNoise.h"
#include "SampledMeshes.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace
{

using namespace ink::test;

std::vector<glm::vec3> randomPoints(std::size_t count)
{
  std::vector<glm::vec3> points;
  for (std::size_t i = 0; i < count; ++i)
  {
    points.emplace_back(
      ink::unitFloat(ink::hash(1, i)), ink::unitFloat(ink::hash(2, i)), ink::unitFloat(ink::hash(3, i)));
  }
  return points;
}

std::vector<glm::vec3> samplesOf(const Mesh& mesh, double radius)
{
  const auto points = positionsOf(mesh.view(),
    ink::samplePoissonDisk(mesh.view(), ink::cumulateArea(mesh.view()), radius, ink::defaultCoverageSlack, 1)
      .samples);
  return { points.begin(), points.end() };
}

/// The angle between unit vectors, in degrees.
float angleBetween(const glm::vec3& a, const glm::vec3& b)
{
  return glm::degrees(2.0f * std::asin(std::min(0.5f * glm::distance(a, b), 1.0f)));
}

} // namespace

TEST(KdTree, AreThoseOfASearchThroughAll)
{
  auto points = randomPoints(700);
  points.insert(points.end(), points.begin(), points.begin() + 50); // copies
  const ink::KdTree tree(points);
  for (const glm::vec3& query : randomPoints(100))
  {
    std::vector<std::pair<float, std::uint32_t>> all;
    for (std::uint32_t i = 0; i < points.size(); ++i)
    {
      const glm::vec3 offset = points[i] - query;
      all.emplace_back(glm::dot(offset, offset), i);
    }
    std::sort(all.begin(), all.end());
    std::vector<std::uint32_t> found(20);
    tree.find(query, found);
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      EXPECT_EQ(found[i], all[i].second);
    }
  }
}

TEST(PointNormals, PointOutOfAClosedSurface)
{
  const auto ball = samplesOf(sphere(80, 40), 0.05);
  const auto ballNormals = ink::estimateNormals(ball);
  float worst = 0.0f;
  for (std::size_t i = 0; i < ball.size(); ++i)
  {
    worst = std::max(worst, angleBetween(ballNormals[i], glm::normalize(ball[i])));
  }
  EXPECT_LT(worst, 3.0f); // measured: 1.6
  worst = 0.0f;
  const auto ring = samplesOf(torus(1.0, 0.4, 120, 60), 0.04);
  const auto ringNormals = ink::estimateNormals(ring);
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    const glm::vec3 axis = glm::normalize(glm::vec3(ring[i].x, ring[i].y, 0.0f));
    worst = std::max(worst, angleBetween(ringNormals[i], glm::normalize(ring[i] - axis)));
  }
  EXPECT_LT(worst, 6.0f); // measured: 3.5
}

TEST(PointNormals, OfTwoBallsPointOutOfEach)
{
  auto points = samplesOf(sphere(80, 40), 0.08);
  const std::size_t one = points.size();
  for (std::size_t i = 0; i < one; ++i)
  {
    points.push_back(points[i] + glm::vec3(3, 0, 0));
  }
  const auto normals = ink::estimateNormals(points);
  float worst = 0.0f;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    worst =
      std::max(worst, angleBetween(normals[i], glm::normalize(points[i] - glm::vec3(i < one ? 0 : 3, 0, 0))));
  }
  EXPECT_LT(worst, 5.0f); // measured: 2.7
}

TEST(PointNormals, AreTheSameOnAnyNumberOfThreads)
{
  const auto points = samplesOf(torus(1.0, 0.4, 60, 30), 0.06);
  const auto run = [&] { return ink::estimateNormals(points); };
  EXPECT_EQ(onThreads(1, run), onThreads(2, run));
}

TEST(PointNormals, OfExtremes)
{
  EXPECT_TRUE(ink::estimateNormals({}).empty());
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::vector<glm::vec3> points{ { 0, 0, 0 }, { nan, 0, 0 } };
  auto normals = ink::estimateNormals(points);
  EXPECT_EQ(normals[0], glm::vec3(0, 0, 1));
  EXPECT_EQ(normals[1], glm::vec3(0));
  std::vector<glm::vec3> line;
  for (int i = 0; i < 30; ++i)
  {
    line.emplace_back(i, 2 * i, 3 * i);
  }
  for (const glm::vec3& normal : ink::estimateNormals(line))
  {
    EXPECT_NEAR(glm::length(normal), 1.0f, 1e-5f);
  }
  for (const glm::vec3& normal : ink::estimateNormals(std::vector<glm::vec3>(40, glm::vec3(5.0f))))
  {
    EXPECT_EQ(normal, glm::vec3(0, 0, 1));
  }
}

TEST(PointNormals, SurviveNoiseUnevenDensityAndCopies)
{
  const Mesh mesh = torus(1.0, 0.4, 240, 120);
  const auto exact =
    positionsOf(mesh.view(), ink::sampleWhiteNoise(mesh.view(), ink::cumulateArea(mesh.view()), 40000, 5));
  std::vector<glm::vec3> points;
  for (std::size_t i = 0; i < exact.size(); ++i)
  {
    const glm::vec3 point(exact[i]);
    // Twenty times as many on one side as on the other, one in a hundred of them thirty times.
    if (ink::unitFloat(ink::hash(7, i)) < std::pow(0.05f, 0.5f + point.x / 2.8f))
    {
      const glm::vec3 noise(
        ink::unitFloat(ink::hash(8, i)), ink::unitFloat(ink::hash(9, i)), ink::unitFloat(ink::hash(10, i)));
      points.insert(points.end(), i % 100 == 0 ? 30 : 1, point + 0.004f * (noise - 0.5f));
    }
  }
  const auto normals = ink::estimateNormals(points, 32);
  float worst = 0.0f;
  double squares = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const glm::vec3 axis = glm::normalize(glm::vec3(points[i].x, points[i].y, 0.0f));
    const float angle = angleBetween(normals[i], glm::normalize(points[i] - axis));
    worst = std::max(worst, angle);
    squares += angle * angle;
  }
  EXPECT_LT(worst, 16.0f);                                                 // measured: 8.6
  EXPECT_LT(std::sqrt(squares / static_cast<double>(points.size())), 2.5); // measured: 1.4
}

TEST(PointNormals, PointToTheViewer)
{
  const auto ball = samplesOf(sphere(80, 40), 0.06);
  const glm::vec3 viewpoint(3.0f, 0.0f, 0.0f);
  const auto normals = ink::estimateNormals(ball, 16, {}, viewpoint);
  float worst = 0.0f;
  for (std::size_t i = 0; i < ball.size(); ++i)
  {
    EXPECT_GE(glm::dot(normals[i], viewpoint - ball[i]), 0.0f);
    const glm::vec3 out = glm::normalize(ball[i]);
    worst = std::max(worst, std::min(angleBetween(normals[i], out), angleBetween(normals[i], -out)));
  }
  EXPECT_LT(worst, 3.0f); // measured: 1.7
}
