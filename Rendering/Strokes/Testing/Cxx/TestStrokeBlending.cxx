// SPDX-License-Identifier: BSD-3-Clause
// How strokes are blended with what is behind and before them: passes for translucent things, colors, depth.
#include "InkTestImage.h"
#include "StrokeScene.h"

#include "vtkCellData.h"
#include "vtkLookupTable.h"
#include "vtkPointData.h"
#include "vtkVolume.h"

#include <gtest/gtest.h>

#include <string>

namespace
{

/// Turns the order-independent pass for translucent things off, which VTK can since 9.3.
/// @return whether it can
template <class Renderer>
bool BlendInOrder(Renderer* renderer)
{
  if constexpr (requires { renderer->SetUseOIT(false); })
  {
    renderer->SetUseOIT(false);
    return true;
  }
  return false;
}

/// A volume of which there is nothing to see.
class NoVolume : public vtkVolume
{
public:
  static NoVolume* New() { return new NoVolume; }
  int RenderVolumetricGeometry(vtkViewport*) override { return 0; }
};

float DepthAt(vtkRenderWindow* window, int x, int y)
{
  float* read = window->GetZbufferData(x, y, x, y);
  const float depth = *read;
  delete[] read;
  return depth;
}

} // namespace

/// Volumes, which come after all that is translucent, find the depth of strokes: with the pass that VTK
/// blends with of itself, which has a depth of its own, and without it; wherever the viewport is.
TEST(StrokeBlending, Depth)
{
  for (const bool ordered : { false, true })
  {
    for (const double left : { 0.0, 0.5 })
    {
      const int shift = static_cast<int>(400 * left);
      StrokeScene scene(MakeStrokes({ HorizontalLine(100.0) }), 200, 200);
      scene.LookAtPixels();
      scene.Window->SetSize(400, 200);
      scene.Renderer->SetViewport(left, 0.0, left + 0.5, 1.0);
      vtkNew<vtkRenderer> empty;
      empty->SetViewport(0.5 - left, 0.0, 1.0 - left, 1.0);
      empty->SetBackground(1.0, 1.0, 1.0);
      scene.Window->AddRenderer(empty);
      scene.Mapper->SetLineWidth(6.0);
      if (ordered && !BlendInOrder(scene.Renderer.Get()))
      {
        continue; // this VTK has no way but its order-independent pass
      }
      if (!ordered)
      {
        scene.Window->Render();
        EXPECT_EQ(DepthAt(scene.Window, shift + 100, 100), 1.0f) << "for nobody";
        scene.Renderer->AddVolume(vtkNew<NoVolume>());
      }
      const InkTestImage image(scene.Window);
      EXPECT_EQ(image.CountDark(shift, 0, shift + 200, 200), image.CountDark());
      EXPECT_NEAR(image.CountDark(), 6 * 160, 40);
      const double expected = (1000.0 - 2.0 * 4.0 - 1.0) / 1999.0;
      EXPECT_NEAR(DepthAt(scene.Window, shift + 100, 100), expected, 1e-4)
        << "lifted by 2 pixels, as on a slanted surface";
      EXPECT_EQ(DepthAt(scene.Window, shift + 100, 110), 1.0f) << "no depth beside it";
      EXPECT_EQ(DepthAt(scene.Window, 300 - shift, 100), 1.0f) << "nor in the other half of the window";
    }
  }
}

/// No depth of a stroke reaches other translucent things, nor strokes of which it hides a part.
TEST(StrokeBlending, DepthChangesNoPicture)
{
  // Many strokes that cross at all depths.
  std::vector<StrokePolyline> lines;
  for (int i = 0; i < 12; ++i)
  {
    lines.push_back({ { 20.0, 20.0 + 13.0 * i, 5.0 * i }, { 180.0, 160.0 - 11.0 * i, -7.0 * i } });
  }
  StrokeScene independent(MakeStrokes(lines));
  independent.Renderer->AddVolume(vtkNew<NoVolume>());
  StrokeScene peeled(MakeStrokes(lines));
  for (StrokeScene* scene : { &independent, &peeled })
  {
    scene->LookAtPixels();
    scene->Mapper->SetLineWidth(2.3);
  }
  peeled.Renderer->SetUseDepthPeeling(true);
  peeled.Renderer->SetMaximumNumberOfPeels(30);
  peeled.Renderer->SetOcclusionRatio(0.0);
  const InkTestImage expected(peeled.Window);
  EXPECT_GT(expected.CountDark(), 3000);
  EXPECT_LT(InkTestImage(independent.Window).CountDifferent(expected, 12), 20);
}

/// Depth peeling sorts strokes among translucent surfaces. VTK's order-independent pass does not: it weights
/// all by their opacity, whichever is in front.
TEST(StrokeBlending, BetweenTranslucentSurfaces)
{
  const struct
  {
    double Height;
    double Sorted; ///< gray level of a black stroke; surfaces are of .9 and half translucent
  } cases[] = { { 90.0, 0.0 }, { 0.0, 0.5 * 0.9 * 255.0 }, { -90.0, 0.75 * 0.9 * 255.0 } };
  for (const bool peeling : { true, false })
  {
    for (const auto& [height, sorted] : cases)
    {
      StrokeScene scene(MakeStrokes({ HorizontalLine(100.0, height) }));
      scene.LookAtPixels();
      scene.Mapper->SetLineWidth(8.0);
      vtkNew<vtkActor> above;
      AddSurface(scene, above, 50.0, 50.0, 0.5);
      vtkNew<vtkActor> below;
      AddSurface(scene, below, -50.0, -50.0, 0.5);
      scene.Renderer->SetUseDepthPeeling(peeling);
      scene.Renderer->SetMaximumNumberOfPeels(10);
      scene.Renderer->SetOcclusionRatio(0.0);
      if (!peeling)
      {
        scene.Renderer->AddVolume(vtkNew<NoVolume>());
      }
      const InkTestImage image(scene.Window);
      EXPECT_NEAR(image.Gray(100, 100), peeling ? sorted : 0.5 * 0.9 * 255.0, 3.0)
        << (peeling ? "peeled" : "in any order") << ", at " << height;
      EXPECT_NEAR(image.Gray(100, 130), (0.75 * 0.9 + 0.25) * 255.0, 3.0) << "beside it";
    }
  }
}

/// The same picture with depth peeling, without the order-independent pass, and with multisampling.
TEST(StrokeBlending, Passes)
{
  const auto strokes = MakeStrokes({ Spiral() });
  StrokeScene usual(strokes);
  usual.Mapper->SetLineWidth(3.0);
  const InkTestImage expected(usual.Window);
  EXPECT_GT(expected.CountDark(), 1000);

  StrokeScene peeled(strokes);
  peeled.Mapper->SetLineWidth(3.0);
  peeled.Renderer->SetUseDepthPeeling(true);
  peeled.Renderer->SetMaximumNumberOfPeels(20);
  peeled.Renderer->SetOcclusionRatio(0.0);
  EXPECT_LT(InkTestImage(peeled.Window).CountDifferent(expected, 12), 20) << "with depth peeling";

  StrokeScene blended(strokes);
  blended.Mapper->SetLineWidth(3.0);
  BlendInOrder(blended.Renderer.Get());
  EXPECT_LT(InkTestImage(blended.Window).CountDifferent(expected, 3), 5) << "blended";

  StrokeScene smooth(strokes);
  smooth.Mapper->SetLineWidth(3.0);
  smooth.Window->SetMultiSamples(4);
  EXPECT_LT(InkTestImage(smooth.Window).CountDifferent(expected, 40), 60) << "with multisampling";
}

TEST(StrokeBlending, Colors)
{
  const auto strokes = MakeStrokes({ HorizontalLine(60.0), HorizontalLine(140.0) });
  strokes->GetPointData()->SetScalars(Values("Heat", { 0.0f, 0.5f, 1.0f, 1.0f, 1.0f, 1.0f }));
  strokes->GetCellData()->AddArray(Values("Stroke", { 0.0f, 1.0f }));
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(256);
  for (int i = 0; i < 256; ++i)
  {
    table->SetTableValue(i, i / 255.0, 0.0, 1.0 - i / 255.0, 1.0);
  }
  StrokeScene scene(strokes);
  scene.LookAtPixels();
  scene.Mapper->SetLineWidth(6.0);
  scene.Mapper->SetLookupTable(table);
  scene.Mapper->SetScalarRange(0.0, 1.0);
  scene.Mapper->SetInkColor(0.0, 0.4, 0.0);
  EXPECT_NEAR(InkTestImage(scene.Window).Channel(100, 60, 1), 102, 1) << "the ink's color";
  scene.Mapper->ScalarVisibilityOn();
  const InkTestImage points(scene.Window);
  for (const int x : { 30, 60, 100, 140, 170 })
  {
    EXPECT_NEAR(points.Channel(x, 60, 0), 255.0 * (x + 0.5 - 20.0) / 160.0, 2.0) << "interpolated at " << x;
    EXPECT_NEAR(points.Channel(x, 140, 0), 255, 1);
  }
  scene.Mapper->SetScalarModeToUseCellFieldData();
  scene.Mapper->SelectColorArray("Stroke");
  const vtkMTimeType upload = scene.Mapper->GetUploadTime();
  const InkTestImage cells(scene.Window);
  EXPECT_EQ(cells.Channel(100, 60, 0), 0);
  EXPECT_EQ(cells.Channel(100, 60, 2), 255);
  EXPECT_EQ(cells.Channel(100, 140, 0), 255);
  EXPECT_EQ(scene.Mapper->GetUploadTime(), upload) << "new colors only";
}

/// The alpha of a lookup table is the opacity of strokes, beside that of the actor.
TEST(StrokeBlending, AlphaOfTheLookupTable)
{
  const auto strokes = MakeStrokes({ HorizontalLine(60.0), HorizontalLine(140.0) });
  strokes->GetPointData()->SetScalars(Values("Heat", { 0.0f, 0.5f, 1.0f, 1.0f, 1.0f, 1.0f }));
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(256);
  for (int i = 0; i < 256; ++i)
  {
    table->SetTableValue(i, 0.0, 0.0, 0.0, i / 255.0);
  }
  StrokeScene scene(strokes);
  scene.LookAtPixels();
  scene.Mapper->SetLineWidth(8.0);
  scene.Mapper->SetLookupTable(table);
  scene.Mapper->SetScalarRange(0.0, 1.0);
  scene.Mapper->ScalarVisibilityOn();
  for (const double opacity : { 1.0, 0.5 })
  {
    scene.Actor->GetProperty()->SetOpacity(opacity);
    const InkTestImage image(scene.Window);
    for (const int x : { 30, 60, 100, 140, 170 })
    {
      const double alpha = (x + 0.5 - 20.0) / 160.0;
      EXPECT_NEAR(image.Gray(x, 60), 255.0 * (1.0 - opacity * alpha), 3.0) << x << ", " << opacity;
    }
    EXPECT_NEAR(image.Gray(100, 140), 255.0 * (1.0 - opacity), 2.0) << opacity;
  }
}
