// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "MeshesWithCurvature.h"
#include "SampledMeshes.h"

#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <tuple>
#include <utility>
#include <vector>

namespace ink::test
{

/// Points of one position become one.
inline void weld(Mesh& mesh)
{
  std::map<std::tuple<double, double, double>, std::uint32_t> ids;
  std::vector<glm::dvec3> points;
  for (Triangle& triangle : mesh.triangles)
  {
    for (std::uint32_t& corner : triangle)
    {
      const glm::dvec3 p = mesh.points[corner];
      const auto [at, isNew] =
        ids.emplace(std::tuple(p.x, p.y, p.z), static_cast<std::uint32_t>(points.size()));
      if (isNew)
      {
        points.push_back(p);
      }
      corner = at->second;
    }
  }
  mesh.points = std::move(points);
}

/// A box from the origin on, each face of cells x cells quads that are cut in two, seen from outside.
/// @param welded whether its faces share the points of their edges
inline Mesh box(const glm::dvec3& size, int cells, bool welded)
{
  Mesh mesh;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int side = 0; side < 2; ++side)
    {
      mesh.addPatch(cells, cells,
        [&](double u, double v)
        {
          glm::dvec3 p(0.0);
          p[axis] = side * size[axis];
          p[(axis + 1) % 3] = (side == 1 ? u : v) * size[(axis + 1) % 3];
          p[(axis + 2) % 3] = (side == 1 ? v : u) * size[(axis + 2) % 3];
          return p;
        });
    }
  }
  if (welded)
  {
    weld(mesh);
  }
  return mesh;
}

/// A cylinder of radius 1 around the z axis with caps as CAD systems tessellate them: all points of a cap are
/// on its rim.
/// @param columns around the side
/// @param rows along it
/// @param welded whether caps share the rims' points
inline Mesh cylinder(int columns, int rows, double length, bool welded)
{
  Mesh mesh;
  const auto at = [&](int column, double z)
  {
    const double angle = 2.0 * std::numbers::pi * (column % columns) / columns;
    return glm::dvec3(std::cos(angle), std::sin(angle), z);
  };
  mesh.addPatch(columns, rows,
    [&](double u, double v) { return at(static_cast<int>(std::lround(u * columns)), v * length); });
  weld(mesh);
  for (const double z : { 0.0, length })
  {
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    for (int column = 0; column < columns; ++column)
    {
      mesh.points.push_back(at(column, z));
    }
    for (std::uint32_t i = 1; i + 1 < static_cast<std::uint32_t>(columns); ++i)
    {
      const Triangle up{ first, first + i, first + i + 1 };
      mesh.triangles.push_back(z > 0.0 ? up : Triangle{ up[0], up[2], up[1] });
    }
  }
  if (welded)
  {
    weld(mesh);
  }
  return mesh;
}

} // namespace ink::test
