// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "OutputFile.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>

namespace ink::cli
{

/// What there is to say of a picture before its pixels. These have 8 bits a component, which are red, green
/// and blue, and alpha, not multiplied into the colors, where there are four.
struct PictureLayout
{
  int width = 0;  ///< pixels
  int height = 0; ///< pixels
  int components = 3;
  double dotsPerInch = 0;

  std::size_t rowBytes() const { return static_cast<std::size_t>(this->width) * this->components; }
};

/// "out.png: 1024 x 1024 pixels, 300 dpi, 87 x 87 mm".
std::string describe(const std::filesystem::path& file, const PictureLayout& layout);

/// Takes whole rows of a picture, one or more at a time, from the top on.
using RowSink = std::function<void(std::span<const unsigned char> rows)>;

/// Writes a picture row by row, so that none has to be in memory as a whole.
class PictureEncoder
{
public:
  virtual ~PictureEncoder() = default;
  PictureEncoder(const PictureEncoder&) = delete;
  PictureEncoder& operator=(const PictureEncoder&) = delete;

  /// The encoder for a file by the end of its name, or for PNG where it is "-"; null for a name of another
  /// kind.
  /// @param sink takes the bytes of the file
  static std::unique_ptr<PictureEncoder> create(
    const std::filesystem::path& file, const PictureLayout& layout, const ByteSink& sink);

  /// Whether a name is that of a picture: "-" is a PNG's.
  static bool isPicture(const std::filesystem::path& file);
  /// The ends of names of pictures, as ".png, .jpg or .tif".
  static std::string suffixes();
  /// Whether a file of this name can hold alpha.
  static bool hasAlpha(const std::filesystem::path& file);
  /// The longest side in pixels that a file of this name can have.
  static int longestSide(const std::filesystem::path& file);

  virtual void add(std::span<const unsigned char> rows) = 0;
  /// Once all rows were added.
  virtual void finish() = 0;

protected:
  PictureEncoder(const PictureLayout& layout, const ByteSink& sink)
    : Layout(layout)
    , Sink(sink)
  {
  }

  PictureLayout Layout;
  ByteSink Sink;
};

/// Writes a picture as the name of a file says.
/// @param draw is called once the file is open, and hands over all rows; what it throws is passed on
/// @throws Failure if the file cannot be written whole
void writePicture(const OutputFile& output, const std::filesystem::path& file, const PictureLayout& layout,
  const std::function<void(const RowSink&)>& draw);

} // namespace ink::cli
