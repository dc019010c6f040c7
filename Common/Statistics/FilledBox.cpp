// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/FilledBox.h"

#include "Core/ParallelFor.h"
#include "Fields/ScalarDifference.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace ink
{
namespace
{

constexpr double filledShare = 0.97;

struct Box
{
  std::array<int, 3> first;
  std::array<int, 3> last{ -1, -1, -1 };
  std::int64_t voxels = 0;

  void add(const std::array<int, 3>& begin, const std::array<int, 3>& end, std::int64_t count)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      this->first[axis] = std::min(this->first[axis], begin[axis]);
      this->last[axis] = std::max(this->last[axis], end[axis]);
    }
    this->voxels += count;
  }

  double size() const
  {
    double size = 1.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      size *= this->last[axis] - this->first[axis] + 1;
    }
    return size;
  }
};

} // namespace

template <typename T>
std::optional<std::array<int, 6>> findFilledBox(
  const SliceReader<T>& read, const std::array<int, 3>& dimensions, int slicesAtOnce, double value)
{
  const auto [nx, ny, nz] = dimensions;
  const std::size_t slice = static_cast<std::size_t>(nx) * ny;
  std::vector<Box> boxes(static_cast<std::size_t>(nz), Box{ dimensions });
  for (int first = 0; first < nz; first += slicesAtOnce)
  {
    const auto count = static_cast<std::size_t>(std::min(slicesAtOnce, nz - first));
    const std::span<const T> values = read(first, first + static_cast<int>(count));
    if (values.size() != slice * count)
    {
      throw std::invalid_argument("findFilledBox: " + std::to_string(values.size()) +
        " values, but expected " + std::to_string(slice * count));
    }
    parallelFor(count,
      [&, width = nx, height = ny](std::size_t n)
      {
        const int z = first + static_cast<int>(n);
        const auto isAbove = [value](T one) { return static_cast<double>(one) > value; };
        for (int y = 0; y < height; ++y)
        {
          const auto row = values.subspan(n * slice + static_cast<std::size_t>(y) * width, width);
          const auto begin = std::find_if(row.begin(), row.end(), isAbove);
          if (begin != row.end())
          {
            const auto end = std::find_if(row.rbegin(), row.rend(), isAbove);
            boxes[static_cast<std::size_t>(z)].add({ static_cast<int>(begin - row.begin()), y, z },
              { static_cast<int>(row.rend() - end) - 1, y, z }, std::count_if(begin, row.end(), isAbove));
          }
        }
      });
  }
  Box all{ dimensions };
  for (const Box& one : boxes)
  {
    all.add(one.first, one.last, one.voxels);
  }
  const double whole = static_cast<double>(nx) * ny * nz;
  if (all.voxels == 0 || all.size() == whole || static_cast<double>(all.voxels) < filledShare * all.size())
  {
    return std::nullopt;
  }
  return std::array{ all.first[0], all.last[0], all.first[1], all.last[1], all.first[2], all.last[2] };
}

#define INK_INSTANTIATE(T)                                                                                   \
  template std::optional<std::array<int, 6>> findFilledBox(                                                  \
    const SliceReader<T>&, const std::array<int, 3>&, int, double);
INK_FOR_EACH_SCALAR(INK_INSTANTIATE)
#undef INK_INSTANTIATE

} // namespace ink
