// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ink::io
{

/// A type of numbers in PLY files.
struct PlyType
{
  int vtkType; ///< as VTK_FLOAT
  int size;    ///< bytes in a binary file
};

/// A number, or a list of them, that each of an element's rows has.
struct PlyProperty
{
  std::string name;
  PlyType type;
  std::optional<PlyType> countType; ///< of the number before a list; none: not a list
};

/// A table.
struct PlyElement
{
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  /// The index of a property; none if there is no such or it is a list where none is wanted, or the reverse.
  std::optional<std::size_t> find(std::string_view property, bool isList = false) const;
};

enum class PlyFormat
{
  Text,
  LittleEndian,
  BigEndian
};

/// What stands before a PLY file's tables.
struct PlyHeader
{
  PlyFormat format = PlyFormat::Text;
  std::vector<PlyElement> elements;

  /// Takes the header from the front of bytes. @throws ReadError if it is none, or promises more than the
  /// bytes after it can hold.
  static PlyHeader take(std::string_view& bytes, const std::filesystem::path& file);
};

} // namespace ink::io
