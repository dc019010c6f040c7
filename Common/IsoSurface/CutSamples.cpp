// SPDX-License-Identifier: BSD-3-Clause
#include "IsoSurface/CutSamples.h"

#include "Fields/Grid/GridField.h"
#include "Fields/ScalarDifference.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace ink
{
namespace
{

/// The values at the corners (0, 0), (1, 0), (1, 1) and (0, 1) of a face, bilinear in between.
struct Face
{
  double values[4];

  double at(const glm::dvec2& p) const
  {
    return glm::mix(
      glm::mix(this->values[0], this->values[1], p.x), glm::mix(this->values[3], this->values[2], p.x), p.y);
  }
  glm::dvec2 gradient(const glm::dvec2& p) const
  {
    const auto& v = this->values;
    return { glm::mix(v[1] - v[0], v[2] - v[3], p.y), glm::mix(v[3] - v[0], v[2] - v[1], p.x) };
  }
};

/// The mean of the surface's intersections with a face's edges, if it crosses them.
std::optional<glm::dvec2> meanCrossing(const Face& face, double isoValue)
{
  constexpr glm::dvec2 corners[4] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
  glm::dvec2 sum(0.0);
  int crossings = 0;
  for (int n = 0; n < 4; ++n)
  {
    const int next = (n + 1) % 4;
    const double here = face.values[n];
    const double there = face.values[next];
    if ((here < isoValue) != (there < isoValue))
    {
      // Halves, as the difference of large values may overflow.
      sum += glm::mix(corners[n], corners[next], (isoValue / 2 - here / 2) / (there / 2 - here / 2));
      ++crossings;
    }
  }
  return crossings > 0 ? std::optional(sum / static_cast<double>(crossings)) : std::nullopt;
}

/// Samples one side of the volume.
template <class T>
class SideSampler
{
public:
  SideSampler(const GridField<T>& field, double isoValue, CutSurface kind, const CellSelection& selection,
    const glm::ivec3& divisions, int axis, bool upper, CutSamples& samples)
    : Field(field)
    , IsoValue(isoValue)
    , Kind(kind)
    , Selection(selection)
    , Divisions(divisions)
    , Axis(axis)
    , U(axis == 0 ? 1 : 0)
    , V(axis == 2 ? 1 : 2)
    , Upper(upper)
    , Samples(samples)
  {
    glm::dvec3 outwards(0.0);
    outwards[axis] = upper ? 1.0 : -1.0;
    this->Normal = glm::normalize(field.geometry().gradientDirection() * outwards);
  }

  /// @param layer the index of the side's samples along its axis
  void sample(int layer)
  {
    const glm::ivec3 dimensions = this->Field.geometry().dimensions();
    const GridGeometry cells(glm::max(dimensions - 1, glm::ivec3(0)));
    const glm::ivec3 begin = glm::max(this->Selection.begin, glm::ivec3(0));
    const glm::ivec3 end = glm::min(this->Selection.end, dimensions - 1);
    glm::ivec3 cell(0);
    cell[this->Axis] = this->Upper ? layer - 1 : layer;
    if (cell[this->Axis] < begin[this->Axis] || cell[this->Axis] >= end[this->Axis])
    {
      return;
    }
    for (cell[this->V] = begin[this->V]; cell[this->V] < end[this->V]; ++cell[this->V])
    {
      for (cell[this->U] = begin[this->U]; cell[this->U] < end[this->U]; ++cell[this->U])
      {
        const auto& skipped = this->Selection.skipped;
        if (skipped.empty() || !skipped[cells.offset(cell)])
        {
          this->sampleFace(cell, layer);
        }
      }
    }
  }

private:
  /// The face of a cell with that index along the axis; nothing if a corner is missing.
  std::optional<Face> faceOf(const glm::ivec3& cell, int layer) const
  {
    Face face = {};
    for (int n = 0; n < 4; ++n)
    {
      glm::ivec3 sample = cell;
      sample[this->Axis] = layer;
      sample[this->U] += n == 1 || n == 2;
      sample[this->V] += n >= 2;
      if (!this->Field.has(sample))
      {
        return std::nullopt;
      }
      face.values[n] = static_cast<double>(this->Field.at(sample));
    }
    return face;
  }

  void sampleFace(const glm::ivec3& cell, int layer)
  {
    const std::optional<Face> whole = this->faceOf(cell, layer);
    if (!whole)
    {
      return;
    }
    const auto [least, most] = std::minmax_element(whole->values, whole->values + 4);
    // Also for NaN.
    if (!(*most >= this->IsoValue) || (this->Kind == CutSurface::Rim && *least >= this->IsoValue))
    {
      return;
    }
    const glm::dvec2 parts(this->Divisions[this->U], this->Divisions[this->V]);
    for (int j = 0; j < this->Divisions[this->V]; ++j)
    {
      for (int i = 0; i < this->Divisions[this->U]; ++i)
      {
        const auto place = [&](const glm::dvec2& p) { return (glm::dvec2(i, j) + p) / parts; };
        const Face part{ { whole->at(place({ 0, 0 })), whole->at(place({ 1, 0 })), whole->at(place({ 1, 1 })),
          whole->at(place({ 0, 1 })) } };
        glm::ivec3 own = (this->Field.geometry().first() + cell) * this->Divisions;
        own[this->Axis] += this->Upper ? this->Divisions[this->Axis] - 1 : 0;
        own[this->U] += i;
        own[this->V] += j;
        if (const auto crossing = meanCrossing(part, this->IsoValue))
        {
          this->addRim(cell, layer, *whole, place(*crossing), activeCellId(own));
        }
        else if (this->Kind == CutSurface::Cap && part.values[0] >= this->IsoValue)
        {
          this->add(this->toWorld(cell, layer, place(glm::dvec2(0.5))), this->Normal, activeCellId(own));
        }
      }
    }
  }

  void addRim(
    const glm::ivec3& cell, int layer, const Face& face, const glm::dvec2& position, ActiveCellId own)
  {
    const glm::dvec2 gradient = face.gradient(position);
    glm::dvec3 downwards(0.0);
    downwards[this->U] = -gradient.x;
    downwards[this->V] = -gradient.y;
    if (const auto inner = this->faceOf(cell, this->Upper ? layer - 1 : layer + 1))
    {
      const double step = face.at(position) - inner->at(position);
      downwards[this->Axis] = this->Upper ? -step : step;
    }
    // Scaled first, as squares of large values may overflow.
    const double largest =
      std::max({ std::abs(downwards.x), std::abs(downwards.y), std::abs(downwards.z), 1e-300 });
    const glm::dvec3 along = this->Field.geometry().gradientDirection() * (downwards / largest);
    const double length = glm::length(along);
    const glm::dvec3 surface = length > 0.0 ? along / length : this->Normal;
    for (int n = 1; n <= rimNormals; ++n)
    {
      const glm::dvec3 between = glm::mix(surface, this->Normal, static_cast<double>(n) / (rimNormals - 1));
      if (glm::length(between) > 1e-6)
      {
        this->add(this->toWorld(cell, layer, position), glm::normalize(between), own);
      }
    }
  }

  /// Not relative to the grid's own first sample, which differs between pieces.
  glm::dvec3 toWorld(const glm::ivec3& cell, int layer, const glm::dvec2& position) const
  {
    const GridGeometry& geometry = this->Field.geometry();
    glm::ivec3 corner = cell;
    corner[this->Axis] = layer;
    glm::dvec3 index(geometry.first() + corner);
    index[this->U] += position.x;
    index[this->V] += position.y;
    return geometry.origin() + geometry.stepToWorld() * index;
  }

  void add(const glm::dvec3& point, const glm::dvec3& normal, ActiveCellId cell)
  {
    this->Samples.points.push_back(point);
    this->Samples.normals.push_back(normal);
    this->Samples.cells.push_back(cell);
  }

  const GridField<T>& Field;
  double IsoValue;
  CutSurface Kind;
  const CellSelection& Selection;
  glm::ivec3 Divisions;
  int Axis;
  int U; ///< the side's own axes
  int V;
  bool Upper;
  glm::dvec3 Normal;
  CutSamples& Samples;
};

} // namespace

template <class T>
CutSamples sampleCut(const GridField<T>& field, double isoValue, CutSurface kind, const glm::ivec3& first,
  const glm::ivec3& last, const CellSelection& selection, const glm::ivec3& divisions)
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
        SideSampler(field, isoValue, kind, selection, divisions, axis, upper, samples).sample(layer);
      }
    }
  }
  return samples;
}

#define INK_INSTANTIATE(T)                                                                                   \
  template CutSamples sampleCut(const GridField<T>&, double, CutSurface, const glm::ivec3&,                  \
    const glm::ivec3&, const CellSelection&, const glm::ivec3&);
INK_FOR_EACH_SCALAR(INK_INSTANTIATE)
#undef INK_INSTANTIATE

} // namespace ink
