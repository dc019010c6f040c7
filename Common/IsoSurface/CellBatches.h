// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "IsoSurface/ActiveCells.h"
#include "Simd/SamplingKernels.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

/// Batches of active cells for the kernels. Internal to Common/IsoSurface.
namespace ink
{

/// The cells of one batch. Offsets past the last cell are readable, too.
struct SegmentBatch : SegmentList
{
  /// A bit for each cell that is the first or last of the grid along an axis.
  std::uint64_t sides[3][2];
  bool border = false; ///< one of those bits is set

  glm::ivec3 cell(int lane) const;
};

/// What all segments of a grid share.
class SegmentParameters
{
public:
  /// @param steps array strides between neighboring samples along x, y and z
  SegmentParameters(const glm::ivec3& samples, const std::ptrdiff_t (&steps)[3]);

private:
  friend class SegmentLister;

  glm::ivec3 Last; ///< the last cell along each axis
  std::ptrdiff_t Steps[3];
};

/// Lists the cells of some runs a batch at a time.
class SegmentLister
{
public:
  SegmentLister(
    const SegmentParameters& terms, const std::vector<CellRun>& runs, const SamplingKernels& kernels)
    : Terms(terms)
    , Runs(runs)
    , Kernels(kernels)
  {
  }

  /// The next cells, up to BatchSize of them; none after the last.
  void next(SegmentBatch& batch);

private:
  void enterRun(const CellRun& run);
  void markBorder(int firstSegment, SegmentBatch& batch) const;

  const SegmentParameters& Terms;
  const std::vector<CellRun>& Runs;
  const SamplingKernels& Kernels;
  std::size_t Entered = 0; ///< runs
  std::uint64_t Rest = 0;  ///< cells of the run that were not listed yet
  RunPosition Position = {};
  std::uint64_t Border = 0; ///< a bit for each cell of the run that lies at the grid's border
};

} // namespace ink
