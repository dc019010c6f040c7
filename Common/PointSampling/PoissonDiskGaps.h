// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PointSampling/PoissonDiskBins.h"

#include <glm/vec2.hpp>

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace ink
{

/// A candidate for a sample.
struct PoissonDiskDart
{
  SurfaceSample sample;
  float radius; ///< 0: no sample is allowed there
  glm::vec3 position;
};

/// Fills the voids that the discs of a bin leave: bisects triangles until each part lies in a disc or is
/// small, and makes samples in the uncovered parts (after Cline et al. 2009, section 3).
class PoissonDiskGaps
{
public:
  using RadiusAt = std::function<float(const SurfaceSample& sample)>;
  using Make = std::function<void(const PoissonDiskDart& dart)>;

  /// @param radiusAt the radius of a sample at a position, at least 1; 0: no sample allowed
  /// @param make called for each sample; adds its disc to the bins
  /// @param smallest relative to the radius: narrower parts are not subdivided
  PoissonDiskGaps(const PoissonDiskBins& bins, const RadiusAt& radiusAt, float smallest, const Make& make);

  /// Fills one bin; `random` is the bin's hash.
  void fill(const PoissonDiskBins::Open& bin, std::uint64_t random);

private:
  struct Corner
  {
    glm::vec3 position;
    glm::vec2 barycentric; // b1 and b2 of a SurfaceSample
    std::uint64_t discs;   // one bit for each of the first 64: whether it contains the corner
  };
  using Part = std::array<Corner, 3>;

  /// @param known the number of discs already tested against the corners
  void fill(Part part, std::size_t known, std::uint64_t random);
  /// Makes a sample at a position in a part, in coordinates from (0, 0) to (1, 0) and (0, 1), unless another
  /// is too close.
  bool tryAt(const Part& part, const glm::vec2& weights);
  void findDiscs(Corner& corner, std::size_t first, float radius) const;

  const PoissonDiskBins& Bins;
  const RadiusAt& Radius;
  float Smallest;
  const Make& MakeSample;
  std::uint32_t Triangle = 0;
  std::vector<PoissonDiskBins::Disc> Discs; // of the bin
};

} // namespace ink
