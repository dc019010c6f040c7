// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Streamlines/CombDirections.h"

#include "Curves/Streamlines/AlignedLineField.h"
#include "Mesh/OnePerPoint.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ink
{

namespace
{

// In distances of lines: over which the family is chosen, and over which its directions are averaged.
constexpr double familyReach = 25.0;
constexpr double lineReach = 4.0;

} // namespace

std::vector<glm::dvec3> combDirections(const TriangleMesh& mesh, std::span<const glm::vec3> normals,
  std::span<const glm::dvec3> directions, std::span<const float> umbilics, std::span<const float> preferences,
  double distance, const Progress& progress)
{
  checkOnePerPoint(mesh, umbilics.size(), "umbilic measures");
  const auto half = [&progress](double begun)
  {
    return progress ? Progress([&progress, begun](double done) { return progress(begun + 0.5 * done); })
                    : progress;
  };
  const std::vector<glm::dvec3> family =
    alignedLineField(mesh, normals, directions, preferences, familyReach * distance, half(0.0));
  std::vector<float> own(preferences.size());
  for (std::size_t i = 0; i < own.size(); ++i)
  {
    const float defined = std::clamp(1.0f - umbilics[i], 0.0f, 1.0f);
    const auto cosine = static_cast<float>(glm::dot(family[i], directions[i]));
    // The cosine of twice the angle.
    own[i] = std::max(std::abs(preferences[i]), defined * defined) * (2.0f * cosine * cosine - 1.0f);
  }
  return alignedLineField(mesh, normals, directions, own, lineReach * distance, half(0.5));
}

} // namespace ink
