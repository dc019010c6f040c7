// SPDX-License-Identifier: BSD-3-Clause
#include "Curvature/MeshCurvature.h"

#include "Core/ParallelChunks.h"
#include "Core/UnitOrZero.h"
#include "Curvature/CurvatureDiffusion.h"
#include "Curvature/ExponentialMapFit.h"
#include "Curvature/RingFit.h"
#include "Curvature/SurfaceRings.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace ink
{

namespace
{

constexpr std::size_t pointsPerChunk = 512;

/// The unit normals of sites, zero where unknown.
std::vector<glm::dvec3> siteNormals(
  const TriangleMesh& mesh, const SurfaceRings& rings, std::span<const glm::vec3> normals)
{
  std::vector<glm::dvec3> result(mesh.points.size(), glm::dvec3(0.0));
  // Several points of a site add up.
  for (std::size_t point = 0; point < normals.size(); ++point)
  {
    result[rings.site(point)] += unitOrZero(glm::dvec3(normals[point]));
  }
  parallelForEach(result.size(),
    [&](std::size_t site)
    {
      // Opposite ones cancel out up to rounding.
      constexpr double rounding = 1e-6;
      glm::dvec3& normal = result[site];
      normal = unitOrZero(glm::length(normal) > rounding ? normal : rings.areaVector(mesh.points, site));
    });
  return result;
}

bool isKnown(CurvatureSource source)
{
  return source != CurvatureSource::None;
}

/// The mean of what is known of the neighbors, as forms in the tangent plane of a site.
/// @param normal of the site, or zero: the mean of the neighbors'
std::pair<PrincipalCurvature, CurvatureSource> meanOfNeighbors(
  std::span<const std::uint32_t> ring, const glm::dvec3& normal, const MeshCurvature& known)
{
  glm::dmat3 sum(0.0);
  glm::dvec3 up(0.0);
  int count = 0;
  for (const std::uint32_t neighbor : ring)
  {
    if (isKnown(known.sources[neighbor]))
    {
      const PrincipalCurvature& c = known.points[neighbor];
      sum += c.k1 * glm::outerProduct(c.direction1, c.direction1) +
        c.k2 * glm::outerProduct(c.direction2, c.direction2);
      up += c.normal();
      ++count;
    }
  }
  up = glm::dot(normal, normal) > 0.0 ? normal : unitOrZero(up);
  const auto [axis1, axis2] = tangentAxes(glm::dot(up, up) > 0.0 ? up : glm::dvec3(0.0, 0.0, 1.0));
  const double share = 1.0 / std::max(count, 1);
  const TangentForm form{ share * glm::dot(axis1, sum * axis1), share * glm::dot(axis1, sum * axis2),
    share * glm::dot(axis2, sum * axis2) };
  // Sums of the largest numbers may be none.
  const bool isUsable = count > 0 && std::isfinite(form.l) && std::isfinite(form.m) && std::isfinite(form.n);
  return { principalCurvature(isUsable ? form : TangentForm(), axis1, axis2),
    isUsable ? CurvatureSource::Neighbors : CurvatureSource::None };
}

void fillUnknown(const SurfaceRings& rings, std::span<const glm::dvec3> normals, MeshCurvature& result)
{
  // Sites that are filled do not count as known before all are.
  std::vector<std::pair<std::size_t, std::pair<PrincipalCurvature, CurvatureSource>>> filled;
  for (std::size_t site = 0; site < result.sources.size(); ++site)
  {
    if (!isKnown(result.sources[site]))
    {
      filled.emplace_back(site, meanOfNeighbors(rings.ring(site), normals[site], result));
    }
  }
  for (const auto& [site, found] : filled)
  {
    std::tie(result.points[site], result.sources[site]) = found;
  }
}

void checkOptions(
  const TriangleMesh& mesh, std::span<const glm::vec3> normals, const CurvatureOptions& options)
{
  if (!normals.empty() && normals.size() != mesh.points.size())
  {
    throw std::invalid_argument("there are " + std::to_string(normals.size()) +
      " normals; expected one for each of " + std::to_string(mesh.points.size()) + " points, or none");
  }
  if (options.rings < 1 || options.rings > mostCurvatureRings)
  {
    throw std::invalid_argument("the number of rings is " + std::to_string(options.rings) +
      "; expected 1 to " + std::to_string(mostCurvatureRings));
  }
  if (options.degree != 2 && options.degree != 3)
  {
    throw std::invalid_argument("the degree is " + std::to_string(options.degree) + "; expected 2 or 3");
  }
  if (options.derivatives && (options.degree != 3 || options.estimator != CurvatureEstimator::Jet))
  {
    throw std::invalid_argument(
      "derivatives of curvature are asked for; expected the estimator Jet of degree 3");
  }
}

/// Whether noise is averaged away, and not fitted by more rings, as derivatives need.
bool diffuses(const CurvatureOptions& options)
{
  return options.estimator == CurvatureEstimator::Jet && options.adaptive && !options.derivatives &&
    options.rings >= RingFit::fewestRingsAtBorders;
}

/// Whether a fit to few rings says how much noise there is, and averages lessen it: residuals without degrees
/// of freedom say nothing, and noise that is not small compared to the neighborhood tilts the fits too much
/// for their forms to be added up in space.
bool canBeAveraged(const JetFit& fit)
{
  constexpr double mostNoise = 0.25; // of the reach
  return fit.residual < mostNoise * fit.reach;
}

CurvatureNoise noiseOf(const JetFit& fit, int mostPasses)
{
  // Somewhat more than wanted, since residuals of few points are not known well.
  constexpr double margin = 2.0;
  const double excess = fit.noiseExcess();
  const double passes = excess > 1.0 ? std::ceil(passesToDivideNoise(margin * excess)) : 0.0;
  return { fit.noise(), static_cast<std::uint8_t>(std::min<double>(passes, mostPasses)) };
}

/// What one thread needs.
struct Scratch
{
  explicit Scratch(std::size_t sites)
    : front(sites)
  {
  }
  RingFit::Front front;
  std::vector<glm::dvec3> ring;
  std::vector<UnfoldedPoint> unfolded;
};

} // namespace

int curvatureReach(const CurvatureOptions& options)
{
  if (options.estimator == CurvatureEstimator::ExponentialMap)
  {
    return 1;
  }
  const int diffused = RingFit::fewestRingsAtBorders + passesForRings(options.rings);
  return diffuses(options) ? std::max(options.rings, diffused) : options.rings;
}

namespace
{

/// The estimates at single sites, which go into one result.
class SiteCurvature
{
public:
  /// All are kept as references.
  SiteCurvature(const TriangleMesh& mesh, const SurfaceRings& rings, std::span<const glm::dvec3> up,
    const CurvatureOptions& options, MeshCurvature& result)
    : Mesh(mesh)
    , Rings(rings)
    , Up(up)
    , Options(options)
    , Result(result)
    , Fitter(mesh.points, rings, up, options)
    , Noise(diffuses(options) ? rings.size() : 0)
  {
  }

  const RingFit& fitter() const { return this->Fitter; }
  std::span<CurvatureNoise> noise() { return this->Noise; }

  void estimate(std::uint32_t site, Scratch& scratch)
  {
    const RingShape shape = this->Rings.shape(site);
    if (shape == RingShape::Isolated || glm::dot(this->Up[site], this->Up[site]) == 0.0)
    {
      return;
    }
    if (this->Options.estimator == CurvatureEstimator::Jet ? this->fitJet(site, scratch)
                                                           : this->fitPaper(site, scratch))
    {
      this->Result.sources[site] =
        shape == RingShape::Closed ? CurvatureSource::Surface : CurvatureSource::Border;
    }
  }

private:
  std::optional<JetFit> fitRings(std::uint32_t site, Scratch& scratch)
  {
    if (diffuses(this->Options))
    {
      const std::optional<JetFit> fit = this->Fitter.fitFewest(site, scratch.front);
      if (fit && canBeAveraged(*fit))
      {
        this->Noise[site] = noiseOf(*fit, this->MostPasses);
        return fit;
      }
    }
    return this->Fitter.fit(site, scratch.front);
  }

  bool fitJet(std::uint32_t site, Scratch& scratch)
  {
    if (const std::optional<JetFit> fit = this->fitRings(site, scratch))
    {
      this->Result.points[site] = fit->curvature;
      if (this->Options.derivatives)
      {
        this->Result.derivatives[site] = fit->derivative;
      }
      return true;
    }
    const std::optional<PrincipalCurvature> pinned = this->Fitter.fitPinned(site, scratch.front);
    this->Result.points[site] = pinned.value_or(PrincipalCurvature());
    return pinned.has_value();
  }

  /// As published, by the exponential map.
  bool fitPaper(std::uint32_t site, Scratch& scratch)
  {
    scratch.ring.clear();
    for (const std::uint32_t neighbor : this->Rings.ring(site))
    {
      scratch.ring.push_back(this->Mesh.points[neighbor] - this->Mesh.points[site]);
    }
    // The ring runs as its first triangle does, which may be seen from inside.
    glm::dvec3 area(0.0);
    for (std::size_t i = 0; i < scratch.ring.size(); ++i)
    {
      area += glm::cross(scratch.ring[i], scratch.ring[(i + 1) % scratch.ring.size()]);
    }
    if (glm::dot(area, this->Up[site]) < 0.0)
    {
      std::reverse(scratch.ring.begin(), scratch.ring.end());
    }
    return this->Rings.shape(site) == RingShape::Closed &&
      fitExponentialMap(scratch.ring, scratch.unfolded, this->Result.points[site]);
  }

  const TriangleMesh& Mesh;
  const SurfaceRings& Rings;
  std::span<const glm::dvec3> Up;
  const CurvatureOptions& Options;
  MeshCurvature& Result;
  const RingFit Fitter;
  const int MostPasses = passesForRings(Options.rings);
  std::vector<CurvatureNoise> Noise;
};

/// Points share what was found for their site.
void copyToPoints(const SurfaceRings& rings, MeshCurvature& result)
{
  for (std::size_t point = 0; point < result.points.size(); ++point)
  {
    if (const std::uint32_t site = rings.site(point); site != point)
    {
      result.points[point] = result.points[site];
      result.sources[point] = result.sources[site];
      if (!result.derivatives.empty())
      {
        result.derivatives[point] = result.derivatives[site];
      }
    }
  }
}

} // namespace

MeshCurvature estimateCurvature(const TriangleMesh& mesh, std::span<const glm::vec3> normals,
  const CurvatureOptions& options, const Progress& progress)
{
  checkOptions(mesh, normals, options);
  const SurfaceRings rings(mesh, options.seams);
  const std::size_t count = rings.size();
  const std::vector<glm::dvec3> up = siteNormals(mesh, rings, normals);
  MeshCurvature result;
  result.points.resize(count);
  result.sources.assign(count, CurvatureSource::None);
  result.derivatives.resize(options.derivatives ? count : 0);

  SiteCurvature sites(mesh, rings, up, options, result);
  tbb::enumerable_thread_specific<Scratch> scratches(count);
  const bool finished = parallelForChunks(
    count,
    [&](std::size_t, std::size_t begin, std::size_t end)
    {
      Scratch& scratch = scratches.local();
      for (std::size_t i = begin; i < end; ++i)
      {
        sites.estimate(static_cast<std::uint32_t>(i), scratch);
      }
    },
    pointsPerChunk, progress);
  if (!finished)
  {
    return {};
  }
  if (diffuses(options))
  {
    const std::vector<std::uint32_t> uneven = diffuseCurvature(rings, sites.noise(), result);
    // There residuals of wider fits tell noise from form.
    parallelForChunks(
      uneven.size(),
      [&](std::size_t, std::size_t begin, std::size_t end)
      {
        RingFit::Front& front = scratches.local().front;
        for (std::size_t i = begin; i < end; ++i)
        {
          if (const std::optional<JetFit> fit = sites.fitter().fit(uneven[i], front))
          {
            result.points[uneven[i]] = fit->curvature;
          }
        }
      },
      pointsPerChunk);
  }
  fillUnknown(rings, up, result);
  copyToPoints(rings, result);
  return result;
}

} // namespace ink
