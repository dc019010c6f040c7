// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Streamlines/EvenStreamlines.h"

#include "Curves/Streamlines/StreamlinePlacement.h"
#include "Curves/Streamlines/StreamlineTracer.h"
#include "Mesh/OnePerPoint.h"
#include "Mesh/SurfaceSides.h"
#include "PointSampling/WhiteNoise.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace ink
{

namespace
{

// Of the spacing:
constexpr double longestStep = 0.25;
constexpr double closeDistance = 0.1;

void check(bool isRight, const std::string& message)
{
  if (!isRight)
  {
    throw std::invalid_argument(message);
  }
}

/// A mesh with directions at its points.
class MeshLineSurface
{
public:
  using Point = MeshPoint;

  MeshLineSurface(const MeshNavigation& mesh, std::span<const glm::vec3> normals, const LineField& field,
    const TraceOptions& options)
    : Mesh(mesh)
    , Normals(normals)
    , Field(field)
    , Areas(cumulateArea(mesh.mesh()))
    , Tracer(mesh, field, options)
  {
  }

  double area() const { return this->Mesh.area(); }
  glm::dvec3 center() const { return 0.5 * this->Mesh.lower() + 0.5 * this->Mesh.upper(); }
  glm::dvec3 position(const MeshPoint& at) const { return this->Mesh.position(at); }
  glm::vec3 normal(const MeshPoint& at) const
  {
    // Farther from the triangle's own, normals would put points beside each other above each other.
    const glm::vec3 given = normalAt(this->Mesh, this->Normals, at);
    const glm::vec3 own(this->planeNormal(at));
    const float cosine = glm::dot(given, own);
    return cosine * cosine < 1.0f - straightUp ? std::copysign(1.0f, cosine) * own : given;
  }
  glm::dvec3 planeNormal(const MeshPoint& at) const { return this->Mesh.chart(at.triangle).normal(); }
  SurfaceDirection ownDirection(const MeshPoint& at) const
  {
    const std::uint32_t point = this->Mesh.nearestPoint(at);
    return { this->Field.directions[point],
      this->Field.umbilics.empty() ? 0.0f : this->Field.umbilics[point] };
  }
  glm::dvec3 direction(const MeshPoint& at, const glm::dvec3& heading) const
  {
    return this->Tracer.direction(at, heading);
  }
  TracedLine trace(
    const MeshPoint& seed, const glm::dvec3& heading, const StreamlineTracer::Accept& accept) const
  {
    return this->Tracer.trace(seed, heading, accept);
  }
  std::optional<SurfaceArrival<MeshPoint>> walk(
    const MeshPoint& from, const glm::dvec3& direction, double distance) const
  {
    const std::optional<MeshNavigation::Arrival> end = this->Mesh.walk(from, direction, distance);
    return end ? std::optional<SurfaceArrival<MeshPoint>>({ end->at, end->heading }) : std::nullopt;
  }
  std::vector<SurfaceSample> scatter(std::size_t count, std::uint64_t seed) const
  {
    return sampleWhiteNoise(this->Mesh.mesh(), this->Areas, count, seed);
  }
  std::optional<MeshPoint> pointOf(const SurfaceSample& sample) const
  {
    const MeshPoint at{ sample.triangle,
      { 1.0 - static_cast<double>(sample.b1) - static_cast<double>(sample.b2), sample.b1, sample.b2 } };
    return this->Mesh.isUsable(at.triangle) ? std::optional(at) : std::nullopt;
  }
  static bool isBefore(const MeshPoint& a, const MeshPoint& b) { return a.triangle < b.triangle; }

private:
  const MeshNavigation& Mesh;
  std::span<const glm::vec3> Normals;
  const LineField& Field;
  CumulativeArea Areas;
  StreamlineTracer Tracer;
};

} // namespace

EvenStreamlineOptions completeOptions(const EvenStreamlineOptions& options, double area)
{
  check(options.spacing > 0.0 && std::isfinite(options.spacing),
    "the spacing is " + std::to_string(options.spacing) + ", expected more than 0");
  check(options.stopDistance > 0.0 && options.stopDistance <= 0.9,
    "the stop distance is " + std::to_string(options.stopDistance) +
      ", expected more than 0 and no more than 0.9");
  const double samples = area / options.spacing / options.spacing / longestStep;
  check(samples < 0x1p28,
    "the surface needs " + std::to_string(samples) + " samples of lines at a spacing of " +
      std::to_string(options.spacing) + ", expected fewer than 268435456, so a larger spacing");
  EvenStreamlineOptions own = options;
  own.trace.maximumStep = std::min(own.trace.maximumStep, longestStep * options.spacing);
  own.trace.closeDistance =
    own.trace.closeDistance > 0.0 ? own.trace.closeDistance : closeDistance * options.spacing;
  return own;
}

Streamlines evenStreamlines(const MeshNavigation& mesh, std::span<const glm::vec3> normals,
  const LineField& field, const EvenStreamlineOptions& options, const Progress& progress)
{
  const std::size_t count = mesh.mesh().points.size();
  checkOnePerPoint(mesh.mesh(), field.directions.size(), "directions");
  check((normals.empty() || normals.size() == count) &&
      (field.others.empty() || field.others.size() == count) &&
      (field.umbilics.empty() || field.umbilics.size() == count),
    "normals, other directions and umbilic measures: expected none or one per point");
  const EvenStreamlineOptions own = completeOptions(options, mesh.area());
  if (!(mesh.area() > 0.0))
  {
    return {};
  }
  const MeshLineSurface surface(mesh, normals, field, own.trace);
  return StreamlinePlacement<MeshLineSurface>(surface, own, progress).run();
}

} // namespace ink
