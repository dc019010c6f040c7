// SPDX-License-Identifier: BSD-3-Clause
#include "InkImageContours.h"

#include "InkAllocate.h"
#include "InkImageGrid.h"
#include "InkPointOutput.h"
#include "InkWithGridField.h"

#include "IsoSurface/IsoSurfaceSamples.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

/// One iso-surface, of values of a type that others need not know.
class InkImageContours::Surface
{
public:
  virtual ~Surface() = default;

  virtual ink::Contours Find(
    const ink::Eye& eye, const ink::ContourArrays& arrays, const ink::GridContourOptions& options) const = 0;
  virtual ink::Contours FindBorder(const ink::ContourArrays& arrays) const = 0;
  virtual ink::ActiveCells FindCells() const = 0;
  /// A sample in each of these, see ink::placeIsoSurfaceSamples.
  virtual void Place(
    const ink::ActiveCells& cells, std::span<double> points, std::span<float> normals) const = 0;
};

namespace
{

/// @param Base InkImageContours::Surface, which is private there
template <class T, class Base>
class SurfaceOf : public Base
{
public:
  SurfaceOf(const ink::GridField<T>& field, double isoValue, const ink::CellSelection& cells,
    ink::MinMaxBricks* ranges, const ink::Progress& progress)
    : Field(field)
    , IsoValue(isoValue)
    , Cells(cells)
    , Contours(field, isoValue, cells, ranges, progress)
  {
  }

  ink::Contours Find(const ink::Eye& eye, const ink::ContourArrays& arrays,
    const ink::GridContourOptions& options) const override
  {
    return this->Contours.find(eye, arrays, options);
  }

  ink::Contours FindBorder(const ink::ContourArrays& arrays) const override
  {
    return this->Contours.border(arrays);
  }

  ink::ActiveCells FindCells() const override
  {
    return ink::findActiveCells(this->Field, this->IsoValue, ink::CrossingRule::HalfOpen, this->Cells);
  }

  void Place(const ink::ActiveCells& cells, std::span<double> points, std::span<float> normals) const override
  {
    ink::placeIsoSurfaceSamples(this->Field, this->IsoValue, {}, cells, points, normals);
  }

private:
  ink::GridField<T> Field;
  double IsoValue;
  ink::CellSelection Cells;
  ink::GridContours<T> Contours;
};

} // namespace

bool InkImageContours::IsOf(const Input& input) const
{
  return this->Source.Image == input.Image && this->Source.Scalars == input.Scalars &&
    this->Source.Component == input.Component && this->Source.Cells.begin == input.Cells.begin &&
    this->Source.Cells.end == input.Cells.end &&
    this->SourceTime == std::max(input.Image->GetMTime(), input.Scalars->GetMTime());
}

void InkImageContours::Clear()
{
  *this = InkImageContours();
}

int InkImageContours::Update(
  const Input& input, std::span<const double> isoValues, const ink::Progress& progress)
{
  if (!this->IsOf(input))
  {
    this->Clear();
    this->Source = input;
    this->SourceTime = std::max(input.Image->GetMTime(), input.Scalars->GetMTime());
    this->ComponentToRead = input.Component;
    this->Values = InkMakeContiguous(input.Scalars, this->ComponentToRead);
    this->Ghosts = input.Image->GetPointGhostArray();
    this->CellGhosts = input.Image->GetCellGhostArray();
  }
  const ink::GridGeometry geometry = InkMakeGrid(input.Image, InkExtent(input.Image->GetExtent()));
  this->DiscRadius = ink::isoSurfaceSampleRadius(geometry);
  const ink::ElementMarks hidden =
    InkGetMarks(input.Image->GetPointData(), vtkDataSetAttributes::HIDDENPOINT);
  std::vector<Kept> surfaces;
  int builds = 0;
  for (const double isoValue : isoValues)
  {
    const auto kept = std::find_if(this->Surfaces.begin(), this->Surfaces.end(),
      [isoValue](const Kept& surface) { return surface.IsoValue == isoValue; });
    surfaces.push_back({ isoValue, kept != this->Surfaces.end() ? kept->Own : nullptr });
    if (surfaces.back().Own || std::isnan(isoValue))
    {
      continue;
    }
    ++builds;
    surfaces.back().Own = InkWithGridField(geometry, this->Values, this->ComponentToRead, hidden,
      [&]<class T>(const ink::GridField<T>& field) -> std::shared_ptr<const Surface>
      {
        return std::make_shared<const SurfaceOf<T, Surface>>(
          field, isoValue, input.Cells, &this->Ranges, progress);
      });
  }
  this->Surfaces = std::move(surfaces);
  return builds;
}

template <class OfSurface>
ink::Contours InkImageContours::Collect(
  const ink::ContourArrays& arrays, std::vector<int>& surfaces, const OfSurface& ofSurface) const
{
  ink::Contours all;
  surfaces.clear();
  for (std::size_t n = 0; n < this->Surfaces.size(); ++n)
  {
    if (this->Surfaces[n].Own)
    {
      ink::appendContours(all, ofSurface(*this->Surfaces[n].Own), arrays);
      surfaces.resize(all.chains.size(), static_cast<int>(n));
    }
  }
  return all;
}

ink::Contours InkImageContours::Find(const ink::Eye& eye, const ink::ContourArrays& arrays,
  const ink::GridContourOptions& options, std::vector<int>& surfaces) const
{
  return this->Collect(
    arrays, surfaces, [&](const Surface& surface) { return surface.Find(eye, arrays, options); });
}

ink::Contours InkImageContours::FindBorders(
  const ink::ContourArrays& arrays, std::vector<int>& surfaces) const
{
  return this->Collect(arrays, surfaces, [&](const Surface& surface) { return surface.FindBorder(arrays); });
}

vtkSmartPointer<vtkPolyData> InkImageContours::MakeDiscs() const
{
  std::vector<std::pair<const Surface*, ink::ActiveCells>> parts;
  std::size_t count = 0;
  for (const Kept& surface : this->Surfaces)
  {
    if (surface.Own)
    {
      parts.emplace_back(surface.Own.get(), surface.Own->FindCells());
      count += parts.back().second.count;
    }
  }
  vtkNew<vtkDoubleArray> positions;
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  for (vtkDataArray* array :
    { static_cast<vtkDataArray*>(positions.Get()), static_cast<vtkDataArray*>(normals.Get()) })
  {
    array->SetNumberOfComponents(3);
    InkSetNumberOfTuples(array, static_cast<vtkIdType>(count));
  }
  std::size_t begin = 0;
  for (const auto& [surface, cells] : parts)
  {
    const std::size_t size = 3 * cells.count;
    surface->Place(
      cells, { positions->GetPointer(0) + begin, size }, { normals->GetPointer(0) + begin, size });
    begin += size;
  }
  vtkNew<vtkPoints> points;
  points->SetData(positions);
  auto discs = vtkSmartPointer<vtkPolyData>::New();
  discs->SetPoints(points);
  discs->GetPointData()->SetNormals(normals);
  discs->GetPointData()->AddArray(
    InkMakeConstant("Radius", VTK_FLOAT, static_cast<vtkIdType>(count), this->DiscRadius));
  return discs;
}

void InkImageContours::AddSurfaceIndex(std::span<const int> surfaces, vtkPolyData* lines) const
{
  if (this->Surfaces.size() < 2)
  {
    return;
  }
  vtkNew<vtkIntArray> indices;
  indices->SetName("SurfaceIndex");
  indices->SetNumberOfTuples(static_cast<vtkIdType>(surfaces.size()));
  std::copy(surfaces.begin(), surfaces.end(), indices->GetPointer(0));
  lines->GetCellData()->AddArray(indices);
}
