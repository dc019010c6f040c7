// SPDX-License-Identifier: BSD-3-Clause
#include "InkArrayList.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"

#include <sstream>

std::string InkListArrays(vtkFieldData* data)
{
  std::ostringstream list;
  const char* separator = "";
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    if (vtkDataArray* array = data->GetArray(i))
    {
      list << separator << '"' << (array->GetName() ? array->GetName() : "") << "\" ("
           << array->GetNumberOfComponents() << ')';
      separator = ", ";
    }
  }
  return *separator ? list.str() : "none";
}
