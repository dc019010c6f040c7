// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkInkStippleActor
 * @brief an actor for vtkInkStippleMapper that draws without VTK's passes for translucent things
 *
 * Stipples are blended over what lies behind them, so a vtkActor draws them in the renderer's translucent
 * pass: by depth peeling, which draws them several times, or by the order-independent pass, which adds up in
 * floating point numbers and costs about as much again as the stipples. Dots of one ink look the same in any
 * order. So this actor blends them straight into the picture, after all surfaces, where nothing else in its
 * renderers is translucent, volumes included; else it does what vtkActor does, since what is translucent may
 * lie in front. In a chain of render passes (vtkRenderer::SetPass) it draws where vtkActor does if there is
 * no pass for volumes, and in any case once.
 *
 * A picture has 8 bits as a rule: dots too pale for them are drawn more rarely instead. Where each gray
 * matters more than the time of a frame, take vtkActor without depth peeling.
 */
#ifndef vtkInkStippleActor_h
#define vtkInkStippleActor_h

#include "vtkInkRenderingStippleModule.h" // for the export macro
#include "vtkOpenGLActor.h"

class vtkRenderPass;

class VTKINKRENDERINGSTIPPLE_EXPORT vtkInkStippleActor : public vtkOpenGLActor
{
public:
  static vtkInkStippleActor* New();
  vtkTypeMacro(vtkInkStippleActor, vtkOpenGLActor);

  vtkTypeBool HasTranslucentPolygonalGeometry() override;
  int RenderTranslucentPolygonalGeometry(vtkViewport* viewport) override;
  int RenderVolumetricGeometry(vtkViewport* viewport) override;

protected:
  vtkInkStippleActor();
  ~vtkInkStippleActor() override;

private:
  vtkInkStippleActor(const vtkInkStippleActor&) = delete;
  void operator=(const vtkInkStippleActor&) = delete;

  /// Whether there is nothing else translucent, and no volume, in any renderer with this actor.
  bool IsAlone();
  bool FindAlone();
  int Draw(vtkViewport* viewport);

  bool Drawing = false;
  vtkRenderPass* DrawnBy = nullptr; ///< this chain has drawn the actor in this picture; only compared
  bool Asking = false;
};

#endif
