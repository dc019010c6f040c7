// SPDX-License-Identifier: BSD-3-Clause
// The silhouettes of surfaces in Lu et al. (2003, section 5.6): lines in image space and toon shading.
#include "InkTestImage.h"
#include "InkTestMessages.h"
#include "InkTestScene.h"
#include "InkTestViewports.h"
#include "vtkInkSilhouetteMapper.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace
{

constexpr double Pi = std::numbers::pi;

vtkSmartPointer<vtkPolyData> Sphere(double x = 0.0, double z = 0.0, double radius = 1.0)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(x, 0.0, z);
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(128);
  sphere->SetPhiResolution(128);
  sphere->Update();
  return sphere->GetOutput();
}

vtkSmartPointer<vtkPolyData> Join(vtkPolyData* one, vtkPolyData* other)
{
  vtkNew<vtkAppendPolyData> append;
  append->AddInputData(one);
  append->AddInputData(other);
  append->Update();
  return append->GetOutput();
}

/// Looks along -z at a sphere of radius 1, which is 60 pixels in a window of 200.
class Scene : public InkTestScene<vtkInkSilhouetteMapper>
{
public:
  Scene(vtkPolyData* data, int method, int size = 200)
    : InkTestScene(data, size, size)
  {
    this->Mapper->SetMethod(method);
    this->Mapper->SetSizeUnitToPixels();
    this->Mapper->SetLineWidth(6.0);
    this->Mapper->ThinningOff();
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(100.0 / 60.0);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetPosition(0.0, 0.0, 10.0);
    camera->SetClippingRange(5.0, 15.0);
  }
  double Ink() { return InkTestImage(this->Window).Ink(); }
};

constexpr double Radius = 60.0; ///< pixels

/// Lines in image space are blended where they overlap: their smooth rims are darker and so broader, by that
/// many pixels; measured .75 to 1.0.
constexpr double Fringe = 0.85;

/// How many of 100 pixels around the middle, in a circle, are dark.
int CountAround(const InkTestImage& image, double radius, double x = 100.0, double y = 100.0)
{
  int dark = 0;
  for (int i = 0; i < 100; ++i)
  {
    const double angle = (i + 0.5) * 2.0 * Pi / 100;
    dark += image.IsDark(
      static_cast<int>(x + radius * std::cos(angle)), static_cast<int>(y + radius * std::sin(angle)));
  }
  return dark;
}

constexpr int ImageSpace = vtkInkSilhouetteMapper::IMAGE_SPACE;
constexpr int Toon = vtkInkSilhouetteMapper::TOON;

} // namespace

/// Half of the line's width reaches past the front of a sphere.
TEST(ImageSpaceSilhouettes, Sphere)
{
  Scene scene(Sphere(), ImageSpace);
  for (const double azimuth : { 0.0, 17.0, 90.0 })
  {
    scene.Renderer->GetActiveCamera()->Azimuth(azimuth);
    const InkTestImage image(scene.Window);
    EXPECT_NEAR(image.Ink() / (2.0 * Pi * Radius), 3.0 + Fringe, 0.3);
    EXPECT_EQ(CountAround(image, Radius + 1.5), 100);
    EXPECT_EQ(CountAround(image, Radius - 2.5), 0);
    EXPECT_EQ(CountAround(image, 0.5 * Radius), 0);
    EXPECT_EQ(CountAround(image, Radius + 4.5), 0);
  }
  EXPECT_EQ(scene.Mapper->GetContours(scene.Renderer, scene.Actor), nullptr);
  scene.Mapper->SilhouettesOff();
  EXPECT_EQ(scene.Ink(), 0.0);
}

/// Whichever way the polygons run.
TEST(ImageSpaceSilhouettes, InsideOut)
{
  const auto sphere = Sphere();
  Scene scene(sphere, ImageSpace);
  const InkTestImage before(scene.Window);
  for (vtkIdType cell = 0; cell < sphere->GetNumberOfPolys(); ++cell)
  {
    sphere->GetPolys()->ReverseCellAtId(cell);
  }
  sphere->GetPolys()->Modified();
  sphere->Modified();
  EXPECT_LE(InkTestImage(scene.Window).CountDifferent(before, 30), 100);
  EXPECT_EQ(CountAround(InkTestImage(scene.Window), 0.5 * Radius), 0);
}

/// A sphere before another one has its line on that.
TEST(ImageSpaceSilhouettes, BeforeAnotherPart)
{
  Scene scene(Join(Sphere(0.0, 0.0), Sphere(0.5, -2.5)), ImageSpace);
  const InkTestImage image(scene.Window);
  EXPECT_EQ(CountAround(image, Radius + 1.5), 100);
  EXPECT_LT(CountAround(image, Radius - 2.5), 8);
  // That of the other one only where it is in view.
  const int visible = CountAround(image, Radius + 1.5, 130.0);
  EXPECT_TRUE(visible > 55 && visible < 64) << visible;
}

/// Its lines lie on each other with other arc lengths: dashes and an image along them would make them gray.
TEST(ImageSpaceSilhouettes, NeitherDashesNorTexture)
{
  Scene scene(Sphere(), ImageSpace);
  const InkTestImage plain(scene.Window);
  scene.Mapper->DashedOn();
  EXPECT_EQ(InkTestImage(scene.Window).CountDifferent(plain), 0);
  scene.Mapper->DashedOff();
  scene.Mapper->SetHiddenPartsToDashed();
  EXPECT_EQ(InkTestImage(scene.Window).CountDifferent(plain), 0);
  vtkNew<vtkImageData> texture;
  texture->SetDimensions(2, 2, 1);
  texture->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  texture->GetPointData()->GetScalars()->Fill(100.0);
  scene.Mapper->SetTexture(texture);
  EXPECT_EQ(InkTestImage(scene.Window).CountDifferent(plain), 0);
}

/// The line becomes thinner as the projected bounding sphere does, and is as given where that fills the view.
TEST(ImageSpaceSilhouettes, Thinning)
{
  for (const bool parallel : { true, false })
  {
    Scene scene(Sphere(), ImageSpace);
    vtkCamera* camera = scene.Renderer->GetActiveCamera();
    camera->SetParallelProjection(parallel);
    camera->SetViewAngle(2.0 * std::atan(100.0 / 60.0 / 10.0) * 180.0 / Pi);
    camera->SetClippingRange(1.0, 30.0);
    const double circle = 2.0 * Pi * Radius;
    EXPECT_NEAR(scene.Ink() / circle, 3.0 + Fringe, 0.3);
    // The diagonal of the bounding box of a sphere is sqrt(3) times its diameter: 104 of 100 pixels.
    scene.Mapper->ThinningOn();
    EXPECT_NEAR(scene.Ink() / circle, 3.0 + Fringe, 0.3);
    camera->SetParallelScale(camera->GetParallelScale() * 2.0);
    camera->SetPosition(0.0, 0.0, 20.0);
    const double half = 2.0 * 0.5 * Radius * std::sqrt(3.0) / 200.0;
    EXPECT_NEAR(scene.Ink() / (0.5 * circle), 3.0 * half + Fringe, 0.3);
    scene.Mapper->ThinningOff();
    EXPECT_NEAR(scene.Ink() / (0.5 * circle), 3.0 + Fringe, 0.3);
  }
}

/// A surface is ink where the cosine is small: of a sphere that share of its disc is the cosine's square.
TEST(ToonSilhouettes, Sphere)
{
  Scene scene(Sphere(), Toon);
  for (const double cosine : { 0.3, 0.4, 0.8, 1.0 })
  {
    scene.Mapper->SetLargestCosine(cosine);
    const InkTestImage image(scene.Window);
    EXPECT_NEAR(image.Ink() / (Pi * Radius * Radius), cosine * cosine, 0.012) << cosine;
    const double inner = Radius * std::sqrt(1.0 - cosine * cosine);
    EXPECT_EQ(CountAround(image, 0.5 * (inner + Radius)), 100) << cosine;
    EXPECT_EQ(inner < 4.0 ? 0 : CountAround(image, inner - 2.0), 0) << cosine;
    EXPECT_EQ(CountAround(image, Radius + 2.0), 0);
  }
  scene.Mapper->SetLargestCosine(0.4);
  scene.Mapper->SetInkColor(1.0, 0.0, 0.0);
  scene.Actor->GetProperty()->SetOpacity(0.5);
  EXPECT_NEAR(InkTestImage(scene.Window).Channel(158, 100, 1), 128, 2);
  EXPECT_EQ(InkTestImage(scene.Window).Channel(158, 100, 0), 255);
  scene.Mapper->SilhouettesOff();
  EXPECT_EQ(scene.Ink(), 0.0);
}

/// The default of .1: a rim of half a hundredth of the radius, 1.5 pixels here, smooth on both sides.
TEST(ToonSilhouettes, ThinRim)
{
  constexpr double scale = 5.0;
  Scene scene(Sphere(), Toon, static_cast<int>(200 * scale));
  ASSERT_EQ(scene.Mapper->GetLargestCosine(), 0.1);
  const InkTestImage image(scene.Window);
  const double area = Pi * scale * Radius * scale * Radius;
  EXPECT_NEAR(image.Ink() / area, 0.01, 0.0007);
  const double rim = scale * Radius * (1.0 - std::sqrt(0.99));
  const auto around = [&](double radius) { return CountAround(image, radius, 100.0 * scale, 100.0 * scale); };
  EXPECT_GE(around(scale * Radius - 0.5 * rim), 99);
  EXPECT_EQ(around(scale * Radius - rim - 1.5), 0);
  EXPECT_EQ(around(scale * Radius + 1.5), 0);
}

/// The edge of the ink is as smooth as a pixel, and no more.
TEST(ToonSilhouettes, SmoothEdge)
{
  Scene scene(Sphere(), Toon);
  scene.Mapper->SetLargestCosine(0.4);
  const InkTestImage image(scene.Window);
  const double inner = Radius * std::sqrt(1.0 - 0.16);
  int gray = 0;
  for (int y = 0; y < 200; ++y)
  {
    for (int x = 0; x < 200; ++x)
    {
      const bool beside = std::abs(std::hypot(x - 99.5, y - 99.5) - inner) < 4.0;
      gray += beside && image.Gray(x, y) > 10 && image.Gray(x, y) < 245;
    }
  }
  // Between 1 and sqrt(2) pixels wide.
  EXPECT_NEAR(gray / (2.0 * Pi * inner), 1.2, 0.3);
}

/// Whichever way normals point, and where the surface faces the eye.
TEST(ToonSilhouettes, EitherSide)
{
  const auto sphere = Sphere();
  Scene scene(sphere, Toon);
  scene.Mapper->SetLargestCosine(0.4);
  const InkTestImage before(scene.Window);
  vtkDataArray* normals = sphere->GetPointData()->GetNormals();
  for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); ++i)
  {
    double normal[3];
    normals->GetTuple(i, normal);
    normals->SetTuple3(i, -normal[0], -normal[1], -normal[2]);
  }
  normals->Modified();
  sphere->Modified();
  EXPECT_EQ(InkTestImage(scene.Window).CountDifferent(before), 0);
  vtkNew<vtkPlaneSource> plane;
  plane->Update();
  Scene facing(plane->GetOutput(), Toon);
  facing.Mapper->SetLargestCosine(1.0);
  EXPECT_NEAR(facing.Ink() / (Radius * Radius), 1.0, 0.02) << "a square of side 1";
}

/// What lies behind is hidden.
TEST(ToonSilhouettes, BeforeAnotherPart)
{
  Scene scene(Join(Sphere(0.0, 0.0), Sphere(0.0, -2.5, 0.7)), Toon);
  scene.Mapper->SetLargestCosine(0.4);
  const InkTestImage image(scene.Window);
  Scene alone(Sphere(), Toon);
  alone.Mapper->SetLargestCosine(0.4);
  EXPECT_LE(InkTestImage(alone.Window).CountDifferent(image, 20), 4);
}

/// Both with clipping planes, in tiles, in several viewports, and found by selection.
TEST(PublishedSilhouettes, ClippingTilesViewportsAndSelection)
{
  for (const int method : { ImageSpace, Toon })
  {
    const auto sphere = Sphere();
    Scene scene(sphere, method, 100);
    scene.Mapper->SetSizeUnitToThousandths();
    scene.Mapper->SetLineWidth(40.0);
    scene.Mapper->SetLargestCosine(0.4);
    const InkTestImage all(scene.Window);
    const InkTestImage tiles(scene.Window, 2);
    scene.Window->SetSize(200, 200);
    const InkTestImage large(scene.Window);
    EXPECT_LE(tiles.CountDifferent(large, 8), 20) << method;

    vtkNew<vtkHardwareSelector> selector;
    selector->SetRenderer(scene.Renderer);
    selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_POINTS);
    selector->SetArea(110, 0, 199, 199);
    const auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
    ASSERT_EQ(selection->GetNumberOfNodes(), 1u) << method;
    auto* ids = vtkIdTypeArray::SafeDownCast(selection->GetNode(0)->GetSelectionList());
    EXPECT_GT(ids->GetNumberOfTuples(), 10) << method;
    for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
    {
      double p[3];
      sphere->GetPoint(ids->GetValue(i), p);
      EXPECT_TRUE(p[0] > 0.05 && std::abs(p[2]) < 0.5) << method;
    }

    vtkNew<vtkPlane> plane;
    plane->SetNormal(1.0, 0.0, 0.0);
    scene.Mapper->AddClippingPlane(plane);
    const InkTestImage clipped(scene.Window);
    // Half a line reaches past the cut.
    EXPECT_EQ(clipped.CountDark(0, 0, 95, 200), 0) << method;
    EXPECT_EQ(clipped.CountDark(112, 0, 200, 200), large.CountDark(112, 0, 200, 200)) << method;
    scene.Mapper->RemoveAllClippingPlanes();

    InkTestScene<vtkInkSilhouetteMapper> pair(sphere, 100, 100);
    pair.Mapper->SetMethod(method);
    pair.Mapper->SetLargestCosine(0.4);
    const InkTestImage alone(pair.Window);
    EXPECT_GT(alone.CountDark(), 100) << method;
    pair.Window->SetSize(200, 100);
    EXPECT_LE(CountDifferentInViewports(alone, pair, pair.Actor, 8), 10) << method;
  }
}

TEST(PublishedSilhouettes, OddSurfaces)
{
  for (const int method : { ImageSpace, Toon })
  {
    const auto points = vtkSmartPointer<vtkPolyData>::New();
    points->SetPoints(Sphere()->GetPoints());
    Scene none(points, method);
    vtkNew<InkTestMessages> messages;
    messages->Observe(none.Mapper);
    EXPECT_EQ(none.Ink(), 0.0);
    none.Window->Render();
    messages->Expect("no polygons", { "polygons", "points" });

    // A point that is not finite takes its polygons with it.
    const auto torn = Sphere();
    torn->GetPoints()->SetPoint(5, std::nan(""), 0.0, 0.0);
    Scene hole(torn, method);
    Scene whole(Sphere(), method);
    const InkTestImage own(whole.Window);
    whole.Mapper->SetSurfaceData(vtkSmartPointer<vtkPolyData>::New());
    EXPECT_EQ(InkTestImage(whole.Window).CountDifferent(own), 0) << "the other surface is empty, " << method;
    EXPECT_NEAR(hole.Ink() / whole.Ink(), 1.0, 0.1) << method;
  }
  const auto bare = Sphere();
  bare->GetPointData()->SetNormals(nullptr);
  Scene computed(bare, Toon);
  vtkNew<InkTestMessages> warnings;
  warnings->Observe(computed.Mapper);
  Scene given(Sphere(), Toon);
  EXPECT_NEAR(computed.Ink() / given.Ink(), 1.0, 0.05);
  computed.Window->Render();
  warnings->Expect("no normals", { "normals", "computed" });
}
