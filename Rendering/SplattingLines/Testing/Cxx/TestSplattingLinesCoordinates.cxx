// SPDX-License-Identifier: BSD-3-Clause
// Where points may be: far from the origin, tiny and huge, transformed, clipped, close up, far away, at the
// window's edge.
#include "InkTestImage.h"
#include "InkTestMessages.h"
#include "InkTestPoints.h"
#include "SplattingLinesScene.h"

#include "vtkDoubleArray.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkTransform.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

/// The same picture of points that are scaled and shifted together with the camera.
TEST(SplattingLinesCoordinates, ScaleAndShift)
{
  auto local = InkTestPoints::Torus(1.0, 0.4, 0.03);
  SplattingLinesScene reference(local);
  const InkTestImage expected(reference.Window);
  const double far = 1e7;
  const struct
  {
    double Scale;
    InkTestPoints::Vector Shift;
  } cases[] = { { 1.0, { far, -far, far } }, { 1e-3, { 0, 0, 0 } }, { 1e-9, { 0, 0, 0 } },
    { 1e9, { 0, 0, 0 } }, { 1e9, { far, far, far } } };
  for (const auto& [scale, shift] : cases)
  {
    SplattingLinesScene scene(InkTestPoints::Transform(local, scale, shift));
    vtkCamera* from = reference.Renderer->GetActiveCamera();
    vtkCamera* camera = scene.Renderer->GetActiveCamera();
    const auto transformed = [&, s = scale, move = shift](const double* p) {
      return InkTestPoints::Vector{ s * p[0] + move[0], s * p[1] + move[1], s * p[2] + move[2] };
    };
    camera->SetPosition(transformed(from->GetPosition()).data());
    camera->SetFocalPoint(transformed(from->GetFocalPoint()).data());
    camera->SetClippingRange(scale * from->GetClippingRange()[0], scale * from->GetClippingRange()[1]);
    const int different = InkTestImage(scene.Window).CountDifferent(expected, 40);
    EXPECT_LT(different, 40) << "the local picture at scale " << scale << ", shifted by " << shift[0] << ": "
                             << different << " pixels differ";
  }
}

/// A transformed actor shows what transformed points show.
TEST(SplattingLinesCoordinates, ActorTransform)
{
  auto sphere = InkTestPoints::Sphere(1.0, 0.04);
  InkTestPoints::SetRadius(sphere, 0.05);

  // An ellipsoid: the normals' transformation is the inverse transpose.
  auto ellipsoid = vtkSmartPointer<vtkPolyData>::New();
  ellipsoid->DeepCopy(sphere);
  vtkNew<vtkTransform> stretch;
  stretch->RotateZ(30.0);
  stretch->Scale(-2.0, 1.0, 0.5);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  stretch->TransformPoints(sphere->GetPoints(), points);
  ellipsoid->SetPoints(points);
  vtkDataArray* normals = ellipsoid->GetPointData()->GetArray("Normals");
  for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); ++i)
  {
    double n[3];
    normals->GetTuple(i, n);
    stretch->TransformNormal(n, n);
    normals->SetTuple(i, n);
  }

  SplattingLinesScene expected(ellipsoid);
  expected.Renderer->GetActiveCamera()->Azimuth(40.0);
  expected.Renderer->ResetCamera();
  const InkTestImage expectedImage(expected.Window);
  SplattingLinesScene scene(sphere);
  scene.Actor->SetUserTransform(stretch);
  scene.Renderer->GetActiveCamera()->DeepCopy(expected.Renderer->GetActiveCamera());
  const InkTestImage image(scene.Window);
  // Discs are stretched with their actor: the splats differ a little, the contour does not.
  int misplaced = 0;
  for (int y = 0; y < 200; ++y)
  {
    for (int x = 0; x < 200; ++x)
    {
      misplaced += image.IsDark(x, y) && expectedImage.CountDark(x - 3, y - 3, x + 4, y + 4) == 0;
      misplaced += expectedImage.IsDark(x, y) && image.CountDark(x - 3, y - 3, x + 4, y + 4) == 0;
    }
  }
  EXPECT_TRUE(image.CountDark() > 200 && misplaced == 0)
    << "the contour of an ellipsoid, " << misplaced << " of " << image.CountDark() << " pixels elsewhere";

  SplattingLinesScene turned(sphere);
  const InkTestImage before(turned.Window);
  turned.Actor->SetScale(3.0);
  turned.Renderer->ResetCamera();
  EXPECT_LT(InkTestImage(turned.Window).CountDifferent(before, 40), 20)
    << "the same picture of a scaled sphere";
}

/// Clipping planes cut the surface, in world coordinates.
TEST(SplattingLinesCoordinates, ClippingPlanes)
{
  auto points = InkTestPoints::Plane(2.0, 0.04);
  SplattingLinesScene scene(points);
  scene.Renderer->SetBackground(0.0, 0.0, 0.0);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.Renderer->GetActiveCamera()->SetParallelScale(1.0);
  scene.Actor->SetPosition(0.25, 0.0, 0.0);
  vtkNew<vtkPlane> right;
  right->SetNormal(1.0, 0.0, 0.0);
  scene.Mapper->AddClippingPlane(right);
  vtkNew<vtkPlane> below;
  below->SetOrigin(0.0, 0.5, 0.0);
  below->SetNormal(0.0, -1.0, 0.0);
  scene.Mapper->AddClippingPlane(below);
  const InkTestImage image(scene.Window);
  int wrong = 0;
  for (int y = 0; y < 200; ++y)
  {
    for (int x = 0; x < 200; ++x)
    {
      // The scene's edges at x = 100 and y = 150, sharp to a pixel.
      const bool inside = x > 100 && y < 149;
      const bool outside = x < 99 || y > 150;
      wrong += (inside && image.Gray(x, y) == 0) || (outside && image.Gray(x, y) != 0);
    }
  }
  EXPECT_EQ(wrong, 0) << "a plane cut at two others, " << wrong << " pixels wrong";

  right->SetOrigin(0.5, 0.0, 0.0);
  EXPECT_EQ(InkTestImage(scene.Window).Gray(125, 50), 0) << "a moved clipping plane";

  vtkNew<InkTestMessages> messages;
  messages->Observe(scene.Mapper);
  for (int i = 0; i < 5; ++i)
  {
    vtkNew<vtkPlane> more;
    more->SetNormal(1.0, 0.0, 0.0);
    scene.Mapper->AddClippingPlane(more);
  }
  EXPECT_EQ(InkTestImage(scene.Window).Gray(125, 50), 0) << "the first six of seven clipping planes";
  scene.Window->Render();
  EXPECT_TRUE(messages->Messages.size() == 1 && messages->Messages[0].find("7") != std::string::npos)
    << "one message about seven clipping planes";

  scene.Mapper->RemoveAllClippingPlanes();
  EXPECT_EQ(InkTestImage(scene.Window).Gray(50, 50), 255) << "no clipping planes";
}

/// Splats that are larger than any point sprite, and splats whose centers lie outside the window.
TEST(SplattingLinesCoordinates, CloseUp)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  vtkNew<vtkPolyData> disc;
  disc->SetPoints(points);
  vtkNew<vtkDoubleArray> normal;
  normal->SetName("Normals");
  normal->SetNumberOfComponents(3);
  normal->InsertNextTuple3(0.0, 0.0, 1.0);
  disc->GetPointData()->AddArray(normal);

  for (int size : { 300, 1500 })
  {
    for (double aside : { 0.0, 1.4 })
    {
      SplattingLinesScene scene(disc, size, size);
      scene.Mapper->SetRadius(0.9);
      scene.Mapper->SetPhi(0.0);
      scene.Renderer->SetBackground(0.0, 0.0, 0.0);
      vtkCamera* camera = scene.Renderer->GetActiveCamera();
      camera->ParallelProjectionOn();
      camera->SetParallelScale(1.0);
      camera->SetFocalPoint(aside, 0.0, 0.0);
      camera->SetPosition(aside, 0.0, 5.0);
      scene.Renderer->ResetCameraClippingRange();
      const InkTestImage image(scene.Window);
      int wrong = 0;
      for (int y = 0; y < size; ++y)
      {
        for (int x = 0; x < size; ++x)
        {
          const double u = (2.0 * x + 1.0) / size - 1.0 + aside;
          const double v = (2.0 * y + 1.0) / size - 1.0;
          const double beyond = (std::hypot(u, v) - 0.9) * size / 2.0;
          wrong += (beyond < -2.0 && image.Gray(x, y) == 0) || (beyond > 2.0 && image.Gray(x, y) != 0);
        }
      }
      EXPECT_EQ(wrong, 0) << "a whole disc in " << size << " pixels, center at " << -aside << ": " << wrong
                          << " pixels wrong";
    }
  }
}

/// A surface that ends without turning away from the viewer has a line along its border, as wide as others,
/// and none within; as published it has none.
TEST(SplattingLinesCoordinates, Outline)
{
  for (const int size : { 300, 900 })
  {
    for (const bool asPublished : { false, true })
    {
      SplattingLinesScene scene(InkTestPoints::Plane(1.0, 0.02), size, size);
      scene.Mapper->SetAsPublished(asPublished);
      vtkCamera* camera = scene.Renderer->GetActiveCamera();
      camera->ParallelProjectionOn();
      camera->SetParallelScale(1.0);
      camera->SetFocalPoint(0.0, 0.0, 0.0);
      camera->SetPosition(0.0, 0.0, 5.0);
      scene.Renderer->ResetCameraClippingRange();
      const InkTestImage image(scene.Window);
      double dark = 0.0;
      bool isDarkWithin = false;
      for (int x = 0; x < size; ++x)
      {
        const bool isBorder = std::abs(std::abs(2.0 * x / size - 1.0) - 0.5) < 0.05;
        const double ink = 1.0 - image.Gray(x, size / 2) / 255.0;
        dark += isBorder ? ink : 0.0;
        isDarkWithin = isDarkWithin || (!isBorder && ink > 0.0);
      }
      EXPECT_FALSE(isDarkWithin) << size;
      if (asPublished)
      {
        EXPECT_EQ(dark, 0.0) << size;
      }
      else
      {
        // Of both borders.
        EXPECT_NEAR(dark / 2.0, std::max(0.002 * size, 1.2), 0.5) << size;
      }
    }
  }
}

/// A surface that reaches beyond the window on all sides fills it, from afar and from within touching
/// distance.
TEST(SplattingLinesCoordinates, WindowEdge)
{
  SplattingLinesScene scene(InkTestPoints::Plane(20.0, 0.1));
  scene.Renderer->SetBackground(0.0, 0.0, 0.0);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  for (double distance : { 20.0, 3.0, 0.2 })
  {
    camera->SetPosition(0.03, 0.02, distance);
    camera->SetFocalPoint(0.03, 0.02, 0.0);
    scene.Renderer->ResetCameraClippingRange();
    const InkTestImage image(scene.Window);
    EXPECT_EQ(image.CountDark(255), 0)
      << "a window full of paper from " << distance << ", but for " << image.CountDark(255) << " pixels";
  }
}

/// An object so far away that its points are much smaller than pixels has no holes.
TEST(SplattingLinesCoordinates, FarAway)
{
  auto points = InkTestPoints::Sphere(1.0, 0.02);
  SplattingLinesScene scene(points);
  scene.Mapper->SetRadius(0.011);
  scene.Mapper->SetPhi(0.0);
  scene.Renderer->SetBackground(0.0, 0.0, 0.0);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  for (double pixels : { 60.0, 30.0, 15.0, 4.0 })
  {
    camera->SetParallelScale(100.0 / pixels);
    const InkTestImage image(scene.Window);
    int holes = 0;
    int covered = 0;
    for (int y = 0; y < 200; ++y)
    {
      for (int x = 0; x < 200; ++x)
      {
        holes += std::hypot(x - 99.5, y - 99.5) < pixels - 1.0 && image.Gray(x, y) == 0;
        covered += image.Gray(x, y) != 0;
      }
    }
    EXPECT_EQ(holes, 0) << "no holes with a radius of " << pixels << " pixels, but " << holes;
    EXPECT_LT(covered, 3.1416 * (pixels + 2.0) * (pixels + 2.0))
      << "no more than the sphere with " << pixels << " pixels: " << covered;
  }
}

/// From within a sphere: surfaces on all sides, also behind the eye and at the near plane.
TEST(SplattingLinesCoordinates, FromWithin)
{
  SplattingLinesScene scene(InkTestPoints::Sphere(1.0, 0.03));
  scene.Renderer->SetBackground(0.0, 0.0, 0.0);
  scene.Mapper->SetPhi(0.0);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(0.0, 0.0, 0.9);
  camera->SetFocalPoint(0.0, 0.9, 0.0);
  camera->SetViewAngle(90.0);
  camera->SetClippingRange(0.01, 10.0);
  const InkTestImage image(scene.Window);
  EXPECT_EQ(image.CountDark(255), 0) << "a closed sphere from within, but for " << image.CountDark(255)
                                     << " pixels";
}
