// SPDX-License-Identifier: BSD-3-Clause
// Windows and viewports: resizing, multisampling, tiles, several renderers, actors and mappers, and resources
// that go away.
#include "InkTestImage.h"
#include "InkTestPoints.h"
#include "InkTestViewports.h"
#include "SplattingLinesScene.h"

#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <string>

namespace
{

vtkSmartPointer<vtkPolyData> Points()
{
  return InkTestPoints::Torus(1.0, 0.4, 0.03);
}

} // namespace

TEST(SplattingLinesWindows, Resize)
{
  SplattingLinesScene scene(Points());
  const InkTestImage first(scene.Window);
  scene.Window->SetSize(120, 90);
  const InkTestImage small(scene.Window);
  EXPECT_TRUE(small.GetWidth() == 120 && small.GetHeight() == 90 && small.CountDark() > 100)
    << "lines in a smaller window";
  scene.Window->SetSize(200, 200);
  EXPECT_EQ(InkTestImage(scene.Window).CountDifferent(first), 0) << "the first picture again";
}

TEST(SplattingLinesWindows, Multisampling)
{
  SplattingLinesScene plain(Points());
  const InkTestImage expected(plain.Window);
  for (int samples : { 4, 8 })
  {
    SplattingLinesScene scene(Points());
    scene.Window->SetMultiSamples(samples);
    EXPECT_EQ(InkTestImage(scene.Window).CountDifferent(expected, 2), 0)
      << "the same picture with " << samples << " samples";
  }
}

/// A picture of several tiles is like one from a large window.
TEST(SplattingLinesWindows, Tiles)
{
  SplattingLinesScene scene(Points());
  const InkTestImage tiles(scene.Window, 2);
  EXPECT_EQ(tiles.GetWidth(), 400) << "twice the size";
  SplattingLinesScene large(Points(), 400, 400);
  // Tiles always sum up for each pixel.
  large.Mapper->SetMaximumDownsampling(1);
  const InkTestImage whole(large.Window);
  EXPECT_GT(whole.CountDark(), 1000);
  EXPECT_EQ(tiles.CountDifferent(whole, 8), 0) << "the large window's picture";
  int seam = 0;
  for (int y = 0; y < 400; ++y)
  {
    seam += tiles.IsDark(199, y) != tiles.IsDark(200, y);
    seam += tiles.IsDark(y, 199) != tiles.IsDark(y, 200);
  }
  EXPECT_LE(seam, 8) << "lines that go on across the tiles, " << seam << " pixels differ";
}

/// Two renderers with one actor each, or with the same actor, draw what they draw alone.
TEST(SplattingLinesWindows, Viewports)
{
  SplattingLinesScene alone(Points(), 100, 200);
  const InkTestImage expected(alone.Window);
  for (bool shared : { false, true })
  {
    SplattingLinesScene scene(Points());
    SplattingLinesScene other(Points());
    EXPECT_EQ(CountDifferentInViewports(expected, scene, shared ? scene.Actor : other.Actor), 0)
      << "two viewports like one" << (shared ? " (one actor)" : "");
  }
}

/// A viewport that fills neither the window's width nor its height.
TEST(SplattingLinesWindows, Inset)
{
  SplattingLinesScene alone(Points(), 100, 100);
  const InkTestImage expected(alone.Window);
  SplattingLinesScene scene(Points());
  scene.Renderer->SetViewport(0.25, 0.4, 0.75, 0.9);
  scene.Renderer->ResetCamera();
  const InkTestImage image(scene.Window);
  int different = 0;
  int outside = 0;
  for (int y = 0; y < 200; ++y)
  {
    for (int x = 0; x < 200; ++x)
    {
      const bool inside = x >= 50 && x < 150 && y >= 80 && y < 180;
      different += inside && image.Gray(x, y) != expected.Gray(x - 50, y - 80);
      // The window is black where it has no renderer.
      outside += !inside && image.Gray(x, y) != 0;
    }
  }
  EXPECT_TRUE(different == 0 && outside == 0)
    << "an inset viewport: " << different << " pixels differ, " << outside << " outside";
}

TEST(SplattingLinesWindows, ReleasedResources)
{
  SplattingLinesScene scene(Points());
  const InkTestImage first(scene.Window);
  scene.Mapper->ReleaseGraphicsResources(scene.Window);
  EXPECT_EQ(scene.Mapper->GetUploadTime(), 0) << "nothing on the GPU";
  EXPECT_EQ(InkTestImage(scene.Window).CountDifferent(first), 0) << "the picture after a release";
  scene.Window->Finalize();
  EXPECT_EQ(InkTestImage(scene.Window).CountDifferent(first), 0) << "the picture after Finalize";
}

TEST(SplattingLinesWindows, MovedRenderer)
{
  SplattingLinesScene scene(Points());
  const InkTestImage first(scene.Window);
  vtkNew<vtkRenderWindow> second;
  second->SetOffScreenRendering(true);
  second->SetMultiSamples(0);
  second->SetSize(200, 200);
  scene.Window->RemoveRenderer(scene.Renderer);
  second->AddRenderer(scene.Renderer);
  EXPECT_EQ(InkTestImage(second).CountDifferent(first), 0) << "the picture in another window";
  second->RemoveRenderer(scene.Renderer);
  scene.Window->AddRenderer(scene.Renderer);
  EXPECT_EQ(InkTestImage(scene.Window).CountDifferent(first), 0) << "the picture in the first window";
}

/// Mapper, actor, renderer and window may go in any order.
TEST(SplattingLinesWindows, OrderOfDeletion)
{
  // The window never hears of a mapper that was taken from its actor.
  auto mapper = vtkSmartPointer<vtkInkSplattingLinesMapper>::New();
  mapper->SetInputData(Points());
  {
    SplattingLinesScene scene(Points());
    scene.Actor->SetMapper(mapper);
    scene.Window->Render();
    scene.Actor->SetMapper(scene.Mapper);
    scene.Window->Render();
    EXPECT_GT(mapper->GetUploadTime(), 0) << "points on the GPU";
  }
  EXPECT_EQ(mapper->GetUploadTime(), 0) << "nothing left of a window that is gone";
  mapper = nullptr;

  SplattingLinesScene scene(Points());
  {
    vtkNew<vtkInkSplattingLinesMapper> shortLived;
    shortLived->SetInputData(Points());
    scene.Actor->SetMapper(shortLived);
    scene.Window->Render();
    scene.Actor->SetMapper(scene.Mapper);
  }
  EXPECT_GT(InkTestImage(scene.Window).CountDark(), 100) << "a picture after a mapper is gone";
}

/// Two mappers in one scene, and one mapper for two actors.
TEST(SplattingLinesWindows, TwoActors)
{
  SplattingLinesScene scene(Points());
  vtkNew<vtkInkSplattingLinesMapper> mapper;
  mapper->SetInputData(Points());
  InkTestImage* images[2];
  for (bool shared : { false, true })
  {
    SplattingLinesScene two(Points());
    vtkNew<vtkActor> actor;
    actor->SetMapper(shared ? static_cast<vtkMapper*>(two.Mapper) : mapper);
    actor->SetPosition(2.0, 1.0, -2.0);
    two.Renderer->AddActor(actor);
    two.Renderer->ResetCamera();
    images[shared] = new InkTestImage(two.Window);
    const vtkMTimeType time = two.Mapper->GetUploadTime();
    two.Window->Render();
    EXPECT_EQ(two.Mapper->GetUploadTime(), time) << "no upload for a second actor";
  }
  EXPECT_TRUE(images[0]->CountDifferent(*images[1]) == 0 && images[0]->CountDark() > 200)
    << "one mapper for two actors like two mappers";
  delete images[0];
  delete images[1];
}

/// One mapper in two windows: sent to each GPU once, the same picture, and each window takes its own with it.
TEST(SplattingLinesWindows, TwoWindows)
{
  SplattingLinesScene first(Points());
  const InkTestImage expected(first.Window);
  {
    SplattingLinesScene second(Points());
    second.Actor->SetMapper(first.Mapper);
    EXPECT_EQ(InkTestImage(second.Window).CountDifferent(expected), 0) << "the picture in a second window";
    const vtkMTimeType time = first.Mapper->GetUploadTime();
    for (int frame = 0; frame < 3; ++frame)
    {
      for (SplattingLinesScene* scene : { &first, &second })
      {
        scene->Renderer->GetActiveCamera()->Azimuth(10.0);
        scene->Window->Render();
      }
    }
    EXPECT_EQ(first.Mapper->GetUploadTime(), time) << "no upload for windows by turns";
    EXPECT_EQ(InkTestImage(second.Window).CountDifferent(InkTestImage(first.Window)), 0)
      << "the same picture in both windows";
    // An older input that comes back is not what the other window drew last.
    auto shifted = InkTestPoints::Transform(Points(), 3.0, { 5.0, 0.0, 0.0 });
    first.Mapper->SetInputData(shifted);
    second.Renderer->ResetCamera();
    second.Window->Render();
  }
  EXPECT_GT(first.Mapper->GetUploadTime(), 0) << "the first window's points stay when the second is gone";
  first.Mapper->SetInputData(Points());
  first.Renderer->GetActiveCamera()->Azimuth(-30.0);
  EXPECT_EQ(InkTestImage(first.Window).CountDifferent(expected), 0) << "the first picture again";
}

/// Asking about layers frees nothing, for which no context is current, and knows a drawing from none.
TEST(SplattingLinesWindows, DrawnLayers)
{
  SplattingLinesScene scene(Points());
  vtkNew<vtkRenderer> unseen;
  {
    // Its drawing stays until the mapper draws again.
    vtkNew<vtkActor> actor;
    actor->SetMapper(scene.Mapper);
    scene.Renderer->AddActor(actor);
    scene.Window->Render();
    actor->SetMapper(nullptr);
    scene.Renderer->RemoveActor(actor);
  }
  SplattingLinesScene other(Points());
  other.Window->Render();
  const InkTestImage before(other.Window);
  EXPECT_EQ(scene.Mapper->GetNumberOfDrawnLayers(scene.Renderer, scene.Actor), 1) << "one layer is drawn";
  EXPECT_EQ(scene.Mapper->GetNumberOfDrawnLayers(scene.Renderer, other.Actor), 0) << "none of another actor";
  EXPECT_EQ(scene.Mapper->GetNumberOfDrawnLayers(unseen, scene.Actor), 0) << "none without a window";
  // The names of the objects of one context mean others in another: those of the other window are all there.
  other.Renderer->GetActiveCamera()->Azimuth(10.0);
  other.Window->Render();
  other.Renderer->GetActiveCamera()->Azimuth(-10.0);
  EXPECT_EQ(InkTestImage(other.Window).CountDifferent(before), 0)
    << "the other window's drawing is untouched";
  EXPECT_GT(InkTestImage(scene.Window).CountDark(), 100) << "a picture after that";
}
