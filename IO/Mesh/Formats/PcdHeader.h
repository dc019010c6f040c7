// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace ink::io
{

/// A number, or some of them, that each point of a PCD file has.
struct PcdField
{
  std::string name;
  int vtkType = 0;        ///< as VTK_FLOAT
  std::size_t size = 0;   ///< bytes of a number
  std::size_t count = 1;  ///< numbers of a point
  std::size_t offset = 0; ///< bytes before it in a point
  std::size_t index = 0;  ///< among the fields

  /// Whether it is red, green and blue in the bytes of a number, be that called one of floating point.
  bool isColor() const
  {
    return (this->name == "rgb" || this->name == "rgba") && this->size == 4 && this->count == 1;
  }
};

enum class PcdData
{
  Text,
  Binary,
  Compressed
};

/// What stands before a PCD file's points.
struct PcdHeader
{
  std::vector<PcdField> fields;
  std::uint64_t points = 0;
  PcdData data = PcdData::Text;
  std::size_t pointBytes = 0;
  std::size_t lines = 0; ///< of the header

  /// Null if there is no field of that name with one number.
  const PcdField* find(std::string_view name) const;

  /// Takes the header from the front of bytes. @throws ReadError if it is none
  static PcdHeader take(std::string_view& bytes, const std::filesystem::path& file);
};

} // namespace ink::io
