// SPDX-License-Identifier: BSD-3-Clause
// vtkInkStippleActor: the picture of vtkActor, by another way; among other actors, in selections.
#include "StippleScene.h"

#include "InkTestChecks.h"
#include "InkTestImage.h"
#include "InkTestStipples.h"
#include "vtkInkStippleActor.h"

#include "vtkAssembly.h"
#include "vtkHardwareSelector.h"
#include "vtkPolyDataMapper.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkSphereSource.h"
#include "vtkVolume.h"

#include <cmath>

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

void TestPicture(InkTestChecks& check)
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
      check(!scene.Straight->HasTranslucentPolygonalGeometry(), "nothing for the translucent pass");
      check(expected.Ink() > 100.0 && picture.CountDifferent(expected, 24) < 40,
        "vtkActor's picture, opacity ", opacity, peeled ? ", peeled: " : ": ",
        picture.CountDifferent(expected, 24), " pixels differ");
      check(std::abs(picture.Ink() / expected.Ink() - 1.0) < 0.02, "its ink ", expected.Ink(), ", found ",
        picture.Ink());
    }
  }
}

/// Whatever the order in which actors were added.
void TestBehindSurfaces(InkTestChecks& check)
{
  Scene usual(false);
  usual.AddSphere(1.02, 1.0);
  const InkTestImage expected(usual.Window);
  Scene scene(true);
  scene.AddSphere(1.02, 1.0);
  check(InkTestImage(scene.Window).CountDifferent(expected, 24) < 40, "hidden by a surface added later");
  check(!scene.Straight->HasTranslucentPolygonalGeometry(), "nothing for the translucent pass");
}

void TestBesideTranslucent(InkTestChecks& check)
{
  Scene usual(false);
  usual.AddSphere(0.5, 0.4);
  const InkTestImage expected(usual.Window);
  Scene scene(true);
  scene.AddSphere(0.5, 0.4);
  const InkTestImage picture(scene.Window);
  check(scene.Straight->HasTranslucentPolygonalGeometry(), "a part of the translucent pass");
  check(picture.CountDifferent(expected) == 0, "vtkActor's picture");
  scene.Sphere->VisibilityOff();
  scene.Window->Render();
  check(!scene.Straight->HasTranslucentPolygonalGeometry(), "alone again");

  // Another of its kind is no reason.
  vtkNew<vtkInkStippleActor> other;
  other->SetMapper(scene.Mapper);
  scene.Renderer->AddActor(other);
  check(!scene.Straight->HasTranslucentPolygonalGeometry(), "beside another");

  // What a volume in front does to stipples is known to the translucent pass only.
  vtkNew<vtkVolume> volume;
  scene.Renderer->AddVolume(volume);
  check(scene.Straight->HasTranslucentPolygonalGeometry(), "a part of the translucent pass beside a volume");
  scene.Renderer->RemoveVolume(volume);
  check(!scene.Straight->HasTranslucentPolygonalGeometry(), "alone without the volume");

  // Asks its parts, of which this actor is one.
  vtkNew<vtkAssembly> assembly;
  assembly->AddPart(scene.Straight);
  scene.Renderer->AddActor(assembly);
  check(scene.Straight->HasTranslucentPolygonalGeometry(), "as vtkActor as a part of an assembly");

  vtkNew<vtkInkStippleActor> nowhere;
  nowhere->SetMapper(scene.Mapper);
  check(nowhere->HasTranslucentPolygonalGeometry(), "without a renderer as vtkActor");
}

void TestSelection(InkTestChecks& check)
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
  check(expected > 100 && count(scene) == expected, "all ", expected, " selected stipples, ", count(scene));
}

} // namespace

int TestStippleActor(int, char*[])
{
  InkTestChecks check;
  TestPicture(check);
  TestBehindSurfaces(check);
  TestBesideTranslucent(check);
  TestSelection(check);
  return check.Result();
}
