// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkDrawHidingDepths_h
#define InkDrawHidingDepths_h

#include <functional>

class InkRenderPasses;
class vtkOpenGLState;
class vtkShaderProgram;
struct InkFrame;

/// Draws once more, depths alone, where ink covers so much of a pixel that it hides what is behind it. VTK's
/// order-independent pass has a depth of its own; there depths take as long as the picture, and are left out
/// unless there are volumes, which come later and would cover all ink: then they go where the picture is that
/// the pass adds to. Not where depth peeling, or a chain of render passes, asks for depth itself.
/// @param program that draws, with the uniform `viewportOrigin`, which is changed
/// @param draw takes the least coverage that is drawn
void InkDrawHidingDepths(vtkOpenGLState* state, const InkFrame& frame, const InkRenderPasses& renderPasses,
  vtkShaderProgram* program, const std::function<void(float)>& draw);

#endif
