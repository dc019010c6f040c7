// SPDX-License-Identifier: BSD-3-Clause
#include "Errors.h"
#include "Input.h"
#include "NumberTypes.h"
#include "Pattern.h"

#include <map>
#include <string>
#include <vector>

namespace ink::cli
{

RawLayout RawLayout::parse(const std::string& layout)
{
  static const io::Pattern pattern(R"((\d{1,6})x(\d{1,6})x(\d{1,6}):(\w+))");
  const std::vector<std::string> match = pattern.match(layout);
  if (match.empty())
  {
    throw UsageError("--raw '" + layout + "': expected WxHxD:type, as 256x256x128:uint8");
  }
  const std::map<std::string, int>& types = io::numberTypes();
  const auto type = types.find(match[4]);
  if (type == types.end())
  {
    throw UsageError(
      "--raw '" + layout + "': unknown type '" + match[4] + "'; expected one of " + io::listNumberTypes());
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
