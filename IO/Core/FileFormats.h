// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ReadError.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <string>

namespace ink::io
{

/// The format of a file by the end of its name, or null.
/// @param formats the table of a reader, each row with a `suffix`
template <class Formats>
auto findFormat(const Formats& formats, const std::filesystem::path& file)
{
  const std::string suffix = suffixOf(file);
  const auto found = std::find_if(
    std::begin(formats), std::end(formats), [&](const auto& format) { return suffix == format.suffix; });
  return found == std::end(formats) ? nullptr : &*found;
}

/// The suffixes of a reader's table, separated by spaces.
template <class Formats>
std::string listSuffixes(const Formats& formats)
{
  std::string list;
  for (const auto& format : formats)
  {
    list.append(list.empty() ? "" : " ").append(format.suffix);
  }
  return list;
}

} // namespace ink::io
