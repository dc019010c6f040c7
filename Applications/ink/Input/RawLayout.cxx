// SPDX-License-Identifier: BSD-3-Clause
#include "Errors.h"
#include "Input.h"
#include "Pattern.h"

#include "vtkType.h"

#include <map>

namespace ink::cli
{
namespace
{

const std::map<std::string, int>& rawTypes()
{
  static const std::map<std::string, int> types{ { "int8", VTK_SIGNED_CHAR }, { "uint8", VTK_UNSIGNED_CHAR },
    { "int16", VTK_SHORT }, { "uint16", VTK_UNSIGNED_SHORT }, { "int32", VTK_INT },
    { "uint32", VTK_UNSIGNED_INT }, { "int64", VTK_LONG_LONG }, { "uint64", VTK_UNSIGNED_LONG_LONG },
    { "float32", VTK_FLOAT }, { "float64", VTK_DOUBLE } };
  return types;
}

} // namespace

RawLayout RawLayout::parse(const std::string& layout)
{
  static const io::Pattern pattern(R"((\d{1,6})x(\d{1,6})x(\d{1,6}):(\w+))");
  const std::vector<std::string> match = pattern.match(layout);
  if (match.empty())
  {
    throw UsageError("--raw '" + layout + "': expected WxHxD:type, as 256x256x128:uint8");
  }
  const auto type = rawTypes().find(match[4]);
  if (type == rawTypes().end())
  {
    std::string names;
    for (const auto& [name, id] : rawTypes())
    {
      names += " " + name;
    }
    throw UsageError("--raw '" + layout + "': unknown type '" + match[4] + "'; expected one of" + names);
  }
  RawLayout result;
  result.type = type->second;
  for (int i = 0; i < 3; ++i)
  {
    result.dimensions[i] = std::stoi(match[i + 1]);
    if (result.dimensions[i] == 0)
    {
      throw UsageError("--raw '" + layout + "': dimensions have to be 1 or more");
    }
  }
  return result;
}

} // namespace ink::cli
