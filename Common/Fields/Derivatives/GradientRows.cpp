// SPDX-License-Identifier: BSD-3-Clause
#include "Fields/Derivatives/GradientRows.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace ink
{
namespace
{

/// The rows' samples at one x, relative to the rows' pointers.
template <class Work, int radius>
struct Column
{
  static constexpr int width = 2 * radius + 1;
  const Work* rows[width][width];

  explicit Column(const RowsAround<Work>& around)
  {
    for (int c = 0; c < width; ++c)
    {
      for (int b = 0; b < width; ++b)
      {
        this->rows[c][b] = around[c + 2 - radius][b + 2 - radius];
      }
    }
  }
};

/// Sum of samples times their offset: a regression's slope up to a factor. Computed from differences, so that
/// equal samples give exactly 0.
template <int radius, class Work>
Work slope(const Work* samples)
{
  if constexpr (radius == 1)
  {
    return samples[2] - samples[0];
  }
  else
  {
    const Work outer = samples[4] - samples[0];
    return outer + outer + (samples[3] - samples[1]);
  }
}

template <int radius, class Work>
Work sum(const Work* samples)
{
  Work total = samples[0];
  for (int n = 1; n < 2 * radius + 1; ++n)
  {
    total += samples[n];
  }
  return total;
}

template <class Work, int radius>
void fitUniform(const RowsAround<Work>& around, std::size_t count, IndexGradients<Work>& to)
{
  constexpr int width = 2 * radius + 1;
  const Column<Work, radius> column(around);
  // First across the rows: the sums of each plane of constant x, and their slopes along y and z.
  Work sums[rowChunk + 2 * radius];
  Work alongY[rowChunk + 2 * radius];
  Work alongZ[rowChunk + 2 * radius];
  const std::size_t padded = count + 2 * radius;
  for (std::size_t i = 0; i < padded; ++i)
  {
    Work sumOfSlice[width];
    Work slopeOfSlice[width];
    for (int c = 0; c < width; ++c)
    {
      Work samples[width];
      for (int b = 0; b < width; ++b)
      {
        samples[b] = column.rows[c][b][static_cast<std::ptrdiff_t>(i) - radius];
      }
      sumOfSlice[c] = sum<radius>(samples);
      slopeOfSlice[c] = slope<radius>(samples);
    }
    sums[i] = sum<radius>(sumOfSlice);
    alongY[i] = sum<radius>(slopeOfSlice);
    alongZ[i] = slope<radius>(sumOfSlice);
  }
  // Then along x. The factors are the reciprocals of the sums of squared offsets, and of ones.
  constexpr Work perSlope = Work(1) / (width * width * (radius == 1 ? 2 : 10));
  constexpr Work perSum = Work(1) / (width * width * width);
  for (std::size_t i = 0; i < count; ++i)
  {
    to.x[i] = slope<radius>(sums + i) * perSlope;
    to.y[i] = sum<radius>(alongY + i) * perSlope;
    to.z[i] = sum<radius>(alongZ + i) * perSlope;
    to.value[i] = sum<radius>(sums + i) * perSum;
  }
}

/// The weighted sum over absolute offsets across the rows; begin leaves out those that cancel.
template <int radius, class Work>
Work weigh(const std::array<std::array<std::array<Work, 3>, 3>, 3>& kernel, int a, int firstB, int firstC,
  const Work (&samples)[radius + 1][radius + 1])
{
  Work total = 0;
  for (int c = firstC; c <= radius; ++c)
  {
    for (int b = firstB; b <= radius; ++b)
    {
      total += kernel[c][b][a] * samples[c][b];
    }
  }
  return total;
}

template <class Work, int radius>
void fitMirrored(const MirroredKernel<Work>& kernel, const RowsAround<Work>& around, std::size_t count,
  IndexGradients<Work>& to)
{
  const Column<Work, radius> column(around);
  const MirroredKernel<Work> k = kernel;
  constexpr std::size_t padding = 2 * radius;
  Work alongX[radius + 1][rowChunk + padding];
  Work alongY[radius + 1][rowChunk + padding];
  Work alongZ[radius + 1][rowChunk + padding];
  Work value[radius + 1][rowChunk + padding];
  for (std::size_t i = 0; i < count + padding; ++i)
  {
    // Sums and differences of mirrored samples, first along y, then along z.
    Work even[2 * radius + 1][radius + 1];
    Work odd[2 * radius + 1][radius + 1];
    for (int c = 0; c < 2 * radius + 1; ++c)
    {
      const std::ptrdiff_t x = static_cast<std::ptrdiff_t>(i) - radius;
      even[c][0] = column.rows[c][radius][x];
      odd[c][0] = 0;
      for (int b = 1; b <= radius; ++b)
      {
        even[c][b] = column.rows[c][radius + b][x] + column.rows[c][radius - b][x];
        odd[c][b] = column.rows[c][radius + b][x] - column.rows[c][radius - b][x];
      }
    }
    Work both[radius + 1][radius + 1];
    Work oddY[radius + 1][radius + 1];
    Work oddZ[radius + 1][radius + 1];
    for (int b = 0; b <= radius; ++b)
    {
      both[0][b] = even[radius][b];
      oddY[0][b] = odd[radius][b];
      oddZ[0][b] = 0;
      for (int c = 1; c <= radius; ++c)
      {
        both[c][b] = even[radius + c][b] + even[radius - c][b];
        oddY[c][b] = odd[radius + c][b] + odd[radius - c][b];
        oddZ[c][b] = even[radius + c][b] - even[radius - c][b];
      }
    }
    for (int a = 0; a <= radius; ++a)
    {
      alongX[a][i] = weigh<radius>(k.x, a, 0, 0, both);
      alongY[a][i] = weigh<radius>(k.y, a, 1, 0, oddY);
      alongZ[a][i] = weigh<radius>(k.z, a, 0, 1, oddZ);
      value[a][i] = weigh<radius>(k.value, a, 0, 0, both);
    }
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::size_t middle = i + radius;
    Work x = 0;
    Work y = alongY[0][middle];
    Work z = alongZ[0][middle];
    Work v = value[0][middle];
    for (int a = 1; a <= radius; ++a)
    {
      x += alongX[a][middle + a] - alongX[a][middle - a];
      y += alongY[a][middle + a] + alongY[a][middle - a];
      z += alongZ[a][middle + a] + alongZ[a][middle - a];
      v += value[a][middle + a] + value[a][middle - a];
    }
    to.x[i] = x;
    to.y[i] = y;
    to.z[i] = z;
    to.value[i] = v;
  }
}

/// Clamps to the range of Real. The comparisons have the form of vector instructions.
template <class Real, class Work>
Work bounded(Work value)
{
  constexpr Work largest = static_cast<Work>(std::numeric_limits<Real>::max());
  const Work notTooLow = value > -largest ? value : -largest;
  return notTooLow < largest ? notTooLow : largest;
}

/// The length of a vector whose squares may overflow or underflow.
double carefulLength(double x, double y, double z)
{
  const double squared = x * x + y * y + z * z;
  constexpr double tiny = 1e-280;
  constexpr double huge = 1e300;
  return squared > tiny && squared < huge ? std::sqrt(squared) : std::hypot(x, y, z);
}

} // namespace

template <class Work>
void differentiateRows(const RowsAround<Work>& rows, std::size_t count, IndexGradients<Work>& to)
{
  const Work* const middle = rows[2][2];
  const Work* const below = rows[2][1];
  const Work* const above = rows[2][3];
  const Work* const before = rows[1][2];
  const Work* const after = rows[3][2];
  const Work half = Work(0.5);
  for (std::size_t i = 0; i < count; ++i)
  {
    to.x[i] = half * (middle[i + 1] - middle[static_cast<std::ptrdiff_t>(i) - 1]);
    to.y[i] = half * (above[i] - below[i]);
    to.z[i] = half * (after[i] - before[i]);
    to.value[i] = middle[i];
  }
}

template <class Work>
void fitUniformRows(int radius, const RowsAround<Work>& rows, std::size_t count, IndexGradients<Work>& to)
{
  radius == 1 ? fitUniform<Work, 1>(rows, count, to) : fitUniform<Work, 2>(rows, count, to);
}

template <class Work>
void fitMirroredRows(int radius, const MirroredKernel<Work>& kernel, const RowsAround<Work>& rows,
  std::size_t count, IndexGradients<Work>& to)
{
  radius == 1 ? fitMirrored<Work, 1>(kernel, rows, count, to) : fitMirrored<Work, 2>(kernel, rows, count, to);
}

template <class Work>
void convolveRows(std::span<const RowTap<Work>> taps, const RowsAround<Work>& rows, std::size_t count,
  IndexGradients<Work>& to)
{
  const Work* const middle = rows[2][2];
  if (count == 1)
  {
    // The same sums in registers.
    glm::vec<3, Work> gradient(0);
    Work value = middle[0];
    for (const RowTap<Work>& tap : taps)
    {
      const Work difference = rows[tap.offset.z + 2][tap.offset.y + 2][tap.offset.x] - middle[0];
      gradient += tap.gradient * difference;
      value += tap.value * difference;
    }
    to.x[0] = gradient.x;
    to.y[0] = gradient.y;
    to.z[0] = gradient.z;
    to.value[0] = value;
    return;
  }
  std::fill_n(to.x.begin(), count, Work(0));
  std::fill_n(to.y.begin(), count, Work(0));
  std::fill_n(to.z.begin(), count, Work(0));
  std::copy_n(middle, count, to.value.begin());
  for (const RowTap<Work>& tap : taps)
  {
    const Work* const row = rows[tap.offset.z + 2][tap.offset.y + 2] + tap.offset.x;
    for (std::size_t i = 0; i < count; ++i)
    {
      const Work difference = row[i] - middle[i];
      to.x[i] += tap.gradient.x * difference;
      to.y[i] += tap.gradient.y * difference;
      to.z[i] += tap.gradient.z * difference;
      to.value[i] += tap.value * difference;
    }
  }
}

template <class Work, class Real>
void storeRows(const IndexGradients<Work>& from, const glm::mat<3, 3, Work>& toWorld, std::size_t count,
  const GradientPointers<Real>& to)
{
  if (to.value)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      to.value[i] = static_cast<Real>(bounded<Real>(from.value[i]));
    }
  }
  if (!to.gradient && !to.magnitude)
  {
    return;
  }
  Work x[rowChunk];
  Work y[rowChunk];
  Work z[rowChunk];
  const bool straight = toWorld[0][1] == 0 && toWorld[0][2] == 0 && toWorld[1][0] == 0 &&
    toWorld[1][2] == 0 && toWorld[2][0] == 0 && toWorld[2][1] == 0;
  if (straight)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      x[i] = bounded<Real>(toWorld[0][0] * from.x[i]);
      y[i] = bounded<Real>(toWorld[1][1] * from.y[i]);
      z[i] = bounded<Real>(toWorld[2][2] * from.z[i]);
    }
  }
  else
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      x[i] = bounded<Real>(toWorld[0][0] * from.x[i] + toWorld[1][0] * from.y[i] + toWorld[2][0] * from.z[i]);
      y[i] = bounded<Real>(toWorld[0][1] * from.x[i] + toWorld[1][1] * from.y[i] + toWorld[2][1] * from.z[i]);
      z[i] = bounded<Real>(toWorld[0][2] * from.x[i] + toWorld[1][2] * from.y[i] + toWorld[2][2] * from.z[i]);
    }
  }
  if (to.gradient)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      to.gradient[3 * i] = static_cast<Real>(x[i]);
      to.gradient[3 * i + 1] = static_cast<Real>(y[i]);
      to.gradient[3 * i + 2] = static_cast<Real>(z[i]);
    }
  }
  if (to.magnitude)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      if constexpr (std::is_same_v<Work, float>)
      {
        // Squares of floats do not overflow in double.
        const double dx = x[i];
        const double dy = y[i];
        const double dz = z[i];
        to.magnitude[i] = static_cast<Real>(bounded<Real>(std::sqrt(dx * dx + dy * dy + dz * dz)));
      }
      else
      {
        to.magnitude[i] = static_cast<Real>(bounded<Real>(carefulLength(x[i], y[i], z[i])));
      }
    }
  }
}

#define INK_INSTANTIATE(Work)                                                                                \
  template void differentiateRows(const RowsAround<Work>&, std::size_t, IndexGradients<Work>&);              \
  template void fitUniformRows(int, const RowsAround<Work>&, std::size_t, IndexGradients<Work>&);            \
  template void fitMirroredRows(                                                                             \
    int, const MirroredKernel<Work>&, const RowsAround<Work>&, std::size_t, IndexGradients<Work>&);          \
  template void convolveRows(                                                                                \
    std::span<const RowTap<Work>>, const RowsAround<Work>&, std::size_t, IndexGradients<Work>&);
INK_INSTANTIATE(float)
INK_INSTANTIATE(double)
#undef INK_INSTANTIATE
template void storeRows(
  const IndexGradients<float>&, const glm::mat<3, 3, float>&, std::size_t, const GradientPointers<float>&);
template void storeRows(
  const IndexGradients<double>&, const glm::mat<3, 3, double>&, std::size_t, const GradientPointers<float>&);
template void storeRows(
  const IndexGradients<double>&, const glm::mat<3, 3, double>&, std::size_t, const GradientPointers<double>&);

} // namespace ink
