// SPDX-License-Identifier: BSD-3-Clause
#include "InkIsoSurfaceMesh.h"

#include "InkImageGrid.h"
#include "InkIndexMesh.h"
#include "vtkInkIsoSurfaceSampler.h"

#include "Core/ParallelChunks.h"
#include "Core/UnitOrZero.h"
#include "Fields/Grid/GridField.h"
#include "Fields/Resampling/ResampleGrid.h"
#include "IsoSurface/ActiveCellComponents.h"
#include "IsoSurface/ResampledSamples.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace
{

ink::IsoSurfaceResampling FindResampling(const ink::GridGeometry& grid, vtkInkIsoSurfaceSampler* settings)
{
  constexpr std::size_t mostValues = std::size_t(1) << 27;
  const auto with = [&](int subdivision)
  {
    return ink::makeIsoSurfaceResampling(grid, settings->GetSmoothing(), subdivision,
      static_cast<ink::SmoothingTarget>(settings->GetSmoothingTarget()), false,
      settings->GetShapeBasedInterpolation());
  };
  int subdivision = settings->GetSubdivision();
  while (
    subdivision > 1 && ink::resampledGeometry(grid, with(subdivision).subdivision).sampleCount() > mostValues)
  {
    subdivision /= 2;
  }
  ink::IsoSurfaceResampling resampling = with(subdivision);
  glm::ivec3& cells = resampling.subdivision;
  while (cells != glm::ivec3(1) && ink::resampledGeometry(grid, cells).sampleCount() > mostValues)
  {
    const int most = std::max({ cells.x, cells.y, cells.z });
    cells = glm::min(cells, glm::ivec3(most / 2));
  }
  return resampling;
}

/// Resampled values of an image, and the iso-surfaces in them.
template <class Work>
class ResampledImage
{
public:
  ResampledImage(const ink::GridField<Work>& field, const ink::IsoSurfaceResampling& resampling)
    : Geometry(ink::resampledGeometry(field.geometry(), resampling.subdivision))
  {
    const bool onlyNormals =
      resampling.target == ink::SmoothingTarget::Normals && resampling.deviation != glm::dvec3(0.0);
    this->Smooth = this->Resample(field, resampling, 1.0, ink::SmoothingKernel::Gaussian);
    if (onlyNormals)
    {
      this->Surface =
        this->Resample(field, resampling, ink::fourthOrderShare, ink::SmoothingKernel::FourthOrder);
    }
  }

  const ink::GridGeometry& GetGeometry() const { return this->Geometry; }

  /// A surface as vtkFlyingEdges3D finds it.
  /// @param cap whether it is closed where it leaves the image
  std::string FindSurface(
    double isoValue, bool cap, const std::function<std::string(vtkAlgorithm*)>& update, InkIndexMesh& mesh)
  {
    std::vector<Work>& values = this->Surface.empty() ? this->Smooth : this->Surface;
    const glm::ivec3 size = this->Geometry.dimensions();
    std::vector<Work> closed = cap ? Surround(values, size, isoValue) : std::vector<Work>();
    const glm::ivec3 margin(cap ? 1 : 0);
    vtkNew<vtkAOSDataArrayTemplate<Work>> array;
    std::vector<Work>& used = cap ? closed : values;
    // The vector keeps its memory.
    array->SetArray(used.data(), static_cast<vtkIdType>(used.size()), 1);
    vtkNew<vtkImageData> image;
    image->SetDimensions(&(size + 2 * margin)[0]);
    image->GetPointData()->SetScalars(array);
    vtkNew<vtkFlyingEdges3D> edges;
    edges->SetInputData(image);
    edges->SetValue(0, isoValue);
    edges->ComputeNormalsOff();
    edges->ComputeScalarsOff();
    const std::string problem = update(edges);
    vtkPolyData* found = edges->GetOutput();
    mesh.Points.resize(static_cast<std::size_t>(found->GetNumberOfPoints()));
    for (std::size_t n = 0; n < mesh.Points.size(); ++n)
    {
      found->GetPoint(static_cast<vtkIdType>(n), &mesh.Points[n][0]);
      mesh.Points[n] -= margin;
    }
    mesh.Triangles.reserve(static_cast<std::size_t>(found->GetNumberOfPolys()));
    for (vtkIdType n = 0; n < found->GetNumberOfPolys(); ++n)
    {
      vtkIdType count = 0;
      const vtkIdType* ids = nullptr;
      found->GetPolys()->GetCellAtId(n, count, ids);
      mesh.Triangles.push_back({ static_cast<std::uint32_t>(ids[0]), static_cast<std::uint32_t>(ids[1]),
        static_cast<std::uint32_t>(ids[2]) });
    }
    return problem;
  }

  /// Out of the image's side on whose cap a point lies; zero for those within the image.
  glm::ivec3 FindSide(const glm::dvec3& index) const
  {
    const glm::dvec3 last = this->Geometry.dimensions() - 1;
    return glm::ivec3(glm::greaterThan(index, last)) - glm::ivec3(glm::lessThan(index, glm::dvec3(0.0)));
  }

  /// The unit normal at a point of a surface, along the negative gradient; on a cap, out of the image. Zero
  /// where there is no gradient.
  glm::vec3 FindNormal(const glm::dvec3& index) const
  {
    const glm::ivec3 side = this->FindSide(index);
    if (side != glm::ivec3(0))
    {
      return glm::vec3(ink::unitOrZero(this->Geometry.gradientDirection() * glm::dvec3(side)));
    }
    const glm::dvec3 last = this->Geometry.dimensions() - 1;
    const glm::ivec3 cell = glm::min(glm::ivec3(index), glm::ivec3(last));
    const glm::dvec3 share = index - glm::dvec3(cell);
    const ink::GridField<Work> field(this->Geometry, this->Smooth);
    glm::dvec3 sum(0.0);
    for (int corner = 0; corner < 8; ++corner)
    {
      const glm::ivec3 step(corner & 1, corner >> 1 & 1, corner >> 2);
      const glm::dvec3 factors = glm::mix(1.0 - share, share, glm::dvec3(step));
      const double weight = factors.x * factors.y * factors.z;
      // Points lie on edges, so that few corners count.
      if (weight > 0.0)
      {
        sum -= weight * ink::unitOrZero(this->Geometry.gradientDirection() * field.gradientAt(cell + step));
      }
    }
    return glm::vec3(ink::unitOrZero(sum));
  }

private:
  std::vector<Work> Resample(const ink::GridField<Work>& field, const ink::IsoSurfaceResampling& resampling,
    double share, ink::SmoothingKernel kernel) const
  {
    const auto along = [&](int axis)
    {
      return ink::AxisResampling(share * resampling.deviation[axis], resampling.subdivision[axis],
        field.geometry().dimensions()[axis], kernel);
    };
    std::vector<Work> values(this->Geometry.sampleCount());
    ink::resampleGrid(field, { along(0), along(1), along(2) }, std::span<Work>(values));
    return values;
  }

  /// Values with a layer around them that is below the iso-value, so that a surface ends at the image's
  /// sides: where values are above it, 1/256 of a cell beyond.
  static std::vector<Work> Surround(const std::vector<Work>& values, const glm::ivec3& size, double isoValue)
  {
    constexpr Work steepness = 255;
    const Work iso = static_cast<Work>(isoValue);
    const glm::ivec3 wider = size + 2;
    std::vector<Work> all;
    all.reserve(static_cast<std::size_t>(wider.x) * wider.y * wider.z);
    for (int k = 0; k < wider.z; ++k)
    {
      for (int j = 0; j < wider.y; ++j)
      {
        for (int i = 0; i < wider.x; ++i)
        {
          const glm::ivec3 at = glm::ivec3(i, j, k) - 1;
          const glm::ivec3 nearest = glm::clamp(at, glm::ivec3(0), size - 1);
          const Work value = values[static_cast<std::size_t>(nearest.x) +
            static_cast<std::size_t>(size.x) *
              (static_cast<std::size_t>(nearest.y) + static_cast<std::size_t>(size.y) * nearest.z)];
          const Work below = std::min(
            iso - steepness * (value - iso), std::nextafter(iso, std::numeric_limits<Work>::lowest()));
          all.push_back(at == nearest || value < iso ? value : below);
        }
      }
    }
    return all;
  }

  ink::GridGeometry Geometry;
  std::vector<Work> Surface; ///< what the surface lies in; empty: Smooth
  std::vector<Work> Smooth;  ///< what normals are of
};

/// The surfaces of an image in world coordinates.
template <class Work>
void FillMesh(const InkIndexMesh& surfaces, const ResampledImage<Work>& image, vtkPolyData* mesh)
{
  const auto count = static_cast<vtkIdType>(surfaces.Points.size());
  vtkPoints* points = mesh->GetPoints();
  auto* normals = vtkFloatArray::SafeDownCast(mesh->GetPointData()->GetNormals());
  points->SetNumberOfPoints(count);
  normals->SetNumberOfTuples(count);
  ink::parallelForEach(surfaces.Points.size(),
    [&](std::size_t n)
    {
      const auto id = static_cast<vtkIdType>(n);
      const glm::dvec3 world = image.GetGeometry().toWorld(surfaces.Points[n]);
      const glm::vec3 normal = image.FindNormal(surfaces.Points[n]);
      points->SetPoint(id, &world[0]);
      normals->SetTypedTuple(id, &normal[0]);
    });
  const auto triangles = static_cast<vtkIdType>(surfaces.Triangles.size());
  mesh->GetPolys()->AllocateExact(triangles, 3 * triangles);
  for (const InkIndexMesh::Triangle& triangle : surfaces.Triangles)
  {
    mesh->GetPolys()->InsertNextCell({ triangle[0], triangle[1], triangle[2] });
  }
}

} // namespace

std::string InkMakeIsoSurfaceMesh(vtkImageData* image, vtkDataArray* scalars,
  vtkInkIsoSurfaceSampler* settings, const std::function<std::string(vtkAlgorithm*)>& update,
  vtkPolyData* mesh)
{
  const ink::GridGeometry grid = InkMakeGrid(image, InkExtent(image->GetExtent()));
  mesh->Initialize();
  vtkNew<vtkPoints> points;
  points->SetDataType(InkNeedsDoublePrecision(grid) ? VTK_DOUBLE : VTK_FLOAT);
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  mesh->SetPoints(points);
  mesh->SetPolys(vtkSmartPointer<vtkCellArray>::New());
  mesh->GetPointData()->SetNormals(normals);
  const glm::ivec3& samples = grid.dimensions();
  if (std::min({ samples.x, samples.y, samples.z }) < 2)
  {
    return "expected an image with at least 2 samples along each axis, found " + std::to_string(samples.x) +
      " x " + std::to_string(samples.y) + " x " + std::to_string(samples.z);
  }
  const ink::IsoSurfaceResampling resampling = FindResampling(grid, settings);
  const InkCellFilter cells(grid.dimensions(), resampling.subdivision, image);
  const ink::ComponentSelection parts = ink::ComponentSelection{ settings->GetSmallestPart(),
    static_cast<std::size_t>(settings->GetLargestParts()) }
                                          .inDividedCells(settings->GetSubdivision());
  const ink::ElementMarks hidden = InkGetMarks(image->GetPointData(), vtkDataSetAttributes::HIDDENPOINT);
  const auto make = [&](auto zero)
  {
    using Work = decltype(zero);
    vtkNew<vtkAOSDataArrayTemplate<Work>> values;
    values->DeepCopy(scalars);
    const std::span<const Work> all(
      values->GetPointer(0), static_cast<std::size_t>(values->GetNumberOfValues()));
    ResampledImage<Work> resampled(ink::GridField<Work>(grid, all, 1, hidden), resampling);
    InkIndexMesh surfaces;
    std::string problem;
    for (int n = 0; n < settings->GetNumberOfContours() && problem.empty(); ++n)
    {
      InkIndexMesh surface;
      problem = resampled.FindSurface(
        settings->GetValue(n), settings->GetCut() == vtkInkIsoSurfaceSampler::CAP, update, surface);
      std::erase_if(surface.Triangles,
        [&](const InkIndexMesh::Triangle& triangle) { return !cells.IsKept(surface, triangle); });
      if (!parts.keepsAll())
      {
        surface.RemoveUnusedPoints();
        surface.KeepParts(parts);
      }
      // Where a surface and its caps meet, each has a border: slivers between them would join their normals.
      std::erase_if(surface.Triangles,
        [&](const InkIndexMesh::Triangle& triangle)
        {
          const auto side = [&](std::size_t corner)
          { return resampled.FindSide(surface.Points[triangle[corner]]); };
          return side(0) != side(1) || side(0) != side(2);
        });
      surface.RemoveUnusedPoints();
      surfaces.Append(surface);
    }
    FillMesh(surfaces, resampled, mesh);
    return problem;
  };
  // Numbers that float holds, as floats.
  const bool isSmall = scalars->GetDataType() == VTK_FLOAT || scalars->GetDataTypeSize() <= 2;
  return isSmall ? make(0.0f) : make(0.0);
}
