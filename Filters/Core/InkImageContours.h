// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkImageContours_h
#define InkImageContours_h

#include "Curves/Contours/GridContours.h"
#include "IsoSurface/MinMaxBricks.h"

#include "vtkDataArray.h"
#include "vtkInkFiltersCoreModule.h" // for the export macro
#include "vtkSmartPointer.h"

#include <memory>
#include <span>
#include <vector>

class vtkImageData;
class vtkPolyData;

/// The contours of an image's iso-surfaces for any eye. What does not depend on the eye is kept: of the
/// image, and of each iso-value.
class VTKINKFILTERSCORE_EXPORT InkImageContours
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

  /// The silhouettes of all iso-values, one after the other.
  /// @param surfaces of each chain the index of its iso-value
  ink::Contours Find(const ink::Eye& eye, const ink::ContourArrays& arrays,
    const ink::GridContourOptions& options, std::vector<int>& surfaces) const;

  /// Where the surfaces end (ink::gridBorder), for any eye.
  /// @param surfaces as Find has it
  ink::Contours FindBorders(const ink::ContourArrays& arrays, std::vector<int>& surfaces) const;

  /// The surfaces as points with `Normals` and `Radius` (ink::sampleIsoSurfaces): discs that cover them, and
  /// reach no farther beyond them than their radius.
  vtkSmartPointer<vtkPolyData> MakeDiscs() const;

  /// Adds the cell array `SurfaceIndex` to lines, where there are several iso-values.
  void AddSurfaceIndex(std::span<const int> surfaces, vtkPolyData* lines) const;

private:
  class Surface;
  struct Kept
  {
    double IsoValue;
    std::shared_ptr<const Surface> Own; ///< null where the value is not a number
  };

  bool IsOf(const Input& input) const;
  template <class OfSurface>
  ink::Contours Collect(
    const ink::ContourArrays& arrays, std::vector<int>& surfaces, const OfSurface& ofSurface) const;

  Input Source;
  vtkMTimeType SourceTime = 0;
  vtkSmartPointer<vtkDataArray> Values; ///< contiguous
  int ComponentToRead = 0;              ///< of these
  vtkSmartPointer<vtkDataArray> Ghosts; ///< of points, which Surfaces read
  vtkSmartPointer<vtkDataArray> CellGhosts;
  double DiscRadius = 0.0; ///< world units
  ink::MinMaxBricks Ranges;
  std::vector<Kept> Surfaces;
};

#endif
