// SPDX-License-Identifier: BSD-3-Clause
// How much ink strokes put on the paper, and where: lines, corners, closed strokes, dashes, tapers.
#include "InkTestImage.h"
#include "StrokeScene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

namespace
{

/// Whether a stroke with round corners covers a point.
bool Covers(const StrokePolyline& polyline, double width, bool butt, double x, double y)
{
  for (std::size_t i = 0; i + 1 < polyline.size(); ++i)
  {
    const auto& a = polyline[i];
    const auto& b = polyline[i + 1];
    const double wx = b[0] - a[0];
    const double wy = b[1] - a[1];
    const double t = ((x - a[0]) * wx + (y - a[1]) * wy) / (wx * wx + wy * wy);
    const bool cut = butt && ((i == 0 && t < 0.0) || (i + 2 == polyline.size() && t > 1.0));
    const double near = std::clamp(t, 0.0, 1.0);
    if (!cut && std::hypot(x - a[0] - near * wx, y - a[1] - near * wy) < 0.5 * width)
    {
      return true;
    }
  }
  return false;
}

/// How much of a pixel it covers, 0 to 1, by well spread samples (Roberts' sequence R2).
double CoverageOf(const StrokePolyline& polyline, double width, bool butt, int x, int y)
{
  if (!Covers(polyline, width + 1.5, false, x + 0.5, y + 0.5))
  {
    return 0.0;
  }
  constexpr int samples = 1000;
  int inside = 0;
  for (int sample = 0; sample < samples; ++sample)
  {
    inside += Covers(polyline, width, butt, x + std::fmod(0.7548776662466927 * sample, 1.0),
      y + std::fmod(0.5698402909980532 * sample, 1.0));
  }
  return static_cast<double>(inside) / samples;
}

/// Root mean square of the difference in gray levels, of pixels that either covers.
double Difference(const InkTestImage& image, const StrokePolyline& polyline, double width, bool butt)
{
  double sum = 0.0;
  int count = 0;
  for (int y = 0; y < image.GetHeight(); ++y)
  {
    for (int x = 0; x < image.GetWidth(); ++x)
    {
      const double expected = 255.0 * (1.0 - CoverageOf(polyline, width, butt, x, y));
      const double found = image.Gray(x, y);
      if (expected < 255.0 || found < 255.0)
      {
        sum += (expected - found) * (expected - found);
        ++count;
      }
    }
  }
  return std::sqrt(sum / std::max(count, 1));
}

} // namespace

/// Width times length of ink, wherever the line lies within its pixels.
TEST(StrokeShapes, StraightLine)
{
  for (const double width : { 0.4, 1.0, 3.3 })
  {
    for (const double angle : { 0.0, 30.0, 45.0, 77.0 })
    {
      for (const double offset : { 0.0, 0.3, 0.5 })
      {
        const double c = 40.0 * std::cos(angle * std::numbers::pi / 180.0);
        const double s = 40.0 * std::sin(angle * std::numbers::pi / 180.0);
        const double middle = 50.0 + offset;
        const StrokePolyline line{ { middle - c, middle - s, 0.0 }, { middle + c, middle + s, 0.0 } };
        StrokeScene scene(MakeStrokes({ line }), 100, 100);
        scene.LookAtPixels();
        scene.Mapper->SetLineWidth(width);
        scene.Mapper->SetCapToButt();
        const InkTestImage image(scene.Window);
        EXPECT_NEAR(image.Ink() / (80.0 * width), 1.0, 0.02)
          << "width " << width << ", angle " << angle << ", offset " << offset;
        EXPECT_LT(Difference(image, line, width, true), 2.0)
          << "width " << width << ", angle " << angle << ", offset " << offset;
      }
    }
  }
}

/// Ends are half discs, wherever they lie within their pixels, of lines and of corners.
TEST(StrokeShapes, RoundCaps)
{
  for (const double width : { 1.0, 3.3, 12.0 })
  {
    for (const double angle : { 0.0, 30.0, 45.0, 77.0 })
    {
      for (const double bend : { 0.0, 70.0 })
      {
        const auto along = [&](double length, double degrees)
        {
          const double a = degrees * std::numbers::pi / 180.0;
          return std::array<double, 3>{ 50.3 + length * std::cos(a), 50.1 + length * std::sin(a), 0.0 };
        };
        const StrokePolyline line{ along(-30.0, angle), along(0.0, angle), along(30.0, angle + bend) };
        StrokeScene scene(MakeStrokes({ line }), 100, 100);
        scene.LookAtPixels();
        scene.Mapper->SetLineWidth(width);
        const InkTestImage image(scene.Window);
        // Half a pixel's disc is taken for one with a straight edge.
        EXPECT_LT(Difference(image, line, width, false), width < 2.0 ? 5.0 : 3.0)
          << "width " << width << ", angle " << angle << ", bend " << bend;
        if (bend == 0.0)
        {
          const double ends = 0.25 * std::numbers::pi * width * width;
          EXPECT_NEAR(image.Ink() / (60.0 * width + ends), 1.0, 0.02) << "width " << width;
          scene.Mapper->SetCapToButt();
          EXPECT_NEAR(image.Ink() - InkTestImage(scene.Window).Ink(), ends, 0.05 * ends + 0.4)
            << "width " << width << ", angle " << angle;
        }
      }
    }
  }
}

/// A star of sharp turns, each of which a miter would make a spike.
TEST(StrokeShapes, SharpTurns)
{
  StrokePolyline star;
  for (int i = 0; i <= 24; ++i)
  {
    const double angle = i * 2.0 * std::numbers::pi / 24.0;
    const double radius = i % 2 == 0 ? 45.0 : 12.0;
    star.push_back({ 50.0 + radius * std::cos(angle), 50.0 + radius * std::sin(angle), 0.0 });
  }
  star.back() = star.front();
  for (const int join : { vtkInkStrokeMapper::ROUND_JOIN, vtkInkStrokeMapper::MITER_JOIN })
  {
    StrokeScene scene(MakeStrokes({ star }), 100, 100);
    scene.LookAtPixels();
    scene.Mapper->SetLineWidth(3.0);
    scene.Mapper->SetJoin(join);
    scene.Mapper->SetMiterLimit(1.5);
    EXPECT_LT(Difference(InkTestImage(scene.Window), star, 3.0, false), 8.0)
      << "as round corners, " << scene.Mapper->GetJoinAsString();
  }
}

/// Pointed corners within the limit: of a square, one and a half times as wide at its corners as beside.
TEST(StrokeShapes, Miter)
{
  const StrokePolyline square{ { 30.0, 30.0, 0.0 }, { 70.0, 30.0, 0.0 }, { 70.0, 70.0, 0.0 },
    { 30.0, 70.0, 0.0 }, { 30.0, 30.0, 0.0 } };
  StrokeScene scene(MakeStrokes({ square }), 100, 100);
  scene.LookAtPixels();
  scene.Mapper->SetLineWidth(10.0);
  scene.Mapper->SetJoinToMiter();
  EXPECT_NEAR(InkTestImage(scene.Window).Ink(), 50.0 * 50.0 - 30.0 * 30.0, 4.0) << "square corners";
  scene.Mapper->SetMiterLimit(1.3);
  const double round = 4.0 * 25.0 * (1.0 - std::numbers::pi / 4.0);
  EXPECT_NEAR(InkTestImage(scene.Window).Ink(), 50.0 * 50.0 - 30.0 * 30.0 - round, 4.0)
    << "round ones beyond the limit";
  scene.Mapper->SetMiterLimit(4.0);
  scene.Mapper->SetJoinToRound();
  EXPECT_NEAR(InkTestImage(scene.Window).Ink(), 50.0 * 50.0 - 30.0 * 30.0 - round, 4.0) << "round ones";
}

/// No pixel of a translucent stroke gets ink twice: neither at corners, nor where the stroke closes, nor of
/// many segments in a pixel.
TEST(StrokeShapes, Translucent)
{
  for (const int segments : { 3, 5, 40, 400, 4000 })
  {
    StrokePolyline ring;
    for (int i = 0; i < segments; ++i)
    {
      const double angle = i * 2.0 * std::numbers::pi / segments;
      ring.push_back({ 50.0 + 35.0 * std::cos(angle), 50.0 + 35.0 * std::sin(angle), 0.0 });
    }
    ring.push_back(ring.front());
    StrokeScene scene(MakeStrokes({ ring }), 100, 100);
    scene.LookAtPixels();
    scene.Mapper->SetLineWidth(7.0);
    scene.Actor->GetProperty()->SetOpacity(0.5);
    const InkTestImage image(scene.Window);
    int darker = 0;
    int half = 0;
    for (int y = 0; y < 100; ++y)
    {
      for (int x = 0; x < 100; ++x)
      {
        darker += image.Gray(x, y) < 126;
        half += image.Gray(x, y) < 130;
      }
    }
    EXPECT_EQ(darker, 0) << "twice the ink with " << segments << " segments";
    EXPECT_GT(half, 700) << "the stroke with " << segments << " segments";
    double around = 0.0;
    for (int i = 0; i < segments; ++i)
    {
      const auto& a = ring[static_cast<std::size_t>(i)];
      const auto& b = ring[static_cast<std::size_t>(i) + 1];
      around += std::hypot(b[0] - a[0], b[1] - a[1]);
    }
    EXPECT_NEAR(image.Ink() / (0.5 * 7.0 * around), 1.0, 0.03) << segments << " segments";
  }
}

/// Nor where a stroke leaves the clipping range and comes back beside itself: how long it is outside does not
/// matter, though there is no length on the picture.
TEST(StrokeShapes, TranslucentHairpin)
{
  for (const double height : { 2000.0, -3000.0 })
  {
    StrokeScene scene(MakeStrokes({ { { 20.0, 48.0, 0.0 }, { 80.0, 48.0, height }, { 80.0, 52.0, height },
                        { 20.0, 52.0, 0.0 } } }),
      100, 100);
    scene.LookAtPixels();
    scene.Mapper->SetLineWidth(10.0);
    scene.Actor->GetProperty()->SetOpacity(0.5);
    const InkTestImage image(scene.Window);
    int darker = 0;
    int half = 0;
    for (int y = 0; y < 100; ++y)
    {
      for (int x = 0; x < 100; ++x)
      {
        darker += image.Gray(x, y) < 126;
        half += image.Gray(x, y) < 130;
      }
    }
    EXPECT_EQ(darker, 0) << "twice the ink, " << height;
    EXPECT_GT(half, 300) << height;
  }
}

/// The ink of dashes is their share of the stroke, and a closed one has no broken dash.
TEST(StrokeShapes, Dashes)
{
  const StrokePolyline line{ { 10.0, 50.5, 0.0 }, { 60.0, 50.5, 0.0 }, { 190.0, 50.5, 0.0 } };
  StrokeScene scene(MakeStrokes({ line }));
  scene.LookAtPixels();
  scene.Mapper->SetLineWidth(4.0);
  scene.Mapper->SetCapToButt();
  scene.Mapper->DashedOn();
  for (const double dash : { 12.0, 3.0, 0.6 })
  {
    for (const double gap : { 6.0, 3.0, 0.4 })
    {
      scene.Mapper->SetDashLength(dash);
      scene.Mapper->SetGapLength(gap);
      EXPECT_NEAR(InkTestImage(scene.Window).Ink() / (180.0 * 4.0), dash / (dash + gap), 0.03)
        << "dashes of " << dash << ", gaps of " << gap;
    }
  }
  scene.Mapper->SetDashLength(20.0);
  scene.Mapper->SetGapLength(10.0);
  const InkTestImage image(scene.Window);
  for (int x = 10; x < 190; ++x)
  {
    const bool inDash = (x - 10) % 30 < 20;
    EXPECT_EQ(image.IsDark(x, 50), inDash) << "pixel " << x;
  }
  scene.Mapper->SetCapToRound();
  scene.Mapper->SetLineWidth(11.0);
  const InkTestImage round(scene.Window);
  EXPECT_EQ(round.Gray(7, 50), 0) << "the cap of a dash that begins with the stroke";
  EXPECT_EQ(round.Gray(192, 50), 255) << "and of a gap that ends with it";

  StrokePolyline ring;
  for (int i = 0; i < 100; ++i)
  {
    const double angle = i * 2.0 * std::numbers::pi / 100;
    ring.push_back({ 100.0 + 80.0 * std::cos(angle), 100.0 + 80.0 * std::sin(angle), 0.0 });
  }
  ring.push_back(ring.front());
  scene.Mapper->SetInputData(MakeStrokes({ ring }));
  const InkTestImage dashed(scene.Window);
  int changes = 0;
  for (int i = 0; i < 2000; ++i)
  {
    const auto darkAt = [&](int n)
    {
      const double angle = (n + 0.5) * 2.0 * std::numbers::pi / 2000;
      return dashed.IsDark(
        static_cast<int>(100.0 + 80.0 * std::cos(angle)), static_cast<int>(100.0 + 80.0 * std::sin(angle)));
    };
    changes += darkAt(i) != darkAt(i + 1);
  }
  EXPECT_EQ(changes, 2 * 17) << "17 whole dashes on a circumference of 502 pixels";
}

/// A stroke that tapers altogether is two triangles; one that does by half has the full width between.
TEST(StrokeShapes, Taper)
{
  const StrokePolyline line{ { 10.0, 50.5, 0.0 }, { 60.0, 50.5, 0.0 }, { 190.0, 50.5, 0.0 } };
  StrokeScene scene(MakeStrokes({ line }));
  scene.LookAtPixels();
  scene.Mapper->SetLineWidth(9.0);
  scene.Mapper->SetCapToButt();
  double before = 180.0 * 9.0;
  for (const double taper : { 0.2, 0.5, 0.8, 1.0 })
  {
    scene.Mapper->SetTaper(taper);
    const InkTestImage image(scene.Window);
    EXPECT_NEAR(image.Ink() / (180.0 * 9.0 * (1.0 - 0.5 * taper)), 1.0, 0.02) << "taper " << taper;
    EXPECT_LT(image.Ink(), before);
    before = image.Ink();
    EXPECT_TRUE(image.IsDark(100, 53) && !image.IsDark(12, 53) && !image.IsDark(187, 53))
      << "taper " << taper;
  }
}

/// Nothing is missing between short segments either, of which wider ones cover pixels beyond their ends.
TEST(StrokeShapes, TaperOfManySegments)
{
  constexpr double begin = 10.0;
  constexpr double step = 9.0;
  constexpr double length = 180.0;
  constexpr double middle = 50.5;
  StrokePolyline line;
  for (int i = 0; i <= 20; ++i)
  {
    line.push_back({ begin + step * i, middle, 0.0 });
  }
  StrokeScene scene(MakeStrokes({ line }), 200, 100);
  scene.LookAtPixels();
  scene.Mapper->SetCapToButt();
  for (const double width : { 9.0, 20.0, 60.0 })
  {
    scene.Mapper->SetLineWidth(width);
    for (const double taper : { 0.5, 1.0 })
    {
      scene.Mapper->SetTaper(taper);
      const InkTestImage image(scene.Window);
      // Discs of the widest stroke's corners, which narrows by .67, reach past its straight edges.
      if (width < 60.0)
      {
        EXPECT_NEAR(image.Ink() / (length * width * (1.0 - 0.5 * taper)), 1.0, 0.02)
          << "width " << width << ", taper " << taper;
      }
      const auto halfWidthAt = [&](double along)
      { return 0.5 * width * std::min(2.0 * std::min(along, length - along) / (taper * length), 1.0); };
      for (int y = 0; y < 100; ++y)
      {
        for (int x = 0; x < 200; ++x)
        {
          double inside = -INFINITY;
          for (double from = 0.0; from < length; from += step)
          {
            const double nearest = std::clamp(x + 0.5 - begin, from, from + step);
            const double distance = std::hypot(x + 0.5 - begin - nearest, y + 0.5 - middle);
            inside = std::max(inside, halfWidthAt(nearest) - distance);
          }
          if (std::abs(inside) > 1.0)
          {
            EXPECT_EQ(image.Gray(x, y), inside > 0.0 ? 0 : 255)
              << x << ", " << y << ", width " << width << ", taper " << taper;
          }
        }
      }
    }
  }
}
