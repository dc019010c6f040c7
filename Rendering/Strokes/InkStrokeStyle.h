// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkStrokeStyle_h
#define InkStrokeStyle_h

#include "Tone/Hatching/Intensity.h"
#include "Tone/Light.h"

#include <array>
#include <optional>
#include <vector>

/// How strokes make tones; their HalfWidth is the least.
struct InkHatching
{
  ink::hatching::Intensity Intensity;
  float Crosshatching = 0.0f;
  std::array<float, 2> Spacing{}; ///< pixels, and view units in addition
  float CullingCosine = 1.0f;     ///< what faces away from the eye by more is not drawn
  std::vector<ink::Light> Lights;
};

/// Which voxels get a segment, and how long it is: in the voxels' local frame, whose gradients are divided by
/// the greatest of them.
struct InkVoxelSegments
{
  std::array<float, 2> ValueBounds{};
  float LeastGradient = 0.0f; ///< magnitude
  float LargestCosine = 0.0f; ///< of the angle between gradient and eye
  float SegmentLength = 1.0f; ///< of the voxels' own
};

/// How strokes are drawn, in the units of the shader.
struct InkStrokeStyle
{
  std::array<float, 2> HalfWidth{}; ///< pixels, and view units in addition
  float Taper = 0.0f;               ///< share of a stroke's length
  float DepthWidth = 0.0f;          ///< how much narrower the farthest strokes are
  std::array<float, 2> Distances{}; ///< from the eye to the nearest and the farthest stroke, view units
  bool Miter = false;
  float MiterLimit = 1.0f;
  bool Butt = false;
  bool Dashed = false;
  bool HiddenDashed = false;
  std::array<float, 2> Dash{}; ///< lengths of a dash and of a dash with a gap, the local frame's unit
  float TextureLength = 1.0f;  ///< of arc length, for the width of the image, the local frame's unit
  float Density = 1.0f;
  float Lift = 0.0f; ///< pixels towards the eye
  float HiddenOpacity = 1.0f;
  std::array<double, 3> Color{};
  std::optional<InkHatching> Hatching;
  std::optional<InkVoxelSegments> Voxels; ///< strokes are voxels
  bool BackEdges = false;                 ///< strokes are edges, of which those of back faces are drawn
  std::array<float, 4> Eye{}; ///< of both: position and 1, or the direction to it and 0; local frame

  /// Whether the GPU finds which strokes there are in a view.
  bool AreFoundByEye() const { return this->Voxels || this->BackEdges; }
};

#endif
