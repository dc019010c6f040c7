// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fields/Grid/GridField.h"
#include "IsoSurface/ActiveCells.h"
#include "IsoSurface/IsoSurfaceSamples.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

namespace ink::testing
{

/// A grid with its own values.
template <class T>
struct Volume
{
  GridGeometry geometry;
  std::vector<T> values;

  explicit Volume(const GridGeometry& g, T value = T())
    : geometry(g)
    , values(g.sampleCount(), value)
  {
  }

  /// Samples function(world point), converted to T.
  template <class Function>
  static Volume from(const GridGeometry& g, const Function& function)
  {
    Volume volume(g);
    const glm::ivec3 n = g.dimensions();
    for (int k = 0; k < n.z; ++k)
    {
      for (int j = 0; j < n.y; ++j)
      {
        for (int i = 0; i < n.x; ++i)
        {
          volume.at({ i, j, k }) = static_cast<T>(function(g.toWorld({ i, j, k })));
        }
      }
    }
    return volume;
  }

  /// Its samples from `first` to `last`, in their place.
  Volume part(const glm::ivec3& first, const glm::ivec3& last) const
  {
    Volume part(GridGeometry(last - first + 1, this->geometry.origin(), this->geometry.spacing(),
      this->geometry.direction(), this->geometry.first() + first));
    const glm::ivec3 n = part.geometry.dimensions();
    for (int k = 0; k < n.z; ++k)
    {
      for (int j = 0; j < n.y; ++j)
      {
        for (int i = 0; i < n.x; ++i)
        {
          part.at({ i, j, k }) = this->values[this->geometry.offset(first + glm::ivec3(i, j, k))];
        }
      }
    }
    return part;
  }

  T& at(const glm::ivec3& sample) { return this->values[this->geometry.offset(sample)]; }
  GridField<T> field(const ElementMarks& hidden = {}) const
  {
    return GridField<T>(this->geometry, std::span<const T>(this->values), 1, hidden);
  }
};

/// The samples of an iso-surface as points and normals.
template <class Real>
struct Samples
{
  std::vector<Real> coordinates;
  std::vector<float> components;

  std::size_t size() const { return this->coordinates.size() / 3; }
  glm::dvec3 point(std::size_t n) const
  {
    return { this->coordinates[3 * n], this->coordinates[3 * n + 1], this->coordinates[3 * n + 2] };
  }
  glm::dvec3 normal(std::size_t n) const
  {
    return { this->components[3 * n], this->components[3 * n + 1], this->components[3 * n + 2] };
  }
  bool operator==(const Samples&) const = default;

  /// Makes room for so many: what an ink::GrowRoom does.
  SampleRoom grow(std::size_t count)
  {
    this->coordinates.resize(3 * count);
    this->components.resize(3 * count);
    SampleRoom room;
    if constexpr (std::is_same_v<Real, float>)
    {
      room.points = this->coordinates.data();
    }
    else
    {
      room.doublePoints = this->coordinates.data();
    }
    room.normals = this->components.data();
    room.capacity = count;
    return room;
  }
};

template <class Real = double, class T>
Samples<Real> sampleIsoSurface(const GridField<T>& field, double isoValue, const SampleOptions& options,
  const CellSelection& selection = {})
{
  const ActiveCells cells = findActiveCells(field, isoValue, options.rule, selection);
  Samples<Real> samples;
  samples.coordinates.resize(3 * cells.count);
  samples.components.resize(3 * cells.count);
  placeIsoSurfaceSamples(field, isoValue, options, cells, std::span<Real>(samples.coordinates),
    std::span<float>(samples.components));
  return samples;
}

template <class Real = double, class T>
Samples<Real> sampleIsoSurface(const GridField<T>& field, double isoValue,
  CrossingRule rule = CrossingRule::HalfOpen, const CellSelection& selection = {})
{
  SampleOptions options;
  options.rule = rule;
  return sampleIsoSurface<Real>(field, isoValue, options, selection);
}

} // namespace ink::testing
