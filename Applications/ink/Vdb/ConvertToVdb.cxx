// SPDX-License-Identifier: BSD-3-Clause
#include "VdbParts.h"

#include "Fields/Grid/GridField.h"
#include "Fields/Vdb/VdbWrite.h"
#include "InkImageGrid.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <span>

namespace ink::cli
{
namespace
{

/// The smallest of OpenVDB's types that holds all values of a type.
bool needsDouble(int type)
{
  switch (type)
  {
    case VTK_INT:
    case VTK_UNSIGNED_INT:
    case VTK_LONG:
    case VTK_UNSIGNED_LONG:
    case VTK_LONG_LONG:
    case VTK_UNSIGNED_LONG_LONG:
    case VTK_ID_TYPE:
    case VTK_DOUBLE:
      return true;
    default:
      return false;
  }
}

template <class Array>
std::string convertAs(vtkImageData* image, const VdbConversion& conversion)
{
  using T = typename Array::ValueType;
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  vtkSmartPointer<Array> values = Array::FastDownCast(scalars);
  if (!values)
  {
    values = vtkSmartPointer<Array>::New();
    values->DeepCopy(scalars);
  }
  const GridField<T> volume(InkMakeGrid(image, InkExtent(image->GetExtent())),
    std::span<const T>(values->GetPointer(0), static_cast<std::size_t>(values->GetNumberOfValues())));
  return serializeVdb(makeVdbGrid(volume, conversion));
}

} // namespace

std::string convertToVdb(vtkImageData* image, const VdbConversion& conversion)
{
  return needsDouble(image->GetPointData()->GetScalars()->GetDataType())
    ? convertAs<vtkDoubleArray>(image, conversion)
    : convertAs<vtkFloatArray>(image, conversion);
}

} // namespace ink::cli
