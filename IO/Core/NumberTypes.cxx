// SPDX-License-Identifier: BSD-3-Clause
#include "NumberTypes.h"

#include "OrderedBytes.h"

#include "vtkDataArray.h"
#include "vtkType.h"

#include <cmath>

namespace ink::io
{
namespace
{

template <class T>
double roundedAt(const void* bytes, bool swapped)
{
  return static_cast<double>(valueFrom<T>(bytes, swapped));
}

} // namespace

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

double numberAt(const void* bytes, int type, bool swapped)
{
  switch (type)
  {
    vtkTemplateMacro(return roundedAt<VTK_TT>(bytes, swapped));
  }
  return 0.0;
}

bool isNumberOf(int type, double number)
{
  if (type == VTK_FLOAT || type == VTK_DOUBLE)
  {
    return true;
  }
  // Written with a power of two, as the greatest number of 64 bits is no double.
  const int bits = 8 * vtkDataArray::GetDataTypeSize(type);
  const bool isSigned = vtkDataArray::GetDataTypeMin(type) < 0.0;
  const double least = isSigned ? -std::ldexp(1.0, bits - 1) : 0.0;
  return number >= least && number < least + std::ldexp(1.0, bits) && number == std::floor(number);
}

} // namespace ink::io
