// SPDX-License-Identifier: BSD-3-Clause
// Splats that may be larger than the largest point sprite are drawn as quads: with a near plane close to the
// eye all may be, and everything looks the same and is found by the same ids.
#include "InkTestImage.h"
#include "InkTestPoints.h"
#include "SplattingLinesScene.h"

#include "vtkFloatArray.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

namespace
{

constexpr int Size = 400;

/// Two spheres, one behind the other, with scalars.
vtkSmartPointer<vtkPolyData> Spheres()
{
  auto points = InkTestPoints::Join(InkTestPoints::Sphere(1.0, 0.05, { 0.0, 0.0, 1.2 }),
    InkTestPoints::Sphere(1.0, 0.05, { 0.7, 0.3, -1.2 }));
  vtkNew<vtkFloatArray> scalars;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    scalars->InsertNextValue(static_cast<float>(i));
  }
  points->GetPointData()->SetScalars(scalars);
  return points;
}

struct Case
{
  std::string Name;
  bool Planes;
  bool Layers;
  bool Colors;
};

void Prepare(SplattingLinesScene& scene, const Case& one, double nearPlane)
{
  scene.Mapper->SetHiddenLayers(one.Layers);
  scene.Mapper->SetPeelBackFaces(one.Layers);
  scene.Mapper->SetInkColorMode(
    one.Colors ? vtkInkSplattingLinesMapper::SCALARS : vtkInkSplattingLinesMapper::INK);
  scene.Mapper->SetScalarRange(0.0, 10000.0);
  if (one.Planes)
  {
    vtkNew<vtkPlane> right;
    right->SetNormal(1.0, 0.2, 0.1);
    scene.Mapper->AddClippingPlane(right);
    vtkNew<vtkPlane> below;
    below->SetOrigin(0.0, 0.6, 0.0);
    below->SetNormal(0.0, -1.0, 0.3);
    scene.Mapper->AddClippingPlane(below);
  }
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(0.0, 0.0, 9.0);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetClippingRange(nearPlane, 14.0);
}

/// The ids of points in the picture, in their order.
std::vector<vtkIdType> Select(vtkRenderer* renderer)
{
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(renderer);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_POINTS);
  selector->SetArea(0, 0, Size - 1, Size - 1);
  const auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  std::vector<vtkIdType> ids;
  for (unsigned int i = 0; i < selection->GetNumberOfNodes(); ++i)
  {
    auto* list = vtkIdTypeArray::SafeDownCast(selection->GetNode(i)->GetSelectionList());
    ids.insert(ids.end(), list->GetPointer(0), list->GetPointer(0) + list->GetNumberOfTuples());
  }
  std::sort(ids.begin(), ids.end());
  return ids;
}

} // namespace

TEST(SplattingLinesQuads, AreAsPointSprites)
{
  const auto spheres = Spheres();
  for (const Case& one : { Case{ "plain", false, false, false }, Case{ "clipped", true, false, false },
         Case{ "layers", false, true, false }, Case{ "clipped, colored layers", true, true, true } })
  {
    SplattingLinesScene sprites(spheres, Size, Size);
    SplattingLinesScene quads(spheres, Size, Size);
    Prepare(sprites, one, 6.0);
    Prepare(quads, one, 0.05);
    const InkTestImage expected(sprites.Window);
    const int different = InkTestImage(quads.Window).CountDifferent(expected, 8);
    EXPECT_TRUE(expected.CountDark(200) > 500 && different < 20)
      << one.Name << ": the same picture, but for " << different << " of " << expected.CountDark(200)
      << " dark pixels";

    const std::vector<vtkIdType> ids = Select(sprites.Renderer);
    const std::vector<vtkIdType> found = Select(quads.Renderer);
    std::vector<vtkIdType> others;
    std::set_symmetric_difference(
      ids.begin(), ids.end(), found.begin(), found.end(), std::back_inserter(others));
    EXPECT_TRUE(ids.size() > 200 && others.size() < 0.02 * ids.size())
      << one.Name << ": the same points found, but for " << others.size() << " of " << ids.size();
    const auto cutOff = [&](vtkIdType id)
    {
      const double* p = spheres->GetPoint(id);
      // Discs reach over the planes by their radius.
      return p[0] + 0.2 * p[1] + 0.1 * p[2] < -0.08 || 0.6 - p[1] + 0.3 * p[2] < -0.08;
    };
    const auto beyond = std::count_if(ids.begin(), ids.end(), cutOff);
    EXPECT_EQ(one.Planes, (beyond == 0)) << one.Name << ": points found beyond the planes: " << beyond;
  }
}
