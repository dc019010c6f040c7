// SPDX-License-Identifier: BSD-3-Clause
// vtkInkGradient at the ends of what there is: images without points, without values, thin, flat, very small,
// very large, far away and at the limits of their types.

#include "InkTestMessages.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInkGradient.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

namespace
{

using Value = std::function<double(const std::array<int, 3>&)>;

vtkSmartPointer<vtkImageData> MakeImage(int type, const std::array<int, 3>& size, const Value& value,
  const std::array<double, 3>& spacing = { 1.0, 1.0, 1.0 })
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size.data());
  image->SetSpacing(spacing.data());
  image->AllocateScalars(type, 1);
  vtkIdType n = 0;
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        image->GetPointData()->GetScalars()->SetComponent(n++, 0, value({ i, j, k }));
      }
    }
  }
  return image;
}

/// Everything that can be computed, in every way: calls use(name, output) with each, whose numbers are
/// finite.
void ForEachMethod(const std::string& name, vtkImageData* image,
  const std::function<void(const std::string&, vtkPointData*)>& use)
{
  for (int way = 0; way < 16; ++way)
  {
    vtkNew<vtkInkGradient> filter;
    vtkNew<InkTestMessages> messages;
    messages->Observe(filter);
    filter->SetInputData(image);
    filter->SetMethod(way < 14 ? vtkInkGradient::REGRESSION : vtkInkGradient::CENTRAL_DIFFERENCE);
    filter->SetNeighborhood(way & 1);
    filter->SetWeighting(way >> 1 & 1);
    filter->SetLaplacianScale(0.7 * (way >> 2));
    filter->SetOutputArraysPrecision(way & 1);
    filter->ComputeValueOn();
    filter->ComputeLaplacianOn();
    filter->Update();
    const std::string what = name + ", way " + std::to_string(way);
    EXPECT_TRUE(messages->Messages.empty())
      << what << ": no message, found " << (messages->Messages.empty() ? "" : messages->Messages[0]);
    vtkPointData* data = filter->GetOutput()->GetPointData();
    for (const char* array : { "Gradient", "GradientMagnitude", "Value", "Laplacian" })
    {
      vtkDataArray* values = data->GetArray(array);
      const vtkIdType count = values ? values->GetNumberOfTuples() : 0;
      EXPECT_EQ(count, image->GetNumberOfPoints())
        << what << ": " << image->GetNumberOfPoints() << " values in " << array << ", found " << count;
      bool finite = true;
      for (vtkIdType n = 0; n < count; ++n)
      {
        for (int c = 0; c < values->GetNumberOfComponents(); ++c)
        {
          finite = finite && std::isfinite(values->GetComponent(n, c));
        }
      }
      EXPECT_TRUE(finite) << what << ": finite values in " << array;
    }
    if (data->GetArray("Laplacian"))
    {
      use(what, data);
    }
  }
}

double LargestOf(vtkDataArray* array)
{
  double largest = 0.0;
  for (vtkIdType n = 0; n < array->GetNumberOfTuples(); ++n)
  {
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      largest = std::max(largest, std::abs(array->GetComponent(n, c)));
    }
  }
  return largest;
}

} // namespace

TEST(GradientExtremes, Nothing)
{
  vtkNew<vtkImageData> empty;
  vtkNew<vtkInkGradient> filter;
  vtkNew<InkTestMessages> messages;
  messages->Observe(filter);
  filter->SetInputData(empty);
  filter->Update();
  EXPECT_TRUE(filter->GetOutput()->GetNumberOfPoints() == 0 && messages->Messages.empty())
    << "an image without points: one without points, and no message";

  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double value : { nan, infinity, -infinity })
  {
    const auto image = MakeImage(VTK_FLOAT, { 5, 4, 3 }, [=](const auto&) { return value; });
    ForEachMethod("nothing but " + std::to_string(value), image,
      [&](const std::string& name, vtkPointData* data)
      {
        EXPECT_TRUE(LargestOf(data->GetArray("Gradient")) == 0.0 &&
          LargestOf(data->GetArray("Value")) == 0.0 && LargestOf(data->GetArray("Laplacian")) == 0.0)
          << name << ": zeros";
      });
  }
}

TEST(GradientExtremes, Constants)
{
  for (const int type : { VTK_SIGNED_CHAR, VTK_UNSIGNED_SHORT, VTK_LONG_LONG, VTK_FLOAT, VTK_DOUBLE })
  {
    for (const std::array<int, 3>& size :
      { std::array<int, 3>{ 1, 1, 1 }, { 12, 1, 1 }, { 1, 9, 1 }, { 1, 1, 7 }, { 1, 8, 9 }, { 12, 11, 10 } })
    {
      const auto image = MakeImage(type, size, [](const auto&) { return 101.0; });
      ForEachMethod("a constant of type " + std::to_string(type), image,
        [&](const std::string& name, vtkPointData* data)
        {
          EXPECT_TRUE(LargestOf(data->GetArray("Gradient")) == 0.0 &&
            LargestOf(data->GetArray("GradientMagnitude")) == 0.0)
            << name << ": no gradient at all";
          EXPECT_LE(LargestOf(data->GetArray("Laplacian")), 1e-10)
            << name << ": no Laplacian, found " << LargestOf(data->GetArray("Laplacian"));
          EXPECT_LT(std::abs(LargestOf(data->GetArray("Value")) - 101.0), 1e-4) << name << ": its value";
        });
    }
  }
}

/// A slope along each axis, with any spacing, far from the origin.
TEST(GradientExtremes, Spacings)
{
  for (const std::array<double, 3>& spacing : { std::array<double, 3>{ 1e-9, 1e-9, 1e-9 }, { 1e9, 1e9, 1e9 },
         { 1.0, 1e3, 1.0 }, { 1e-3, 1.0, 1.0 }, { 1e-9, 1.0, 1e9 }, { -1.0, 2.0, -0.5 } })
  {
    const auto image = MakeImage(
      VTK_FLOAT, { 9, 8, 7 }, [](const auto& at) { return 1.0 * at[0] - 2.0 * at[1] + 3.0 * at[2]; },
      spacing);
    image->SetOrigin(1e7, -1e7, 1e7);
    const std::string name = "spacing " + std::to_string(spacing[0]) + " " + std::to_string(spacing[1]) +
      " " + std::to_string(spacing[2]);
    const double slope[3] = { 1.0 / spacing[0], -2.0 / spacing[1], 3.0 / spacing[2] };
    ForEachMethod(name, image,
      [&](const std::string& what, vtkPointData* data)
      {
        bool right = true;
        for (vtkIdType n = 0; n < image->GetNumberOfPoints(); ++n)
        {
          for (int axis = 0; axis < 3; ++axis)
          {
            right = right &&
              std::abs(data->GetArray("Gradient")->GetComponent(n, axis) - slope[axis]) <=
                1e-4 * std::abs(slope[axis]);
          }
          right = right &&
            std::abs(data->GetArray("GradientMagnitude")->GetComponent(n, 0) - vtkMath::Norm(slope)) <=
              1e-4 * vtkMath::Norm(slope);
        }
        EXPECT_TRUE(right) << what << ": the slope everywhere";
      });
  }
}

/// From one end of a type to the other and back.
TEST(GradientExtremes, Limits)
{
  for (const int type : { VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_INT, VTK_UNSIGNED_INT,
         VTK_LONG_LONG, VTK_UNSIGNED_LONG_LONG, VTK_FLOAT, VTK_DOUBLE })
  {
    vtkSmartPointer<vtkImageData> image = MakeImage(type, { 8, 7, 6 }, [](const auto&) { return 0.0; });
    vtkDataArray* scalars = image->GetPointData()->GetScalars();
    const double low = scalars->GetDataTypeMin();
    const double high = scalars->GetDataTypeMax();
    for (vtkIdType n = 0; n < scalars->GetNumberOfTuples(); ++n)
    {
      // Doubles beyond the ends of 64-bit integers would wrap around.
      scalars->SetComponent(n, 0, (n / 2 % 2 ? 0.999 * low : 0.999 * high));
    }
    ForEachMethod("the ends of type " + std::to_string(type), image,
      [&](const std::string& name, vtkPointData* data)
      {
        EXPECT_GT(LargestOf(data->GetArray("GradientMagnitude")), std::min(0.01 * high, 1e38))
          << name << ": steep, found " << LargestOf(data->GetArray("GradientMagnitude"));
      });
  }
}
