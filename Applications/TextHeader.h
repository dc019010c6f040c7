#pragma once

#include <filesystem>
#include <ios>
#include <map>
#include <string>
#include <vector>

namespace ink::cli
{

/// The fields of a header made of lines "key separator value", up to the first line that is empty or whose
/// key is lastKey. Keys and values come without the space around them; lines without separator are skipped.
/// \param size where to store the header's size in bytes, if not null: what follows it starts there.
std::map<std::string, std::string> readTextHeader(const std::filesystem::path& file, char separator,
  const std::string& lastKey, std::streamoff* size = nullptr);

/// All numbers in text, which may stand between spaces, commas and parentheses.
std::vector<double> numbersIn(std::string text);

} // namespace ink::cli
