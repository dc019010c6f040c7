// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

namespace ink::cli
{

/// A direction to look along and the direction that is up in the picture, unit and at right angles.
///
/// World axes are read as DICOM's: +x is the subject's left, +y its back, +z its top.
struct View
{
  double direction[3];
  double up[3];

  /// Makes another axis than z the subject's top.
  /// @param axis of upAxes()
  void stand(const std::string& axis);

  /// Moves the viewer about the subject.
  /// @param azimuth degrees to the viewer's right, about the up direction.
  /// @param elevation degrees upwards after that.
  void rotate(double azimuth, double elevation);

  /// Moves the viewer around the axis of the world that is nearest to a direction, which stays as it is in
  /// the picture: to the right where the direction is up.
  void turnAround(const double axis[3], double degrees);
};

/// x, y and z, and each of these with a minus.
std::vector<std::string> upAxes();

/// The named views: front, back, left, right, top, bottom (from that side of the subject) and iso (from its
/// front, left and top at equal angles).
const std::map<std::string, View>& namedViews();

} // namespace ink::cli
