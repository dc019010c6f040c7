// SPDX-License-Identifier: BSD-3-Clause
#include "Fields/Resampling/SmoothGrid.h"

#include "Fields/Resampling/ResampleGrid.h"

#include <span>

namespace ink
{

template <class T>
std::vector<SmoothedValue<T>> smoothGrid(
  const GridField<T>& field, const glm::dvec3& deviation, const Progress& progress)
{
  const GridGeometry& geometry = field.geometry();
  const auto along = [&](int axis)
  { return AxisResampling(deviation[axis], 1, geometry.dimensions()[axis]); };
  std::vector<SmoothedValue<T>> values(geometry.sampleCount());
  const bool finished =
    resampleGrid(field, { along(0), along(1), along(2) }, std::span<SmoothedValue<T>>(values), progress);
  return finished ? values : std::vector<SmoothedValue<T>>();
}

#define INK_INSTANTIATE(T)                                                                                   \
  template std::vector<SmoothedValue<T>> smoothGrid(const GridField<T>&, const glm::dvec3&, const Progress&);
INK_FOR_EACH_SCALAR(INK_INSTANTIATE)
#undef INK_INSTANTIATE

} // namespace ink
