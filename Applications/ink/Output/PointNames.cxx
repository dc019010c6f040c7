// SPDX-License-Identifier: BSD-3-Clause
#include "PointNames.h"

#include "PointStore.h"

#include "vtkType.h"

#include <algorithm>
#include <array>
#include <set>
#include <stdexcept>
#include <type_traits>

namespace ink::cli
{
namespace
{

constexpr bool isSigned = std::is_signed_v<char>;
static_assert(VTK_SIZEOF_LONG == 8 && VTK_SIZEOF_ID_TYPE == 8);

// Legacy files call these by their size: what long and vtkIdType are differs between programs.
constexpr const char* legacyInt64 = "vtktypeint64";
constexpr const char* legacyUInt64 = "vtktypeuint64";

constexpr std::array<TypeNames, 14> allTypes{ { { VTK_FLOAT, "Float32", "float", "float" },
  { VTK_DOUBLE, "Float64", "double", "double" },
  { VTK_CHAR, isSigned ? "Int8" : "UInt8", isSigned ? "char" : "unsigned_char", isSigned ? "char" : "uchar" },
  { VTK_SIGNED_CHAR, "Int8", "signed_char", "char" },
  { VTK_UNSIGNED_CHAR, "UInt8", "unsigned_char", "uchar" }, { VTK_SHORT, "Int16", "short", "short" },
  { VTK_UNSIGNED_SHORT, "UInt16", "unsigned_short", "ushort" }, { VTK_INT, "Int32", "int", "int" },
  { VTK_UNSIGNED_INT, "UInt32", "unsigned_int", "uint" }, { VTK_LONG, "Int64", legacyInt64, nullptr },
  { VTK_UNSIGNED_LONG, "UInt64", legacyUInt64, nullptr }, { VTK_LONG_LONG, "Int64", legacyInt64, nullptr },
  { VTK_UNSIGNED_LONG_LONG, "UInt64", legacyUInt64, nullptr },
  { VTK_ID_TYPE, "Int64", legacyInt64, nullptr } } };

bool isControl(char c)
{
  return static_cast<unsigned char>(c) < ' ' || c == '\x7f';
}

std::string componentName(const PointStore::Array& array, int component)
{
  return array.components == 1 ? array.name : array.name + "_" + std::to_string(component);
}

} // namespace

const TypeNames* findTypeNames(int type)
{
  const auto* found =
    std::find_if(allTypes.begin(), allTypes.end(), [type](const auto& names) { return names.type == type; });
  return found == allTypes.end() ? nullptr : found;
}

const TypeNames& typeNamesOf(int type)
{
  const TypeNames* names = findTypeNames(type);
  if (!names)
  {
    throw std::invalid_argument("PointFile: an array of VTK's type " + std::to_string(type));
  }
  return *names;
}

std::string xmlName(const std::string& name)
{
  std::string text;
  for (const char c : name)
  {
    switch (c)
    {
      case '&':
        text += "&amp;";
        break;
      case '<':
        text += "&lt;";
        break;
      case '>':
        text += "&gt;";
        break;
      case '"':
        text += "&quot;";
        break;
      default:
        // XML has no others.
        text += isControl(c) ? ' ' : c;
    }
  }
  return text;
}

std::string legacyName(const std::string& name)
{
  constexpr const char* digits = "0123456789ABCDEF";
  std::string text;
  for (const char c : name)
  {
    if (c > ' ' && c < '\x7f' && c != '"' && c != '%')
    {
      text += c;
      continue;
    }
    const auto byte = static_cast<unsigned char>(c);
    text += { '%', digits[byte / 16], digits[byte % 16] };
  }
  return text;
}

std::vector<std::string> columnNames(const PointStore& points, bool words)
{
  static const std::array<std::vector<std::string>, 2> known{ { { "x", "y", "z" }, { "nx", "ny", "nz" } } };
  std::vector<std::string> columns;
  std::set<std::string> taken;
  for (const auto& names : known)
  {
    taken.insert(names.begin(), names.end());
  }
  for (std::size_t i = 0; i < points.arrays().size(); ++i)
  {
    const PointStore::Array& array = points.arrays()[i];
    if (i == 0 || array.isNormals())
    {
      const auto& names = known[i == 0 ? 0 : 1];
      columns.insert(columns.end(), names.begin(), names.end());
      continue;
    }
    for (int c = 0; c < array.components; ++c)
    {
      std::string name = componentName(array, c);
      if (words)
      {
        std::replace_if(
          name.begin(), name.end(), [](char one) { return one == ' ' || isControl(one); }, '_');
      }
      while (name.empty() || !taken.insert(name).second)
      {
        name += '_';
      }
      columns.push_back(std::move(name));
    }
  }
  return columns;
}

std::string csvName(const std::string& name)
{
  if (name.find_first_of(",\"\r\n") == std::string::npos)
  {
    return name;
  }
  std::string text = "\"";
  for (const char c : name)
  {
    text += c == '"' ? "\"\"" : std::string(1, c);
  }
  return text + "\"";
}

} // namespace ink::cli
