// SPDX-License-Identifier: BSD-3-Clause
// Silhouettes of an image as segments through voxels (Lu et al. 2003, section 5.6).
#include "InkTestMessages.h"
#include "InkTestVolume.h"

#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInkContours.h"
#include "vtkInkEdgeVoxels.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRTAnalyticSource.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

namespace
{

constexpr double Radius = 12.0;
constexpr double Eye[3] = { 70.0, 40.0, 50.0 };

/// What a scanner sees of a ball: 100 inside, 0 outside, blurred by a Gaussian of one voxel.
vtkSmartPointer<vtkImageData> MakeBall(int type = VTK_FLOAT, double spacing = 1.0)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(36, 36, 36);
  image->SetOrigin(-17.5 * spacing, -17.5 * spacing, -17.5 * spacing);
  image->SetSpacing(spacing, spacing, spacing);
  InkTestFill(image, type,
    [spacing](double x, double y, double z)
    { return 50.0 * std::erfc((std::hypot(x, y, z) / spacing - Radius) / std::sqrt(2.0)); });
  return image;
}

struct Finder
{
  explicit Finder(vtkDataObject* data)
  {
    this->Messages->Observe(this->Contours);
    this->Contours->SetInputDataObject(data);
    this->Contours->SetMethodToVoxelSegments();
    this->Contours->SetEyeToPosition();
    this->Contours->SetEyePosition(Eye);
    this->Contours->SetLeastGradientMagnitude(10.0);
  }

  vtkPolyData* Find()
  {
    this->Contours->Update();
    return this->Contours->GetOutput();
  }

  vtkNew<vtkInkContours> Contours;
  vtkNew<InkTestMessages> Messages;
};

using Vector = std::array<double, 3>;

Vector PointOf(vtkPolyData* data, vtkIdType id)
{
  Vector p;
  data->GetPoint(id, p.data());
  return p;
}

/// The middle of each segment.
std::vector<Vector> MiddlesOf(vtkPolyData* lines)
{
  std::vector<Vector> middles;
  for (vtkIdType line = 0; line < lines->GetNumberOfLines(); ++line)
  {
    Vector p = PointOf(lines, 2 * line);
    const Vector q = PointOf(lines, 2 * line + 1);
    for (int axis = 0; axis < 3; ++axis)
    {
      p[axis] = 0.5 * (p[axis] + q[axis]);
    }
    middles.push_back(p);
  }
  return middles;
}

/// The share of points that have one of others in the same or the next voxel.
double FindShare(const std::vector<Vector>& points, const std::vector<Vector>& others)
{
  const auto found = std::count_if(points.begin(), points.end(),
    [&](const Vector& p)
    {
      return std::any_of(others.begin(), others.end(),
        [&](const Vector& q) {
          return std::max({ std::abs(p[0] - q[0]), std::abs(p[1] - q[1]), std::abs(p[2] - q[2]) }) < 1.5;
        });
    });
  return static_cast<double>(found) / static_cast<double>(points.size());
}

std::vector<Vector> SortedPoints(vtkPolyData* data)
{
  std::vector<Vector> points;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    points.push_back(PointOf(data, i));
  }
  std::sort(points.begin(), points.end());
  return points;
}

} // namespace

/// Segments lie where the ball is seen from its side, along the circle, in any unit of length.
TEST(VoxelSegments, OfABallLieAroundACircle)
{
  for (const double spacing : { 1.0, 0.01 })
  {
    Finder run(MakeBall(VTK_FLOAT, spacing));
    run.Contours->SetEyePosition(spacing * Eye[0], spacing * Eye[1], spacing * Eye[2]);
    run.Contours->SetLeastGradientMagnitude(10.0 / spacing);
    run.Contours->SetSegmentLength(1.5);
    run.Contours->ComputeNormalsOn();
    run.Contours->ComputeArcLengthOn();
    vtkPolyData* lines = run.Find();
    ASSERT_GT(lines->GetNumberOfLines(), 100);
    ASSERT_EQ(lines->GetNumberOfPoints(), 2 * lines->GetNumberOfLines());
    const double along = Radius * Radius / vtkMath::Norm(Eye);
    for (vtkIdType line = 0; line < lines->GetNumberOfLines(); ++line)
    {
      EXPECT_EQ(lines->GetCellData()->GetArray("ContourKind")->GetTuple1(line), vtkInkContours::SILHOUETTE);
      const Vector p = PointOf(lines, 2 * line);
      const Vector q = PointOf(lines, 2 * line + 1);
      Vector way;
      Vector middle;
      vtkMath::Subtract(q.data(), p.data(), way.data());
      vtkMath::Add(q.data(), p.data(), middle.data());
      vtkMath::MultiplyScalar(middle.data(), 0.5 / spacing);
      EXPECT_NEAR(vtkMath::Normalize(way.data()), 1.5 * spacing, 1e-5 * spacing);
      EXPECT_NEAR(vtkMath::Norm(middle.data()), Radius, 0.95);
      EXPECT_NEAR(vtkMath::Dot(middle.data(), Eye) / vtkMath::Norm(Eye), along, 1.0 + 0.11 * Radius);
      Vector tangent;
      Vector toEye;
      vtkMath::Subtract(Eye, middle.data(), toEye.data());
      vtkMath::Cross(middle.data(), toEye.data(), tangent.data());
      vtkMath::Normalize(tangent.data());
      EXPECT_GT(std::abs(vtkMath::Dot(tangent.data(), way.data())), 0.95);
      double normal[3];
      lines->GetPointData()->GetNormals()->GetTuple(2 * line, normal);
      EXPECT_GT(vtkMath::Dot(normal, middle.data()), 0.98 * vtkMath::Norm(middle.data()));
      EXPECT_NEAR(
        lines->GetPointData()->GetArray("ArcLength")->GetTuple1(2 * line + 1), 1.5 * spacing, 1e-9 * spacing);
    }
    run.Messages->Expect("a ball", {});
  }
}

/// "Virtually identical results": what the edge voxels give, the exhaustive search gives in the same or the
/// next voxel.
TEST(VoxelSegments, AsTheExhaustiveSearch)
{
  for (const int type : { VTK_FLOAT, VTK_UNSIGNED_CHAR })
  {
    Finder run(MakeBall(type));
    run.Contours->SetLargestCosine(0.12);
    const auto edges = MiddlesOf(run.Find());
    run.Contours->SetMethodToVoxelSearch();
    const auto searched = MiddlesOf(run.Find());
    ASSERT_GT(edges.size(), 100u);
    ASSERT_GT(searched.size(), 100u);
    EXPECT_GT(FindShare(edges, searched), 0.97);
    EXPECT_GT(FindShare(searched, edges), 0.97);
    EXPECT_EQ(run.Contours->GetNumberOfIndexBuilds(), 1) << "edge voxels only";
  }
}

/// The segments are those of the edge voxels that pass the test, whose thresholds count.
TEST(VoxelSegments, OfEdgeVoxelsThatPass)
{
  const auto image = MakeBall();
  vtkNew<vtkInkEdgeVoxels> edges;
  edges->SetInputData(image);
  edges->SetLeastGradientMagnitude(10.0);
  edges->Update();
  vtkPolyData* voxels = edges->GetOutput();
  ASSERT_GT(voxels->GetNumberOfPoints(), 1500);
  EXPECT_EQ(voxels->GetNumberOfVerts(), voxels->GetNumberOfPoints());
  Finder run(image);
  run.Contours->SetLowestValue(20.0);
  run.Contours->SetHighestValue(60.0);
  run.Contours->SetLeastGradientMagnitude(36.0);
  run.Contours->SetLargestCosine(0.3);
  std::vector<Vector> expected;
  for (vtkIdType i = 0; i < voxels->GetNumberOfPoints(); ++i)
  {
    Vector p = PointOf(voxels, i);
    double gradient[3];
    voxels->GetPointData()->GetArray("Gradient")->GetTuple(i, gradient);
    const double value = voxels->GetPointData()->GetArray("Value")->GetTuple1(i);
    EXPECT_NEAR(voxels->GetPointData()->GetArray("Radius")->GetTuple1(i), 0.5 * std::sqrt(3.0), 1e-6);
    EXPECT_NEAR(value, image->GetPointData()->GetScalars()->GetTuple1(image->FindPoint(p.data())), 1e-6);
    Vector toEye;
    vtkMath::Subtract(Eye, p.data(), toEye.data());
    const double magnitude = vtkMath::Norm(gradient);
    if (value >= 20.0 && value <= 60.0 && magnitude >= 36.0 &&
      std::abs(vtkMath::Dot(gradient, toEye.data())) <= 0.3 * magnitude * vtkMath::Norm(toEye.data()))
    {
      expected.push_back(p);
    }
  }
  const auto found = MiddlesOf(run.Find());
  ASSERT_GT(found.size(), 50u);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    EXPECT_LT(std::sqrt(vtkMath::Distance2BetweenPoints(found[i].data(), expected[i].data())), 1e-5);
  }
}

/// Another eye or threshold of the eye's test does not look at the image again.
TEST(VoxelSegments, EdgesAreKept)
{
  const auto image = MakeBall();
  Finder run(image);
  vtkNew<vtkCamera> camera;
  camera->SetPosition(Eye);
  run.Contours->SetCamera(camera);
  run.Contours->SetEyeToCamera();
  const auto first = MiddlesOf(run.Find());
  camera->SetPosition(-60.0, 30.0, 20.0);
  EXPECT_NE(MiddlesOf(run.Find()), first);
  run.Contours->SetLargestCosine(0.2);
  EXPECT_GT(run.Find()->GetNumberOfLines(), static_cast<vtkIdType>(1.5 * static_cast<double>(first.size())));
  EXPECT_EQ(run.Contours->GetNumberOfIndexBuilds(), 1);
  run.Contours->SetEdgeScale(2.0);
  run.Find();
  EXPECT_EQ(run.Contours->GetNumberOfIndexBuilds(), 2);
  image->GetPointData()->GetScalars()->SetTuple1(0, 1.0);
  image->GetPointData()->GetScalars()->Modified();
  run.Find();
  EXPECT_EQ(run.Contours->GetNumberOfIndexBuilds(), 3);
}

/// The pieces' voxels and segments are together those of the whole, each once, for any number of threads.
TEST(VoxelSegments, Pieces)
{
  vtkNew<vtkRTAnalyticSource> source;
  source->SetWholeExtent(-12, 15, -9, 11, -10, 13);
  vtkNew<vtkInkEdgeVoxels> edges;
  edges->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkInkContours> contours;
  contours->SetInputConnection(source->GetOutputPort());
  contours->SetMethodToVoxelSegments();
  contours->SetEyeToPosition();
  contours->SetEyePosition(Eye);
  for (vtkPolyDataAlgorithm* filter : std::initializer_list<vtkPolyDataAlgorithm*>{ edges, contours })
  {
    setenv("VTK_SMP_MAX_THREADS", "1", 1);
    filter->Update();
    const auto whole = SortedPoints(filter->GetOutput());
    EXPECT_GT(whole.size(), 500u);
    setenv("VTK_SMP_MAX_THREADS", "2", 1);
    filter->Modified();
    filter->Update();
    EXPECT_EQ(SortedPoints(filter->GetOutput()), whole);
    unsetenv("VTK_SMP_MAX_THREADS");
    std::vector<Vector> together;
    for (int piece = 0; piece < 4; ++piece)
    {
      filter->UpdatePiece(piece, 4, 0);
      const auto points = SortedPoints(filter->GetOutput());
      together.insert(together.end(), points.begin(), points.end());
    }
    std::sort(together.begin(), together.end());
    EXPECT_EQ(together, whole) << filter->GetClassName();
  }
}

TEST(VoxelSegments, WhatCannotBeFound)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  Finder ofMesh(sphere->GetOutput());
  EXPECT_EQ(ofMesh.Find()->GetNumberOfPoints(), 0);
  ofMesh.Messages->Expect("a mesh", { "need an image", "found a mesh of 50 points" });

  vtkNew<vtkImageData> bare;
  bare->SetDimensions(4, 4, 4);
  Finder withoutArray(bare);
  EXPECT_EQ(withoutArray.Find()->GetNumberOfPoints(), 0);
  EXPECT_EQ(withoutArray.Messages->Messages.size(), 1u);
  vtkNew<vtkInkEdgeVoxels> edges;
  vtkNew<InkTestMessages> messages;
  messages->Observe(edges);
  edges->SetInputData(bare);
  edges->Update();
  EXPECT_EQ(edges->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(messages->Messages.size(), 1u);

  const auto flat = MakeBall();
  flat->SetSpacing(1.0, 0.0, 1.0);
  Finder withoutSpacing(flat);
  EXPECT_EQ(withoutSpacing.Find()->GetNumberOfPoints(), 0);
  withoutSpacing.Messages->Expect("no spacing", { "cannot be found", "spacing" });

  const auto holes = MakeBall();
  for (vtkIdType i = 0; i < holes->GetNumberOfPoints(); i += 3)
  {
    holes->GetPointData()->GetScalars()->SetTuple1(i, std::numeric_limits<double>::quiet_NaN());
  }
  Finder withHoles(holes);
  vtkPolyData* lines = withHoles.Find();
  EXPECT_GT(lines->GetNumberOfLines(), 20);
  for (const Vector& p : SortedPoints(lines))
  {
    EXPECT_TRUE(std::isfinite(p[0] + p[1] + p[2]));
  }
  withHoles.Messages->Expect("holes", {});

  const auto constant = MakeBall();
  constant->GetPointData()->GetScalars()->Fill(7.0);
  EXPECT_EQ(Finder(constant).Find()->GetNumberOfLines(), 0);
}
