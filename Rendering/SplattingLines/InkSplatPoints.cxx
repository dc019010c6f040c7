// SPDX-License-Identifier: BSD-3-Clause
#include "InkSplatPoints.h"

#include "InkGhostPoint.h"

#include "vtkMath.h"
#include "vtkPoints.h"

#include "Core/ParallelChunks.h"
#include "PointSampling/PointCloud/PointSpacing.h"

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <span>
#include <vector>

namespace
{

/// Of those that can be drawn.
struct VisiblePoints
{
  vtkIdType Number = 0;
  float LargestRadius = 0.0f;
  glm::vec3 Least = glm::vec3(std::numeric_limits<float>::infinity());
  glm::vec3 Greatest = glm::vec3(-std::numeric_limits<float>::infinity());

  static VisiblePoints Join(const VisiblePoints& a, const VisiblePoints& b)
  {
    return { a.Number + b.Number, std::max(a.LargestRadius, b.LargestRadius), glm::min(a.Least, b.Least),
      glm::max(a.Greatest, b.Greatest) };
  }
};

} // namespace

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
  ink::parallelForEach(static_cast<std::size_t>(count),
    [&](std::size_t i)
    {
      double p[3];
      points->GetPoint(static_cast<vtkIdType>(i), p);
      this->Frame.ToLocal(p, position + 3 * i);
      if (InkIsGhostPoint(ghosts, static_cast<vtkIdType>(i)))
      {
        // As points without a position, which take no part in anything.
        std::fill_n(position + 3 * i, 3, std::numeric_limits<float>::quiet_NaN());
      }
    });
  this->Positions->Modified();

  float sharedRadius = 0.0f;
  if (!radii)
  {
    sharedRadius = radius > 0.0 ? static_cast<float>(radius / this->Frame.Unit) : this->EstimateRadius();
  }

  this->NormalsAndRadii->SetNumberOfComponents(4);
  this->NormalsAndRadii->SetNumberOfTuples(count);
  float* normalsAndRadii = this->NormalsAndRadii->GetPointer(0);
  const auto read = [&](std::size_t i)
  {
    const auto point = static_cast<vtkIdType>(i);
    float* p = position + 3 * i;
    float* normalAndRadius = normalsAndRadii + 4 * i;
    double n[3];
    normals->GetTuple(point, n);
    const float r =
      radii ? static_cast<float>(radii->GetComponent(point, 0) / this->Frame.Unit) : sharedRadius;
    const double length = vtkMath::Norm(n);
    const bool visible = length > 0.0 && std::isfinite(length) && r > 0.0f && std::isfinite(r) &&
      std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
    for (int axis = 0; axis < 3; ++axis)
    {
      normalAndRadius[axis] = visible ? static_cast<float>(n[axis] / length) : 0.0f;
      p[axis] = visible ? p[axis] : 0.0f;
    }
    normalAndRadius[3] = visible ? r : 0.0f;
    return visible ? VisiblePoints{ 1, r, { p[0], p[1], p[2] }, { p[0], p[1], p[2] } } : VisiblePoints{};
  };
  const auto visible =
    ink::parallelReduce(static_cast<std::size_t>(count), VisiblePoints{}, read, &VisiblePoints::Join);
  this->NumberOfVisiblePoints = visible.Number;
  this->LargestRadius = visible.LargestRadius;
  this->Bounds = {};
  for (int axis = 0; axis < 3 && visible.Number > 0; ++axis)
  {
    this->Bounds[2 * axis] = visible.Least[axis];
    this->Bounds[2 * axis + 1] = visible.Greatest[axis];
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
