// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkFrame_h
#define InkFrame_h

#include "vtkInkRenderingCoreModule.h" // for the export macro

#include <array>
#include <optional>

class InkDrawingProgress;
class vtkActor;
class vtkHardwareSelector;
class vtkRenderer;
class vtkShaderProgram;

/// The colors that a hardware selector asks for, see Shaders/InkIds.glsl.
struct VTKINKRENDERINGCORE_EXPORT InkIdColors
{
  /// Those of the selector's present pass. Marks are points: where cells are asked for there are none.
  explicit InkIdColors(vtkHardwareSelector* selector);

  void SetUniforms(vtkShaderProgram* program) const;

  int Shift = -1;              ///< the first of the point id's 24 bits to show; negative: show Prop
  std::array<float, 3> Prop{}; ///< the actor's color
};

/// What a mapper is to draw: an actor, into the caller's framebuffer, viewport and blending.
struct InkFrame
{
  vtkRenderer* Renderer;
  vtkActor* Actor;
  /// OpenGL's, in pixels: x, y, width, height. Not the renderer's own: depth peeling draws into buffers of
  /// its own.
  std::array<int, 4> Viewport;
  std::optional<InkIdColors> Ids; ///< draw these instead of the marks' colors
  InkDrawingProgress& Progress;

  const int* GetSize() const { return this->Viewport.data() + 2; }
  /// As the uniform `viewportOrigin`.
  void SetOrigin(vtkShaderProgram* program) const;
};

#endif
