// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Curves/Streamlines/LineField.h"
#include "Curves/Streamlines/StreamlineCell.h"
#include "Curves/Streamlines/TracedLine.h"
#include "Mesh/MeshNavigation.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <optional>
#include <utility>

namespace ink
{

/// A line on its way over a mesh, from triangle to triangle.
class MeshWalk
{
public:
  /// The mesh and the field are viewed and have to live as long.
  /// @param curves whether steps are of Runge and Kutta's in place of Euler's
  MeshWalk(const MeshNavigation& mesh, const LineField& field, bool curves, const MeshPoint& seed,
    const glm::dvec3& heading);

  const MeshPoint& at() const { return this->At; }
  const StreamlineCell& cell() const { return this->Cell; }
  /// Whether an edge, by the corner opposite, is the one that the line came in by: one that leads back there
  /// is followed.
  bool cameInBy(int corner) const { return this->Entry == corner; }

  /// The corner whose opposite edge the point is on while the direction leads out by it; -1 if none.
  int cornerBehind(const glm::dvec2& direction) const;
  /// Takes a step inside the triangle, or up to an edge of it.
  /// @return the corner opposite the edge; -1 if still inside
  int step(const glm::dvec2& direction, double length);
  /// Moves along the edge opposite a corner.
  /// @return false if the direction is at right angles to it
  bool slide(int corner, const glm::dvec2& direction, double length);
  /// The corner that the point is at; -1 if none.
  int vertex() const;
  /// Goes on in the triangle around a corner that the direction points into.
  /// @return why the line ends; nothing if it goes on, as for the next one
  std::optional<LineEnd> leaveVertex(int corner, const glm::dvec3& heading);
  /// Goes on behind the edge opposite a corner.
  std::optional<LineEnd> leaveByEdge(int corner, const glm::dvec2& direction);

private:
  /// The share of a step to new coordinates after which it leaves the triangle, and the corner opposite the
  /// edge that it leaves by; -1 if it stays inside.
  std::pair<double, int> exit(const glm::dvec3& next) const;

  const MeshNavigation& Mesh;
  const LineField& Field;
  bool Curves;
  MeshPoint At;
  StreamlineCell Cell;
  int Entry = -1;
};

} // namespace ink
