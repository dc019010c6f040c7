// SPDX-License-Identifier: BSD-3-Clause
// Curvature, radial curvature of contours and lines of curvature of a narrow band: as of the dense grid that
// it was made of, and as of the torus that this samples.

#include "Curvature/FieldCurvatureDerivative.h"
#include "Curves/Contours/FieldContours.h"
#include "Curves/Streamlines/EvenFieldStreamlines.h"
#include "Fields/Vdb/VdbField.h"
#include "Fields/Vdb/VdbWrite.h"

#include "AnalyticFields.h"
#include "MeshesWithCurvature.h"
#include "SampledVolume.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace
{

using namespace ink;

constexpr double radius = 1.0;
constexpr double tube = 0.4;
constexpr double voxel = 0.04;

/// Distances from a torus, positive inside, and the band of ten voxels around it.
struct Scan
{
  ink::testing::Volume<double> dense = ink::testing::Volume<double>::from(
    GridGeometry({ 81, 81, 41 }, glm::dvec3(-1.6, -1.6, -0.8), glm::dvec3(voxel)),
    [](const glm::dvec3& p) {
      return -ink::testing::Torus{ radius, tube }.value(p);
    });
  VdbField band{ makeVdbGrid(this->dense.field(), { 0.0, 5 }) };
};

const Scan& scan()
{
  static const Scan one;
  return one;
}

const test::MeshWithCurvature& torus()
{
  static const test::MeshWithCurvature mesh = test::closedTorus(radius, tube, 40, 30);
  return mesh;
}

} // namespace

TEST(VdbCurvature, IsThatOfTheDenseGrid)
{
  const GridField<double> dense = scan().dense.field();
  const MeshCurvature found = fieldCurvatures(scan().band, torus().mesh.points);
  const MeshCurvature expected = fieldCurvatures(dense, torus().mesh.points);
  const FieldDerivativeOptions options{ 1.5 * voxel,
    [&](const glm::dvec3& p) { return dense.geometry().contains(p); } };
  for (std::size_t i = 0; i < found.points.size(); ++i)
  {
    ASSERT_EQ(found.sources[i], CurvatureSource::Surface) << i;
    const PrincipalCurvature& at = expected.points[i];
    ASSERT_NEAR(found.points[i].k1, at.k1, 1e-9) << i;
    ASSERT_NEAR(found.points[i].k2, at.k2, 1e-9) << i;
    const glm::dvec3& p = torus().mesh.points[i];
    const CurvatureDerivative own = fieldCurvatureDerivative(scan().band, p, at, options);
    ASSERT_NEAR(own.c122, fieldCurvatureDerivative(dense, p, at, options).c122, 1e-6) << i;
  }
  EXPECT_LT(test::curvatureErrors(torus().exact, found.points).curvature, 0.05);
  // Outside the band nothing is known.
  EXPECT_FALSE(fieldCurvature(scan().band, { radius, 0.0, 0.0 }));
}

TEST(VdbCurvature, OfContoursTowardTheEye)
{
  const Eye eye = Eye::at({ 3.0, 4.0, 2.0 });
  ContourArrays arrays;
  arrays.radialCurvature = true;
  const Contours contours = FieldContours(scan().band, 0.0, scan().dense.geometry).find(eye, arrays);
  ASSERT_GT(contours.positions.size(), 200u);
  ASSERT_EQ(contours.radialCurvature.size(), contours.positions.size());
  // A mean, as second derivatives of voxels are interpolated.
  double error = 0.0;
  for (std::size_t i = 0; i < contours.positions.size(); ++i)
  {
    const glm::dvec3 p = contours.positions[i];
    ASSERT_NEAR(ink::testing::Torus({ radius, tube }).value(p), 0.0, 0.1 * voxel);
    ASSERT_NEAR(contours.radialCurvature[i], radialCurvature(scan().dense.field(), eye, p), 1e-4) << i;
    const double exact = -radialCurvature(ink::testing::Torus{ radius, tube }, eye, p);
    error += std::abs(contours.radialCurvature[i] - exact) / static_cast<double>(contours.positions.size());
  }
  EXPECT_LT(error, 0.1);
}

TEST(VdbCurvature, LinesAreTheCirclesOfTheTorus)
{
  const FieldSurface surface{ scan().band, scan().band, 0.0,
    [](const glm::dvec3& p) { return scan().dense.geometry.contains(p); } };
  const SurfaceSamples samples{ torus().mesh.points,
    4.0 * std::numbers::pi * std::numbers::pi * radius * tube };
  EvenStreamlineOptions options;
  options.spacing = 0.15;
  options.trace.maximumStep = 0.5 * voxel;
  const FieldStreamlines lines = evenFieldStreamlines(surface, samples, true, 0.0, options);
  ASSERT_GT(lines.lines.size(), 25u);
  double length = 0.0;
  for (std::size_t n = 0; n < lines.lines.size(); ++n)
  {
    const std::size_t first = lines.lines.offsets[n];
    const std::size_t end = lines.lines.offsets[n + 1];
    length += lines.arcLength[end - 1];
    for (std::size_t i = first; i < end; ++i)
    {
      const glm::dvec3 p = lines.positions[i];
      const double turn =
        std::atan2(p.y, p.x) - std::atan2(lines.positions[first].y, lines.positions[first].x);
      ASSERT_NEAR(std::remainder(turn, 2.0 * std::numbers::pi) * std::hypot(p.x, p.y), 0.0, 0.5 * voxel);
      ASSERT_NEAR(ink::testing::Torus({ radius, tube }).value(p), 0.0, 0.1 * voxel);
    }
  }
  EXPECT_NEAR(samples.area / length / options.spacing, 1.0, 0.15);
}
