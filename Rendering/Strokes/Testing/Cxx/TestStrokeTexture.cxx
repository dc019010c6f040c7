// SPDX-License-Identifier: BSD-3-Clause
// Strokes that an image is drawn along.
#include "InkTestImage.h"
#include "InkTestMessages.h"
#include "StrokeScene.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace
{

/// A texture of function(column, row).
vtkSmartPointer<vtkImageData> MakeTexture(
  int width, int height, const std::function<int(int, int)>& function, int components = 1)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, components);
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      for (int component = 0; component < components; ++component)
      {
        image->SetScalarComponentFromDouble(x, y, 0, component, function(x, y));
      }
    }
  }
  return image;
}

/// The first half of each repetition is ink.
vtkSmartPointer<vtkImageData> Stripes()
{
  return MakeTexture(64, 2, [](int x, int) { return x < 32 ? 255 : 0; });
}

const StrokePolyline Line{ { 20.0, 50.0, 0.0 }, { 180.0, 50.0, 0.0 } };

class TexturedScene : public StrokeScene
{
public:
  explicit TexturedScene(const StrokePolyline& polyline, vtkImageData* texture)
    : StrokeScene(MakeStrokes({ polyline }), 200, 100)
  {
    this->LookAtPixels();
    this->Mapper->SetLineWidth(10.0);
    this->Mapper->SetTextureLength(4.0);
    this->Mapper->SetCapToButt();
    this->Mapper->SetTexture(texture);
  }
};

} // namespace

/// Stripes along a stroke: 20 of 40 pixels are ink, as of dashes of these lengths.
TEST(StrokeTexture, StripesAlong)
{
  TexturedScene scene(Line, Stripes());
  const InkTestImage image(scene.Window);
  EXPECT_NEAR(image.Ink(), 0.5 * 160.0 * 10.0, 20.0);
  for (int x = 20; x < 180; ++x)
  {
    const double phase = std::fmod(x + 0.5 - 20.0, 40.0);
    const double border = std::min({ phase, std::abs(phase - 20.0), 40.0 - phase });
    if (border > 1.5)
    {
      EXPECT_EQ(image.Gray(x, 50), phase < 20.0 ? 0 : 255) << x;
      EXPECT_EQ(image.Gray(x, 46), phase < 20.0 ? 0 : 255) << x;
    }
  }
  scene.Mapper->SetTexture(nullptr);
  scene.Mapper->DashedOn();
  scene.Mapper->SetDashLength(20.0);
  scene.Mapper->SetGapLength(20.0);
  EXPECT_LE(InkTestImage(scene.Window).CountDifferent(image, 100), 30);
  // Together, what both leave.
  scene.Mapper->SetDashLength(10.0);
  scene.Mapper->SetGapLength(30.0);
  scene.Mapper->SetTexture(Stripes());
  EXPECT_NEAR(InkTestImage(scene.Window).Ink(), 0.25 * 160.0 * 10.0, 20.0);
}

/// Rows of the image lie across the stroke, the first one on the right of its way.
TEST(StrokeTexture, RowsAcross)
{
  TexturedScene scene(Line, MakeTexture(2, 64, [](int, int y) { return y < 16 ? 255 : y < 32 ? 0 : 128; }));
  scene.Mapper->SetLineWidth(40.0);
  const InkTestImage image(scene.Window);
  for (const int x : { 25, 60, 100, 175 })
  {
    EXPECT_EQ(image.Gray(x, 34), 0);
    EXPECT_EQ(image.Gray(x, 45), 255);
    EXPECT_NEAR(image.Gray(x, 55), 127, 1);
    EXPECT_NEAR(image.Gray(x, 66), 127, 1);
    EXPECT_EQ(image.Gray(x, 28), 255);
  }
}

/// Around a closed stroke there is a whole number of repetitions, and on a bent one as many as its length
/// asks for.
TEST(StrokeTexture, BentAndClosed)
{
  StrokePolyline circle;
  for (int i = 0; i <= 120; ++i)
  {
    const double angle = i % 120 * 2.0 * std::numbers::pi / 120;
    circle.push_back({ 100.0 + 40.0 * std::cos(angle), 50.0 + 40.0 * std::sin(angle), 0.0 });
  }
  TexturedScene scene(circle, Stripes());
  scene.Mapper->SetLineWidth(8.0);
  scene.Mapper->SetTextureLength(5.0);
  // 251 pixels are 6 repetitions of 41.9.
  const InkTestImage image(scene.Window);
  for (int i = 0; i < 360; ++i)
  {
    const double angle = (i + 0.5) * std::numbers::pi / 180.0;
    const double phase = std::fmod((i + 0.5) / 60.0, 1.0);
    if (std::min({ phase, std::abs(phase - 0.5), 1.0 - phase }) > 0.05)
    {
      for (const double r : { 38.0, 40.0, 42.0 })
      {
        EXPECT_EQ(image.IsDark(static_cast<int>(100.0 + r * std::cos(angle)),
                    static_cast<int>(50.0 + r * std::sin(angle))),
          phase < 0.5)
          << i << ' ' << r;
      }
    }
  }
  EXPECT_NEAR(image.Ink() / (0.5 * 2.0 * std::numbers::pi * 40.0 * 8.0), 1.0, 0.02);
}

/// Colors of the image take the place of the ink's; half of them is opaque.
TEST(StrokeTexture, Colors)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(2, 1, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  const int rgba[2][4] = { { 255, 0, 0, 255 }, { 255, 0, 0, 128 } };
  for (int x = 0; x < 2; ++x)
  {
    for (int component = 0; component < 4; ++component)
    {
      image->SetScalarComponentFromDouble(x, 0, 0, component, rgba[x][component]);
    }
  }
  TexturedScene scene(Line, image);
  scene.Mapper->SetTextureLength(16.0);
  const InkTestImage picture(scene.Window);
  // The middles of the two texels.
  EXPECT_EQ(picture.Channel(60, 50, 0), 255);
  EXPECT_NEAR(picture.Channel(60, 50, 1), 0, 2);
  EXPECT_NEAR(picture.Channel(140, 50, 1), 127, 2);
}

/// A texture finer than pixels is its mean, one that is moved with the camera stays where it is on the
/// stroke.
TEST(StrokeTexture, FinenessTilesAndCamera)
{
  TexturedScene scene(Line, Stripes());
  scene.Mapper->SetTextureLength(0.05);
  const InkTestImage fine(scene.Window);
  EXPECT_NEAR(fine.Ink(), 0.5 * 160.0 * 10.0, 20.0);
  EXPECT_NEAR(fine.Gray(100, 50), 127, 12);

  scene.Mapper->SetTextureLength(4.0);
  const InkTestImage tiles(scene.Window, 2);
  scene.Window->SetSize(400, 200);
  scene.Mapper->SetLineWidth(20.0);
  EXPECT_LE(tiles.CountDifferent(InkTestImage(scene.Window), 8), 20);

  scene.Window->SetSize(200, 100);
  scene.Mapper->SetLineWidth(10.0);
  const InkTestImage before(scene.Window);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetFocalPoint(110.0, 50.0, 0.0);
  camera->SetPosition(110.0, 50.0, 1000.0);
  const InkTestImage after(scene.Window);
  for (int x = 10; x < 190; ++x)
  {
    EXPECT_NEAR(after.Gray(x, 50), before.Gray(x + 10, 50), 2) << x;
  }
}

/// Round ends are part of the image, which goes on there.
TEST(StrokeTexture, Ends)
{
  TexturedScene scene(Line, Stripes());
  scene.Mapper->SetCapToRound();
  scene.Mapper->SetLineWidth(16.0);
  scene.Mapper->SetTextureLength(2.0);
  const InkTestImage image(scene.Window);
  // 16 of 32 pixels: before the begin there is a gap, and after the end, 160 = 5 * 32, a stripe.
  EXPECT_EQ(image.Gray(15, 50), 255);
  EXPECT_EQ(image.Gray(25, 50), 0);
  EXPECT_EQ(image.Gray(175, 50), 255);
  EXPECT_EQ(image.Gray(184, 50), 0);
}

TEST(StrokeTexture, WhatIsNoTexture)
{
  const double plain = InkTestImage(TexturedScene(Line, nullptr).Window).Ink();
  vtkNew<vtkImageData> bare;
  bare->SetDimensions(4, 4, 1);
  vtkNew<vtkImageData> floats;
  floats->SetDimensions(4, 4, 1);
  floats->AllocateScalars(VTK_FLOAT, 1);
  const auto three = MakeTexture(
    4, 4, [](int, int) { return 0; }, 3);
  const auto fewer = MakeTexture(4, 4, [](int, int) { return 0; });
  fewer->GetPointData()->GetScalars()->SetNumberOfTuples(15);
  for (vtkImageData* image : { bare.Get(), floats.Get(), three.Get(), fewer.Get() })
  {
    TexturedScene scene(Line, image);
    vtkNew<InkTestMessages> messages;
    messages->Observe(scene.Mapper);
    EXPECT_EQ(InkTestImage(scene.Window).Ink(), plain);
    scene.Window->Render();
    messages->Expect("no texture", { "2D image of unsigned char with 1 or 4 components", "4 x 4 x 1" });
  }
  // Without repetitions to be seen, from a stroke that is no wider than nothing.
  TexturedScene thin(Line, Stripes());
  thin.Mapper->SetLineWidth(0.0);
  EXPECT_EQ(InkTestImage(thin.Window).Ink(), 0.0);
}
