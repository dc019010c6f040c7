// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Contours/Contours.h"

#include <cstddef>

namespace ink
{

namespace
{

/// Appends one array if it is wanted.
template <class T>
void append(std::vector<T>& to, const std::vector<T>& from, bool wanted = true)
{
  if (wanted)
  {
    to.insert(to.end(), from.begin(), from.end());
  }
}

} // namespace

void appendContours(Contours& to, const Contours& from, const ContourArrays& arrays)
{
  const std::size_t points = to.positions.size();
  for (std::size_t chain = 0; chain < from.chains.size(); ++chain)
  {
    to.chains.offsets.push_back(points + from.chains.offsets[chain + 1]);
  }
  append(to.chains.closed, from.chains.closed);
  append(to.kinds, from.kinds);
  append(to.positions, from.positions);
  append(to.normals, from.normals, arrays.normals);
  append(to.radialCurvature, from.radialCurvature, arrays.radialCurvature);
  append(to.arcLength, from.arcLength, arrays.arcLength);
  append(to.elements, from.elements, arrays.elements);
}

} // namespace ink
