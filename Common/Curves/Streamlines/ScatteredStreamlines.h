// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Progress.h"
#include "Curves/Streamlines/Streamlines.h"

#include <cstdint>
#include <span>
#include <vector>

namespace ink
{

struct AreaSeedOptions
{
  double count = 5000.0;   ///< about how many seeds there are on the whole mesh: n in the paper
  int mostInTriangle = 10; ///< m in the paper
  std::uint64_t seed = 0;
  /// Empty, or one per point of the mesh: triangles whose mean is at least `threshold` get `factor` times as
  /// many seeds.
  std::span<const float> curvature;
  double threshold = 0.0; ///< in 1 / world unit
  double factor = 1.0;
};

/// Seeds of lines by area (Rössl et al. 2000, section 3.1): m times in each triangle, a point falls with the
/// probability A_i / A n / m. The paper prints the opposite, and barycentric coordinates that leave the
/// triangle in half of all cases; these are folded back.
/// @param progress when it asks to stop, the result is empty
/// @return in the order of triangles, without those that have no area
/// @throws std::invalid_argument if there are curvatures, but not one per point, or a number is out of range
std::vector<MeshPoint> areaSeeds(
  const MeshNavigation& mesh, const AreaSeedOptions& options, const Progress& progress = {});

/// The lines of seeds, independent of each other, in an order by chance. Lines without length are left out.
/// @param options with a limit of length, which a line that is not closed may need to end
/// @param progress when it asks to stop, the result is empty
/// @throws std::invalid_argument if there is not one direction per point
Streamlines scatteredStreamlines(const MeshNavigation& mesh, const LineField& field,
  std::span<const MeshPoint> seeds, const TraceOptions& options, std::uint64_t seed,
  const Progress& progress = {});

} // namespace ink
