// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkImageContourFinder_h
#define InkImageContourFinder_h

#include "InkContourFinder.h"
#include "InkImageContours.h"

#include <optional>
#include <span>
#include <vector>

class vtkDataArray;
class vtkImageData;

/// Contours of an image's iso-surfaces, straight from its samples (InkImageContours). Discs around a sample
/// in each active cell hide them, so that no surface is made.
class InkImageContourFinder : public InkContourFinder
{
public:
  struct Options
  {
    std::vector<double> IsoValues;
    int Component = 0;
    bool Silhouettes = true;
    bool Borders = true; ///< where surfaces leave the image, or samples are missing
    bool operator==(const Options& other) const;
  };

  /// Does nothing where it is ready for these.
  /// @param scalars of the image's points
  /// @return whether anything was made
  /// @throws std::invalid_argument as InkImageContours
  bool Update(vtkImageData* image, vtkDataArray* scalars, const Options& options);

  Found Find(const ink::Eye& eye) const override;
  /// The discs, made when they are first asked for; not before Update.
  vtkPolyData* GetSurface();
  /// How far behind the discs contours lie at most, in world units.
  double GetDepthTolerance() const;

private:
  vtkSmartPointer<vtkImageData> Image;
  vtkDataArray* Scalars = nullptr; ///< only compared
  vtkMTimeType ImageTime = 0;
  Options Wanted;
  InkImageContours Surfaces;
  ink::Contours Borders;
  std::vector<int> BorderSurfaces; ///< iso-value of each
  vtkSmartPointer<vtkPolyData> Discs;
};

#endif
