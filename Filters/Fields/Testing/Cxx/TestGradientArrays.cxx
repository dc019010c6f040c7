// SPDX-License-Identifier: BSD-3-Clause
// Which arrays the filter takes and which it makes: any scalar type and component, chosen arrays, arrays that
// are not contiguous, hidden points, what is passed on, and memory that is used again.

#include "GradientTestImages.h"

#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkInkGradient.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <limits>

namespace
{

const std::array<int, 6> Extent = { 0, 9, 0, 8, 0, 7 };

/// 2 i - j + 3 k + 30 of the point's index: representable in every type.
double IndexPlane(vtkIdType n)
{
  return 2.0 * (n % 10) - n / 10 % 9 + 3.0 * (n / 90) + 30.0;
}

vtkSmartPointer<vtkImageData> MakeIndexImage(int type)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(const_cast<int*>(Extent.data()));
  image->AllocateScalars(type, 1);
  image->GetPointData()->GetScalars()->SetName("Density");
  for (vtkIdType n = 0; n < image->GetNumberOfPoints(); ++n)
  {
    image->GetPointData()->GetScalars()->SetComponent(n, 0, IndexPlane(n));
  }
  return image;
}

/// How far the gradients are from (2, -1, 3), at most.
double PlaneError(vtkImageData* image)
{
  vtkDataArray* gradient = image->GetPointData()->GetArray("Gradient");
  if (!gradient || gradient->GetNumberOfTuples() != image->GetNumberOfPoints())
  {
    return VTK_DOUBLE_MAX;
  }
  double error = 0.0;
  const double expected[3] = { 2.0, -1.0, 3.0 };
  for (vtkIdType n = 0; n < gradient->GetNumberOfTuples(); ++n)
  {
    for (int c = 0; c < 3; ++c)
    {
      error = std::max(error, std::abs(gradient->GetComponent(n, c) - expected[c]));
    }
  }
  return error;
}

} // namespace

TEST(GradientArrays, TakesEveryScalarType)
{
  for (const int type : { VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT,
         VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG, VTK_UNSIGNED_LONG_LONG,
         VTK_FLOAT, VTK_DOUBLE, VTK_ID_TYPE })
  {
    for (const int precision : { vtkAlgorithm::SINGLE_PRECISION, vtkAlgorithm::DOUBLE_PRECISION })
    {
      vtkNew<vtkInkGradient> filter;
      filter->SetInputData(MakeIndexImage(type));
      filter->SetOutputArraysPrecision(precision);
      filter->Update();
      const double error = PlaneError(filter->GetOutput());
      EXPECT_LT(error, 1e-5) << "the plane's gradient for VTK type " << type;
      const int found = filter->GetOutput()->GetPointData()->GetArray("Gradient")->GetDataType();
      EXPECT_EQ(found, precision == vtkAlgorithm::SINGLE_PRECISION ? VTK_FLOAT : VTK_DOUBLE)
        << "the output type asked for";
    }
  }
}

TEST(GradientArrays, TakesTheChosenComponent)
{
  // An array that is not the active one, its second component, laid out component by component.
  auto image = MakeIndexImage(VTK_UNSIGNED_CHAR);
  image->GetPointData()->GetScalars()->Fill(7.0);
  vtkNew<vtkSOADataArrayTemplate<float>> apart;
  apart->SetName("Apart");
  apart->SetNumberOfComponents(2);
  apart->SetNumberOfTuples(image->GetNumberOfPoints());
  for (vtkIdType n = 0; n < image->GetNumberOfPoints(); ++n)
  {
    apart->SetTypedComponent(n, 0, 1.0f);
    apart->SetTypedComponent(n, 1, static_cast<float>(IndexPlane(n)));
  }
  image->GetPointData()->AddArray(apart);
  vtkNew<vtkInkGradient> filter;
  filter->SetInputData(image);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Apart");
  filter->SetArrayComponent(1);
  filter->Update();
  EXPECT_LT(PlaneError(filter->GetOutput()), 1e-5) << "the gradient of the chosen component";
}

TEST(GradientArrays, PassesTheInputsArraysOn)
{
  auto image = MakeIndexImage(VTK_FLOAT);
  vtkNew<vtkIntArray> cells;
  cells->SetName("OfCells");
  cells->SetNumberOfValues(image->GetNumberOfCells());
  cells->Fill(3.0);
  image->GetCellData()->AddArray(cells);
  vtkNew<vtkIntArray> fields;
  fields->SetName("OfAll");
  image->GetFieldData()->AddArray(fields);
  vtkNew<vtkInkGradient> filter;
  filter->SetInputData(image);
  filter->Update();
  vtkImageData* output = filter->GetOutput();
  EXPECT_EQ(output->GetPointData()->GetScalars(), image->GetPointData()->GetScalars())
    << "the input's scalars, not copied";
  EXPECT_EQ(output->GetCellData()->GetArray("OfCells"), cells) << "the input's cell data";
  EXPECT_EQ(output->GetFieldData()->GetAbstractArray("OfAll"), fields) << "the input's field data";
  EXPECT_EQ(output->GetPointData()->GetNumberOfArrays(), 3) << "Density, Gradient and GradientMagnitude";
  filter->ComputeGradientOff();
  filter->ComputeGradientMagnitudeOff();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetNumberOfArrays(), 1)
    << "nothing where nothing is asked for";
}

TEST(GradientArrays, MissingPointsHaveNoGradient)
{
  auto image = MakeIndexImage(VTK_FLOAT);
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  scalars->SetComponent(345, 0, std::numeric_limits<double>::quiet_NaN());
  scalars->SetComponent(400, 0, std::numeric_limits<double>::infinity());
  scalars->SetComponent(410, 0, 1e6);
  image->AllocatePointGhostArray();
  image->GetPointGhostArray()->SetValue(410, vtkDataSetAttributes::HIDDENPOINT);
  vtkNew<vtkInkGradient> filter;
  filter->SetInputData(image);
  filter->ComputeLaplacianOn();
  filter->ComputeValueOn();
  filter->Update();
  vtkPointData* data = filter->GetOutput()->GetPointData();
  for (const vtkIdType n : { 345, 400, 410 })
  {
    for (const char* name : { "Gradient", "GradientMagnitude", "Value", "Laplacian" })
    {
      EXPECT_EQ(data->GetArray(name)->GetComponent(n, 0), 0.0) << name << " is 0 at a missing point";
      data->GetArray("Gradient")->SetTuple3(n, 2.0, -1.0, 3.0);
    }
  }
  EXPECT_LT(PlaneError(filter->GetOutput()), 1e-4) << "beside them the plane's gradient";
}

TEST(GradientArrays, ReusesOnlyMemoryThatNobodyHolds)
{
  auto image = MakeIndexImage(VTK_FLOAT);
  vtkNew<vtkInkGradient> filter;
  filter->SetInputData(image);
  filter->Update();
  vtkDataArray* first = filter->GetOutput()->GetPointData()->GetArray("Gradient");
  filter->SetWeightingToInverseDistance();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetArray("Gradient"), first)
    << "memory that no one else holds is used again";
  vtkSmartPointer<vtkDataArray> held = filter->GetOutput()->GetPointData()->GetArray("Gradient");
  vtkNew<vtkFloatArray> copy;
  copy->DeepCopy(held);
  image->GetPointData()->GetScalars()->SetComponent(444, 0, 1000.0);
  image->Modified();
  filter->Modified();
  filter->Update();
  EXPECT_NE(filter->GetOutput()->GetPointData()->GetArray("Gradient"), held)
    << "memory that someone holds is left alone";
  EXPECT_EQ(LargestDifference(held, copy), 0.0) << "and not written to";
}
