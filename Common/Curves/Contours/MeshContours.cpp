// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Contours/MeshContours.h"

#include "Curves/Contours/ContourSegments.h"
#include "Curves/Contours/FeatureEdges.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

namespace ink
{

namespace
{

MeshContourOptions checked(const MeshContourOptions& options, bool hasNormals)
{
  if (options.silhouettes && !options.faceted && !hasNormals)
  {
    throw std::invalid_argument(
      "the mesh has no normals, expected one per point for interpolated silhouettes; faceted ones need none");
  }
  if (!(options.creaseAngle >= 0.0 && options.creaseAngle <= 180.0))
  {
    throw std::invalid_argument(
      "the angle of creases is " + std::to_string(options.creaseAngle) + " degrees, expected from 0 to 180");
  }
  const auto checkShare = [](double share, const char* edge)
  {
    if (!(share >= 0.0 && share <= 1.0))
    {
      throw std::invalid_argument("the length of the shortest " + std::string(edge) + " is " +
        std::to_string(share) + " of the diagonal, expected from 0 to 1");
    }
  };
  checkShare(options.shortestCrease, "crease");
  checkShare(options.shortestBorder, "border");
  return options;
}

/// The two faces at the edge that a segment lies on, which tell the edge.
std::uint64_t facesAt(const ContourSegment& segment)
{
  const auto [low, high] = std::minmax(segment.face, segment.otherFace);
  return std::uint64_t(low) << 32 | high;
}

constexpr ContourArrays allArrays{ true, true, true, true };

} // namespace

MeshContours::MeshContours(
  const TriangleMesh& mesh, std::span<const glm::vec3> normals, const MeshContourOptions& options)
  : Options(checked(options, !normals.empty() || mesh.points.empty()))
  , Surface(mesh, normals)
{
  if (options.silhouettes && options.faceted)
  {
    this->Faceted.emplace(this->Surface);
  }
  else if (options.silhouettes)
  {
    this->Interpolated.emplace(this->Surface);
  }
  if (options.creases || options.borders || options.nonManifold)
  {
    const FeatureEdges edges(this->Surface, options.creaseAngle, options.shortestCrease,
      options.shortestBorder, options.sharpCreasesOnly);
    const auto add = [&](bool wanted, const std::vector<ContourSegment>& segments, ContourKind kind)
    {
      if (wanted)
      {
        appendContours(
          this->Features, chainContours(this->Surface, segments, kind, Eye(), allArrays), allArrays);
      }
    };
    if (options.borders)
    {
      this->Holes.emplace(edges.holes);
    }
    add(options.creases, edges.creases, ContourKind::Crease);
    if (options.creases && options.once)
    {
      for (const ContourSegment& crease : edges.creases)
      {
        this->Creases.push_back(facesAt(crease));
      }
      std::sort(this->Creases.begin(), this->Creases.end());
    }
    add(options.borders, edges.borders, ContourKind::Border);
    add(options.nonManifold, edges.nonManifold, ContourKind::NonManifold);
  }
}

Contours MeshContours::find(const Eye& eye, const ContourArrays& arrays, SilhouetteSearch search) const
{
  eye.check();
  Contours result;
  if (this->Options.silhouettes)
  {
    std::vector<ContourSegment> segments =
      this->Faceted ? this->Faceted->find(eye, search) : this->Interpolated->find(this->Surface, eye, search);
    if (!this->Creases.empty())
    {
      std::erase_if(segments,
        [&](const ContourSegment& segment)
        {
          // Within a face there is no crease.
          return segment.face != segment.otherFace &&
            std::binary_search(this->Creases.begin(), this->Creases.end(), facesAt(segment));
        });
    }
    if (this->Holes && this->Interpolated)
    {
      this->Holes->bridge(this->Surface, segments);
    }
    result = chainContours(this->Surface, segments, ContourKind::Silhouette, eye, arrays);
  }
  appendContours(result, this->Features, arrays);
  return result;
}

} // namespace ink
