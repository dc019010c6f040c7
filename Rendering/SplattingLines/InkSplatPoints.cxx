// SPDX-License-Identifier: BSD-3-Clause
#include "InkSplatPoints.h"

#include "vtkMath.h"
#include "vtkPoints.h"

#include "PointSampling/PointCloud/PointSpacing.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>
#include <vector>

float InkSplatPoints::EstimateRadius() const
{
  const std::span<const glm::vec3> all(reinterpret_cast<const glm::vec3*>(this->Positions->GetPointer(0)),
    static_cast<std::size_t>(this->Positions->GetNumberOfTuples()));
  const auto isFinite = [](const glm::vec3& p)
  { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); };
  // The estimate looks at some of those that it is given.
  std::vector<glm::vec3> drawn;
  if (!std::all_of(all.begin(), all.end(), isFinite))
  {
    std::copy_if(all.begin(), all.end(), std::back_inserter(drawn), isFinite);
  }
  const float radius = ink::discRadiusFromSpacing(drawn.empty() ? all : drawn);
  return radius > 0.0f ? radius : 1.0f;
}

void InkSplatPoints::ReadEdges(vtkDataArray* edges)
{
  for (std::size_t edge = 0; edge < this->Edges.size(); ++edge)
  {
    vtkFloatArray* offsets = this->Edges[edge];
    offsets->Initialize();
    offsets->SetNumberOfComponents(3);
    offsets->SetNumberOfTuples(edges ? edges->GetNumberOfTuples() : 0);
    for (vtkIdType i = 0; i < offsets->GetNumberOfTuples(); ++i)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        const double offset = edges->GetComponent(i, 3 * static_cast<int>(edge) + axis) / this->Frame.Unit;
        offsets->SetTypedComponent(i, axis, std::isfinite(offset) ? static_cast<float>(offset) : 0.0f);
      }
    }
    offsets->Modified();
  }
}

void InkSplatPoints::Read(vtkPoints* points, vtkDataArray* normals, vtkDataArray* radii, vtkDataArray* edges,
  double radius, vtkUnsignedCharArray* ghosts)
{
  double bounds[6];
  InkShiftScale::FindFiniteBounds(points, bounds, ghosts);
  this->Frame = InkShiftScale::FromBounds(bounds);

  const vtkIdType count = points->GetNumberOfPoints();
  this->Positions->SetNumberOfComponents(3);
  this->Positions->SetNumberOfTuples(count);
  float* position = this->Positions->GetPointer(0);
  for (vtkIdType i = 0; i < count; ++i, position += 3)
  {
    double p[3];
    points->GetPoint(i, p);
    this->Frame.ToLocal(p, position);
    if (InkIsGhostPoint(ghosts, i))
    {
      // As points without a position, which take no part in anything.
      std::fill_n(position, 3, std::numeric_limits<float>::quiet_NaN());
    }
  }
  this->Positions->Modified();

  float sharedRadius = 0.0f;
  if (!radii)
  {
    sharedRadius = radius > 0.0 ? static_cast<float>(radius / this->Frame.Unit) : this->EstimateRadius();
  }

  this->NormalsAndRadii->SetNumberOfComponents(4);
  this->NormalsAndRadii->SetNumberOfTuples(count);
  this->NumberOfVisiblePoints = 0;
  this->LargestRadius = 0.0;
  this->Bounds = {};
  position = this->Positions->GetPointer(0);
  float* normalAndRadius = this->NormalsAndRadii->GetPointer(0);
  for (vtkIdType i = 0; i < count; ++i, position += 3, normalAndRadius += 4)
  {
    double n[3];
    normals->GetTuple(i, n);
    const float r = radii ? static_cast<float>(radii->GetComponent(i, 0) / this->Frame.Unit) : sharedRadius;
    const double length = vtkMath::Norm(n);
    const bool visible = length > 0.0 && std::isfinite(length) && r > 0.0f && std::isfinite(r) &&
      std::isfinite(position[0]) && std::isfinite(position[1]) && std::isfinite(position[2]);
    for (int axis = 0; axis < 3 && visible; ++axis)
    {
      float* range = this->Bounds.data() + 2 * axis;
      range[0] = this->NumberOfVisiblePoints > 0 ? std::min(range[0], position[axis]) : position[axis];
      range[1] = this->NumberOfVisiblePoints > 0 ? std::max(range[1], position[axis]) : position[axis];
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      normalAndRadius[axis] = visible ? static_cast<float>(n[axis] / length) : 0.0f;
      position[axis] = visible ? position[axis] : 0.0f;
    }
    normalAndRadius[3] = visible ? r : 0.0f;
    this->LargestRadius = visible ? std::max<double>(this->LargestRadius, r) : this->LargestRadius;
    this->NumberOfVisiblePoints += visible;
  }
  this->NormalsAndRadii->Modified();
  this->ReadEdges(edges);
}

void InkSplatPoints::ReleaseArrays()
{
  this->Positions->Initialize();
  this->NormalsAndRadii->Initialize();
  for (vtkFloatArray* edges : this->GetEdges())
  {
    edges->Initialize();
  }
}
