// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace ink::io
{

/// How the values of a page lie; pages of one volume have them alike.
struct TiffLayout
{
  int width = 0;
  int height = 0;
  int bits = 0;         ///< of a value: 8, 16, 32 or 64
  bool bilevel = false; ///< a bit in the file becomes a byte, 0 for black and 1 for white
  enum class Kind
  {
    Unsigned,
    Signed,
    Float
  } kind = Kind::Unsigned;
  int components = 1;
  bool separate = false; ///< components one after the other, of which only the first is read

  bool operator==(const TiffLayout&) const = default;
  /// Of what is read of the page.
  std::uint64_t bytes() const;
};

/// A TIFF file through libtiff, page by page.
class TiffFile
{
public:
  /// What a byte of a stack may become, at most: 1032 with Deflate, about 1300 with LZW.
  static constexpr std::uint64_t mostPerByte = 2048;

  /// Turns to the first page. @throws ReadError
  explicit TiffFile(const std::filesystem::path& path);
  ~TiffFile();

  const std::filesystem::path& path() const { return this->Path; }
  bool bigEndian() const;

  /// @return false if there is none. @throws ReadError
  bool turnToNext();
  /// @param directory where that of the page lies in the file, as directory() says. @throws ReadError
  void turnTo(std::uint64_t directory);
  std::uint64_t directory() const;

  /// Whether the page is a smaller copy of another one, or a mask.
  bool isReduced() const;
  /// Of this page; where its values are not compressed, the file has bytes for them. @throws ReadError for
  /// what is no image of numbers
  TiffLayout layout() const;
  /// Where the values of this page lie in the file as they are, in one block, if they do.
  /// @param layout of this page
  std::optional<std::uint64_t> plainOffset(const TiffLayout& layout) const;
  /// What is written beside the page; empty if nothing is.
  std::string description() const;
  /// Along x and y, in whatever unit; 0 where it is not said.
  double pixelsPerUnit(int axis) const;

  /// The values of the page, row by row from the top, in the order of bytes of this machine.
  /// @param values room for layout().bytes(). @throws ReadError
  void read(std::span<unsigned char> values);

private:
  struct Library;

  void checkEndOfDirectory() const;
  void readStrips(const TiffLayout& layout, std::span<unsigned char> values);
  void readTiles(const TiffLayout& layout, std::span<unsigned char> values);
  void readBits(const TiffLayout& layout, std::span<unsigned char> values);

  std::filesystem::path Path;
  std::unique_ptr<Library> Tiff;
};

} // namespace ink::io
