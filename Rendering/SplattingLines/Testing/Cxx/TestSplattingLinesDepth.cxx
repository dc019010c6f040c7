// SPDX-License-Identifier: BSD-3-Clause
// Splatting lines among other actors: what hides what, with and without paper, with opacity and depth
// peeling.
#include "InkTestImage.h"
#include "InkTestPoints.h"
#include "SplattingLinesScene.h"

#include "vtkCellArray.h"
#include "vtkPlane.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

#include <gtest/gtest.h>

#include <string>

namespace
{

/// A flat square of a color, facing the viewer at some z.
class Square
{
public:
  Square(double halfSide, double z, double red, double green, double blue)
  {
    vtkNew<vtkPoints> points;
    points->InsertNextPoint(-halfSide, -halfSide, z);
    points->InsertNextPoint(halfSide, -halfSide, z);
    points->InsertNextPoint(halfSide, halfSide, z);
    points->InsertNextPoint(-halfSide, halfSide, z);
    const vtkIdType ids[4] = { 0, 1, 2, 3 };
    vtkNew<vtkCellArray> cells;
    cells->InsertNextCell(4, ids);
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetPolys(cells);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    this->Actor->SetMapper(mapper);
    this->Actor->GetProperty()->SetColor(red, green, blue);
    this->Actor->GetProperty()->LightingOff();
  }
  vtkNew<vtkActor> Actor;
};

/// A sphere of radius 1, from 20 to 180 of 200 pixels.
class SphereScene : public SplattingLinesScene
{
public:
  SphereScene()
    : SplattingLinesScene(InkTestPoints::Sphere(1.0, 0.04))
  {
    this->Renderer->GetActiveCamera()->ParallelProjectionOn();
    this->Renderer->GetActiveCamera()->SetParallelScale(1.25);
    this->Renderer->SetBackground(0.5, 0.5, 0.5);
  }
};

bool IsRed(const InkTestImage& image, int x, int y)
{
  return image.Channel(x, y, 0) > 240 && image.Channel(x, y, 1) < 15;
}

} // namespace

/// Actors before, behind and through the sphere, whichever is drawn first.
TEST(SplattingLinesDepth, Paper)
{
  for (bool first : { true, false })
  {
    for (double z : { 2.0, -2.0, 0.8 })
    {
      SphereScene scene;
      Square square(0.9, z, 1.0, 0.0, 0.0);
      if (first)
      {
        scene.Renderer->RemoveActor(scene.Actor);
        scene.Renderer->AddActor(square.Actor);
        scene.Renderer->AddActor(scene.Actor);
      }
      else
      {
        scene.Renderer->AddActor(square.Actor);
      }
      scene.Renderer->ResetCameraClippingRange();
      const InkTestImage image(scene.Window);
      const std::string where = " with a square at z " + std::to_string(z);
      // The sphere is nearer than the plane z = 0.8 within 0.6 of its center, 48 pixels.
      EXPECT_EQ(IsRed(image, 100, 100), (z > 1.0)) << "the sphere's front" << where;
      EXPECT_TRUE(image.Gray(100, 100) == 255 || z > 1.0) << "paper in front of the square" << where;
      EXPECT_EQ(IsRed(image, 100, 100 + 55), (z > 0.0)) << "the sphere's side" << where;
      EXPECT_EQ(IsRed(image, 100 + 68, 100 + 68), true) << "the square beside the sphere" << where;
    }
  }
}

/// Ink without paper lies over what is behind, is hidden by what is before, and leaves the rest untouched.
TEST(SplattingLinesDepth, InkOnly)
{
  for (bool peeling : { false, true })
  {
    SphereScene scene;
    scene.Renderer->SetUseDepthPeeling(peeling);
    scene.Mapper->PaperVisibilityOff();
    // As bright as the squares.
    scene.Renderer->SetBackground(2.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0);
    const std::string how = peeling ? " (depth peeling)" : "";

    const InkTestImage alone(scene.Window);
    const int ring = alone.CountDark(64);
    EXPECT_GT(ring, 300) << "a ring of ink, " << ring << " pixels" << how;
    EXPECT_EQ(alone.Gray(100, 100), alone.Gray(2, 2)) << "the background within the ring" << how;

    Square behind(1.2, -2.0, 1.0, 1.0, 0.0);
    scene.Renderer->AddActor(behind.Actor);
    scene.Renderer->ResetCameraClippingRange();
    const InkTestImage over(scene.Window);
    EXPECT_EQ(over.CountDark(64), ring)
      << "the same ring over a square behind, " << over.CountDark(64) << " pixels, not " << ring << how;
    EXPECT_TRUE(over.Channel(100, 100, 0) == 255 && over.Channel(100, 100, 2) == 0)
      << "the square within the ring" << how;
    scene.Renderer->RemoveActor(behind.Actor);

    Square before(1.2, 2.0, 1.0, 1.0, 0.0);
    scene.Renderer->AddActor(before.Actor);
    scene.Renderer->ResetCameraClippingRange();
    EXPECT_EQ(InkTestImage(scene.Window).CountDark(64), 0) << "no ink behind a square" << how;
  }
}

/// Ink drawn over the very surface that the points are on does not sink into it, even where that surface lies
/// half a splat further out.
TEST(SplattingLinesDepth, InkOnItsSurface)
{
  SplattingLinesScene scene(InkTestPoints::Plane(2.0, 0.05));
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.Mapper->PaperVisibilityOff();
  scene.Mapper->SetRadius(0.06);
  scene.Mapper->SetTau(1.2); // ink everywhere
  Square square(1.0, 0.03, 1.0, 1.0, 0.0);
  scene.Renderer->AddActor(square.Actor);
  scene.Renderer->GetActiveCamera()->Elevation(40.0);
  scene.Renderer->ResetCamera();
  const InkTestImage image(scene.Window);
  const int dark = image.CountDark(80, 80, 120, 120);
  EXPECT_EQ(dark, 40 * 40) << "ink all over the surface, " << dark << " of 1600 pixels";
}

/// A translucent actor is blended, sorted by depth peeling.
TEST(SplattingLinesDepth, Opacity)
{
  for (bool peeling : { false, true })
  {
    for (bool before : { false, true })
    {
      SphereScene scene;
      scene.Renderer->SetUseDepthPeeling(peeling);
      scene.Renderer->SetBackground(0.0, 0.0, 0.0);
      scene.Actor->GetProperty()->SetOpacity(0.5);
      const std::string how = peeling ? " (depth peeling)" : "";
      const int half = InkTestImage(scene.Window).Gray(100, 100);
      EXPECT_TRUE(half > 120 && half < 135) << "half the paper's brightness, " << half << how;
      if (!peeling)
      {
        continue;
      }
      // Half of blue over half of white, or half of white over half of blue.
      Square square(0.9, before ? 2.0 : -2.0, 0.0, 0.0, 1.0);
      square.Actor->GetProperty()->SetOpacity(0.5);
      scene.Renderer->AddActor(square.Actor);
      scene.Renderer->ResetCameraClippingRange();
      const InkTestImage image(scene.Window);
      const int red = image.Channel(100, 100, 0);
      const int expected = before ? 64 : 128;
      EXPECT_LT(std::abs(red - expected), 6) << "red " << expected << " with a translucent square "
                                             << (before ? "before" : "behind") << ": " << red;
    }
  }
}
