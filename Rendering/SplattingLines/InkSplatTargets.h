// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkSplatTargets_h
#define InkSplatTargets_h

#include "vtkNew.h"

class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;

/// The images that splats are drawn into: depth (32-bit float, fraction of the view's depth range, 1 where
/// there is no surface) and the sums of the illumination splats (RGBA, 32-bit float).
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
  void BindDepth();
  void BindLight();

  vtkTextureObject* GetDepth() { return this->Depth; }
  vtkTextureObject* GetLight() { return this->Light; }

private:
  vtkOpenGLRenderWindow* Window; // outlives this: released with the window's resources
  vtkNew<vtkTextureObject> Depth;
  vtkNew<vtkTextureObject> Light;
  vtkNew<vtkOpenGLFramebufferObject> DepthFramebuffer;
  vtkNew<vtkOpenGLFramebufferObject> LightFramebuffer;
  bool Complete = false;
};

#endif
