#pragma once

#include "Tone/Boundary.h"
#include "Tone/Distance.h"
#include "Tone/Interior.h"
#include "Tone/Lighting.h"
#include "Tone/Resolution.h"
#include "Tone/Silhouette.h"
#include "Tone/SmallElements.h"
#include "Tone/WarmCool.h"

namespace ink
{

/// All that decides how many of an element's stipples are drawn, how large and in which color (Lu et al.
/// 2003, sections 4.3 and 5). The reference for vtkInkStippleMapper's vertex shader, which computes the same.
struct StippleTone
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
  /// Where an element's list is too short for the room it has on the screen, whether stipples grow, so that
  /// the gray stays as it is.
  bool growing = true;
  /// Whether a part of a stipple is a smaller stipple of full intensity instead of a paler one; the same
  /// gray.
  bool appearBySize = false;

  /// What depends on the camera and the object as a whole.
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
    float listLength;        ///< how many stipples the element has
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
  Mark mark(const View& view, std::span<const StippleLight> lights, const Element& element, int rank) const;

  /// Whether the way an element faces lets it be drawn.
  /// @param cosine of the angle between its normal and the eye
  bool isSeen(float cosine) const;

  /// How the elements of a group lie to the eye and the light.
  struct Directions
  {
    float leastCosine = -1.0f; ///< of the angles between normals and the eye
    float mostCosine = 1.0f;
    float leastLit = 0.0f; ///< as Lighting::lit gives it
    float mostLit = 1.0f;
  };

  /// At least T, for whole groups of elements: no more than this of the first in each list need be looked at.
  /// 0 where none of the group is drawn.
  /// @param largestValue, largestGradient, longestList over the group
  /// @param nearestDistance, farthestDistance of the group from the eye along the view
  float mostTone(const View& view, float largestValue, float largestGradient, float longestList,
    float nearestDistance, float farthestDistance, const Directions& directions) const;

  /// No stipple's diameter exceeds this anywhere in the view.
  float largestDiameter(const View& view) const;
};

} // namespace ink
