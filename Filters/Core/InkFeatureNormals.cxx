// SPDX-License-Identifier: BSD-3-Clause
#include "InkFeatureNormals.h"

#include "InkAllocate.h"
#include "InkMeshTriangles.h"
#include "InkPointNormals.h"
#include "InkSourcePoints.h"

#include "Core/WeldedPoints.h"
#include "Mesh/FeatureSplit.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"
#include "vtkTriangleFilter.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace
{

/// What serves a point on one side of a feature edge.
struct Side
{
  std::uint32_t Point; ///< in the mesh
  std::uint32_t Fan;   ///< in the split
};

constexpr std::uint32_t None = ink::MeshNavigation::border;

/// The sides of all points: first one of each point, in order, then all others.
class Sides
{
public:
  /// @param isSplit for each point whether it has a side for each fan, or one alone
  Sides(const InkMeshTriangles& triangles, const ink::FeatureSplit& split,
    const std::vector<std::uint8_t>& isSplit)
    : Shared(triangles.Points.size())
  {
    for (std::uint32_t point = 0; point < this->Shared.size(); ++point)
    {
      this->All.push_back({ point, None });
    }
    for (std::size_t t = 0; t < triangles.Triangles.size(); ++t)
    {
      const ink::Triangle& fans = split.triangles[t];
      for (std::size_t i = 0; i < 3 && fans[0] != fans[1]; ++i)
      {
        if (isSplit[triangles.Triangles[t][i]])
        {
          this->Add(triangles.Triangles[t][i], fans[i]);
        }
      }
    }
  }

  std::span<const Side> Get() const { return this->All; }
  std::size_t Find(std::uint32_t point, std::uint32_t fan) const
  {
    const std::uint32_t first = this->All[point].Fan;
    return first == None || first == fan ? point : this->Further.at(Key(point, fan));
  }
  bool IsAlone(std::uint32_t point) const { return this->Shared[point] == 0; }

private:
  static std::uint64_t Key(std::uint32_t point, std::uint32_t fan)
  {
    return std::uint64_t(point) << 32 | fan;
  }

  void Add(std::uint32_t point, std::uint32_t fan)
  {
    Side& first = this->All[point];
    first.Fan = first.Fan == None ? fan : first.Fan;
    // Pleats may have any number of fans around a point.
    if (first.Fan != fan && this->Further.try_emplace(Key(point, fan), this->All.size()).second)
    {
      this->All.push_back({ point, fan });
      this->Shared[point] = 1;
    }
  }

  std::vector<std::uint8_t> Shared; ///< of each point, whether it has further sides
  std::vector<Side> All;
  std::unordered_map<std::uint64_t, std::size_t> Further;
};

/// The points whose normals do not do for all of their sides: given ones where they enclose more than the
/// feature angle with that of a side, as the means over a box's edges do, but not those of a coarse sphere.
std::vector<std::uint8_t> FindSplit(const InkMeshTriangles& triangles, const ink::FeatureSplit& split,
  const std::vector<glm::vec3>& ofFans, bool isGiven)
{
  std::vector<std::uint8_t> isSplit(triangles.Points.size(), isGiven ? 0 : 1);
  const auto leastCosine = static_cast<float>(std::cos(glm::radians(ink::defaultFeatureAngle)));
  for (std::size_t t = 0; t < triangles.Triangles.size(); ++t)
  {
    const ink::Triangle& fans = split.triangles[t];
    for (std::size_t i = 0; i < 3 && fans[0] != fans[1]; ++i)
    {
      const std::uint32_t point = triangles.Triangles[t][i];
      const glm::vec3& own = triangles.Normals[point];
      const glm::vec3& side = ofFans[fans[i]];
      if (glm::dot(own, side) < leastCosine * glm::length(own) * glm::length(side))
      {
        isSplit[point] = 1;
      }
    }
  }
  return isSplit;
}

/// Polygons run the same way round as their neighbors, and strips become triangles.
vtkSmartPointer<vtkPolyData> Oriented(vtkPolyData* mesh)
{
  vtkNew<vtkPolyDataNormals> filter;
  filter->SetInputData(mesh);
  filter->SplittingOff();
  filter->Update();
  vtkPolyData* result = filter->GetOutput();
  vtkDataArray* normals = result->GetPointData()->GetNormals();
  if (!normals)
  {
    // It found nothing to do, as without a polygon of three points.
    return mesh;
  }
  result->GetPointData()->RemoveArray(normals->GetName());
  return result;
}

vtkSmartPointer<vtkPolyData> WithoutStrips(vtkPolyData* mesh)
{
  if (mesh->GetNumberOfStrips() == 0)
  {
    return mesh;
  }
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(mesh);
  triangles->Update();
  return triangles->GetOutput();
}

/// Repeats points for their further sides, and gives polygons the points of theirs.
void RepeatPoints(const InkMeshTriangles& triangles, const ink::FeatureSplit& split, const Sides& sides,
  vtkPolyData* mesh, vtkPolyData* output)
{
  const vtkIdType before = mesh->GetNumberOfPoints();
  const auto count = static_cast<vtkIdType>(sides.Get().size());
  vtkNew<vtkPoints> points;
  points->SetDataType(mesh->GetPoints()->GetDataType());
  InkSetNumberOfPoints(points, count);
  points->GetData()->InsertTuples(0, before, 0, mesh->GetPoints()->GetData());
  // Without ids that are one point's alone.
  output->GetPointData()->Initialize();
  output->GetPointData()->CopyAllocate(mesh->GetPointData(), count);
  output->GetPointData()->CopyData(mesh->GetPointData(), 0, before, 0);
  std::vector<vtkIdType> repeated;
  for (vtkIdType side = before; side < count; ++side)
  {
    const auto point = static_cast<vtkIdType>(sides.Get()[static_cast<std::size_t>(side)].Point);
    points->SetPoint(side, mesh->GetPoint(point));
    output->GetPointData()->CopyData(mesh->GetPointData(), point, side);
    repeated.push_back(point);
  }
  output->SetPoints(points);
  InkSetSourcePoints(output, mesh, repeated);

  vtkNew<vtkCellArray> polygons;
  polygons->DeepCopy(mesh->GetPolys());
  const vtkIdType first = mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
  vtkNew<vtkIdList> corners;
  for (std::size_t t = 0; t < triangles.Triangles.size();)
  {
    // The triangles of one polygon follow each other.
    const auto face = triangles.FaceIds[t];
    std::unordered_map<vtkIdType, vtkIdType> sideOf;
    for (; t < triangles.Triangles.size() && triangles.FaceIds[t] == face; ++t)
    {
      const ink::Triangle& fans = split.triangles[t];
      for (std::size_t i = 0; i < 3 && fans[0] != fans[1]; ++i)
      {
        const std::uint32_t point = triangles.Triangles[t][i];
        if (const std::size_t side = sides.Find(point, fans[i]); side != point)
        {
          sideOf[point] = static_cast<vtkIdType>(side);
        }
      }
    }
    if (sideOf.empty())
    {
      continue;
    }
    polygons->GetCellAtId(face - first, corners);
    for (vtkIdType c = 0; c < corners->GetNumberOfIds(); ++c)
    {
      const auto found = sideOf.find(corners->GetId(c));
      corners->SetId(c, found == sideOf.end() ? corners->GetId(c) : found->second);
    }
    polygons->ReplaceCellAtId(face - first, corners);
  }
  output->SetPolys(polygons);
}

} // namespace

vtkSmartPointer<vtkPolyData> InkWithFeatureNormals(vtkPolyData* mesh)
{
  InkMeshTriangles::Check(mesh);
  const bool isGiven = InkPointNormals(mesh) != nullptr;
  const vtkSmartPointer<vtkPolyData> surface = isGiven ? WithoutStrips(mesh) : Oriented(mesh);
  const InkMeshTriangles triangles(surface, true, InkMeshTriangles::Order::OfMesh);
  auto output = vtkSmartPointer<vtkPolyData>::New();
  output->ShallowCopy(surface);
  std::vector<glm::vec3> normals = triangles.Normals;
  if (ink::mayHaveFeatures(triangles.GetMesh(), normals))
  {
    ink::MeshNavigation navigation(triangles.GetMesh(), 180.0);
    ink::cutFeatures(navigation);
    const ink::FeatureSplit split = ink::splitAtFeatures(navigation);
    const std::vector<glm::vec3> ofFans = ink::splitNormals(split, triangles.GetMesh(), normals);
    const Sides sides(triangles, split, FindSplit(triangles, split, ofFans, isGiven));
    for (std::size_t i = 0; i < sides.Get().size(); ++i)
    {
      const auto [point, fan] = sides.Get()[i];
      normals.resize(std::max(normals.size(), i + 1));
      normals[i] = fan == None || sides.IsAlone(point) ? triangles.Normals[point] : ofFans[fan];
    }
    if (normals.size() > triangles.Points.size())
    {
      RepeatPoints(triangles, split, sides, surface, output);
    }
  }
  if (isGiven && normals.size() == triangles.Points.size())
  {
    return mesh;
  }
  vtkNew<vtkFloatArray> array;
  array->SetName("Normals");
  array->SetNumberOfComponents(3);
  InkSetNumberOfTuples(array, output->GetNumberOfPoints());
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    array->SetTuple(static_cast<vtkIdType>(i), &normals[i].x);
  }
  output->GetPointData()->SetNormals(array);
  return output;
}

bool InkHasFeatureEdges(vtkPolyData* mesh)
{
  vtkDataArray* normals = InkPointNormals(mesh);
  const vtkIdType count = mesh->GetNumberOfPoints();
  if (!normals || normals->GetNumberOfTuples() != count)
  {
    return false;
  }
  double middle[3];
  mesh->GetCenter(middle);
  std::vector<glm::vec3> points(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    glm::dvec3 point;
    mesh->GetPoint(static_cast<vtkIdType>(i), &point.x);
    points[i] = point - glm::dvec3(middle[0], middle[1], middle[2]);
  }
  const ink::WeldedPoints welded(points);
  const double leastCosine = std::cos(glm::radians(ink::defaultFeatureAngle));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const std::uint32_t position = welded.of[i];
    if (position == ink::WeldedPoints::none || welded.first[position] == i)
    {
      continue;
    }
    glm::dvec3 own;
    glm::dvec3 other;
    normals->GetTuple(static_cast<vtkIdType>(i), &own.x);
    normals->GetTuple(static_cast<vtkIdType>(welded.first[position]), &other.x);
    if (glm::dot(own, other) < leastCosine * glm::length(own) * glm::length(other))
    {
      return true;
    }
  }
  return false;
}
