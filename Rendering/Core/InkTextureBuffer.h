// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkTextureBuffer_h
#define InkTextureBuffer_h

#include "vtkInkRenderingCoreModule.h" // for the export macro

#include "vtkNew.h"
#include "vtkOpenGLBufferObject.h"

#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;

/// Numbers that a shader looks up by their index, in a texture buffer of one window.
class VTKINKRENDERINGCORE_EXPORT InkTextureBuffer
{
public:
  explicit InkTextureBuffer(vtkOpenGLRenderWindow* window);
  ~InkTextureBuffer();
  InkTextureBuffer(const InkTextureBuffer&) = delete;
  void operator=(const InkTextureBuffer&) = delete;

  /// How many texels the current OpenGL looks up at most.
  static int FindMostTexels(vtkOpenGLRenderWindow* window);

  /// @param type VTK's, of a component
  /// @param internalFormat OpenGL's, of a texel
  template <typename T>
  void Fill(const std::vector<T>& texels, int components, int type, unsigned int internalFormat)
  {
    this->Clear();
    if (!texels.empty())
    {
      this->Data->Upload(texels, vtkOpenGLBufferObject::TextureBuffer);
      this->Create(static_cast<unsigned int>(texels.size()), components, type, internalFormat);
    }
  }
  bool IsFilled() const { return this->Filled; }

  /// Binds it to a texture unit for a sampler, up to Deactivate, which does nothing without.
  void Activate(vtkShaderProgram* program, const char* sampler);
  void Deactivate();

private:
  void Clear();
  void Create(unsigned int texels, int components, int type, unsigned int internalFormat);

  vtkOpenGLRenderWindow* Window;
  vtkNew<vtkOpenGLBufferObject> Data;
  vtkNew<vtkTextureObject> Texture;
  bool Filled = false;
  bool Active = false;
};

#endif
