// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/ParallelFor.h"
#include "Curves/Contours/Contours.h"
#include "Curves/Contours/DescribeContours.h"
#include "Curves/Contours/Eye.h"
#include "Curves/Contours/GridContours.h"
#include "Fields/Field.h"
#include "Fields/Grid/GridField.h"
#include "Fields/Grid/GridGeometry.h"
#include "IsoSurface/IsoSurfaceSamples.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace ink
{

/// Finds the occluding contours of an iso-surface of any field, by those of its samples on a grid, whose
/// points are then projected onto the contour of the field itself. What is smaller than a cell may be missed.
/// Where the field is not defined, samples are missing and chains end.
template <Field F>
class FieldContours
{
public:
  /// @param field is copied
  /// @param grid the box to search, and how finely
  FieldContours(const F& field, double isoValue, const GridGeometry& grid)
    : Shape(field)
    , IsoValue(isoValue)
    , Values(sample(field, grid))
    , Cells(GridField<double>(grid, this->Values), isoValue)
    , Reach(2.0 * isoSurfaceSampleRadius(grid))
  {
  }

  /// As GridContours::find.
  /// @param steps of the projection; no point moves farther than a cell's diagonal
  Contours find(const Eye& eye, const ContourArrays& arrays = {}, int steps = 8) const
  {
    ContourArrays withElements;
    withElements.elements = true;
    Contours contours = this->Cells.find(eye, withElements);
    ContourProjection projection;
    projection.steps = steps;
    projection.reach = this->Reach;
    describeContours(this->Shape, this->IsoValue, eye, arrays, projection, contours);
    return contours;
  }

private:
  static std::vector<double> sample(const F& field, const GridGeometry& grid)
  {
    const glm::ivec3 n = grid.dimensions();
    std::vector<double> values(grid.sampleCount());
    parallelFor(static_cast<std::size_t>(n.z),
      [&](std::size_t layer)
      {
        glm::ivec3 at(0, 0, static_cast<int>(layer));
        for (at.y = 0; at.y < n.y; ++at.y)
        {
          for (at.x = 0; at.x < n.x; ++at.x)
          {
            values[grid.offset(at)] = field.value(grid.toWorld(at));
          }
        }
      });
    return values;
  }

  F Shape;
  double IsoValue;
  std::vector<double> Values;
  GridContours<double> Cells; ///< of the values
  double Reach;
};

} // namespace ink
