// SPDX-License-Identifier: BSD-3-Clause
#include "InkTestMessages.h"
#include "InkTestVolume.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkImageAlgorithm.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkInkCrop.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace
{

double Code(double x, double y, double z)
{
  return x + 100.0 * y + 10000.0 * z;
}

/// Values say where they are.
vtkSmartPointer<vtkImageData> MakeImage()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(-2, 17, 3, 14, 0, 9);
  image->SetSpacing(0.5, 1.0, 2.0);
  image->SetOrigin(10.0, 20.0, 30.0);
  InkTestFill(image, VTK_DOUBLE, Code);
  return image;
}

/// Makes parts of that image, and remembers the last.
class PartSource : public vtkImageAlgorithm
{
public:
  static PartSource* New();
  vtkTypeMacro(PartSource, vtkImageAlgorithm);
  std::array<int, 6> Asked{};

protected:
  PartSource() { this->SetNumberOfInputPorts(0); }
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* output) override
  {
    vtkInformation* info = output->GetInformationObject(0);
    const auto image = MakeImage();
    info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), image->GetExtent(), 6);
    info->Set(vtkDataObject::ORIGIN(), image->GetOrigin(), 3);
    info->Set(vtkDataObject::SPACING(), image->GetSpacing(), 3);
    info->Set(CAN_PRODUCE_SUB_EXTENT(), 1);
    return 1;
  }
  void ExecuteDataWithInformation(vtkDataObject* output, vtkInformation* info) override
  {
    info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), this->Asked.data());
    vtkNew<vtkImageData> image;
    image->CopyStructure(MakeImage());
    image->SetExtent(this->Asked.data());
    InkTestFill(image.Get(), VTK_DOUBLE, Code);
    output->ShallowCopy(image);
  }
};
vtkStandardNewMacro(PartSource);

/// Each voxel is where its value says.
void ExpectInPlace(vtkImageData* image)
{
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double p[3];
    image->GetPoint(i, p);
    ASSERT_NEAR(image->GetPointData()->GetScalars()->GetComponent(i, 0), Code(p[0], p[1], p[2]), 1e-9) << i;
  }
}

} // namespace

TEST(Crop, VoxelsInTheBoxStayWhereTheyAre)
{
  vtkNew<PartSource> source;
  for (const bool parts : { false, true })
  {
    vtkNew<vtkInkCrop> crop;
    parts ? crop->SetInputConnection(source->GetOutputPort()) : crop->SetInputData(MakeImage());
    crop->SetBox(10.2, 12.0, 24.0, 26.5, 31.0, 37.0);
    crop->Update();
    auto* image = vtkImageData::SafeDownCast(crop->GetOutput());
    ASSERT_NE(image, nullptr);
    const std::array<int, 6> expected{ 0, 3, 0, 2, 0, 2 };
    EXPECT_TRUE(std::equal(expected.begin(), expected.end(), image->GetExtent()));
    EXPECT_DOUBLE_EQ(image->GetOrigin()[0], 10.5);
    ExpectInPlace(image);
  }
  const std::array<int, 6> asked{ 1, 4, 4, 6, 1, 3 };
  EXPECT_EQ(source->Asked, asked) << "no more than what stays";
}

TEST(Crop, PartsOfAPartAreAskedFor)
{
  vtkNew<PartSource> source;
  vtkNew<vtkInkCrop> crop;
  crop->SetInputConnection(source->GetOutputPort());
  crop->SetBox(10.2, 12.0, 24.0, 26.5, 31.0, 37.0);
  const int part[6] = { 1, 2, 0, 2, 2, 2 };
  crop->UpdateExtent(part);
  auto* image = vtkImageData::SafeDownCast(crop->GetOutput());
  EXPECT_TRUE(std::equal(part, part + 6, image->GetExtent()));
  ExpectInPlace(image);
  const std::array<int, 6> asked{ 2, 3, 4, 6, 3, 3 };
  EXPECT_EQ(source->Asked, asked);
}

TEST(Crop, AnObliqueImageKeepsTheVoxelsAroundTheBox)
{
  const auto image = MakeImage();
  image->SetDirectionMatrix(0.6, -0.8, 0.0, 0.8, 0.6, 0.0, 0.0, 0.0, 1.0);
  InkTestFill(image.Get(), VTK_DOUBLE, Code);
  double center[3];
  image->TransformIndexToPhysicalPoint(7, 8, 5, center);
  vtkNew<vtkInkCrop> crop;
  crop->SetInputData(image);
  crop->SetBox(center[0] - 1, center[0] + 1, center[1] - 1, center[1] + 1, center[2], center[2]);
  crop->Update();
  auto* cropped = vtkImageData::SafeDownCast(crop->GetOutput());
  // 1.4 world units along x and y of the image.
  const std::array<int, 6> expected{ 0, 4, 0, 2, 0, 0 };
  EXPECT_TRUE(std::equal(expected.begin(), expected.end(), cropped->GetExtent()));
  ExpectInPlace(cropped);
}

TEST(Crop, PolygonsAreCutAndPointsLeftOut)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(10, 10);
  vtkNew<vtkInkCrop> crop;
  crop->SetInputConnection(plane->GetOutputPort());
  crop->SetBox(-0.27, 0.5, -0.5, 0.5, -1.0, 1.0);
  crop->Update();
  const double* bounds = vtkPolyData::SafeDownCast(crop->GetOutput())->GetBounds();
  EXPECT_NEAR(bounds[0], -0.27, 1e-6);
  EXPECT_NEAR(bounds[1], 0.5, 1e-6);

  vtkNew<vtkPolyData> cloud;
  vtkNew<vtkPoints> points;
  cloud->SetPoints(points);
  vtkNew<vtkDoubleArray> ids;
  ids->SetName("Id");
  for (int i = 0; i < 10; ++i)
  {
    points->InsertNextPoint(i, 0.0, 0.0);
    ids->InsertNextValue(i);
  }
  cloud->GetPointData()->AddArray(ids);
  crop->SetInputData(cloud);
  crop->SetBox(2.5, 6.0, 0.0, 0.0, 0.0, 0.0);
  crop->Update();
  vtkDataArray* left = vtkPolyData::SafeDownCast(crop->GetOutput())->GetPointData()->GetArray("Id");
  ASSERT_EQ(left->GetNumberOfTuples(), 4);
  EXPECT_EQ(left->GetComponent(0, 0), 3.0);
  EXPECT_EQ(left->GetComponent(3, 0), 6.0);
}

TEST(Crop, NothingInTheBoxIsAnError)
{
  vtkNew<vtkPlaneSource> plane;
  vtkNew<PartSource> source;
  for (vtkAlgorithm* input : { static_cast<vtkAlgorithm*>(plane), static_cast<vtkAlgorithm*>(source) })
  {
    vtkNew<vtkInkCrop> crop;
    vtkNew<InkTestMessages> messages;
    messages->Observe(crop);
    crop->SetInputConnection(input->GetOutputPort());
    crop->SetBox(100.0, 101.0, 0.0, 1.0, 0.0, 1.0);
    crop->Update();
    EXPECT_EQ(vtkDataSet::SafeDownCast(crop->GetOutput())->GetNumberOfPoints(), 0);
    ASSERT_EQ(messages->Messages.size(), 1u);
    EXPECT_NE(messages->Messages[0].find("Nothing lies in the box; the data is from "), std::string::npos)
      << messages->Messages[0];
  }
}

TEST(Crop, ABoxHasItsEndsInOrder)
{
  vtkNew<vtkInkCrop> crop;
  vtkNew<InkTestMessages> messages;
  messages->Observe(crop);
  crop->SetBox(2.0, 1.0, 0.0, std::nan(""), 3.0, 4.0);
  ASSERT_EQ(messages->Messages.size(), 2u);
  EXPECT_NE(messages->Messages[0].find("Box along x: expected the lower end"), std::string::npos);
  const std::array<double, 6> expected{ -1.0, 1.0, -1.0, 1.0, 3.0, 4.0 };
  EXPECT_TRUE(std::equal(expected.begin(), expected.end(), crop->GetBox()));
}
