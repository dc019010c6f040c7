// SPDX-License-Identifier: BSD-3-Clause
// Quantized positions: the same stipples, each within half a step of where it was, in pictures that look
// alike; from one voxel in the window to many.
#include "InkTestImage.h"
#include "InkTestStipples.h"
#include "StippleScene.h"

#include "vtkFloatArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

/// The darkness of all pixels by which pictures differ.
double Difference(const InkTestImage& a, const InkTestImage& b)
{
  double sum = 0.0;
  for (int y = 0; y < a.GetHeight(); ++y)
  {
    for (int x = 0; x < a.GetWidth(); ++x)
    {
      sum += std::abs(a.Gray(x, y) - b.Gray(x, y)) / 255.0;
    }
  }
  return sum;
}

/// The middle of the ink in a square of pixels.
struct Pixel
{
  double X;
  double Y;
};
Pixel FindDot(const InkTestImage& image, int middleX, int middleY, int reach)
{
  double ink = 0.0;
  Pixel sum{ 0.0, 0.0 };
  for (int y = middleY - reach; y <= middleY + reach; ++y)
  {
    for (int x = middleX - reach; x <= middleX + reach; ++x)
    {
      const double dark = 255.0 - image.Gray(x, y);
      ink += dark;
      sum.X += dark * x;
      sum.Y += dark * y;
    }
  }
  return { sum.X / ink, sum.Y / ink };
}

} // namespace

/// One element of 9 stipples that fills the window: each dot is where it should be, to half a step.
TEST(StipplePrecision, Positions)
{
  constexpr int size = 400;
  auto stipples = InkTestStipples::PlaneSurface(2.0, 1, 9);
  StippleScene scene(stipples, size, size);
  scene.AllOff();
  scene.Mapper->GrowWithZoomOff();
  scene.Mapper->SetStippleSize(8.0);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.Renderer->GetActiveCamera()->SetParallelScale(1.1);
  scene.Mapper->SetPositionPrecision(vtkInkStippleMapper::QUANTIZED);
  const InkTestImage image(scene.Window);
  const double pixels = 0.5 * size / 1.1;
  double farthest = 0.0;
  for (vtkIdType i = 0; i < stipples->GetNumberOfPoints(); ++i)
  {
    double p[3];
    stipples->GetPoint(i, p);
    const Pixel expected{ p[0] * pixels + 0.5 * size - 0.5, p[1] * pixels + 0.5 * size - 0.5 };
    const Pixel found =
      FindDot(image, static_cast<int>(std::lround(expected.X)), static_cast<int>(std::lround(expected.Y)), 8);
    farthest = std::max({ farthest, std::abs(found.X - expected.X), std::abs(found.Y - expected.Y) });
  }
  // A step is a thousandth of some 300 pixels; brightness has 256 steps.
  EXPECT_LT(farthest, 0.2) << "dots within half a step of their positions, found one off by " << farthest
                           << " pixels";
}

/// The same marks, and a picture that differs by little, at all distances and by either kind.
TEST(StipplePrecision, Pictures)
{
  for (auto data :
    { InkTestStipples::SphereVoxels(1.0, 0.1, 12), InkTestStipples::SphereSurface(1.0, 800, 12) })
  {
    StippleScene scene(data);
    // The middle is all white otherwise, and at the least distance nothing else is seen.
    scene.Mapper->LightingOff();
    vtkCamera* camera = scene.Renderer->GetActiveCamera();
    for (double distance : { 1.2, 4.0, 40.0 })
    {
      camera->SetPosition(0.0, 0.0, distance);
      scene.Renderer->ResetCameraClippingRange();
      scene.Mapper->SetPositionPrecision(vtkInkStippleMapper::FLOAT);
      const InkTestImage exact(scene.Window);
      vtkNew<vtkFloatArray> exactMarks;
      scene.Mapper->EvaluateMarks(scene.Renderer, scene.Actor, exactMarks);
      const vtkMTimeType time = scene.Mapper->GetUploadTime();
      scene.Mapper->SetPositionPrecision(vtkInkStippleMapper::QUANTIZED);
      const InkTestImage packed(scene.Window);
      EXPECT_GT(scene.Mapper->GetUploadTime(), time) << "an upload for the other precision";
      vtkNew<vtkFloatArray> packedMarks;
      scene.Mapper->EvaluateMarks(scene.Renderer, scene.Actor, packedMarks);
      double most = 0.0;
      for (vtkIdType i = 0; i < exactMarks->GetNumberOfTuples(); ++i)
      {
        most = std::max(most, std::abs(exactMarks->GetComponent(i, 1) - packedMarks->GetComponent(i, 1)));
      }
      EXPECT_TRUE(exactMarks->GetNumberOfTuples() == packedMarks->GetNumberOfTuples() && most < 0.02)
        << "the same opacities at distance " << distance << ", found a difference of " << most;
      const double difference = Difference(exact, packed) / exact.Ink();
      EXPECT_TRUE(exact.Ink() > 3.0 && difference < 0.02)
        << "like pictures at distance " << distance << ", ink " << exact.Ink() << ", difference "
        << difference;
    }
  }
}
