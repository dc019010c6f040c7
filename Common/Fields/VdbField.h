#pragma once

#include "Vdb/VdbGrid.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace ink
{

/// The field that a sparse grid stands for: GridField's interpolation and differences, on the active voxels
/// of an OpenVDB tree. Satisfies ink::Field.
///
/// An inactive voxel is missing, as one that is NaN or infinite: what a level set or another narrow band has
/// for a value there only says which side of the surface it is on. So every result is NaN where an
/// interpolated voxel is missing, and differences beside a missing voxel are one-sided. With
/// Inactive::Background, inactive voxels have their values instead, as suits fog volumes.
///
/// A field with a domain ends there, as a GridField does: points outside take the value of the nearest point.
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
