// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Progress.h"
#include "Curvature/PrincipalCurvature.h"
#include "Mesh/Seams.h"
#include "Mesh/TriangleMesh.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace ink
{

/// How the curvature of a mesh is estimated.
enum class CurvatureEstimator : std::uint8_t
{
  Jet,            ///< a polynomial over the tangent plane, fitted to the points around
  ExponentialMap, ///< Rössl et al. 2000, section 2.1: a Taylor polynomial of the 1-ring, unfolded
};

inline constexpr int mostCurvatureRings = 10;

struct CurvatureOptions
{
  CurvatureEstimator estimator = CurvatureEstimator::Jet;
  /// Of Jet: how many rings of edges around a point are fitted, 1 to mostCurvatureRings; the most if
  /// `adaptive`. More smooth out noise, and detail.
  int rings = 5;
  /// Of Jet: fit two rings, at borders three, and with three `rings` or more average away as much of the
  /// noise that is told from the residuals as wider fits would, see diffuseCurvature. Where the surface
  /// itself is uneven, or derivatives are wanted: take as few rings, from 2 on, as noise allows.
  bool adaptive = true;
  /// Of Jet: the degree of the polynomial, 2 or 3. 3 is better where points are irregular. Where `adaptive`
  /// takes more rings because of noise it is 2, unless derivatives are wanted: fewer coefficients are known
  /// better.
  int degree = 3;
  /// Whether `derivatives` are estimated; Jet with degree 3 only.
  bool derivatives = false;
  /// Whether neighborhoods go on where points of borders share a position, or are one-sided there, as on a
  /// mesh that splitAtFeatures has cut open.
  Seams seams = Seams::Joined;
};

/// Where the curvature of a point comes from.
enum class CurvatureSource : std::uint8_t
{
  Surface = 0,   ///< a fit to the surface on all sides
  Border = 1,    ///< a one-sided fit, or one across a non-manifold edge
  Neighbors = 2, ///< no fit of its own: the mean of the neighbors'
  None = 3,      ///< nothing known: zero curvature
};

/// The curvature of a mesh at its points: arrays of one entry per point, all of them finite.
struct MeshCurvature
{
  std::vector<PrincipalCurvature> points;
  std::vector<CurvatureSource> sources;
  std::vector<CurvatureDerivative> derivatives; ///< empty unless asked for
};

/// How many rings of edges around a point its curvature depends on; normals, on one more.
int curvatureReach(const CurvatureOptions& options);

/// Estimates the curvature at each point of a mesh, the same for any number of threads. The mesh need be
/// neither closed, oriented nor manifold.
/// @param normals one per point, of any length, out of the surface: they say on which side outside is. If
///   empty, it is where the triangles run counterclockwise.
/// @param progress when it asks to stop, the result is empty
/// @throws std::invalid_argument if there are normals, but not one per point, a triangle names a point that
///   does not exist, or an option is out of range
MeshCurvature estimateCurvature(const TriangleMesh& mesh, std::span<const glm::vec3> normals,
  const CurvatureOptions& options = {}, const Progress& progress = {});

} // namespace ink
