// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Curvature/JetFit.h"
#include "Curvature/MeshCurvature.h"
#include "Curvature/SurfaceRings.h"
#include "Curvature/TangentPoints.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace ink
{

/// Fits polynomials to the rings around sites of a mesh.
class RingFit
{
public:
  /// One thread's state.
  class Front
  {
  public:
    explicit Front(std::size_t siteCount)
      : isReached(siteCount, 0)
    {
    }

  private:
    friend class RingFit;
    /// @return whether it was not reached before
    bool reach(std::uint32_t site)
    {
      std::uint8_t& mark = this->isReached[site];
      if (mark != 0)
      {
        return false;
      }
      mark = 1;
      return true;
    }

    TangentPoints points;                // of the last fit, in the order of rings
    std::vector<std::uint8_t> isReached; // of each site: by this search
    std::vector<std::uint32_t> sites;    // of this search
    std::vector<std::uint32_t> away;     // reached, but facing away from the start
    std::size_t begin = 0;               // of the sites, where the last ring begins
  };

  /// Keeps references to all of these.
  /// @param normals one per site, unit length
  RingFit(std::span<const glm::dvec3> points, const SurfaceRings& rings, std::span<const glm::dvec3> normals,
    const CurvatureOptions& options);

  /// How many rings are fitted at least, if as many are allowed: at borders one more than elsewhere, as three
  /// rows of points, one-sided, do not determine a polynomial of degree 3.
  static constexpr int fewestRings = 2;
  static constexpr int fewestRingsAtBorders = 3;

  /// The fit of the degree asked for to the fewest rings.
  /// @return nothing if they do not determine it
  std::optional<JetFit> fitFewest(std::uint32_t site, Front& front) const;

  /// The fit to the rings around a site. With adaptive rings, to the fewest in which noise changes curvature
  /// little; where more would leave much larger residuals, the surface and not its noise makes them, and the
  /// fewer are taken.
  /// @return nothing if no number of rings determines one
  std::optional<JetFit> fit(std::uint32_t site, Front& front) const;

  /// The same of fitPinnedQuadric to the first ring, whichever way its sites face: for what has too few
  /// points for a polynomial, as small polyhedra.
  std::optional<PrincipalCurvature> fitPinned(std::uint32_t site, Front& front) const;

private:
  int fewestRingsAt(std::uint32_t site) const;
  void start(std::uint32_t site, Front& front) const;
  void addRings(int count, Front& front) const;

  std::span<const glm::dvec3> Points;
  const SurfaceRings& Rings;
  std::span<const glm::dvec3> Normals;
  const CurvatureOptions& Options;
};

} // namespace ink
