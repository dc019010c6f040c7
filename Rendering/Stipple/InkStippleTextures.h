// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkStippleTextures_h
#define InkStippleTextures_h

#include "InkTextureBuffer.h"

#include "Stippling/QuantizedPosition.h"

#include <cstdint>
#include <string>
#include <vector>

class InkStipplePoints;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;

/// What the shader looks up for each element, in texture buffers.
class InkStippleTextures
{
public:
  explicit InkStippleTextures(vtkOpenGLRenderWindow* window);

  /// @param boxes of the elements, for packed stipples; empty for others
  /// @return why that cannot be done, for the user; empty if it can
  std::string Upload(const InkStipplePoints& points, const std::vector<ink::stipple::QuantizationBox>& boxes);

  /// @param colors RGBA of each element, in the points' order; empty: none
  void UploadColors(const std::vector<std::uint32_t>& colors);
  bool HasColors() const { return this->Colors.IsFilled(); }

  void Activate(vtkShaderProgram* program);
  void Deactivate();

private:
  vtkOpenGLRenderWindow* Window;
  InkTextureBuffer Shapes;
  InkTextureBuffer Values;
  InkTextureBuffer Ids;
  InkTextureBuffer Boxes;
  InkTextureBuffer Colors;
};

#endif
