// SPDX-License-Identifier: BSD-3-Clause
#include "InkImageContours.h"

#include "InkImageGrid.h"
#include "InkWithGridField.h"

#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <memory>

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
  }
  const ink::GridGeometry geometry = InkMakeGrid(input.Image, InkExtent(input.Image->GetExtent()));
  const ink::ElementMarks hidden =
    InkGetMarks(input.Image->GetPointData(), vtkDataSetAttributes::HIDDENPOINT);
  std::vector<Surface> surfaces;
  int builds = 0;
  for (const double isoValue : isoValues)
  {
    const auto kept = std::find_if(this->Surfaces.begin(), this->Surfaces.end(),
      [isoValue](const Surface& surface) { return surface.IsoValue == isoValue; });
    surfaces.push_back({ isoValue, kept != this->Surfaces.end() ? kept->Find : Finder() });
    if (surfaces.back().Find || std::isnan(isoValue))
    {
      continue;
    }
    ++builds;
    surfaces.back().Find = InkWithGridField(geometry, this->Values, this->ComponentToRead, hidden,
      [&]<class T>(const ink::GridField<T>& field) -> Finder
      {
        const auto contours =
          std::make_shared<const ink::GridContours<T>>(field, isoValue, input.Cells, &this->Ranges, progress);
        return [contours](const ink::Eye& eye, const ink::ContourArrays& arrays,
                 const ink::GridContourOptions& options) { return contours->find(eye, arrays, options); };
      });
  }
  this->Surfaces = std::move(surfaces);
  return builds;
}

ink::Contours InkImageContours::Find(const ink::Eye& eye, const ink::ContourArrays& arrays,
  const ink::GridContourOptions& options, std::vector<int>& surfaces) const
{
  ink::Contours all;
  surfaces.clear();
  for (std::size_t n = 0; n < this->Surfaces.size(); ++n)
  {
    if (this->Surfaces[n].Find)
    {
      ink::appendContours(all, this->Surfaces[n].Find(eye, arrays, options), arrays);
      surfaces.resize(all.chains.size(), static_cast<int>(n));
    }
  }
  return all;
}
