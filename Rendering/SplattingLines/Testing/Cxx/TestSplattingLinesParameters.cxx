// SPDX-License-Identifier: BSD-3-Clause
// What lambda, tau, phi, sigma and the colors do, and that none of them sends the points to the GPU again.
#include "InkTestImage.h"
#include "InkTestPoints.h"
#include "SplattingLinesScene.h"

#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace
{

/// A bumpy surface: lines inside the contour, too.
vtkSmartPointer<vtkPolyData> Bumps()
{
  auto points = InkTestPoints::Join(
    InkTestPoints::Sphere(1.0, 0.03), InkTestPoints::Sphere(0.4, 0.03, { 0.3, 0.3, 0.8 }));
  InkTestPoints::SetRadius(points, 0.04);
  return points;
}

using Setter = void (vtkInkSplattingLinesMapper::*)(double);

void ExpectMoreInk(const char* name, Setter set, const std::vector<double>& values)
{
  SplattingLinesScene scene(Bumps());
  double last = -1.0;
  for (double value : values)
  {
    (scene.Mapper->*set)(value);
    const double ink = InkTestImage(scene.Window).Ink();
    EXPECT_GT(ink, last) << "more ink with " << name << " " << value << ": " << ink << " after " << last;
    last = ink;
  }
}

} // namespace

/// Lambda counts below 1, too. As published, discs that do not overlap have one value each, and so no ink
/// but where f is negative.
TEST(SplattingLinesParameters, SmallLambda)
{
  SplattingLinesScene scene(Bumps());
  for (bool published : { false, true })
  {
    scene.Mapper->SetAsPublished(published);
    const auto draw = [&scene](double lambda)
    {
      scene.Mapper->SetLambda(lambda);
      return InkTestImage(scene.Window);
    };
    const InkTestImage one = draw(1.0);
    const InkTestImage half = draw(0.5);
    const InkTestImage tenth = draw(0.1);
    EXPECT_TRUE(one.CountDifferent(half, 20) > 100 && half.CountDifferent(tenth, 20) > 100)
      << "other pictures with lambda 1, 0.5 and 0.1" << (published ? " as published" : "") << ": "
      << one.CountDifferent(half, 20) << ", " << half.CountDifferent(tenth, 20) << " pixels";
    EXPECT_TRUE(!published || tenth.Ink() < 0.1) << "no ink where no disc overlaps another: " << tenth.Ink();
  }
  // A part of the points covers the surface as far as all do.
  scene.Mapper->AsPublishedOff();
  for (double lambda : { 0.5, 0.9, 1.1, 2.5 })
  {
    scene.Mapper->SetLambda(lambda);
    scene.Mapper->SetPointFraction(1.0);
    const double all = InkTestImage(scene.Window).Ink();
    scene.Mapper->SetPointFraction(0.5);
    const double part = InkTestImage(scene.Window).Ink();
    EXPECT_LT(std::abs(part - all), 0.1 * all)
      << "half of the points have about as much ink with lambda " << lambda << ": " << part << " of " << all;
  }
}

/// Larger splats, or wider Gaussians, smooth fine ripples away that smaller ones draw.
TEST(SplattingLinesParameters, LevelOfDetail)
{
  auto points = InkTestPoints::Plane(2.0, 0.02);
  InkTestPoints::SetRadius(points, 0.02);
  vtkDataArray* normals = points->GetPointData()->GetArray("Normals");
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    const double ripple = 0.8 * std::sin(points->GetPoint(i)[0] * 2.0 * vtkMath::Pi() / 0.2);
    normals->SetTuple3(i, ripple, 0.0, std::sqrt(1.0 - ripple * ripple));
  }
  SplattingLinesScene scene(points, 400, 400);
  const auto count = [&scene](double lambda, double sigma)
  {
    scene.Mapper->SetLambda(lambda);
    scene.Mapper->SetSigma(sigma);
    return InkTestImage(scene.Window).CountDark(120, 120, 280, 280);
  };
  const int fine = count(1.0, 0.4);
  const int coarse = count(8.0, 0.4);
  EXPECT_TRUE(fine > 1000 && coarse == 0)
    << "ripples with lambda 1, " << fine << " pixels, and none with 8, " << coarse;
  const int narrow = count(4.0, 0.15);
  const int wide = count(4.0, 1.0);
  EXPECT_TRUE(narrow > 1000 && wide < narrow / 4)
    << "ripples with sigma 0.15, " << narrow << " pixels, and few with 1, " << wide;
}

TEST(SplattingLinesParameters, NoInk)
{
  SplattingLinesScene scene(Bumps());
  scene.Mapper->SetPhi(0.0);
  EXPECT_EQ(InkTestImage(scene.Window).Ink(), 0.0) << "no ink with phi 0";
}

TEST(SplattingLinesParameters, Colors)
{
  SplattingLinesScene scene(Bumps());
  scene.Mapper->SetInkColor(1.0, 0.0, 0.0);
  scene.Mapper->SetPaperColor(0.0, 0.0, 1.0);
  const InkTestImage image(scene.Window);
  int ink = 0;
  int paper = 0;
  for (int y = 0; y < image.GetHeight(); ++y)
  {
    for (int x = 0; x < image.GetWidth(); ++x)
    {
      ink += image.Channel(x, y, 0) > 250 && image.Channel(x, y, 2) < 5;
      paper += image.Channel(x, y, 0) < 5 && image.Channel(x, y, 2) > 250;
    }
  }
  EXPECT_GT(ink, 100) << "ink in its color, " << ink << " pixels";
  EXPECT_GT(paper, 5000) << "paper in its color, " << paper << " pixels";
}

TEST(SplattingLinesParameters, Uploads)
{
  auto points = Bumps();
  SplattingLinesScene scene(points);
  vtkInkSplattingLinesMapper* mapper = scene.Mapper;
  EXPECT_EQ(mapper->GetUploadTime(), 0) << "nothing uploaded before the first frame";
  const InkTestImage first(scene.Window);
  const vtkMTimeType time = mapper->GetUploadTime();
  EXPECT_GT(time, 0) << "an upload in the first frame";

  mapper->SetLambda(3.0);
  mapper->SetTau(1.0);
  mapper->SetPhi(20.0);
  mapper->SetSigma(0.3);
  mapper->SetInkColor(0.0, 0.0, 1.0);
  mapper->PaperVisibilityOff();
  scene.Actor->SetPosition(0.1, 0.0, 0.0);
  scene.Renderer->GetActiveCamera()->Azimuth(10.0);
  const InkTestImage changed(scene.Window);
  EXPECT_GT(changed.CountDifferent(first), 0) << "another picture";
  EXPECT_EQ(mapper->GetUploadTime(), time) << "no upload for parameters, actor and camera";
  mapper->SetRadius(0.1);
  scene.Window->Render();
  EXPECT_EQ(mapper->GetUploadTime(), time) << "no upload for Radius where the input has radii";

  points->GetPoints()->SetPoint(0, 0.0, 0.0, 1.1);
  points->GetPoints()->Modified();
  points->Modified();
  scene.Window->Render();
  const vtkMTimeType pointsTime = mapper->GetUploadTime();
  EXPECT_GT(pointsTime, time) << "an upload of changed points";

  points->GetPointData()->RemoveArray("Radius");
  points->Modified();
  scene.Window->Render();
  const vtkMTimeType radiusTime = mapper->GetUploadTime();
  EXPECT_GT(radiusTime, pointsTime) << "an upload of other radii";
  mapper->SetRadius(0.05);
  scene.Window->Render();
  EXPECT_GT(mapper->GetUploadTime(), radiusTime) << "an upload of a changed Radius";

  const InkTestImage before(scene.Window);
  vtkDataArray* normals = points->GetPointData()->GetArray("Normals");
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    normals->SetTuple3(i, 0.0, 0.0, 1.0);
  }
  normals->Modified();
  EXPECT_GT(InkTestImage(scene.Window).CountDifferent(before), 200) << "a picture of changed normals";
}

/// An unchanged parameter set gives the same picture, and going back gives the first one again.
TEST(SplattingLinesParameters, Repeats)
{
  SplattingLinesScene scene(Bumps());
  const InkTestImage first(scene.Window);
  EXPECT_EQ(InkTestImage(scene.Window).CountDifferent(first), 0) << "the same picture again";
  scene.Mapper->SetTau(1.2);
  scene.Mapper->SetLambda(4.0);
  EXPECT_GT(InkTestImage(scene.Window).CountDifferent(first), 0) << "a changed picture";
  scene.Mapper->SetTau(0.99);
  scene.Mapper->SetLambda(2.5);
  EXPECT_EQ(InkTestImage(scene.Window).CountDifferent(first), 0) << "the first picture again";
}

TEST(SplattingLinesParameters, Ranges)
{
  vtkNew<vtkInkSplattingLinesMapper> mapper;
  EXPECT_TRUE(mapper->GetLambda() == 2.5 && mapper->GetTau() == 0.99 && mapper->GetPhi() == 100.0 &&
    mapper->GetSigma() == 0.4 && mapper->GetRadius() == 0.0 && mapper->GetPaperVisibility())
    << "the documented defaults";
  mapper->SetLambda(0.0);
  mapper->SetTau(9.0);
  mapper->SetPhi(-1.0);
  mapper->SetSigma(1e9);
  mapper->SetRadius(-3.0);
  EXPECT_TRUE(mapper->GetLambda() == 0.1 && mapper->GetTau() == 1.2 && mapper->GetPhi() == 0.0 &&
    mapper->GetSigma() == 2.0 && mapper->GetRadius() == 0.0)
    << "values clamped to their ranges";
}

TEST(SplattingLinesParameters, MoreInkWithTau)
{
  ExpectMoreInk("tau", &vtkInkSplattingLinesMapper::SetTau, { 0.9, 0.97, 0.99, 1.0, 1.02 });
}

TEST(SplattingLinesParameters, MoreInkWithPhi)
{
  ExpectMoreInk("phi", &vtkInkSplattingLinesMapper::SetPhi, { 1.0, 10.0, 100.0, 500.0 });
}
