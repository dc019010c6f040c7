// SPDX-License-Identifier: BSD-3-Clause
#include "InkKeepRange.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationInformationVectorKey.h"
#include "vtkNew.h"
#include "vtkShortArray.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <vector>

namespace
{

template <class Array, class T>
vtkSmartPointer<Array> ArrayOf(const std::vector<T>& values)
{
  auto array = vtkSmartPointer<Array>::New();
  for (const T value : values)
  {
    array->InsertNextValue(value);
  }
  return array;
}

bool Keeps(vtkDataArray* array, vtkInformationInformationVectorKey* key)
{
  return array->HasInformation() && array->GetInformation()->Has(key) != 0;
}

using Range = std::array<double, 2>;

Range RangeOf(vtkDataArray* array)
{
  Range range;
  array->GetRange(range.data());
  return range;
}

Range FiniteRangeOf(vtkDataArray* array)
{
  Range range;
  array->GetFiniteRange(range.data());
  return range;
}

TEST(KeepRange, IsTheArraysOwnUntilItIsModified)
{
  const auto array = ArrayOf<vtkShortArray>(std::vector<short>{ 3, -7, 1000, 5 });
  InkKeepRange(array);
  EXPECT_TRUE(Keeps(array, vtkAbstractArray::PER_COMPONENT()));
  EXPECT_TRUE(Keeps(array, vtkAbstractArray::PER_FINITE_COMPONENT()));
  // Values that changed in secret show that nothing is looked at.
  array->SetValue(1, -9);
  EXPECT_EQ(RangeOf(array), (Range{ -7.0, 1000.0 }));
  EXPECT_EQ(FiniteRangeOf(array), (Range{ -7.0, 1000.0 }));
  array->Modified();
  EXPECT_EQ(RangeOf(array), (Range{ -9.0, 1000.0 }));
  EXPECT_EQ(FiniteRangeOf(array), (Range{ -9.0, 1000.0 }));
}

TEST(KeepRange, OfValuesThatAreNotFiniteIsVtks)
{
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const auto array = ArrayOf<vtkFloatArray>(
    std::vector<float>{ 2.0F, infinity, -1.5F, std::numeric_limits<float>::quiet_NaN() });
  const auto same = vtkSmartPointer<vtkFloatArray>::New();
  same->DeepCopy(array);
  InkKeepRange(array);
  EXPECT_FALSE(Keeps(array, vtkAbstractArray::PER_COMPONENT()));
  EXPECT_TRUE(Keeps(array, vtkAbstractArray::PER_FINITE_COMPONENT()));
  EXPECT_EQ(RangeOf(array), RangeOf(same));
  EXPECT_EQ(FiniteRangeOf(array), FiniteRangeOf(same));
}

TEST(KeepRange, IsNotKeptWhereThereIsNone)
{
  const auto none = ArrayOf<vtkDoubleArray>(std::vector<double>{ std::numeric_limits<double>::quiet_NaN() });
  vtkNew<vtkDoubleArray> empty;
  vtkNew<vtkDoubleArray> pairs;
  pairs->SetNumberOfComponents(2);
  pairs->InsertNextTuple2(1.0, 2.0);
  for (vtkDataArray* array : { static_cast<vtkDataArray*>(none), static_cast<vtkDataArray*>(empty),
         static_cast<vtkDataArray*>(pairs) })
  {
    InkKeepRange(array);
    EXPECT_FALSE(Keeps(array, vtkAbstractArray::PER_FINITE_COMPONENT()));
  }
}

} // namespace
