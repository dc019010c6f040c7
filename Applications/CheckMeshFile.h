#pragma once

#include <filesystem>

namespace ink::cli
{

/// Check that a file holds all that its header promises. VTK's readers do not: the one for PLY may end the
/// program, the one for binary STL returns what it found.
/// \throw Failure if it is not such a file or not whole.
void checkPly(const std::filesystem::path& file);
void checkStl(const std::filesystem::path& file);

/// An OBJ promises nothing: only a file cut off within its last line is known not to be whole.
void checkObj(const std::filesystem::path& file);

} // namespace ink::cli
