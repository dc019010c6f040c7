// SPDX-License-Identifier: BSD-3-Clause
#include "InkPlaceSamples.h"

#include "Core/ParallelChunks.h"
#include "InkAllocate.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPoints.h"

#include <span>

namespace
{

template <class Real>
void Place(const ink::TriangleMesh& mesh, const std::vector<ink::SurfaceSample>& samples, Real* points)
{
  ink::parallelForEach(samples.size(),
    [&](std::size_t i)
    {
      const glm::dvec3 point = ink::positionOf(mesh, samples[i]);
      for (int axis = 0; axis < 3; ++axis)
      {
        points[3 * i + axis] = static_cast<Real>(point[axis]);
      }
    });
}

} // namespace

vtkSmartPointer<vtkPoints> InkPlacePoints(
  const ink::TriangleMesh& mesh, const std::vector<ink::SurfaceSample>& samples, int type)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataType(type == VTK_DOUBLE ? VTK_DOUBLE : VTK_FLOAT);
  InkSetNumberOfPoints(points, static_cast<vtkIdType>(samples.size()));
  if (auto* floats = vtkFloatArray::SafeDownCast(points->GetData()))
  {
    Place(mesh, samples, floats->GetPointer(0));
  }
  else
  {
    Place(mesh, samples, vtkDoubleArray::SafeDownCast(points->GetData())->GetPointer(0));
  }
  return points;
}

vtkSmartPointer<vtkFloatArray> InkPlaceNormals(const ink::TriangleMesh& mesh,
  const std::vector<glm::vec3>& normals, const std::vector<ink::SurfaceSample>& samples)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName("Normals");
  array->SetNumberOfComponents(3);
  InkSetNumberOfTuples(array, static_cast<vtkIdType>(samples.size()));
  ink::placeNormals(mesh, normals, samples, std::span<float>(array->GetPointer(0), 3 * samples.size()));
  return array;
}
