// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Contours/ContourSegments.h"

#include "Core/KeyNumbers.h"
#include "Core/ParallelChunks.h"
#include "Core/Prefetch.h"
#include "Curves/ChainSegments.h"
#include "Curves/Contours/ContourPoints.h"

#include <algorithm>
#include <cmath>

namespace ink
{

namespace
{

constexpr std::size_t nodesPerChunk = 1 << 11;

std::uint64_t keyOf(const ContourNode& node)
{
  return std::uint64_t(node.corner0) << 32 | node.corner1;
}

/// Where nodes are, and the surface's normals there.
struct Nodes
{
  std::vector<glm::dvec3> positions;
  std::vector<glm::dvec3> normals; // unit length
};

Nodes placeNodes(
  const ContourSurface& surface, std::span<const std::uint64_t> keys, const Eye& eye, bool wantNormals)
{
  constexpr std::size_t ahead = 16; // nodes, enough for memory to answer
  Nodes nodes;
  nodes.positions.resize(keys.size());
  nodes.normals.resize(wantNormals ? keys.size() : 0);
  parallelForEach(
    keys.size(),
    [&](std::size_t i)
    {
      const std::uint64_t later = keys[std::min(i + ahead, keys.size() - 1)];
      prefetchObject(surface.corners[static_cast<std::uint32_t>(later >> 32)]);
      prefetchObject(surface.corners[static_cast<std::uint32_t>(later)]);
      const auto a = static_cast<std::uint32_t>(keys[i] >> 32);
      const auto b = static_cast<std::uint32_t>(keys[i]);
      double t = 0.0;
      if (a != b)
      {
        const double atA = surface.facing(a, eye);
        t = atA / (atA - surface.facing(b, eye)); // of unlike signs
      }
      nodes.positions[i] =
        glm::mix(surface.corners[a].position, surface.corners[b].position, t); // exact at both
      if (wantNormals)
      {
        const glm::dvec3 normal =
          glm::mix(glm::dvec3(surface.corners[a].normal), glm::dvec3(surface.corners[b].normal), t);
        const double length = glm::length(normal);
        nodes.normals[i] = length > 0.0 ? normal / length : glm::dvec3(0.0, 0.0, 1.0);
      }
    },
    nodesPerChunk);
  return nodes;
}

/// Normal curvature towards `v` at a point of a face, from the derivative of the interpolated normal. For
/// silhouettes on the edge of two faces with normals of their own, see foldCurvature.
double faceCurvature(
  const ContourSurface& surface, std::uint32_t face, const glm::dvec3& normal, const glm::dvec3& v)
{
  const auto& [a, b, c] = surface.faces[face];
  const glm::dvec3 e1 = surface.corners[b].position - surface.corners[a].position;
  const glm::dvec3 e2 = surface.corners[c].position - surface.corners[a].position;
  const glm::dvec3 w = v - normal * glm::dot(normal, v);
  // w = b1 e1 + b2 e2, in the sense of least squares.
  const double e11 = glm::dot(e1, e1);
  const double e12 = glm::dot(e1, e2);
  const double e22 = glm::dot(e2, e2);
  const double determinant = e11 * e22 - e12 * e12;
  const double we1 = glm::dot(w, e1);
  const double we2 = glm::dot(w, e2);
  const double b1 = (we1 * e22 - we2 * e12) / determinant;
  const double b2 = (we2 * e11 - we1 * e12) / determinant;
  const glm::dvec3 n0(surface.corners[a].normal);
  const glm::dvec3 derivative =
    b1 * (glm::dvec3(surface.corners[b].normal) - n0) + b2 * (glm::dvec3(surface.corners[c].normal) - n0);
  const double curvature = glm::dot(derivative, w) / glm::dot(w, w);
  return std::isfinite(curvature) ? curvature : 0.0;
}

/// Normal curvature towards `v` across the edge that two faces share: the angle between them, over the
/// distance of their centers.
double foldCurvature(
  const ContourSurface& surface, std::uint32_t face, std::uint32_t other, const glm::dvec3& v)
{
  const auto center = [&](std::uint32_t f)
  {
    const auto& [a, b, c] = surface.faces[f];
    return (surface.corners[a].position + surface.corners[b].position + surface.corners[c].position) / 3.0;
  };
  const auto normal = [&](std::uint32_t f)
  {
    // On the side of the corners' normals, whichever way the face runs.
    const auto& [a, b, c] = surface.faces[f];
    const glm::dvec3 area = surface.faceNormal(f);
    return glm::dot(area,
             glm::dvec3(surface.corners[a].normal + surface.corners[b].normal + surface.corners[c].normal)) <
        0.0
      ? -area
      : area;
  };
  const glm::dvec3 across = center(other) - center(face);
  const double curvature = glm::dot(normal(other) - normal(face), across) / glm::dot(across, across);
  const double cosine = glm::dot(glm::normalize(across), glm::normalize(v));
  const double result = curvature * cosine * cosine;
  return std::isfinite(result) ? result : 0.0;
}

} // namespace

Contours chainContours(const ContourSurface& surface, std::span<const ContourSegment> segments,
  ContourKind kind, const Eye& eye, const ContourArrays& arrays)
{
  KeyNumbers numbers(2 * segments.size());
  std::vector<Segment> ends;
  ends.reserve(segments.size());
  for (const ContourSegment& segment : segments)
  {
    const std::uint32_t from = numbers.numberOf(keyOf(segment.from));
    ends.push_back({ from, numbers.numberOf(keyOf(segment.to)) });
  }
  const bool wantCurvature = arrays.radialCurvature && kind == ContourKind::Silhouette;
  const Nodes nodes = placeNodes(surface, numbers.keys(), eye, arrays.normals || wantCurvature);
  const Chains chains = chainSegments(ends, numbers.keys().size());

  Contours result;
  const auto curvatureOf = [&](std::uint32_t node, std::uint32_t segment)
  {
    const auto& [from, to, face, other] = segments[segment];
    const glm::dvec3 v = eye.from(nodes.positions[node]);
    const double curvature = face == other ? faceCurvature(surface, face, nodes.normals[node], v)
                                           : foldCurvature(surface, face, other, v);
    return surface.isInsideOut ? -curvature : curvature;
  };
  result.chains = chains.polylines;
  result.kinds.assign(result.chains.size(), kind);
  result.positions.reserve(chains.nodes.size());
  for (std::size_t chain = 0; chain < result.chains.size(); ++chain)
  {
    const std::size_t begin = result.chains.offsets[chain];
    const std::size_t end = result.chains.offsets[chain + 1];
    for (std::size_t point = begin; point < end; ++point)
    {
      const std::uint32_t node = chains.nodes[point];
      const std::uint32_t segment = chains.segments[point];
      result.positions.push_back(nodes.positions[node]);
      if (arrays.normals)
      {
        result.normals.emplace_back(nodes.normals[node]);
      }
      if (wantCurvature)
      {
        const bool closed = result.chains.closed[chain] != 0;
        const std::uint32_t before = chains.segments[point > begin ? point - 1 : closed ? end - 1 : point];
        result.radialCurvature.push_back(
          static_cast<float>(0.5 * (curvatureOf(node, before) + curvatureOf(node, segment))));
      }
      if (arrays.elements)
      {
        result.elements.push_back(surface.faceIds[segments[segment].face]);
      }
    }
  }
  if (arrays.radialCurvature && !wantCurvature)
  {
    result.radialCurvature.assign(result.positions.size(), 0.0f);
  }
  joinCoincidentPoints(result);
  if (arrays.arcLength)
  {
    measureArcLength(result);
  }
  return result;
}

} // namespace ink
