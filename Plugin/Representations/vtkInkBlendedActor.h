// SPDX-License-Identifier: BSD-3-Clause
/**
 * An actor whose marks look the same blended in any order, as dots of one ink do. It draws them once, after
 * all surfaces, where depth peeling would draw them several times; unless there is something else translucent
 * in the renderer, which may lie in front of them.
 */
#ifndef vtkInkBlendedActor_h
#define vtkInkBlendedActor_h

#include "vtkOpenGLActor.h"
#include "vtkWeakPointer.h"

class vtkRenderer;

class vtkInkBlendedActor : public vtkOpenGLActor
{
public:
  static vtkInkBlendedActor* New();
  vtkTypeMacro(vtkInkBlendedActor, vtkOpenGLActor);

  /// What else is to be drawn.
  void SetRenderer(vtkRenderer* renderer);

  vtkTypeBool HasTranslucentPolygonalGeometry() override;
  int RenderVolumetricGeometry(vtkViewport* viewport) override;

protected:
  vtkInkBlendedActor();
  ~vtkInkBlendedActor() override;

private:
  vtkInkBlendedActor(const vtkInkBlendedActor&) = delete;
  void operator=(const vtkInkBlendedActor&) = delete;

  bool IsBesideOthers();

  vtkWeakPointer<vtkRenderer> Renderer;
  bool Drawing = false;
};

#endif
