// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace ink::cli
{

class OutputFile;
class PointStore;

/// The kinds of files that points are written to.
enum class PointFormat
{
  Vtp, ///< VTK XML, binary
  Vtk, ///< legacy VTK, binary
  Ply, ///< binary
  Csv, ///< text with a line of names
  Xyz  ///< text: coordinates and normals
};

/// By the name's suffix. @throws UsageError if it is none of them
PointFormat pointFormatOf(const std::filesystem::path& file);

/// Writes all points with all arrays (coordinates and Normals alone to Xyz).
/// @throws Failure
void writePoints(const PointStore& points, PointFormat format, const OutputFile& file);

} // namespace ink::cli
