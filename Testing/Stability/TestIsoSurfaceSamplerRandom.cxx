// SPDX-License-Identifier: BSD-3-Clause
// vtkInkIsoSurfaceSampler on thousands of small random images against a plain implementation, in one piece
// and in several. A hundred images are a test, named by the first one's seed.

#include "InkTestMessages.h"
#include "IsoSurfaceReference.h"
#include "RandomImages.h"
#include "StabilityChecks.h"

#include "Fields/Grid/GridField.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInkIsoSurfaceSampler.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace
{

constexpr unsigned Images = 3000;
constexpr unsigned ImagesOfTest = 100;

struct Description
{
  std::string Name;
  int Rule;
  int Precision;
  int Component;
  int NormalMethod;
  std::vector<double> IsoValues;
};

/// One point against the reference, in samples, where all cells are alike.
bool CheckPoint(const std::string& name, vtkPolyData* output, vtkIdType n,
  const ink::testing::ReferenceSample& expected, const ink::GridGeometry& geometry)
{
  double point[3];
  output->GetPoint(n, point);
  const glm::dvec3 world(point[0], point[1], point[2]);
  const bool doubles = output->GetPoints()->GetDataType() == VTK_DOUBLE;
  const double epsilon =
    doubles ? std::numeric_limits<double>::epsilon() : std::numeric_limits<float>::epsilon();
  const glm::dvec3 right = geometry.toWorld(expected.index);
  glm::dvec3 tolerance(2e-5);
  for (int axis = 0; axis < 3; ++axis)
  {
    // What rounding a coordinate means in samples.
    glm::dvec3 step(0.0);
    step[axis] = 2 * epsilon * (std::abs(right[axis]) + std::abs(geometry.origin()[axis]));
    tolerance += glm::abs(geometry.toIndex(right + step) - geometry.toIndex(right));
  }
  const glm::dvec3 off = glm::abs(geometry.toIndex(world) - expected.index);
  const bool near = off.x <= tolerance.x && off.y <= tolerance.y && off.z <= tolerance.z;
  EXPECT_TRUE(near) << name << ": point " << n << " at " << expected.index.x << " " << expected.index.y << " "
                    << expected.index.z << " in samples, off by " << off.x << " " << off.y << " " << off.z;
  return near;
}

/// A normal by central differences against the reference, unless it is a matter of rounding.
bool CheckNormal(
  const std::string& name, vtkPolyData* output, vtkIdType n, const ink::testing::ReferenceSample& expected)
{
  const double length = glm::length(expected.direction);
  const double normalTolerance =
    1e-4 + (expected.directionError + 1e-4 * (1 - std::min(length, 1.0))) / length;
  // Elsewhere the direction is a matter of rounding; it has the length 1 all the same.
  if (!(normalTolerance < 0.1))
  {
    return true;
  }
  double normal[3];
  output->GetPointData()->GetNormals()->GetTuple(n, normal);
  const double error =
    glm::distance(glm::dvec3(normal[0], normal[1], normal[2]), -expected.direction / length);
  EXPECT_LE(error, normalTolerance) << name << ": normal " << n;
  return error <= normalTolerance;
}

/// Points and normals in their order.
std::vector<double> Numbers(vtkPolyData* output)
{
  std::vector<double> all;
  for (vtkIdType n = 0; n < output->GetNumberOfPoints(); ++n)
  {
    double triple[3];
    output->GetPoint(n, triple);
    all.insert(all.end(), triple, triple + 3);
    output->GetPointData()->GetNormals()->GetTuple(n, triple);
    all.insert(all.end(), triple, triple + 3);
  }
  return all;
}

std::vector<std::vector<double>> SortedSamples(const std::vector<double>& numbers)
{
  std::vector<std::vector<double>> samples;
  for (std::size_t n = 0; n < numbers.size(); n += 6)
  {
    samples.emplace_back(
      numbers.begin() + static_cast<std::ptrdiff_t>(n), numbers.begin() + static_cast<std::ptrdiff_t>(n + 6));
  }
  std::sort(samples.begin(), samples.end());
  return samples;
}

template <class T>
void CheckImage(unsigned seed, int type)
{
  InkTestRandom random(seed);
  const glm::ivec3 dimensions(2 + random.UpTo(9), 2 + random.UpTo(7), 2 + random.UpTo(7));
  const ink::GridGeometry geometry = RandomGeometry(random, dimensions, true);
  const vtkSmartPointer<vtkImageData> image = MakeImage(geometry);
  const int components = 1 + (random.Once(4) ? random.UpTo(3) : 0);
  image->AllocateScalars(type, components);
  const auto count = static_cast<std::size_t>(image->GetNumberOfPoints());
  const std::span<T> values(static_cast<T*>(image->GetScalarPointer()), count * components);
  const int kind = random.UpTo(4);
  const int levels = 2 + random.UpTo(6);
  const int missing = std::is_floating_point_v<T> && random.Once(3) ? 5 : 0;
  FillRandomly(values, random, kind, levels, missing);
  vtkSmartPointer<vtkUnsignedCharArray> hiddenPoints;
  if (random.Once(4))
  {
    hiddenPoints = RandomMarks(random, image->GetNumberOfPoints(), vtkDataSetAttributes::HIDDENPOINT, 4);
    image->GetPointData()->AddArray(hiddenPoints);
  }
  vtkSmartPointer<vtkUnsignedCharArray> skippedCells;
  if (random.Once(4))
  {
    skippedCells = RandomMarks(random, image->GetNumberOfCells(),
      random.Once(2) ? vtkDataSetAttributes::HIDDENCELL : vtkDataSetAttributes::REFINEDCELL, 10);
    image->GetCellData()->AddArray(skippedCells);
  }

  Description run;
  run.Rule = random.UpTo(2);
  run.Precision = random.UpTo(3);
  run.Component = random.UpTo(components);
  run.NormalMethod = random.Once(3) ? random.UpTo(4) : vtkInkIsoSurfaceSampler::INTERPOLATED_NORMAL;
  for (int i = 1 + random.UpTo(3); i > 0; --i)
  {
    // Often exactly a value, or half way to another, or any.
    const auto value = [&]
    {
      return static_cast<double>(
        values[static_cast<std::size_t>(random.UpTo(static_cast<int>(values.size())))]);
    };
    const double a = value();
    const double iso = random.Once(2) ? a : random.Once(5) ? a * random.Share() : a / 2 + value() / 2;
    run.IsoValues.push_back(std::isfinite(iso) ? iso : 1.0);
  }
  run.Name = "seed " + std::to_string(seed) + ", " + vtkImageScalarTypeNameMacro(type);

  vtkNew<vtkInkIsoSurfaceSampler> sampler;
  vtkNew<InkTestMessages> messages;
  messages->Observe(sampler);
  sampler->SetInputData(image);
  sampler->SetCrossingRule(run.Rule);
  sampler->SetOutputPointsPrecision(run.Precision);
  sampler->SetArrayComponent(run.Component);
  sampler->SetNormalMethod(run.NormalMethod);
  sampler->SetArithmeticPrecision(random.UpTo(2));
  sampler->SetUseIndex(random.Once(2));
  for (std::size_t i = 0; i < run.IsoValues.size(); ++i)
  {
    sampler->SetValue(static_cast<int>(i), run.IsoValues[i]);
  }
  sampler->Update();
  vtkPolyData* output = sampler->GetOutput();
  // That no value lies beyond the iso-value is said.
  const bool silent = messages->Messages.empty() || output->GetNumberOfPoints() == 0;
  ASSERT_TRUE(silent) << run.Name << ": no message, found "
                      << (messages->Messages.empty() ? "" : messages->Messages[0]);
  if (!CheckValidPoints(run.Name, output))
  {
    return;
  }

  const auto marksOf = [](vtkUnsignedCharArray* marks, std::uint8_t mask)
  {
    return marks
      ? ink::ElementMarks{ { marks->GetPointer(0), static_cast<std::size_t>(marks->GetNumberOfValues()) },
          mask }
      : ink::ElementMarks{};
  };
  const ink::GridField<T> field(geometry,
    std::span<const T>(values).subspan(static_cast<std::size_t>(run.Component)),
    static_cast<std::size_t>(components), marksOf(hiddenPoints, vtkDataSetAttributes::HIDDENPOINT));
  const auto rule =
    run.Rule == vtkInkIsoSurfaceSampler::STRICT ? ink::CrossingRule::Strict : ink::CrossingRule::HalfOpen;
  vtkDataArray* indices = output->GetPointData()->GetArray("SurfaceIndex");
  EXPECT_EQ(indices != nullptr, run.IsoValues.size() > 1)
    << run.Name << ": SurfaceIndex with several iso-values";
  vtkIdType n = 0;
  int surface = 0;
  for (const double isoValue : run.IsoValues)
  {
    const auto expected = ink::testing::referenceSamples(field, isoValue, rule,
      marksOf(skippedCells, vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::REFINEDCELL));
    const std::string name =
      run.Name + ", iso-value " + std::to_string(isoValue) + (run.Rule ? ", strict" : "");
    ASSERT_LE(n + static_cast<vtkIdType>(expected.size()), output->GetNumberOfPoints())
      << name << ": " << expected.size() << " points, found " << output->GetNumberOfPoints() - n
      << " or less";
    for (const auto& sample : expected)
    {
      if (!CheckPoint(name, output, n, sample, geometry) ||
        (run.NormalMethod == vtkInkIsoSurfaceSampler::INTERPOLATED_NORMAL &&
          !CheckNormal(name, output, n, sample)))
      {
        return;
      }
      ASSERT_TRUE(!indices || indices->GetComponent(n, 0) == surface)
        << name << ": SurfaceIndex " << surface << " of point " << n;
      ++n;
    }
    ++surface;
  }
  ASSERT_EQ(n, output->GetNumberOfPoints())
    << run.Name << ": " << n << " points, found " << output->GetNumberOfPoints();

  // In pieces: exactly the same points.
  const auto expectPieces = [&](const std::vector<double>& whole, const char* what)
  {
    const int pieces = 2 + random.UpTo(4);
    std::vector<double> all;
    for (int piece = 0; piece < pieces; ++piece)
    {
      sampler->UpdatePiece(piece, pieces, random.UpTo(2));
      const auto part = Numbers(sampler->GetOutput());
      all.insert(all.end(), part.begin(), part.end());
    }
    EXPECT_EQ(SortedSamples(all), SortedSamples(whole))
      << run.Name << what << ": " << whole.size() / 6 << " points in " << pieces << " pieces, found "
      << all.size() / 6 << " or others";
  };
  const std::vector<double> whole = Numbers(output);
  expectPieces(whole, "");
  sampler->SetProjectionSteps(1 + random.UpTo(8));
  sampler->UpdatePiece(0, 1, 0);
  const std::vector<double> projected = Numbers(output);
  ASSERT_EQ(projected.size(), whole.size()) << run.Name << ": as many points projected";
  if (CheckValidPoints(run.Name + ", projected", output))
  {
    expectPieces(projected, ", projected");
  }

  // Smoothed and divided.
  sampler->SetProjectionSteps(random.UpTo(1));
  sampler->SetSmoothing(0.25 * random.UpTo(6));
  sampler->SetSmoothingTarget(random.UpTo(1));
  sampler->SetSubdivision(1 + random.UpTo(2));
  sampler->SetShapeBasedInterpolation(random.UpTo(1) == 1);
  sampler->UpdatePiece(0, 1, 0);
  const std::vector<double> smoothed = Numbers(output);
  if (CheckValidPoints(run.Name + ", smoothed", output))
  {
    expectPieces(smoothed, ", smoothed");
  }
}

void CheckSeed(unsigned seed)
{
  WithScalarType(seed, [&](auto zero, int type) { CheckImage<decltype(zero)>(seed, type); });
}

class IsoSurfaceSamplerRandom : public testing::TestWithParam<unsigned>
{
};

} // namespace

TEST_P(IsoSurfaceSamplerRandom, IsTheReferences)
{
  for (unsigned seed = GetParam(); seed < GetParam() + ImagesOfTest && !HasFailure(); ++seed)
  {
    CheckSeed(seed);
  }
}

INSTANTIATE_TEST_SUITE_P(Images, IsoSurfaceSamplerRandom, testing::Range(0u, Images, ImagesOfTest),
  testing::PrintToStringParamName());
