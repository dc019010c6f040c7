// SPDX-License-Identifier: BSD-3-Clause
// Volumes that were enlarged by repeating voxels, or by interpolating slices, are drawn as what they were
// made of.
#include "StyleData.h"
#include "StyleErrors.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkInkSplattingLinesStyle.h"
#include "vtkInkStippleStyle.h"
#include "vtkInkStyle.h"
#include "vtkMath.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkShortArray.h"
#include "vtkTrivialProducer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

namespace
{

constexpr double Radius = 58.0;
constexpr int Side = 145; ///< of the enlarged volume, one millimeter a voxel

/// The mask of a ball around the middle of a volume of voxels that are as long as `step` says, repeated for
/// one of one millimeter, beside an array that says where its points are.
vtkSmartPointer<vtkImageData> MakeEnlargedBall(double step)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(5, Side + 4, 0, Side - 1, 0, Side - 1);
  image->SetOrigin(-5.0, 0.0, 0.0);
  vtkNew<vtkShortArray> mask;
  mask->SetName("mask");
  vtkNew<vtkDoubleArray> places;
  places->SetName("places");
  places->SetNumberOfComponents(3);
  const auto middleOf = [=](double place) { return (std::floor((place + 0.5) / step) + 0.5) * step - 0.5; };
  const double center = 0.5 * (Side - 1);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double p[3];
    image->GetPoint(i, p);
    places->InsertNextTuple(p);
    const double radius =
      std::hypot(middleOf(p[0]) - center, middleOf(p[1]) - center, middleOf(p[2]) - center);
    mask->InsertNextValue(radius < Radius ? 3 : 0);
  }
  image->GetPointData()->SetScalars(mask);
  image->GetPointData()->AddArray(places);
  return image;
}

/// A ball with an edge as wide as a voxel, with noise, in slices that are so many voxels apart, others
/// interpolated between them.
vtkSmartPointer<vtkImageData> MakeBallOfSlices(double step)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(Side, Side, Side);
  vtkNew<vtkShortArray> values;
  values->SetName("values");
  const double center = 0.5 * (Side - 1);
  std::minstd_rand random;
  std::normal_distribution<double> noise(0.0, 10.0);
  std::vector<double> scanned;
  const int slices = static_cast<int>(Side / step) + 2;
  for (int z = 0; z < slices; ++z)
  {
    for (int y = 0; y < Side; ++y)
    {
      for (int x = 0; x < Side; ++x)
      {
        const double radius = std::hypot(x - center, y - center, z * step - center);
        scanned.push_back(1000.0 / (1.0 + std::exp(4.0 * (radius - Radius))) + noise(random));
      }
    }
  }
  constexpr std::size_t slice = static_cast<std::size_t>(Side) * Side;
  for (std::size_t i = 0; i < slice * Side; ++i)
  {
    const double place = static_cast<double>(i / slice) / step;
    const std::size_t below = static_cast<std::size_t>(place) * slice + i % slice;
    const double share = place - std::floor(place);
    values->InsertNextValue(
      static_cast<short>((1.0 - share) * scanned[below] + share * scanned[below + slice]));
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

/// How far normals are off those of the ball (degrees, root mean square), and points off its surface.
std::pair<double, double> FindErrors(vtkPolyData* points)
{
  double angles = 0.0;
  double distances = 0.0;
  const double center = 0.5 * (Side - 1);
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double out[3];
    double normal[3];
    points->GetPoint(i, out);
    points->GetPointData()->GetNormals()->GetTuple(i, normal);
    std::for_each(out, out + 3, [=](double& coordinate) { coordinate -= center; });
    const double angle = vtkMath::DegreesFromRadians(vtkMath::AngleBetweenVectors(out, normal));
    angles += angle * angle;
    distances += std::pow(vtkMath::Norm(out) - Radius, 2);
  }
  const auto count = static_cast<double>(points->GetNumberOfPoints());
  return { std::sqrt(angles / count), std::sqrt(distances / count) };
}

std::string NoteOf(vtkInkStyle* style)
{
  for (int i = 0; i < style->GetNumberOfNotes(); ++i)
  {
    if (std::string(style->GetNote(i)).find("enlarged by") != std::string::npos)
    {
      return style->GetNote(i);
    }
  }
  return "";
}

} // namespace

TEST(EnlargedVolumes, SurfacesHaveNoBlocks)
{
  for (const double step : { 3.0, 4.3, 6.24 })
  {
    const auto image = MakeEnlargedBall(step);
    vtkNew<vtkInkSplattingLinesStyle> style;
    ASSERT_TRUE(style->Make(image));
    EXPECT_NE(NoteOf(style).find("that it was made of"), std::string::npos) << step;
    const auto [angle, distance] = FindErrors(style->GetPiece(0));
    EXPECT_LT(angle, 6.0) << step;
    EXPECT_LT(distance, 0.5 * step) << step; // what smoothing two voxels takes away from a ball this small
    double bounds[6];
    style->GetPiece(0)->GetBounds(bounds);
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_NEAR(0.5 * (bounds[2 * axis] + bounds[2 * axis + 1]), 0.5 * (Side - 1), 0.25 * step) << step;
    }
    style->SetParameterAsString("LabelMap", "off");
    ASSERT_TRUE(style->Make(image));
    EXPECT_EQ(NoteOf(style), "") << step;
    EXPECT_GT(FindErrors(style->GetPiece(0)).first, 2.0 * angle) << step;
  }
}

TEST(EnlargedVolumes, SurfacesHaveNoTerraces)
{
  for (const double step : { 4.0, 6.24 })
  {
    const auto image = MakeBallOfSlices(step);
    vtkNew<vtkInkSplattingLinesStyle> style;
    style->SetParameterAsString("IsoValues", "500");
    ASSERT_TRUE(style->Make(image));
    const std::string slices = std::to_string(static_cast<int>(std::round((Side - 1) / step)) + 1);
    EXPECT_NE(NoteOf(style).find("it is drawn as the 145 x 145 x " + slices), std::string::npos)
      << NoteOf(style);
    const auto [angle, distance] = FindErrors(style->GetPiece(0));
    style->SetParameterAsString("ShapeBasedInterpolation", "off");
    ASSERT_TRUE(style->Make(image));
    EXPECT_EQ(NoteOf(style), "");
    const auto [angleAsItIs, distanceAsItIs] = FindErrors(style->GetPiece(0));
    EXPECT_LT(angle, 0.3 * angleAsItIs) << step;
    EXPECT_LT(distance, distanceAsItIs) << step;
  }
}

TEST(EnlargedVolumes, StipplesOfVoxelsTakeAllSlices)
{
  const auto image = MakeBallOfSlices(5.0);
  vtkNew<vtkInkStippleStyle> style;
  style->SetParameterAsString("StippleSource", "volume");
  ASSERT_TRUE(style->Make(image));
  EXPECT_EQ(NoteOf(style), "");
  style->SetParameterAsString("StippleSource", "surface");
  ASSERT_TRUE(style->Make(image));
  EXPECT_NE(NoteOf(style).find("interpolating slices"), std::string::npos);
}

TEST(EnlargedVolumes, OthersStayAsTheyAre)
{
  for (const double step : { 1.0, 2.0 })
  {
    vtkNew<vtkInkSplattingLinesStyle> style;
    ASSERT_TRUE(style->Make(MakeEnlargedBall(step)));
    EXPECT_EQ(NoteOf(style), "") << step;
  }
  vtkNew<vtkInkSplattingLinesStyle> style;
  ASSERT_TRUE(style->Make(MakeBall()));
  EXPECT_EQ(NoteOf(style), "");
}

TEST(EnlargedVolumes, AllStylesAndPorts)
{
  const auto image = MakeEnlargedBall(6.24);
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(image);
  for (const auto& style : MakeStyles())
  {
    style->SetPictureSize(100.0);
    MakeFewMarks(style);
    ASSERT_TRUE(style->Make(image)) << style->GetName();
    EXPECT_NE(NoteOf(style), "") << style->GetName();
    EXPECT_GT(MarksOf(style).size(), 300u) << style->GetName();
    EXPECT_EQ(style->MakeMarks({ .Data = image, .Port = producer->GetOutputPort() }), "") << style->GetName();
    EXPECT_NE(NoteOf(style), "") << style->GetName();
    EXPECT_GT(MarksOf(style).size(), 300u) << style->GetName();
  }
}

TEST(EnlargedVolumes, AChangeOfTheVolumeIsSeen)
{
  const auto image = MakeEnlargedBall(3.0);
  vtkNew<vtkInkSplattingLinesStyle> style;
  ASSERT_TRUE(style->Make(image));
  EXPECT_NE(NoteOf(style), "");
  ASSERT_TRUE(style->Make(image));
  EXPECT_NE(NoteOf(style), "") << "noted each time";
  image->GetPointData()->GetScalars()->SetTuple1(image->FindPoint(70.0, 70.0, 70.0), 4);
  image->GetPointData()->GetScalars()->Modified();
  ASSERT_TRUE(style->Make(image));
  EXPECT_EQ(NoteOf(style), "") << "one voxel alone shows that they are not repeated";
}
