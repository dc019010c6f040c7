// SPDX-License-Identifier: BSD-3-Clause
// Hidden layers (Zhang et al. 2014, section 5.2) against a scene of which all is known: spheres within each
// other, of which each layer must show one ring.
#include "InkTestImage.h"
#include "InkTestPoints.h"
#include "SplattingLinesScene.h"

#include "vtkMath.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace
{

constexpr double Radii[3] = { 1.0, 0.6, 0.3 };

/// Concentric spheres, seen along z with parallel rays; a unit has 80 pixels.
class Spheres
{
public:
  explicit Spheres(int count = 3)
    : Scene(MakePoints(count))
  {
    this->Scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
    this->Scene.Renderer->GetActiveCamera()->SetParallelScale(1.25);
    this->Scene.Mapper->HiddenLayersOn();
    this->Scene.Mapper->SetNumberOfLayers(8);
    for (int layer = 0; layer < 8; ++layer)
    {
      this->Scene.Mapper->SetLayerStrength(layer, 1.0);
    }
  }
  int CountLayers()
  {
    this->Scene.Window->Render();
    return this->Scene.Mapper->GetNumberOfDrawnLayers(this->Scene.Renderer, this->Scene.Actor);
  }

  SplattingLinesScene Scene;

private:
  static vtkSmartPointer<vtkPolyData> MakePoints(int count)
  {
    auto points = InkTestPoints::Sphere(Radii[0], 0.03);
    for (int i = 1; i < count; ++i)
    {
      points = InkTestPoints::Join(points, InkTestPoints::Sphere(Radii[i], 0.03));
    }
    return points;
  }
};

/// The share of a ring's directions in which a channel is dark within two pixels of it.
double RingIn(const InkTestImage& image, double radius, int channel)
{
  int dark = 0;
  for (int degree = 0; degree < 360; ++degree)
  {
    const double angle = vtkMath::RadiansFromDegrees(double(degree));
    bool found = false;
    for (int across = -3; across <= 3; ++across)
    {
      const double r = 80.0 * radius - 1.0 + across;
      found = found ||
        image.Channel(static_cast<int>(100.0 + r * std::cos(angle)),
          static_cast<int>(100.0 + r * std::sin(angle)), channel) < 128;
    }
    dark += found;
  }
  return dark / 360.0;
}

/// Ink farther than some pixels from all rings.
int CountStray(const InkTestImage& image)
{
  int stray = 0;
  for (int y = 0; y < 200; ++y)
  {
    for (int x = 0; x < 200; ++x)
    {
      const double distance = std::hypot(x + 0.5 - 100.0, y + 0.5 - 100.0);
      bool near = false;
      for (double radius : Radii)
      {
        near = near || std::abs(distance - 80.0 * radius) < 8.0;
      }
      stray += !near && image.Gray(x, y) < 250;
    }
  }
  return stray;
}

/// A plane at some depth that covers the left half of the picture.
vtkSmartPointer<vtkActor> HalfPlane(double z, double opacity)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-2.0, -2.0, z);
  plane->SetPoint1(0.0, -2.0, z);
  plane->SetPoint2(-2.0, 2.0, z);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(1.0, 0.0, 0.0);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetOpacity(opacity);
  return actor;
}

} // namespace

/// As many layers as there are, and each one's ring in its color.
TEST(SplattingLinesLayers, Rings)
{
  Spheres spheres;
  vtkInkSplattingLinesMapper* mapper = spheres.Scene.Mapper;
  EXPECT_EQ(spheres.CountLayers(), 3) << "three layers that face the viewer, found " << spheres.CountLayers();
  // Each without one of the channels.
  mapper->SetInkColor(0.0, 1.0, 1.0);
  mapper->SetLayerColor(1, 1.0, 0.0, 1.0);
  mapper->SetLayerColor(2, 1.0, 1.0, 0.0);
  const InkTestImage image(spheres.Scene.Window);
  for (int layer = 0; layer < 3; ++layer)
  {
    for (int channel = 0; channel < 3; ++channel)
    {
      const double share = RingIn(image, Radii[layer], channel);
      EXPECT_TRUE(layer == channel ? share > 0.99 : share < 0.02)
        << "ring " << layer << " in channel " << channel << " only if they are the same; there in " << share
        << " of the directions";
    }
  }
  EXPECT_EQ(CountStray(image), 0) << "no ink but the rings, found " << CountStray(image);

  mapper->SetPeelBackFaces(true);
  EXPECT_EQ(spheres.CountLayers(), 6) << "six layers with their backs, found " << spheres.CountLayers();
  spheres.Scene.Actor->GetProperty()->BackfaceCullingOn();
  EXPECT_EQ(spheres.CountLayers(), 3)
    << "three layers where backs are culled, found " << spheres.CountLayers();
  mapper->SetAsPublished(true);
  EXPECT_EQ(spheres.CountLayers(), 3) << "three layers as published, found " << spheres.CountLayers();
}

TEST(SplattingLinesLayers, MoreLayersMoreInk)
{
  Spheres spheres;
  vtkInkSplattingLinesMapper* mapper = spheres.Scene.Mapper;
  mapper->HiddenLayersOff();
  const InkTestImage visible(spheres.Scene.Window);
  EXPECT_EQ(spheres.CountLayers(), 1) << "one layer by default";
  mapper->HiddenLayersOn();
  double last = 0.0;
  for (int layers = 1; layers <= 4; ++layers)
  {
    mapper->SetNumberOfLayers(layers);
    const InkTestImage image(spheres.Scene.Window);
    EXPECT_TRUE(layers > 1 || image.CountDifferent(visible) == 0) << "one layer is what is visible";
    EXPECT_TRUE(layers == 4 ? image.Ink() == last : image.Ink() > 1.1 * last)
      << "more ink with " << layers << " layers, as far as there are any: " << image.Ink() << " after "
      << last;
    last = image.Ink();
  }
  for (double strength : { 0.6, 0.3, 0.0 })
  {
    mapper->SetLayerStrength(1, strength);
    mapper->SetLayerStrength(2, strength);
    const InkTestImage image(spheres.Scene.Window);
    EXPECT_LT(image.Ink(), last) << "less ink with strength " << strength;
    last = image.Ink();
  }
  EXPECT_EQ(InkTestImage(spheres.Scene.Window).CountDifferent(visible), 0) << "no hidden ink of no strength";
}

TEST(SplattingLinesLayers, Defaults)
{
  vtkNew<vtkInkSplattingLinesMapper> mapper;
  EXPECT_TRUE(!mapper->GetHiddenLayers() && mapper->GetNumberOfLayers() == 2) << "off, and two layers";
  EXPECT_EQ(mapper->GetLayerStrength(0), 1.0) << "all ink for the visible layer";
  for (int layer = 1; layer < 8; ++layer)
  {
    EXPECT_LT(mapper->GetLayerStrength(layer), mapper->GetLayerStrength(layer - 1)) << "fainter and fainter";
  }
  mapper->SetLayerStrength(3, 7.0);
  EXPECT_EQ(mapper->GetLayerStrength(3), 1.0) << "strength within its range";
  mapper->SetInkColor(0.5, 0.2, 0.1);
  double color[3];
  mapper->GetLayerColor(5, color);
  EXPECT_TRUE(color[0] == 0.5 && color[2] == 0.1) << "the ink's color for layers without their own";
}

/// Hidden lines have the colors of their own layer's points, until they are given one.
TEST(SplattingLinesLayers, Scalars)
{
  Spheres spheres;
  vtkInkSplattingLinesMapper* mapper = spheres.Scene.Mapper;
  // The outer sphere red, the middle one green, the inner one blue.
  auto points = vtkSmartPointer<vtkPolyData>::New();
  points->ShallowCopy(mapper->GetInput());
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("Colors");
  colors->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    const double radius = vtkMath::Norm(points->GetPoint(i));
    const int sphere = radius > 0.8 ? 0 : radius > 0.45 ? 1 : 2;
    colors->InsertNextTuple3(sphere == 0 ? 255 : 0, sphere == 1 ? 255 : 0, sphere == 2 ? 255 : 0);
  }
  points->GetPointData()->SetScalars(colors);
  mapper->SetInputData(points);
  mapper->SetInkColorModeToScalars();
  for (bool paper : { true, false })
  {
    mapper->SetPaperVisibility(paper);
    const InkTestImage image(spheres.Scene.Window);
    for (int sphere = 0; sphere < 3; ++sphere)
    {
      for (int channel = 0; channel < 3; ++channel)
      {
        // Ink of one color is dark in the others.
        const double dark = RingIn(image, Radii[sphere], channel);
        EXPECT_TRUE(channel == sphere ? dark < 0.05 : dark > 0.95)
          << "sphere " << sphere << " in its points' color; " << dark << " of its ring is dark in channel "
          << channel;
      }
    }
  }
  mapper->SetLayerColor(1, 0.0, 0.0, 1.0);
  const InkTestImage own(spheres.Scene.Window);
  EXPECT_TRUE(RingIn(own, Radii[1], 1) > 0.95 && RingIn(own, Radii[1], 2) < 0.05) << "a layer's own color";
  EXPECT_TRUE(RingIn(own, Radii[2], 2) < 0.05 && RingIn(own, Radii[0], 0) < 0.05)
    << "and the others as before";
  mapper->ResetLayerColor(1);
  EXPECT_LT(RingIn(InkTestImage(spheres.Scene.Window), Radii[1], 1), 0.05) << "its points' color again";
}

/// Without paper each layer is at its own depth: what stands between two layers hides the farther one, or
/// tints it where it is translucent and depth peeling is on.
TEST(SplattingLinesLayers, OtherActors)
{
  for (double opacity : { 1.0, 0.5 })
  {
    Spheres spheres(2);
    spheres.Scene.Mapper->PaperVisibilityOff();
    spheres.Scene.Renderer->AddActor(HalfPlane(0.8, opacity));
    spheres.Scene.Renderer->UseDepthPeelingOn();
    spheres.Scene.Window->AlphaBitPlanesOn();
    spheres.Scene.Renderer->ResetCameraClippingRange();
    const InkTestImage image(spheres.Scene.Window);
    const std::string what = opacity < 1.0 ? " (translucent)" : " (opaque)";
    // On the far sphere's ring to the right and to the left, in red and in green.
    const auto darkest = [&image](int x, int channel)
    {
      int least = 255;
      for (int across = -3; across <= 3; ++across)
      {
        least = std::min(least, image.Channel(x + across, 100, channel));
      }
      return least;
    };
    EXPECT_LT(darkest(147, 0), 80) << "the far sphere's ring where nothing hides it" << what << ": "
                                   << darkest(147, 0);
    const int behind = darkest(53, 0);
    EXPECT_TRUE(opacity == 1.0 ? behind == 255 : behind > 100 && behind < 200)
      << "the far sphere's ring behind the plane" << what << ": " << behind;
    // The near sphere's front is before the plane only near its middle; its ring lies behind, at z 0.
    EXPECT_LT(image.Channel(60, 160, 1), 200) << "the plane itself" << what;
  }
}

/// Hidden sheets that lie one right behind the other are one layer; a plane's own points make no second one.
TEST(SplattingLinesLayers, Coplanar)
{
  SplattingLinesScene scene(InkTestPoints::Plane(2.0, 0.03));
  scene.Mapper->HiddenLayersOn();
  scene.Mapper->SetNumberOfLayers(8);
  scene.Mapper->PeelBackFacesOn();
  for (double angle : { 0.0, 30.0, 60.0, 80.0 })
  {
    scene.Renderer->GetActiveCamera()->Azimuth(angle);
    scene.Renderer->ResetCamera();
    scene.Window->Render();
    const int layers = scene.Mapper->GetNumberOfDrawnLayers(scene.Renderer, scene.Actor);
    EXPECT_EQ(layers, 1) << "one layer for a plane turned by " << angle << " more degrees, found " << layers;
    scene.Renderer->GetActiveCamera()->Azimuth(-angle);
  }
}
