// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkSplatTargets_h
#define InkSplatTargets_h

#include "vtkNew.h"

class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;

/// The images that splats are drawn into: the visible surface (distance from the eye along the view, very
/// large where there is none, and slope) and the sums of the illumination splats (four numbers), in 32-bit
/// floats.
class InkSplatTargets
{
public:
  InkSplatTargets(vtkOpenGLRenderWindow* window, const int size[2]);
  ~InkSplatTargets();
  InkSplatTargets(const InkSplatTargets&) = delete;
  void operator=(const InkSplatTargets&) = delete;

  /// False when this OpenGL cannot draw into such images.
  bool IsComplete() const { return this->Complete; }

  /// Make one of the images the target of drawing.
  void BindSurface();
  void BindLight();

  vtkTextureObject* GetSurface() { return this->Surface; }
  vtkTextureObject* GetLight() { return this->Light; }

private:
  vtkOpenGLRenderWindow* Window; // outlives this: released with the window's resources
  vtkNew<vtkTextureObject> ZBuffer;
  vtkNew<vtkTextureObject> Surface;
  vtkNew<vtkTextureObject> Light;
  vtkNew<vtkOpenGLFramebufferObject> SurfaceFramebuffer;
  vtkNew<vtkOpenGLFramebufferObject> LightFramebuffer;
  bool Complete = false;
};

#endif
