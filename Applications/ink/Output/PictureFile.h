// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "OutputFile.h"

#include "PictureEncoder.h"

#include <filesystem>
#include <functional>
#include <span>
#include <string>

namespace ink::cli
{

/// Takes whole rows of a picture, one or more at a time, from the top on.
using RowSink = std::function<void(std::span<const unsigned char> rows)>;

/// The name by whose end the format of a picture is chosen: of the standard output stream that of a PNG.
std::filesystem::path formatName(const std::filesystem::path& file);

/// "out.png: 1024 x 1024 pixels, 300 dpi, 87 x 87 mm".
std::string describe(const std::filesystem::path& file, const io::PictureLayout& layout);

/// Writes a picture as the name of a file says, row by row, so that none has to be in memory as a whole.
/// @param draw is called once the file is open, and hands over all rows; what it throws is passed on
/// @throws Failure if the file cannot be written whole
void writePicture(const OutputFile& output, const std::filesystem::path& file,
  const io::PictureLayout& layout, const std::function<void(const RowSink&)>& draw);

} // namespace ink::cli
