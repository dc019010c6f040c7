// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkStippleView_h
#define InkStippleView_h

#include "Tone/StippleTone.h"

#include <vector>

class InkStipplePoints;
struct InkView;
class vtkRenderer;

/// What the tone depends on besides the stipples and the k's: the object's place before the camera, lights.
struct InkStippleView
{
  /// No more lights than this are used: the first of the renderer's that are on.
  static constexpr std::size_t MostLights = 8;

  /// @param headlight whether a light at the camera stands in for the renderer's lights
  InkStippleView(vtkRenderer* renderer, const InkView& view, const InkStipplePoints& points,
    const ink::StippleTone& tone, bool headlight);

  ink::StippleTone::View Tone;
  std::vector<ink::StippleLight> Lights;
};

#endif
