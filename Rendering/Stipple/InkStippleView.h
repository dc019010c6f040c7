// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkStippleView_h
#define InkStippleView_h

#include "Tone/Stipple/Tone.h"

#include <vector>

class InkStipplePoints;
struct InkViewUniforms;
class vtkRenderer;

/// What the tone depends on besides the stipples and the k's: the object's position before the camera,
/// lights.
struct InkStippleView
{
  /// @param headlight whether a light at the camera stands in for the renderer's lights
  InkStippleView(vtkRenderer* renderer, const InkViewUniforms& view, const InkStipplePoints& points,
    const ink::stipple::Tone& tone, bool headlight);

  ink::stipple::Tone::View Tone;
  std::vector<ink::Light> Lights;
};

#endif
