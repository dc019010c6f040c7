// SPDX-License-Identifier: BSD-3-Clause
// Silhouettes of volumes and of meshes for one eye: how far they are from the true curve, against the time to
// find them.

#include "Tradeoff.h"

#include "AnalyticFields.h"
#include "Curves/Contours/GridContours.h"
#include "Curves/Contours/MeshContours.h"
#include "Curves/Contours/ProjectContour.h"
#include "Curves/Contours/SilhouetteVoxels.h"
#include "HashNoise.h"
#include "MeshesWithCurvature.h"
#include "SampledVolume.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace
{

using namespace ink::testing;
using ink::Eye;

const Torus Shape{ 14.0, 6.0 };
/// From so far above that no point has a radial curvature of 0, where the distance is not defined.
const Eye View = Eye::at({ 20.0, 12.0, 75.0 });

/// What a scanner sees of the torus: 1 inside, 0 outside, blurred by a Gaussian of deviation 1, with noise of
/// a share of the step. Spacing is 1 / fineness.
Volume<float> Scan(int fineness, double noise)
{
  std::uint64_t index = 0;
  const glm::ivec3 n(48 * fineness, 48 * fineness, 24 * fineness);
  const double spacing = 1.0 / fineness;
  return Volume<float>::from(ink::GridGeometry(n, -0.5 * spacing * glm::dvec3(n - 1), glm::dvec3(spacing)),
    [&](const glm::dvec3& p)
    { return 0.5 * std::erfc(Shape.distance(p) / std::sqrt(2.0)) + noise * hashNormal(1, index++); });
}

/// The mean distance of points from the torus's contour: of their projections onto it, or 2 where these are
/// farther away or are not found.
double MeanDistance(const std::vector<glm::dvec3>& points)
{
  constexpr double most = 2.0;
  ink::ContourProjection projection;
  projection.steps = 30;
  projection.tolerance = 1e-6;
  projection.reach = most;
  double sum = 0.0;
  for (const glm::dvec3& p : points)
  {
    const auto [end, converged] = ink::projectToContour(Shape, 0.0, View, p, projection);
    sum += converged ? glm::distance(end, p) : most;
  }
  return sum / static_cast<double>(points.size());
}

/// Both ends of the segments through edge voxels.
std::vector<glm::dvec3> VoxelSegments(const ink::EdgeVoxels& voxels, double length)
{
  ink::SilhouetteCriteria criteria;
  criteria.leastMagnitude = 0.15f;
  std::vector<glm::dvec3> ends;
  for (const std::uint32_t n : ink::selectSilhouetteVoxels(voxels, criteria, View))
  {
    const glm::dvec3& center = voxels.positions[n];
    const auto segment = ink::silhouetteSegment(center, voxels.gradients[n], View.from(center), length);
    ends.insert(ends.end(), segment.begin(), segment.end());
  }
  return ends;
}

ink::EdgeVoxels EdgesOf(const Volume<float>& volume, int fineness)
{
  return ink::findEdgeVoxels(volume.field(), glm::dvec3(fineness), 0.1);
}

ink::GridContourOptions Projected(int steps)
{
  ink::GridContourOptions options;
  options.projectionSteps = steps;
  return options;
}

/// Of a mesh of the torus, with quads of about the same width and height and the surface's own normals.
ink::MeshContours ContoursOfMesh(std::uint32_t rows, double jitter, bool faceted)
{
  const ink::test::MeshWithCurvature torus = ink::test::closedTorus(14.0, 6.0, 2 * rows, rows, jitter);
  std::vector<glm::vec3> normals;
  for (const ink::PrincipalCurvature& curvature : torus.exact)
  {
    normals.emplace_back(curvature.normal());
  }
  ink::MeshContourOptions options;
  options.faceted = faceted;
  return { torus.mesh.view(), normals, options };
}

void MeasureVolumes()
{
  const Volume<float> clean = Scan(1, 0.0);
  const Volume<float> noisy = Scan(1, 0.02);
  const Volume<float> fine = Scan(4, 0.0);
  Tradeoff knob("Silhouettes of volumes",
    "Keep chains from cells; project them where curves are measured; segments through voxel centers need no "
    "iso-value.",
    "mean distance from the true contour, voxels",
    "one eye, torus of 192 x 192 x 96 voxels; edge voxels and the tree of cones were made before");

  const ink::EdgeVoxels edges = EdgesOf(fine, 4);
  knob.Add("segments through voxel centers", [&] { VoxelSegments(edges, 0.25); },
    { { "no noise", MeanDistance(VoxelSegments(EdgesOf(clean, 1), 1.0)) },
      { "2 % noise", MeanDistance(VoxelSegments(EdgesOf(noisy, 1), 1.0)) } });

  const ink::GridContours<float> ofClean(clean.field(), 0.5);
  const ink::GridContours<float> ofNoisy(noisy.field(), 0.5);
  const ink::GridContours<float> ofFine(fine.field(), 0.5);
  for (const int steps : { 0, 1, 2, 4 })
  {
    knob.Add(
      steps == 0 ? "chains from cells" : "chains, " + std::to_string(steps) + " projection steps",
      [&ofFine, steps] { ofFine.find(View, {}, Projected(steps)); },
      { { "no noise", MeanDistance(ofClean.find(View, {}, Projected(steps)).positions) },
        { "2 % noise", MeanDistance(ofNoisy.find(View, {}, Projected(steps)).positions) } },
      steps == 0 ? Tradeoff::Default : Tradeoff::Choice);
  }
  knob.Print();
}

void MeasureMeshes()
{
  constexpr std::uint32_t rows = 120;
  constexpr double edge = 2.0 * std::numbers::pi * 6.0 / rows;
  Tradeoff knob("Silhouettes of meshes",
    "Keep interpolated silhouettes; faceted ones serve meshes without normals, and follow the outline of the "
    "polygons themselves.",
    "mean distance from the true contour, edges",
    "one eye, torus of 921,600 triangles; the index was made before");
  const ink::MeshContours interpolated = ContoursOfMesh(480, 0.0, false);
  const ink::MeshContours faceted = ContoursOfMesh(480, 0.0, true);
  const auto errors = [&](bool ofFaceted)
  {
    Tradeoff::Errors all;
    for (const auto& [scene, jitter] :
      { std::pair("regular", 0.0), std::pair("points displaced by a quarter edge", 0.25) })
    {
      all.emplace_back(
        scene, MeanDistance(ContoursOfMesh(rows, jitter, ofFaceted).find(View).positions) / edge);
    }
    return all;
  };
  knob.Add(
    "interpolated", [&] { interpolated.find(View); }, errors(false), Tradeoff::Default);
  knob.Add(
    "faceted", [&] { faceted.find(View); }, errors(true));
  knob.Print();
}

} // namespace

int main()
{
  Tradeoff::PrintHeader();
  MeasureVolumes();
  MeasureMeshes();
  return 0;
}
