#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace ink::cli
{

/// Checks that a VTK XML file has its end: VTK's readers take what they find of appended data.
/// \throw Failure if it does not.
void checkXml(const std::filesystem::path& file);

/// The last bytes of a file, at most size of them.
std::string fileTail(const std::filesystem::path& file, std::size_t size);

} // namespace ink::cli
