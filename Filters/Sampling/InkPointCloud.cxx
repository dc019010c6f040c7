// SPDX-License-Identifier: BSD-3-Clause
#include "InkPointCloud.h"

#include "InkAllocate.h"
#include "InkExtractPoints.h"
#include "InkGhostPoint.h"
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
  vtkUnsignedCharArray* ghosts = points->GetPointGhostArray();
  if (!ghosts || ghosts->GetNumberOfTuples() != points->GetNumberOfPoints())
  {
    return nullptr;
  }
  std::vector<std::uint32_t> own;
  for (vtkIdType i = 0; i < ghosts->GetNumberOfTuples(); ++i)
  {
    if (!InkIsGhostPoint(ghosts, i))
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

/// Points with what is made for them. Each step returns false when aborted.
class Cloud
{
public:
  Cloud(vtkPointSet* input, const InkPointCloudOptions& options, vtkAlgorithm* algorithm)
    : Input(input)
    , Options(options)
    , GivenNormals(InkPointNormals(input))
    , GivenRadius(GetPointArray(input, "Radius", 1))
    , Progress(
        [this, algorithm](double part)
        {
          algorithm->UpdateProgress(this->Done + this->Share * part);
          return !InkCheckAbort(algorithm);
        })
  {
    this->Positions = GetLocalPositions(input, this->Unit, this->Origin);
    this->Order.resize(this->Positions.size());
    std::iota(this->Order.begin(), this->Order.end(), 0u);
  }
  Cloud(const Cloud&) = delete;
  void operator=(const Cloud&) = delete;

  bool MakeNormals();
  bool MakeRadii();
  bool SortByPriority();
  void Write(vtkPolyData* output) const;

  std::size_t GetNumberOfIsolated() const { return this->Isolated; }

private:
  void StartStep(double share)
  {
    this->Done += this->Share;
    this->Share = share;
  }
  bool EstimatesNormals() const { return !this->GivenNormals && this->Options.Normals; }

  vtkPointSet* const Input;
  const InkPointCloudOptions& Options;
  vtkDataArray* const GivenNormals;
  vtkDataArray* const GivenRadius;
  double Done = 0.0;
  double Share = 0.0;
  const ink::Progress Progress;
  double Unit = 1.0;
  glm::dvec3 Origin = glm::dvec3(0.0);
  std::vector<glm::vec3> Positions;
  std::vector<glm::vec3> Normals;   ///< empty: none
  std::vector<float> Radii;         ///< empty: none
  std::vector<std::uint32_t> Order; ///< the points that are kept
  std::size_t Isolated = 0;
};

bool Cloud::MakeNormals()
{
  this->StartStep(0.4);
  if (this->EstimatesNormals())
  {
    std::optional<glm::vec3> viewpoint;
    if (this->Options.Viewpoint)
    {
      const double* v = this->Options.Viewpoint;
      viewpoint = glm::vec3((glm::dvec3(v[0], v[1], v[2]) - this->Origin) / this->Unit);
    }
    this->Normals =
      ink::estimateNormals(this->Positions, this->Options.NormalNeighbors, this->Progress, viewpoint);
    return this->Normals.size() == this->Positions.size();
  }
  if (this->GivenNormals)
  {
    this->Normals.resize(this->Positions.size());
    for (std::size_t i = 0; i < this->Normals.size(); ++i)
    {
      double normal[3];
      this->GivenNormals->GetTuple(static_cast<vtkIdType>(i), normal);
      this->Normals[i] = glm::vec3(normal[0], normal[1], normal[2]);
    }
  }
  return true;
}

bool Cloud::MakeRadii()
{
  this->StartStep(0.2);
  if (this->GivenRadius)
  {
    this->Radii.resize(this->Positions.size());
    for (std::size_t i = 0; i < this->Radii.size(); ++i)
    {
      this->Radii[i] =
        static_cast<float>(this->GivenRadius->GetComponent(static_cast<vtkIdType>(i), 0) / this->Unit);
    }
  }
  else if (this->Options.Radius && this->Options.UniformRadius)
  {
    this->Radii.assign(this->Positions.size(), ink::discRadiusFromSpacing(this->Positions));
  }
  else if (this->Options.Radius)
  {
    ink::PointRadii own = ink::pointRadii(this->Positions, this->Normals, this->Progress);
    if (own.radius.size() != this->Positions.size())
    {
      return false;
    }
    this->Isolated = own.isolatedCount;
    this->Radii = std::move(own.radius);
    if (this->Isolated > 0 && this->Options.RemoveIsolated)
    {
      std::erase_if(this->Order, [&](std::uint32_t i) { return own.isolated[i] != 0; });
      this->Positions = Pick(this->Positions, this->Order);
      this->Normals = Pick(this->Normals, this->Order);
      this->Radii = Pick(this->Radii, this->Order);
    }
  }
  return true;
}

bool Cloud::SortByPriority()
{
  this->StartStep(0.4);
  if (!this->Options.Priority)
  {
    return true;
  }
  const auto sorted = ink::progressiveOrder(this->Positions, this->Normals,
    AreRadii(this->Radii) ? this->Radii : std::vector<float>(),
    static_cast<std::uint64_t>(this->Options.Seed), this->Progress);
  if (sorted.size() != this->Positions.size())
  {
    return false;
  }
  this->Order = Pick(this->Order, sorted);
  this->Normals = Pick(this->Normals, sorted);
  this->Radii = Pick(this->Radii, sorted);
  return true;
}

void Cloud::Write(vtkPolyData* output) const
{
  InkExtractPoints(this->Input, this->Order, output);
  const auto count = static_cast<vtkIdType>(this->Order.size());
  vtkPointData* pointData = output->GetPointData();
  if (this->EstimatesNormals())
  {
    vtkNew<vtkFloatArray> array;
    array->SetName("Normals");
    array->SetNumberOfComponents(3);
    InkSetNumberOfTuples(array, count);
    for (vtkIdType i = 0; i < count; ++i)
    {
      array->SetTuple(i, &this->Normals[static_cast<std::size_t>(i)].x);
    }
    pointData->SetNormals(array);
  }
  else if (!pointData->GetNormals() && this->GivenNormals)
  {
    pointData->SetNormals(pointData->GetArray(this->GivenNormals->GetName()));
  }
  if (this->Options.Radius && !this->GivenRadius)
  {
    const vtkSmartPointer<vtkDataArray> array =
      InkMakeConstant("Radius", output->GetPoints()->GetDataType(), count, 0.0);
    for (vtkIdType i = 0; i < count; ++i)
    {
      array->SetComponent(i, 0, this->Unit * static_cast<double>(this->Radii[static_cast<std::size_t>(i)]));
    }
    pointData->AddArray(array);
  }
  if (this->Options.Priority)
  {
    pointData->AddArray(InkMakePriority(count));
  }
  if (this->Options.Vertices)
  {
    output->SetVerts(InkMakePolyVertex(count));
  }
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
  Cloud cloud(input, options, algorithm);
  if (!cloud.MakeNormals() || !cloud.MakeRadii() || !cloud.SortByPriority())
  {
    return 0;
  }
  cloud.Write(output);
  return static_cast<vtkIdType>(cloud.GetNumberOfIsolated());
}
