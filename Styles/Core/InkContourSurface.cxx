// SPDX-License-Identifier: BSD-3-Clause
#include "InkContourSurface.h"

#include "InkHasPolygons.h"
#include "InkIsoSurface.h"
#include "vtkInkSilhouetteMapper.h"

#include "vtkCellData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <vector>

namespace
{

/// The cell array that surfaces of images have. Of field data less is left when pieces are put together.
constexpr const char* OfImage = "OfImage";

} // namespace

bool InkContourSurface::IsOfImage(vtkPolyData* surface)
{
  return surface->GetCellData()->HasArray(OfImage);
}

void InkContourSurface::SetCreases(vtkInkSilhouetteMapper* mapper, bool creases)
{
  vtkPolyData* surface = mapper->GetInput();
  mapper->SetCreases(creases && !(surface && IsOfImage(surface)));
}

std::string InkContourSurface::MakeOfImages(InkIsoSurface& isoSurface, std::span<vtkImageData* const> images,
  const std::string& array, vtkPolyData* surface)
{
  std::string problem;
  std::vector<vtkSmartPointer<vtkPolyData>> parts;
  for (vtkImageData* image : this->Style->GetProcesses().GatherImages(images, array))
  {
    parts.push_back(vtkSmartPointer<vtkPolyData>::New());
    problem = isoSurface.Mesh(this->Style, image, parts.back(), array);
    if (!problem.empty())
    {
      return problem;
    }
  }
  if (!parts.empty())
  {
    surface->ShallowCopy(InkAppend(parts));
    vtkNew<vtkUnsignedCharArray> mark;
    mark->SetName(OfImage);
    mark->SetNumberOfTuples(surface->GetNumberOfCells());
    mark->Fill(1);
    surface->GetCellData()->AddArray(mark);
  }
  return {};
}

std::string InkContourSurface::MakeOfMesh(vtkPolyData* mesh, vtkPolyData* surface)
{
  if (!InkHasPolygons(mesh))
  {
    this->Style->AddNote("there are no silhouettes, as the points have no polygons between them");
    return {};
  }
  return this->Style->TakeMeshWithNormals(mesh, true, surface);
}
