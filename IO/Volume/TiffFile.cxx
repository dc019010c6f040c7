// SPDX-License-Identifier: BSD-3-Clause
#include "TiffFile.h"

#include "FileHandle.h"
#include "OrderedBytes.h"
#include "ReadError.h"

#include <algorithm>
#include <array>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <vector>

#include <fcntl.h>
#include <tiffio.h>

namespace fs = std::filesystem;

namespace ink::io
{
namespace
{

constexpr std::uint64_t roomForAnyFile = 1 << 24;
constexpr std::uint64_t bitsOfAByte = 8;

template <class T>
T fieldOf(TIFF* tiff, std::uint32_t tag, T otherwise)
{
  T value{};
  return TIFFGetFieldDefaulted(tiff, tag, &value) ? value : otherwise;
}

/// Of the strips or tiles that what is read of a page is in.
std::uint32_t partsOf(TIFF* tiff, const TiffLayout& layout)
{
  const std::uint32_t all = TIFFIsTiled(tiff) ? TIFFNumberOfTiles(tiff) : TIFFNumberOfStrips(tiff);
  return layout.separate ? all / static_cast<std::uint32_t>(layout.components) : all;
}

} // namespace

struct TiffFile::Library
{
  TIFF* tiff = nullptr;
  std::string message; ///< libtiff's last

  Library() = default;
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
  ~Library()
  {
    if (this->tiff)
    {
      TIFFClose(this->tiff);
    }
  }

  static int keepMessage(TIFF*, void* library, const char*, const char* format, va_list arguments)
  {
    std::array<char, 200> text{};
    std::vsnprintf(text.data(), text.size(), format, arguments);
    static_cast<Library*>(library)->message = text.data();
    return 1;
  }
  static int ignore(TIFF*, void*, const char*, const char*, va_list) { return 1; }

  [[noreturn]] void fail(const fs::path& path, const std::string& reason) const
  {
    failToRead(path, this->message.empty() ? reason : reason + ": " + this->message);
  }
};

std::uint64_t TiffLayout::bytes() const
{
  return static_cast<std::uint64_t>(this->width) * static_cast<std::uint64_t>(this->height) *
    static_cast<std::uint64_t>(this->separate ? 1 : this->components) *
    static_cast<std::uint64_t>(this->bits) / bitsOfAByte;
}

TiffFile::TiffFile(const fs::path& path)
  : Path(path)
  , Tiff(std::make_unique<Library>())
{
  const std::uint64_t room = 10 * static_cast<std::uint64_t>(fs::file_size(path)) + roomForAnyFile;
  TIFFOpenOptions* options = TIFFOpenOptionsAlloc();
  TIFFOpenOptionsSetErrorHandlerExtR(options, Library::keepMessage, this->Tiff.get());
  TIFFOpenOptionsSetWarningHandlerExtR(options, Library::ignore, nullptr);
  TIFFOpenOptionsSetMaxSingleMemAlloc(options, static_cast<tmsize_t>(room));
  // Not mapped to memory, where a file that is cut short meanwhile would end the program.
  this->Tiff->tiff = TIFFOpenExt(path.c_str(), "rm", options);
  TIFFOpenOptionsFree(options);
  if (!this->Tiff->tiff)
  {
    this->Tiff->fail(path, "it is no TIFF file");
  }
}

TiffFile::~TiffFile() = default;

bool TiffFile::bigEndian() const
{
  return TIFFIsBigEndian(this->Tiff->tiff) != 0;
}

bool TiffFile::turnToNext()
{
  if (TIFFLastDirectory(this->Tiff->tiff))
  {
    this->checkEndOfDirectory();
    return false;
  }
  if (!TIFFReadDirectory(this->Tiff->tiff))
  {
    this->Tiff->fail(this->Path, "one of its pages is damaged");
  }
  return true;
}

/// libtiff takes a directory for the last where a file ends before it says which is the next.
void TiffFile::checkEndOfDirectory() const
{
  TIFF* tiff = this->Tiff->tiff;
  const bool isBig = TIFFIsBigTIFF(tiff) != 0;
  const bool isSwapped = TIFFIsByteSwapped(tiff) != 0;
  std::array<unsigned char, sizeof(std::uint64_t)> bytes{};
  const FileHandle file(::open(this->Path.c_str(), O_RDONLY | O_CLOEXEC));
  readAt(file.get(), this->directory(), bytes);
  const std::uint64_t entries = isBig ? valueFrom<std::uint64_t>(bytes.data(), isSwapped)
                                      : valueFrom<std::uint16_t>(bytes.data(), isSwapped);
  const std::uint64_t size = fs::file_size(this->Path);
  constexpr std::uint64_t bytesOfAnEntry = 12;
  constexpr std::uint64_t bytesOfABigEntry = 20;
  const std::uint64_t needed = isBig
    ? 2 * sizeof(std::uint64_t) + std::min(entries, size) * bytesOfABigEntry
    : sizeof(std::uint16_t) + entries * bytesOfAnEntry + sizeof(std::uint32_t);
  if (size - std::min(size, this->directory()) < needed)
  {
    failToRead(this->Path, "it ends before it says whether there are more pages");
  }
}

void TiffFile::turnTo(std::uint64_t directory)
{
  if (!TIFFSetSubDirectory(this->Tiff->tiff, directory))
  {
    this->Tiff->fail(this->Path, "one of its pages is damaged");
  }
}

std::uint64_t TiffFile::directory() const
{
  return TIFFCurrentDirOffset(this->Tiff->tiff);
}

bool TiffFile::isReduced() const
{
  return (fieldOf<std::uint32_t>(this->Tiff->tiff, TIFFTAG_SUBFILETYPE, 0) &
           (FILETYPE_REDUCEDIMAGE | FILETYPE_MASK)) != 0;
}

TiffLayout TiffFile::layout() const
{
  TIFF* tiff = this->Tiff->tiff;
  TiffLayout layout;
  layout.width = static_cast<int>(fieldOf<std::uint32_t>(tiff, TIFFTAG_IMAGEWIDTH, 0));
  layout.height = static_cast<int>(fieldOf<std::uint32_t>(tiff, TIFFTAG_IMAGELENGTH, 0));
  layout.bits = fieldOf<std::uint16_t>(tiff, TIFFTAG_BITSPERSAMPLE, 1);
  layout.components = fieldOf<std::uint16_t>(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
  layout.separate = layout.components > 1 &&
    fieldOf<std::uint16_t>(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG) == PLANARCONFIG_SEPARATE;
  const int format = fieldOf<std::uint16_t>(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT);
  layout.kind = format == SAMPLEFORMAT_INT ? TiffLayout::Kind::Signed
    : format == SAMPLEFORMAT_IEEEFP        ? TiffLayout::Kind::Float
                                           : TiffLayout::Kind::Unsigned;
  const bool isNumber = format == SAMPLEFORMAT_UINT || format == SAMPLEFORMAT_INT ||
    format == SAMPLEFORMAT_IEEEFP || format == SAMPLEFORMAT_VOID;
  const bool isFloat = layout.kind == TiffLayout::Kind::Float;
  if (layout.bits == 1 && layout.components == 1 && format == SAMPLEFORMAT_UINT && !TIFFIsTiled(tiff))
  {
    layout.bilevel = true;
    layout.bits = bitsOfAByte;
  }
  if (!isNumber ||
    !((layout.bits == 8 && !isFloat) || layout.bits == 16 || layout.bits == 32 || layout.bits == 64))
  {
    failToRead(this->Path,
      "its values have " + std::to_string(layout.bits) + " bits and sample format " + std::to_string(format) +
        "; expected integers of 1, 8, 16, 32 or 64 bits or floating-point numbers of 16, 32 or 64");
  }
  if (layout.width < 1 || layout.height < 1 || layout.components < 1 ||
    fieldOf<std::uint32_t>(tiff, TIFFTAG_IMAGEDEPTH, 1) != 1)
  {
    failToRead(this->Path,
      "a page of it says " + std::to_string(layout.width) + " x " + std::to_string(layout.height) +
        " pixels of " + std::to_string(layout.components) + " components; expected 1 or more, in one layer");
  }
  const auto compression = fieldOf<std::uint16_t>(tiff, TIFFTAG_COMPRESSION, COMPRESSION_NONE);
  if (fieldOf<std::uint16_t>(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK) == PHOTOMETRIC_YCBCR &&
    compression != COMPRESSION_JPEG)
  {
    failToRead(this->Path, "its colors are YCbCr without JPEG; expected gray levels or RGB");
  }
  if (!TIFFIsCODECConfigured(compression))
  {
    failToRead(this->Path,
      "it is compressed in a way (" + std::to_string(compression) +
        ") that libtiff was built without; expected LZW, Deflate, PackBits or none");
  }
  if (compression == COMPRESSION_NONE)
  {
    const std::uint64_t size = fs::file_size(this->Path);
    std::uint64_t stored = 0;
    for (std::uint32_t part = 0; part < partsOf(tiff, layout); ++part)
    {
      stored = std::min(stored + std::min<std::uint64_t>(TIFFGetStrileByteCount(tiff, part), size), size);
    }
    const std::uint64_t needed =
      layout.bilevel ? TIFFScanlineSize64(tiff) * static_cast<std::uint64_t>(layout.height) : layout.bytes();
    if (stored < needed)
    {
      failToRead(this->Path,
        "it has " + std::to_string(stored) + " bytes for a page of " + std::to_string(layout.width) + " x " +
          std::to_string(layout.height) + " pixels that needs " + std::to_string(needed));
    }
  }
  return layout;
}

std::optional<std::uint64_t> TiffFile::plainOffset(const TiffLayout& layout) const
{
  TIFF* tiff = this->Tiff->tiff;
  const bool isPlain =
    fieldOf<std::uint16_t>(tiff, TIFFTAG_COMPRESSION, COMPRESSION_NONE) == COMPRESSION_NONE &&
    fieldOf<std::uint16_t>(tiff, TIFFTAG_FILLORDER, FILLORDER_MSB2LSB) == FILLORDER_MSB2LSB;
  if (!isPlain || layout.bilevel || TIFFIsTiled(tiff))
  {
    return std::nullopt;
  }
  const std::uint64_t first = TIFFGetStrileOffset(tiff, 0);
  const std::uint64_t bytesOfAStrip = TIFFStripSize64(tiff);
  for (std::uint32_t strip = 1; strip < partsOf(tiff, layout); ++strip)
  {
    if (TIFFGetStrileOffset(tiff, strip) != first + strip * bytesOfAStrip)
    {
      return std::nullopt;
    }
  }
  return first;
}

std::string TiffFile::description() const
{
  const char* text = nullptr;
  return TIFFGetField(this->Tiff->tiff, TIFFTAG_IMAGEDESCRIPTION, &text) && text ? text : "";
}

double TiffFile::pixelsPerUnit(int axis) const
{
  float pixels = 0.0F;
  return TIFFGetField(this->Tiff->tiff, axis == 0 ? TIFFTAG_XRESOLUTION : TIFFTAG_YRESOLUTION, &pixels)
    ? static_cast<double>(pixels)
    : 0.0;
}

void TiffFile::read(std::span<unsigned char> values)
{
  TIFF* tiff = this->Tiff->tiff;
  const TiffLayout layout = this->layout();
  if (layout.bytes() != values.size())
  {
    failToRead(this->Path, "it was changed while it was read");
  }
  if (fieldOf<std::uint16_t>(tiff, TIFFTAG_COMPRESSION, COMPRESSION_NONE) == COMPRESSION_JPEG)
  {
    TIFFSetField(tiff, TIFFTAG_JPEGCOLORMODE, JPEGCOLORMODE_RGB);
  }
  this->Tiff->message.clear();
  layout.bilevel        ? this->readBits(layout, values)
    : TIFFIsTiled(tiff) ? this->readTiles(layout, values)
                        : this->readStrips(layout, values);
}

void TiffFile::readBits(const TiffLayout& layout, std::span<unsigned char> values)
{
  const std::uint64_t bytesOfARow = TIFFScanlineSize64(this->Tiff->tiff);
  std::vector<unsigned char> bits(
    static_cast<std::size_t>(bytesOfARow * static_cast<std::uint64_t>(layout.height)));
  this->readStrips(layout, bits);
  const bool isWhite = fieldOf<std::uint16_t>(this->Tiff->tiff, TIFFTAG_PHOTOMETRIC,
                         PHOTOMETRIC_MINISBLACK) == PHOTOMETRIC_MINISWHITE;
  const auto width = static_cast<std::uint64_t>(layout.width);
  for (std::uint64_t i = 0; i < values.size(); ++i)
  {
    const std::uint64_t x = i % width;
    const unsigned char byte = bits[static_cast<std::size_t>(i / width * bytesOfARow + x / bitsOfAByte)];
    const bool isSet = ((byte >> (bitsOfAByte - 1 - x % bitsOfAByte)) & 1) != 0;
    values[static_cast<std::size_t>(i)] = isSet != isWhite ? 1 : 0;
  }
}

void TiffFile::readStrips(const TiffLayout& layout, std::span<unsigned char> values)
{
  const std::uint64_t bytesOfAStrip = TIFFStripSize64(this->Tiff->tiff);
  std::uint32_t strip = 0;
  for (; !values.empty() && strip < partsOf(this->Tiff->tiff, layout); ++strip)
  {
    const auto bytes = static_cast<std::size_t>(std::min<std::uint64_t>(bytesOfAStrip, values.size()));
    if (TIFFReadEncodedStrip(this->Tiff->tiff, strip, values.data(), static_cast<tmsize_t>(bytes)) !=
      static_cast<tmsize_t>(bytes))
    {
      this->Tiff->fail(this->Path, "a page of it cannot be unpacked");
    }
    values = values.subspan(bytes);
  }
  if (!values.empty())
  {
    this->Tiff->fail(this->Path, "a page of it has fewer rows than it says");
  }
}

void TiffFile::readTiles(const TiffLayout& layout, std::span<unsigned char> values)
{
  TIFF* tiff = this->Tiff->tiff;
  const std::uint64_t bytesOfATile = TIFFTileSize64(tiff);
  const auto width = static_cast<std::uint64_t>(fieldOf<std::uint32_t>(tiff, TIFFTAG_TILEWIDTH, 0));
  const auto height = static_cast<std::uint64_t>(fieldOf<std::uint32_t>(tiff, TIFFTAG_TILELENGTH, 0));
  if (width < 1 || height < 1 || bytesOfATile > std::max(roomForAnyFile, 4 * layout.bytes()))
  {
    failToRead(this->Path,
      "its tiles have " + std::to_string(width) + " x " + std::to_string(height) + " pixels, its pages " +
        std::to_string(layout.width) + " x " + std::to_string(layout.height));
  }
  const std::uint64_t bytesOfARow = values.size() / static_cast<std::uint64_t>(layout.height);
  const std::uint64_t bytesOfAPixel = bytesOfARow / static_cast<std::uint64_t>(layout.width);
  std::vector<unsigned char> tile(static_cast<std::size_t>(bytesOfATile));
  for (std::uint64_t y = 0; y < static_cast<std::uint64_t>(layout.height); y += height)
  {
    for (std::uint64_t x = 0; x < static_cast<std::uint64_t>(layout.width); x += width)
    {
      const std::uint32_t number =
        TIFFComputeTile(tiff, static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), 0, 0);
      if (TIFFReadEncodedTile(tiff, number, tile.data(), static_cast<tmsize_t>(tile.size())) !=
        static_cast<tmsize_t>(tile.size()))
      {
        this->Tiff->fail(this->Path, "a page of it cannot be unpacked");
      }
      const std::uint64_t rows = std::min(height, static_cast<std::uint64_t>(layout.height) - y);
      const std::uint64_t bytes =
        std::min(width, static_cast<std::uint64_t>(layout.width) - x) * bytesOfAPixel;
      for (std::uint64_t row = 0; row < rows; ++row)
      {
        std::memcpy(&values[(y + row) * bytesOfARow + x * bytesOfAPixel], &tile[row * width * bytesOfAPixel],
          static_cast<std::size_t>(bytes));
      }
    }
  }
}

} // namespace ink::io
