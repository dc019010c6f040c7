// SPDX-License-Identifier: BSD-3-Clause
// vtkInkGradient on thousands of small random images against plain implementations in long double, and parts
// of an image against the whole. A hundred images are a test, named by the first one's seed.

#include "GradientReference.h"
#include "InkTestMessages.h"
#include "RandomImages.h"

#include "Fields/Grid/GridField.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInkGradient.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <span>
#include <string>
#include <type_traits>

namespace
{

using ink::testing::Wide;
using ink::testing::WideMatrix;
using ink::testing::WideVector;

constexpr unsigned Images = 2000;
constexpr unsigned ImagesOfTest = 100;

const char* const Names[] = { "Gradient", "GradientMagnitude", "Value", "Laplacian" };

void SetUp(vtkInkGradient* filter, InkTestRandom& random, int components)
{
  filter->SetMethod(random.Once(4) ? vtkInkGradient::CENTRAL_DIFFERENCE : vtkInkGradient::REGRESSION);
  filter->SetNeighborhood(random.UpTo(2));
  filter->SetWeighting(random.UpTo(2));
  filter->SetComputeGradient(!random.Once(8));
  filter->SetComputeGradientMagnitude(random.Once(2));
  filter->SetComputeValue(random.Once(2));
  filter->SetComputeLaplacian(random.Once(2));
  filter->SetLaplacianScale(random.Once(4) ? 0.0 : random.Magnitude(-1, 0.7));
  filter->SetLaplacianScaleUnit(random.UpTo(2));
  filter->SetArrayComponent(random.UpTo(components));
  filter->SetOutputArraysPrecision(random.UpTo(2));
}

std::string Describe(vtkInkGradient* filter)
{
  return std::string(filter->GetMethod() == vtkInkGradient::REGRESSION ? ", regression" : ", differences") +
    (filter->GetNeighborhood() == vtkInkGradient::NEIGHBORHOOD_3 ? " 3" : " 5") +
    (filter->GetWeighting() == vtkInkGradient::UNIFORM ? " uniform" : " by distance") + ", scale " +
    std::to_string(filter->GetLaplacianScale()) +
    (filter->GetOutputArraysPrecision() == vtkAlgorithm::SINGLE_PRECISION ? ", float" : ", double");
}

/// Compares numbers of an output array with references.
class Comparison
{
public:
  Comparison(std::string name, bool doubles)
    : Name(std::move(name))
    , Doubles(doubles)
  {
  }

  /// `slack` is what rounding what went into it may do.
  bool operator()(const char* array, const glm::ivec3& sample, double found, Wide expected, Wide slack)
  {
    // Beyond the type there is its largest value.
    const Wide largest =
      this->Doubles ? std::numeric_limits<double>::max() : std::numeric_limits<float>::max();
    const Wide least = this->Doubles ? std::numeric_limits<double>::min() : std::numeric_limits<float>::min();
    const Wide wanted = std::clamp(expected, -largest, largest);
    const Wide tolerance = slack + 4.0L * this->epsilon() * std::abs(wanted) + 4.0L * least;
    const bool near = std::abs(static_cast<Wide>(found) - wanted) <= tolerance;
    EXPECT_TRUE(near) << this->Name << ": " << array << " at " << sample.x << " " << sample.y << " "
                      << sample.z << " within " << static_cast<double>(tolerance) << " of "
                      << static_cast<double>(wanted) << ", found " << found;
    return near;
  }

  Wide epsilon() const
  {
    return this->Doubles ? std::numeric_limits<double>::epsilon() : std::numeric_limits<float>::epsilon();
  }

private:
  std::string Name;
  bool Doubles;
};

/// Gradients, magnitudes and values.
template <class T>
bool CompareGradients(Comparison& compare, vtkInkGradient* filter, const ink::GridField<T>& field,
  vtkDataArray* const (&arrays)[4], const glm::ivec3& sample)
{
  const ink::testing::ReferenceGradient reference = filter->GetMethod() == vtkInkGradient::CENTRAL_DIFFERENCE
    ? ink::testing::referenceCentralDifference(field, sample)
    : ink::testing::referenceRegression(field, filter->GetNeighborhood() + 1,
        filter->GetWeighting() == vtkInkGradient::INVERSE_DISTANCE, sample);
  // Sums are taken in single precision where nothing in and out is wider.
  const bool narrow = (std::is_same_v<T, float> || sizeof(T) <= 2) &&
    filter->GetOutputArraysPrecision() == vtkAlgorithm::SINGLE_PRECISION;
  const Wide rounding =
    narrow ? std::numeric_limits<float>::epsilon() : std::numeric_limits<double>::epsilon();
  const Wide share = 8.0L * rounding + 64.0L * std::numeric_limits<double>::epsilon() * reference.condition;

  const WideMatrix toWorld = ink::testing::gradientToWorld(field.geometry());
  const WideVector gradient = toWorld * reference.gradient;
  WideVector slack(0.0L);
  for (int axis = 0; axis < 3; ++axis)
  {
    // An element of the matrix that should be 0 is so but for rounding of the others.
    const WideVector column = glm::abs(toWorld[axis]);
    slack += WideVector(std::max({ column.x, column.y, column.z })) * 64.0L *
      static_cast<Wide>(std::numeric_limits<double>::epsilon()) * reference.gradientTerms[axis];
    slack += glm::abs(toWorld[axis]) *
      (share * reference.gradientTerms[axis] + 4.0L * compare.epsilon() * std::abs(reference.gradient[axis]));
  }
  const vtkIdType n = static_cast<vtkIdType>(field.geometry().offset(sample));
  bool right = true;
  // What is too large for a double per step counts as the largest one.
  const WideVector perStep = glm::abs(reference.gradient);
  const bool exists = std::max({ perStep.x, perStep.y, perStep.z }) <= std::numeric_limits<double>::max();
  for (int axis = 0; axis < 3 && arrays[0] && exists; ++axis)
  {
    right = right && compare(Names[0], sample, arrays[0]->GetComponent(n, axis), gradient[axis], slack[axis]);
  }
  right = right &&
    (!arrays[1] || !exists ||
      compare(
        Names[1], sample, arrays[1]->GetComponent(n, 0), glm::length(gradient), slack.x + slack.y + slack.z));
  return right &&
    (!arrays[2] ||
      compare(
        Names[2], sample, arrays[2]->GetComponent(n, 0), reference.value, share * reference.valueTerms));
}

template <class T>
glm::dvec3 DeviationOf(vtkInkGradient* filter, const ink::GridField<T>& field)
{
  glm::dvec3 deviation(filter->GetLaplacianScale());
  for (int axis = 0; axis < 3; ++axis)
  {
    if (filter->GetLaplacianScaleUnit() == vtkInkGradient::WORLD_UNITS)
    {
      deviation[axis] /= glm::length(field.geometry().direction()[axis] * field.geometry().spacing()[axis]);
    }
    deviation[axis] = std::min(deviation[axis], 16.0);
  }
  return deviation;
}

template <class T>
bool CompareLaplacians(Comparison& compare, vtkInkGradient* filter, const ink::GridField<T>& field,
  vtkDataArray* laplacian, Wide largest)
{
  const ink::testing::ReferenceLaplacian<T> reference(field, DeviationOf(filter, field));
  const WideMatrix toWorld = ink::testing::gradientToWorld(field.geometry());
  Wide factors = 0.0L;
  for (int axis = 0; axis < 3; ++axis)
  {
    factors += glm::dot(toWorld[axis], toWorld[axis]);
  }
  // Normal equations of parabolas lose some digits.
  const Wide slack = 1e-11L * largest * factors;
  const glm::ivec3 size = field.geometry().dimensions();
  bool right = true;
  for (vtkIdType n = 0; n < laplacian->GetNumberOfTuples() && right; ++n)
  {
    const int at = static_cast<int>(n);
    const glm::ivec3 sample(at % size.x, at / size.x % size.y, at / size.x / size.y);
    const Wide expected = reference.at(sample);
    right =
      compare(Names[3], sample, laplacian->GetComponent(n, 0), expected, field.has(sample) ? slack : 0.0L);
  }
  return right;
}

/// A part asked for alone has the bits that it has in the whole.
void ComparePart(const std::string& name, vtkInkGradient* filter, vtkImageData* whole, InkTestRandom& random)
{
  int extent[6];
  whole->GetExtent(extent);
  for (int axis = 0; axis < 3; ++axis)
  {
    const int first = extent[2 * axis] + random.UpTo(extent[2 * axis + 1] - extent[2 * axis] + 1);
    extent[2 * axis + 1] = first + random.UpTo(extent[2 * axis + 1] - first + 1);
    extent[2 * axis] = first;
  }
  filter->UpdateExtent(extent);
  vtkImageData* part = filter->GetOutput();
  for (const char* array : Names)
  {
    vtkDataArray* all = whole->GetPointData()->GetArray(array);
    vtkDataArray* some = part->GetPointData()->GetArray(array);
    bool same = !all == !some;
    for (vtkIdType n = 0; all && same && n < part->GetNumberOfPoints(); ++n)
    {
      int sample[3] = { 0, 0, 0 };
      const int* own = part->GetExtent();
      const vtkIdType width = own[1] - own[0] + 1;
      const vtkIdType height = own[3] - own[2] + 1;
      sample[0] = own[0] + static_cast<int>(n % width);
      sample[1] = own[2] + static_cast<int>(n / width % height);
      sample[2] = own[4] + static_cast<int>(n / width / height);
      for (int c = 0; c < all->GetNumberOfComponents(); ++c)
      {
        same = same && some->GetComponent(n, c) == all->GetComponent(whole->ComputePointId(sample), c);
      }
    }
    EXPECT_TRUE(same) << name << ": " << array << " of a part as in the whole";
  }
}

template <class T>
void CheckImage(unsigned seed, int type)
{
  InkTestRandom random(seed);
  // Mostly all border; some with an inside in which whole rows are worked on.
  const int most = random.Once(4) ? 12 : 6;
  const glm::ivec3 dimensions(1 + random.UpTo(most), 1 + random.UpTo(most), 1 + random.UpTo(most));
  const ink::GridGeometry geometry = RandomGeometry(random, dimensions, false);
  const vtkSmartPointer<vtkImageData> image = MakeImage(geometry);
  const int components = 1 + (random.Once(4) ? random.UpTo(3) : 0);
  image->AllocateScalars(type, components);
  const auto count = static_cast<std::size_t>(image->GetNumberOfPoints());
  const std::span<T> values(static_cast<T*>(image->GetScalarPointer()), count * components);
  const int kind = random.UpTo(4);
  const int levels = 2 + random.UpTo(6);
  const int missing = std::is_floating_point_v<T> && random.Once(3) ? 5 + random.UpTo(40) : 0;
  FillRandomly(values, random, kind, levels, missing);
  ink::ElementMarks hidden;
  vtkSmartPointer<vtkUnsignedCharArray> marks;
  if (random.Once(4))
  {
    // Points that other pieces have as well count.
    const unsigned char mark =
      random.Once(2) ? vtkDataSetAttributes::HIDDENPOINT : vtkDataSetAttributes::DUPLICATEPOINT;
    marks = RandomMarks(random, image->GetNumberOfPoints(), mark, 3 + random.UpTo(30));
    image->GetPointData()->AddArray(marks);
    hidden = { { marks->GetPointer(0), count }, vtkDataSetAttributes::HIDDENPOINT };
  }

  vtkNew<vtkInkGradient> filter;
  vtkNew<InkTestMessages> messages;
  messages->Observe(filter);
  SetUp(filter, random, components);
  filter->SetInputData(image);
  filter->Update();
  const std::string name =
    "seed " + std::to_string(seed) + ", " + vtkImageScalarTypeNameMacro(type) + Describe(filter);
  vtkNew<vtkImageData> output;
  output->DeepCopy(filter->GetOutput());
  ASSERT_TRUE(messages->Messages.empty())
    << name << ": no message, found " << (messages->Messages.empty() ? "" : messages->Messages[0]);

  const bool wanted[] = { filter->GetComputeGradient(), filter->GetComputeGradientMagnitude(),
    filter->GetComputeValue(), filter->GetComputeLaplacian() };
  vtkDataArray* arrays[4];
  for (int n = 0; n < 4; ++n)
  {
    arrays[n] = output->GetPointData()->GetArray(Names[n]);
    ASSERT_EQ(arrays[n] != nullptr, wanted[n]) << name << ": " << Names[n] << (wanted[n] ? "" : " not");
    ASSERT_TRUE(!arrays[n] ||
      (arrays[n]->GetNumberOfTuples() == output->GetNumberOfPoints() &&
        output->GetNumberOfPoints() == image->GetNumberOfPoints()))
      << name << ": " << count << " values in " << Names[n] << ", found " << arrays[n]->GetNumberOfTuples();
  }
  const ink::GridField<T> field(geometry,
    std::span<const T>(values).subspan(static_cast<std::size_t>(filter->GetArrayComponent())),
    static_cast<std::size_t>(components), hidden);
  Comparison compare(name, filter->GetOutputArraysPrecision() == vtkAlgorithm::DOUBLE_PRECISION);
  Wide largest = 0.0L;
  bool right = true;
  for (int k = 0; k < dimensions.z && right; ++k)
  {
    for (int j = 0; j < dimensions.y && right; ++j)
    {
      for (int i = 0; i < dimensions.x && right; ++i)
      {
        const glm::ivec3 sample(i, j, k);
        right =
          !(wanted[0] || wanted[1] || wanted[2]) || CompareGradients(compare, filter, field, arrays, sample);
        largest =
          field.has(sample) ? std::max(largest, std::abs(static_cast<Wide>(field.at(sample)))) : largest;
      }
    }
  }
  if (right && (!arrays[3] || CompareLaplacians(compare, filter, field, arrays[3], largest)))
  {
    ComparePart(name, filter, output, random);
  }
}

void CheckSeed(unsigned seed)
{
  WithScalarType(seed, [&](auto zero, int type) { CheckImage<decltype(zero)>(seed, type); });
}

class GradientRandom : public testing::TestWithParam<unsigned>
{
};

} // namespace

TEST_P(GradientRandom, IsTheReferences)
{
  for (unsigned seed = GetParam(); seed < GetParam() + ImagesOfTest && !HasFailure(); ++seed)
  {
    CheckSeed(seed);
  }
}

INSTANTIATE_TEST_SUITE_P(
  Images, GradientRandom, testing::Range(0u, Images, ImagesOfTest), testing::PrintToStringParamName());
