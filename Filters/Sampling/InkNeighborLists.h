// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkNeighborLists_h
#define InkNeighborLists_h

#include "PointSampling/SampleGroups.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <span>
#include <vector>

/// Lists of stipples that are neighbors on one side of a surface (ink::groupSamples), for surfaces whose own
/// elements are too small for lists. A list for each stipple, or few of them, would have all stipples drawn
/// everywhere, the smaller the lighter the tone: dust instead of dots.
struct InkNeighborLists
{
  /// Stipples of a list, on average: enough that most of those drawn are whole ones, and few enough that a
  /// list's normal is that of each.
  static constexpr double PerList = 8.0;

  ink::SampleGroups Groups;
  std::vector<glm::vec3> Normals; ///< unit: of each list the mean of its stipples'

  /// @param positions, normals of stipples in progressive order, as ink::groupSamples takes them; unit
  /// normals
  /// @param areaPerStipple of the surface
  InkNeighborLists(
    std::span<const glm::vec3> positions, std::span<const glm::vec3> normals, double areaPerStipple);

  std::size_t Count() const { return this->Groups.begins.size() - 1; }
};

#endif
