// SPDX-License-Identifier: BSD-3-Clause
#include "TiffEncoder.h"

#include "vtk_tiff.h"

#include <cerrno>
#include <cstring>
#include <vector>

#include <unistd.h>

namespace ink::io
{
namespace
{

constexpr std::uint64_t mostBytesOfClassicTiff = 0xFFFFFFFFu;

[[noreturn]] void fail()
{
  throw PictureError(std::string("the picture cannot be encoded as TIFF: ") + std::strerror(errno));
}

} // namespace

struct TiffEncoder::Library
{
  FileHandle file = openUnnamed(std::filesystem::temp_directory_path());
  TIFF* tiff = nullptr;
  std::uint32_t row = 0;

  ~Library()
  {
    if (this->tiff)
    {
      TIFFClose(this->tiff);
    }
  }

  static int descriptorOf(thandle_t handle) { return static_cast<Library*>(handle)->file.get(); }

  /// @param large whether positions need more than 32 bits
  void open(bool large)
  {
    // What it would say goes nowhere; errno tells.
    TIFFSetErrorHandler(nullptr);
    TIFFSetWarningHandler(nullptr);
    this->tiff = TIFFClientOpen(
      "picture", large ? "w8" : "w", this,
      [](thandle_t handle, void* data, tmsize_t size) -> tmsize_t
      { return read(descriptorOf(handle), data, static_cast<std::size_t>(size)); },
      [](thandle_t handle, void* data, tmsize_t size) -> tmsize_t
      {
        const bool written = writeAll(
          descriptorOf(handle), { static_cast<const unsigned char*>(data), static_cast<std::size_t>(size) });
        return written ? size : -1;
      },
      [](thandle_t handle, toff_t offset, int from) -> toff_t
      { return static_cast<toff_t>(lseek(descriptorOf(handle), static_cast<off_t>(offset), from)); },
      [](thandle_t) { return 0; },
      [](thandle_t handle) -> toff_t
      {
        const off_t here = lseek(descriptorOf(handle), 0, SEEK_CUR);
        const off_t size = lseek(descriptorOf(handle), 0, SEEK_END);
        lseek(descriptorOf(handle), here, SEEK_SET);
        return static_cast<toff_t>(size);
      },
      nullptr, nullptr);
  }
};

TiffEncoder::TiffEncoder(const PictureLayout& layout, const ByteSink& sink)
  : PictureEncoder(layout, sink)
  , Tiff(std::make_unique<Library>())
{
  const std::uint64_t bytes = layout.rowBytes() * static_cast<std::uint64_t>(layout.height);
  // What cannot be compressed gets a little larger.
  this->Tiff->open(bytes + bytes / 16 > mostBytesOfClassicTiff);
  TIFF* tiff = this->Tiff->tiff;
  if (!tiff)
  {
    fail();
  }
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, static_cast<std::uint32_t>(layout.width));
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, static_cast<std::uint32_t>(layout.height));
  TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, static_cast<std::uint16_t>(layout.components));
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, static_cast<std::uint16_t>(8));
  TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, static_cast<std::uint16_t>(PHOTOMETRIC_RGB));
  TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, static_cast<std::uint16_t>(PLANARCONFIG_CONTIG));
  TIFFSetField(tiff, TIFFTAG_ORIENTATION, static_cast<std::uint16_t>(ORIENTATION_TOPLEFT));
  TIFFSetField(tiff, TIFFTAG_COMPRESSION, static_cast<std::uint16_t>(COMPRESSION_ADOBE_DEFLATE));
  TIFFSetField(tiff, TIFFTAG_PREDICTOR, static_cast<std::uint16_t>(2)); // differences of neighbors
  TIFFSetField(tiff, TIFFTAG_RESOLUTIONUNIT, static_cast<std::uint16_t>(RESUNIT_INCH));
  TIFFSetField(tiff, TIFFTAG_XRESOLUTION, layout.dotsPerInch);
  TIFFSetField(tiff, TIFFTAG_YRESOLUTION, layout.dotsPerInch);
  TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, TIFFDefaultStripSize(tiff, 0));
  if (layout.components == 4)
  {
    const std::uint16_t alpha = EXTRASAMPLE_UNASSALPHA;
    TIFFSetField(tiff, TIFFTAG_EXTRASAMPLES, static_cast<std::uint16_t>(1), &alpha);
  }
}

TiffEncoder::~TiffEncoder() = default;

void TiffEncoder::add(std::span<const unsigned char> rows)
{
  const std::size_t length = this->Layout.rowBytes();
  // The predictor works in place.
  std::vector<unsigned char> row;
  for (; !rows.empty(); rows = rows.subspan(length))
  {
    row.assign(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(length));
    if (TIFFWriteScanline(this->Tiff->tiff, row.data(), this->Tiff->row++, 0) < 0)
    {
      fail();
    }
  }
}

void TiffEncoder::finish()
{
  if (!TIFFFlush(this->Tiff->tiff))
  {
    fail();
  }
  TIFFClose(this->Tiff->tiff);
  this->Tiff->tiff = nullptr;
  if (!readAll(this->Tiff->file.get(), this->Sink))
  {
    fail();
  }
}

} // namespace ink::io
