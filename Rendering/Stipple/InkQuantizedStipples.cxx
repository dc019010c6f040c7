// SPDX-License-Identifier: BSD-3-Clause
#include "InkQuantizedStipples.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/gtc/type_ptr.hpp>

InkQuantizedStipples::InkQuantizedStipples(const InkStipplePoints& points)
{
  const std::vector<InkStipplePoints::Vertex>& vertices = points.GetVertices();
  const int bits = points.GetRankBits();
  const auto element = [bits](const InkStipplePoints::Vertex& vertex)
  { return bits < 32 ? vertex.ElementAndRank >> bits : 0u; };

  const std::size_t count = points.GetShapes().size();
  std::vector<glm::vec3> lows(count, glm::vec3(INFINITY));
  std::vector<glm::vec3> highs(count, glm::vec3(-INFINITY));
  for (const InkStipplePoints::Vertex& vertex : vertices)
  {
    const glm::vec3 position = glm::make_vec3(vertex.Position);
    glm::vec3& low = lows[element(vertex)];
    glm::vec3& high = highs[element(vertex)];
    low = glm::min(low, position);
    high = glm::max(high, position);
    this->Edges = glm::max(this->Edges, high - low);
  }
  this->Boxes.resize(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    // Elements none of whose stipples has a finite position have no box.
    if (lows[i].x <= highs[i].x)
    {
      this->Boxes[i] = ink::stipple::fitQuantizationBox(lows[i], highs[i], this->Edges);
    }
  }
  this->Vertices.reserve(vertices.size());
  for (const InkStipplePoints::Vertex& vertex : vertices)
  {
    this->Vertices.push_back({ ink::stipple::quantizePosition(
                                 glm::make_vec3(vertex.Position), this->Boxes[element(vertex)], this->Edges),
      vertex.ElementAndRank });
  }
}
