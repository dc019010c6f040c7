// SPDX-License-Identifier: BSD-3-Clause
#include "IsoSurface/CutSamples.h"

#include "Fields/Grid/GridField.h"
#include "Fields/ScalarDifference.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <optional>

namespace ink
{
namespace
{

/// Where a face is sampled, by the corners' values in the order around it: from (0, 0) to (1, 1), or nowhere.
std::optional<glm::dvec2> samplePosition(const double (&values)[4], double isoValue, CutSurface kind)
{
  constexpr glm::dvec2 corners[4] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
  glm::dvec2 sum(0.0);
  int crossings = 0;
  for (int n = 0; n < 4; ++n)
  {
    const int next = (n + 1) % 4;
    if ((values[n] < isoValue) != (values[next] < isoValue))
    {
      // Halves, as the difference of large values may overflow.
      const double t = (isoValue / 2 - values[n] / 2) / (values[next] / 2 - values[n] / 2);
      sum += glm::mix(corners[n], corners[next], t);
      ++crossings;
    }
  }
  if (crossings > 0)
  {
    return sum / static_cast<double>(crossings);
  }
  return kind == CutSurface::Cap && values[0] >= isoValue ? std::optional(glm::dvec2(0.5)) : std::nullopt;
}

/// The cells of the side whose samples have the index `layer` along an axis.
template <class T>
void sampleSide(const GridField<T>& field, double isoValue, CutSurface kind, int axis, bool upper, int layer,
  const CellSelection& selection, CutSamples& samples)
{
  const GridGeometry& geometry = field.geometry();
  const int u = (axis + 1) % 3 < (axis + 2) % 3 ? (axis + 1) % 3 : (axis + 2) % 3;
  const int v = 3 - axis - u;
  const glm::ivec3 end = glm::min(selection.end, geometry.dimensions() - 1);
  const GridGeometry cells(glm::max(geometry.dimensions() - 1, glm::ivec3(0)));
  glm::dvec3 outwards(0.0);
  outwards[axis] = upper ? 1.0 : -1.0;
  const glm::dvec3 normal = glm::normalize(geometry.gradientDirection() * outwards);
  glm::ivec3 cell(0);
  cell[axis] = upper ? layer - 1 : layer;
  if (cell[axis] < std::max(selection.begin[axis], 0) || cell[axis] >= end[axis])
  {
    return;
  }
  for (cell[v] = std::max(selection.begin[v], 0); cell[v] < end[v]; ++cell[v])
  {
    for (cell[u] = std::max(selection.begin[u], 0); cell[u] < end[u]; ++cell[u])
    {
      glm::ivec3 corner = cell;
      corner[axis] = layer;
      bool complete = true;
      double values[4];
      for (int n = 0; n < 4; ++n)
      {
        glm::ivec3 sample = corner;
        sample[u] += n == 1 || n == 2;
        sample[v] += n >= 2;
        complete = complete && field.has(sample);
        values[n] = static_cast<double>(field.at(sample));
      }
      if (!complete || (!selection.skipped.empty() && selection.skipped[cells.offset(cell)]))
      {
        continue;
      }
      if (const auto position = samplePosition(values, isoValue, kind))
      {
        // Not relative to the grid's own first sample, which differs between pieces.
        glm::dvec3 index(geometry.first() + corner);
        index[u] += position->x;
        index[v] += position->y;
        samples.points.push_back(geometry.origin() + geometry.stepToWorld() * index);
        samples.normals.push_back(normal);
        samples.cells.push_back(activeCellId(geometry.first() + cell));
      }
    }
  }
}

} // namespace

template <class T>
CutSamples sampleCut(const GridField<T>& field, double isoValue, CutSurface kind, const glm::ivec3& first,
  const glm::ivec3& last, const CellSelection& selection)
{
  CutSamples samples;
  const GridGeometry& geometry = field.geometry();
  for (int axis = 0; kind != CutSurface::Open && axis < 3; ++axis)
  {
    for (const bool upper : { false, true })
    {
      const int layer = (upper ? last : first)[axis] - geometry.first()[axis];
      if (layer >= 0 && layer < geometry.dimensions()[axis])
      {
        sampleSide(field, isoValue, kind, axis, upper, layer, selection, samples);
      }
    }
  }
  return samples;
}

#define INK_INSTANTIATE(T)                                                                                   \
  template CutSamples sampleCut(                                                                             \
    const GridField<T>&, double, CutSurface, const glm::ivec3&, const glm::ivec3&, const CellSelection&);
INK_FOR_EACH_SCALAR(INK_INSTANTIATE)
#undef INK_INSTANTIATE

} // namespace ink
