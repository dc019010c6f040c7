// SPDX-License-Identifier: BSD-3-Clause
#include "PictureEncoder.h"

#include "JpegEncoder.h"
#include "PngEncoder.h"
#include "TiffEncoder.h"

#include "FileFormats.h"

#include <limits>

namespace fs = std::filesystem;

namespace ink::io
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
  return findFormat(formats, file);
}

} // namespace

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

} // namespace ink::io
