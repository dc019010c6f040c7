// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkStrokeTexture_h
#define InkStrokeTexture_h

#include "vtkNew.h"
#include "vtkTextureObject.h"
#include "vtkType.h"

#include <string>

class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;

/// The image that strokes are drawn with, on the GPU of one window.
class InkStrokeTexture
{
public:
  explicit InkStrokeTexture(vtkOpenGLRenderWindow* window);
  ~InkStrokeTexture();
  InkStrokeTexture(const InkStrokeTexture&) = delete;
  void operator=(const InkStrokeTexture&) = delete;

  /// Takes an image, or none where it is null or not as expected. Does nothing when it is the one that it
  /// has.
  /// @return what is wrong with it, for the user; empty if nothing is
  std::string Update(vtkImageData* image);

  bool IsFilled() const { return this->Components > 0; }
  /// Whether it has colors, not only shares of ink.
  bool HasColors() const { return this->Components == 4; }

  void Activate(vtkShaderProgram* program, const char* sampler);
  void Deactivate();

private:
  vtkOpenGLRenderWindow* Window;
  vtkNew<vtkTextureObject> Texture;
  int Components = 0; ///< 0: none
  vtkMTimeType ImageTime = 0;
  bool Active = false;
};

#endif
