#pragma once

#include "Sampling/BlueNoiseBins.h"

#include <glm/vec2.hpp>

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace ink
{

/// A place for a sample.
struct BlueNoiseDart
{
  SurfaceSample sample;
  float radius; ///< 0: no sample may be there
  glm::vec3 position;
};

/// Looks for what the discs of a bin leave open, and makes samples there: halves triangles until each part
/// lies in a disc or is small (after Cline et al. 2009, section 3).
class BlueNoiseGaps
{
public:
  using RadiusAt = std::function<float(const SurfaceSample& place)>;
  using Make = std::function<void(const BlueNoiseDart& dart)>;

  /// @param radiusAt the radius of a sample at a place, at least 1; or 0, for none
  /// @param make called for each sample made; adds its disc to the bins
  /// @param smallest of the radius: what is narrower is not looked into
  BlueNoiseGaps(const BlueNoiseBins& bins, const RadiusAt& radiusAt, float smallest, const Make& make);

  /// Fills one bin; `random` is the bin's own.
  void fill(const BlueNoiseBins::Open& bin, std::uint64_t random);

private:
  struct Corner
  {
    glm::vec3 position;
    glm::vec2 barycentric; // b1 and b2 of a SurfaceSample
    std::uint64_t discs;   // that contain it, a bit for each of the first 64
  };
  using Part = std::array<Corner, 3>;

  /// @param known how many discs the corners know of
  void fill(Part part, std::size_t known, std::uint64_t random);
  /// Makes a sample at a place of a part, (0, 0) to (1, 0) and (0, 1), unless one is too near.
  bool tryAt(const Part& part, const glm::vec2& place);
  void findDiscs(Corner& corner, std::size_t first, float radius) const;

  const BlueNoiseBins& Bins;
  const RadiusAt& Radius;
  float Smallest;
  const Make& MakeSample;
  std::uint32_t Triangle = 0;
  std::vector<BlueNoiseBins::Disc> Discs; // of the bin
};

} // namespace ink
