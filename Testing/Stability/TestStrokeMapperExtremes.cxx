// SPDX-License-Identifier: BSD-3-Clause
// vtkInkStrokeMapper and odd lines and sizes: the right picture, or an empty one.
#include "InkTestImage.h"
#include "InkTestMessages.h"
#include "StrokeScene.h"

#include "vtkCamera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace
{

constexpr int Size = 200;
constexpr double Width = 3.0;

/// A view along -z in which a unit is `size` pixels' width, and (x, y, z) in the lower left corner.
void LookAt(StrokeScene& scene, double size, double x, double y, double z)
{
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  const double middle = 0.5 * Size * size;
  camera->ParallelProjectionOn();
  camera->SetParallelScale(middle);
  camera->SetFocalPoint(x + middle, y + middle, z);
  camera->SetPosition(x + middle, y + middle, z + 10.0 * middle);
  camera->SetClippingRange(middle, 20.0 * middle);
}

struct Picture
{
  double Ink;
  InkTestImage Image;
};

/// Of strokes in such a view; nothing is said.
Picture Draw(const std::string& name, const std::vector<StrokePolyline>& strokes, double size = 1.0,
  double x = 0.0, double y = 0.0, double z = 0.0)
{
  StrokeScene scene(MakeStrokes(strokes), Size, Size);
  vtkNew<InkTestMessages> messages;
  messages->Observe(scene.Mapper);
  scene.Mapper->SetLineWidth(Width);
  LookAt(scene, size, x, y, z);
  InkTestImage image(scene.Window);
  messages->Expect(name, {});
  return { image.Ink(), image };
}

/// A zigzag over the picture.
StrokePolyline Zigzag(double size = 1.0, double x = 0.0, double y = 0.0, double z = 0.0)
{
  StrokePolyline line;
  for (const auto& [u, v] : { std::array{ 20.0, 30.0 }, { 60.0, 170.0 }, { 100.0, 40.0 }, { 180.0, 150.0 } })
  {
    line.push_back({ x + size * u, y + size * v, z });
  }
  return line;
}

} // namespace

TEST(StrokeMapperExtremes, Coordinates)
{
  const Picture usual = Draw("zigzag", { Zigzag() });
  const double length = std::hypot(40.0, 140.0) + std::hypot(40.0, 130.0) + std::hypot(80.0, 110.0);
  EXPECT_NEAR(usual.Ink / (Width * length), 1.0, 0.02);
  // The same picture, but for the last bit of a coordinate in a pixel's coverage.
  const auto expectSame = [&](const std::string& name, const Picture& picture)
  { EXPECT_EQ(picture.Image.CountDifferent(usual.Image, 3), 0) << name; };
  for (const double size : { 1e-9, 1e-3, 1e9 })
  {
    expectSame("size " + std::to_string(size), Draw("size", { Zigzag(size) }, size));
  }
  for (const double far : { 1e7, -1e7 })
  {
    expectSame("far away", Draw("far", { Zigzag(0.01, far, -far, far) }, 0.01, far, -far, far));
  }
}

TEST(StrokeMapperExtremes, Points)
{
  const Picture usual = Draw("zigzag", { Zigzag() });
  // Straight lines of ten thousand points each, far closer than pixels, and of repeated ones.
  StrokePolyline fine;
  const StrokePolyline coarse = Zigzag();
  for (std::size_t i = 0; i + 1 < coarse.size(); ++i)
  {
    for (int n = 0; n < 10'000; ++n)
    {
      const double t = n / 10'000.0;
      fine.push_back({ coarse[i][0] + t * (coarse[i + 1][0] - coarse[i][0]),
        coarse[i][1] + t * (coarse[i + 1][1] - coarse[i][1]), 0.0 });
      if (n % 100 == 0)
      {
        fine.push_back(fine.back());
      }
    }
  }
  fine.push_back(coarse.back());
  const Picture many = Draw("many points", { fine });
  EXPECT_NEAR(many.Ink / usual.Ink, 1.0, 0.01);
  EXPECT_LT(many.Image.CountDifferent(usual.Image, 64), 20);

  // A thousand strokes shorter than a pixel, each a dot as wide as a stroke, in a row: a line.
  std::vector<StrokePolyline> dots;
  for (int n = 0; n <= 1000; ++n)
  {
    const double x = 20.0 + 0.16 * n;
    dots.push_back({ { x, 100.0, 0.0 }, { x + 0.01, 100.0, 0.0 } });
  }
  const InkTestImage row = Draw("dots", dots).Image;
  for (int x = 20; x < 180; ++x)
  {
    EXPECT_TRUE(row.IsDark(x, 100) && !row.IsDark(x, 105) && !row.IsDark(x, 95)) << x;
  }
}

/// Strokes that lead past or through the eye, or to where float ends.
TEST(StrokeMapperExtremes, Depth)
{
  const auto draw = [](const StrokePolyline& line, bool parallel)
  {
    StrokeScene scene(MakeStrokes({ line }), Size, Size);
    vtkNew<InkTestMessages> messages;
    messages->Observe(scene.Mapper);
    scene.Mapper->SetLineWidth(Width);
    vtkCamera* camera = scene.Renderer->GetActiveCamera();
    camera->SetParallelProjection(parallel);
    camera->SetPosition(0.0, 0.0, 0.0);
    camera->SetFocalPoint(0.0, 0.0, -1.0);
    camera->SetViewAngle(90.0);
    camera->SetParallelScale(1.0);
    camera->SetClippingRange(0.1, 1000.0);
    const InkTestImage image(scene.Window);
    messages->Expect("depth", {});
    return image;
  };
  EXPECT_EQ(draw({ { -1.0, 0.0, 5.0 }, { 1.0, 0.0, 5.0 } }, false).Ink(), 0.0) << "behind the eye";
  // From behind the eye, beside it, into the depth: on the horizon from the border to the middle.
  const InkTestImage through = draw({ { 1.0, 0.0, 50.0 }, { 1.0, 0.0, -900.0 } }, false);
  EXPECT_NEAR(through.Ink() / (0.5 * Size * Width), 1.0, 0.05);
  EXPECT_EQ(through.CountDark(0, 0, Size / 2 - 3, Size, 255), 0);
  EXPECT_NEAR(draw({ { -1.0, 0.0, -5.0 }, { 1.0, 0.0, -5.0 } }, true).Ink() / (Size * Width), 1.0, 0.02);
  EXPECT_EQ(draw({ { 0.5, 0.0, -2000.0 }, { 0.5, 0.5, -3000.0 } }, true).Ink(), 0.0)
    << "beyond the far plane";
  // Up to a million pixels; of ten million float loses an eighth of the ink.
  for (const double far : { 1e2, 1e3, 1e4 })
  {
    EXPECT_NEAR(draw({ { -far, 0.0, -5.0 }, { far, 0.0, -5.0 } }, true).Ink() / (Size * Width), 1.0, 0.02)
      << far;
  }
}

TEST(StrokeMapperExtremes, Widths)
{
  const std::vector<StrokePolyline> line = { { { 20.0, 100.0, 0.0 }, { 180.0, 100.0, 0.0 } } };
  for (const double width : { 0.0, 0.05, 0.5, 1.0, 10.0, 400.0, 1e6 })
  {
    StrokeScene scene(MakeStrokes(line), Size, Size);
    scene.Mapper->SetCapToButt();
    scene.Mapper->SetLineWidth(width);
    scene.LookAtPixels();
    const double ink = InkTestImage(scene.Window).Ink();
    const double expected = 160.0 * std::min(width, static_cast<double>(Size));
    EXPECT_NEAR(ink, expected, 0.05 * expected + 0.5) << width;
  }
}
