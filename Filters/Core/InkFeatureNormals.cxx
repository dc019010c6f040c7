// SPDX-License-Identifier: BSD-3-Clause
#include "InkFeatureNormals.h"

#include "InkAllocate.h"
#include "InkMeshTriangles.h"
#include "InkPointNormals.h"

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

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
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
  Sides(const InkMeshTriangles& triangles, const ink::FeatureSplit& split)
    : Next(triangles.Points.size(), None)
  {
    for (std::uint32_t point = 0; point < this->Next.size(); ++point)
    {
      this->All.push_back({ point, None });
    }
    for (std::size_t t = 0; t < triangles.Triangles.size(); ++t)
    {
      const ink::Triangle& fans = split.triangles[t];
      for (std::size_t i = 0; i < 3 && fans[0] != fans[1]; ++i)
      {
        this->Add(triangles.Triangles[t][i], fans[i]);
      }
    }
  }

  std::span<const Side> Get() const { return this->All; }
  std::size_t Find(std::uint32_t point, std::uint32_t fan) const
  {
    std::uint32_t side = point;
    while (this->All[side].Fan != fan)
    {
      side = this->Next[side];
    }
    return side;
  }
  bool IsAlone(std::uint32_t point) const { return this->Next[point] == None; }

private:
  void Add(std::uint32_t point, std::uint32_t fan)
  {
    if (this->All[point].Fan == None)
    {
      this->All[point].Fan = fan;
    }
    for (std::uint32_t side = point; this->All[side].Fan != fan; side = this->Next[side])
    {
      if (this->Next[side] == None)
      {
        this->Next[side] = static_cast<std::uint32_t>(this->All.size());
        this->All.push_back({ point, fan });
        this->Next.push_back(None);
      }
    }
  }

  std::vector<std::uint32_t> Next; ///< of each side, another one of the same point
  std::vector<Side> All;
};

/// With normals from all polygons around each point, and these the same way round as their neighbors.
vtkSmartPointer<vtkPolyData> WithMeanNormals(vtkPolyData* mesh)
{
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(mesh);
  normals->SplittingOff();
  normals->Update();
  return normals->GetOutput();
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
  output->GetPointData()->CopyAllocate(mesh->GetPointData(), count);
  output->GetPointData()->CopyData(mesh->GetPointData(), 0, before, 0);
  for (vtkIdType side = before; side < count; ++side)
  {
    const auto point = static_cast<vtkIdType>(sides.Get()[static_cast<std::size_t>(side)].Point);
    points->SetPoint(side, mesh->GetPoint(point));
    output->GetPointData()->CopyData(mesh->GetPointData(), point, side);
  }
  output->SetPoints(points);

  vtkNew<vtkCellArray> polygons;
  polygons->DeepCopy(mesh->GetPolys());
  const vtkIdType first = mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
  vtkNew<vtkIdList> corners;
  for (std::size_t t = 0; t < triangles.Triangles.size(); ++t)
  {
    const ink::Triangle& fans = split.triangles[t];
    for (std::size_t i = 0; i < 3 && fans[0] != fans[1]; ++i)
    {
      const std::uint32_t point = triangles.Triangles[t][i];
      if (const std::size_t side = sides.Find(point, fans[i]); side != point)
      {
        polygons->GetCellAtId(triangles.FaceIds[t] - first, corners);
        for (vtkIdType c = 0; c < corners->GetNumberOfIds(); ++c)
        {
          const bool isIt = corners->GetId(c) == static_cast<vtkIdType>(point);
          corners->SetId(c, isIt ? static_cast<vtkIdType>(side) : corners->GetId(c));
        }
        polygons->ReplaceCellAtId(triangles.FaceIds[t] - first, corners);
      }
    }
  }
  output->SetPolys(polygons);
}

} // namespace

vtkSmartPointer<vtkPolyData> InkWithFeatureNormals(vtkPolyData* mesh)
{
  vtkDataArray* given = InkPointNormals(mesh);
  const vtkSmartPointer<vtkPolyData> surface = given ? WithoutStrips(mesh) : WithMeanNormals(mesh);
  const InkMeshTriangles triangles(surface, true, InkMeshTriangles::Order::OfMesh);
  ink::MeshNavigation navigation(triangles.GetMesh(), 180.0);
  ink::cutFeatures(navigation);
  const ink::FeatureSplit split = ink::splitAtFeatures(navigation);
  const Sides sides(triangles, split);
  const bool isSplit = sides.Get().size() > triangles.Points.size();
  if (given && !isSplit)
  {
    return mesh;
  }
  auto output = vtkSmartPointer<vtkPolyData>::New();
  output->ShallowCopy(surface);
  if (isSplit)
  {
    RepeatPoints(triangles, split, sides, surface, output);
  }
  const std::vector<glm::vec3> found =
    ink::splitNormals(split, triangles.GetMesh(), triangles.Normals, given != nullptr);
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  InkSetNumberOfTuples(normals, output->GetNumberOfPoints());
  for (std::size_t i = 0; i < sides.Get().size(); ++i)
  {
    const auto [point, fan] = sides.Get()[i];
    const bool isKept = fan == None || (given && sides.IsAlone(point));
    normals->SetTuple(static_cast<vtkIdType>(i), &(isKept ? triangles.Normals[point] : found[fan]).x);
  }
  output->GetPointData()->SetNormals(normals);
  return output;
}
