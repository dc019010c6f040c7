// SPDX-License-Identifier: BSD-3-Clause
#include "InkSurfaceParts.h"

#include "vtkDataArray.h"

#include <algorithm>
#include <cstring>

namespace
{

/// Points that stay: from `begin` up to but excluding `end`.
struct Range
{
  std::size_t begin;
  std::size_t end;
};

void Compact(vtkDataArray* array, const std::vector<Range>& kept)
{
  const std::size_t tuple =
    static_cast<std::size_t>(array->GetNumberOfComponents()) * array->GetDataTypeSize();
  auto* values = static_cast<unsigned char*>(array->GetVoidPointer(0));
  unsigned char* to = values;
  for (const Range& range : kept)
  {
    const std::size_t bytes = (range.end - range.begin) * tuple;
    std::memmove(to, values + range.begin * tuple, bytes);
    to += bytes;
  }
  array->Modified();
}

} // namespace

void InkKeepParts(std::span<const ink::ActiveCellId> cells, const ink::ComponentSelection& selection,
  std::span<vtkDataArray* const> arrays, std::vector<std::size_t>& counts)
{
  std::vector<Range> kept;
  std::size_t first = 0;
  for (std::size_t& count : counts)
  {
    const ink::ActiveCellComponents components = ink::findActiveCellComponents(cells.subspan(first, count));
    const std::vector<char> selected = ink::selectComponents(components.counts, selection);
    std::size_t left = 0;
    for (std::size_t i = 0; i < count; ++i)
    {
      if (!selected[components.labels[i]])
      {
        continue;
      }
      ++left;
      if (!kept.empty() && kept.back().end == first + i)
      {
        ++kept.back().end;
      }
      else
      {
        kept.push_back({ first + i, first + i + 1 });
      }
    }
    first += count;
    count = left;
  }
  for (vtkDataArray* array : arrays)
  {
    Compact(array, kept);
  }
}
