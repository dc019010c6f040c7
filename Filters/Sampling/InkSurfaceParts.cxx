// SPDX-License-Identifier: BSD-3-Clause
#include "InkSurfaceParts.h"

#include "Core/ParallelSort.h"

#include "vtkDataArray.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace
{

/// Points that stay: from `begin` up to but excluding `end`.
struct Range
{
  std::size_t begin;
  std::size_t end;
};

std::vector<ink::ActiveCellId> SortedOnce(std::span<const ink::ActiveCellId> cells)
{
  std::vector<ink::ActiveCellId> sorted(cells.begin(), cells.end());
  if (!std::is_sorted(sorted.begin(), sorted.end()))
  {
    ink::parallelSort(sorted.begin(), sorted.end());
  }
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  return sorted;
}

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
    const auto own = cells.subspan(first, count);
    const std::vector<ink::ActiveCellId> sorted = SortedOnce(own);
    const ink::ActiveCellComponents components = ink::findActiveCellComponents(sorted);
    const std::vector<char> selected = ink::selectComponents(components.counts, selection);
    std::size_t left = 0;
    auto cell = sorted.begin();
    for (std::size_t i = 0; i < count; ++i)
    {
      // Mostly the next one.
      cell = cell != sorted.end() && *cell == own[i] ? cell
                                                     : std::lower_bound(sorted.begin(), sorted.end(), own[i]);
      const std::uint32_t label = components.labels[static_cast<std::size_t>(cell - sorted.begin())];
      ++cell;
      if (!selected[label])
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
