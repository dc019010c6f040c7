// SPDX-License-Identifier: BSD-3-Clause
// vtkInkStippleActor: the picture of vtkActor, by another way; among other actors, in selections.
#include "StippleScene.h"

#include "InkTestImage.h"
#include "InkTestStipples.h"
#include "vtkInkStippleActor.h"

#include "vtkAssembly.h"
#include "vtkCameraPass.h"
#include "vtkDualDepthPeelingPass.h"
#include "vtkHardwareSelector.h"
#include "vtkLightsPass.h"
#include "vtkOpaquePass.h"
#include "vtkOrderIndependentTranslucentPass.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderStepsPass.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkSequencePass.h"
#include "vtkSphereSource.h"
#include "vtkTranslucentPass.h"
#include "vtkVolume.h"
#include "vtkVolumetricPass.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace
{

vtkSmartPointer<vtkPolyData> Voxels()
{
  return InkTestStipples::SphereVoxels(1.0, 0.1, 16);
}

/// A scene with one actor or the other.
class Scene : public StippleScene
{
public:
  explicit Scene(bool straight)
    : StippleScene(Voxels())
  {
    if (straight)
    {
      this->Renderer->RemoveActor(this->Actor);
      this->Straight->SetMapper(this->Mapper);
      this->Renderer->AddActor(this->Straight);
    }
  }
  void AddSphere(double radius, double opacity)
  {
    vtkNew<vtkSphereSource> source;
    source->SetRadius(radius);
    source->SetThetaResolution(40);
    source->SetPhiResolution(40);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(source->GetOutputPort());
    this->Sphere->SetMapper(mapper);
    this->Sphere->GetProperty()->SetColor(1.0, 0.0, 0.0);
    this->Sphere->GetProperty()->SetOpacity(opacity);
    this->Renderer->AddActor(this->Sphere);
  }

  vtkNew<vtkInkStippleActor> Straight;
  vtkNew<vtkActor> Sphere;
};

/// A pass that knows of none of the others: opaque and translucent props.
class OwnPass : public vtkRenderPass
{
public:
  static OwnPass* New() { return new OwnPass; }
  vtkTypeMacro(OwnPass, vtkRenderPass);
  void Render(const vtkRenderState* state) override
  {
    this->Opaque->Render(state);
    this->Translucent->Render(state);
  }

private:
  vtkNew<vtkOpaquePass> Opaque;
  vtkNew<vtkTranslucentPass> Translucent;
};

} // namespace

TEST(StippleActor, Picture)
{
  for (const bool peeled : { false, true })
  {
    for (const double opacity : { 1.0, 0.4 })
    {
      Scene usual(false);
      usual.Actor->GetProperty()->SetOpacity(opacity);
      const InkTestImage expected(usual.Window);
      Scene scene(true);
      scene.Renderer->SetUseDepthPeeling(peeled);
      scene.Straight->GetProperty()->SetOpacity(opacity);
      const InkTestImage picture(scene.Window);
      EXPECT_FALSE(scene.Straight->HasTranslucentPolygonalGeometry()) << "nothing for the translucent pass";
      EXPECT_TRUE(expected.Ink() > 100.0 && picture.CountDifferent(expected, 24) < 40)
        << "vtkActor's picture, opacity " << opacity << (peeled ? ", peeled: " : ": ")
        << picture.CountDifferent(expected, 24) << " pixels differ";
      EXPECT_LT(std::abs(picture.Ink() / expected.Ink() - 1.0), 0.02)
        << "its ink " << expected.Ink() << ", found " << picture.Ink();
    }
  }
}

/// Whatever the order in which actors were added.
TEST(StippleActor, BehindSurfaces)
{
  Scene usual(false);
  usual.AddSphere(1.02, 1.0);
  const InkTestImage expected(usual.Window);
  Scene scene(true);
  scene.AddSphere(1.02, 1.0);
  EXPECT_LT(InkTestImage(scene.Window).CountDifferent(expected, 24), 40) << "hidden by a surface added later";
  EXPECT_FALSE(scene.Straight->HasTranslucentPolygonalGeometry()) << "nothing for the translucent pass";
}

TEST(StippleActor, BesideTranslucent)
{
  Scene usual(false);
  usual.AddSphere(0.5, 0.4);
  const InkTestImage expected(usual.Window);
  Scene scene(true);
  scene.AddSphere(0.5, 0.4);
  const InkTestImage picture(scene.Window);
  EXPECT_TRUE(scene.Straight->HasTranslucentPolygonalGeometry()) << "a part of the translucent pass";
  EXPECT_EQ(picture.CountDifferent(expected), 0) << "vtkActor's picture";
  scene.Sphere->VisibilityOff();
  scene.Window->Render();
  EXPECT_FALSE(scene.Straight->HasTranslucentPolygonalGeometry()) << "alone again";

  // Another of its kind is no reason.
  vtkNew<vtkInkStippleActor> other;
  other->SetMapper(scene.Mapper);
  scene.Renderer->AddActor(other);
  EXPECT_FALSE(scene.Straight->HasTranslucentPolygonalGeometry()) << "beside another";

  // What a volume in front does to stipples is known to the translucent pass only.
  vtkNew<vtkVolume> volume;
  scene.Renderer->AddVolume(volume);
  EXPECT_TRUE(scene.Straight->HasTranslucentPolygonalGeometry())
    << "a part of the translucent pass beside a volume";
  scene.Renderer->RemoveVolume(volume);
  EXPECT_FALSE(scene.Straight->HasTranslucentPolygonalGeometry()) << "alone without the volume";

  // Asks its parts, of which this actor is one.
  vtkNew<vtkAssembly> assembly;
  assembly->AddPart(scene.Straight);
  scene.Renderer->AddActor(assembly);
  EXPECT_TRUE(scene.Straight->HasTranslucentPolygonalGeometry()) << "as vtkActor as a part of an assembly";

  vtkNew<vtkInkStippleActor> nowhere;
  nowhere->SetMapper(scene.Mapper);
  EXPECT_TRUE(nowhere->HasTranslucentPolygonalGeometry()) << "without a renderer as vtkActor";
}

TEST(StippleActor, Selection)
{
  const auto count = [](Scene& scene)
  {
    scene.Window->Render();
    vtkNew<vtkHardwareSelector> selector;
    selector->SetRenderer(scene.Renderer);
    selector->SetArea(0, 0, 199, 199);
    selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_POINTS);
    vtkSmartPointer<vtkSelection> selection;
    selection.TakeReference(selector->Select());
    return selection->GetNumberOfNodes() == 1 ? selection->GetNode(0)->GetSelectionList()->GetNumberOfTuples()
                                              : 0;
  };
  Scene usual(false);
  Scene scene(true);
  const vtkIdType expected = count(usual);
  EXPECT_TRUE(expected > 100 && count(scene) == expected)
    << "all " << expected << " selected stipples, " << count(scene);
}

/// In every chain of passes that draws vtkActor's stipples, and once where there are passes for both.
TEST(StippleActor, Passes)
{
  Scene usual(false);
  const InkTestImage expected(usual.Window);

  vtkNew<vtkLightsPass> lights;
  vtkNew<vtkOpaquePass> opaque;
  vtkNew<vtkTranslucentPass> translucent;
  vtkNew<vtkVolumetricPass> volumetric;
  vtkNew<vtkOrderIndependentTranslucentPass> anyOrder;
  anyOrder->SetTranslucentPass(translucent);
  vtkNew<vtkDualDepthPeelingPass> peeling;
  peeling->SetTranslucentPass(translucent);
  peeling->SetMaximumNumberOfPeels(20);
  vtkNew<vtkDefaultPass> all;
  vtkNew<vtkRenderStepsPass> steps;
  vtkNew<OwnPass> own;
  const std::pair<const char*, std::vector<vtkRenderPass*>> chains[] = {
    { "opaque, translucent", { lights, opaque, translucent } },
    { "opaque, translucent in any order", { lights, opaque, anyOrder } },
    { "opaque, peeled", { lights, opaque, peeling } },
    { "opaque, translucent, volumes", { lights, opaque, translucent, volumetric } },
    { "opaque, translucent in any order, volumes", { lights, opaque, anyOrder, volumetric } },
    { "opaque, volumes", { lights, opaque, volumetric } },
    { "all", { lights, all } },
    { "a pass of another library", { lights, own } },
    { "VTK's steps", {} },
  };
  for (const auto& [name, passes] : chains)
  {
    Scene scene(true);
    vtkNew<vtkRenderPassCollection> collection;
    for (vtkRenderPass* pass : passes)
    {
      collection->AddItem(pass);
    }
    vtkNew<vtkSequencePass> sequence;
    sequence->SetPasses(collection);
    vtkNew<vtkCameraPass> camera;
    camera->SetDelegatePass(sequence);
    scene.Renderer->SetPass(passes.empty() ? static_cast<vtkRenderPass*>(steps) : camera);
    for (int picture = 0; picture < 2; ++picture)
    {
      const InkTestImage found(scene.Window);
      EXPECT_TRUE(
        found.CountDifferent(expected, 24) < 40 && std::abs(found.Ink() / expected.Ink() - 1.0) < 0.02)
        << "vtkActor's picture in the chain " << name << ": " << found.CountDifferent(expected, 24)
        << " pixels differ, ink " << expected.Ink() << ", found " << found.Ink();
    }
    scene.Renderer->SetPass(nullptr);
    EXPECT_LT(InkTestImage(scene.Window).CountDifferent(expected, 24), 40) << "after the chain " << name;
    for (vtkRenderPass* pass : passes)
    {
      pass->ReleaseGraphicsResources(scene.Window);
    }
    steps->ReleaseGraphicsResources(scene.Window);
  }
}
