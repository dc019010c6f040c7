// SPDX-License-Identifier: BSD-3-Clause
#include "InkNeighborLists.h"

#include "Core/ParallelChunks.h"

#include <glm/geometric.hpp>

InkNeighborLists::InkNeighborLists(
  std::span<const glm::vec3> positions, std::span<const glm::vec3> normals, double areaPerStipple)
  : Groups(ink::groupSamples(positions, normals, ink::groupEdge(areaPerStipple, PerList)))
{
  this->Normals.resize(this->Count());
  ink::parallelForEach(this->Count(),
    [&](std::size_t list)
    {
      glm::vec3 sum(0.0f);
      for (std::size_t i = this->Groups.begins[list]; i < this->Groups.begins[list + 1]; ++i)
      {
        sum += normals[this->Groups.samples[i]];
      }
      // They point in about the same direction.
      this->Normals[list] = glm::normalize(sum);
    });
}
