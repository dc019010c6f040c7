// SPDX-License-Identifier: BSD-3-Clause
#include "InkMeshTriangles.h"

#include "InkAllocate.h"
#include "InkNotFiniteFaces.h"
#include "InkPointNormals.h"

#include "Core/Hash.h"
#include "Mesh/FaceOrder.h"
#include "Mesh/RepeatedTriangles.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTriangleFilter.h"
#include "vtkUnsignedCharArray.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace
{

constexpr const char* FaceIdName = "vtkInkFaceId";

bool HasTrianglesOnly(vtkPolyData* mesh)
{
  return mesh->GetNumberOfStrips() == 0 && mesh->GetPolys()->IsHomogeneous() == 3;
}

/// The mesh's faces as triangles, each with the id of its cell.
vtkSmartPointer<vtkPolyData> CutIntoTriangles(vtkPolyData* mesh)
{
  vtkNew<vtkPolyData> copy;
  copy->SetPoints(mesh->GetPoints());
  copy->SetVerts(mesh->GetVerts());
  copy->SetLines(mesh->GetLines());
  copy->SetPolys(mesh->GetPolys());
  copy->SetStrips(mesh->GetStrips());
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName(FaceIdName);
  InkSetNumberOfTuples(ids, copy->GetNumberOfCells());
  auto values = vtk::DataArrayValueRange<1>(ids.Get());
  vtkIdType next = 0;
  std::generate(values.begin(), values.end(), [&] { return next++; });
  copy->GetCellData()->AddArray(ids);
  vtkNew<vtkTriangleFilter> filter;
  filter->PassVertsOff();
  filter->PassLinesOff();
  filter->SetInputData(copy);
  filter->Update();
  return filter->GetOutput();
}

std::string Counted(vtkIdType count, const char* what)
{
  return std::to_string(count) + " " + what;
}

/// The faces that belong to another piece, or are hidden.
class LeftOutFaces
{
public:
  explicit LeftOutFaces(vtkPolyData* mesh)
    : Marks(mesh->GetCellGhostArray())
  {
  }
  bool Contain(vtkIdType face) const
  {
    constexpr int marks = vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL |
      vtkDataSetAttributes::REFINEDCELL;
    return this->Marks && (this->Marks->GetValue(face) & marks) != 0;
  }

private:
  const vtkUnsignedCharArray* Marks;
};

/// Some VTK versions triangulate degenerate faces into no triangles. A mesh of only ghost cells belongs to
/// another piece. @throws std::invalid_argument for a mesh without triangles that has faces of its own
void RequireNoFaces(vtkPolyData* mesh)
{
  const LeftOutFaces leftOut(mesh);
  const vtkIdType first = mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
  for (vtkIdType face = first; face < mesh->GetNumberOfCells(); ++face)
  {
    if (!leftOut.Contain(face))
    {
      throw std::invalid_argument("its " + Counted(mesh->GetNumberOfCells() - first, "faces") +
        " have no area; expected faces with three different points that are finite");
    }
  }
}

} // namespace

void InkMeshTriangles::Check(vtkPolyData* mesh)
{
  const vtkIdType pointCount = mesh->GetNumberOfPoints();
  constexpr vtkIdType most = std::numeric_limits<std::uint32_t>::max() / 3;
  if (pointCount > most || mesh->GetPolys()->GetNumberOfConnectivityIds() > most)
  {
    throw std::invalid_argument("it has " + Counted(pointCount, "points and ") +
      Counted(mesh->GetPolys()->GetNumberOfConnectivityIds(), "corners; expected no more than ") +
      std::to_string(most) + " of either");
  }
  for (vtkCellArray* cells : { mesh->GetPolys(), mesh->GetStrips() })
  {
    if (cells->GetNumberOfConnectivityIds() > 0)
    {
      double range[2];
      cells->GetConnectivityArray()->GetRange(range, 0);
      if (range[0] < 0 || range[1] >= static_cast<double>(pointCount))
      {
        const double wrong = range[0] < 0 ? range[0] : range[1];
        throw std::invalid_argument("a face has the point " + std::to_string(static_cast<vtkIdType>(wrong)) +
          "; expected 0 to " + std::to_string(pointCount - 1));
      }
    }
  }
  if (const std::string problem = InkDescribeNoFiniteFace(mesh); !problem.empty())
  {
    throw std::invalid_argument(problem);
  }
}

InkMeshTriangles::InkMeshTriangles(vtkPolyData* mesh, bool wantNormals, Order order, Repeats repeats)
{
  Check(mesh);
  const vtkIdType pointCount = mesh->GetNumberOfPoints();
  this->Points.resize(static_cast<std::size_t>(pointCount));
  for (vtkIdType i = 0; i < pointCount; ++i)
  {
    mesh->GetPoint(i, &this->Points[static_cast<std::size_t>(i)].x);
  }
  this->TakeTriangles(mesh);
  if (repeats == Repeats::LeftOut)
  {
    const std::vector<std::uint32_t> repeated = ink::repeatedTriangles(this->Points, this->Triangles);
    ink::eraseIndices(this->Triangles, repeated);
    ink::eraseIndices(this->FaceIds, repeated);
  }
  if (order == Order::ByPosition)
  {
    this->SortByPosition();
  }
  vtkDataArray* globalIds = mesh->GetCellData()->GetGlobalIds();
  std::uint64_t partOfFace = 0;
  for (std::size_t i = 0; globalIds && i < this->FaceIds.size(); ++i)
  {
    partOfFace = i > 0 && this->FaceIds[i] == this->FaceIds[i - 1] ? partOfFace + 1 : 0;
    const auto globalId = static_cast<std::uint64_t>(globalIds->GetComponent(this->FaceIds[i], 0));
    this->Names.push_back(ink::hash(globalId, partOfFace));
  }
  if (this->Triangles.empty())
  {
    RequireNoFaces(mesh);
  }
  if (wantNormals && !this->TakeNormals(mesh))
  {
    this->AverageNormals();
  }
}

void InkMeshTriangles::TakeTriangles(vtkPolyData* mesh)
{
  // Cells come in the order vertices, lines, polygons, strips.
  vtkIdType cell = mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
  vtkSmartPointer<vtkPolyData> triangles = mesh;
  vtkDataArray* ids = nullptr;
  if (!HasTrianglesOnly(mesh))
  {
    triangles = CutIntoTriangles(mesh);
    ids = triangles->GetCellData()->GetArray(FaceIdName);
    cell = 0;
  }
  const vtkIdType count = triangles->GetNumberOfPolys();
  this->Triangles.reserve(static_cast<std::size_t>(count));
  this->FaceIds.reserve(static_cast<std::size_t>(count));
  const LeftOutFaces leftOut(mesh);
  const auto corners = vtk::TakeSmartPointer(triangles->GetPolys()->NewIterator());
  for (corners->GoToFirstCell(); !corners->IsDoneWithTraversal(); corners->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    corners->GetCurrentCell(size, points);
    const vtkIdType id = corners->GetCurrentCellId();
    const vtkIdType face = ids ? static_cast<vtkIdType>(ids->GetTuple1(id)) : cell + id;
    if (size == 3 && !leftOut.Contain(face))
    {
      this->Triangles.push_back({ static_cast<std::uint32_t>(points[0]),
        static_cast<std::uint32_t>(points[1]), static_cast<std::uint32_t>(points[2]) });
      this->FaceIds.push_back(face);
    }
  }
}

bool InkMeshTriangles::TakeNormals(vtkPolyData* mesh)
{
  this->Normals.assign(this->Points.size(), glm::vec3(0.0f));
  vtkDataArray* normals = InkPointNormals(mesh);
  if (!normals || normals->GetNumberOfTuples() != mesh->GetNumberOfPoints())
  {
    return false;
  }
  for (std::size_t i = 0; i < this->Normals.size(); ++i)
  {
    glm::dvec3 normal;
    normals->GetTuple(static_cast<vtkIdType>(i), &normal.x);
    const double length = glm::length(normal);
    if (length > 0.0 && std::isfinite(length))
    {
      this->Normals[i] = normal / length;
    }
  }
  return true;
}

void InkMeshTriangles::AverageNormals()
{
  std::vector<glm::dvec3> sums(this->Points.size(), glm::dvec3(0.0));
  for (const auto& [a, b, c] : this->Triangles)
  {
    const glm::dvec3 normal =
      glm::cross(this->Points[b] - this->Points[a], this->Points[c] - this->Points[a]);
    if (const double size = glm::length(normal); std::isfinite(size))
    {
      sums[a] += normal;
      sums[b] += normal;
      sums[c] += normal;
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i)
  {
    if (const double length = glm::length(sums[i]); length > 0.0)
    {
      this->Normals[i] = sums[i] / length;
    }
  }
}

void InkMeshTriangles::SortByPosition()
{
  std::vector<std::uint32_t> firsts;
  for (std::size_t i = 0; i < this->FaceIds.size(); ++i)
  {
    if (i == 0 || this->FaceIds[i] != this->FaceIds[i - 1])
    {
      firsts.push_back(static_cast<std::uint32_t>(i));
    }
  }
  std::vector<ink::Triangle> triangles;
  std::vector<vtkIdType> faceIds;
  triangles.reserve(this->Triangles.size());
  faceIds.reserve(this->FaceIds.size());
  for (const std::uint32_t triangle : ink::orderByPosition(this->Points, this->Triangles, firsts))
  {
    triangles.push_back(this->Triangles[triangle]);
    faceIds.push_back(this->FaceIds[triangle]);
  }
  this->Triangles = std::move(triangles);
  this->FaceIds = std::move(faceIds);
}

void InkMeshTriangles::SetDensity(vtkDataArray* density, bool ofCells)
{
  std::vector<float>& values = ofCells ? this->FaceDensity : this->PointDensity;
  values.resize(ofCells ? this->Triangles.size() : this->Points.size());
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const vtkIdType id = ofCells ? this->FaceIds[i] : static_cast<vtkIdType>(i);
    values[i] = static_cast<float>(density->GetComponent(id, 0));
  }
}

ink::TriangleMesh InkMeshTriangles::GetMesh() const
{
  return { this->Points, this->Triangles, this->PointDensity, this->FaceDensity };
}
