// SPDX-License-Identifier: BSD-3-Clause
#include "PointSampling/PointCloud/VoronoiCell2D.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace ink
{

VoronoiCell2D::VoronoiCell2D(float reach)
{
  this->Corners[0] = { { -reach, -reach }, false };
  this->Corners[1] = { { reach, -reach }, false };
  this->Corners[2] = { { reach, reach }, false };
  this->Corners[3] = { { -reach, reach }, false };
}

void VoronoiCell2D::cut(const glm::vec2& neighbor)
{
  const float limit = 0.5f * glm::dot(neighbor, neighbor);
  std::array<Corner, mostCorners> kept;
  std::size_t count = 0;
  for (std::size_t i = 0; i < this->Count; ++i)
  {
    const Corner& here = this->Corners[i];
    const Corner& next = this->Corners[i + 1 < this->Count ? i + 1 : 0];
    const float beyond = glm::dot(here.position, neighbor) - limit;
    const float nextBeyond = glm::dot(next.position, neighbor) - limit;
    if (beyond <= 0.0f && count < kept.size())
    {
      kept[count++] = here;
    }
    // A line leaves and enters a convex cell once each.
    if ((beyond <= 0.0f) != (nextBeyond <= 0.0f) && count < kept.size())
    {
      const float part = beyond / (beyond - nextBeyond);
      kept[count++] = { here.position + part * (next.position - here.position),
        beyond <= 0.0f || here.cutAfter };
    }
  }
  this->Corners = kept;
  this->Count = count;
}

float VoronoiCell2D::extent() const
{
  float farthest = 0.0f;
  for (std::size_t i = 0; i < this->Count; ++i)
  {
    farthest = std::max(farthest, glm::dot(this->Corners[i].position, this->Corners[i].position));
  }
  return std::sqrt(farthest);
}

std::size_t VoronoiCell2D::corners(std::span<float, mostCorners> distances) const
{
  std::size_t found = 0;
  for (std::size_t i = 0; i < this->Count; ++i)
  {
    if (this->Corners[i].cutAfter && this->Corners[i > 0 ? i - 1 : this->Count - 1].cutAfter)
    {
      distances[found++] = glm::length(this->Corners[i].position);
    }
  }
  return found;
}

} // namespace ink
