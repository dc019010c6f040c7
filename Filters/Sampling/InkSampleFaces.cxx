// SPDX-License-Identifier: BSD-3-Clause
#include "InkSampleFaces.h"

#include "Core/FormatNumber.h"
#include "Core/Hash.h"
#include "Core/IsFinite.h"
#include "InkAllocate.h"
#include "InkPlaceSamples.h"
#include "Mesh/SurfaceStretch.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace
{

constexpr const char* FaceIdName = "FaceId";
constexpr const char* FacePointsName = "FacePoints";
constexpr const char* BarycentricName = "BarycentricCoordinates";
constexpr const char* SampledMeshName = "SampledMesh";
constexpr const char* SampledPointsName = "SampledMeshPoints";
// Of triangles around a sample whose stretch counts, at the most.
constexpr int MostStretchRounds = 8;

/// Where the mesh's points were when the samples were made.
/// @param count how many the mesh has
std::vector<glm::dvec3> GetPointsBefore(vtkPolyData* samples, std::size_t count)
{
  vtkDataArray* array = samples->GetFieldData()->GetArray(SampledPointsName);
  if (!array || array->GetNumberOfComponents() != 3 ||
    array->GetNumberOfTuples() != static_cast<vtkIdType>(count))
  {
    throw std::invalid_argument(std::string("the first frame's samples lack the field array ") +
      SampledPointsName + " with the mesh's " + std::to_string(count) +
      " points; expected samples made with KeepFaces");
  }
  std::vector<glm::dvec3> before(count);
  for (std::size_t i = 0; i < before.size(); ++i)
  {
    array->GetTuple(static_cast<vtkIdType>(i), &before[i].x);
  }
  return before;
}

/// For each point of the mesh, the factor by which discs around it must grow since the samples were made.
/// Empty if nothing has moved.
/// @param before of GetPointsBefore
std::vector<float> GetStretch(
  const InkMeshTriangles& triangles, const std::vector<glm::dvec3>& before, vtkDataArray* radius)
{
  if (before == triangles.Points)
  {
    return {};
  }
  // The number of rings that the widest disc reaches on triangles of mean size.
  const double area = triangles.Triangles.empty()
    ? 0.0
    : ink::cumulateArea({ before, triangles.Triangles, {}, {} }).area.back();
  const double side =
    1.5 * std::sqrt(area / static_cast<double>(std::max<std::size_t>(triangles.Triangles.size(), 1)));
  double range[2];
  radius->GetRange(range);
  const double rounds = side > 0.0 ? range[1] / side : 0.0;
  return ink::pointStretch(before, triangles.Points, triangles.Triangles,
    static_cast<int>(std::min(std::ceil(rounds), static_cast<double>(MostStretchRounds))));
}

/// A hash of a mesh's connectivity, below 2^53 so that a double holds it.
double HashFaces(vtkPolyData* mesh)
{
  std::uint64_t all = 0;
  for (vtkCellArray* faces : { mesh->GetPolys(), mesh->GetStrips() })
  {
    const auto face = vtk::TakeSmartPointer(faces->NewIterator());
    for (face->GoToFirstCell(); !face->IsDoneWithTraversal(); face->GoToNextCell())
    {
      vtkIdType size = 0;
      const vtkIdType* points = nullptr;
      face->GetCurrentCell(size, points);
      all = ink::hash(all, static_cast<std::uint64_t>(size));
      for (vtkIdType i = 0; i < size; ++i)
      {
        all = ink::hash(all, static_cast<std::uint64_t>(points[i]));
      }
    }
  }
  return static_cast<double>(all >> 11);
}

/// The faces of samples have to be those of a mesh.
/// @throws std::invalid_argument if not
void CheckFaces(vtkPolyData* mesh, vtkPolyData* samples)
{
  vtkDataArray* corners = samples->GetPointData()->GetArray(FacePointsName);
  vtkDataArray* weights = samples->GetPointData()->GetArray(BarycentricName);
  vtkDataArray* sampled = samples->GetFieldData()->GetArray(SampledMeshName);
  if (!corners || !weights || !sampled || corners->GetNumberOfComponents() != 3 ||
    weights->GetNumberOfComponents() != 3 || sampled->GetNumberOfComponents() != 3 ||
    sampled->GetNumberOfTuples() != 1)
  {
    throw std::invalid_argument(std::string("the first frame's samples lack one of the arrays ") +
      FacePointsName + ", " + BarycentricName + " and " + SampledMeshName +
      "; expected samples made with KeepFaces");
  }
  const auto cells = static_cast<vtkIdType>(sampled->GetComponent(0, 0));
  const auto points = static_cast<vtkIdType>(sampled->GetComponent(0, 1));
  if (cells != mesh->GetNumberOfCells() || points != mesh->GetNumberOfPoints())
  {
    throw std::invalid_argument("it has " + std::to_string(mesh->GetNumberOfCells()) + " cells and " +
      std::to_string(mesh->GetNumberOfPoints()) + " points; expected " + std::to_string(cells) + " and " +
      std::to_string(points) + " as in the mesh that the first frame's samples were made of");
  }
  if (sampled->GetComponent(0, 2) != HashFaces(mesh))
  {
    throw std::invalid_argument("its faces join other points than those of the mesh that the first frame's "
                                "samples were made of; expected the same " +
      std::to_string(cells) + " cells, deformed");
  }
}

/// Radii times the stretch at each sample, which has a triangle of its own.
vtkSmartPointer<vtkDataArray> GrowRadius(vtkDataArray* radius, const std::vector<float>& stretch,
  const std::vector<ink::Triangle>& triangles, const std::vector<ink::SurfaceSample>& samples)
{
  vtkSmartPointer<vtkDataArray> grown = vtk::TakeSmartPointer(radius->NewInstance());
  grown->DeepCopy(radius);
  for (vtkIdType i = 0; i < radius->GetNumberOfTuples(); ++i)
  {
    const auto sample = static_cast<std::size_t>(i);
    const auto& [a, b, c] = triangles[sample];
    const double b1 = static_cast<double>(samples[sample].b1);
    const double b2 = static_cast<double>(samples[sample].b2);
    const double here = (1.0 - b1 - b2) * stretch[a] + b1 * stretch[b] + b2 * stretch[c];
    grown->SetComponent(i, 0, here * radius->GetComponent(i, 0));
  }
  return grown;
}

/// A triangle's sides from its first corner and its normal, which is as long as they are.
glm::dmat3 GetFrame(const std::vector<glm::dvec3>& points, const ink::Triangle& triangle)
{
  const glm::dvec3 a = points[triangle[1]] - points[triangle[0]];
  const glm::dvec3 b = points[triangle[2]] - points[triangle[0]];
  const glm::dvec3 normal = glm::cross(a, b);
  return { a, b, normal / std::sqrt(glm::length(normal)) };
}

/// Vectors of samples, two of three components each, that turn and stretch with the samples' triangles. Those
/// of triangles that had no area are 0.
vtkSmartPointer<vtkDataArray> TurnVectors(vtkDataArray* vectors, const std::vector<glm::dvec3>& before,
  const std::vector<glm::dvec3>& now, const std::vector<ink::Triangle>& triangles)
{
  vtkSmartPointer<vtkDataArray> turned = vtk::TakeSmartPointer(vectors->NewInstance());
  turned->DeepCopy(vectors);
  for (vtkIdType i = 0; i < vectors->GetNumberOfTuples(); ++i)
  {
    const ink::Triangle& triangle = triangles[static_cast<std::size_t>(i)];
    const glm::dmat3 change = GetFrame(now, triangle) * glm::inverse(GetFrame(before, triangle));
    std::array<glm::dvec3, 2> pair;
    vectors->GetTuple(i, &pair[0].x);
    for (glm::dvec3& vector : pair)
    {
      vector = change * vector;
      vector = ink::isFinite(vector) ? vector : glm::dvec3(0.0);
    }
    turned->SetTuple(i, &pair[0].x);
  }
  return turned;
}

} // namespace

void InkAddFaces(const InkMeshTriangles& triangles, const std::vector<ink::SurfaceSample>& samples,
  vtkPolyData* mesh, vtkPolyData* output)
{
  const auto count = static_cast<vtkIdType>(samples.size());
  vtkNew<vtkIdTypeArray> faces;
  faces->SetName(FaceIdName);
  InkSetNumberOfTuples(faces, count);
  vtkNew<vtkIdTypeArray> points;
  points->SetName(FacePointsName);
  points->SetNumberOfComponents(3);
  InkSetNumberOfTuples(points, count);
  vtkNew<vtkFloatArray> weights;
  weights->SetName(BarycentricName);
  weights->SetNumberOfComponents(3);
  InkSetNumberOfTuples(weights, count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const ink::SurfaceSample& sample = samples[static_cast<std::size_t>(i)];
    faces->SetValue(i, triangles.FaceIds[sample.triangle]);
    const ink::Triangle& corners = triangles.Triangles[sample.triangle];
    for (int corner = 0; corner < 3; ++corner)
    {
      points->SetTypedComponent(i, corner, corners[static_cast<std::size_t>(corner)]);
    }
    // Rounding may make the sum of the others exceed 1.
    weights->SetTypedComponent(i, 0, std::max(1.0f - sample.b1 - sample.b2, 0.0f));
    weights->SetTypedComponent(i, 1, sample.b1);
    weights->SetTypedComponent(i, 2, sample.b2);
  }
  output->GetPointData()->AddArray(faces);
  output->GetPointData()->AddArray(points);
  output->GetPointData()->AddArray(weights);
  vtkNew<vtkDoubleArray> sampled;
  sampled->SetName(SampledMeshName);
  sampled->SetNumberOfComponents(3);
  sampled->InsertNextTuple3(static_cast<double>(mesh->GetNumberOfCells()),
    static_cast<double>(mesh->GetNumberOfPoints()), HashFaces(mesh));
  vtkSmartPointer<vtkDataArray> before = vtk::TakeSmartPointer(mesh->GetPoints()->GetData()->NewInstance());
  before->DeepCopy(mesh->GetPoints()->GetData());
  before->SetName(SampledPointsName);
  output->GetFieldData()->AddArray(before);
  output->GetFieldData()->AddArray(sampled);
}

bool InkAreSamplesOf(vtkPolyData* samples, vtkPolyData* mesh)
{
  vtkDataArray* sampled = samples->GetFieldData()->GetArray(SampledMeshName);
  return sampled && sampled->GetNumberOfComponents() == 3 && sampled->GetNumberOfTuples() == 1 &&
    sampled->GetComponent(0, 0) == static_cast<double>(mesh->GetNumberOfCells()) &&
    sampled->GetComponent(0, 1) == static_cast<double>(mesh->GetNumberOfPoints()) &&
    sampled->GetComponent(0, 2) == HashFaces(mesh);
}

void InkRemoveFaces(vtkPolyData* samples)
{
  for (const char* name : { FaceIdName, FacePointsName, BarycentricName })
  {
    samples->GetPointData()->RemoveArray(name);
  }
  for (const char* name : { SampledMeshName, SampledPointsName })
  {
    samples->GetFieldData()->RemoveArray(name);
  }
}

void InkMoveSamples(vtkPolyData* mesh, vtkPolyData* samples, bool normals, int type, vtkPolyData* output)
{
  const vtkIdType count = samples->GetNumberOfPoints();
  if (count == 0)
  {
    return;
  }
  CheckFaces(mesh, samples);
  vtkDataArray* corners = samples->GetPointData()->GetArray(FacePointsName);
  vtkDataArray* weights = samples->GetPointData()->GetArray(BarycentricName);
  InkMeshTriangles triangles(mesh, normals, InkMeshTriangles::Order::OfMesh);
  vtkDataArray* radius = samples->GetPointData()->GetArray("Radius");
  vtkDataArray* edges = samples->GetPointData()->GetArray("EdgeOffsets");
  const std::vector<glm::dvec3> before =
    radius || edges ? GetPointsBefore(samples, triangles.Points.size()) : std::vector<glm::dvec3>();
  const std::vector<float> stretch = radius ? GetStretch(triangles, before, radius) : std::vector<float>();
  // Each sample has its own triangle.
  triangles.Triangles.resize(static_cast<std::size_t>(count));
  std::vector<ink::SurfaceSample> positions(static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    const auto sample = static_cast<std::size_t>(i);
    for (int corner = 0; corner < 3; ++corner)
    {
      const double point = corners->GetComponent(i, corner);
      if (!(point >= 0.0 && point < static_cast<double>(mesh->GetNumberOfPoints())))
      {
        throw std::invalid_argument("the first frame's sample " + std::to_string(i) + " is on the point " +
          ink::formatNumber(point) + "; expected 0 to " + std::to_string(mesh->GetNumberOfPoints() - 1));
      }
      triangles.Triangles[sample][static_cast<std::size_t>(corner)] = static_cast<std::uint32_t>(point);
    }
    positions[sample] = { static_cast<std::uint32_t>(i), static_cast<float>(weights->GetComponent(i, 1)),
      static_cast<float>(weights->GetComponent(i, 2)) };
  }
  output->ShallowCopy(samples);
  output->SetPoints(InkPlacePoints(triangles.GetMesh(), positions, type));
  if (normals)
  {
    output->GetPointData()->SetNormals(InkPlaceNormals(triangles.GetMesh(), triangles.Normals, positions));
  }
  if (!stretch.empty())
  {
    output->GetPointData()->AddArray(GrowRadius(radius, stretch, triangles.Triangles, positions));
  }
  if (edges && before != triangles.Points)
  {
    output->GetPointData()->AddArray(TurnVectors(edges, before, triangles.Points, triangles.Triangles));
  }
}
