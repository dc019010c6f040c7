// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkSilhouetteMapper
 * @brief   draws the outlines of a surface as strokes of a pen
 *
 * Input: a surface of polygons and strips, with point normals or without (then they are computed, which a
 * warning says). Its contours are found again when the camera, the surface or an option changed, at a cost
 * that follows their length and not the size of the surface (Hertzmann and Zorin 2000), and drawn as
 * vtkInkStrokeMapper draws strokes, with all its parameters. The surface hides what lies behind it, whether
 * or not an actor shows it; SetSurfaceConnection and SetSurfaceData give another surface to do that.
 *
 * An edge that is a crease and a silhouette is drawn once, as a crease.
 *
 * Hardware selection finds points of the surface beside a contour. With ScalarVisibility on, the cell array
 * `ContourKind` (0 silhouette, 1 crease, 2 border, 3 non-manifold edge) can color the strokes.
 *
 * @sa vtkInkStrokeMapper
 */
#ifndef vtkInkSilhouetteMapper_h
#define vtkInkSilhouetteMapper_h

#include "vtkInkRenderingStrokesModule.h" // for the export macro
#include "vtkInkStrokeMapper.h"

#include <memory> // for std::unique_ptr

class VTKINKRENDERINGSTROKES_EXPORT vtkInkSilhouetteMapper : public vtkInkStrokeMapper
{
public:
  static vtkInkSilhouetteMapper* New();
  vtkTypeMacro(vtkInkSilhouetteMapper, vtkInkStrokeMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// All parameters and both inputs of another mapper, as far as it has them.
  void ShallowCopy(vtkAbstractMapper* mapper) override;

  ///@{
  /**
   * Whether silhouettes are drawn: where the surface turns away from the eye. Default: on.
   */
  vtkSetMacro(Silhouettes, bool);
  vtkGetMacro(Silhouettes, bool);
  vtkBooleanMacro(Silhouettes, bool);
  ///@}

  ///@{
  /**
   * Whether silhouettes are edges between polygons that face the eye and those that do not, in place of
   * smooth curves by the normals at the points. Default: off.
   */
  vtkSetMacro(Faceted, bool);
  vtkGetMacro(Faceted, bool);
  vtkBooleanMacro(Faceted, bool);
  ///@}

  ///@{
  /**
   * Whether creases are drawn: edges between polygons at an angle of FeatureAngle or more. Default: off.
   */
  vtkSetMacro(Creases, bool);
  vtkGetMacro(Creases, bool);
  vtkBooleanMacro(Creases, bool);
  ///@}

  ///@{
  /**
   * The least angle between the normals of the polygons at a crease, in degrees; fewer creases with a larger
   * one. 0 to 180; default: 30.
   */
  InkSetClampMacro(FeatureAngle, 0.0, 180.0);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  ///@{
  /**
   * Creases that end within the surface, and with all creases and borders that they join are no longer than
   * this share of its diagonal, are left out: specks, as the noise of scans makes them. Edges of a machine
   * part, however short, end at others and stay. 0 (default: none is left out) to 1. NaN is refused with a
   * warning.
   */
  InkSetClampMacro(ShortestCrease, 0.0, 1.0);
  vtkGetMacro(ShortestCrease, double);
  ///@}

  ///@{
  /**
   * Whether borders are drawn: edges of one polygon only. Default: on.
   */
  vtkSetMacro(Borders, bool);
  vtkGetMacro(Borders, bool);
  vtkBooleanMacro(Borders, bool);
  ///@}

  ///@{
  /**
   * Whether edges of more than two polygons are drawn. Default: off.
   */
  vtkSetMacro(NonManifoldEdges, bool);
  vtkGetMacro(NonManifoldEdges, bool);
  vtkBooleanMacro(NonManifoldEdges, bool);
  ///@}

  ///@{
  /**
   * Whether dashes of silhouettes stay as near as they can to where they were in the picture before, for
   * motion. Off (default), they begin where the line does, which travels over the surface with the eye; on, a
   * picture depends on those before it.
   */
  vtkSetMacro(CoherentDashes, bool);
  vtkGetMacro(CoherentDashes, bool);
  vtkBooleanMacro(CoherentDashes, bool);
  ///@}

  /**
   * The contours that an actor in a renderer showed last: lines with the point arrays `Normals`,
   * `RadialCurvature` and `ArcLength` and the cell array `ContourKind`; null before the first picture. Its
   * modification time tells when they were found.
   */
  vtkPolyData* GetContours(vtkRenderer* renderer, vtkActor* actor);

protected:
  vtkInkSilhouetteMapper();
  ~vtkInkSilhouetteMapper() override;

  bool UpdateMarks(InkMarks& own) override;
  void DrawMarks(InkMarks& own, const InkFrame& frame) override;
  vtkPolyData* FindSurface() override;

private:
  vtkInkSilhouetteMapper(const vtkInkSilhouetteMapper&) = delete;
  void operator=(const vtkInkSilhouetteMapper&) = delete;

  bool UpdateSurface();

  bool Silhouettes = true;
  bool Faceted = false;
  bool Creases = false;
  double FeatureAngle = 30.0;
  double ShortestCrease = 0.0;
  bool Borders = true;
  bool NonManifoldEdges = false;
  bool CoherentDashes = false;

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
