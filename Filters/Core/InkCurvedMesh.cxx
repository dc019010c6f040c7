// SPDX-License-Identifier: BSD-3-Clause
#include "InkCurvedMesh.h"

#include "InkAllocate.h"
#include "InkFeatureNormals.h"
#include "InkMeshTriangles.h"
#include "InkSourcePoints.h"

#include "Core/IsFinite.h"
#include "Mesh/CurvedMesh.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace
{

// In diagonals of the mesh's bounds: what a picture of 1,000 pixels hardly shows, but not noise on the edges
// of a fine mesh.
constexpr double Deviation = 2.5e-4;
constexpr double Length = 0.01;
constexpr std::size_t MostTriangles = 1'000'000;

/// Of the bounds of its triangles.
double DiagonalOf(const InkMeshTriangles& mesh)
{
  glm::dvec3 lower(std::numeric_limits<double>::max());
  glm::dvec3 upper(std::numeric_limits<double>::lowest());
  for (const ink::Triangle& triangle : mesh.Triangles)
  {
    for (const std::uint32_t corner : triangle)
    {
      if (ink::isFinite(mesh.Points[corner]))
      {
        lower = glm::min(lower, mesh.Points[corner]);
        upper = glm::max(upper, mesh.Points[corner]);
      }
    }
  }
  return lower.x <= upper.x ? glm::distance(lower, upper) : 0.0;
}

bool HasLongEdge(const InkMeshTriangles& triangles, double length)
{
  return std::any_of(triangles.Triangles.begin(), triangles.Triangles.end(),
    [&](const ink::Triangle& corners)
    {
      const auto isLong = [&](std::size_t i, std::size_t j)
      { return glm::distance(triangles.Points[corners[i]], triangles.Points[corners[j]]) > length; };
      return isLong(0, 1) || isLong(1, 2) || isLong(2, 0);
    });
}

/// Of each further point the nearer one of the mesh's points that the edge's ends are nearest to.
std::vector<vtkIdType> FindNearest(const ink::CurvedMesh& curved, std::size_t before)
{
  std::vector<vtkIdType> nearest;
  nearest.reserve(curved.ends.size());
  for (std::size_t i = 0; i < curved.ends.size(); ++i)
  {
    const auto meshPoint = [&](std::uint32_t end) {
      return end < before ? static_cast<std::size_t>(end) : static_cast<std::size_t>(nearest[end - before]);
    };
    const std::size_t a = meshPoint(curved.ends[i][0]);
    const std::size_t b = meshPoint(curved.ends[i][1]);
    const glm::dvec3& point = curved.points[before + i];
    const bool isFirst = glm::distance(point, curved.points[a]) <= glm::distance(point, curved.points[b]);
    nearest.push_back(static_cast<vtkIdType>(isFirst ? a : b));
  }
  return nearest;
}

void CopyPoints(const ink::CurvedMesh& curved, vtkPolyData* mesh, vtkPolyData* output)
{
  const vtkIdType before = mesh->GetNumberOfPoints();
  const auto count = static_cast<vtkIdType>(curved.points.size());
  vtkNew<vtkPoints> points;
  points->SetDataType(mesh->GetPoints()->GetDataType());
  InkSetNumberOfPoints(points, count);
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  InkSetNumberOfTuples(normals, count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    points->SetPoint(i, &curved.points[static_cast<std::size_t>(i)].x);
    normals->SetTuple(i, &curved.normals[static_cast<std::size_t>(i)].x);
  }
  // What is made here is left out before, so that arrays have the same numbers in both.
  vtkNew<vtkPointData> given;
  given->ShallowCopy(mesh->GetPointData());
  given->SetNormals(nullptr);
  given->RemoveArray("Normals");
  given->RemoveArray(InkSourcePointsName);
  vtkPointData* data = output->GetPointData();
  for (int attribute = 0; attribute < vtkDataSetAttributes::NUM_ATTRIBUTES; ++attribute)
  {
    if (!data->GetCopyAttribute(attribute, vtkDataSetAttributes::INTERPOLATE))
    {
      given->SetAttribute(nullptr, attribute); // ids
    }
  }
  data->InterpolateAllocate(given, count);
  for (vtkIdType i = 0; i < before; ++i)
  {
    data->CopyData(given, i, i);
  }
  for (vtkIdType i = before; i < count; ++i)
  {
    const auto& [a, b] = curved.ends[static_cast<std::size_t>(i - before)];
    data->InterpolateEdge(data, i, a, b, 0.5);
  }
  data->SetNormals(normals);
  output->SetPoints(points);
  InkSetSourcePoints(output, mesh, FindNearest(curved, static_cast<std::size_t>(before)));
}

void CopyTriangles(
  const ink::CurvedMesh& curved, const InkMeshTriangles& triangles, vtkPolyData* mesh, vtkPolyData* output)
{
  const auto count = static_cast<vtkIdType>(curved.triangles.size());
  vtkNew<vtkCellArray> polygons;
  polygons->AllocateExact(count, 3 * count);
  vtkCellData* data = output->GetCellData();
  data->CopyGlobalIdsOff();
  data->CopyAllocate(mesh->GetCellData(), count);
  for (vtkIdType t = 0; t < count; ++t)
  {
    const auto& [a, b, c] = curved.triangles[static_cast<std::size_t>(t)];
    polygons->InsertNextCell({ a, b, c });
    data->CopyData(mesh->GetCellData(), triangles.FaceIds[curved.sources[static_cast<std::size_t>(t)]], t);
  }
  output->SetPolys(polygons);
}

} // namespace

vtkSmartPointer<vtkPolyData> InkCurvedMesh(vtkPolyData* mesh, const ink::Progress& progress)
{
  constexpr auto ofMesh = InkMeshTriangles::Order::OfMesh;
  const InkMeshTriangles coarse(mesh, false, ofMesh);
  const double diagonal = DiagonalOf(coarse);
  const ink::CurvedMeshOptions options{ Deviation * diagonal, Length * diagonal, MostTriangles };
  if (coarse.Triangles.size() >= MostTriangles || !HasLongEdge(coarse, options.length))
  {
    return mesh;
  }
  const vtkSmartPointer<vtkPolyData> smooth = InkWithFeatureNormals(mesh);
  const InkMeshTriangles triangles(smooth, true, ofMesh);
  const ink::CurvedMesh curved = ink::curveMesh(triangles.GetMesh(), triangles.Normals, options, progress);
  if (curved.triangles.size() == triangles.Triangles.size())
  {
    return mesh;
  }
  auto output = vtkSmartPointer<vtkPolyData>::New();
  CopyPoints(curved, smooth, output);
  CopyTriangles(curved, triangles, smooth, output);
  output->GetFieldData()->PassData(mesh->GetFieldData());
  return output;
}
