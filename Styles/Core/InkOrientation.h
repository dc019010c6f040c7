// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkOrientation_h
#define InkOrientation_h

#include <span>
#include <string>

/// A direction to look along and the direction that is up in the picture, unit and at right angles.
///
/// World axes are read as DICOM's: +x is the subject's left, +y its back, +z its top.
struct InkOrientation
{
  double Direction[3];
  double Up[3];

  /// That of a named view: front, back, left, right, top, bottom (from that side of the subject) or iso (from
  /// its front, left and top at equal angles). Null if there is none of that name.
  static const InkOrientation* Find(const std::string& view);
  static std::span<const char* const> GetViewNames();

  /// Makes another axis than z the subject's top. @param axis of GetAxes()
  void Stand(const std::string& axis);
  /// x, y and z, and each of these with a minus.
  static std::span<const char* const> GetAxes();

  /// Moves the viewer about the subject.
  /// @param azimuth degrees to the viewer's right, about the up direction
  /// @param elevation degrees upwards after that
  void Rotate(double azimuth, double elevation);

  /// Moves the viewer around the axis of the world that is nearest to a direction, which stays as it is in
  /// the picture: to the right where the direction is up.
  void TurnAround(const double axis[3], double degrees);
};

#endif
