// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Tone/Stipple/Boundary.h"
#include "Tone/Stipple/Distance.h"
#include "Tone/Stipple/Interior.h"
#include "Tone/Stipple/Lighting.h"
#include "Tone/Stipple/Resolution.h"
#include "Tone/Stipple/Silhouette.h"
#include "Tone/Stipple/SmallElements.h"
#include "Tone/Stipple/WarmCool.h"

namespace ink::stipple
{

/// The parameters that determine how many of an element's stipples are drawn, how large and in which color
/// (Lu et al. 2003, sections 4.3 and 5). The reference for vtkInkStippleMapper's vertex shader, which
/// computes the same.
struct Tone
{
  /// The element's kind. A surface has no boundary, silhouette and interior enhancement.
  bool surface = false;
  /// Surfaces: whether elements that face away from the eye are drawn as if they faced it, or not at all.
  bool twoSided = false;

  Boundary boundary;
  Silhouette silhouette;
  Resolution resolution;
  Lighting lighting;
  Distance distance;
  Interior interior;
  SmallElements smallElements;
  WarmCool warmCool;
  /// Boundaries and silhouettes: v counts as v^valueEffect. 1: as Table 1 has it; 0: it does not count.
  float valueEffect = 1.0f;
  float pixelsPerStipple = 4.0f; ///< see maximumStipples
  float diameter = 2.0f;         ///< pixels
  /// Whether stipples grow where an element's list is too short for its size on the screen, which keeps the
  /// gray constant.
  bool growWithZoom = true;
  /// Whether a part of a stipple is a smaller stipple of full intensity instead of a paler one; the same
  /// gray.
  bool fadeBySize = false;

  /// The parameters that depend on the camera and the object as a whole.
  struct View
  {
    float listed;          ///< N_max that the lists were made for, positive
    float maximumStipples; ///< N_max at the distance `nearest`
    float smallness;       ///< as SmallElements::weight gives it for N_max at the object's center
    bool parallel;         ///< nothing gets smaller with the distance
    float nearest;         ///< D_near + d_0 as Resolution::nearestDistance gives it
    float middle;          ///< of the object's range of distances
    float halfRange;       ///< a, positive
    float closest;         ///< nothing that is drawn is nearer to the eye
  };

  /// An element, or where it is large one of its points, in view coordinates.
  struct Element
  {
    glm::vec3 position;
    glm::vec3 normal;        ///< unit length, out of the denser side
    float value;             ///< 0..1
    float gradientMagnitude; ///< 0..1
    float listLength;        ///< the number of stipples of the element
    float random;            ///< in [0, 1)
    glm::vec3 color;         ///< RGB in 0..1
    float alpha = 1.0f;      ///< of that color
  };

  /// A stipple to draw.
  struct Mark
  {
    float tone;     ///< T, the number of the element's stipples to draw; may exceed the list
    float opacity;  ///< of this one, 0 (not drawn) to 1
    float diameter; ///< pixels
    glm::vec3 color;
  };

  /// T = N_max T_b T_s T_r T_l T_d T_i, in this order and as far as each is on, and what follows from it.
  /// N_max is in proportion to the list's length, which is in proportion to the element's size.
  /// @param rank of the stipple in the element's list, from 0
  Mark mark(const View& view, std::span<const Light> lights, const Element& element, int rank) const;

  /// Whether an element of this orientation is drawn.
  /// @param cosine of the angle between its normal and the eye
  bool isSeen(float cosine) const;

  /// Bounds on the orientation of a group's elements to the eye and the light.
  struct Directions
  {
    float leastCosine = -1.0f; ///< of the angles between normals and the eye
    float mostCosine = 1.0f;
    float leastLit = 0.0f; ///< as Lighting::lit gives it
    float mostLit = 1.0f;
  };

  /// An upper bound of T for a group of elements: only this many of the first stipples in each list need to
  /// be processed. 0 if none of the group is drawn.
  /// @param largestValue, largestGradient, longestList over the group
  /// @param nearestDistance, farthestDistance of the group from the eye along the view
  float mostTone(const View& view, float largestValue, float largestGradient, float longestList,
    float nearestDistance, float farthestDistance, const Directions& directions) const;

  /// No stipple's diameter exceeds this anywhere in the view.
  float largestDiameter(const View& view) const;
};

} // namespace ink::stipple
