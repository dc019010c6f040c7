// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkSilhouettes_h
#define InkSilhouettes_h

#include "vtkInkStylesModule.h" // for the export macro

#include "vtkNew.h"
#include "vtkTimeStamp.h"

class vtkInkMapper;
class vtkInkSilhouetteMapper;
class vtkPolyData;

/// Silhouettes of the surface that a style draws otherwise, as strokes over its marks: an option of styles
/// that are no contours. Strokes have the marks' ink and are seen where these are, by the same actor.
class VTKINKSTYLES_EXPORT InkSilhouettes
{
public:
  /// @param under the mapper of the marks
  explicit InkSilhouettes(vtkInkMapper* under);
  ~InkSilhouettes();
  InkSilhouettes(const InkSilhouettes&) = delete;
  void operator=(const InkSilhouettes&) = delete;

  ///@{
  /// Whether there are any. Default: off.
  void SetSilhouettes(bool silhouettes);
  bool GetSilhouettes() const { return this->Wanted; }
  ///@}

  ///@{
  /// Whether creases are drawn, too, but not those of an image's surface. Default: off.
  void SetCreases(bool creases);
  bool GetCreases() const { return this->Creases; }
  ///@}

  /// What draws them; properties that are parameters are set as such.
  vtkInkSilhouetteMapper* GetMapper();

  void SetInkColor(const double color[3]);
  /// As the style's.
  void SetPixelScale(double scale);

  /// Shows those of a surface, see InkContourSurface; null or empty: of none.
  void Show(vtkPolyData* surface);

  /// When it changed last whether a surface is needed.
  vtkMTimeType GetMTime() const { return this->Changed.GetMTime(); }

private:
  vtkNew<vtkInkSilhouetteMapper> Mapper;
  bool Wanted = false;
  bool Creases = false;
  vtkTimeStamp Changed;
};

#endif
