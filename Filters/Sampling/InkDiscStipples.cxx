// SPDX-License-Identifier: BSD-3-Clause
#include "InkDiscStipples.h"

#include "Core/FiniteBox.h"
#include "Core/ParallelChunks.h"
#include "InkAllocate.h"
#include "InkGhostPoint.h"
#include "InkNeighborLists.h"
#include "InkPointNormals.h"
#include "InkPointOutput.h"
#include "InkSampleCell.h"
#include "InkStippleFields.h"
#include "InkStippleOutput.h"
#include "InkVTKCompat.h"
#include "IsoSurface/IsoSurfaceSamples.h"
#include "PointSampling/DiscSamples.h"
#include "PointSampling/ProgressiveBlueNoise.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{

/// Memory per stipple while they are made.
constexpr double BytesPerStipple = 160.0;

bool Fits(vtkDataArray* array, int components, vtkIdType count)
{
  return array && array->GetNumberOfComponents() == components && array->GetNumberOfTuples() == count;
}

/// The areas that discs stand for.
class DiscAreas
{
public:
  explicit DiscAreas(vtkPolyData* points)
    : Cell(InkGetSampleCell(points).value_or(glm::dmat3(0.0)))
    , Radius(ink::isoSurfaceSampleRadius(this->Cell))
  {
  }

  /// See ink::SurfaceDiscs.
  float FindReach() const
  {
    return std::max(ink::reachOfCubes, static_cast<float>(ink::isoSurfaceSampleReach(this->Cell)));
  }

  double Find(const glm::dvec3& normal, double radius) const
  {
    // Other discs beside those of the cells may have been appended.
    const bool ofCell = std::abs(radius - this->Radius) <= 1e-5 * this->Radius && this->Radius > 0.0;
    return ofCell ? ink::isoSurfaceSampleArea(this->Cell, glm::normalize(normal)) : ink::areaOfDisc(radius);
  }

private:
  glm::dmat3 Cell;
  double Radius; ///< of its samples' discs
};

/// The middle of the bounds of the points that are finite, in steps of at least a sixteenth of their width
/// that are powers of two: so that the same points lie at the same positions, up to whole steps, when others
/// come and go.
glm::dvec3 MiddleOf(vtkPolyData* points)
{
  const auto [low, high] = ink::finiteBox(static_cast<std::size_t>(points->GetNumberOfPoints()),
    [&](std::size_t i)
    {
      glm::dvec3 p;
      points->GetPoint(static_cast<vtkIdType>(i), &p.x);
      return p;
    });
  const glm::dvec3 size = high - low;
  const double width = std::max({ size.x, size.y, size.z });
  if (!(width > 0.0 && std::isfinite(width)))
  {
    return width == 0.0 ? low : glm::dvec3(0.0);
  }
  const double step = std::exp2(std::ceil(std::log2(width / 16.0)));
  return step * glm::round(0.5 * (low + high) / step);
}

/// Points as discs, relative to about the middle of their bounds.
struct Discs
{
  std::vector<float> Areas;
  std::vector<glm::vec3> Centers;
  std::vector<glm::vec3> Normals;
  std::vector<float> Radii;
  glm::dvec3 Middle{ 0.0 };
  float Reach = ink::reachOfCubes;

  explicit Discs(vtkPolyData* points)
    : Areas(static_cast<std::size_t>(points->GetNumberOfPoints()))
    , Centers(this->Areas.size())
    , Normals(this->Centers.size())
    , Radii(this->Centers.size())
  {
    vtkDataArray* normals = InkPointNormals(points);
    vtkDataArray* radii = points->GetPointData()->GetArray("Radius");
    vtkUnsignedCharArray* ghosts = points->GetPointGhostArray();
    const DiscAreas areas(points);
    this->Middle = MiddleOf(points);
    this->Reach = areas.FindReach();
    ink::parallelForEach(this->Centers.size(),
      [&](std::size_t i)
      {
        const auto id = static_cast<vtkIdType>(i);
        glm::dvec3 p;
        glm::dvec3 normal;
        double radius = 0.0;
        points->GetPoint(id, &p.x);
        normals->GetTuple(id, &normal.x);
        radii->GetTuple(id, &radius);
        this->Centers[i] = p - this->Middle;
        this->Normals[i] = normal;
        this->Radii[i] = InkIsGhostPoint(ghosts, id) ? 0.0f : static_cast<float>(radius);
        this->Areas[i] = static_cast<float>(areas.Find(normal, radius));
      });
    this->LeaveOutEdges();
  }

  /// Neighbors at one position with different normals are the rim of a cut, which is an edge: stipples on its
  /// discs would stick out of the surface.
  void LeaveOutEdges()
  {
    const auto same = [this](std::size_t i, std::size_t j)
    { return this->Centers[i] == this->Centers[j] && this->Normals[i] != this->Normals[j]; };
    const std::size_t count = this->Centers.size();
    ink::parallelForEach(count,
      [&](std::size_t i)
      {
        if ((i > 0 && same(i - 1, i)) || (i + 1 < count && same(i, i + 1)))
        {
          this->Radii[i] = 0.0f;
        }
      });
  }

  ink::SurfaceDiscs Get() const
  {
    return { this->Centers, this->Normals, this->Radii, this->Areas, this->Reach };
  }
};

std::vector<glm::vec3> VectorsOf(
  const std::vector<ink::DiscSample>& samples, glm::vec3 ink::DiscSample::*member)
{
  std::vector<glm::vec3> vectors(samples.size());
  ink::parallelForEach(samples.size(), [&](std::size_t i) { vectors[i] = samples[i].*member; });
  return vectors;
}

template <class Array>
vtkSmartPointer<vtkPoints> MakePoints(const std::vector<glm::vec3>& positions, const InkNeighborLists& lists,
  const glm::dvec3& middle, vtkNew<Array>& array)
{
  using Real = typename Array::ValueType;
  array->SetNumberOfComponents(3);
  InkSetNumberOfTuples(array, static_cast<vtkIdType>(positions.size()));
  Real* values = array->GetPointer(0);
  ink::parallelForEach(positions.size(),
    [&](std::size_t i)
    {
      const glm::dvec3 p = middle + glm::dvec3(positions[lists.Groups.samples[i]]);
      for (int axis = 0; axis < 3; ++axis)
      {
        values[3 * i + static_cast<std::size_t>(axis)] = static_cast<Real>(p[axis]);
      }
    });
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetData(array);
  return points;
}

/// Of the disc of each list's first stipple.
vtkSmartPointer<vtkDataArray> ColorsOf(
  const InkNeighborLists& lists, const std::vector<ink::DiscSample>& samples, vtkDataArray* colors)
{
  std::vector<vtkIdType> discs(lists.Count());
  for (std::size_t list = 0; list < lists.Count(); ++list)
  {
    const std::uint32_t first = lists.Groups.samples[lists.Groups.begins[list]];
    discs[list] = samples[first].disc;
  }
  return InkPickTuples(colors, discs);
}

} // namespace

bool InkHasDiscs(vtkPolyData* points)
{
  const vtkIdType count = points->GetNumberOfPoints();
  return Fits(InkPointNormals(points), 3, count) &&
    Fits(points->GetPointData()->GetArray("Radius"), 1, count);
}

double InkAreaOfDiscs(vtkPolyData* points)
{
  return ink::areaOf(Discs(points).Get());
}

void InkMakeDiscStipples(vtkPolyData* points, const InkDiscStippleRequest& request, vtkPolyData* output)
{
  if (points->GetNumberOfPoints() >= static_cast<vtkIdType>(std::numeric_limits<std::uint32_t>::max()))
  {
    throw std::invalid_argument(
      "there are " + std::to_string(points->GetNumberOfPoints()) + " points; expected fewer than 4294967295");
  }
  const Discs discs(points);
  const double count = request.Count > 0
    ? static_cast<double>(request.Count)
    : static_cast<double>(points->GetNumberOfPoints()) * request.PerPoint;
  InkCheckStippleMemory(count, BytesPerStipple);
  const double spacing = ink::spacingForCount(discs.Get(), count, ink::defaultCandidates);
  if (!(spacing > 0.0))
  {
    return;
  }
  const std::vector<ink::DiscSample> samples = ink::sampleDiscs(discs.Get(), spacing, ink::defaultCandidates,
    static_cast<std::uint64_t>(request.Seed), InkPartOfProgress(request.Progress, 0.0, 0.95));
  if (samples.empty())
  {
    return;
  }
  const double area = ink::areaPerSample(spacing, ink::defaultCandidates);
  const std::vector<glm::vec3> positions = VectorsOf(samples, &ink::DiscSample::position);
  const InkNeighborLists lists(positions, VectorsOf(samples, &ink::DiscSample::normal), area);
  vtkNew<vtkFloatArray> floats;
  vtkNew<vtkDoubleArray> doubles;
  output->SetPoints(request.Doubles ? MakePoints(positions, lists, discs.Middle, doubles)
                                    : MakePoints(positions, lists, discs.Middle, floats));
  output->SetVerts(
    InkMakePolyVertices(std::vector<vtkIdType>(lists.Groups.begins.begin(), lists.Groups.begins.end())));
  output->GetPointData()->AddArray(InkMakePriority(lists.Groups.samples));
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  InkSetNumberOfTuples(normals, static_cast<vtkIdType>(lists.Count()));
  for (std::size_t list = 0; list < lists.Count(); ++list)
  {
    normals->SetTuple(static_cast<vtkIdType>(list), &lists.Normals[list].x);
  }
  output->GetCellData()->SetNormals(normals);
  if (request.Colors)
  {
    InkAddColors(output, ColorsOf(lists, samples, request.Colors));
  }
  const double perElement = static_cast<double>(samples.size()) / static_cast<double>(lists.Count());
  const double size = std::sqrt(area * perElement);
  InkAddStippleFields(output, InkElementKind::Surface, size, perElement);
}
