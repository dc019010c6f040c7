// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>

class vtkPolyData;

namespace ink::cli
{

/// How a subject is looked at.
struct Pose
{
  std::string up = "z";       ///< one of upAxes()
  std::string view = "front"; ///< one of namedViews()
  double elevation = 0.0;     ///< degrees that the viewer is above it

  bool operator==(const Pose&) const = default;
};

/// A guess at how a mesh or a cloud of points stands, of whose axes its file says nothing.
///
/// Up is z, or y where the mesh rests on a clearly larger base then: what it touches the ground with, as a
/// part of what lies below all of it. OBJ files have y up unless z is clearly better. Of the four sides it is
/// shown from the one whose polygons that face the viewer are largest as they are seen: from the front unless
/// another side shows clearly more. What lies flat is looked down on.
/// @param file its name
/// @param up where it is known
Pose findPose(
  vtkPolyData* mesh, const std::filesystem::path& file, const std::optional<std::string>& up = std::nullopt);

} // namespace ink::cli
