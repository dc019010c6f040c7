// SPDX-License-Identifier: BSD-3-Clause
#include "InkMeshContourFinder.h"

#include "InkSourcePoints.h"

#include <cstddef>
#include <vector>

bool InkMeshContourFinder::Update(vtkPolyData* mesh, const ink::MeshContourOptions& options)
{
  const bool sameMesh = this->Triangles && this->Mesh == mesh && this->MeshTime == mesh->GetMTime();
  if (sameMesh && this->Finder && this->Options == options)
  {
    return false;
  }
  this->SetReady(false);
  this->Finder.reset();
  if (!sameMesh)
  {
    this->Triangles.reset();
    this->Triangles.emplace(mesh, true, InkMeshTriangles::Order::OfMesh);
    this->Mesh = mesh;
    this->MeshTime = mesh->GetMTime();
  }
  this->Finder.emplace(this->Triangles->GetMesh(), this->Triangles->Normals, options);
  this->Options = options;
  this->SetReady(true);
  return !sameMesh;
}

InkContourFinder::Found InkMeshContourFinder::Find(const ink::Eye& eye) const
{
  Found found{ this->Finder->find(eye, { true, this->Finder->isClosed(), true, true }), nullptr };
  vtkIdTypeArray* sources = InkGetSourcePoints(this->Mesh);
  std::vector<vtkIdType> beside;
  for (const std::int64_t element : found.Contours.elements)
  {
    const vtkIdType point = this->Triangles->Triangles[static_cast<std::size_t>(element)][0];
    beside.push_back(InkSourcePoint(sources, point));
  }
  found.Lines = MakeLines(found.Contours, this->Triangles->FaceIds, beside);
  return found;
}
