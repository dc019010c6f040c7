// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/CurvedMesh.h"

#include "Core/IsFinite.h"
#include "Core/KeyNumbers.h"
#include "Core/WeldedPoints.h"
#include "Mesh/OnePerPoint.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

namespace ink
{

namespace
{

/// Cosine of the largest angle, 30 degrees, between an edge and the surface at its ends; normals that enclose
/// more describe none that runs along it.
constexpr double steepest = 0.866;

/// A level of subdivision.
class Level
{
public:
  Level(CurvedMesh& mesh, std::vector<std::uint32_t>& positions, const CurvedMeshOptions& options)
    : Mesh(mesh)
    , Positions(positions)
    , Options(options)
    , EdgesOf(mesh.triangles.size())
  {
    this->findEdges();
    this->findTriangles();
  }

  /// Halves edges and divides their triangles. @return whether there were any
  bool divide()
  {
    if (!this->chooseEdges())
    {
      return false;
    }
    KeyNumbers pointNumbers(3 * this->Mesh.triangles.size()); // by the ends' points
    const auto firstPoint = static_cast<std::uint32_t>(this->Mesh.points.size());
    const std::uint32_t firstPosition = this->PositionCount;
    std::vector<Triangle> triangles;
    std::vector<std::uint32_t> sources;
    for (std::size_t t = 0; t < this->Mesh.triangles.size(); ++t)
    {
      const Triangle corners = this->Mesh.triangles[t];
      std::array<std::uint32_t, 3> between{ none, none, none };
      for (std::size_t i = 0; i < 3; ++i)
      {
        const std::uint32_t a = corners[i];
        const std::uint32_t b = corners[(i + 1) % 3];
        const std::uint32_t edge = this->EdgesOf[t][i];
        if (edge != none && this->Edges[edge].isHalved)
        {
          between[i] = firstPoint + pointNumbers.numberOf(keyOf(a, b));
          if (between[i] == this->Mesh.points.size())
          {
            this->addPoint(a, b, firstPosition + edge, this->Edges[edge].middle);
          }
        }
      }
      this->addParts(corners, between, triangles);
      sources.resize(triangles.size(), this->Mesh.sources[t]);
    }
    this->Mesh.triangles = std::move(triangles);
    this->Mesh.sources = std::move(sources);
    return true;
  }

private:
  static constexpr std::uint32_t none = WeldedPoints::none;

  /// The edges between two positions, with the points of their first two sides.
  struct Edge
  {
    std::array<std::array<std::uint32_t, 2>, 2> sides; ///< from the lower position to the other
    std::uint32_t count = 0;
    double length = 0.0;
    glm::dvec3 middle; ///< of its curve
    bool isHalved = false;
  };

  static std::uint64_t keyOf(std::uint32_t a, std::uint32_t b)
  {
    return std::uint64_t(std::min(a, b)) << 32 | std::max(a, b);
  }
  std::uint64_t edgeKey(std::uint32_t a, std::uint32_t b) const
  {
    return keyOf(this->Positions[a], this->Positions[b]);
  }

  bool isUsable(const Triangle& triangle) const
  {
    const auto& [a, b, c] = triangle;
    const std::uint32_t p = this->Positions[a];
    const std::uint32_t q = this->Positions[b];
    const std::uint32_t r = this->Positions[c];
    return p != none && q != none && r != none && p != q && q != r && r != p;
  }

  void findEdges()
  {
    KeyNumbers numbers(3 * this->Mesh.triangles.size());
    for (std::size_t t = 0; t < this->Mesh.triangles.size(); ++t)
    {
      const Triangle& triangle = this->Mesh.triangles[t];
      this->EdgesOf[t].fill(none);
      for (std::size_t i = 0; i < 3 && this->isUsable(triangle); ++i)
      {
        std::array<std::uint32_t, 2> side{ triangle[i], triangle[(i + 1) % 3] };
        if (this->Positions[side[1]] < this->Positions[side[0]])
        {
          std::swap(side[0], side[1]);
        }
        const std::uint32_t number = numbers.numberOf(this->edgeKey(side[0], side[1]));
        this->EdgesOf[t][i] = number;
        this->Edges.resize(std::max<std::size_t>(this->Edges.size(), number + 1));
        Edge& edge = this->Edges[number];
        if (edge.count < 2)
        {
          edge.sides[edge.count] = side;
        }
        ++edge.count;
      }
    }
    for (Edge& edge : this->Edges)
    {
      this->measure(edge);
    }
    for (const std::uint32_t position : this->Positions)
    {
      this->PositionCount = std::max(this->PositionCount, position + 1); // none + 1 is 0
    }
  }

  void findTriangles()
  {
    this->FirstTriangle.assign(this->Edges.size() + 1, 0);
    for (std::size_t edge = 0; edge < this->Edges.size(); ++edge)
    {
      this->FirstTriangle[edge + 1] = this->FirstTriangle[edge] + this->Edges[edge].count;
    }
    this->TrianglesOf.resize(this->FirstTriangle.back());
    std::vector<std::uint32_t> next = this->FirstTriangle;
    for (std::size_t t = 0; t < this->EdgesOf.size(); ++t)
    {
      for (const std::uint32_t edge : this->EdgesOf[t])
      {
        if (edge != none)
        {
          this->TrianglesOf[next[edge]++] = static_cast<std::uint32_t>(t);
        }
      }
    }
  }

  /// The derivative of an edge's curve at one end: along the surface, or both surfaces that meet there;
  /// nothing if they do not tell.
  std::optional<glm::dvec3> tangentAt(const Edge& edge, std::size_t end, const glm::dvec3& along) const
  {
    const auto normalOf = [&](std::size_t side)
    { return glm::dvec3(this->Mesh.normals[edge.sides[side][end]]); };
    const glm::dvec3 normal = normalOf(0);
    const glm::dvec3 other = edge.count > 1 ? normalOf(1) : normal;
    const glm::dvec3 crease = glm::cross(normal, other);
    const double size = glm::dot(crease, crease);
    constexpr double flat = 1e-6; // squared sine of an angle between normals that tells no direction
    const glm::dvec3 tangent =
      size > flat ? glm::dot(along, crease) / size * crease : along - glm::dot(along, normal) * normal;
    const double cosine = glm::length(tangent) / glm::length(along);
    if (!(cosine > steepest))
    {
      return std::nullopt;
    }
    // So long that the middle of a circle's arc is on the circle.
    return 2.0 / (cosine * (1.0 + cosine)) * tangent;
  }

  /// Finds the middle of an edge's cubic curve, and whether it is to be halved for itself.
  void measure(Edge& edge) const
  {
    const glm::dvec3& a = this->Mesh.points[edge.sides[0][0]];
    const glm::dvec3& b = this->Mesh.points[edge.sides[0][1]];
    const glm::dvec3 along = b - a;
    edge.length = glm::length(along);
    edge.middle = 0.5 * (a + b);
    if (edge.count > 2)
    {
      return; // many surfaces meet
    }
    const std::optional<glm::dvec3> atA = this->tangentAt(edge, 0, along);
    const std::optional<glm::dvec3> atB = this->tangentAt(edge, 1, along);
    if (atA && atB)
    {
      const glm::dvec3 offset = (*atA - *atB) / 8.0;
      const double deviation = glm::length(offset);
      edge.middle += std::isfinite(deviation) ? offset : glm::dvec3(0.0);
      edge.isHalved = deviation > this->Options.deviation && edge.length > this->Options.length;
    }
  }

  std::uint32_t longestEdge(std::uint32_t triangle) const
  {
    const std::array<std::uint32_t, 3>& edges = this->EdgesOf[triangle];
    return *std::max_element(edges.begin(), edges.end(),
      [&](std::uint32_t a, std::uint32_t b) { return this->Edges[a].length < this->Edges[b].length; });
  }

  /// Where an edge of a triangle is halved, so is its longest, lest triangles become ever thinner (Rivara
  /// 1984). @return whether any is
  bool chooseEdges()
  {
    std::vector<std::uint32_t> chosen;
    for (std::uint32_t edge = 0; edge < this->Edges.size(); ++edge)
    {
      if (this->Edges[edge].isHalved)
      {
        chosen.push_back(edge);
      }
    }
    for (std::size_t i = 0; i < chosen.size(); ++i)
    {
      for (std::uint32_t k = this->FirstTriangle[chosen[i]]; k < this->FirstTriangle[chosen[i] + 1]; ++k)
      {
        const std::uint32_t longest = this->longestEdge(this->TrianglesOf[k]);
        if (!this->Edges[longest].isHalved)
        {
          this->Edges[longest].isHalved = true;
          chosen.push_back(longest);
        }
      }
    }
    return !chosen.empty();
  }

  void addPoint(std::uint32_t a, std::uint32_t b, std::uint32_t number, const glm::dvec3& position)
  {
    // Across the edge. What both ends have along it is a curve that bends to both sides or, more often,
    // noise, which the published -2 (section 3.3) doubles.
    const glm::dvec3 along = this->Mesh.points[b] - this->Mesh.points[a];
    const glm::dvec3 sum(this->Mesh.normals[a] + this->Mesh.normals[b]);
    const glm::dvec3 normal = sum - glm::dot(along, sum) / glm::dot(along, along) * along;
    const double length = glm::length(normal);
    this->Mesh.points.push_back(position);
    this->Mesh.normals.push_back(length > 0.0 ? glm::vec3(normal / length) : this->Mesh.normals[a]);
    this->Mesh.ends.push_back({ a, b });
    this->Positions.push_back(number);
  }

  /// A triangle's parts; `between` are the points on its edges from each corner to the next, or none.
  void addParts(
    const Triangle& corners, const std::array<std::uint32_t, 3>& between, std::vector<Triangle>& parts) const
  {
    const auto isHalved = [&](std::size_t edge) { return between[edge % 3] != none; };
    const auto count = isHalved(0) + isHalved(1) + isHalved(2);
    if (count == 0)
    {
      parts.push_back(corners);
      return;
    }
    if (count == 3)
    {
      parts.push_back({ corners[0], between[0], between[2] });
      parts.push_back({ between[0], corners[1], between[1] });
      parts.push_back({ between[2], between[1], corners[2] });
      parts.push_back({ between[0], between[1], between[2] });
      return;
    }
    // Turned so that the first edge is halved and the last one is not.
    std::size_t first = 0;
    while (!isHalved(first) || isHalved(first + 2))
    {
      ++first;
    }
    const std::uint32_t a = corners[first];
    const std::uint32_t b = corners[(first + 1) % 3];
    const std::uint32_t c = corners[(first + 2) % 3];
    const std::uint32_t ab = between[first];
    const std::uint32_t bc = between[(first + 1) % 3];
    if (count == 1)
    {
      parts.push_back({ a, ab, c });
      parts.push_back({ ab, b, c });
      return;
    }
    parts.push_back({ ab, b, bc });
    const auto distance = [&](std::uint32_t p, std::uint32_t q)
    { return glm::distance(this->Mesh.points[p], this->Mesh.points[q]); };
    if (distance(a, bc) < distance(ab, c))
    {
      parts.push_back({ a, ab, bc });
      parts.push_back({ a, bc, c });
    }
    else
    {
      parts.push_back({ a, ab, c });
      parts.push_back({ ab, bc, c });
    }
  }

  CurvedMesh& Mesh;
  std::vector<std::uint32_t>& Positions; ///< of each point; none where it is not finite
  const CurvedMeshOptions& Options;
  std::uint32_t PositionCount = 0;
  std::vector<Edge> Edges;
  std::vector<std::array<std::uint32_t, 3>> EdgesOf; ///< each triangle, from each corner to the next; or none
  std::vector<std::uint32_t> FirstTriangle;          ///< of each edge in TrianglesOf, and the end
  std::vector<std::uint32_t> TrianglesOf;            ///< the edges
};

/// Which points share a position.
std::vector<std::uint32_t> findPositions(std::span<const glm::dvec3> points)
{
  glm::dvec3 lower(std::numeric_limits<double>::max());
  glm::dvec3 upper(std::numeric_limits<double>::lowest());
  for (const glm::dvec3& point : points)
  {
    if (isFinite(point))
    {
      lower = glm::min(lower, point);
      upper = glm::max(upper, point);
    }
  }
  std::vector<glm::vec3> centered(points.size());
  std::transform(points.begin(), points.end(), centered.begin(),
    [&](const glm::dvec3& point) { return glm::vec3(point - 0.5 * (lower + upper)); });
  return WeldedPoints(centered).of;
}

} // namespace

CurvedMesh curveMesh(const TriangleMesh& mesh, std::span<const glm::vec3> normals,
  const CurvedMeshOptions& options, const Progress& progress)
{
  checkOnePerPoint(mesh, normals.size(), "normals");
  CurvedMesh result;
  result.points.assign(mesh.points.begin(), mesh.points.end());
  result.normals.assign(normals.begin(), normals.end());
  result.triangles.assign(mesh.triangles.begin(), mesh.triangles.end());
  result.sources.resize(mesh.triangles.size());
  std::iota(result.sources.begin(), result.sources.end(), 0U);
  std::vector<std::uint32_t> positions = findPositions(mesh.points);
  double left = 1.0;
  while (result.triangles.size() < options.mostTriangles && (!progress || progress(1.0 - left)) &&
    Level(result, positions, options).divide())
  {
    left /= 2.0;
  }
  return result;
}

} // namespace ink
