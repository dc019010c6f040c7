// SPDX-License-Identifier: BSD-3-Clause
#include "PictureEncoder.h"

#include "JpegEncoder.h"
#include "PngEncoder.h"
#include "TiffEncoder.h"

#include "Core/FormatNumber.h"
#include "FileFormats.h"

#include <cmath>
#include <limits>

namespace fs = std::filesystem;

namespace ink::cli
{
namespace
{

template <class Encoder>
std::unique_ptr<PictureEncoder> make(const PictureLayout& layout, const ByteSink& sink)
{
  return std::make_unique<Encoder>(layout, sink);
}

struct Format
{
  const char* suffix;
  std::unique_ptr<PictureEncoder> (*create)(const PictureLayout&, const ByteSink&);
  bool alpha;
  int longestSide;
};

// What these formats have room for; JPEG's library takes a little less.
constexpr int longestPngSide = std::numeric_limits<int>::max();
constexpr int longestJpegSide = 65500;
constexpr Format formats[] = {
  { ".png", make<PngEncoder>, true, longestPngSide },
  { ".jpg", make<JpegEncoder>, false, longestJpegSide },
  { ".jpeg", make<JpegEncoder>, false, longestJpegSide },
  { ".tif", make<TiffEncoder>, true, longestPngSide },
  { ".tiff", make<TiffEncoder>, true, longestPngSide },
};

const Format* formatOf(const fs::path& file)
{
  return io::findFormat(formats, file == standardOutput ? fs::path("-.png") : file);
}

} // namespace

std::string describe(const fs::path& file, const PictureLayout& layout)
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

std::unique_ptr<PictureEncoder> PictureEncoder::create(
  const fs::path& file, const PictureLayout& layout, const ByteSink& sink)
{
  const Format* format = formatOf(file);
  return format ? format->create(layout, sink) : nullptr;
}

bool PictureEncoder::isPicture(const fs::path& file)
{
  return formatOf(file) != nullptr;
}

std::string PictureEncoder::suffixes()
{
  std::string list;
  for (const Format& format : formats)
  {
    list += (list.empty()                          ? ""
                : &format == std::end(formats) - 1 ? " or "
                                                   : ", ") +
      std::string(format.suffix);
  }
  return list;
}

bool PictureEncoder::hasAlpha(const fs::path& file)
{
  const Format* format = formatOf(file);
  return format && format->alpha;
}

int PictureEncoder::longestSide(const fs::path& file)
{
  const Format* format = formatOf(file);
  return format ? format->longestSide : 0;
}

void writePicture(const OutputFile& output, const fs::path& file, const PictureLayout& layout,
  const std::function<void(const RowSink&)>& draw)
{
  output.write(
    [&](const ByteSink& sink)
    {
      const auto encoder = PictureEncoder::create(file, layout, sink);
      draw([&](std::span<const unsigned char> rows) { encoder->add(rows); });
      encoder->finish();
    });
}

} // namespace ink::cli
