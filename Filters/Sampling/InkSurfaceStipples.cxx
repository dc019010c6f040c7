// SPDX-License-Identifier: BSD-3-Clause
#include "InkSurfaceStipples.h"

#include "InkAllocate.h"
#include "InkMeshTriangles.h"
#include "InkNeighborLists.h"
#include "InkPointNormals.h"
#include "InkPointOutput.h"
#include "InkStippleFields.h"
#include "InkStippleOutput.h"
#include "InkSurfaceSamples.h"

#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace
{

/// The nondegenerate polygons of a mesh, in the order of the triangles.
struct Polygons
{
  std::vector<vtkIdType> Cells;
  std::vector<std::size_t> Triangles; ///< each polygon's first triangle
  std::vector<glm::dvec3> Normals;    ///< unit, out of the front
  std::vector<double> Areas;
  double Area = 0.0; ///< of all

  /// @param smooth whether a polygon's normal is the mean of its point normals instead of that of its plane
  Polygons(const InkMeshTriangles& triangles, bool smooth)
  {
    const ink::TriangleMesh mesh = triangles.GetMesh();
    const std::size_t count = triangles.FaceIds.size();
    std::size_t end = 0;
    for (std::size_t begin = 0; begin < count; begin = end)
    {
      double area = 0.0;
      glm::dvec3 plane(0.0);
      glm::dvec3 mean(0.0);
      for (end = begin; end < count && triangles.FaceIds[end] == triangles.FaceIds[begin]; ++end)
      {
        const double size = ink::areaOf(mesh, end);
        if (size > 0.0)
        {
          const auto& [a, b, c] = triangles.Triangles[end];
          const glm::dvec3& corner = triangles.Points[a];
          plane += size * Unit(glm::cross(triangles.Points[b] - corner, triangles.Points[c] - corner));
          mean += size * glm::dvec3(triangles.Normals[a] + triangles.Normals[b] + triangles.Normals[c]);
          area += size;
        }
      }
      if (area > 0.0)
      {
        this->Cells.push_back(triangles.FaceIds[begin]);
        this->Triangles.push_back(begin);
        const bool useMean = smooth && glm::length(mean) > 1e-3 * area;
        this->Normals.push_back(Unit(useMean ? mean : plane));
        this->Areas.push_back(area);
        this->Area += area;
      }
    }
  }

private:
  static glm::dvec3 Unit(const glm::dvec3& vector)
  {
    // Relative to its largest component, because the square of an area may overflow or underflow.
    const double largest = std::max({ std::abs(vector.x), std::abs(vector.y), std::abs(vector.z) });
    return largest > 0.0 ? glm::normalize(vector / largest) : glm::dvec3(0.0, 0.0, 1.0);
  }
};

/// A polygon with room for fewer stipples than that is too small for a list of its own: with four, the dots
/// of the Stanford bunny are as even as with any more, and as on far larger polygons.
constexpr double FewestOfPolygon = 4.0;

/// The polygon of each sample.
std::vector<std::size_t> FindPolygons(const Polygons& polygons, std::span<const vtkIdType> cellOfSample)
{
  const vtkIdType lastCell = *std::max_element(polygons.Cells.begin(), polygons.Cells.end());
  std::vector<std::size_t> polygonOfCell(static_cast<std::size_t>(lastCell) + 1);
  for (std::size_t polygon = 0; polygon < polygons.Cells.size(); ++polygon)
  {
    polygonOfCell[static_cast<std::size_t>(polygons.Cells[polygon])] = polygon;
  }
  std::vector<std::size_t> polygonOf(cellOfSample.size());
  for (std::size_t sample = 0; sample < cellOfSample.size(); ++sample)
  {
    polygonOf[sample] = polygonOfCell[static_cast<std::size_t>(cellOfSample[sample])];
  }
  return polygonOf;
}

/// A list for each polygon that is large enough, then lists of neighbors on all others.
struct Lists
{
  std::vector<vtkIdType> Samples;    ///< list by list, in each ascending
  std::vector<vtkIdType> Begins;     ///< of each list, none of which is empty; one more at the end
  std::vector<std::size_t> Polygons; ///< of each list, that of its first sample
  std::vector<glm::vec3> Normals;
  std::size_t Elements; ///< lists, and without any of neighbors also polygons that have no sample

  /// @param points of the samples, in progressive order
  Lists(const struct Polygons& polygons, const std::vector<std::size_t>& polygonOf, vtkPoints* points)
  {
    const double areaPerSample = polygons.Area / static_cast<double>(polygonOf.size());
    std::vector<vtkIdType> next(polygons.Cells.size() + 1, 0);
    std::vector<vtkIdType> others;
    const auto isLarge = [&](std::size_t polygon)
    { return polygons.Areas[polygon] >= FewestOfPolygon * areaPerSample; };
    for (std::size_t sample = 0; sample < polygonOf.size(); ++sample)
    {
      if (isLarge(polygonOf[sample]))
      {
        ++next[polygonOf[sample] + 1];
      }
      else
      {
        others.push_back(static_cast<vtkIdType>(sample));
      }
    }
    std::partial_sum(next.begin(), next.end(), next.begin());
    for (std::size_t polygon = 0; polygon < polygons.Cells.size(); ++polygon)
    {
      if (next[polygon + 1] > next[polygon])
      {
        this->Polygons.push_back(polygon);
        this->Begins.push_back(next[polygon]);
        this->Normals.emplace_back(polygons.Normals[polygon]);
      }
    }
    this->Samples.resize(static_cast<std::size_t>(next.back()));
    for (std::size_t sample = 0; sample < polygonOf.size(); ++sample)
    {
      if (isLarge(polygonOf[sample]))
      {
        this->Samples[static_cast<std::size_t>(next[polygonOf[sample]]++)] = static_cast<vtkIdType>(sample);
      }
    }
    this->AddNeighbors(polygons, polygonOf, others, points, areaPerSample);
    this->Begins.push_back(static_cast<vtkIdType>(this->Samples.size()));
    this->Elements = others.empty() ? polygons.Cells.size() : this->Polygons.size();
  }

private:
  void AddNeighbors(const struct Polygons& polygons, const std::vector<std::size_t>& polygonOf,
    const std::vector<vtkIdType>& samples, vtkPoints* points, double areaPerSample)
  {
    std::vector<glm::vec3> positions(samples.size());
    std::vector<glm::vec3> normals(samples.size());
    const vtkBoundingBox box(points->GetBounds());
    glm::dvec3 middle;
    box.GetCenter(&middle.x);
    for (std::size_t i = 0; i < samples.size(); ++i)
    {
      glm::dvec3 position;
      points->GetPoint(samples[i], &position.x);
      positions[i] = position - middle;
      normals[i] = polygons.Normals[polygonOf[static_cast<std::size_t>(samples[i])]];
    }
    const InkNeighborLists lists(positions, normals, areaPerSample);
    const auto first = static_cast<vtkIdType>(this->Samples.size());
    for (const std::uint32_t sample : lists.Groups.samples)
    {
      this->Samples.push_back(samples[sample]);
    }
    for (std::size_t list = 0; list < lists.Count(); ++list)
    {
      const std::size_t begin = lists.Groups.begins[list];
      this->Begins.push_back(first + static_cast<vtkIdType>(begin));
      const auto sample = static_cast<std::size_t>(samples[lists.Groups.samples[begin]]);
      this->Polygons.push_back(polygonOf[sample]);
      this->Normals.push_back(lists.Normals[list]);
    }
  }
};

/// A polygon's tuple, or the mean over the points of its first triangle.
vtkSmartPointer<vtkDataArray> ColorsOf(const InkMeshTriangles& triangles, const Polygons& polygons,
  const Lists& lists, vtkDataArray* colors, bool ofCells)
{
  vtkSmartPointer<vtkDataArray> result =
    vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(colors->GetDataType()));
  result->SetName(colors->GetName());
  result->SetNumberOfComponents(colors->GetNumberOfComponents());
  InkSetNumberOfTuples(result, static_cast<vtkIdType>(lists.Polygons.size()));
  for (std::size_t e = 0; e < lists.Polygons.size(); ++e)
  {
    const std::size_t polygon = lists.Polygons[e];
    const auto& [a, b, c] = triangles.Triangles[polygons.Triangles[polygon]];
    for (int component = 0; component < colors->GetNumberOfComponents(); ++component)
    {
      const double value = ofCells ? colors->GetComponent(polygons.Cells[polygon], component)
                                   : colors->GetComponent(a, component) / 3.0 +
          colors->GetComponent(b, component) / 3.0 + colors->GetComponent(c, component) / 3.0;
      result->SetComponent(static_cast<vtkIdType>(e), component, value);
    }
  }
  return result;
}

} // namespace

void InkMakeSurfaceStipples(vtkPolyData* mesh, const InkSurfaceStippleRequest& request, vtkPolyData* output)
{
  const InkMeshTriangles triangles(mesh, true);
  // A piece of only ghost cells.
  if (triangles.Triangles.empty())
  {
    return;
  }
  const bool smooth = InkPointNormals(mesh) != nullptr;
  const Polygons polygons(triangles, smooth);

  InkSampleRequest sampling;
  sampling.Noise = InkNoise::Progressive;
  sampling.Count = request.Count > 0
    ? static_cast<std::size_t>(request.Count)
    : std::max<std::size_t>(polygons.Cells.size(), 1) * static_cast<std::size_t>(request.PerPolygon);
  sampling.Seed = request.Seed;
  sampling.Progress = InkPartOfProgress(request.Progress, 0.0, 0.95);
  const InkSurfaceSamples samples(triangles, sampling);
  vtkNew<vtkPolyData> sampled;
  samples.AddFaces(mesh, sampled);
  auto* cells = vtkIdTypeArray::SafeDownCast(sampled->GetPointData()->GetArray("FaceId"));
  const auto count = static_cast<std::size_t>(cells->GetNumberOfValues());
  if (count == 0)
  {
    return;
  }
  const vtkSmartPointer<vtkPoints> points = samples.MakePoints(request.Doubles ? VTK_DOUBLE : VTK_FLOAT);
  const Lists lists(polygons, FindPolygons(polygons, { cells->GetPointer(0), count }), points);

  vtkNew<vtkPoints> ordered;
  ordered->SetData(InkPickTuples(points->GetData(), lists.Samples));
  output->SetPoints(ordered);
  output->SetVerts(InkMakePolyVertices(lists.Begins));
  output->GetPointData()->AddArray(
    InkPickTuples(InkMakePriority(static_cast<vtkIdType>(count)), lists.Samples));

  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  InkSetNumberOfTuples(normals, static_cast<vtkIdType>(lists.Polygons.size()));
  for (std::size_t e = 0; e < lists.Polygons.size(); ++e)
  {
    normals->SetTuple(static_cast<vtkIdType>(e), &lists.Normals[e].x);
  }
  output->GetCellData()->SetNormals(normals);
  if (request.Colors)
  {
    InkAddColors(output, ColorsOf(triangles, polygons, lists, request.Colors, request.ColorsOfCells));
  }
  const auto elements = static_cast<double>(lists.Elements);
  const double perElement = static_cast<double>(count) / elements;
  const double size = std::sqrt(polygons.Area / elements);
  InkAddStippleFields(output, InkElementKind::Surface, size, perElement);
}
