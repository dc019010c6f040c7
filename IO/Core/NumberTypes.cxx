// SPDX-License-Identifier: BSD-3-Clause
#include "NumberTypes.h"

#include "vtkType.h"

namespace ink::io
{

const std::map<std::string, int>& numberTypes()
{
  static const std::map<std::string, int> types{ { "int8", VTK_SIGNED_CHAR }, { "uint8", VTK_UNSIGNED_CHAR },
    { "int16", VTK_SHORT }, { "uint16", VTK_UNSIGNED_SHORT }, { "int32", VTK_INT },
    { "uint32", VTK_UNSIGNED_INT }, { "int64", VTK_LONG_LONG }, { "uint64", VTK_UNSIGNED_LONG_LONG },
    { "float32", VTK_FLOAT }, { "float64", VTK_DOUBLE } };
  return types;
}

std::string listNumberTypes()
{
  std::string list;
  for (const auto& [name, type] : numberTypes())
  {
    list += (list.empty() ? "" : " ") + name;
  }
  return list;
}

} // namespace ink::io
