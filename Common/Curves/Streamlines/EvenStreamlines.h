// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Progress.h"
#include "Curves/Streamlines/Streamlines.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>

namespace ink
{

struct EvenStreamlineOptions
{
  /// How lines are integrated. The greatest step is at most a quarter of the spacing, and the distance at
  /// which lines are closed is a tenth of it where it is 0.
  TraceOptions trace;
  double spacing = 1.0;       ///< between neighboring lines, in world units
  double stopDistance = 0.5;  ///< how close a line comes to others, in spacings, in (0, 0.9]
  double minimumLength = 2.0; ///< shorter lines are left out, in spacings
  std::uint64_t seed = 0;
};

/// The same with the greatest step and the distance at which lines are closed that suit the spacing.
/// @param area of the surface, in world units squared
/// @throws std::invalid_argument if an option is out of range, or the surface needs more than 2^28 samples
EvenStreamlineOptions completeOptions(const EvenStreamlineOptions& options, double area);

/// Evenly spaced lines of a field of directions on a mesh (Jobard and Lefer 1997, there in the plane): a line
/// starts at a spacing's distance to the side of another one and ends where it comes closer than a share of
/// the spacing to another one or to itself. Starts are found by walking straight on over the surface, and
/// distances are those between samples of the lines whose normals say that they are on the same side of the
/// same sheet.
///
/// Lines are made from coarse to fine, each time at half the spacing before, in the order of priority: those
/// of one spacing are in an order that spreads them over the surface. Starts that are given neither by
/// lines nor by chance are where the field is defined best, so that lines run from there to where it is not.
///
/// The result is the same for any number of threads, see StreamlinePlacement.
///
/// @param normals of unit length, one per point of the mesh, or empty
/// @param progress when it asks to stop, the result is empty
/// @throws std::invalid_argument if an option is out of range, a span has not one entry per point, or the
///   surface needs more than 2^28 samples at that spacing
Streamlines evenStreamlines(const MeshNavigation& mesh, std::span<const glm::vec3> normals,
  const LineField& field, const EvenStreamlineOptions& options, const Progress& progress = {});

} // namespace ink
