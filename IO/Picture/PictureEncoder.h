// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ByteSink.h"
#include "vtkInkIOPictureModule.h" // for the export macro

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>

namespace ink::io
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

/// Why a picture cannot be encoded.
class PictureError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Writes a picture row by row, so that none has to be in memory as a whole.
class VTKINKIOPICTURE_EXPORT PictureEncoder
{
public:
  virtual ~PictureEncoder() = default;
  PictureEncoder(const PictureEncoder&) = delete;
  PictureEncoder& operator=(const PictureEncoder&) = delete;

  /// The encoder for a file by the end of its name; null for a name of another kind.
  /// @param sink takes the bytes of the file
  static std::unique_ptr<PictureEncoder> create(
    const std::filesystem::path& file, const PictureLayout& layout, const ByteSink& sink);

  /// Whether a name is that of a picture.
  static bool isPicture(const std::filesystem::path& file);
  /// The ends of names of pictures, as ".png, .jpg or .tif".
  static std::string suffixes();
  /// Whether a file of this name can hold alpha.
  static bool hasAlpha(const std::filesystem::path& file);
  /// The longest side in pixels that a file of this name can have.
  static int longestSide(const std::filesystem::path& file);

  /// Whole rows, one or more, from the top on. @throws PictureError
  virtual void add(std::span<const unsigned char> rows) = 0;
  /// Once all rows were added. @throws PictureError
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

} // namespace ink::io
