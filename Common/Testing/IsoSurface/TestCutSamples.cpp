// SPDX-License-Identifier: BSD-3-Clause
#include "IsoSurface/CutSamples.h"

#include "Fields/Grid/GridField.h"

#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <vector>

namespace
{

using ink::CutSurface;

constexpr double radius = 9.3;
const glm::ivec3 size(25, 27, 14);

/// A ball around the middle of the lower side across z; 100 on its surface, more inside. By global indices.
std::vector<float> halfBall(const glm::ivec3& first, const glm::ivec3& dimensions)
{
  std::vector<float> values;
  for (int k = 0; k < dimensions.z; ++k)
  {
    for (int j = 0; j < dimensions.y; ++j)
    {
      for (int i = 0; i < dimensions.x; ++i)
      {
        const glm::dvec3 p = glm::dvec3(first + glm::ivec3(i, j, k)) - glm::dvec3(12, 13, 0);
        values.push_back(static_cast<float>(100.0 - 10.0 * (glm::length(p) - radius)));
      }
    }
  }
  return values;
}

ink::CutSamples cutOf(const std::vector<float>& values, const ink::GridGeometry& geometry, CutSurface kind,
  double isoValue = 100.0)
{
  return ink::sampleCut(
    ink::GridField<float>(geometry, values), isoValue, kind, glm::ivec3(0), geometry.dimensions() - 1);
}

TEST(CutSamples, OfABallAreOnACircle)
{
  const ink::CutSamples cut = cutOf(halfBall(glm::ivec3(0), size), ink::GridGeometry(size), CutSurface::Rim);
  // A curve crosses about 4 / pi times its length of faces.
  EXPECT_NEAR(static_cast<double>(cut.points.size()), 8 * radius * ink::rimNormals, 4.0 * ink::rimNormals);
  ASSERT_EQ(cut.normals.size(), cut.points.size());
  ASSERT_EQ(cut.cells.size(), cut.points.size());
  for (std::size_t i = 0; i < cut.points.size(); ++i)
  {
    const glm::dvec3 fromCenter = cut.points[i] - glm::dvec3(12, 13, 0);
    EXPECT_EQ(cut.points[i].z, 0.0);
    EXPECT_NEAR(glm::length(fromCenter), radius, 0.1);
    const glm::ivec3 cell(glm::floor(cut.points[i]));
    EXPECT_EQ(cut.cells[i], ink::activeCellId(cell)) << "a point on no edge lies in one face";
    // From the ball's normal over the side's and beyond the opposite.
    const double turned = (i % ink::rimNormals + 1) * std::numbers::pi / (ink::rimNormals - 1);
    const glm::dvec3 wanted =
      std::cos(turned) * fromCenter / radius + std::sin(turned) * glm::dvec3(0, 0, -1);
    EXPECT_GT(glm::dot(cut.normals[i], wanted), 0.99);
    EXPECT_NEAR(glm::length(cut.normals[i]), 1.0, 1e-12);
  }
}

TEST(CutSamples, OfFinerFacesAreNearerToTheCircle)
{
  const auto values = halfBall(glm::ivec3(0), size);
  const ink::GridGeometry geometry(size);
  const auto cutOf = [&](CutSurface kind)
  {
    const ink::IsoSurfaceResampling finer{ .subdivision = glm::ivec3(3, 3, 2) };
    return ink::sampleCut(
      ink::GridField<float>(geometry, values), 100.0, kind, glm::ivec3(0), size - 1, {}, finer);
  };
  const auto rim = cutOf(CutSurface::Rim);
  EXPECT_NEAR(
    static_cast<double>(rim.points.size()), 3 * 8 * radius * ink::rimNormals, 12.0 * ink::rimNormals);
  for (std::size_t i = 0; i < rim.points.size(); ++i)
  {
    EXPECT_NEAR(glm::length(rim.points[i] - glm::dvec3(12, 13, 0)), radius, 0.03);
    EXPECT_EQ(rim.cells[i], ink::activeCellId(glm::ivec3(glm::floor(3.0 * rim.points[i]))));
  }
  const auto cap = cutOf(CutSurface::Cap);
  EXPECT_NEAR(static_cast<double>(cap.points.size()) -
      (1.0 - 0.5 / ink::rimNormals) * static_cast<double>(rim.points.size()),
    9 * std::numbers::pi * radius * radius, 30.0);
}

TEST(CutSamples, OfNoiseLieOnTheSmoothedSurface)
{
  auto values = halfBall(glm::ivec3(0), size);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    // A checkerboard of two fifths of a voxel's step, which a Gaussian of one voxel takes away.
    const int parity = static_cast<int>(i % 25 + i / 25 % 27 + i / (25 * 27)) % 2;
    values[i] += parity == 0 ? 4.0F : -4.0F;
  }
  const ink::GridField<float> field(ink::GridGeometry(size), values);
  const auto farthest = [&](const ink::IsoSurfaceResampling& resampling)
  {
    double most = 0.0;
    for (const glm::dvec3& point :
      ink::sampleCut(field, 100.0, CutSurface::Rim, glm::ivec3(0), size - 1, {}, resampling).points)
    {
      most = std::max(most, std::abs(glm::length(point - glm::dvec3(12, 13, 0)) - radius));
    }
    return most;
  };
  EXPECT_GT(farthest({}), 0.3);
  for (const auto target : { ink::SmoothingTarget::Surface, ink::SmoothingTarget::Normals })
  {
    const double found = farthest({ glm::dvec3(1.0), glm::ivec3(2), target });
    EXPECT_LT(found, target == ink::SmoothingTarget::Surface ? 0.3 : 0.15);
  }
}

TEST(CutSamples, OfACapFillTheCircle)
{
  const auto values = halfBall(glm::ivec3(0), size);
  const ink::GridGeometry geometry(size);
  const auto rim = cutOf(values, geometry, CutSurface::Rim);
  const auto cap = cutOf(values, geometry, CutSurface::Cap);
  // A point for each unit of area, and half of one where the rim is.
  EXPECT_NEAR(static_cast<double>(cap.points.size()) -
      (1.0 - 0.5 / ink::rimNormals) * static_cast<double>(rim.points.size()),
    std::numbers::pi * radius * radius, 10.0);
  for (const glm::dvec3& point : cap.points)
  {
    EXPECT_LT(glm::length(point - glm::dvec3(12, 13, 0)), radius + 0.1);
  }
}

TEST(CutSamples, AreOnAllSidesOfWhatFillsTheVolume)
{
  const std::vector<float> values(static_cast<std::size_t>(size.x * size.y * size.z), 150.0F);
  const ink::GridGeometry geometry(size);
  EXPECT_TRUE(cutOf(values, geometry, CutSurface::Rim).points.empty());
  const auto cap = cutOf(values, geometry, CutSurface::Cap);
  const int faces = 2 * (24 * 26 + 24 * 13 + 26 * 13);
  const int edges = 4 * (24 + 26 + 13);
  EXPECT_EQ(cap.points.size(), static_cast<std::size_t>(faces + edges * ink::capEdgeNormals));
  glm::dvec3 sum(0.0);
  for (std::size_t i = 0; i < cap.points.size(); ++i)
  {
    EXPECT_GT(glm::dot(cap.normals[i], cap.points[i] - glm::dvec3(12, 13, 6.5)), 0.0) << "outwards";
    sum += cap.normals[i];
  }
  EXPECT_LT(glm::length(sum), 1e-9);
}

TEST(CutSamples, TurnOverTheEdgesBetweenCaps)
{
  // The upper corner along all axes, on a grid twice as fine, and none where the surface leaves the edge.
  const glm::ivec3 eight(8, 8, 8);
  std::vector<float> values;
  for (int n = 0; n < 8 * 8 * 8; ++n)
  {
    const glm::dvec3 p(n % 8, n / 8 % 8, n / 64);
    values.push_back(static_cast<float>(4.2 - glm::distance(p, glm::dvec3(7.0))));
  }
  const ink::GridGeometry geometry(eight, glm::dvec3(0.0), glm::dvec3(1, 2, 1));
  const auto cut = ink::sampleCut(ink::GridField<float>(geometry, values), 0.0, CutSurface::Cap,
    glm::ivec3(0), eight - 1, {}, { .subdivision = glm::ivec3(2) });
  int positions = 0;
  for (std::size_t i = 0; i + 1 < cut.points.size(); ++i)
  {
    const glm::bvec3 isEnd = glm::equal(cut.points[i], glm::dvec3(7, 14, 7));
    const int ends = (isEnd.x ? 1 : 0) + (isEnd.y ? 1 : 0) + (isEnd.z ? 1 : 0);
    if (ends < 2 || (i > 0 && cut.points[i] == cut.points[i - 1]))
    {
      continue;
    }
    ++positions;
    ASSERT_LE(i + ink::capEdgeNormals, cut.points.size());
    for (std::size_t n = 0; n < ink::capEdgeNormals; ++n)
    {
      const double turned = static_cast<double>(n) * std::numbers::pi / 12.0;
      const glm::dvec3 from = isEnd.x ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
      const glm::dvec3 to = isEnd.z ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
      EXPECT_EQ(cut.points[i + n], cut.points[i]);
      EXPECT_LT(glm::distance(cut.normals[i + n], std::cos(turned) * from + std::sin(turned) * to), 1e-9);
    }
  }
  EXPECT_EQ(positions, 3 * 8) << "4.2 voxels of two halves each, the last of which the surface crosses";
}

TEST(CutSamples, HaveNormalsAcrossTheSideOfAShearedGrid)
{
  const glm::dmat3 direction(0.8, 0.6, 0.0, -0.6, 0.8, 0.3, 0.1, 0.0, 1.0);
  const ink::GridGeometry geometry(size, glm::dvec3(1e3, 0, 0), glm::dvec3(1e-3, 1, -2), direction);
  const auto cut = cutOf(halfBall(glm::ivec3(0), size), geometry, CutSurface::Rim);
  ASSERT_FALSE(cut.points.empty());
  glm::dvec3 side = glm::normalize(glm::cross(direction[0], direction[1]));
  side *= glm::dot(side, geometry.stepToWorld() * glm::dvec3(0, 0, 1)) > 0.0 ? -1.0 : 1.0;
  for (std::size_t i = 0; i < cut.normals.size(); i += ink::rimNormals)
  {
    double nearest = -1.0;
    for (std::size_t n = i; n < i + ink::rimNormals; ++n)
    {
      EXPECT_NEAR(glm::length(cut.normals[n]), 1.0, 1e-12);
      EXPECT_NEAR(glm::dot(glm::cross(cut.normals[i], cut.normals[n]), side), 0.0, 1e-9) << "in one plane";
      nearest = std::max(nearest, glm::dot(cut.normals[n], side));
    }
    EXPECT_GT(nearest, std::cos(0.5 * std::numbers::pi / (ink::rimNormals - 1)) - 1e-9) << "outwards";
  }
}

TEST(CutSamples, OfPiecesAreThoseOfTheWhole)
{
  const auto sorted = [](const ink::CutSamples& cut)
  {
    std::vector<std::array<double, 3>> points;
    for (const glm::dvec3& p : cut.points)
    {
      points.push_back({ p.x, p.y, p.z });
    }
    std::sort(points.begin(), points.end());
    return points;
  };
  const auto whole =
    sorted(cutOf(halfBall(glm::ivec3(0), size), ink::GridGeometry(size), CutSurface::Cap, 40.0));
  std::vector<std::array<double, 3>> all;
  // Cells 0 to 9 and 10 to 23 along x, with a ghost cell between them.
  for (const auto& [first, end, own, ownEnd] : { std::array{ 0, 12, 0, 10 }, std::array{ 9, 25, 1, 15 } })
  {
    const glm::ivec3 corner(first, 0, 0);
    const glm::ivec3 dimensions(end - first, size.y, size.z);
    const ink::GridGeometry geometry(dimensions, glm::dvec3(0.0), glm::dvec3(1.0), glm::dmat3(1.0), corner);
    ink::CellSelection selection;
    selection.begin.x = own;
    selection.end.x = ownEnd;
    const auto values = halfBall(corner, dimensions);
    const auto part = sorted(ink::sampleCut(
      ink::GridField<float>(geometry, values), 40.0, CutSurface::Cap, glm::ivec3(0), size - 1, selection));
    all.insert(all.end(), part.begin(), part.end());
  }
  std::sort(all.begin(), all.end());
  EXPECT_EQ(all, whole);
}

TEST(CutSamples, KeepAwayFromWhatIsMissing)
{
  auto values = halfBall(glm::ivec3(0), size);
  const ink::GridGeometry geometry(size);
  const auto whole = cutOf(values, geometry, CutSurface::Cap);
  values[static_cast<std::size_t>(13 * size.x + 12)] = std::numeric_limits<float>::quiet_NaN();
  values[static_cast<std::size_t>(15 * size.x + 12)] = std::numeric_limits<float>::infinity();
  // Four faces around each of the two, which are not neighbors' neighbors.
  EXPECT_EQ(cutOf(values, geometry, CutSurface::Cap).points.size(), whole.points.size() - 8);
  EXPECT_TRUE(cutOf(values, geometry, CutSurface::Cap, std::nan("")).points.empty());
  EXPECT_TRUE(cutOf(values, geometry, CutSurface::Open).points.empty());
}

TEST(CutSamples, OfOneSliceAreNone)
{
  const glm::ivec3 slice(25, 27, 1);
  EXPECT_TRUE(
    cutOf(halfBall(glm::ivec3(0), slice), ink::GridGeometry(slice), CutSurface::Cap).points.empty());
}

TEST(CutSamples, AreTheSameAcrossStripsAndOnAnyNumberOfThreads)
{
  // The ball's middle lies at (32, 33): strips are 32 faces wide.
  const glm::ivec3 large(70, 70, 14);
  const auto values = halfBall(glm::ivec3(-20, -20, 0), large);
  const ink::GridGeometry geometry(large);
  for (const CutSurface kind : { CutSurface::Rim, CutSurface::Cap })
  {
    for (const ink::IsoSurfaceResampling& resampling :
      { ink::IsoSurfaceResampling{}, ink::IsoSurfaceResampling{ .subdivision = glm::ivec3(2) } })
    {
      const auto cutOn = [&](const char* threads)
      {
        setenv("VTK_SMP_MAX_THREADS", threads, 1);
        return ink::sampleCut(
          ink::GridField<float>(geometry, values), 100.0, kind, glm::ivec3(0), large - 1, {}, resampling);
      };
      const ink::CutSamples one = cutOn("1");
      const ink::CutSamples two = cutOn("2");
      EXPECT_TRUE(one.points == two.points && one.normals == two.normals && one.cells == two.cells);
      const ink::CutSamples alone =
        ink::sampleCut(ink::GridField<float>(ink::GridGeometry(size), halfBall(glm::ivec3(0), size)), 100.0,
          kind, glm::ivec3(0), size - 1, {}, resampling);
      ASSERT_EQ(one.points.size(), alone.points.size());
      for (std::size_t i = 0; i < one.points.size(); ++i)
      {
        EXPECT_LT(glm::distance(one.points[i] - glm::dvec3(20, 20, 0), alone.points[i]), 1e-6);
      }
    }
  }
  unsetenv("VTK_SMP_MAX_THREADS");
}

TEST(CutSamples, DoNotOverflowAtTheLimitsOfTheType)
{
  const glm::ivec3 two(2, 2, 2);
  const double least = std::numeric_limits<double>::lowest();
  const double most = std::numeric_limits<double>::max();
  const std::vector<double> values{ least, most, least, most, least, most, least, most };
  const auto cut = ink::sampleCut(ink::GridField<double>(ink::GridGeometry(two), values), 0.0,
    CutSurface::Rim, glm::ivec3(0), glm::ivec3(1));
  ASSERT_EQ(cut.points.size(), 4U * ink::rimNormals) << "the sides that the surface crosses";
  for (const glm::dvec3& point : cut.points)
  {
    EXPECT_EQ(point.x, 0.5);
  }
}

} // namespace
