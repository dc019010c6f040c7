// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Curves/Polylines.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace ink
{

/// What makes a curve on a surface worth drawing.
enum class ContourKind : std::uint8_t
{
  Silhouette,  ///< occluding contour: the normal is orthogonal to the direction to the eye
  Crease,      ///< an edge between two faces at an angle
  Border,      ///< an edge of one face
  NonManifold, ///< an edge of more than two faces
};

/// Which of the arrays of Contours are filled, beside positions and kinds.
struct ContourArrays
{
  bool normals = false;
  bool radialCurvature = false;
  bool arcLength = false;
  bool elements = false;
};

/// The contours of a surface for one eye: chains of points, each of one kind, in an order that follows from
/// the surface and the eye alone. Arrays other than `positions` and `kinds` are empty unless asked for.
struct Contours
{
  Polylines chains;
  std::vector<ContourKind> kinds;    ///< one per chain
  std::vector<glm::dvec3> positions; ///< one per point, as all that follow
  std::vector<glm::vec3> normals;    ///< of the surface, unit length
  /// Normal curvature in the direction to the eye, in 1 / world unit: positive where the surface bends away
  /// from the eye on both sides (a visible contour, if nothing is in front), negative where the contour is
  /// hidden by the surface itself. 0 on what is no silhouette.
  std::vector<float> radialCurvature;
  std::vector<double> arcLength; ///< from the chain's first point, in world units
  std::vector<std::int64_t>
    elements; ///< the face or cell, by its index in the surface, that the segment to the next point lies in;
              ///< an open chain's last point repeats the one before
};

/// Appends contours, with those of their arrays that are asked for, which both have.
void appendContours(Contours& to, const Contours& from, const ContourArrays& arrays);

} // namespace ink
