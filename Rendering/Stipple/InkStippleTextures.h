// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkStippleTextures_h
#define InkStippleTextures_h

#include "Stippling/QuantizedPosition.h"

#include "vtkNew.h"

#include <cstdint>
#include <string>
#include <vector>

class InkStipplePoints;
class vtkOpenGLBufferObject;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;

/// What the shader looks up for each element, in texture buffers.
class InkStippleTextures
{
public:
  explicit InkStippleTextures(vtkOpenGLRenderWindow* window);
  ~InkStippleTextures();
  InkStippleTextures(const InkStippleTextures&) = delete;
  void operator=(const InkStippleTextures&) = delete;

  /// @param boxes of the elements, for packed stipples; empty for others
  /// @return why that cannot be done, for the user; empty if it can
  std::string Upload(const InkStipplePoints& points, const std::vector<ink::stipple::QuantizationBox>& boxes);

  /// @param colors RGBA of each element, in the points' order; empty: none
  void UploadColors(const std::vector<std::uint32_t>& colors);
  bool HasColors() const { return this->Colors.Filled; }

  void Activate(vtkShaderProgram* program);
  void Deactivate();

private:
  struct Buffer
  {
    vtkNew<vtkOpenGLBufferObject> Data;
    vtkNew<vtkTextureObject> Texture;
    bool Filled = false;
  };
  template <typename T>
  void Fill(
    Buffer& buffer, const std::vector<T>& values, int components, int type, unsigned int internalFormat);

  vtkOpenGLRenderWindow* Window;
  Buffer Shapes;
  Buffer Values;
  Buffer Ids;
  Buffer Boxes;
  Buffer Colors;
};

#endif
