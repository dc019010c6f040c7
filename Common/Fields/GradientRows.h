#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace ink
{

/// The loops behind ink::estimateGradients, over the samples of one row at a time, in plain steps that
/// compilers turn into vector instructions. Work is float or double.

/// How many samples the functions here take at most.
inline constexpr std::size_t rowChunk = 512;

/// The rows around a row of a grid, each pointing at the sample with the same x: row (b, c), b and c steps
/// away along y and z, is at [c + 2][b + 2]. Null where the grid has none.
template <class Work>
using RowsAround = std::array<std::array<const Work*, 5>, 5>;

/// Derivatives per sample step, and values.
template <class Work>
struct IndexGradients
{
  std::array<Work, rowChunk> x;
  std::array<Work, rowChunk> y;
  std::array<Work, rowChunk> z;
  std::array<Work, rowChunk> value;
};

/// Central differences; `value` becomes the samples' own.
template <class Work>
void differentiateRows(const RowsAround<Work>& rows, std::size_t count, IndexGradients<Work>& to);

/// A regression with equal weights, radius 1 or 2. All rows must be there.
template <class Work>
void fitUniformRows(int radius, const RowsAround<Work>& rows, std::size_t count, IndexGradients<Work>& to);

/// The coefficients of a regression whose weights do not change when an axis is mirrored, for samples by the
/// absolute value of their offset: [|c|][|b|][|a|].
template <class Work>
struct MirroredKernel
{
  using Octant = std::array<std::array<std::array<Work, 3>, 3>, 3>;
  Octant x{};
  Octant y{};
  Octant z{};
  Octant value{};
};

/// A regression with such weights, radius 1 or 2. All rows must be there.
template <class Work>
void fitMirroredRows(int radius, const MirroredKernel<Work>& kernel, const RowsAround<Work>& rows,
  std::size_t count, IndexGradients<Work>& to);

/// One coefficient for each of gradient and value at an offset.
template <class Work>
struct RowTap
{
  glm::ivec3 offset;
  glm::vec<3, Work> gradient;
  Work value;
};

/// Any linear estimate, as a sum over differences from the sample in the middle. The rows of all offsets must
/// be there.
template <class Work>
void convolveRows(std::span<const RowTap<Work>> taps, const RowsAround<Work>& rows, std::size_t count,
  IndexGradients<Work>& to);

/// Where world gradients go; null for what is not wanted.
template <class Real>
struct GradientPointers
{
  Real* gradient;
  Real* magnitude;
  Real* value;
};

/// Writes world gradients, toWorld times the derivatives per sample step, no larger than Real can hold.
template <class Work, class Real>
void storeRows(const IndexGradients<Work>& from, const glm::mat<3, 3, Work>& toWorld, std::size_t count,
  const GradientPointers<Real>& to);

} // namespace ink
