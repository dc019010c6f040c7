// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Curvature/PrincipalCurvature.h"
#include "Mesh/TriangleMesh.h"

#include <glm/vec3.hpp>

#include <span>
#include <vector>

namespace ink
{

/// How a surface bends at large: second fundamental forms, as tensors of space, averaged over a distance,
/// weighted by area. Bumps that are smaller cancel out, as a form's mean is how much normals turn from one
/// end to the other.
///
/// Forms are summed up in a grid that is a width apart, in six layers by where normals point, and read from
/// it with linear weights (as in a bilateral grid, Chen, Paris and Durand 2007): the work does not grow with
/// the width, and the sides of a thin wall do not mix. The kernel is the convolution of two tents; its
/// standard deviation is .6 of the width.
///
/// @param mesh each triangle's points exist
/// @param normals one per point, unit length or zero
/// @param curvatures one per point, in its tangent plane; what is not finite counts as flat
/// @param width in world units, above 0
/// @param most larger curvatures count as this, in 1 / world unit: so a crease does not drown all around it
/// @return one per point; {} where the normal is zero or no triangle is around. The same for any number of
///   threads.
/// @throws std::invalid_argument if a span has not one entry per point
std::vector<PrincipalCurvature> averagedCurvature(const TriangleMesh& mesh,
  std::span<const glm::vec3> normals, std::span<const PrincipalCurvature> curvatures, double width,
  double most);

} // namespace ink
