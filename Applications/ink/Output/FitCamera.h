// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "View.h"

#include <array>
#include <limits>

class vtkCamera;
class vtkPoints;

namespace ink::cli
{

/// Places a camera so that all points that were added just fit into the picture, whichever of the views they
/// were added with it looks from: it turns about a pivot at a fixed distance.
///
/// With a perspective camera the points themselves are fitted into the four sides of the view, not their
/// bounding sphere: each side asks for one distance, and opposite sides share the center.
class CameraFit
{
public:
  /// @param aspect width of the picture by its height.
  /// @param margin the part of the picture's half width and height that stays free, 0 to 1.
  /// @param parallel parallel instead of perspective projection.
  CameraFit(double aspect, double margin, bool parallel, const std::array<double, 3>& pivot = { 0, 0, 0 });

  /// Points that are not finite are skipped.
  void add(vtkPoints* points, const View& view);

  /// Needs one finite point.
  void apply(vtkCamera* camera, const View& view) const;

private:
  /// Least and greatest of a number of values.
  struct Interval
  {
    double least = std::numeric_limits<double>::max();
    double greatest = std::numeric_limits<double>::lowest();

    void add(double value);
  };

  double Aspect;
  double Free;
  bool Parallel;
  std::array<double, 3> Pivot;
  double TangentX = 0.0;
  double TangentY = 0.0;
  Interval Sides[4];
  Interval Depths;
};

} // namespace ink::cli
