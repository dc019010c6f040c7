// SPDX-License-Identifier: BSD-3-Clause
#include "InkContourSurface.h"

#include "InkFeatureNormals.h"
#include "InkHasPolygons.h"
#include "InkImageGrid.h"
#include "InkIsoSurface.h"
#include "InkMeshTriangles.h"
#include "InkPointNormals.h"
#include "vtkInkIsoSurfaceSampler.h"
#include "vtkInkSilhouetteMapper.h"

#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include "Fields/Resampling/AxisResampling.h"
#include "Mesh/BorderEdges.h"
#include "Mesh/LongestBorder.h"
#include "Mesh/WeldedTriangles.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace
{

/// The cell array that surfaces of images have: how far behind the surface a silhouette by its normals may
/// lie, in world units. Of field data less is left when pieces are put together.
constexpr const char* DepthTolerance = "DepthTolerance";

/// In standard deviations of the Gaussian that smooths the normals, but not the surface. The gradient at a
/// distance s from the edge of a box is at right angles to an eye that sees the side beyond the edge at the
/// angle b where exp(-s^2 / 2) = 2 Phi(s) tan b: s is 2.5 for 1.3 degrees.
constexpr double Reach = 2.5;

/// In the unit of the image.
double FindTolerance(vtkImageData* image, vtkInkIsoSurfaceSampler* settings)
{
  if (settings->GetSmoothingTarget() != vtkInkIsoSurfaceSampler::NORMALS)
  {
    return 0.0;
  }
  const ink::GridGeometry grid = InkMakeGrid(image, InkExtent(image->GetExtent()));
  const glm::dvec3 deviation = grid.spacing() * ink::smoothingDeviation(grid, settings->GetSmoothing());
  return Reach * std::max({ deviation.x, deviation.y, deviation.z });
}

bool HasBorder(vtkPolyData* mesh)
{
  const InkMeshTriangles triangles(mesh, false, InkMeshTriangles::Order::OfMesh);
  if (ink::hasPairedEdges(triangles.GetMesh()))
  {
    return false;
  }
  const ink::WeldedTriangles welded(triangles.GetMesh());
  return ink::longestBorder(welded.mesh()) > InkContourSurface::ShortestBorder * welded.diagonal();
}

} // namespace

bool InkContourSurface::IsOfImage(vtkPolyData* surface)
{
  return surface->GetCellData()->HasArray(DepthTolerance);
}

void InkContourSurface::Follow(vtkInkSilhouetteMapper* mapper, bool creases)
{
  vtkPolyData* surface = mapper->GetInput();
  vtkDataArray* tolerance = surface ? surface->GetCellData()->GetArray(DepthTolerance) : nullptr;
  mapper->SetCreases(creases && !tolerance);
  mapper->SetDepthTolerance(tolerance && tolerance->GetNumberOfTuples() > 0 ? tolerance->GetRange()[1] : 0.0);
}

std::string InkContourSurface::MakeOfImages(
  InkIsoSurface& isoSurface, std::span<vtkImageData* const> images, vtkPolyData* surface)
{
  std::string problem;
  std::vector<vtkSmartPointer<vtkPolyData>> parts;
  for (vtkImageData* image : this->Style->GetProcesses().GatherImages(images))
  {
    parts.push_back(vtkSmartPointer<vtkPolyData>::New());
    problem = isoSurface.Mesh(this->Style, image, parts.back());
    if (!problem.empty())
    {
      return problem;
    }
    vtkNew<vtkFloatArray> tolerance;
    tolerance->SetName(DepthTolerance);
    tolerance->SetNumberOfTuples(parts.back()->GetNumberOfCells());
    tolerance->Fill(FindTolerance(image, isoSurface.GetSampler()));
    parts.back()->GetCellData()->AddArray(tolerance);
  }
  if (!parts.empty())
  {
    surface->ShallowCopy(InkAppend(parts));
  }
  return {};
}

std::string InkContourSurface::MakeOfEdges(vtkPolyData* mesh, vtkPolyData* surface)
{
  try
  {
    const vtkSmartPointer<vtkPolyData> split = InkWithFeatureNormals(mesh);
    if (InkHasFeatureEdges(split) || HasBorder(split))
    {
      surface->ShallowCopy(split);
      surface->GetPointData()->SetNormals(InkPointNormals(split));
    }
  }
  catch (const std::invalid_argument& problem)
  {
    return std::string("The mesh's edges cannot be drawn: ") + problem.what();
  }
  return {};
}

std::string InkContourSurface::MakeOfMesh(vtkPolyData* mesh, vtkPolyData* surface, bool voxels)
{
  if (!InkHasPolygons(mesh))
  {
    this->Style->AddNote("there are no silhouettes, as the points have no polygons between them");
    return {};
  }
  if (voxels)
  {
    this->Style->AddNote(
      "silhouettes are lines in image space, as segments through voxels need an image; found a mesh");
  }
  return this->Style->TakeMeshWithNormals(mesh, surface);
}
