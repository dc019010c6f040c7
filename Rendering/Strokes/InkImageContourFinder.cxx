// SPDX-License-Identifier: BSD-3-Clause
#include "InkImageContourFinder.h"

#include "InkImageGrid.h"

#include "IsoSurface/IsoSurfaceSamples.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace
{

/// With which borders are found; they have no radial curvature.
constexpr ink::ContourArrays ArraysOf(bool radialCurvature)
{
  return { true, radialCurvature, true, true };
}

ink::GridGeometry GridOf(vtkImageData* image)
{
  return InkMakeGrid(image, InkExtent(image->GetExtent()));
}

} // namespace

bool InkImageContourFinder::Options::operator==(const Options& other) const
{
  const auto same = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
  return std::ranges::equal(this->IsoValues, other.IsoValues, same) && this->Component == other.Component &&
    this->Silhouettes == other.Silhouettes && this->Borders == other.Borders;
}

bool InkImageContourFinder::Update(vtkImageData* image, vtkDataArray* scalars, const Options& options)
{
  const vtkMTimeType time = std::max(image->GetMTime(), scalars->GetMTime());
  if (this->GetTime() > 0 && this->Image == image && this->Scalars == scalars && this->ImageTime == time &&
    this->Wanted == options)
  {
    return false;
  }
  this->SetReady(false);
  this->Discs = nullptr;
  try
  {
    const ink::CellSelection cells{ .skipped = InkGetLeftOutCells(image) };
    this->Surfaces.Update({ image, scalars, options.Component, cells }, options.IsoValues, {});
  }
  catch (...)
  {
    this->Surfaces.Clear();
    throw;
  }
  this->Borders = this->Surfaces.FindBorders(ArraysOf(false), this->BorderSurfaces);
  this->Image = image;
  this->Scalars = scalars;
  this->ImageTime = time;
  this->Wanted = options;
  this->SetReady(true);
  return true;
}

InkContourFinder::Found InkImageContourFinder::Find(const ink::Eye& eye) const
{
  // A surface with a border may show its silhouettes from its inside.
  const bool closed = this->Borders.chains.size() == 0;
  const ink::ContourArrays arrays = ArraysOf(closed);
  Found found;
  std::vector<int> surfaces;
  if (this->Wanted.Silhouettes)
  {
    found.Contours = this->Surfaces.Find(eye, arrays, {}, surfaces);
  }
  if (this->Wanted.Borders)
  {
    ink::appendContours(found.Contours, this->Borders, arrays);
    surfaces.insert(surfaces.end(), this->BorderSurfaces.begin(), this->BorderSurfaces.end());
  }
  const ink::GridGeometry grid = GridOf(this->Image);
  std::vector<vtkIdType> nearest;
  for (const glm::dvec3& position : found.Contours.positions)
  {
    const glm::ivec3 last = grid.dimensions() - 1;
    const glm::ivec3 sample = glm::clamp(glm::ivec3(glm::round(grid.toIndex(position))), glm::ivec3(0), last);
    nearest.push_back(static_cast<vtkIdType>(grid.offset(sample)));
  }
  found.Lines = MakeLines(found.Contours, {}, nearest);
  this->Surfaces.AddSurfaceIndex(surfaces, found.Lines);
  return found;
}

vtkPolyData* InkImageContourFinder::GetSurface()
{
  if (!this->Discs)
  {
    this->Discs = this->Surfaces.MakeDiscs();
  }
  return this->Discs;
}

double InkImageContourFinder::GetDepthTolerance() const
{
  // A disc reaches by its radius out of a surface that bends away from it; its center, its normal and the
  // contours are those of the surface only up to the curvature within a cell.
  return 2.0 * ink::isoSurfaceSampleRadius(GridOf(this->Image));
}
