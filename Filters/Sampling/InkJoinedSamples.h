// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkJoinedSamples_h
#define InkJoinedSamples_h

#include "InkMemoryBudget.h"

#include "IsoSurface/ActiveCellComponents.h"

#include "vtkSmartPointer.h"

#include <cstddef>
#include <cstdint>
#include <vector>

class vtkPolyData;

/// Puts the points of surfaces together that come in parts.
class InkJoinedSamples
{
public:
  explicit InkJoinedSamples(const InkMemoryBudget& budget);

  /// @param points with the same arrays each time
  /// @throws std::runtime_error if there are more of them than memory has room for
  void Add(int surface, vtkPolyData* points);

  /// What points are to have besides their arrays.
  struct Contents
  {
    bool CellIds; ///< which they have then
    bool SurfaceIndex;
    bool Vertices;
  };
  /// Fills a data object with all points, those of one surface after the other.
  /// @param selection the parts of surfaces that stay; unless all do, points have the array `CellId`
  void Fill(vtkPolyData* output, const ink::ComponentSelection& selection, const Contents& contents) const;

private:
  void FillAll(vtkPolyData* output) const;

  const InkMemoryBudget Budget;
  std::uint64_t Total = 0;
  std::vector<std::size_t> Counts;                              ///< of each surface
  std::vector<std::vector<vtkSmartPointer<vtkPolyData>>> Parts; ///< of each surface
};

#endif
