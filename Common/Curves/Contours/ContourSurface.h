// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/LargePages.h"
#include "Curves/Contours/Eye.h"
#include "Mesh/TriangleMesh.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace ink
{

/// A mesh as contours are found on it: its faces in Morton order, its points in the order in which these
/// first use them, and those of equal position and normal welded, since files repeat points along seams.
/// Faces with a point that is not finite or that occurs twice are left out.
struct ContourSurface
{
  /// A point with a normal; where the normals of a position differ, as along the edges of a cube, it has
  /// several corners.
  struct Corner
  {
    glm::dvec3 position;
    glm::vec3 normal; ///< unit length, or zero where nothing tells
  };
  /// Faces by their three corners.
  LargePageVector<Triangle> faces;
  std::vector<std::uint32_t> faceIds; ///< of each face, its triangle in the mesh
  LargePageVector<Corner> corners;
  std::vector<std::uint32_t> sites;   ///< of each corner, the first corner at its position
  std::vector<glm::vec3> siteNormals; ///< of each corner, the mean at its position; empty if none differ
  /// Whether the normals point into the volume that the surface encloses, as those of meshes do whose faces
  /// run the other way round.
  bool isInsideOut = false;
  /// Whether each edge has an even number of faces, but for a chance of 2^-64.
  bool isClosed = false;

  /// @param pointNormals one per point, of any length; a zero normal, or one that is not finite, is replaced
  ///   by the mean of those around, and all are by the mean of the faces around each position if there are
  ///   none
  /// @throws std::invalid_argument if there are normals, but not one per point
  ContourSurface(const TriangleMesh& mesh, std::span<const glm::vec3> pointNormals);

  /// The area vector of a face: twice its area long, to the side from which its corners run
  /// counterclockwise.
  glm::dvec3 areaVector(std::uint32_t face) const;
  /// Its direction; of a face without area, that of its corners' normals, or zero.
  glm::dvec3 faceNormal(std::uint32_t face) const;

  /// The surface's normal at a corner's position, unit length: the mean of its corners' normals.
  glm::vec3 siteNormal(std::uint32_t corner) const
  {
    return this->siteNormals.empty() ? this->corners[corner].normal : this->siteNormals[corner];
  }

  /// n.v of a corner for an eye; its sign tells which side the eye sees.
  double facing(std::uint32_t corner, const Eye& eye) const
  {
    return glm::dot(glm::dvec3(this->corners[corner].normal), eye.from(this->corners[corner].position));
  }

private:
  void completeNormals(bool all);
  void averageAtSites();
  bool pointsInwards() const;
  bool hasNoBorder() const;
};

/// Whether the eye is in front: an n.v of exactly 0 counts as more than 0 everywhere, so that contours never
/// run through a corner and never break there (simulation of simplicity, Edelsbrunner and Mücke 1990).
inline bool isFront(double facing)
{
  return facing >= 0.0;
}

} // namespace ink
