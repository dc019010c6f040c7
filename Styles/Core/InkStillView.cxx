// SPDX-License-Identifier: BSD-3-Clause
#include "InkStillView.h"

#include "InkCameraEye.h"
#include "InkMeshTriangles.h"
#include "Mesh/TrianglesWithin.h"
#include "Visibility/SeenTriangles.h"

#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPlanes.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

vtkSmartPointer<vtkPlanes> InkSeenRegion(vtkPoints* points, vtkCamera* camera)
{
  constexpr double margin = 0.1;
  vtkNew<vtkCamera> wider;
  wider->DeepCopy(camera);
  wider->Zoom(1.0 / (1.0 + 2.0 * margin));
  // Left, right, bottom, top, near and far; a x + b y + c z + d > 0 is inside.
  std::array<double, 24> planes;
  wider->GetFrustumPlanes(camera->GetExplicitAspectRatio(), planes.data());
  std::array<ink::HalfSpace, 4> sides;
  vtkNew<vtkPoints> origins;
  vtkNew<vtkDoubleArray> normals;
  normals->SetNumberOfComponents(3);
  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    const double* plane = &planes[4 * i];
    sides[i] = { -glm::dvec3(plane[0], plane[1], plane[2]), plane[3] };
    const glm::dvec3 origin = sides[i].offset * sides[i].normal;
    origins->InsertNextPoint(&origin.x);
    normals->InsertNextTuple(&sides[i].normal.x);
  }
  vtkIdType within = 0;
  for (glm::dvec3 p; within < points->GetNumberOfPoints(); ++within)
  {
    points->GetPoint(within, &p.x);
    if (!ink::areContaining(sides, p))
    {
      break;
    }
  }
  if (within == points->GetNumberOfPoints())
  {
    return nullptr;
  }
  auto region = vtkSmartPointer<vtkPlanes>::New();
  region->SetPoints(origins);
  region->SetNormals(normals);
  return region;
}

vtkSmartPointer<vtkPolyData> InkSeenPart(vtkPolyData* surface, vtkCamera* camera, double margin)
{
  const InkMeshTriangles triangles(surface, false, InkMeshTriangles::Order::OfMesh);
  glm::dvec3 axis;
  camera->GetDirectionOfProjection(&axis.x);
  const std::vector<std::uint32_t> seen =
    ink::seenTriangles(triangles.GetMesh(), InkCameraEye(camera), axis, margin);
  if (seen.size() == triangles.Triangles.size())
  {
    return surface;
  }
  std::vector<vtkIdType> cells;
  cells.reserve(seen.size());
  for (const std::uint32_t triangle : seen)
  {
    cells.push_back(triangles.FaceIds[triangle]);
  }
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  vtkNew<vtkIdList> kept;
  kept->SetNumberOfIds(static_cast<vtkIdType>(cells.size()));
  std::copy(cells.begin(), cells.end(), kept->GetPointer(0));
  auto part = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(surface->GetPoints()->GetDataType());
  part->SetPoints(points);
  part->AllocateProportional(surface, static_cast<double>(cells.size()) / surface->GetNumberOfCells());
  part->GetPointData()->CopyAllocate(surface->GetPointData());
  part->GetCellData()->CopyAllocate(surface->GetCellData());
  part->CopyCells(surface, kept);
  part->GetFieldData()->PassData(surface->GetFieldData());
  return part;
}
