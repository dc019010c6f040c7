// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Curves/Streamlines/LineField.h"
#include "Curves/Streamlines/TracedLine.h"
#include "Mesh/MeshNavigation.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <limits>

namespace ink
{

enum class StreamlineIntegrator : std::uint8_t
{
  Euler,       ///< Rössl et al. 2000, equation 14
  RungeKutta4, ///< the classical one, of fourth order within a triangle
};

struct TraceOptions
{
  StreamlineIntegrator integrator = StreamlineIntegrator::RungeKutta4;
  double stepFactor = 0.5; ///< of the step that Rössl et al. 2000, equation 15, takes in each triangle
  double maximumStep = std::numeric_limits<double>::infinity(); ///< in world units
  /// Of a line; each of its halves, from the seed, has half of it.
  double maximumLength = std::numeric_limits<double>::infinity();
  double umbilicLimit = 1.0; ///< lines end where LineField::umbilics are more
  /// Whether lines end in triangles around which directions turn by half or (cross fields) a quarter of a
  /// turn: those that have an umbilic inside.
  bool stopAtSingularities = true;
  double closeDistance = 0.0; ///< a line that passes its start in this distance is closed
};

using TracedPoint = TracedPointOn<MeshPoint>;
using TracedLine = TracedLineOn<MeshPoint>;

/// Integrates a field of directions over a mesh (Rössl et al. 2000, section 2.2).
///
/// In a triangle, directions are interpolated linearly between its corners (equation 12), projected into its
/// plane (equation 13) and normalized. Where a step would leave the triangle the line is cut at the edge,
/// which is a point of it, and goes on in the triangle behind, whose directions are turned to its own. So
/// lines never leave the mesh. A line between two triangles that both lead to their common edge follows the
/// edge; one that meets a vertex goes on in the triangle around it that its direction points into.
class StreamlineTracer
{
public:
  /// The arguments are viewed and have to live as long.
  StreamlineTracer(const MeshNavigation& mesh, const LineField& field, const TraceOptions& options);

  using Accept = AcceptPoint<MeshPoint>;

  /// One half of a line.
  /// @param heading of the field's directions, the one closest to it is followed
  /// @param length at most, in world units
  LineEnd follow(const MeshPoint& seed, const glm::dvec3& heading, double length, const Accept& accept) const;

  /// Both halves, see traceHalves.
  TracedLine trace(const MeshPoint& seed, const glm::dvec3& heading, const Accept& accept) const;

  /// The interpolated direction that is closest to a vector, in the plane of the triangle; zero where there
  /// is none.
  glm::dvec3 direction(const MeshPoint& point, const glm::dvec3& heading) const;

private:
  const MeshNavigation& Mesh;
  const LineField& Field;
  TraceOptions Options;
};

} // namespace ink
