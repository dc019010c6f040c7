// SPDX-License-Identifier: BSD-3-Clause
// Hardware selection: which actor and which points.
#include "InkSourcePoints.h"
#include "InkTestImage.h"
#include "InkTestPoints.h"
#include "SplattingLinesScene.h"

#include "vtkDataObject.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{

vtkSmartPointer<vtkSelection> Select(
  vtkRenderer* renderer, int association, unsigned int x, unsigned int y, unsigned int size)
{
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(renderer);
  selector->SetFieldAssociation(association);
  selector->SetArea(x, y, x + size - 1, y + size - 1);
  return vtkSmartPointer<vtkSelection>::Take(selector->Select());
}

} // namespace

/// The sphere from 20 to 180 of 200 pixels, in a parallel projection along -z.
TEST(SplattingLinesSelection, Points)
{
  for (bool paper : { true, false })
  {
    auto points = InkTestPoints::Sphere(1.0, 0.05);
    SplattingLinesScene scene(points);
    scene.Mapper->SetPaperVisibility(paper);
    scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
    scene.Renderer->GetActiveCamera()->SetParallelScale(1.25);
    const InkTestImage before(scene.Window);
    auto selection = Select(scene.Renderer, vtkDataObject::FIELD_ASSOCIATION_POINTS, 110, 90, 20);
    ASSERT_EQ(selection->GetNumberOfNodes(), 1u) << "one prop selected";
    vtkSelectionNode* node = selection->GetNode(0);
    EXPECT_EQ(node->GetProperties()->Get(vtkSelectionNode::PROP()), scene.Actor.Get())
      << "the actor in the selection";
    EXPECT_EQ(node->GetFieldType(), vtkSelectionNode::POINT) << "a selection of points";
    auto* ids = vtkIdTypeArray::SafeDownCast(node->GetSelectionList());
    EXPECT_GT(ids->GetNumberOfTuples(), 5) << "several points, " << ids->GetNumberOfTuples();
    for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
    {
      double p[3];
      points->GetPoint(ids->GetValue(i), p);
      const double x = 100.0 + 80.0 * p[0];
      const double y = 100.0 + 80.0 * p[1];
      // Discs reach a few pixels out of the area.
      EXPECT_TRUE(p[2] > 0.0 && x > 103.0 && x < 137.0 && y > 83.0 && y < 117.0)
        << "point " << ids->GetValue(i) << " in the area and on the front, at " << x << ", " << y;
    }
    EXPECT_EQ(Select(scene.Renderer, vtkDataObject::FIELD_ASSOCIATION_POINTS, 2, 2, 5)->GetNumberOfNodes(), 0)
      << "nothing selected beside the sphere";
    EXPECT_EQ(InkTestImage(scene.Window).CountDifferent(before), 0) << "the same picture afterwards";
  }
}

/// Points that were made on a mesh, say, are found as those of the mesh: the ids are far from their numbers,
/// and need more than 24 bits.
TEST(SplattingLinesSelection, SourcePoints)
{
  constexpr vtkIdType first = 20'000'000;
  auto points = InkTestPoints::Sphere(1.0, 0.05);
  SplattingLinesScene scene(points);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.Renderer->GetActiveCamera()->SetParallelScale(1.25);
  // Before its first picture a window has no OpenGL to select with.
  scene.Window->Render();
  const auto select = [&]
  {
    auto selection = Select(scene.Renderer, vtkDataObject::FIELD_ASSOCIATION_POINTS, 90, 90, 20);
    const bool found = selection->GetNumberOfNodes() == 1;
    auto* ids = vtkIdTypeArray::SafeDownCast(found ? selection->GetNode(0)->GetSelectionList() : nullptr);
    std::vector<vtkIdType> values;
    for (vtkIdType i = 0; ids && i < ids->GetNumberOfTuples(); ++i)
    {
      values.push_back(ids->GetValue(i));
    }
    return values;
  };
  const std::vector<vtkIdType> own = select();
  ASSERT_GT(own.size(), 5u);
  vtkNew<vtkIdTypeArray> sources;
  sources->SetName(InkSourcePointsName);
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    sources->InsertNextValue(first + i);
  }
  points->GetPointData()->AddArray(sources);
  std::vector<vtkIdType> expected = own;
  std::for_each(expected.begin(), expected.end(), [](vtkIdType& id) { id += first; });
  EXPECT_EQ(select(), expected);
  points->GetPointData()->RemoveArray(InkSourcePointsName);
  EXPECT_EQ(select(), own) << "their own numbers again";
}

TEST(SplattingLinesSelection, Props)
{
  SplattingLinesScene scene(InkTestPoints::Sphere(0.5, 0.05, { -1.0, 0.0, 0.0 }));
  SplattingLinesScene other(InkTestPoints::Sphere(0.5, 0.05, { 1.0, 0.0, 0.0 }));
  scene.Renderer->AddActor(other.Actor);
  scene.Renderer->ResetCamera();
  // VTK's selector takes a window that has been drawn.
  scene.Window->Render();
  for (vtkActor* actor : { scene.Actor.Get(), other.Actor.Get() })
  {
    scene.Renderer->SetWorldPoint(actor->GetCenter()[0], 0.0, 0.0, 1.0);
    scene.Renderer->WorldToDisplay();
    const double* pixel = scene.Renderer->GetDisplayPoint();
    auto selection = Select(scene.Renderer, vtkDataObject::FIELD_ASSOCIATION_CELLS,
      static_cast<unsigned int>(pixel[0]), static_cast<unsigned int>(pixel[1]), 2);
    EXPECT_TRUE(selection->GetNumberOfNodes() == 1 &&
      selection->GetNode(0)->GetProperties()->Get(vtkSelectionNode::PROP()) == actor)
      << "the actor at " << pixel[0] << ", " << pixel[1];
  }
}
