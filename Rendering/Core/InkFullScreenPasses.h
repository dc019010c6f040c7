// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkFullScreenPasses_h
#define InkFullScreenPasses_h

#include "vtkInkRenderingCoreModule.h" // for the export macro

#include <map>
#include <memory>
#include <string>

class InkRenderPasses;
class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;

/// Passes over whole images: a quad that fills the viewport, whose fragment shader finds its position in
/// `texCoord`. For one window.
class VTKINKRENDERINGCORE_EXPORT InkFullScreenPasses
{
public:
  explicit InkFullScreenPasses(vtkOpenGLRenderWindow* window);
  ~InkFullScreenPasses();
  InkFullScreenPasses(const InkFullScreenPasses&) = delete;
  void operator=(const InkFullScreenPasses&) = delete;

  vtkOpenGLRenderWindow* GetWindow() const { return this->Window; }

  /// Makes the program of a fragment shader ready for uniforms and Draw; null if it cannot be compiled.
  /// @param renderPasses that may change the shader, and then set its parameters; or null
  vtkShaderProgram* Begin(std::string fragmentShader, const InkRenderPasses* renderPasses = nullptr);

  /// Draws the quad with the program of the last Begin.
  void Draw();

private:
  vtkOpenGLRenderWindow* Window;
  std::map<std::string, std::unique_ptr<vtkOpenGLQuadHelper>> Quads; ///< by their shaders
  vtkOpenGLQuadHelper* Current = nullptr;
};

#endif
