// SPDX-License-Identifier: BSD-3-Clause
// Images without active scalars, and of several components.
#include "InkActiveScalars.h"
#include "InkCellCenters.h"

#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <string>

namespace
{

vtkSmartPointer<vtkFloatArray> Numbers(const std::string& name, int components)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name.c_str());
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(8);
  for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
  {
    array->SetValue(i, static_cast<float>(i));
  }
  return array;
}

vtkSmartPointer<vtkImageData> Image()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(2, 2, 2);
  return image;
}

TEST(ActiveScalars, AreTheFirstOfOneComponentWhereNoneIsActive)
{
  const auto image = Image();
  EXPECT_FALSE(InkLacksActiveScalars(image));
  EXPECT_EQ(InkWithActiveScalars(image), image) << "there are none";
  vtkNew<vtkUnsignedCharArray> marks;
  marks->SetName(vtkDataSetAttributes::GhostArrayName());
  marks->SetNumberOfValues(8);
  vtkNew<vtkStringArray> words;
  words->SetName("words");
  words->SetNumberOfValues(8);
  image->GetPointData()->AddArray(marks);
  image->GetPointData()->AddArray(words);
  EXPECT_FALSE(InkLacksActiveScalars(image)) << "neither marks nor words are values";
  image->GetPointData()->AddArray(Numbers("velocity", 3));
  EXPECT_TRUE(InkLacksActiveScalars(image));
  EXPECT_STREQ(InkWithActiveScalars(image)->GetPointData()->GetScalars()->GetName(), "velocity");
  image->GetPointData()->AddArray(Numbers("pressure", 1));
  image->GetPointData()->AddArray(Numbers("density", 1));
  const auto active = InkWithPointValues(image);
  EXPECT_STREQ(active->GetPointData()->GetScalars()->GetName(), "density");
  EXPECT_EQ(active->GetPointData()->GetArray("pressure"), image->GetPointData()->GetArray("pressure"));
  EXPECT_EQ(image->GetPointData()->GetScalars(), nullptr) << "the image stays as it is";
  EXPECT_EQ(InkWithPointValues(image, "pressure"), image) << "asked for by its name";
  image->GetPointData()->SetActiveScalars("pressure");
  EXPECT_EQ(InkWithActiveScalars(image), image);
}

TEST(ActiveScalars, AreThoseOfAName)
{
  const auto image = Image();
  image->GetPointData()->SetScalars(Numbers("pressure", 1));
  image->GetPointData()->AddArray(Numbers("density", 1));
  EXPECT_EQ(InkWithActiveScalars(image, "pressure"), image);
  EXPECT_STREQ(InkWithActiveScalars(image, "density")->GetPointData()->GetScalars()->GetName(), "density");
  EXPECT_STREQ(image->GetPointData()->GetScalars()->GetName(), "pressure") << "the image stays as it is";
  const auto none = InkWithActiveScalars(image, "velocity");
  EXPECT_EQ(none->GetPointData()->GetScalars(), nullptr);
  EXPECT_EQ(none->GetPointData()->GetNumberOfArrays(), 2);
}

TEST(ActiveScalars, OfSeveralComponentsAreTheFirst)
{
  const auto image = Image();
  image->GetPointData()->SetScalars(Numbers("complex", 2));
  const auto first = InkWithFirstComponent(image);
  vtkDataArray* scalars = first->GetPointData()->GetScalars();
  EXPECT_STREQ(scalars->GetName(), "complex");
  ASSERT_EQ(scalars->GetNumberOfComponents(), 1);
  ASSERT_EQ(scalars->GetNumberOfTuples(), 8);
  for (vtkIdType i = 0; i < 8; ++i)
  {
    EXPECT_EQ(scalars->GetTuple1(i), 2.0 * static_cast<double>(i));
  }
  EXPECT_EQ(image->GetPointData()->GetScalars()->GetNumberOfComponents(), 2) << "the image stays as it is";
  EXPECT_EQ(InkWithFirstComponent(first), first);
}

} // namespace
