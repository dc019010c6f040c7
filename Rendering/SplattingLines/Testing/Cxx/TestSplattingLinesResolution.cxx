// SPDX-License-Identifier: BSD-3-Clause
// The same drawing at all sizes and in tiles, from all and from a part of the points, exact and quick.
#include "InkTestImage.h"
#include "InkTestPoints.h"
#include "PictureDifference.h"
#include "SplattingLinesScene.h"

#include "vtkFloatArray.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace
{

/// Darkness on a grid of size x size squares, each the mean of a picture's pixels there.
std::vector<double> Shrink(const InkTestImage& image, int size)
{
  const int factor = image.GetWidth() / size;
  std::vector<double> squares(static_cast<std::size_t>(size * size));
  for (int y = 0; y < size; ++y)
  {
    for (int x = 0; x < size; ++x)
    {
      double sum = 0.0;
      for (int v = 0; v < factor; ++v)
      {
        for (int u = 0; u < factor; ++u)
        {
          sum += 1.0 - image.Gray(x * factor + u, y * factor + v) / 255.0;
        }
      }
      squares[static_cast<std::size_t>(y * size + x)] = sum / (factor * factor);
    }
  }
  return squares;
}

vtkSmartPointer<vtkPolyData> Shape()
{
  return InkTestPoints::Join(
    InkTestPoints::Torus(1.0, 0.4, 0.01), InkTestPoints::Sphere(0.3, 0.01, { 0.0, 0.0, 0.2 }));
}

void Turn(SplattingLinesScene& scene)
{
  scene.Renderer->GetActiveCamera()->Elevation(-40.0);
  scene.Renderer->ResetCamera();
}

} // namespace

/// Each size shrunk to 64 pixels: as much ink, at the same positions.
TEST(SplattingLinesResolution, Sizes)
{
  std::vector<double> first;
  for (int size : { 512, 1024, 4096 })
  {
    SplattingLinesScene scene(Shape(), size, size);
    Turn(scene);

    const std::vector<double> squares = Shrink(InkTestImage(scene.Window), 64);
    if (first.empty())
    {
      first = squares;
    }
    const double difference = ink::pictureDifference(first, squares);
    EXPECT_LT(difference, 0.1) << "the same drawing with " << size << " pixels as with 512; " << difference
                               << " of the ink differs";
  }
}

/// A picture in tiles is that of a large window: no seams, and the same marks.
TEST(SplattingLinesResolution, Tiles)
{
  for (bool styled : { false, true })
  {
    SplattingLinesScene small(Shape(), 600, 600);
    SplattingLinesScene large(Shape(), 1200, 1200);
    for (SplattingLinesScene* scene : { &small, &large })
    {
      Turn(*scene);
      // Tiles always sum up for each pixel.
      scene->Mapper->SetMaximumDownsampling(1);
      scene->Mapper->SetHiddenLayers(styled);
      scene->Mapper->SetHardness(styled ? 0.5 : 0.0);
      scene->Mapper->SetLineWidth(styled ? 4.0 : 0.0);
      scene->Mapper->SetThinning(styled);
    }
    const InkTestImage tiles(small.Window, 2);
    const InkTestImage whole(large.Window);
    const int different = whole.CountDifferent(tiles, 8);
    EXPECT_EQ(different, 0) << "two by two tiles like one picture" << (styled ? " (styled)" : "") << "; "
                            << different << " pixels differ";
    int atSeams = 0;
    for (int i = 0; i < 1200; ++i)
    {
      for (int beside : { 599, 600 })
      {
        atSeams += std::abs(whole.Gray(beside, i) - tiles.Gray(beside, i)) > 8;
        atSeams += std::abs(whole.Gray(i, beside) - tiles.Gray(i, beside)) > 8;
      }
    }
    EXPECT_EQ(atSeams, 0) << "no seams, found " << atSeams << " pixels";
  }
}

/// A part of the points has no holes and much the same lines; all of them again are exactly what they were.
TEST(SplattingLinesResolution, PointFraction)
{
  SplattingLinesScene scene(Shape(), 400, 400);
  Turn(scene);
  scene.Renderer->SetBackground(0.5, 0.5, 0.5);
  const InkTestImage all(scene.Window);
  const auto countHoles = [&](const InkTestImage& image)
  {
    int holes = 0;
    for (int y = 0; y < 400; ++y)
    {
      for (int x = 0; x < 400; ++x)
      {
        holes += all.Gray(x, y) == 255 && image.Gray(x, y) == 127;
      }
    }
    return holes;
  };
  for (double fraction : { 0.5, 0.25 })
  {
    scene.Mapper->SetPointFraction(fraction);
    const InkTestImage part(scene.Window);
    EXPECT_EQ(countHoles(part), 0) << "no holes with " << fraction << " of the points, found "
                                   << countHoles(part);
    const double difference = ink::pictureDifference(Shrink(all, 100), Shrink(part, 100));
    EXPECT_LT(difference, 0.0045) << "much the same lines with " << fraction << " of the points; "
                                  << difference << " differs";
  }
  scene.Mapper->SetPointFraction(1.0);
  EXPECT_EQ(InkTestImage(scene.Window).CountDifferent(all), 0) << "all points again";
}

/// Points come in the order of their priorities, whatever their order in the list.
TEST(SplattingLinesResolution, Priority)
{
  auto points = InkTestPoints::Plane(2.0, 0.05);
  vtkNew<vtkFloatArray> priority;
  priority->SetName("Priority");
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    priority->InsertNextValue(static_cast<float>(0.5 - 0.49 * points->GetPoint(i)[0]));
  }
  points->GetPointData()->AddArray(priority);
  SplattingLinesScene scene(points);
  scene.Renderer->SetBackground(0.0, 0.0, 0.0);
  scene.Mapper->SetPointFraction(0.25);
  const InkTestImage image(scene.Window);
  EXPECT_EQ(image.CountDark(20, 60, 120, 140), 100 * 80) << "nothing of the other three quarters";
  EXPECT_EQ(image.CountDark(150, 60, 165, 140), 0) << "all of the quarter of least priority";
}

/// Ranks are priorities as well, and changed ones count.
TEST(SplattingLinesResolution, Ranks)
{
  auto points = InkTestPoints::Plane(2.0, 0.05);
  const vtkIdType count = points->GetNumberOfPoints();
  vtkNew<vtkFloatArray> priority;
  priority->SetName("Priority");
  for (vtkIdType i = 0; i < count; ++i)
  {
    priority->InsertNextValue(static_cast<float>(count - i));
  }
  points->GetPointData()->AddArray(priority);
  SplattingLinesScene scene(points);
  scene.Renderer->SetBackground(0.0, 0.0, 0.0);
  scene.Mapper->SetPointFraction(0.25);
  const InkTestImage last(scene.Window);
  for (vtkIdType i = 0; i < count; ++i)
  {
    priority->SetValue(i, static_cast<float>(i));
  }
  priority->Modified();
  points->Modified();
  const InkTestImage first(scene.Window);
  EXPECT_GT(first.CountDifferent(last, 20), 100) << "other points with other ranks";
  // Too few of them are none.
  priority->SetNumberOfTuples(3);
  points->Modified();
  const InkTestImage few(scene.Window);
  points->GetPointData()->RemoveArray("Priority");
  points->Modified();
  EXPECT_TRUE(InkTestImage(scene.Window).CountDifferent(few) == 0 && few.CountDifferent(first, 20) > 100)
    << "too few priorities are none: points by chance";
}

/// Narrow Gaussians need more texels.
TEST(SplattingLinesResolution, SmallSigma)
{
  SplattingLinesScene scene(Shape(), 600, 600);
  Turn(scene);
  scene.Mapper->SetLambda(8.0);
  for (double sigma : { 0.05, 0.1, 0.15, 0.25, 0.35, 0.5 })
  {
    scene.Mapper->SetSigma(sigma);
    scene.Mapper->SetMaximumDownsampling(1);
    const InkTestImage exact(scene.Window);
    for (int texel : { 2, 4 })
    {
      scene.Mapper->SetMaximumDownsampling(texel);
      const double difference =
        ink::pictureDifference(Shrink(exact, 150), Shrink(InkTestImage(scene.Window), 150));
      EXPECT_LT(difference, 0.05) << "much the same with sigma " << sigma << " and texels of " << texel
                                  << "; " << difference << " of the ink differs";
    }
  }
}

/// Splats summed up for several pixels at once change little.
TEST(SplattingLinesResolution, MaximumDownsampling)
{
  SplattingLinesScene scene(Shape(), 600, 600);
  Turn(scene);
  for (double lambda : { 3.0, 6.0 })
  {
    scene.Mapper->SetLambda(lambda);
    scene.Mapper->SetMaximumDownsampling(1);
    const InkTestImage exact(scene.Window);
    scene.Mapper->SetMaximumDownsampling(3);
    EXPECT_EQ(scene.Mapper->GetMaximumDownsampling(), 2) << "texels of 1, 2 or 4 pixels";
    double last = 0.0;
    for (int texel : { 2, 4 })
    {
      scene.Mapper->SetMaximumDownsampling(texel);
      const double difference =
        ink::pictureDifference(Shrink(exact, 600), Shrink(InkTestImage(scene.Window), 600));
      EXPECT_TRUE(difference < 0.06 && difference >= last)
        << "much the same with texels of " << texel << " and lambda " << lambda << "; " << difference
        << " of the ink differs";
      last = difference;
    }
    scene.Mapper->AsPublishedOn();
    const InkTestImage published(scene.Window);
    scene.Mapper->SetMaximumDownsampling(1);
    EXPECT_EQ(InkTestImage(scene.Window).CountDifferent(published), 0) << "published splats are always exact";
    scene.Mapper->AsPublishedOff();
  }
}

/// Sixteen bits are enough to see the same lines.
TEST(SplattingLinesResolution, HalfFloats)
{
  SplattingLinesScene scene(Shape(), 400, 400);
  Turn(scene);
  const InkTestImage exact(scene.Window);
  scene.Mapper->HalfFloatsOn();
  const InkTestImage half(scene.Window);
  const double difference = ink::pictureDifference(Shrink(exact, 400), Shrink(half, 400));
  EXPECT_TRUE(difference > 0.0 && difference < 0.0056)
    << "much the same from half floats; " << difference << " of the ink differs";
}
