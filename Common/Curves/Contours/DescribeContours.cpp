// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Contours/DescribeContours.h"

#include "Core/ParallelChunks.h"
#include "Curves/Contours/ContourPoints.h"

#include <cstddef>

namespace ink
{

void describeContours(const FieldView& field, double isoValue, const Eye& eye, const ContourArrays& arrays,
  const ContourProjection& projection, Contours& contours)
{
  const auto forEachPoint = [&contours](const auto& body)
  {
    constexpr std::size_t pointsPerChunk = 256;
    parallelForEach(
      contours.positions.size(), [&](std::size_t n) { body(n, contours.positions[n]); }, pointsPerChunk);
  };
  if (projection.steps > 0)
  {
    forEachPoint([&](std::size_t, glm::dvec3& position)
      { position = projectToContour(field, isoValue, eye, position, projection).first; });
  }
  joinCoincidentPoints(contours);
  if (arrays.normals)
  {
    contours.normals.resize(contours.positions.size());
    forEachPoint(
      [&](std::size_t n, const glm::dvec3& position)
      {
        const glm::dvec3 gradient = field.gradient(position);
        const double slope = glm::length(gradient);
        contours.normals[n] =
          slope > 0.0 && std::isfinite(slope) ? glm::vec3(-gradient / slope) : glm::vec3(0.0f, 0.0f, 1.0f);
      });
  }
  if (arrays.radialCurvature)
  {
    contours.radialCurvature.resize(contours.positions.size());
    forEachPoint([&](std::size_t n, const glm::dvec3& position)
      { contours.radialCurvature[n] = static_cast<float>(radialCurvature(field, eye, position)); });
  }
  if (arrays.arcLength)
  {
    measureArcLength(contours);
  }
  if (!arrays.elements)
  {
    contours.elements.clear();
  }
}

} // namespace ink
