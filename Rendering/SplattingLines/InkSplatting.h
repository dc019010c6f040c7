// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkSplatting_h
#define InkSplatting_h

#include "vtkType.h"

#include <limits>

/// What the splats depend on besides the points and the view.
struct InkSplatting
{
  double Lambda;
  double Sigma;
  bool AsPublished;
  double MinimumRadius; ///< of illumination splats, in thousandths of the viewport's height
  int Layers;           ///< the most that are drawn
  bool PeelBackFaces;   ///< whether hidden layers may face away
  int CoarsestTexel;    ///< pixels; 1: all splats are summed up for each pixel
  bool HalfFloats;
  double PointFraction;
  vtkMTimeType OrderTime; ///< of the order that a part of the points is drawn in
  bool Colors;            ///< whether points have colors that are wanted

  bool operator==(const InkSplatting&) const = default;
};

/// The distance of what is not there.
constexpr float InkNoSurface = std::numeric_limits<float>::max();

/// Splats count as being on the visible surface within this fraction of their point's radius, and of the
/// least radius on the screen, from what the depth splats show (Zhang et al. 2014, section 3.1, has an offset
/// instead).
constexpr double InkSplatTolerance = 1.5;

#endif
