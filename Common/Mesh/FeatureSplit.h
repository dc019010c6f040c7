// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Mesh/MeshNavigation.h"
#include "Mesh/TriangleMesh.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace ink
{

/// Which edges are features: those whose triangles' normals enclose more than so many degrees ...
inline constexpr double defaultFeatureAngle = 40.0;
/// ... also from so far away, in diagonals of the surface's bounds, see MeshNavigation::cutFeatures: noise,
/// and stairs between the voxels of a binary volume, are rougher than that; parts that a picture shows are
/// not.
inline constexpr double defaultFeatureReach = 0.02;

/// Cuts a surface's feature edges (MeshNavigation::cutFeatures), but none of a connected part on which they
/// would be denser than the reach can tell apart, so that their length times the reach is more than
/// `mostFeatures` of the area: the part is rough. Others, as the casing around a heat sink, have theirs.
/// @param angle in degrees; 180: none
/// @param reach in world units
void cutFeatures(MeshNavigation& navigation, double angle, double reach);
inline constexpr double mostFeatures = 1.5;

/// As all do who draw a surface.
void cutFeatures(MeshNavigation& navigation);

/// A mesh that is cut open along the edges that cannot be crossed: each point stands for one fan of triangles
/// around a position, so that what is estimated at a point is of one smooth part of the surface. Where files
/// list a point several times along a seam that can be crossed, there is one.
struct FeatureSplit
{
  std::vector<Triangle>
    triangles; ///< the mesh's, in its order; of those that are not usable a point three times
  std::vector<std::uint32_t> sources; ///< of each point here one of the mesh's, in ascending order of both

  /// A value of each point, from values of the mesh's.
  template <class Value>
  std::vector<Value> spread(std::span<const Value> values) const
  {
    std::vector<Value> result;
    result.reserve(this->sources.size());
    for (const std::uint32_t source : this->sources)
    {
      result.push_back(values[source]);
    }
    return result;
  }
};

/// The same for any number of threads.
FeatureSplit splitAtFeatures(const MeshNavigation& navigation);

/// The unit normals of the split mesh's points. Where a point of the mesh has one fan, that is its own
/// normal, or the mean of all that share the fan along a seam. Where it has several, its normal is of none of
/// them: theirs are the means of their triangles, weighted by their angles at the point, so that long thin
/// ones count no more than others, to the side of the point's own, or, where that is not the same one for
/// all, to that of nearly all other normals of its part, if there is one.
/// @param mesh that was split
/// @param normals one per point of the mesh, unit length or zero
std::vector<glm::vec3> splitNormals(
  const FeatureSplit& split, const TriangleMesh& mesh, std::span<const glm::vec3> normals);

/// Whether triangles at a common point enclose so much that an edge between them might be a feature: quickly,
/// and in doubt true. Points that only share a position have none in common.
/// @param normals one per point, unit length
bool mayHaveFeatures(
  const TriangleMesh& mesh, std::span<const glm::vec3> normals, double angle = defaultFeatureAngle);

} // namespace ink
