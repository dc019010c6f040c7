// SPDX-License-Identifier: BSD-3-Clause
#include "InkPointCloud.h"

#include "InkAllocate.h"
#include "InkExtractPoints.h"
#include "InkPointNormals.h"
#include "InkPointOutput.h"
#include "InkVTKCompat.h"
#include "PointSampling/PointCloud/PointNormals.h"
#include "PointSampling/PointCloud/PointRadii.h"
#include "PointSampling/PointCloud/PointSpacing.h"
#include "PointSampling/ProgressiveOrder.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace
{

/// The positions relative to the center of their bounds, in units of the largest extent, so that single
/// precision suffices.
std::vector<glm::vec3> GetLocalPositions(vtkPointSet* points, double& unit, glm::dvec3& origin)
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
  origin = 0.5 * (low + high);
  std::vector<glm::vec3> positions(count);
  std::transform(exact.begin(), exact.end(), positions.begin(),
    [&](const glm::dvec3& point) { return glm::vec3((point - origin) / unit); });
  return positions;
}

/// The points without those that vtkGhostType marks as hidden or duplicate; null if it marks none.
vtkSmartPointer<vtkPolyData> WithoutGhosts(vtkPointSet* points)
{
  constexpr unsigned char marks = vtkDataSetAttributes::HIDDENPOINT | vtkDataSetAttributes::DUPLICATEPOINT;
  vtkUnsignedCharArray* ghosts = points->GetPointGhostArray();
  if (!ghosts || ghosts->GetNumberOfTuples() != points->GetNumberOfPoints())
  {
    return nullptr;
  }
  std::vector<std::uint32_t> own;
  for (vtkIdType i = 0; i < ghosts->GetNumberOfTuples(); ++i)
  {
    if ((ghosts->GetValue(i) & marks) == 0)
    {
      own.push_back(static_cast<std::uint32_t>(i));
    }
  }
  if (own.size() == static_cast<std::size_t>(points->GetNumberOfPoints()))
  {
    return nullptr;
  }
  auto kept = vtkSmartPointer<vtkPolyData>::New();
  InkExtractPoints(points, own, kept);
  kept->GetPointData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  return kept;
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

template <class Value>
std::vector<Value> Pick(const std::vector<Value>& values, const std::vector<std::uint32_t>& which)
{
  std::vector<Value> picked;
  if (!values.empty())
  {
    picked.reserve(which.size());
    std::transform(
      which.begin(), which.end(), std::back_inserter(picked), [&](std::uint32_t i) { return values[i]; });
  }
  return picked;
}

bool AreRadii(const std::vector<float>& radii)
{
  return std::all_of(radii.begin(), radii.end(), [](float r) { return r > 0.0f && std::isfinite(r); });
}

} // namespace

vtkIdType InkPreparePointCloud(
  vtkPointSet* input, const InkPointCloudOptions& options, vtkAlgorithm* algorithm, vtkPolyData* output)
{
  if (input->GetNumberOfPoints() >= static_cast<vtkIdType>(std::numeric_limits<std::uint32_t>::max()))
  {
    throw std::invalid_argument(
      "there are " + std::to_string(input->GetNumberOfPoints()) + " points; expected fewer than 4294967295");
  }
  if (const vtkSmartPointer<vtkPolyData> own = WithoutGhosts(input))
  {
    return own->GetNumberOfPoints() > 0 ? InkPreparePointCloud(own, options, algorithm, output) : 0;
  }
  double done = 0.0;
  double share = 0.0;
  const ink::Progress progress = [&](double part)
  {
    algorithm->UpdateProgress(done + share * part);
    return !InkCheckAbort(algorithm);
  };
  const auto next = [&](double part)
  {
    done += share;
    share = part;
  };
  double unit = 1.0;
  glm::dvec3 origin(0.0);
  std::vector<glm::vec3> positions = GetLocalPositions(input, unit, origin);

  vtkDataArray* given = InkPointNormals(input);
  std::vector<glm::vec3> normals;
  const bool estimated = !given && options.Normals;
  next(0.4);
  if (estimated)
  {
    std::optional<glm::vec3> viewpoint;
    if (options.Viewpoint)
    {
      const glm::dvec3 position(options.Viewpoint[0], options.Viewpoint[1], options.Viewpoint[2]);
      viewpoint = glm::vec3((position - origin) / unit);
    }
    normals = ink::estimateNormals(positions, options.NormalNeighbors, progress, viewpoint);
    if (normals.size() != positions.size())
    {
      return 0;
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

  next(0.2);
  vtkDataArray* givenRadius = GetPointArray(input, "Radius", 1);
  std::vector<float> radii;
  std::vector<std::uint32_t> order(positions.size());
  std::iota(order.begin(), order.end(), 0u);
  std::size_t isolated = 0;
  if (givenRadius)
  {
    radii.resize(positions.size());
    for (std::size_t i = 0; i < radii.size(); ++i)
    {
      radii[i] = static_cast<float>(givenRadius->GetComponent(static_cast<vtkIdType>(i), 0) / unit);
    }
  }
  else if (options.Radius && options.UniformRadius)
  {
    radii.assign(positions.size(), ink::discRadiusFromSpacing(positions));
  }
  else if (options.Radius)
  {
    ink::PointRadii own = ink::pointRadii(positions, normals, progress);
    if (own.radius.size() != positions.size())
    {
      return 0;
    }
    isolated = own.isolatedCount;
    radii = std::move(own.radius);
    if (isolated > 0 && options.RemoveIsolated)
    {
      std::erase_if(order, [&](std::uint32_t i) { return own.isolated[i] != 0; });
      positions = Pick(positions, order);
      normals = Pick(normals, order);
      radii = Pick(radii, order);
    }
  }

  next(0.4);
  if (options.Priority)
  {
    const auto sorted = ink::progressiveOrder(positions, normals,
      AreRadii(radii) ? radii : std::vector<float>(), static_cast<std::uint64_t>(options.Seed), progress);
    if (sorted.size() != positions.size())
    {
      return 0;
    }
    order = Pick(order, sorted);
    normals = Pick(normals, sorted);
    radii = Pick(radii, sorted);
  }
  InkExtractPoints(input, order, output);
  const auto count = static_cast<vtkIdType>(order.size());
  vtkPointData* pointData = output->GetPointData();
  if (estimated)
  {
    vtkNew<vtkFloatArray> array;
    array->SetName("Normals");
    array->SetNumberOfComponents(3);
    InkSetNumberOfTuples(array, count);
    for (vtkIdType i = 0; i < count; ++i)
    {
      array->SetTuple(i, &normals[static_cast<std::size_t>(i)].x);
    }
    pointData->SetNormals(array);
  }
  else if (!pointData->GetNormals() && given)
  {
    pointData->SetNormals(pointData->GetArray(given->GetName()));
  }
  if (options.Radius && !givenRadius)
  {
    const vtkSmartPointer<vtkDataArray> array =
      InkMakeConstant("Radius", output->GetPoints()->GetDataType(), count, 0.0);
    for (vtkIdType i = 0; i < count; ++i)
    {
      array->SetComponent(i, 0, unit * static_cast<double>(radii[static_cast<std::size_t>(i)]));
    }
    pointData->AddArray(array);
  }
  if (options.Priority)
  {
    pointData->AddArray(InkMakePriority(count));
  }
  if (options.Vertices)
  {
    output->SetVerts(InkMakePolyVertex(count));
  }
  return static_cast<vtkIdType>(isolated);
}
