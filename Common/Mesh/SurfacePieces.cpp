// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/SurfacePieces.h"

#include "Core/MortonOrder.h"
#include "Core/ParallelChunks.h"
#include "Core/ParallelSort.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <limits>
#include <tuple>

namespace ink
{

namespace
{

constexpr std::uint32_t whole = ~0u;

struct Piece
{
  std::uint64_t mortonCode;
  glm::vec3 middle;
  std::uint32_t triangle;
  std::uint32_t cut; // its corners in the part's list
};

/// Bisects pieces that are too large at the midpoint of their longest edge.
template <class Corners, class Add>
void cutUp(const Corners& corners, const std::array<glm::vec3, 3>& at, float longest, const Add& add)
{
  std::size_t edge = 0;
  float most = 0.0f;
  for (std::size_t e = 0; e < 3; ++e)
  {
    const glm::vec3 way = at[(e + 1) % 3] - at[e];
    if (const float square = glm::dot(way, way); square > most)
    {
      most = square;
      edge = e;
    }
  }
  if (most <= longest * longest)
  {
    add(corners, at);
    return;
  }
  const std::size_t next = (edge + 1) % 3;
  const glm::vec2 middle = 0.5f * (corners[edge] + corners[next]);
  const glm::vec3 middleAt = 0.5f * (at[edge] + at[next]);
  for (const std::size_t replaced : { next, edge })
  {
    Corners half = corners;
    half[replaced] = middle;
    std::array<glm::vec3, 3> halfAt = at;
    halfAt[replaced] = middleAt;
    cutUp(half, halfAt, longest, add);
  }
}

} // namespace

SurfacePieces::SurfacePieces(const TriangleMesh& mesh, std::span<const glm::vec3> points,
  std::span<const glm::vec3> normals, float longest)
  : Mesh(mesh)
  , Points(points)
  , Normals(normals)
  , Longest(longest)
{
  const std::size_t chunks = chunksOf(mesh.triangles.size());
  std::vector<std::vector<Piece>> found(chunks);
  std::vector<std::vector<Corners>> cuts(chunks);
  parallelForChunks(mesh.triangles.size(),
    [&](std::size_t chunk, std::size_t begin, std::size_t end)
    {
      for (std::size_t t = begin; t < end; ++t)
      {
        const auto& [a, b, c] = mesh.triangles[t];
        if (!(areaOf(mesh, t) > 0.0))
        {
          continue;
        }
        const Corners all{ glm::vec2(0.0f), glm::vec2(1.0f, 0.0f), glm::vec2(0.0f, 1.0f) };
        cutUp(all, { points[a], points[b], points[c] }, longest,
          [&](const Corners& corners, const std::array<glm::vec3, 3>& at)
          {
            const glm::vec3 middle = (at[0] + at[1] + at[2]) / 3.0f;
            // The origin is at the center.
            const glm::vec3 cell = glm::clamp(glm::floor(middle / longest) + 0x1p20f, 0.0f, 0x1p21f - 1.0f);
            Piece piece{ mortonOf(glm::uvec3(cell)), middle, static_cast<std::uint32_t>(t), whole };
            if (corners != all)
            {
              piece.cut = static_cast<std::uint32_t>(cuts[chunk].size());
              cuts[chunk].push_back(corners);
            }
            found[chunk].push_back(piece);
          });
      }
    });
  std::vector<Piece> pieces;
  bool isCut = false;
  for (std::size_t chunk = 0; chunk < chunks; ++chunk)
  {
    const auto before = static_cast<std::uint32_t>(this->CutCorners.size());
    for (Piece piece : found[chunk])
    {
      isCut = isCut || piece.cut != whole;
      piece.cut += piece.cut != whole ? before : 0;
      pieces.push_back(piece);
    }
    this->CutCorners.insert(this->CutCorners.end(), cuts[chunk].begin(), cuts[chunk].end());
    found[chunk] = {};
    cuts[chunk] = {};
  }
  parallelSort(pieces.begin(), pieces.end(),
    [](const Piece& a, const Piece& b)
    {
      return a.mortonCode != b.mortonCode ? a.mortonCode < b.mortonCode
        : a.triangle != b.triangle        ? a.triangle < b.triangle
                                          : a.cut < b.cut;
    });
  this->Order.resize(pieces.size());
  this->Cut.resize(isCut ? pieces.size() : 0);
  this->Areas.resize(pieces.size());
  this->Middles.resize(pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    this->Order[i] = pieces[i].triangle;
    this->Middles[i] = pieces[i].middle;
    double share = 1.0;
    if (isCut)
    {
      this->Cut[i] = pieces[i].cut;
      const Corners corners = this->corners(i);
      const glm::dvec2 u = corners[1] - corners[0];
      const glm::dvec2 v = corners[2] - corners[0];
      share = std::abs(u.x * v.y - u.y * v.x);
    }
    this->Areas[i] = share * areaOf(mesh, pieces[i].triangle);
  }
}

SurfacePieces::Corners SurfacePieces::corners(std::size_t piece) const
{
  return this->Cut.empty() || this->Cut[piece] == whole
    ? Corners{ glm::vec2(0.0f), glm::vec2(1.0f, 0.0f), glm::vec2(0.0f, 1.0f) }
    : this->CutCorners[this->Cut[piece]];
}

SurfacePieces::Frame SurfacePieces::frame(std::size_t piece) const
{
  const auto& [a, b, c] = this->Mesh.triangles[this->Order[piece]];
  const glm::vec3 side1 = this->Points[b] - this->Points[a];
  const glm::vec3 side2 = this->Points[c] - this->Points[a];
  Frame frame{ this->Points[a], side1, side2, glm::cross(side1, side2) };
  const float length = glm::length(frame.normal);
  // False for NaN.
  const bool turned = !this->Normals.empty() &&
    glm::dot(frame.normal, this->Normals[a] + this->Normals[b] + this->Normals[c]) < 0.0f;
  frame.normal = length > 0.0f ? frame.normal / (turned ? -length : length) : glm::vec3(0.0f);
  if (!this->Cut.empty() && this->Cut[piece] != whole)
  {
    const Corners& corners = this->CutCorners[this->Cut[piece]];
    const auto at = [&](const glm::vec2& weights) { return weights.x * side1 + weights.y * side2; };
    frame.origin += at(corners[0]);
    frame.along1 = at(corners[1] - corners[0]);
    frame.along2 = at(corners[2] - corners[0]);
  }
  return frame;
}

SurfaceSample SurfacePieces::sample(const SpacedSample& spaced) const
{
  const auto& [piece, b1, b2] = std::tie(spaced.piece, spaced.b1, spaced.b2);
  SurfaceSample result{ this->Order[piece], b1, b2 };
  if (!this->Cut.empty() && this->Cut[piece] != whole)
  {
    const Corners& corners = this->CutCorners[this->Cut[piece]];
    const glm::vec2 weights = corners[0] + b1 * (corners[1] - corners[0]) + b2 * (corners[2] - corners[0]);
    result.b1 = weights.x;
    result.b2 = weights.y;
  }
  return result;
}

} // namespace ink
