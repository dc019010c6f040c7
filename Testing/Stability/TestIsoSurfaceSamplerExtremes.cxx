// SPDX-License-Identifier: BSD-3-Clause
// vtkInkIsoSurfaceSampler at the ends of what images can be: a right result, or none and one clear message.

#include "InkTestMessages.h"
#include "StabilityChecks.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInkIsoSurfaceSampler.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

using Vector = std::array<double, 3>;
using Matrix = std::array<double, 9>; ///< row by row

constexpr Matrix Identity{ 1, 0, 0, 0, 1, 0, 0, 0, 1 };
constexpr Matrix Turned{ 0.36, 0.48, -0.8, -0.8, 0.6, 0, 0.48, 0.64, 0.6 };
constexpr Matrix Mirrored{ 1, 0, 0, 0, 1, 0, 0, 0, -1 };
constexpr Matrix Sheared{ 1, 0, 0.5, 0, 1, 0.25, 0, 0, 1 };

/// Where an image lies.
struct Geometry
{
  const char* Name;
  Vector Spacing;
  Vector Origin;
  Matrix Direction = Identity;
};

const std::vector<Geometry> Geometries{
  { "plain", { 1, 1, 1 }, { 0, 0, 0 } },
  { "far away", { 1, 1, 1 }, { 1e7, -1e7, 1e7 } },
  { "far away and fine", { 0.01, 0.01, 0.01 }, { 1e7, -1e7, 1e7 } },
  { "tiny", { 1e-9, 1e-9, 1e-9 }, { 0, 0, 0 } },
  { "huge", { 1e9, 1e9, 1e9 }, { 0, 0, 0 } },
  { "very tiny", { 1e-100, 1e-100, 1e-100 }, { 0, 0, 0 } },
  { "very huge", { 1e100, 1e100, 1e100 }, { 0, 0, 0 } },
  { "thin slices", { 1, 1, 0.001 }, { 0, 0, 0 } },
  { "thick slices", { 1, 1, 1000 }, { 0, 0, 0 } },
  { "all different", { 0.001, 1, 1000 }, { -3, 4, 5 } },
  { "negative spacing", { -1, 2, -3 }, { 0, 0, 0 } },
  { "turned", { 1, 2, 3 }, { -3, 4, 5 }, Turned },
  { "turned, 1:1000, far away", { 1, 1000, 1 }, { 1e7, 1e7, -1e7 }, Turned },
  { "mirrored", { 1, 2, 3 }, { 0, 0, 0 }, Mirrored },
  { "sheared", { 1, 1, 1 }, { 0, 0, 0 }, Sheared },
};

/// An image whose slices have the given values; the extent does not begin at 0.
vtkSmartPointer<vtkImageData> MakeLayers(
  int type, const std::vector<double>& values, const Geometry& geometry, int size)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(-2, size - 3, 5, 4 + size, 7, 6 + static_cast<int>(values.size()));
  image->SetSpacing(geometry.Spacing.data());
  image->SetOrigin(geometry.Origin.data());
  image->SetDirectionMatrix(geometry.Direction.data());
  image->AllocateScalars(type, 1);
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  for (vtkIdType n = 0; n < image->GetNumberOfPoints(); ++n)
  {
    scalars->SetComponent(n, 0, values[static_cast<std::size_t>(n / (size * size))]);
  }
  return image;
}

/// A type, values of slices of which neighbors cross the iso-value in one layer, and where between them.
struct Ramp
{
  const char* Name;
  int Type;
  std::vector<double> Values;
  double IsoValue;
  double At; ///< in slices
};

// Integers that a double does not hold are left out: the image is made from doubles.
const double LargestInt64 = std::ldexp(1.0, 63) - 1024;
const double LargestUInt64 = std::ldexp(1.0, 64) - 2048;

const std::vector<Ramp> Ramps{
  { "uint8, whole range", VTK_UNSIGNED_CHAR, { 0, 0, 255, 255 }, 127.5, 1.5 },
  { "uint8 at its greatest", VTK_UNSIGNED_CHAR, { 253, 254, 255, 255 }, 255, 2 },
  { "uint8 just above its least", VTK_UNSIGNED_CHAR, { 0, 0, 1, 1 }, 0.25, 1.25 },
  { "int8, whole range", VTK_SIGNED_CHAR, { -128, -128, 127, 127 }, -0.5, 1.5 },
  { "char, whole range", VTK_CHAR, { 0, 0, 100, 127 }, 25, 1.25 },
  { "int16, whole range", VTK_SHORT, { -32768, -32768, 32767, 32767 }, -0.5, 1.5 },
  { "uint16, whole range", VTK_UNSIGNED_SHORT, { 0, 0, 65535, 65535 }, 65535, 2 },
  { "int32, whole range", VTK_INT, { -2147483648.0, -2147483648.0, 2147483647.0, 2147483647.0 }, -0.5, 1.5 },
  { "int32, one step near its end", VTK_INT, { 2147483645.0, 2147483646.0, 2147483647.0, 2147483647.0 },
    2147483646.75, 1.75 },
  { "uint32 at its greatest", VTK_UNSIGNED_INT, { 0, 4294967294.0, 4294967295.0, 4294967295.0 }, 4294967295.0,
    2 },
  { "int64, whole range", VTK_LONG_LONG, { -LargestInt64, -LargestInt64, LargestInt64, LargestInt64 }, 0,
    1.5 },
  { "int64 near its greatest", VTK_LONG_LONG,
    { LargestInt64 - 2048, LargestInt64 - 1024, LargestInt64, LargestInt64 }, LargestInt64, 2 },
  { "uint64, whole range", VTK_UNSIGNED_LONG_LONG, { 0, 0, LargestUInt64, LargestUInt64 }, LargestUInt64 / 2,
    1.5 },
  { "uint64 near its greatest", VTK_UNSIGNED_LONG_LONG,
    { LargestUInt64 - 4096, LargestUInt64 - 2048, LargestUInt64, LargestUInt64 }, LargestUInt64 - 2048, 1 },
  { "float, ordinary", VTK_FLOAT, { 0, 1, 2, 3 }, 1.25, 1.25 },
  { "float, whole range", VTK_FLOAT, { -3e38, -3e38, 3e38, 3e38 }, 0, 1.5 },
  { "float, tiny", VTK_FLOAT, { 0, 0, 1e-30, 1e-30 }, 0.25e-30, 1.25 },
  { "float, denormal", VTK_FLOAT, { 0, 0, 0x1p-140, 0x1p-140 }, 0x1p-141, 1.5 },
  { "float, small steps on a large value", VTK_FLOAT, { 1e6, 1e6 + 1, 1e6 + 2, 1e6 + 3 }, 1e6 + 1.5, 1.5 },
  { "double, ordinary", VTK_DOUBLE, { 3, 2, 1, 0 }, 1.25, 1.75 },
  { "double, whole range", VTK_DOUBLE, { -1.7e308, -1.7e308, 1.7e308, 1.7e308 }, 0, 1.5 },
  { "double, tiny", VTK_DOUBLE, { 0, 0, 1e-300, 1e-300 }, 0.25e-300, 1.25 },
  { "double, small steps on a large value", VTK_DOUBLE, { 1e15, 1e15 + 1, 1e15 + 2, 1e15 + 3 }, 1e15 + 1.5,
    1.5 },
};

/// The surface of a ramp is a plane between two slices: one point above each square, with the axis as normal.
void CheckRamp(const Ramp& ramp, const Geometry& geometry)
{
  const std::string name = std::string(ramp.Name) + ", " + geometry.Name;
  const int size = 5;
  const auto image = MakeLayers(ramp.Type, ramp.Values, geometry, size);
  vtkNew<vtkInkIsoSurfaceSampler> sampler;
  vtkNew<InkTestMessages> messages;
  messages->Observe(sampler);
  sampler->SetInputData(image);
  sampler->SetValue(0, ramp.IsoValue);
  sampler->Update();
  vtkPolyData* output = sampler->GetOutput();
  EXPECT_TRUE(messages->Messages.empty())
    << name << ": no message, found " << (messages->Messages.empty() ? "" : messages->Messages[0]);
  const int expected = (size - 1) * (size - 1);
  ASSERT_EQ(output->GetNumberOfPoints(), expected) << name;
  if (!CheckValidPoints(name, output))
  {
    return;
  }
  const int* extent = image->GetExtent();
  // The gradient in the world: along the third row of the inverse of direction times spacing.
  vtkNew<vtkMatrix3x3> inverse;
  inverse->DeepCopy(image->GetDirectionMatrix());
  inverse->Invert();
  const double rising = (ramp.Values.back() > ramp.Values.front() ? 1.0 : -1.0) / geometry.Spacing[2];
  Vector normal;
  double length = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    normal[i] = inverse->GetElement(2, i) * (rising > 0 ? -1 : 1);
    length = std::hypot(length, normal[i]);
  }
  double diagonal = 0.0;
  for (const Vector& signs :
    { Vector{ 1, 1, 1 }, Vector{ 1, 1, -1 }, Vector{ 1, -1, 1 }, Vector{ 1, -1, -1 } })
  {
    Vector step{ 0, 0, 0 };
    for (int i = 0; i < 9; ++i)
    {
      step[i / 3] += geometry.Direction[i] * geometry.Spacing[i % 3] * signs[i % 3];
    }
    diagonal = std::max(diagonal, std::hypot(step[0], step[1], step[2]));
  }
  const double radius = output->GetPointData()->GetArray("Radius")->GetComponent(0, 0);
  EXPECT_LT(std::abs(radius / (diagonal / 2) - 1), 1e-6)
    << name << ": half a diagonal, " << diagonal / 2 << ", as radius, found " << radius;
  int n = 0;
  for (int j = 0; j < size - 1; ++j)
  {
    for (int i = 0; i < size - 1; ++i, ++n)
    {
      const double index[3] = { extent[0] + i + 0.5, extent[2] + j + 0.5, extent[4] + ramp.At };
      double point[3];
      output->GetPoint(n, point);
      double foundNormal[3];
      output->GetPointData()->GetNormals()->GetTuple(n, foundNormal);
      for (int row = 0; row < 3; ++row)
      {
        double right = geometry.Origin[row];
        // Of the cell, and of the coordinates' own precision.
        double tolerance = 0.0;
        for (int c = 0; c < 3; ++c)
        {
          const double step = geometry.Direction[3 * row + c] * geometry.Spacing[c];
          right += step * index[c];
          tolerance += 2e-5 * std::abs(step);
        }
        const bool doubles = output->GetPoints()->GetDataType() == VTK_DOUBLE;
        tolerance += 2 * std::abs(point[row]) *
          (doubles ? std::numeric_limits<double>::epsilon() : std::numeric_limits<float>::epsilon());
        ASSERT_NEAR(point[row], right, tolerance) << name << ": point " << n << " along axis " << row;
        ASSERT_NEAR(foundNormal[row], normal[row] / length, 1e-4)
          << name << ": normal " << n << " along axis " << row;
      }
    }
  }
}

/// An image and iso-values with what is to come of them.
struct Case
{
  const char* Name;
  std::function<void(vtkImageData*)> Make;
  std::vector<double> IsoValues;
  bool Points;         ///< whether there are any
  const char* Message; ///< a part of the one message; null if there is to be none
};

/// 6 x 6 x 6 doubles, 0 in the lower and 100 in the upper half; then changed.
std::function<void(vtkImageData*)> Step(const std::function<void(vtkImageData*)>& change = {})
{
  return [change](vtkImageData* image)
  {
    image->ShallowCopy(MakeLayers(VTK_DOUBLE, { 0, 0, 0, 100, 100, 100 }, Geometries[0], 6));
    if (change)
    {
      change(image);
    }
  };
}

std::function<void(vtkImageData*)> Full(int type, double value)
{
  return [=](vtkImageData* image)
  {
    image->ShallowCopy(MakeLayers(type, { 0, 0, 0, 0 }, Geometries[0], 4));
    image->GetPointData()->GetScalars()->Fill(value);
  };
}

std::function<void(vtkImageData*)> Dimensions(int x, int y, int z)
{
  return [=](vtkImageData* image)
  {
    image->SetDimensions(x, y, z);
    image->AllocateScalars(VTK_FLOAT, 1);
    for (vtkIdType n = 0; n < image->GetNumberOfPoints(); ++n)
    {
      image->GetPointData()->GetScalars()->SetComponent(n, 0, static_cast<double>(n % 2));
    }
  };
}

const std::vector<Case> Cases{
  { "empty image", [](vtkImageData*) {}, { 1 }, false, nullptr },
  { "image without scalars", [](vtkImageData* image) { image->SetDimensions(4, 4, 4); }, { 1 }, false,
    "none" },
  { "strings",
    [](vtkImageData* image)
    {
      image->SetDimensions(2, 2, 2);
      vtkNew<vtkStringArray> strings;
      strings->SetName("words");
      strings->SetNumberOfValues(8);
      image->GetPointData()->AddArray(strings);
    },
    { 1 }, false, "words" },
  { "fewer values than points",
    Step([](vtkImageData* image) { image->GetPointData()->GetScalars()->SetNumberOfTuples(100); }), { 50 },
    false, "100" },
  { "one slice", Dimensions(5, 5, 1), { 0.5 }, false, "5 x 5 x 1" },
  { "one row", Dimensions(1, 5, 5), { 0.5 }, false, "1 x 5 x 5" },
  { "one column", Dimensions(5, 1, 5), { 0.5 }, false, "5 x 1 x 5" },
  { "one voxel", Dimensions(1, 1, 1), { 0.5 }, false, "1 x 1 x 1" },
  { "one cell", Dimensions(2, 2, 2), { 0.5 }, true, nullptr },
  { "one cell thick", Dimensions(2, 70, 70), { 0.5 }, true, nullptr },
  { "a long row of cells", Dimensions(2, 2, 5000), { 0.5 }, true, nullptr },
  { "a long row of cells the other way", Dimensions(5000, 2, 2), { 0.5 }, true, nullptr },
  { "no iso-value", Step(), {}, false, "No iso-value" },
  { "constant", Full(VTK_FLOAT, 7), { 7 }, false, "values are 7" },
  { "constant, near the iso-value", Full(VTK_DOUBLE, 7), { 7 + 1e-15 }, false, "values are 7" },
  { "all NaN", Full(VTK_FLOAT, NaN), { 7 }, false, "finite" },
  { "all infinite", Full(VTK_DOUBLE, Infinity), { 7 }, false, "finite" },
  { "a slice of NaN at the step",
    Step(
      [](vtkImageData* image)
      {
        for (vtkIdType n = 72; n < 108; ++n)
        {
          image->GetPointData()->GetScalars()->SetComponent(n, 0, NaN);
        }
      }),
    { 50 }, false, nullptr },
  { "a slice of infinity beside the step",
    Step(
      [](vtkImageData* image)
      {
        for (vtkIdType n = 36; n < 72; ++n)
        {
          image->GetPointData()->GetScalars()->SetComponent(n, 0, -Infinity);
        }
      }),
    { 50 }, true, nullptr },
  { "iso-value below the range", Step(), { -1 }, false, "Expected a value above 0" },
  { "iso-value at the least value", Step(), { 0 }, false, "Expected a value above 0" },
  { "iso-value at the greatest value", Step(), { 100 }, true, nullptr },
  { "iso-value above the range", Step(), { 100.001 }, false, "up to 100" },
  { "iso-values at the ends of double", Step(), { -1.7e308, 1.7e308, -Infinity, Infinity }, false,
    "up to 100" },
  { "iso-value NaN", Step(), { NaN }, false, "NaN" },
  { "iso-value NaN among others", Step(), { NaN, 50 }, true, "NaN" },
  { "the same iso-value a hundred times", Step(), std::vector<double>(100, 50.0), true, nullptr },
  { "no spacing", Step([](vtkImageData* image) { image->SetSpacing(1, 0, 1); }), { 50 }, false, "spacing" },
  { "spacing NaN", Step([](vtkImageData* image) { image->SetSpacing(1, NaN, 1); }), { 50 }, false,
    "cannot be sampled" },
  { "origin infinite", Step([](vtkImageData* image) { image->SetOrigin(1, Infinity, 1); }), { 50 }, false,
    "cannot be sampled" },
  { "directions in a plane",
    Step([](vtkImageData* image) { image->SetDirectionMatrix(1, 0, 0, 0, 1, 0, 0, 1, 0); }), { 50 }, false,
    "irection" },
  { "finer than double at its position",
    Step(
      [](vtkImageData* image)
      {
        image->SetSpacing(1e-12, 1e-12, 1e-12);
        image->SetOrigin(1e7, 1e7, 1e7);
      }),
    { 50 }, true, nullptr },
  { "as large as double", Step([](vtkImageData* image) { image->SetSpacing(1e300, 1e300, 1e300); }), { 50 },
    true, nullptr },
  { "as small as double", Step([](vtkImageData* image) { image->SetSpacing(1e-300, 1e-300, 1e-300); }),
    { 50 }, true, nullptr },
};

void CheckCase(const Case& entry)
{
  for (const int rule : { vtkInkIsoSurfaceSampler::HALF_OPEN, vtkInkIsoSurfaceSampler::STRICT })
  {
    const std::string name = std::string(entry.Name) + (rule ? ", strict" : "");
    vtkNew<vtkImageData> image;
    entry.Make(image);
    vtkNew<vtkInkIsoSurfaceSampler> sampler;
    vtkNew<InkTestMessages> messages;
    messages->Observe(sampler);
    sampler->SetInputData(image);
    sampler->SetCrossingRule(rule);
    for (std::size_t i = 0; i < entry.IsoValues.size(); ++i)
    {
      sampler->SetValue(static_cast<int>(i), entry.IsoValues[i]);
    }
    sampler->Update();
    // By the strict rule a flat part at the iso-value has points as well.
    const vtkIdType found = sampler->GetOutput()->GetNumberOfPoints();
    EXPECT_TRUE(rule || (found > 0) == entry.Points)
      << name << ": " << (entry.Points ? "some" : "no") << " points, found " << found;
    CheckValidPoints(name, sampler->GetOutput());
    const bool justified = entry.Message && (entry.Points || found == 0);
    const std::size_t expected = justified ? 1 : 0;
    const auto& all = messages->Messages;
    EXPECT_EQ(all.size(), expected) << name << ": " << expected << " messages, found " << all.size() << ": "
                                    << (all.empty() ? "" : all[0]);
    if (justified && !all.empty())
    {
      EXPECT_NE(all[0].find(entry.Message), std::string::npos)
        << name << ": a message with \"" << entry.Message << "\", found " << all[0];
    }
  }
}

} // namespace

TEST(IsoSurfaceSamplerExtremes, Ramps)
{
  for (const Ramp& ramp : Ramps)
  {
    for (const Geometry& geometry : Geometries)
    {
      CheckRamp(ramp, geometry);
    }
  }
}

TEST(IsoSurfaceSamplerExtremes, Cases)
{
  for (const Case& entry : Cases)
  {
    CheckCase(entry);
  }
}
