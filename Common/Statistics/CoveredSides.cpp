// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/CoveredSides.h"

#include "Fields/ScalarDifference.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace ink
{

template <typename T>
std::array<double, 6> coveredSides(
  const SliceReader<T>& read, const std::array<int, 3>& dimensions, int slicesAtOnce, double value)
{
  const int nx = dimensions[0];
  const int ny = dimensions[1];
  const int nz = dimensions[2];
  struct Side
  {
    std::int64_t covered = 0;
    std::int64_t all = 0;
  };
  std::array<Side, 6> sides;
  for (int first = 0; first < nz; first += slicesAtOnce)
  {
    const int last = std::min(first + slicesAtOnce, nz);
    const std::span<const T> values = read(first, last);
    const auto count = [&](Side& side, int x, int y, int z)
    {
      const std::size_t row = static_cast<std::size_t>(ny) * (z - first) + y;
      side.covered += static_cast<double>(values[row * nx + x]) > value ? 1 : 0;
      ++side.all;
    };
    for (int z = first; z < last; ++z)
    {
      for (int y = 0; y < ny; ++y)
      {
        count(sides[0], 0, y, z);
        count(sides[1], nx - 1, y, z);
      }
      for (int x = 0; x < nx; ++x)
      {
        count(sides[2], x, 0, z);
        count(sides[3], x, ny - 1, z);
      }
      for (int y = 0; (z == 0 || z == nz - 1) && y < ny; ++y)
      {
        for (int x = 0; x < nx; ++x)
        {
          count(sides[z == 0 ? 4 : 5], x, y, z);
        }
      }
    }
  }
  std::array<double, 6> shares;
  std::transform(sides.begin(), sides.end(), shares.begin(),
    [](const Side& side)
    { return side.all > 0 ? static_cast<double>(side.covered) / static_cast<double>(side.all) : 0.0; });
  return shares;
}

bool surroundsObject(const std::array<double, 6>& sides)
{
  constexpr double nearlyWhole = 0.95;
  return std::count_if(sides.begin(), sides.end(), [](double share) { return share > nearlyWhole; }) >= 4;
}

#define INK_INSTANTIATE(T)                                                                                   \
  template std::array<double, 6> coveredSides(const SliceReader<T>&, const std::array<int, 3>&, int, double);
INK_FOR_EACH_SCALAR(INK_INSTANTIATE)
#undef INK_INSTANTIATE

} // namespace ink
