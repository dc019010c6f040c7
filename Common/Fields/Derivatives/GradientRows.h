// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace ink
{

/// The loops behind ink::estimateGradients, over the samples of one row at a time, in a form that compilers
/// vectorize. Work is float or double.

/// The maximum number of samples per call.
inline constexpr std::size_t rowChunk = 512;

/// The rows around a row of a grid, as pointers to their samples at the same x: the row b and c steps away
/// along y and z is at [c + 2][b + 2]. Null outside the grid.
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

/// Central differences; `value` is a copy of the samples.
template <class Work>
void differentiateRows(const RowsAround<Work>& rows, std::size_t count, IndexGradients<Work>& to);

/// A regression with equal weights, radius 1 or 2. All rows must exist.
template <class Work>
void fitUniformRows(int radius, const RowsAround<Work>& rows, std::size_t count, IndexGradients<Work>& to);

/// The coefficients of a regression with mirror-symmetric weights, indexed by the absolute values of a
/// sample's offset: [|c|][|b|][|a|].
template <class Work>
struct MirroredKernel
{
  using Octant = std::array<std::array<std::array<Work, 3>, 3>, 3>;
  Octant x{};
  Octant y{};
  Octant z{};
  Octant value{};
};

/// A regression with such weights, radius 1 or 2. All rows must exist.
template <class Work>
void fitMirroredRows(int radius, const MirroredKernel<Work>& kernel, const RowsAround<Work>& rows,
  std::size_t count, IndexGradients<Work>& to);

/// The coefficients of gradient and value for one offset.
template <class Work>
struct RowTap
{
  glm::ivec3 offset;
  glm::vec<3, Work> gradient;
  Work value;
};

/// Any linear estimate, as a sum over differences from the central sample. The rows of all offsets must
/// exist.
template <class Work>
void convolveRows(std::span<const RowTap<Work>> taps, const RowsAround<Work>& rows, std::size_t count,
  IndexGradients<Work>& to);

/// Output arrays of world gradients; null for outputs that are not wanted.
template <class Real>
struct GradientPointers
{
  Real* gradient;
  Real* magnitude;
  Real* value;
};

/// Writes world gradients, toWorld times the derivatives per sample step, clamped to the range of Real.
template <class Work, class Real>
void storeRows(const IndexGradients<Work>& from, const glm::mat<3, 3, Work>& toWorld, std::size_t count,
  const GradientPointers<Real>& to);

} // namespace ink
