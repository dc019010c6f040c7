// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Progress.h"

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace ink::io
{

/// An element DataArray of a GIFTI file as it stands there: nothing of it is checked.
struct GiftiArray
{
  std::map<std::string, std::string, std::less<>> attributes;
  std::string name; ///< "Name" of its metadata; empty if that says none
  std::string text; ///< its element Data

  /// Empty if there is none.
  std::string_view attribute(std::string_view key) const;
  std::string_view intent() const { return this->attribute("Intent"); }
};

/// The arrays of a GIFTI file, in its order. @throws ReadError if it is none or not whole, ReadAborted
std::vector<GiftiArray> giftiArrays(const std::filesystem::path& file, const Progress& progress);

} // namespace ink::io
