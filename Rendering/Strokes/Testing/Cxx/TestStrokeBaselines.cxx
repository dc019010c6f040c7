// SPDX-License-Identifier: BSD-3-Clause
// Pictures that were checked by eye: contours, solid and with hidden parts dashed, of a mesh and of an image;
// strokes with a texture; line art.
#include "HatchedSurfaces.h"
#include "InkTestBaseline.h"
#include "InkTestImage.h"
#include "InkTestVolume.h"
#include "TubeSurfaces.h"
#include "vtkInkSilhouetteMapper.h"

#include "vtkImageData.h"
#include "vtkLight.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace
{

/// The thresholded difference that another rasterizer's rounding makes.
constexpr double Tolerance = 30.0;
constexpr int Size = 240;

template <class Scene>
void Compare(Scene& scene, const char* name, double height = 3.0)
{
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetPosition(1.0, -4.0, height);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(38.0);
  scene.Renderer->ResetCameraClippingRange();
  EXPECT_TRUE(InkTestMatchesBaseline(InkTestImage(scene.Window), name, Tolerance)) << "the baseline " << name;
}

class Outlines : public InkTestScene<vtkInkSilhouetteMapper>
{
public:
  explicit Outlines(vtkPolyData* surface)
    : InkTestScene(surface, Size, Size)
  {
    this->Mapper->SetSizeUnitToPixels();
    this->Mapper->SetLineWidth(3.0);
    this->Mapper->SetDepthWidth(0.5);
  }
};

/// Five bristles, each of which ends and begins again.
vtkSmartPointer<vtkImageData> Bristles()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(64, 20, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  for (int y = 0; y < 20; ++y)
  {
    for (int x = 0; x < 64; ++x)
    {
      const int bristle = y / 4;
      const bool ink = y % 4 < 3 && (x + 23 * bristle) % 64 < 44;
      image->SetScalarComponentFromDouble(x, y, 0, 0, ink ? 255.0 : 0.0);
    }
  }
  return image;
}

} // namespace

TEST(StrokeBaselines, Contours)
{
  Outlines scene(MakeKnot().Mesh(200, 60));
  Compare(scene, "ContoursKnot");
}

TEST(StrokeBaselines, HiddenPartsOfAnImage)
{
  const TubeSurface torus = MakeTorus();
  vtkNew<vtkImageData> image;
  image->SetDimensions(61, 61, 23);
  image->SetOrigin(-1.5, -1.5, -0.55);
  image->SetSpacing(0.05, 0.05, 0.05);
  InkTestFill(image, VTK_FLOAT, [&](double x, double y, double z) { return -torus.Distance({ x, y, z }); });
  Outlines scene(nullptr);
  scene.Mapper->SetInputData(image);
  scene.Mapper->SetValue(0, 0.0);
  scene.Mapper->SetHiddenPartsToDashed();
  scene.Mapper->SetDashLength(7.0);
  scene.Mapper->SetGapLength(5.0);
  Compare(scene, "ContoursTorusHidden", 1.3);
}

TEST(StrokeBaselines, Texture)
{
  Outlines scene(MakeKnot().Mesh(200, 60));
  scene.Mapper->SetLineWidth(10.0);
  scene.Mapper->SetTexture(Bristles());
  scene.Mapper->SetTextureLength(5.0);
  scene.Mapper->SetInkColor(0.3, 0.1, 0.0);
  Compare(scene, "StrokesWithTexture");
}

/// A torus, hatched around its tube and, in the shade, along it.
TEST(StrokeBaselines, LineArt)
{
  constexpr double major = 1.0;
  constexpr double minor = 0.4;
  const auto normalAt = [](double along, double around)
  {
    const double a = 2.0 * std::numbers::pi * along;
    const double b = 2.0 * std::numbers::pi * around;
    return std::array<double, 3>{ std::cos(b) * std::cos(a), std::cos(b) * std::sin(a), std::sin(b) };
  };
  const auto pointAt = [&](double along, double around)
  {
    const double a = 2.0 * std::numbers::pi * along;
    const std::array<double, 3> n = normalAt(along, around);
    return std::array<double, 3>{ major * std::cos(a) + minor * n[0], major * std::sin(a) + minor * n[1],
      minor * n[2] };
  };
  HatchedSurfaces lines;
  lines.Add(
    8, 2.0 * std::numbers::pi * major / 256.0, 0, [&](double u, double v) { return pointAt(v, u); },
    [&](double u, double v) { return normalAt(v, u); });
  lines.Add(
    7, 2.0 * std::numbers::pi * minor / 128.0, 1, [&](double u, double v) { return pointAt(u, v); },
    [&](double u, double v) { return normalAt(u, v); }, 128);
  HatchingScene scene(lines.Make(), Size);
  scene.Mapper->SetHatchSpacing(4.0);
  scene.Mapper->SetCrosshatching(0.6);
  scene.Mapper->SetSilhouetteWeight(0.3);
  scene.Mapper->SetSurfaceData(MakeTorus().Mesh(120, 60));
  vtkNew<vtkLight> light;
  light->SetLightTypeToCameraLight();
  light->SetPosition(-1.0, 1.0, 1.0);
  scene.Renderer->AddLight(light);
  Compare(scene, "LineArtTorus");
}
