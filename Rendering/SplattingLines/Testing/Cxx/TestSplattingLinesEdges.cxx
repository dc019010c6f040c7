// SPDX-License-Identifier: BSD-3-Clause
// Discs that end at sharp edges.
#include "InkTestImage.h"
#include "InkTestPoints.h"
#include "SplattingLinesScene.h"

#include "vtkFloatArray.h"
#include "vtkHardwareSelector.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSelection.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

namespace
{

constexpr int Side = 400;

/// A sheet that is folded in the middle: to the left it slopes down.
vtkSmartPointer<vtkPolyData> Halves()
{
  auto points = InkTestPoints::Plane(2.0, 0.04);
  InkTestPoints::SetRadius(points, 0.1);
  vtkNew<vtkFloatArray> edges;
  edges->SetName("EdgeOffsets");
  edges->SetNumberOfComponents(6);
  edges->SetNumberOfTuples(points->GetNumberOfPoints());
  edges->Fill(0.0);
  vtkDataArray* normals = points->GetPointData()->GetArray("Normals");
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double p[3];
    points->GetPoint(i, p);
    const double slope = p[0] < 0.0 ? 0.7 : 0.0;
    p[2] = slope * p[0];
    points->GetPoints()->SetPoint(i, p);
    normals->SetTuple3(i, -slope, 0.0, 1.0);
    edges->SetTypedComponent(i, 0, static_cast<float>(-p[0]));
    edges->SetTypedComponent(i, 2, static_cast<float>(-p[2]));
  }
  points->GetPointData()->AddArray(edges);
  return points;
}

/// The points on one side of the edge.
vtkSmartPointer<vtkPolyData> LeftHalf(vtkPolyData* both)
{
  auto left = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  left->GetPointData()->CopyAllocate(both->GetPointData());
  for (vtkIdType i = 0; i < both->GetNumberOfPoints(); ++i)
  {
    if (both->GetPoint(i)[0] < 0.0)
    {
      left->GetPointData()->CopyData(both->GetPointData(), i, points->InsertNextPoint(both->GetPoint(i)));
    }
  }
  left->SetPoints(points);
  return left;
}

/// @param nearPlane close to the eye, any disc may be too large for a point sprite
void SeeFromAbove(SplattingLinesScene& scene, double nearPlane)
{
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(0.0, 0.0, 8.0);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetViewAngle(20.0);
  camera->SetClippingRange(nearPlane, 12.0);
  scene.Mapper->SetTau(0.998);
}

/// Ink in the middle of the picture, around the edge.
int CountInkAtTheEdge(const InkTestImage& image)
{
  int count = 0;
  for (int y = Side / 4; y < 3 * Side / 4; ++y)
  {
    for (int x = Side / 2 - 40; x < Side / 2 + 40; ++x)
    {
      count += image.Channel(x, y, 0) < 200;
    }
  }
  return count;
}

} // namespace

TEST(SplattingLinesEdges, TheSurfaceEndsThere)
{
  for (const double nearPlane : { 6.0, 0.02 })
  {
    for (const bool ends : { true, false })
    {
      const auto half = LeftHalf(Halves());
      if (!ends)
      {
        half->GetPointData()->RemoveArray("EdgeOffsets");
      }
      SplattingLinesScene scene(half, Side, Side);
      SeeFromAbove(scene, nearPlane);
      scene.Mapper->SetPaperColor(1.0, 0.0, 0.0);
      scene.Mapper->SetPhi(0.0);
      const InkTestImage image(scene.Window);
      int last = 0;
      for (int x = 0; x < Side; ++x)
      {
        last = image.Channel(x, Side / 2, 0) > 240 && image.Channel(x, Side / 2, 1) < 15 ? x : last;
      }
      // A disc of the last column, .04 before the edge, reaches .05 beyond it, or 6 pixels.
      EXPECT_NEAR(last, ends ? Side / 2 : Side / 2 + 6, 1) << nearPlane;
    }
  }
}

TEST(SplattingLinesEdges, NothingIsFoundBeyond)
{
  for (const bool ends : { true, false })
  {
    const auto half = LeftHalf(Halves());
    if (!ends)
    {
      half->GetPointData()->RemoveArray("EdgeOffsets");
    }
    SplattingLinesScene scene(half, Side, Side);
    SeeFromAbove(scene, 6.0);
    scene.Window->Render();
    vtkNew<vtkHardwareSelector> selector;
    selector->SetRenderer(scene.Renderer);
    selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_POINTS);
    selector->SetArea(Side / 2 + 2, 0, Side - 1, Side - 1);
    const auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
    EXPECT_EQ(selection->GetNumberOfNodes(), ends ? 0u : 1u);
  }
}

TEST(SplattingLinesEdges, LightIsOfOneSide)
{
  for (const double nearPlane : { 6.0, 0.02 })
  {
    const auto halves = Halves();
    SplattingLinesScene scene(halves, Side, Side);
    SeeFromAbove(scene, nearPlane);
    EXPECT_LT(CountInkAtTheEdge(InkTestImage(scene.Window)), 20) << nearPlane;
    // As published, all discs are whole.
    scene.Mapper->AsPublishedOn();
    EXPECT_GT(CountInkAtTheEdge(InkTestImage(scene.Window)), 1000) << nearPlane;
    scene.Mapper->AsPublishedOff();
    EXPECT_LT(CountInkAtTheEdge(InkTestImage(scene.Window)), 20) << nearPlane;
    halves->GetPointData()->RemoveArray("EdgeOffsets");
    EXPECT_GT(CountInkAtTheEdge(InkTestImage(scene.Window)), 1000) << nearPlane;
  }
}

TEST(SplattingLinesEdges, ArraysOfAnotherShapeAreIgnored)
{
  const auto halves = Halves();
  vtkNew<vtkFloatArray> edges;
  edges->SetName("EdgeOffsets");
  edges->SetNumberOfComponents(3);
  edges->SetNumberOfTuples(halves->GetNumberOfPoints());
  edges->Fill(0.01);
  halves->GetPointData()->AddArray(edges);
  SplattingLinesScene scene(halves, Side, Side);
  SeeFromAbove(scene, 6.0);
  EXPECT_GT(CountInkAtTheEdge(InkTestImage(scene.Window)), 1000);
}
