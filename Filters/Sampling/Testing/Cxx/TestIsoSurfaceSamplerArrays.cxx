// SPDX-License-Identifier: BSD-3-Clause
// Every kind of array that can hold the scalars gives the same points.

#include "SamplerTestImages.h"

#include "vtkBitArray.h"
#include "vtkFloatArray.h"
#include "vtkInkIsoSurfaceSampler.h"
#include "vtkNew.h"
#include "vtkSOADataArrayTemplate.h"

#include <gtest/gtest.h>
#if __has_include("vtkAffineArray.h")
#  include "vtkAffineArray.h"
#endif

namespace
{

const std::array<int, 6> Extent = { 0, 12, 0, 11, 0, 10 };

double Hills(double x, double y, double z)
{
  return std::floor(60.0 + 30.0 * std::sin(0.5 * x) * std::cos(0.4 * y) - 3.0 * z);
}

std::vector<Sample> SampleImage(
  vtkImageData* image, double isoValue, int component = 0, int arithmetic = vtkAlgorithm::DOUBLE_PRECISION)
{
  vtkNew<vtkInkIsoSurfaceSampler> sampler;
  sampler->SetArithmeticPrecision(arithmetic);
  sampler->SetInputData(image);
  sampler->SetArrayComponent(component);
  sampler->SetValue(0, isoValue);
  sampler->Update();
  return SamplesOf(sampler->GetOutput());
}

/// The image with its scalars replaced.
vtkSmartPointer<vtkImageData> With(vtkImageData* image, vtkDataArray* scalars)
{
  auto other = vtkSmartPointer<vtkImageData>::New();
  other->CopyStructure(image);
  other->GetPointData()->SetScalars(scalars);
  return other;
}

} // namespace

TEST(IsoSurfaceSamplerArrays, TakesEveryScalarType)
{
  const auto image = MakeImage(VTK_DOUBLE, Extent, Hills);
  const auto expected = SampleImage(image, 40.0);
  EXPECT_GT(expected.size(), 100u) << "some points";

  for (const int type :
    { VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT,
      VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG, VTK_UNSIGNED_LONG_LONG, VTK_ID_TYPE, VTK_FLOAT })
  {
    EXPECT_EQ(SampleImage(MakeImage(type, Extent, Hills), 40.0), expected)
      << "the same points from type " << type;
  }
}

/// The types that single precision holds exactly agree to the last bit, and with the others closely.
TEST(IsoSurfaceSamplerArrays, SinglePrecisionIsTheSameWhereItHoldsTheType)
{
  const auto expected = SampleImage(MakeImage(VTK_DOUBLE, Extent, Hills), 40.0);
  const auto single = [&](int type)
  { return SampleImage(MakeImage(type, Extent, Hills), 40.0, 0, vtkAlgorithm::SINGLE_PRECISION); };
  const auto ofFloat = single(VTK_FLOAT);
  for (const int type : { VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT })
  {
    EXPECT_EQ(single(type), ofFloat) << "the same points in single precision from type " << type;
  }
  for (const int type : { VTK_INT, VTK_UNSIGNED_LONG_LONG, VTK_DOUBLE })
  {
    EXPECT_EQ(single(type), expected) << "the same points in double from type " << type;
  }
  double farthest = ofFloat.size() == expected.size() ? 0.0 : 1e30;
  for (std::size_t n = 0; n < std::min(ofFloat.size(), expected.size()); ++n)
  {
    for (int i = 0; i < 6; ++i)
    {
      farthest = std::max(farthest, std::abs(ofFloat[n][i] - expected[n][i]));
    }
  }
  EXPECT_TRUE(farthest > 0.0 && farthest < 5e-5)
    << "nearly the same points in single precision, off by " << farthest;
}

TEST(IsoSurfaceSamplerArrays, TakesOneOfSeveralComponents)
{
  const auto image = MakeImage(VTK_DOUBLE, Extent, Hills);
  vtkDataArray* heights = image->GetPointData()->GetScalars();
  const vtkIdType count = image->GetNumberOfPoints();
  const auto expected = SampleImage(image, 40.0);
  const auto ofFloat =
    SampleImage(MakeImage(VTK_FLOAT, Extent, Hills), 40.0, 0, vtkAlgorithm::SINGLE_PRECISION);
  vtkNew<vtkFloatArray> interleaved;
  interleaved->SetNumberOfComponents(3);
  interleaved->SetNumberOfTuples(count);
  interleaved->Fill(0.0);
  interleaved->CopyComponent(1, heights, 0);
  EXPECT_EQ(SampleImage(With(image, interleaved), 40.0, 1), expected)
    << "the same points from one of three components";

  vtkNew<vtkSOADataArrayTemplate<float>> apart;
  apart->DeepCopy(interleaved);
  EXPECT_EQ(SampleImage(With(image, interleaved), 40.0, 1, vtkAlgorithm::SINGLE_PRECISION), ofFloat)
    << "the same points in single precision from one of three components";
  EXPECT_EQ(SampleImage(With(image, apart), 40.0, 1), expected)
    << "the same points from components kept apart";
}

TEST(IsoSurfaceSamplerArrays, TakesAnArrayByItsName)
{
  const auto image = MakeImage(VTK_DOUBLE, Extent, Hills);
  const vtkSmartPointer<vtkDataArray> heights = image->GetPointData()->GetScalars();
  const vtkIdType count = image->GetNumberOfPoints();
  const auto expected = SampleImage(image, 40.0);
  vtkNew<vtkFloatArray> zero;
  zero->SetNumberOfTuples(count);
  zero->Fill(0.0);
  const auto both = With(image, zero);
  heights->SetName("Heights");
  both->GetPointData()->AddArray(heights);
  vtkNew<vtkInkIsoSurfaceSampler> sampler;
  sampler->SetArithmeticPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  sampler->SetInputData(both);
  sampler->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Heights");
  sampler->SetValue(0, 40.0);
  sampler->Update();
  EXPECT_EQ(SamplesOf(sampler->GetOutput()), expected) << "the same points from an array by its name";
}

TEST(IsoSurfaceSamplerArrays, TakesBits)
{
  const auto image = MakeImage(VTK_DOUBLE, Extent, Hills);
  vtkDataArray* heights = image->GetPointData()->GetScalars();
  const vtkIdType count = image->GetNumberOfPoints();
  const auto expected = SampleImage(image, 40.0);
  vtkNew<vtkBitArray> bits;
  bits->SetNumberOfTuples(count);
  vtkNew<vtkFloatArray> zeroOrOne;
  zeroOrOne->SetNumberOfTuples(count);
  for (vtkIdType n = 0; n < count; ++n)
  {
    const int bit = heights->GetComponent(n, 0) >= 40.0;
    bits->SetValue(n, bit);
    zeroOrOne->SetValue(n, static_cast<float>(bit));
  }
  const auto ofBits = SampleImage(With(image, bits), 0.5);
  EXPECT_TRUE(ofBits.size() == expected.size() && ofBits == SampleImage(With(image, zeroOrOne), 0.5))
    << "the same points from bits";
}

#if __has_include("vtkAffineArray.h")
TEST(IsoSurfaceSamplerArrays, TakesImplicitArrays)
{
  const auto image = MakeImage(VTK_DOUBLE, Extent, Hills);
  const vtkIdType count = image->GetNumberOfPoints();
  vtkNew<vtkAffineArray<float>> implicit;
  implicit->SetNumberOfTuples(count);
  implicit->ConstructBackend(0.5f, 3.0f);
  vtkNew<vtkFloatArray> explicitly;
  explicitly->DeepCopy(implicit);
  const auto ofImplicit = SampleImage(With(image, implicit), 200.0);
  EXPECT_TRUE(!ofImplicit.empty() && ofImplicit == SampleImage(With(image, explicitly), 200.0))
    << "the same points from an array that is a function";
}
#endif
