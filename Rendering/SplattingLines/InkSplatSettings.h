// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkSplatSettings_h
#define InkSplatSettings_h

#include "vtkType.h"

#include <limits>

/// What the splats depend on besides the points and the view.
struct InkSplatSettings
{
  double Lambda;
  double Sigma;
  bool AsPublished;
  double MinimumRadius;    ///< of illumination splats, in thousandths of the viewport's height
  int Layers;              ///< the most that are drawn
  bool PeelBackFaces;      ///< whether hidden layers may face away
  int MaximumDownsampling; ///< pixels; 1: all splats are summed up for each pixel
  bool HalfFloats;
  double PointFraction;
  vtkMTimeType OrderTime; ///< of the order that a part of the points is drawn in
  bool Colors;            ///< whether points have colors that are wanted

  bool operator==(const InkSplatSettings&) const = default;
};

/// The distance of what is not there.
constexpr float InkNoSurface = std::numeric_limits<float>::max();

/// Splats count as being on the visible surface within this fraction of their point's radius, and of the
/// least radius on the screen, from what the depth splats show (Zhang et al. 2014, section 3.1, has an offset
/// instead). As published, it is the same for all of a disc.
constexpr double InkSplatTolerance = 1.5;

/// Otherwise this is the most. Discs leave a curved surface by the square of the distance from their middle,
/// and so does the fraction grow: from the first of these by the second for each squared radius of the point.
/// With what is needed and no more, sheets are told apart that are nearer to each other.
constexpr double InkSplatMiddleTolerance = 0.5;
constexpr double InkSplatToleranceGrowth = 0.16;

#endif
