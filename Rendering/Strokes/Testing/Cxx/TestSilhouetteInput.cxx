// SPDX-License-Identifier: BSD-3-Clause
// What silhouette mappers make of odd surfaces, and their parameters.
#include "InkTestImage.h"
#include "InkTestMesh.h"
#include "InkTestMessages.h"
#include "InkTestScene.h"
#include "vtkInkSilhouetteMapper.h"

#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace
{

using Scene = InkTestScene<vtkInkSilhouetteMapper>;

vtkSmartPointer<vtkPolyData> Sphere()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(1.0);
  sphere->SetThetaResolution(64);
  sphere->SetPhiResolution(64);
  sphere->Update();
  return sphere->GetOutput();
}

} // namespace

/// Faces with points that are not finite are left out, which is said once for each surface.
TEST(SilhouetteMapper, FacesThatAreNotFinite)
{
  for (const int method :
    { vtkInkSilhouetteMapper::CHAINS, vtkInkSilhouetteMapper::IMAGE_SPACE, vtkInkSilhouetteMapper::TOON })
  {
    const auto sphere = Sphere();
    Scene scene(sphere);
    scene.Mapper->SetMethod(method);
    scene.Mapper->SetHiddenPartsToFaint();
    vtkNew<InkTestMessages> messages;
    messages->Observe(scene.Mapper);
    const double ink = InkTestImage(scene.Window).Ink();
    messages->Expect("finite", {});
    sphere->GetPoints()->SetPoint(100, 0.0, NAN, 0.0);
    sphere->Modified();
    scene.Renderer->ResetCamera();
    EXPECT_NEAR(InkTestImage(scene.Window).Ink() / ink, 1.0, 0.2) << method;
    scene.Mapper->CreasesOn();
    scene.Renderer->GetActiveCamera()->Azimuth(1.0);
    scene.Window->Render();
    messages->Expect("one point", { "6 of 7936 faces have points that are not finite; expected finite" });

    messages->Messages.clear();
    const auto nothing = InkTestNotFiniteMesh();
    scene.Mapper->SetInputData(nothing);
    EXPECT_EQ(InkTestImage(scene.Window).Ink(), 0.0) << method;
    scene.Window->Render();
    messages->Expect("nothing finite", { InkTestNotFiniteFaces });
  }
}

TEST(SilhouetteMapper, OddSurfaces)
{
  const auto points = vtkSmartPointer<vtkPolyData>::New();
  points->SetPoints(Sphere()->GetPoints());
  Scene none(points);
  vtkNew<InkTestMessages> messages;
  messages->Observe(none.Mapper);
  EXPECT_EQ(InkTestImage(none.Window).Ink(), 0.0);
  none.Window->Render();
  messages->Expect("no polygons", { "polygons", "points" });

  const auto sphere = Sphere();
  const double ink = InkTestImage(Scene(sphere).Window).Ink();
  sphere->GetPointData()->SetNormals(nullptr);
  Scene computed(sphere);
  vtkNew<InkTestMessages> warnings;
  warnings->Observe(computed.Mapper);
  EXPECT_NEAR(InkTestImage(computed.Window).Ink() / ink, 1.0, 0.02);
  computed.Window->Render();
  warnings->Expect("no normals", { "normals", "computed" });

  Scene empty(vtkSmartPointer<vtkPolyData>::New());
  EXPECT_EQ(InkTestImage(empty.Window).Ink(), 0.0);
}

TEST(SilhouetteMapper, Parameters)
{
  vtkNew<vtkInkSilhouetteMapper> mapper;
  mapper->FacetedOn();
  mapper->CreasesOn();
  mapper->SetFeatureAngle(500.0);
  mapper->NonManifoldEdgesOn();
  mapper->CoherentDashesOff();
  mapper->SilhouettesOff();
  mapper->BordersOff();
  mapper->SetLineWidth(7.0);
  mapper->SetMethodToToon();
  mapper->SetLowestValue(1.0);
  mapper->SetHighestValue(2.0);
  mapper->SetLeastGradientMagnitude(3.0);
  mapper->SetLargestCosine(0.4);
  mapper->SetSegmentLength(5.0);
  mapper->ThinningOff();
  mapper->SetTextureLength(6.0);
  mapper->SetValue(0, 0.5); // VTK 9.2 leaves it undefined
  mapper->SetValue(1, 8.5);
  mapper->SetImageComponent(2);
  vtkNew<vtkImageData> texture;
  mapper->SetTexture(texture);
  vtkNew<vtkInkSilhouetteMapper> copy;
  copy->ShallowCopy(mapper);
  const auto print = [](vtkInkSilhouetteMapper* printed)
  {
    std::ostringstream text;
    printed->PrintSelf(text, vtkIndent());
    const std::string whole = text.str();
    return whole.substr(whole.find("SizeUnit"));
  };
  EXPECT_EQ(print(copy), print(mapper));
  for (const char* text : { "Silhouettes: Off", "Faceted: On", "Creases: On", "FeatureAngle: 180",
         "Borders: Off", "NonManifoldEdges: On", "CoherentDashes: Off", "LineWidth: 7", "Method: Toon",
         "LowestValue: 1", "HighestValue: 2", "LeastGradientMagnitude: 3", "LargestCosine: 0.4",
         "SegmentLength: 5", "Thinning: Off", "TextureLength: 6", "Values: 0.5 8.5", "ImageComponent: 2" })
  {
    EXPECT_NE(print(mapper).find(text), std::string::npos) << text;
  }
}
