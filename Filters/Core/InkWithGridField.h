// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkWithGridField_h
#define InkWithGridField_h

#include "Fields/Grid/GridField.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkDataArray.h"

#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>

/// Calls work(field) with the ink::GridField of an array whose type is not known, and returns what it does.
/// @param array contiguous, see InkMakeContiguous; it must outlive what keeps the field
/// @throws std::invalid_argument if its type is not that of numbers
template <class Work>
auto InkWithGridField(const ink::GridGeometry& geometry, vtkDataArray* array, int component,
  const ink::ElementMarks& hidden, const Work& work)
{
  const auto withValues = [&](auto* values)
  {
    using T = typename std::remove_pointer_t<decltype(values)>::ValueType;
    const std::span<const T> all(
      values->GetPointer(0), static_cast<std::size_t>(values->GetNumberOfValues()));
    return work(ink::GridField<T>(geometry, all.subspan(static_cast<std::size_t>(component)),
      static_cast<std::size_t>(values->GetNumberOfComponents()), hidden));
  };
  switch (array->GetDataType())
  {
    vtkTemplateMacro(return withValues(vtkAOSDataArrayTemplate<VTK_TT>::FastDownCast(array)));
  }
  throw std::invalid_argument(std::string("its values have the type ") + array->GetDataTypeAsString());
}

#endif
