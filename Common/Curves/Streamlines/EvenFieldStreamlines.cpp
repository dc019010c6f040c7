// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Streamlines/EvenFieldStreamlines.h"

#include "Core/Hash.h"
#include "Curvature/PrincipalCurvature.h"
#include "Curves/Streamlines/StreamlinePlacement.h"
#include "IsoSurface/IsoSurfaceSamples.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <tuple>

namespace ink
{

namespace
{

/// The iso-surface of a field, with the directions of its curvature.
class FieldLineSurface
{
public:
  using Point = FieldPoint;

  FieldLineSurface(
    const FieldSurface& surface, const SurfaceSamples& samples, const FieldTraceOptions& options)
    : Samples(samples)
    , Tracer(surface, options)
  {
    glm::dvec3 lower(std::numeric_limits<double>::infinity());
    glm::dvec3 upper(-lower);
    for (const glm::dvec3& p : samples.positions)
    {
      lower = glm::min(lower, p);
      upper = glm::max(upper, p);
    }
    this->Center = 0.5 * lower + 0.5 * upper;
    this->Reach = std::sqrt(samples.area / static_cast<double>(samples.positions.size()));
  }

  double area() const { return this->Samples.area; }
  const glm::dvec3& center() const { return this->Center; }
  const glm::dvec3& position(const FieldPoint& at) const { return at.position; }
  glm::vec3 normal(const FieldPoint& at) const { return glm::vec3(at.normal); }
  const glm::dvec3& planeNormal(const FieldPoint& at) const { return at.normal; }
  SurfaceDirection ownDirection(const FieldPoint& at) const
  {
    return this->Tracer.directionAt(at.position, glm::dvec3(0.0));
  }
  glm::dvec3 direction(const FieldPoint& at, const glm::dvec3& heading) const
  {
    return this->Tracer.directionAt(at.position, heading).direction;
  }
  TracedFieldLine trace(
    const FieldPoint& seed, const glm::dvec3& heading, const FieldTracer::Accept& accept) const
  {
    return this->Tracer.trace(seed, heading, accept);
  }
  std::optional<SurfaceArrival<FieldPoint>> walk(
    const FieldPoint& from, const glm::dvec3& direction, double distance) const
  {
    return this->Tracer.walk(from, direction, distance);
  }
  /// Hashes, from each of which a point is made.
  std::vector<std::uint64_t> scatter(std::size_t count, std::uint64_t seed) const
  {
    std::vector<std::uint64_t> result(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      result[i] = hash(seed, i);
    }
    return result;
  }
  /// Near a sample, so that there may be many more points than samples.
  std::optional<FieldPoint> pointOf(std::uint64_t random) const
  {
    const std::optional<FieldPoint> sample =
      this->Tracer.project(this->Samples.positions[random % this->Samples.positions.size()]);
    if (!sample)
    {
      return std::nullopt;
    }
    const double angle = 2.0 * std::numbers::pi * unitDouble(hash(random, 1));
    const double distance = this->Reach * std::sqrt(unitDouble(hash(random, 2)) / std::numbers::pi);
    const auto [x, y] = tangentAxes(sample->normal);
    return this->Tracer.project(sample->position + distance * (std::cos(angle) * x + std::sin(angle) * y));
  }
  static bool isBefore(const FieldPoint& a, const FieldPoint& b)
  {
    const glm::dvec3& p = a.position;
    const glm::dvec3& q = b.position;
    return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
  }

private:
  const SurfaceSamples& Samples;
  FieldTracer Tracer;
  glm::dvec3 Center;
  double Reach; ///< of a sample: the side of a square of its area
};

} // namespace

template <class T>
SurfaceSamples samplesOfGrid(const GridField<T>& field, double isoValue, const Progress& progress)
{
  SampleOptions options;
  options.arithmetic = Arithmetic::Double;
  const ActiveCells cells = findActiveCells(field, isoValue, options.rule, {}, progress);
  std::vector<float> normals(3 * cells.count);
  SurfaceSamples samples;
  std::vector<double> coordinates(3 * cells.count);
  placeIsoSurfaceSamples(
    field, isoValue, options, cells, std::span<double>(coordinates), std::span<float>(normals));
  const glm::dmat3& edges = field.geometry().stepToWorld();
  const double volume = std::abs(glm::dot(edges[0], glm::cross(edges[1], edges[2])));
  for (std::size_t i = 0; i < coordinates.size(); i += 3)
  {
    const glm::dvec3 normal(normals[i], normals[i + 1], normals[i + 2]);
    samples.positions.emplace_back(coordinates[i], coordinates[i + 1], coordinates[i + 2]);
    double across = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      across += std::abs(glm::dot(normal, edges[axis]));
    }
    samples.area += across > 0.0 ? volume / across : 0.0;
  }
  return samples;
}

#define INK_INSTANTIATE(T)                                                                                   \
  template SurfaceSamples samplesOfGrid(const GridField<T>&, double, const Progress&);
INK_FOR_EACH_SCALAR(INK_INSTANTIATE)
#undef INK_INSTANTIATE

FieldStreamlines evenFieldStreamlines(const FieldSurface& surface, const SurfaceSamples& samples,
  bool maximum, double negligible, const EvenStreamlineOptions& options, const Progress& progress)
{
  const EvenStreamlineOptions own = completeOptions(options, samples.area);
  if (!(samples.area > 0.0) || samples.positions.empty())
  {
    return {};
  }
  FieldTraceOptions trace;
  trace.maximum = maximum;
  trace.step = own.trace.maximumStep;
  trace.maximumLength = own.trace.maximumLength / trace.step;
  trace.umbilicLimit = own.trace.umbilicLimit;
  trace.negligible = negligible;
  trace.closeDistance = own.trace.closeDistance / trace.step;
  // Far below what is seen; the interpolated values of a grid are not as exact as they are differentiable.
  trace.tolerance = 1e-4;
  const FieldLineSurface on(surface, samples, trace);
  return StreamlinePlacement<FieldLineSurface>(on, own, progress).run();
}

} // namespace ink
