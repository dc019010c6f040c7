// SPDX-License-Identifier: BSD-3-Clause
#include "InkNeighborLists.h"

#include <glm/geometric.hpp>

InkNeighborLists::InkNeighborLists(
  std::span<const glm::vec3> positions, std::span<const glm::vec3> normals, double areaPerStipple)
  : Groups(ink::groupSamples(positions, normals, ink::groupEdge(areaPerStipple, PerList)))
{
  for (std::size_t list = 0; list < this->Count(); ++list)
  {
    glm::vec3 sum(0.0f);
    for (std::size_t i = this->Groups.begins[list]; i < this->Groups.begins[list + 1]; ++i)
    {
      sum += normals[this->Groups.samples[i]];
    }
    // They point in about the same direction.
    this->Normals.push_back(glm::normalize(sum));
  }
}
