// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Curves/Streamlines/EvenStreamlines.h"
#include "Curves/Streamlines/LineSampleGrid.h"
#include "Curves/Streamlines/StreamlineTracer.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace ink
{

/// Where a line may start, and which way.
struct StreamlineCandidate
{
  std::uint64_t order; ///< lower ones come first
  MeshPoint at;
  glm::dvec3 heading;
};

/// A line that has been traced, with its samples and their points.
struct SpacedLine
{
  TracedLine line;
  std::vector<LineSample> samples;
  std::vector<std::size_t> points;
};

/// Traces lines that keep a distance from others and from themselves. Positions of samples are in spacings,
/// from the center of the mesh.
class SpacedTracer
{
public:
  /// The arguments are viewed and have to live as long.
  SpacedTracer(const MeshNavigation& mesh, std::span<const glm::vec3> normals, const LineField& field,
    const EvenStreamlineOptions& options);

  /// Sets the gap between the lines that are made, in spacings.
  void setGap(double gap);
  double gap() const { return this->Gap; }
  /// How close to other lines one may start, in spacings. Less than the gap: chords are shorter than the
  /// walks by which starts are found.
  float startDistance() const { return this->Start; }

  LineSample sampleOf(const MeshPoint& at, const glm::dvec3& position) const;
  /// The points of a line at which it is sampled: with its ends.
  std::vector<std::size_t> samplePoints(const TracedLine& line) const;
  /// The line of a candidate, up to where it comes close to other lines or to itself; nothing if that leaves
  /// no line.
  std::optional<SpacedLine> trace(const StreamlineCandidate& candidate, const LineSampleGrid& others) const;
  /// Cuts a line where it meets other ones.
  /// @return whether something is left
  bool cut(SpacedLine& spaced, const LineSampleGrid& others) const;

private:
  /// Samples with their arc lengths, in their order along a line.
  using ArcSamples = std::vector<std::pair<double, LineSample>>;

  bool isLongEnough(const TracedLine& line) const;
  /// Whether a sample is near one of the same line that is far from it along the line.
  bool meetsItself(const ArcSamples& own, double arc, const LineSample& sample) const;

  const MeshNavigation& Mesh;
  std::span<const glm::vec3> Normals;
  const EvenStreamlineOptions& Options;
  glm::dvec3 Center;
  StreamlineTracer Tracer;
  double Gap = 1.0;
  float Stop = 0.0f; ///< how close lines come to each other, in spacings
  float Start = 0.0f;
};

} // namespace ink
