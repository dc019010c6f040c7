// SPDX-License-Identifier: BSD-3-Clause
#include "PictureFile.h"

#include "Errors.h"

#include "Core/FormatNumber.h"

#include <cmath>

namespace fs = std::filesystem;

namespace ink::cli
{

fs::path formatName(const fs::path& file)
{
  return file == standardOutput ? fs::path("-.png") : file;
}

std::string describe(const fs::path& file, const io::PictureLayout& layout)
{
  const auto millimeters = [&](int pixels)
  {
    constexpr double perInch = 25.4;
    return std::to_string(std::lround(pixels * perInch / layout.dotsPerInch));
  };
  return (file == standardOutput ? "the standard output stream" : file.string()) + ": " +
    std::to_string(layout.width) + " x " + std::to_string(layout.height) + " pixels, " +
    formatNumber(layout.dotsPerInch) + " dpi, " + millimeters(layout.width) + " x " +
    millimeters(layout.height) + " mm";
}

void writePicture(const OutputFile& output, const fs::path& file, const io::PictureLayout& layout,
  const std::function<void(const RowSink&)>& draw)
{
  output.write(
    [&](const ByteSink& sink)
    {
      try
      {
        const auto encoder = io::PictureEncoder::create(formatName(file), layout, sink);
        draw([&](std::span<const unsigned char> rows) { encoder->add(rows); });
        encoder->finish();
      }
      catch (const io::PictureError& error)
      {
        throw Failure(error.what());
      }
    });
}

} // namespace ink::cli
