// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkIllustrationMapper
 * @brief   splatting lines, and stipples over them, as one
 *
 * Draws what two mappers draw, one after the other, for one actor: lines on paper, which hides what lies
 * behind it, then stipples. Clipping planes and colors of scalars are handed on to both. Ids of hardware
 * selection are those of the lines' points.
 *
 * Two more mappers may draw an outer surface, faint and without paper, so that the inner one is seen through
 * it: with lines and stipples like the inner ones, but only at its rim, where it turns away from the viewer.
 * It is translucent, and drawn with what else is.
 *
 * @sa vtkInkIllustrationStyle vtkInkSplattingLinesMapper vtkInkStippleMapper
 */
#ifndef vtkInkIllustrationMapper_h
#define vtkInkIllustrationMapper_h

#include "InkSetters.h"
#include "vtkInkStylesModule.h" // for the export macro
#include "vtkNew.h"             // for the actor
#include "vtkPolyDataMapper.h"
#include "vtkSmartPointer.h" // for the mappers

class vtkActor;
class vtkInkSplattingLinesMapper;
class vtkInkStippleMapper;

class VTKINKSTYLES_EXPORT vtkInkIllustrationMapper : public vtkPolyDataMapper
{
public:
  static vtkInkIllustrationMapper* New();
  vtkTypeMacro(vtkInkIllustrationMapper, vtkPolyDataMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The mappers of the two, whose inputs are what is drawn.
  void SetMappers(vtkInkSplattingLinesMapper* lines, vtkInkStippleMapper* stipples);

  /// Those of a surface around it; without inputs they draw nothing. Their properties follow the above.
  void SetOuterMappers(vtkInkSplattingLinesMapper* lines, vtkInkStippleMapper* stipples);

  ///@{
  /// The ink of the outer surface. Default: black.
  InkSetColorMacro(OuterInkColor);
  vtkGetVector3Macro(OuterInkColor, double);
  ///@}

  ///@{
  /// How opaque that ink is, 0 to 1: the surface is fainter with a smaller one. Default: 0.45.
  InkSetClampMacro(OuterStrength, 0.0, 1.0);
  vtkGetMacro(OuterStrength, double);
  ///@}

  void RenderPiece(vtkRenderer* renderer, vtkActor* actor) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  double* GetBounds() override;
  using vtkPolyDataMapper::GetBounds;
  bool HasOpaqueGeometry() override;
  bool HasTranslucentPolygonalGeometry() override;
  bool GetSupportsSelection() override { return true; }
  /// Includes the mappers.
  vtkMTimeType GetMTime() override;

protected:
  vtkInkIllustrationMapper();
  ~vtkInkIllustrationMapper() override;

private:
  vtkInkIllustrationMapper(const vtkInkIllustrationMapper&) = delete;
  void operator=(const vtkInkIllustrationMapper&) = delete;

  void RenderInner(vtkRenderer* renderer, vtkActor* actor);
  void RenderOuter(vtkRenderer* renderer, vtkActor* actor);
  void UpdateOuter(vtkActor* actor);
  bool HasOuter();

  vtkSmartPointer<vtkInkSplattingLinesMapper> Lines;
  vtkSmartPointer<vtkInkStippleMapper> Stipples;
  vtkSmartPointer<vtkInkSplattingLinesMapper> OuterLines;
  vtkSmartPointer<vtkInkStippleMapper> OuterStipples;
  vtkNew<vtkActor> OuterActor; ///< as the actor, but fainter
  double OuterInkColor[3] = { 0.0, 0.0, 0.0 };
  double OuterStrength = 0.45;
};

#endif
