// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkWithValues_h
#define InkWithValues_h

#include "vtkDataArray.h"
#include "vtkSetGet.h" // for vtkTemplateMacro

#include <cstddef>
#include <span>

/// Calls use(std::span<const T>) with the values, of type T, of a contiguous array of one component.
/// @return what it returns; nothing where the values are no numbers
template <class Use>
auto InkWithValues(vtkDataArray* array, const Use& use) -> decltype(use(std::span<const double>()))
{
  const auto count = static_cast<std::size_t>(array->GetNumberOfValues());
  switch (array->GetDataType())
  {
    vtkTemplateMacro(return use(std::span(static_cast<const VTK_TT*>(array->GetVoidPointer(0)), count)));
  }
  return {};
}

#endif
