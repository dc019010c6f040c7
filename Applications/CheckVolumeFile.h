#pragma once

#include <filesystem>

namespace ink::cli
{

/// Check that a file holds as many values as its header promises, where VTK's readers do not.
/// \throw Failure if it does not.
void checkLegacyImage(const std::filesystem::path& file);

} // namespace ink::cli
