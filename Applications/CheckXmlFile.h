#pragma once

#include <filesystem>

namespace ink::cli
{

/// Checks what VTK's readers of VTK XML files believe: that the file has its end, and that it is long enough
/// for the points, cells and values that its elements promise and for the blocks in which those are stored.
/// \return how many values an array of it can have at most
/// \throw Failure if not
double checkXml(const std::filesystem::path& file);

} // namespace ink::cli
