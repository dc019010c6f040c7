// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fields/Vdb/VdbGrid.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace ink
{

/// The field defined by a sparse grid: GridField's interpolation and differences, on the active voxels of an
/// OpenVDB tree. Satisfies ink::Field.
///
/// Inactive voxels are missing, as are voxels that are NaN or infinite: in a level set or another narrow
/// band, their values only tell which side of the surface they are on. So results are NaN where an
/// interpolated voxel is missing, and differences next to a missing voxel are one-sided. With
/// Inactive::Background, inactive voxels keep their values instead, as suits fog volumes.
///
/// Outside the grid's domain, if it has one, points are clamped to it, as in GridField.
class VdbField
{
public:
  enum class Inactive
  {
    Missing,
    Background
  };

  explicit VdbField(VdbGrid grid, Inactive inactive = Inactive::Missing);

  const VdbGrid& grid() const { return this->Grid; }

  double value(const glm::dvec3& world) const;
  glm::dvec3 gradient(const glm::dvec3& world) const;
  glm::dmat3 hessian(const glm::dvec3& world) const;

private:
  template <class Result, class Evaluate>
  Result around(const glm::dvec3& world, int reach, const Evaluate& evaluate) const;

  VdbGrid Grid;
  Inactive InactiveVoxels;
  VoxelBox Domain;
  GridGeometry Geometry;
};

} // namespace ink
