// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkSilhouettes_h
#define InkSilhouettes_h

#include "InkSilhouetteMethod.h"
#include "vtkInkStylesModule.h" // for the export macro

#include "vtkNew.h"
#include "vtkTimeStamp.h"

#include <span>
#include <string>

class InkIsoSurface;
class vtkImageData;
class vtkInkMapper;
class vtkInkSilhouetteMapper;
class vtkInkStyle;
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

  ///@{
  /// Whether the sharp edges and the borders of meshes are drawn even if nothing else is: where the normals
  /// of the two sides differ (InkWithFeatureNormals), and where there is one side only. Default: off.
  void SetSharpEdges(bool edges);
  bool GetSharpEdges() const { return this->SharpEdges; }
  ///@}

  /// What draws them; properties that are parameters are set as such.
  vtkInkSilhouetteMapper* GetMapper();

  void SetInkColor(const double color[3]);
  /// As the style's.
  void SetPixelScale(double scale);

  /// How they are found; what is a parameter is set as such.
  InkSilhouetteMethod* GetMethod();

  ///@{
  /**
   * Makes what they are of, if there are any: a surface as InkContourSurface does, or edge voxels of images
   * as InkSilhouetteMethod does; all processes call it at once.
   * @param isoSurface of what is drawn; after Prepare
   * @param piece becomes it
   * @return what is wrong; empty if nothing is
   */
  std::string MakeOfImages(
    vtkInkStyle* style, InkIsoSurface& isoSurface, std::span<vtkImageData* const> images, vtkPolyData* piece);
  std::string MakeOfMesh(vtkInkStyle* style, vtkPolyData* mesh, vtkPolyData* piece);
  ///@}

  /// Shows those of a piece; null or empty: none.
  /// @param hiding a surface that hides segments through voxels; null: nothing does
  void Show(vtkPolyData* piece, vtkPolyData* hiding);

  /// When it changed last which piece is needed.
  vtkMTimeType GetMTime() const;

private:
  /// Makes the mapper draw the kinds of lines that are wanted.
  void FollowKinds();

  vtkNew<vtkInkSilhouetteMapper> Mapper;
  InkSilhouetteMethod Method;
  bool Wanted = false;
  bool Creases = false;
  bool SharpEdges = false;
  vtkTimeStamp Changed;
};

#endif
