// SPDX-License-Identifier: BSD-3-Clause
#include "InkAddCuts.h"

#include "InkAllocate.h"

#include "vtkDataArray.h"

#include <glm/common.hpp>

#include <cstring>
#include <numeric>

std::vector<vtkDataArray*> InkSampleArrays::All() const
{
  std::vector<vtkDataArray*> arrays{ this->Points };
  for (vtkDataArray* array : { this->Normals, this->Cells })
  {
    if (array)
    {
      arrays.push_back(array);
    }
  }
  return arrays;
}

void InkAddCuts(
  std::span<const ink::CutSamples> cuts, const InkSampleArrays& arrays, std::vector<std::size_t>& counts)
{
  std::size_t total = std::accumulate(counts.begin(), counts.end(), std::size_t(0));
  std::size_t added = 0;
  for (const ink::CutSamples& cut : cuts)
  {
    added += cut.points.size();
  }
  const std::vector<vtkDataArray*> all = arrays.All();
  for (vtkDataArray* array : all)
  {
    InkReserve(array, static_cast<vtkIdType>(total + added));
    InkSetNumberOfTuples(array, static_cast<vtkIdType>(total + added));
  }
  const int type = arrays.Normals ? arrays.Normals->GetDataType() : VTK_FLOAT;
  const double scale = type == VTK_FLOAT ? 1.0 : type == VTK_SHORT ? 32767.0 : 127.0;
  // From the last surface on, so that none is overwritten before it has moved.
  for (std::size_t n = cuts.size(); n-- > 0;)
  {
    const ink::CutSamples& cut = cuts[n];
    total -= counts[n];
    added -= cut.points.size();
    for (vtkDataArray* array : all)
    {
      const std::size_t tuple =
        static_cast<std::size_t>(array->GetNumberOfComponents()) * array->GetDataTypeSize();
      auto* values = static_cast<unsigned char*>(array->GetVoidPointer(0));
      std::memmove(values + (total + added) * tuple, values + total * tuple, counts[n] * tuple);
    }
    const std::size_t first = total + added + counts[n];
    for (std::size_t i = 0; i < cut.points.size(); ++i)
    {
      const auto point = static_cast<vtkIdType>(first + i);
      arrays.Points->SetTuple(point, &cut.points[i].x);
      if (arrays.Normals)
      {
        const glm::dvec3 normal = scale == 1.0 ? cut.normals[i] : glm::round(scale * cut.normals[i]);
        arrays.Normals->SetTuple(point, &normal.x);
      }
      if (arrays.Cells)
      {
        static_cast<ink::ActiveCellId*>(arrays.Cells->GetVoidPointer(0))[point] = cut.cells[i];
      }
    }
    counts[n] += cut.points.size();
  }
}
