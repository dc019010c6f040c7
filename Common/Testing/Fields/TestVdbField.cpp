// SPDX-License-Identifier: BSD-3-Clause
#include "AnalyticFields.h"
#include "VdbVolumes.h"

#include "Fields/Vdb/VdbField.h"
#include "IsoSurface/ProjectSamples.h"

#include <openvdb/tools/LevelSetSphere.h>

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <random>
#include <span>
#include <vector>

namespace
{

using namespace ink::testing;
using ink::GridGeometry;
using ink::VdbField;
using ink::VdbGrid;

/// But for the rounding of a point's index, which each grid counts from its own first sample.
bool same(double a, double b)
{
  return std::abs(a - b) <= 1e-10 * (1e4 + std::abs(b)) || (std::isnan(a) && std::isnan(b));
}

template <class T>
void expectSameAsGridField(const Volume<T>& volume)
{
  const VdbGrid grid = ink::makeVdbGrid(volume.field(), {});
  // Of the whole volume only the background is inactive.
  const VdbField field(grid, VdbField::Inactive::Background);
  const auto dense = volume.field();
  std::mt19937 random(5);
  const glm::dvec3 size(volume.geometry.dimensions());
  const auto anywhere = [&](double length) { return (random() % 4096 / 4096.0 * 1.2 - 0.1) * length; };
  for (int n = 0; n < 300; ++n)
  {
    // Also on samples, at the border and outside.
    glm::dvec3 index(anywhere(size.x), anywhere(size.y), anywhere(size.z));
    index = n % 5 == 0 ? glm::floor(index) : index;
    const glm::dvec3 p = volume.geometry.toWorld(index);
    SCOPED_TRACE(
      "index " + std::to_string(index.x) + " " + std::to_string(index.y) + " " + std::to_string(index.z));
    EXPECT_TRUE(same(field.value(p), dense.value(p)));
    const glm::dvec3 g = field.gradient(p);
    const glm::dvec3 denseG = dense.gradient(p);
    const glm::dmat3 h = field.hessian(p);
    const glm::dmat3 denseH = dense.hessian(p);
    for (int a = 0; a < 3; ++a)
    {
      EXPECT_TRUE(same(g[a], denseG[a]));
      for (int b = 0; b < 3; ++b)
      {
        EXPECT_TRUE(same(h[a][b], denseH[a][b]));
      }
    }
  }
}

TEST(VdbField, AgreesWithGridField)
{
  const glm::dmat3 turned(glm::rotate(glm::dmat4(1.0), 0.7, glm::dvec3(1.0, 2.0, 3.0)));
  const GridGeometry geometry({ 19, 12, 15 }, { 10, -20, 30 }, { 0.3, 0.5, 1.5 }, turned, { 4, -5, 0 });
  std::mt19937 random(3);
  Volume<float> floats(geometry);
  Volume<double> doubles(geometry);
  for (std::size_t n = 0; n < floats.values.size(); ++n)
  {
    floats.values[n] = random() % 60 == 0 ? NAN : static_cast<float>(random() % 1000);
    doubles.values[n] = random() % 1000 * 1e-3;
  }
  expectSameAsGridField(floats);
  expectSameAsGridField(doubles);
}

TEST(VdbField, FollowsASphereInsideTheBand)
{
  const Sphere sphere{ { 1.0, -2.0, 3.0 }, 8.0 };
  constexpr double spacing = 0.25;
  const VdbField field(
    readBack<openvdb::DoubleGrid>(openvdb::tools::createLevelSetSphere<openvdb::DoubleGrid>(
      8.0f, { 1.0f, -2.0f, 3.0f }, static_cast<float>(spacing), 5.0f)));
  std::mt19937 random(1);
  const auto number = [&] { return random() % 2048 / 1024.0 - 1.0; };
  for (int n = 0; n < 200; ++n)
  {
    const glm::dvec3 out = glm::normalize(glm::dvec3(number(), number(), number() + 1e-3));
    const glm::dvec3 p = sphere.center + out * (sphere.radius + number() * spacing);
    // Second order in the spacing: h^2 / (8 R) and the like.
    EXPECT_NEAR(field.value(p), sphere.value(p), spacing * spacing / sphere.radius);
    EXPECT_LT(glm::distance(field.gradient(p), sphere.gradient(p)), 0.01);
    const glm::dmat3 difference = field.hessian(p) - sphere.hessian(p);
    for (int a = 0; a < 3; ++a)
    {
      EXPECT_LT(glm::length(difference[a]), 0.02);
    }
  }
}

TEST(VdbField, ProjectsSamplesAsADenseGridDoes)
{
  const VdbGrid grid = readBack<openvdb::FloatGrid>(
    openvdb::tools::createLevelSetSphere<openvdb::FloatGrid>(10.0f, { 0.5f, 1.0f, 2.0f }, 0.5f, 4.0f));
  const auto samples = sampleIsoSurface<double>(grid, 0.0);
  ASSERT_GT(samples.size(), 1000u);
  const auto projected = [&](const auto& field)
  {
    auto points = samples.coordinates;
    ink::projectSamples(field, grid.geometry(grid.activeBox()), 0.0, 3, std::span<double>(points));
    return points;
  };
  const auto dense = projected(denseOf<float>(grid, padded(grid.activeBox(), 3)).field());
  EXPECT_EQ(projected(VdbField(grid, VdbField::Inactive::Background)), dense);
  // The band is wide enough that nothing beyond it counts.
  const VdbField field(grid, VdbField::Inactive::Missing);
  EXPECT_EQ(projected(field), dense);
  EXPECT_NE(dense, samples.coordinates);
  for (std::size_t n = 0; n < dense.size(); n += 3)
  {
    const glm::dvec3 p(dense[n], dense[n + 1], dense[n + 2]);
    EXPECT_LT(std::abs(field.value(p)) / glm::length(field.gradient(p)), 0.5 * 1.1e-4);
  }
  // Out of the band it is not defined, and nothing moves.
  std::vector<double> outside{ 0.5, 1.0, 2.0, 30.0, 1.0, 2.0 };
  const auto before = outside;
  ink::projectSamples(field, grid.geometry(grid.activeBox()), 0.0, 3, std::span<double>(outside));
  EXPECT_EQ(outside, before);
}

TEST(VdbField, IsNotDefinedOutsideTheBand)
{
  const VdbGrid grid = readBack<openvdb::FloatGrid>(
    openvdb::tools::createLevelSetSphere<openvdb::FloatGrid>(10.0f, { 0, 0, 0 }, 1.0f, 3.0f));
  const VdbField field(grid);
  for (const glm::dvec3& p :
    { glm::dvec3(0.0), glm::dvec3(20.0, 0.0, 0.0), glm::dvec3(1e7), glm::dvec3(NAN) })
  {
    EXPECT_TRUE(std::isnan(field.value(p)));
    EXPECT_TRUE(std::isnan(field.gradient(p).x));
    EXPECT_TRUE(std::isnan(field.hessian(p)[1][1]));
  }
  const VdbField everywhere(grid, VdbField::Inactive::Background);
  EXPECT_EQ(everywhere.value({ 20.0, 0.0, 0.0 }), 3.0);
  EXPECT_EQ(everywhere.value({ 0.0, 0.0, 0.0 }), -3.0);
  EXPECT_EQ(everywhere.gradient({ 20.0, 0.0, 0.0 }), glm::dvec3(0.0));
}

} // namespace
