// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkStippleEnhancements
 * @brief   the enhancements of Lu et al. 2003, Table 1, as properties of a mapper
 *
 * Factors of the number of stipples that an element gets, and what belongs to them: for boundaries,
 * silhouettes, resolution, light, distance and interior, with the paper's k's.
 *
 * @sa vtkInkStippleMapper
 */
#ifndef vtkInkStippleEnhancements_h
#define vtkInkStippleEnhancements_h

#include "InkSetters.h"                   // for the setters
#include "vtkInkMapper.h"                 // for the base
#include "vtkInkRenderingStippleModule.h" // for the export macro

class VTKINKRENDERINGSTIPPLE_EXPORT vtkInkStippleEnhancements : public vtkInkMapper
{
public:
  vtkTypeMacro(vtkInkStippleEnhancements, vtkInkMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// All enhancements of another mapper, as far as it has them.
  void ShallowCopy(vtkAbstractMapper* mapper) override;

  ///@{
  /**
   * Whether boundaries get more stipples; volumes only. Default: on.
   */
  vtkSetMacro(Boundary, bool);
  vtkGetMacro(Boundary, bool);
  vtkBooleanMacro(Boundary, bool);
  ///@}

  ///@{
  /**
   * k_gc: what every voxel gets, whatever its gradient; more stipples with a larger one. 0 to 10; default:
   * 0.2.
   */
  InkSetClampMacro(BoundaryBase, 0.0, 10.0);
  vtkGetMacro(BoundaryBase, double);
  ///@}

  ///@{
  /**
   * k_gs: what the gradient's magnitude adds; more stipples on boundaries with a larger one. 0 to 10;
   * default: 1.
   */
  InkSetClampMacro(BoundaryGain, 0.0, 10.0);
  vtkGetMacro(BoundaryGain, double);
  ///@}

  ///@{
  /**
   * k_ge: sharpness; with a larger one only the largest gradients get stipples. 0 to 20; default: 1.
   */
  InkSetClampMacro(BoundaryExponent, 0.0, 20.0);
  vtkGetMacro(BoundaryExponent, double);
  ///@}

  ///@{
  /**
   * Whether silhouettes get more stipples; volumes only. Default: on.
   */
  vtkSetMacro(Silhouette, bool);
  vtkGetMacro(Silhouette, bool);
  vtkBooleanMacro(Silhouette, bool);
  ///@}

  ///@{
  /**
   * k_sc: what every voxel gets, whatever its orientation. 0 to 10; default: 0.3.
   */
  InkSetClampMacro(SilhouetteBase, 0.0, 10.0);
  vtkGetMacro(SilhouetteBase, double);
  ///@}

  ///@{
  /**
   * k_ss: what silhouettes get in addition. 0 to 10; default: 2.
   */
  InkSetClampMacro(SilhouetteGain, 0.0, 10.0);
  vtkGetMacro(SilhouetteGain, double);
  ///@}

  ///@{
  /**
   * k_se: sharpness; silhouettes are thinner with a smaller one. 0.01 to 20; default: 0.5.
   */
  InkSetClampMacro(SilhouetteExponent, 0.01, 20.0);
  vtkGetMacro(SilhouetteExponent, double);
  ///@}

  ///@{
  /**
   * Whether far and slanted elements get fewer stipples, so that the pattern is as dense as elsewhere.
   * Default: on.
   */
  vtkSetMacro(Resolution, bool);
  vtkGetMacro(Resolution, bool);
  vtkBooleanMacro(Resolution, bool);
  ///@}

  ///@{
  /**
   * k_rc: exponent of the distance; the pattern is even with -2, denser far away with a larger one. -8 to 0;
   * default: -2.
   */
  InkSetClampMacro(ResolutionExponent, -8.0, 0.0);
  vtkGetMacro(ResolutionExponent, double);
  ///@}

  ///@{
  /**
   * k_nz: exponent of the slant; the pattern is even with 1, denser where seen edge-on with a smaller one.
   * 0 to 8; default: 1.
   */
  InkSetClampMacro(SlantExponent, 0.0, 8.0);
  vtkGetMacro(SlantExponent, double);
  ///@}

  ///@{
  /**
   * Whether light takes stipples away; where it does not fall, all stay. Of volumes only elements within
   * FacingAngle of the eye are drawn then. Default: on.
   */
  vtkSetMacro(Lighting, bool);
  vtkGetMacro(Lighting, bool);
  vtkBooleanMacro(Lighting, bool);
  ///@}

  ///@{
  /**
   * k_le: exponent of the light; more is lit with a smaller one. 0.01 to 20; default: 1.
   */
  InkSetClampMacro(LightingExponent, 0.01, 20.0);
  vtkGetMacro(LightingExponent, double);
  ///@}

  ///@{
  /**
   * The largest angle between a voxel's normal and the eye at which lit volumes are drawn, in degrees. 0 to
   * 180 (all); default: 90.
   */
  InkSetClampMacro(FacingAngle, 0.0, 180.0);
  vtkGetMacro(FacingAngle, double);
  ///@}

  ///@{
  /**
   * Light from the camera in place of the renderer's lights (of which the first eight that are on count,
   * with their cones and attenuation). Default: off.
   */
  vtkSetMacro(Headlight, bool);
  vtkGetMacro(Headlight, bool);
  vtkBooleanMacro(Headlight, bool);
  ///@}

  ///@{
  /**
   * The ink is lighter than the paper: stipples show light instead of shade. Default: off.
   */
  vtkSetMacro(LightInk, bool);
  vtkGetMacro(LightInk, bool);
  vtkBooleanMacro(LightInk, bool);
  ///@}

  ///@{
  /**
   * Whether what is in front gets more and larger stipples. Default: on.
   */
  vtkSetMacro(Distance, bool);
  vtkGetMacro(Distance, bool);
  vtkBooleanMacro(Distance, bool);
  ///@}

  ///@{
  /**
   * k_de: with a larger one only the nearest and the farthest parts differ. 0.01 to 20; default: 1.
   */
  InkSetClampMacro(DistanceExponent, 0.01, 20.0);
  vtkGetMacro(DistanceExponent, double);
  ///@}

  ///@{
  /**
   * How far the diameter follows the distance: 0 not at all, 1 as the number does. Default: 0.5.
   */
  InkSetClampMacro(DistanceSize, 0.0, 1.0);
  vtkGetMacro(DistanceSize, double);
  ///@}

  ///@{
  /**
   * Whether elements with a small gradient get fewer and smaller stipples, so that what lies within shows
   * through; volumes only. Default: on.
   */
  vtkSetMacro(Interior, bool);
  vtkGetMacro(Interior, bool);
  vtkBooleanMacro(Interior, bool);
  ///@}

  ///@{
  /**
   * k_ie: more is see-through with a larger one. 0 to 20; default: 1.
   */
  InkSetClampMacro(InteriorExponent, 0.0, 20.0);
  vtkGetMacro(InteriorExponent, double);
  ///@}

  ///@{
  /**
   * How far the diameter follows the interior enhancement: 0 not at all, 1 as the number does. Default: 0.5.
   */
  InkSetClampMacro(InteriorSize, 0.0, 1.0);
  vtkGetMacro(InteriorSize, double);
  ///@}

  ///@{
  /**
   * How much a voxel's value counts beside its gradient, for boundaries and silhouettes: v counts as
   * v^ValueEffect. 0 (not at all) to 1 (default: as in Table 1); parts with small values are darker with a
   * smaller one.
   */
  InkSetClampMacro(ValueEffect, 0.0, 1.0);
  vtkGetMacro(ValueEffect, double);
  ///@}

protected:
  vtkInkStippleEnhancements() = default;
  ~vtkInkStippleEnhancements() override = default;

private:
  vtkInkStippleEnhancements(const vtkInkStippleEnhancements&) = delete;
  void operator=(const vtkInkStippleEnhancements&) = delete;

  bool Boundary = true;
  double BoundaryBase = 0.2;
  double BoundaryGain = 1.0;
  double BoundaryExponent = 1.0;
  bool Silhouette = true;
  double SilhouetteBase = 0.3;
  double SilhouetteGain = 2.0;
  double SilhouetteExponent = 0.5;
  bool Resolution = true;
  double ResolutionExponent = -2.0;
  double SlantExponent = 1.0;
  bool Lighting = true;
  double LightingExponent = 1.0;
  double FacingAngle = 90.0;
  bool Headlight = false;
  bool LightInk = false;
  bool Distance = true;
  double DistanceExponent = 1.0;
  double DistanceSize = 0.5;
  bool Interior = true;
  double InteriorExponent = 1.0;
  double InteriorSize = 0.5;
  double ValueEffect = 1.0;
};

#endif
