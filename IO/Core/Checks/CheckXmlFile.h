// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkInkIOCoreModule.h" // for the export macro

#include <filesystem>

namespace ink::io
{

/// Checks what VTK's readers of VTK XML files believe: that the file has its end, and that it is long enough
/// for the points, cells and values that its elements promise and for the blocks in which those are stored.
///
/// Faults: VTK makes room for as many points, cells, components and blocks as a file says, whatever its
/// length; it looks for the rows of a piece beyond the image behind its values; and it takes an array with an
/// offset but without a format for one that is not appended.
/// @return how many values an array of it can have at most
/// @throws ReadError if not
VTKINKIOCORE_EXPORT double checkXml(const std::filesystem::path& file);

} // namespace ink::io
