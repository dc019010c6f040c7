// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Streamlines/FormDirections.h"

#include "Core/IsFinite.h"
#include "Core/UnitOrZero.h"
#include "Curvature/AveragedCurvature.h"
#include "Mesh/OnePerPoint.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <cstddef>
#include <limits>

namespace ink
{

namespace
{

/// The first scale, in distances of lines, and the last one, in diagonals.
constexpr double firstScale = 4.0;
constexpr double lastScale = 0.06;
/// Up to which umbilic measure a direction is not looked for at a larger scale: where smoothCrossField begins
/// to replace it.
constexpr float mostDefined = 0.5f;
/// From which one on it is that of parallels, and how well this is defined.
constexpr float leastUndefined = 0.9f;
constexpr float ofParallels = 0.98f;
constexpr float preferenceOfParallels = 0.02f;

double diagonalOf(const TriangleMesh& mesh)
{
  glm::dvec3 lower(std::numeric_limits<double>::max());
  glm::dvec3 upper(std::numeric_limits<double>::lowest());
  for (const Triangle& triangle : mesh.triangles)
  {
    for (const std::uint32_t point : triangle)
    {
      if (isFinite(mesh.points[point]))
      {
        lower = glm::min(lower, mesh.points[point]);
        upper = glm::max(upper, mesh.points[point]);
      }
    }
  }
  return lower.x <= upper.x ? glm::distance(lower, upper) : 0.0;
}

void set(FormDirections& form, std::size_t point, const PrincipalCurvature& at, double negligible)
{
  const bool isKnown = std::isfinite(at.k1) && std::isfinite(at.k2);
  form.umbilics[point] = isKnown ? static_cast<float>(at.umbilicMeasure(negligible)) : 1.0f;
  form.directions[0][point] = unitOrZero(at.direction1);
  form.directions[1][point] = unitOrZero(at.direction2);
  const double first = std::abs(at.k1);
  const double second = std::abs(at.k2);
  const double preference = isKnown ? (first - second) / (first + second + negligible) : 0.0;
  form.preferences[point] = static_cast<float>(preference * std::abs(preference));
}

} // namespace

FormDirections formDirections(const TriangleMesh& mesh, std::span<const glm::vec3> normals,
  std::span<const PrincipalCurvature> curvatures, double negligible, double distance)
{
  checkOnePerPoint(mesh, normals.size(), "normals");
  checkOnePerPoint(mesh, curvatures.size(), "curvatures");
  const std::size_t count = mesh.points.size();
  FormDirections form;
  form.directions.fill(std::vector<glm::dvec3>(count));
  form.umbilics.resize(count);
  form.preferences.resize(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    set(form, i, curvatures[i], negligible);
  }
  const double last = lastScale * diagonalOf(mesh);
  std::vector<unsigned char> isRound(count);
  for (double scale = firstScale; scale * distance <= last; scale *= 2.0)
  {
    const std::vector<PrincipalCurvature> averaged =
      averagedCurvature(mesh, normals, curvatures, scale * distance, 1.0 / distance);
    for (std::size_t i = 0; i < count; ++i)
    {
      if (form.umbilics[i] > mostDefined &&
        averaged[i].umbilicMeasure(negligible / scale) < static_cast<double>(form.umbilics[i]))
      {
        set(form, i, averaged[i], negligible / scale);
      }
      isRound[i] = std::abs(averaged[i].k1) > negligible / scale && averaged[i].gauss() > 0.0 ? 1 : 0;
    }
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    const glm::dvec3 normal(normals[i]);
    const glm::dvec3 parallel = unitOrZero(glm::cross(glm::dvec3(-1.0, -1.0, 1.0), normal));
    if (isRound[i] != 0 && form.umbilics[i] >= leastUndefined && parallel != glm::dvec3(0.0))
    {
      form.directions[0][i] = parallel;
      form.directions[1][i] = glm::cross(normal, parallel);
      form.umbilics[i] = ofParallels;
      form.preferences[i] = preferenceOfParallels;
    }
  }
  return form;
}

} // namespace ink
