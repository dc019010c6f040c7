// SPDX-License-Identifier: BSD-3-Clause
#include "InkPointCloud.h"

#include "InkPointOutput.h"
#include "InkVTKCompat.h"
#include "Sampling/PointNormals.h"
#include "Sampling/PointSpacing.h"
#include "Sampling/PriorityOrder.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{

/// The positions from the middle of their bounds, so that single precision does for them, in units of the
/// largest extent.
std::vector<glm::vec3> GetLocalPositions(vtkPointSet* points, double& unit)
{
  const auto count = static_cast<std::size_t>(points->GetNumberOfPoints());
  std::vector<glm::dvec3> exact(count);
  glm::dvec3 low(std::numeric_limits<double>::infinity());
  glm::dvec3 high(-low);
  for (std::size_t i = 0; i < count; ++i)
  {
    points->GetPoint(static_cast<vtkIdType>(i), &exact[i].x);
    if (std::isfinite(exact[i].x) && std::isfinite(exact[i].y) && std::isfinite(exact[i].z))
    {
      low = glm::min(low, exact[i]);
      high = glm::max(high, exact[i]);
    }
  }
  const glm::dvec3 size = high - low;
  unit = std::max({ size.x, size.y, size.z });
  unit = unit > 0.0 && std::isfinite(unit) ? unit : 1.0;
  std::vector<glm::vec3> positions(count);
  std::transform(exact.begin(), exact.end(), positions.begin(),
    [&](const glm::dvec3& point) { return glm::vec3((point - 0.5 * (low + high)) / unit); });
  return positions;
}

vtkDataArray* GetPointArray(vtkPointSet* points, const char* name, int components)
{
  vtkDataArray* array = points->GetPointData()->GetArray(name);
  if (array &&
    (array->GetNumberOfComponents() != components ||
      array->GetNumberOfTuples() != points->GetNumberOfPoints()))
  {
    throw std::invalid_argument("the point array " + std::string(name) + " has " +
      std::to_string(array->GetNumberOfTuples()) + " values of " +
      std::to_string(array->GetNumberOfComponents()) + " components; expected " +
      std::to_string(points->GetNumberOfPoints()) + " of " + std::to_string(components));
  }
  return array;
}

} // namespace

void InkPreparePointCloud(
  vtkPointSet* input, const InkPointCloudOptions& options, vtkAlgorithm* algorithm, vtkPolyData* output)
{
  const vtkIdType count = input->GetNumberOfPoints();
  if (count >= static_cast<vtkIdType>(std::numeric_limits<std::uint32_t>::max()))
  {
    throw std::invalid_argument(
      "there are " + std::to_string(count) + " points; expected fewer than 4294967295");
  }
  double done = 0.0;
  double share = 0.5;
  const ink::Progress progress = [&](double part)
  {
    algorithm->UpdateProgress(done + share * part);
    return !InkCheckAbort(algorithm);
  };
  double unit = 1.0;
  const std::vector<glm::vec3> positions = GetLocalPositions(input, unit);

  vtkDataArray* given = input->GetPointData()->GetNormals();
  given = given ? given : GetPointArray(input, "Normals", 3);
  std::vector<glm::vec3> normals;
  const bool estimated = !given && options.Normals;
  if (estimated)
  {
    normals = ink::estimateNormals(positions, 16, progress);
    if (normals.size() != positions.size())
    {
      return;
    }
  }
  else if (given)
  {
    normals.resize(positions.size());
    for (std::size_t i = 0; i < normals.size(); ++i)
    {
      double normal[3];
      given->GetTuple(static_cast<vtkIdType>(i), normal);
      normals[i] = glm::vec3(normal[0], normal[1], normal[2]);
    }
  }
  done = 0.5;
  vtkDataArray* radius = GetPointArray(input, "Radius", 1);
  std::vector<std::uint32_t> order(positions.size());
  std::iota(order.begin(), order.end(), 0u);
  if (options.Priority)
  {
    std::vector<float> radii(radius ? positions.size() : 0);
    for (std::size_t i = 0; i < radii.size(); ++i)
    {
      radii[i] = static_cast<float>(radius->GetComponent(static_cast<vtkIdType>(i), 0) / unit);
    }
    const bool usable =
      std::all_of(radii.begin(), radii.end(), [](float r) { return r > 0.0f && std::isfinite(r); });
    order = ink::priorityOrder(positions, normals, usable ? radii : std::vector<float>(),
      static_cast<std::uint64_t>(options.Seed), progress);
    if (order.size() != positions.size())
    {
      return;
    }
  }
  InkReorderPoints(input, order, output);
  vtkPointData* pointData = output->GetPointData();
  if (estimated)
  {
    vtkNew<vtkFloatArray> array;
    array->SetName("Normals");
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(count);
    for (vtkIdType i = 0; i < count; ++i)
    {
      array->SetTuple(i, &normals[order[static_cast<std::size_t>(i)]].x);
    }
    pointData->SetNormals(array);
  }
  else if (!pointData->GetNormals() && given)
  {
    pointData->SetNormals(pointData->GetArray(given->GetName()));
  }
  if (options.Radius && !radius)
  {
    const double spacing = unit * static_cast<double>(ink::discRadiusFromSpacing(positions));
    pointData->AddArray(InkMakeConstant("Radius", output->GetPoints()->GetDataType(), count, spacing));
  }
  if (options.Priority)
  {
    pointData->AddArray(InkMakePriority(count));
  }
  if (options.Vertices)
  {
    output->SetVerts(InkMakePolyVertex(count));
  }
}
