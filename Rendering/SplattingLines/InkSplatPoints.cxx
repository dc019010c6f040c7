// SPDX-License-Identifier: BSD-3-Clause
#include "InkSplatPoints.h"

#include "vtkMath.h"
#include "vtkPoints.h"

#include "Sampling/PointSpacing.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{

bool IsFinite(const double p[3])
{
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

} // namespace

void InkSplatPoints::FindFiniteBounds(vtkPoints* points, double bounds[6])
{
  vtkMath::UninitializeBounds(bounds);
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double p[3];
    points->GetPoint(i, p);
    if (IsFinite(p))
    {
      const bool first = !vtkMath::AreBoundsInitialized(bounds);
      for (int axis = 0; axis < 3; ++axis)
      {
        bounds[2 * axis] = first ? p[axis] : std::min(bounds[2 * axis], p[axis]);
        bounds[2 * axis + 1] = first ? p[axis] : std::max(bounds[2 * axis + 1], p[axis]);
      }
    }
  }
}

void InkSplatPoints::FindCenterAndUnit(vtkPoints* points)
{
  // vtkPoints' own bounds may count points that are not finite.
  double bounds[6];
  InkSplatPoints::FindFiniteBounds(points, bounds);
  const bool any = vtkMath::AreBoundsInitialized(bounds);
  this->Unit = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Center[axis] = any ? 0.5 * bounds[2 * axis] + 0.5 * bounds[2 * axis + 1] : 0.0;
    this->Unit = any ? std::max(this->Unit, bounds[2 * axis + 1] - bounds[2 * axis]) : this->Unit;
  }
  if (!(this->Unit > 0.0) || !std::isfinite(this->Unit))
  {
    this->Unit = 1.0;
  }
}

float InkSplatPoints::EstimateRadius() const
{
  const auto* positions = reinterpret_cast<const glm::vec3*>(this->Positions->GetPointer(0));
  const float radius =
    ink::discRadiusFromSpacing({ positions, static_cast<std::size_t>(this->Positions->GetNumberOfTuples()) });
  return radius > 0.0f ? radius : 1.0f;
}

void InkSplatPoints::Read(vtkPoints* points, vtkDataArray* normals, vtkDataArray* radii, double radius)
{
  this->FindCenterAndUnit(points);

  const vtkIdType count = points->GetNumberOfPoints();
  this->Positions->SetNumberOfComponents(3);
  this->Positions->SetNumberOfTuples(count);
  float* position = this->Positions->GetPointer(0);
  for (vtkIdType i = 0; i < count; ++i, position += 3)
  {
    double p[3];
    points->GetPoint(i, p);
    for (int axis = 0; axis < 3; ++axis)
    {
      position[axis] = static_cast<float>((p[axis] - this->Center[axis]) / this->Unit);
    }
  }
  this->Positions->Modified();

  float sharedRadius = 0.0f;
  if (!radii)
  {
    sharedRadius = radius > 0.0 ? static_cast<float>(radius / this->Unit) : this->EstimateRadius();
  }

  this->NormalsAndRadii->SetNumberOfComponents(4);
  this->NormalsAndRadii->SetNumberOfTuples(count);
  this->NumberOfVisiblePoints = 0;
  this->LargestRadius = 0.0;
  position = this->Positions->GetPointer(0);
  float* normalAndRadius = this->NormalsAndRadii->GetPointer(0);
  for (vtkIdType i = 0; i < count; ++i, position += 3, normalAndRadius += 4)
  {
    double n[3];
    normals->GetTuple(i, n);
    const float r = radii ? static_cast<float>(radii->GetComponent(i, 0) / this->Unit) : sharedRadius;
    const double length = vtkMath::Norm(n);
    const bool visible = length > 0.0 && std::isfinite(length) && r > 0.0f && std::isfinite(r) &&
      std::isfinite(position[0]) && std::isfinite(position[1]) && std::isfinite(position[2]);
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
}

void InkSplatPoints::ReleaseArrays()
{
  this->Positions->Initialize();
  this->NormalsAndRadii->Initialize();
}
