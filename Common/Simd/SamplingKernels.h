// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Simd/BrickView.h"
#include "Simd/VoxelFill.h"

#include <cstddef>
#include <cstdint>

/// The inner loops of iso-surface sampling, of placing stipples and of finding contours, compiled once for
/// each instruction set and chosen at run time. Internal to Common/Simd.
///
/// Everything here is plain data and pointers to functions: the sources compiled for an instruction set
/// include nothing else, because an inline function that they shared with others could be the one that the
/// linker keeps, and would stop a machine without those instructions. All sets do the same operations in the
/// same order, without fused multiply-adds, so all give the same bits.
namespace ink
{

/// How a sample's normal is found.
enum class NormalMethod
{
  /// The gradient of the trilinear interpolation of the cell's own eight samples.
  Cell,
  /// The trilinear interpolation of the gradients that central differences give the corners.
  InterpolatedGradient,
  /// The trilinear interpolation of the unit vectors along these gradients (Zhang et al. 2014, section 5.1).
  InterpolatedNormal,
  /// As CentralDifference, with gradients by linear regression over each corner's 26 neighbors with equal
  /// weights (Neumann et al. 2000, as Lu et al. 2003, section 4.1, use it).
  Regression
};

/// How many cells are worked on at once; a multiple of what any instruction set takes in one instruction.
constexpr int BatchSize = 64;
/// What a row of a batch has room for: the loops write whole vectors, past the last cell.
constexpr int BatchStride = BatchSize + 16;

/// The samples that a cell's point and normal depend on: its 8 corners, corner c being on the upper side
/// along axis a where bit a of c is set, and the two outer neighbors of each of its 12 edges, along that
/// edge. Edge n of the four that run along an axis is on the upper side of the first axis across where bit 0
/// of n is set, and of the second where bit 1 is.
constexpr int Corners = 8;
constexpr int Edges = 12;
constexpr int StencilSize = Corners + 2 * Edges;
/// All 4 x 4 x 4 samples around a cell, x running fastest, as NormalMethod::Regression wants them.
constexpr int WideStencilSize = 64;

/// Some cells, one in each column, and what was found out about them. Real is float or double.
template <class Real>
struct CellBatch
{
  /// In: the stencils; their rows are numbered as above.
  alignas(64) Real values[WideStencilSize][BatchStride];
  /// In: where the cells' first corners lie.
  alignas(64) Real corners[3][BatchStride];
  /// Out: the mean of the surface's intersections with the cell's edges, in the unit cell and in the world.
  alignas(64) Real means[3][BatchStride];
  alignas(64) Real points[3][BatchStride];
  /// Out: unit vectors towards smaller values.
  alignas(64) float normals[3][BatchStride];
};

/// What the loops need to know of the surface and the grid.
template <class Real>
struct KernelParameters
{
  /// A value's distance from the iso-value is (value - base) - rest; base is close to the iso-value and rest
  /// what is left of it.
  Real base;
  Real rest;
  /// A value is at or above the iso-value when it is >= atLeast, and above it when it is >= above.
  Real atLeast;
  Real above;
  /// Ask for the range of the distances from the iso-value.
  bool checkRange;
  /// Column by column: index steps to world steps.
  Real step[3][3];
  /// Column by column: takes a gradient per sample step to a vector along the world's gradient.
  Real direction[3][3];
  /// xx, yy, zz, 2 xy, 2 xz, 2 yz of direction transposed times direction, which gives that vector's square.
  Real square[6];
};

/// What `direction` and `step` are.
enum class GridAxes
{
  Cubic,   ///< the one the identity, the other diagonal
  Aligned, ///< both diagonal
  General
};

/// Up to so many cells that follow each other along x, in the grid as in a batch.
constexpr int SegmentSize = 8;
struct CellSegment
{
  std::int32_t x; ///< the first cell
  std::int32_t y;
  std::int32_t z;
  std::int16_t lane; ///< where the first cell stands in the batch
  std::int8_t cells;
  /// Bits 0 to 3: the cells are the first along y, the last, the first along z, the last.
  std::int8_t sides;
};

/// Up to 64 cells in a row: bit b of a word stands for the cell (x + b, y, z).
struct RunPosition
{
  std::int32_t x;
  std::int32_t y;
  std::int32_t z;
  std::int32_t sides;    ///< as in CellSegment
  std::ptrdiff_t offset; ///< of the first cell's first corner in the array
  std::ptrdiff_t step;   ///< to the next cell's
};

/// Some cells, in the order of a batch.
struct SegmentList
{
  CellSegment segments[BatchSize];
  /// Where the cells' first corners are in the array.
  std::ptrdiff_t offsets[BatchStride];
  std::int32_t segmentCount;
  std::int32_t count; ///< cells
};

/// The samples around some cells: a cell's first corner is at data[offsets[n]], and its neighbors lie at
/// these distances from it.
template <class T>
struct StencilSource
{
  const T* data;
  const std::ptrdiff_t* offsets; ///< readable up to BatchStride of them
  std::ptrdiff_t y;
  std::ptrdiff_t z;
  /// Distances to the samples before and after the cell, for each cell; null: -y, 2 y, -z, 2 z. They stay
  /// inside the grid where the neighbor does not.
  const std::ptrdiff_t* border[4];
  const CellSegment* segments;
  int segmentCount;
};
/// Rows of samples are read by vectors that reach up to so far from a cell's first corner on.
constexpr int StencilReach = 15;

/// One block of up to four rows of samples to classify.
template <class T>
struct RowBlock
{
  const T* first;
  std::ptrdiff_t stride; ///< from row to row
  int rows;
  int samples;         ///< in a row
  std::ptrdiff_t next; ///< to the block of the next layer
};

/// The samples of a brick, see MinMaxBricks.
template <class T>
constexpr int BrickLength = sizeof(T) <= 2 ? 32 : 16;
constexpr int BrickWidth = 4;

/// What a function that classifies found, in one number.
enum ClassFlags : int
{
  SomeSet = 1,
  SomeClear = 2,
  MaybeMissing = 4 ///< a sample may be NaN or infinite
};

/// Functions for samples of the type T. Those that classify return ClassFlags.
template <class T>
struct TypedKernels
{
  /// Sets bit n of a row of words where sample n is >= lowest, and clears the rest of the last word. `reach`
  /// words lie from row to row.
  int (*classify)(const RowBlock<T>& rows, T lowest, std::uint64_t* words, std::ptrdiff_t reach);
  /// The same, and the least and largest values of each brick's part of the block to low and high, which are
  /// NaN where a sample may be NaN or infinite.
  int (*classifyAndMeasure)(
    const RowBlock<T>& rows, T lowest, std::uint64_t* words, std::ptrdiff_t reach, T* low, T* high);
  /// Reads only the bricks whose state is 2; those of the others are all set (1) or clear (0).
  int (*classifyMixed)(const RowBlock<T>& rows, T lowest, const std::uint8_t* states, std::uint64_t* words,
    std::ptrdiff_t reach);
  /// The state of each brick with these ranges: 0 below, 1 at or above `lowest`, 2 both or not known.
  /// @return 0 or 1 where all are, else 2
  int (*judge)(const T* low, const T* high, int count, T lowest, std::uint8_t* states);
  /// Loads what a NormalMethod needs of the stencils of `count` cells; null for types that float does not
  /// hold exactly.
  void (*load[4])(const StencilSource<T>& source, int count, CellBatch<float>& batch);
  /// Looks at the samples of a brick; null for integers that double does not hold exactly.
  /// @return whether all is finite: otherwise samples or their neighbors may be missing
  bool (*view)(const BrickSource<T>& source, BrickView& view);
};

template <class Real>
struct PlaceKernels
{
  /// values -> means -> points, for the rule HalfOpen or Strict. Regression has its corners elsewhere.
  /// @return a bit for each cell whose numbers are too large or too small for what follows, if asked for
  std::uint64_t (*findPoints[2][2][3])(
    CellBatch<Real>& batch, const KernelParameters<Real>& terms, int count);
  /// values and means -> normals, by NormalMethod and GridAxes.
  /// @return a bit for each cell whose normal is not finite, or is the rounding of vectors that cancel
  std::uint64_t (*findNormals[4][3])(CellBatch<Real>& batch, const KernelParameters<Real>& terms, int count);
};

struct SamplingKernels
{
  const char* name;

  TypedKernels<std::int8_t> i8;
  TypedKernels<std::uint8_t> u8;
  TypedKernels<std::int16_t> i16;
  TypedKernels<std::uint16_t> u16;
  TypedKernels<std::int32_t> i32;
  TypedKernels<std::uint32_t> u32;
  TypedKernels<std::int64_t> i64;
  TypedKernels<std::uint64_t> u64;
  TypedKernels<float> f32;
  TypedKernels<double> f64;

  PlaceKernels<float> single;
  PlaceKernels<double> precise;

  /// The cells of `rows` rows between two layers of samples that have corners on both sides. From row to row
  /// lie `reach` words, more than `words`; of the samples one more row and one more word are read.
  void (*activeRows)(const std::uint64_t* lower, const std::uint64_t* upper, std::ptrdiff_t reach, int rows,
    int words, std::uint64_t* active);
  /// Appends cells of a run to a list, up to BatchSize cells in all.
  /// @return the cells that the list had no room for
  std::uint64_t (*listCells)(std::uint64_t cells, const RunPosition& run, SegmentList& list);
  /// Writes where the cells' first corners are, by the world's x of samples by i and so on; these are
  /// readable SegmentSize further.
  void (*findCorners)(
    const SegmentList& list, const float* x, const float* y, const float* z, CellBatch<float>& batch);
  /// Writes x y z of `count` columns one after the other.
  void (*interleave)(const float* x, const float* y, const float* z, int count, float* xyz);

  /// Places a voxel's stipples.
  void (*fillVoxel)(const VoxelFill& voxel);
};

/// The kernels of the best set that this machine has, or of the set that the environment variable
/// VTKINK_INSTRUCTION_SET names (baseline, avx2, avx512) if the machine has it. Chosen once.
const SamplingKernels& samplingKernels();

/// The kernels of a set by its name; null when this machine or this build lacks it.
const SamplingKernels* samplingKernelsOf(const char* name);

/// Makes samplingKernels() return the given set from now on; null: what it chooses itself. For tests: not to
/// be called while others sample.
void useSamplingKernels(const SamplingKernels* kernels);

} // namespace ink
