// SPDX-License-Identifier: BSD-3-Clause
// Edges of polygons as strokes.
#include "InkMeshTriangles.h"
#include "InkSourcePoints.h"
#include "InkStrokePoints.h"

#include "Core/Hash.h"
#include "Curves/Contours/ContourSurface.h"
#include "Curves/Contours/SurfaceEdges.h"

#include "vtkCellArray.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

InkStrokeArrays::Key InkEdgeArrays::GetKey() const
{
  return { this->Surface->GetMTime() };
}

std::string InkEdgeArrays::FindProblem() const
{
  // Positions on the GPU are ints, six for each of two points.
  constexpr vtkIdType most = std::numeric_limits<int>::max() / 12;
  // Of n corners of a polygon or strip there are n - 2 triangles, none of whose edges may be another's, too.
  vtkCellArray* polygons = this->Surface->GetPolys();
  vtkCellArray* strips = this->Surface->GetStrips();
  const vtkIdType corners = polygons->GetNumberOfConnectivityIds() + strips->GetNumberOfConnectivityIds();
  const vtkIdType edges = 3 * (corners - 2 * (polygons->GetNumberOfCells() + strips->GetNumberOfCells()));
  std::ostringstream message;
  if (edges > most)
  {
    message << "Up to " << most << " edges can be drawn; found polygons with " << edges << '.';
  }
  return message.str();
}

void InkStrokePoints::Read(const InkEdgeArrays& arrays)
{
  *this = {};
  double bounds[6];
  InkShiftScale::FindFiniteBounds(arrays.Surface->GetPoints(), bounds);
  this->Frame = InkShiftScale::FromBounds(bounds);
  this->LocalBounds = { INFINITY, -INFINITY, INFINITY, -INFINITY, INFINITY, -INFINITY };
  const InkMeshTriangles mesh(arrays.Surface, false, InkMeshTriangles::Order::OfMesh);
  // Without normals the polygons' own tell which side is the outside.
  const ink::ContourSurface surface(mesh.GetMesh(), {});
  vtkIdTypeArray* sources = InkGetSourcePoints(arrays.Surface);
  const double outwards = surface.isInsideOut ? -1.0 : 1.0;
  const auto add = [&](const ink::FaceEdge& one, const ink::FaceEdge& other)
  {
    const int first = static_cast<int>(this->Points.size());
    const ink::Triangle& triangle = mesh.Triangles[surface.faceIds[one.face]];
    const std::uint32_t corners[2] = { one.site0, one.site1 };
    for (int end = 0; end < 2; ++end)
    {
      Point point{ {}, 0.0f };
      this->Frame.ToLocal(&surface.corners[corners[end]].position.x, point.Position);
      const glm::vec3 normal(outwards * surface.faceNormal(end == 0 ? one.face : other.face));
      this->Points.push_back(point);
      this->Shapes.push_back({ { normal.x, normal.y, normal.z }, 1.0f });
      const auto id = static_cast<vtkIdType>(triangle[static_cast<std::size_t>(one.corner)]);
      this->Sources.push_back(id);
      this->Ids.push_back(static_cast<std::uint32_t>(InkSourcePoint(sources, id)));
      this->AddToBounds(point.Position);
    }
    const auto edge = static_cast<std::uint64_t>(first / 2);
    const auto cell = mesh.FaceIds[surface.faceIds[one.face]];
    Stroke stroke{ first, first + 1, cell, 0.0f, 0.0f, 0.0f, false };
    stroke.Priority = static_cast<float>(ink::unitDouble(ink::hash(edge)));
    this->Strokes.push_back(stroke);
  };
  ink::visitEdges(
    surface, [](std::uint32_t from, std::uint32_t to) { return from != to; },
    [&](std::span<const ink::FaceEdge> faces)
    {
      for (std::size_t face = 0; face < faces.size(); face += 2)
      {
        add(faces[face], faces[std::min(face + 1, faces.size() - 1)]);
      }
    });
}
