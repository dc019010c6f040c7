// SPDX-License-Identifier: BSD-3-Clause
#include "Fields/Vdb/VdbField.h"

#include "Fields/Field.h"
#include "Fields/Grid/GridField.h"
#include "Fields/Vdb/VdbTree.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <array>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>

namespace ink
{

static_assert(Field<VdbField>);

VdbField::VdbField(VdbGrid grid, Inactive inactive)
  : Grid(std::move(grid))
  , InactiveVoxels(inactive)
  , Domain(this->Grid.domain())
  , Geometry(this->Grid.geometry({ glm::ivec3(0), glm::ivec3(0) }))
{
}

/// Evaluates a small dense field: the voxels up to `reach` steps around the cell that contains the point.
template <class Result, class Evaluate>
Result VdbField::around(const glm::dvec3& world, int reach, const Evaluate& evaluate) const
{
  constexpr int mostReach = 2;
  constexpr int mostSamples = (2 + 2 * mostReach) * (2 + 2 * mostReach) * (2 + 2 * mostReach);
  const glm::dvec3 index = glm::clamp(
    this->Geometry.toGlobalIndex(world), glm::dvec3(this->Domain.first), glm::dvec3(this->Domain.last));
  if (index != index)
  {
    Result undefined(0.0);
    undefined += std::numeric_limits<double>::quiet_NaN();
    return undefined;
  }
  const glm::ivec3 cell(glm::floor(index));
  const VoxelBox box{ glm::max(cell - reach, this->Domain.first),
    glm::min(cell + 1 + reach, this->Domain.last) };
  const GridGeometry geometry = this->Grid.geometry(box);
  return this->Grid.tree().visit(
    [&](const auto& tree)
    {
      using TreeType = std::remove_cvref_t<decltype(tree)>;
      using T = typename TreeType::ValueType;
      VdbLookup<TreeType> lookup(tree);
      std::array<T, mostSamples> values;
      std::array<std::uint8_t, mostSamples> missing;
      std::size_t n = 0;
      for (int k = box.first.z; k <= box.last.z; ++k)
      {
        for (int j = box.first.y; j <= box.last.y; ++j)
        {
          for (int i = box.first.x; i <= box.last.x; ++i, ++n)
          {
            missing[n] = lookup.probeValue({ i, j, k }, values[n]) ? 0 : 1;
          }
        }
      }
      const ElementMarks marks = this->InactiveVoxels == Inactive::Missing
        ? ElementMarks{ std::span<const std::uint8_t>(missing.data(), n), 1 }
        : ElementMarks();
      return Result(evaluate(GridField<T>(geometry, std::span<const T>(values.data(), n), 1, marks)));
    });
}

double VdbField::value(const glm::dvec3& world) const
{
  return this->around<double>(world, 0, [&](const auto& field) { return field.value(world); });
}

glm::dvec3 VdbField::gradient(const glm::dvec3& world) const
{
  return this->around<glm::dvec3>(world, 1, [&](const auto& field) { return field.gradient(world); });
}

glm::dmat3 VdbField::hessian(const glm::dvec3& world) const
{
  return this->around<glm::dmat3>(world, 2, [&](const auto& field) { return field.hessian(world); });
}

} // namespace ink
