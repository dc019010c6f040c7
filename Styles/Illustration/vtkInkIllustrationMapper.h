// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkIllustrationMapper
 * @brief   splatting lines, and stipples over them, as one
 *
 * Draws what two mappers draw, one after the other, for one actor: lines on paper, which hides what lies
 * behind it, then stipples. Clipping planes and coloring by scalars are handed on to both. Ids of hardware
 * selection are those of the lines' points.
 *
 * @sa vtkInkIllustrationStyle vtkInkSplattingLinesMapper vtkInkStippleMapper
 */
#ifndef vtkInkIllustrationMapper_h
#define vtkInkIllustrationMapper_h

#include "vtkInkStylesModule.h" // for the export macro
#include "vtkPolyDataMapper.h"
#include "vtkSmartPointer.h" // for the mappers

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

  vtkSmartPointer<vtkInkSplattingLinesMapper> Lines;
  vtkSmartPointer<vtkInkStippleMapper> Stipples;
};

#endif
