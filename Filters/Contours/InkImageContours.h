// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkImageContours_h
#define InkImageContours_h

#include "Curves/Contours/GridContours.h"
#include "IsoSurface/MinMaxBricks.h"

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <span>
#include <vector>

class vtkImageData;

/// The contours of an image's iso-surfaces for any eye. What does not depend on the eye is kept: of the
/// image, and of each iso-value.
class InkImageContours
{
public:
  struct Input
  {
    vtkImageData* Image = nullptr;   ///< later only compared
    vtkDataArray* Scalars = nullptr; ///< of its points
    int Component = 0;
    ink::CellSelection Cells;
  };

  /// Makes what is not there of an input. Iso-values that are not numbers have no contours.
  /// @param progress when it asks to stop, contours may be missing, and what there is is not to be kept
  /// @return how many iso-values' index was made
  /// @throws std::invalid_argument as InkMakeGrid
  int Update(const Input& input, std::span<const double> isoValues, const ink::Progress& progress);
  void Clear();

  /// Those of all iso-values, one after the other.
  /// @param surfaces of each chain the index of its iso-value
  ink::Contours Find(const ink::Eye& eye, const ink::ContourArrays& arrays,
    const ink::GridContourOptions& options, std::vector<int>& surfaces) const;

private:
  using Finder =
    std::function<ink::Contours(const ink::Eye&, const ink::ContourArrays&, const ink::GridContourOptions&)>;
  struct Surface
  {
    double IsoValue;
    Finder Find;
  };

  bool IsOf(const Input& input) const;

  Input Source;
  vtkMTimeType SourceTime = 0;
  vtkSmartPointer<vtkDataArray> Values; ///< contiguous
  int ComponentToRead = 0;              ///< of these
  vtkSmartPointer<vtkDataArray> Ghosts; ///< of points, which Surfaces read
  ink::MinMaxBricks Ranges;
  std::vector<Surface> Surfaces;
};

#endif
