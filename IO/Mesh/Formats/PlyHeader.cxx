// SPDX-License-Identifier: BSD-3-Clause
#include "PlyHeader.h"

#include "ReadError.h"
#include "Words.h"

#include "vtkType.h"

#include <algorithm>
#include <charconv>
#include <map>

namespace fs = std::filesystem;

namespace ink::io
{
namespace
{

std::optional<PlyType> typeOf(std::string_view name)
{
  static const std::map<std::string_view, PlyType> types{ { "char", { VTK_SIGNED_CHAR, 1 } },
    { "int8", { VTK_SIGNED_CHAR, 1 } }, { "uchar", { VTK_UNSIGNED_CHAR, 1 } },
    { "uint8", { VTK_UNSIGNED_CHAR, 1 } }, { "short", { VTK_SHORT, 2 } }, { "int16", { VTK_SHORT, 2 } },
    { "ushort", { VTK_UNSIGNED_SHORT, 2 } }, { "uint16", { VTK_UNSIGNED_SHORT, 2 } },
    { "int", { VTK_INT, 4 } }, { "int32", { VTK_INT, 4 } }, { "uint", { VTK_UNSIGNED_INT, 4 } },
    { "uint32", { VTK_UNSIGNED_INT, 4 } }, { "float", { VTK_FLOAT, 4 } }, { "float32", { VTK_FLOAT, 4 } },
    { "double", { VTK_DOUBLE, 8 } }, { "float64", { VTK_DOUBLE, 8 } } };
  const auto type = types.find(name);
  return type == types.end() ? std::nullopt : std::optional(type->second);
}

/// One line; words are what follows its first word. @return what was expected instead, empty if it is right
std::string takeLine(PlyHeader& header, bool& haveFormat, std::string_view keyword, std::string_view words)
{
  if (keyword == "comment" || keyword == "obj_info" || keyword.empty())
  {
    return "";
  }
  const std::string_view first = nextWord(words);
  if (keyword == "format")
  {
    static const std::map<std::string_view, PlyFormat> formats{ { "ascii", PlyFormat::Text },
      { "binary_little_endian", PlyFormat::LittleEndian }, { "binary_big_endian", PlyFormat::BigEndian } };
    const auto format = formats.find(first);
    if (format == formats.end())
    {
      return "the format ascii, binary_little_endian or binary_big_endian";
    }
    header.format = format->second;
    haveFormat = true;
    return "";
  }
  if (keyword == "element")
  {
    PlyElement element;
    element.name = first;
    const std::string_view count = nextWord(words);
    const auto [end, error] = std::from_chars(count.data(), count.data() + count.size(), element.count);
    const bool isKnown = std::any_of(
      header.elements.begin(), header.elements.end(), [&](const auto& other) { return other.name == first; });
    header.elements.push_back(element);
    return error != std::errc() || end != count.data() + count.size() || isKnown
      ? "an element of a new name and how many of it there are"
      : "";
  }
  if (keyword != "property" || header.elements.empty())
  {
    return "format, element, property of an element, comment, obj_info or end_header";
  }
  PlyProperty property;
  std::optional<PlyType> type = typeOf(first);
  if (first == "list")
  {
    property.countType = typeOf(nextWord(words));
    type = typeOf(nextWord(words));
  }
  property.name = nextWord(words);
  auto& properties = header.elements.back().properties;
  const bool isKnown = std::any_of(
    properties.begin(), properties.end(), [&](const auto& other) { return other.name == property.name; });
  const bool isCount = first != "list" ||
    (property.countType && property.countType->vtkType != VTK_FLOAT && property.countType->size < 8);
  if (!type || !isCount || isKnown || property.name.empty())
  {
    return "a property with a type as float or list uchar int, and a new name";
  }
  property.type = *type;
  properties.push_back(property);
  return "";
}

/// The least bytes that a row can have.
std::uint64_t leastBytes(const PlyElement& element, PlyFormat format)
{
  // Of text, a digit and what follows it.
  constexpr std::uint64_t textBytes = 2;
  std::uint64_t bytes = 0;
  for (const PlyProperty& property : element.properties)
  {
    const PlyType& type = property.countType ? *property.countType : property.type;
    bytes += format == PlyFormat::Text ? textBytes : static_cast<std::uint64_t>(type.size);
  }
  return bytes;
}

} // namespace

std::optional<std::size_t> PlyElement::find(std::string_view property, bool isList) const
{
  for (std::size_t i = 0; i < this->properties.size(); ++i)
  {
    if (this->properties[i].name == property && this->properties[i].countType.has_value() == isList)
    {
      return i;
    }
  }
  return std::nullopt;
}

PlyHeader PlyHeader::take(std::string_view& bytes, const fs::path& file)
{
  PlyHeader header;
  std::string_view line;
  if (!nextLine(bytes, line) || nextWord(line) != "ply")
  {
    failToRead(file, "it is not a PLY mesh: it does not begin with the word ply");
  }
  bool haveFormat = false;
  for (;;)
  {
    if (!nextLine(bytes, line))
    {
      failToRead(file, "the file ends within its header");
    }
    std::string_view words = line;
    const std::string_view keyword = nextWord(words);
    if (keyword == "end_header")
    {
      break;
    }
    if (const std::string expected = takeLine(header, haveFormat, keyword, words); !expected.empty())
    {
      failToRead(file, "its header says '" + shortened(line) + "'; expected " + expected);
    }
  }
  if (!haveFormat)
  {
    failToRead(file, "its header names no format; expected ascii, binary_little_endian or binary_big_endian");
  }
  std::uint64_t room = bytes.size() + 1;
  for (const PlyElement& element : header.elements)
  {
    // Without properties an element takes no bytes, and any number of them fits.
    if (element.properties.empty() && element.count > 0)
    {
      failToRead(file, "its header gives the elements '" + element.name + "' no properties");
    }
    const std::uint64_t least = leastBytes(element, header.format);
    if (element.count > 0 && element.count > room / least)
    {
      failToRead(file,
        "its header promises " + std::to_string(element.count) + " elements '" + element.name + "' of " +
          std::to_string(least) + " bytes or more each, but there are " + std::to_string(room - 1) +
          " bytes for them");
    }
    room -= element.count * least;
  }
  return header;
}

} // namespace ink::io
