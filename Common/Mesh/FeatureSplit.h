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
/// ... also from so far away, in diagonals of the surface's bounds, see MeshNavigation::cutFeatures: noise, and
/// stairs between the voxels of a binary volume, are rougher than that; parts that a picture shows are not.
inline constexpr double defaultFeatureReach = 0.02;

/// Cuts a surface's feature edges as all do who draw it.
/// @param angle in degrees; 180: none
void cutFeatures(MeshNavigation& navigation, double angle = defaultFeatureAngle);

/// A mesh that is cut open along the edges that cannot be crossed: each point stands for one fan of triangles
/// around a position, so that what is estimated at a point is of one smooth part of the surface. Where files
/// list a point several times along a seam that can be crossed, there is one.
struct FeatureSplit
{
  std::vector<Triangle> triangles;    ///< the mesh's, in its order; of those that are not usable a point three times
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

/// The unit normals of the split mesh's points: those of the mesh's points where one point's triangles are one
/// fan; else the mean of the fan's triangles by their angles at the point, so that long thin ones weigh no more
/// than others, to the side of the point's own.
/// @param mesh that was split
/// @param normals one per point of the mesh, unit length or zero
/// @param keepAtSeams whether they are kept where several points of the mesh share a fan, too
std::vector<glm::vec3> splitNormals(const FeatureSplit& split, const TriangleMesh& mesh,
  std::span<const glm::vec3> normals, bool keepAtSeams);

} // namespace ink
