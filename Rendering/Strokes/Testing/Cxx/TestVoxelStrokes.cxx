// SPDX-License-Identifier: BSD-3-Clause
// Segments through edge voxels (Lu et al. 2003, section 5.6), which the GPU finds for each camera.
#include "InkTestImage.h"
#include "InkTestMessages.h"
#include "InkTestScene.h"
#include "InkTestViewports.h"
#include "InkTestVolume.h"
#include "StrokeScene.h"
#include "vtkInkContours.h"
#include "vtkInkEdgeVoxels.h"
#include "vtkInkSilhouetteMapper.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkMatrix4x4.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace
{

/// What a scanner sees of two balls, one within the other, with some noise.
vtkSmartPointer<vtkImageData> MakeBalls()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(40, 40, 40);
  image->SetOrigin(1000.0 - 19.5, -19.5, -19.5);
  unsigned int state = 1;
  InkTestFill(image, VTK_FLOAT,
    [&](double x, double y, double z)
    {
      const double r = std::hypot(x - 1000.0, y, z);
      state = state * 1664525u + 1013904223u;
      const double noise = static_cast<double>(state >> 8) / (1 << 24);
      return 50.0 * std::erfc((r - 16.0) / std::sqrt(2.0)) + 60.0 * std::erfc((r - 8.0) / std::sqrt(2.0)) +
        noise;
    });
  return image;
}

vtkSmartPointer<vtkPolyData> FindVoxels(vtkImageData* image, double leastMagnitude)
{
  vtkNew<vtkInkEdgeVoxels> edges;
  edges->SetInputData(image);
  edges->SetLeastGradientMagnitude(leastMagnitude);
  edges->Update();
  return edges->GetOutput();
}

class Scene : public InkTestScene<vtkInkSilhouetteMapper>
{
public:
  explicit Scene(vtkPolyData* voxels, int size = 200)
    : InkTestScene(voxels, size, size)
  {
    this->Mapper->SetMethodToVoxelSegments();
    this->Mapper->SetSizeUnitToPixels();
    this->Mapper->SetLineWidth(2.0);
  }
};

struct Voxel
{
  double Position[3];
  double Gradient[3];
  double Value;
};

/// Voxels with an edge of a length.
vtkSmartPointer<vtkPolyData> MakeVoxels(const std::vector<Voxel>& voxels, double edge)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> gradients;
  gradients->SetName("Gradient");
  gradients->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> values;
  values->SetName("Value");
  vtkNew<vtkFloatArray> radii;
  radii->SetName("Radius");
  for (const Voxel& voxel : voxels)
  {
    points->InsertNextPoint(voxel.Position);
    gradients->InsertNextTuple(voxel.Gradient);
    values->InsertNextValue(static_cast<float>(voxel.Value));
    radii->InsertNextValue(static_cast<float>(0.5 * std::sqrt(3.0) * edge));
  }
  data->SetPoints(points);
  data->GetPointData()->AddArray(gradients);
  data->GetPointData()->AddArray(values);
  data->GetPointData()->AddArray(radii);
  return data;
}

/// A parallel view along -z in which x and y are pixels.
void LookAtPixels(Scene& scene)
{
  const int* size = scene.Window->GetSize();
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.5 * size[1]);
  camera->SetFocalPoint(0.5 * size[0], 0.5 * size[1], 0.0);
  camera->SetPosition(0.5 * size[0], 0.5 * size[1], 1000.0);
  camera->SetClippingRange(1.0, 2000.0);
}

} // namespace

/// The GPU draws what the filter finds, whatever the camera, the actor and the thresholds.
TEST(VoxelStrokes, AsTheFilter)
{
  const auto image = MakeBalls();
  Scene scene(FindVoxels(image, 5.0));
  vtkNew<vtkInkContours> filter;
  filter->SetInputData(image);
  filter->SetMethodToVoxelSegments();
  filter->SetLeastGradientMagnitude(5.0);
  filter->ComputeNormalsOn();
  vtkNew<vtkInkStrokeMapper> strokes;
  strokes->SetInputConnection(filter->GetOutputPort());
  strokes->SetSizeUnitToPixels();
  strokes->SetLineWidth(2.0);

  vtkIdType before = 0;
  for (const bool parallel : { false, true })
  {
    vtkCamera* camera = scene.Renderer->GetActiveCamera();
    camera->SetParallelProjection(parallel);
    for (const int variant : { 0, 1, 2, 3 })
    {
      camera->Azimuth(23.0);
      camera->Elevation(7.0);
      scene.Actor->SetScale(variant == 1 ? 1.5 : 1.0, 1.0, variant == 1 ? 0.5 : 1.0);
      scene.Actor->SetOrientation(0.0, 0.0, variant == 1 ? 30.0 : 0.0);
      scene.Renderer->ResetCamera();
      const double cosine = variant == 2 ? 0.4 : 0.1;
      const double least = variant == 3 ? 25.0 : 5.0;
      const double lowest = variant == 3 ? 110.0 : -1e38;
      const double highest = variant == 2 ? 110.0 : 1e38;
      const double length = variant == 0 ? 3.0 : 1.0;
      scene.Mapper->SetLargestCosine(cosine);
      scene.Mapper->SetLeastGradientMagnitude(least);
      scene.Mapper->SetLowestValue(lowest);
      scene.Mapper->SetHighestValue(highest);
      scene.Mapper->SetSegmentLength(length);
      filter->SetLargestCosine(cosine);
      filter->SetLeastGradientMagnitude(least);
      filter->SetLowestValue(lowest);
      filter->SetHighestValue(highest);
      filter->SetSegmentLength(length);
      // The eye in the data's coordinates.
      vtkNew<vtkMatrix4x4> toData;
      scene.Actor->GetModelToWorldMatrix(toData);
      toData->Invert();
      double eye[4] = { 0.0, 0.0, 0.0, parallel ? 0.0 : 1.0 };
      parallel ? camera->GetDirectionOfProjection(eye) : camera->GetPosition(eye);
      toData->MultiplyPoint(eye, eye);
      parallel ? filter->SetEyeToDirection() : filter->SetEyeToPosition();
      parallel ? filter->SetEyeDirection(eye) : filter->SetEyePosition(eye);
      scene.Actor->SetMapper(scene.Mapper);
      const InkTestImage gpu(scene.Window);
      scene.Actor->SetMapper(strokes);
      const InkTestImage cpu(scene.Window);
      const vtkIdType segments = filter->GetOutput()->GetNumberOfLines();
      EXPECT_GT(segments, 50);
      EXPECT_NE(segments, before);
      before = segments;
      EXPECT_GT(gpu.CountDark(), 200);
      // The arithmetic differs in its last digits.
      EXPECT_LE(gpu.CountDifferent(cpu, 4), 4) << parallel << ' ' << variant << ' ' << segments;
    }
  }
}

/// A segment is as long as its voxel, at right angles to gradient and eye, and there if all is within bounds.
TEST(VoxelStrokes, OneVoxel)
{
  // Its gradient is 3 degrees off the picture's plane, and has the magnitude 5.
  const double tilt = 3.0 * std::numbers::pi / 180.0;
  const auto voxel = MakeVoxels(
    { { { 50.0, 50.0, 0.0 }, { 3.0 * std::cos(tilt), 4.0 * std::cos(tilt), 5.0 * std::sin(tilt) }, 7.0 } },
    30.0);
  Scene scene(voxel, 100);
  LookAtPixels(scene);
  scene.Mapper->SetCapToButt();
  scene.Mapper->SetLineWidth(4.0);
  const auto ink = [&] { return InkTestImage(scene.Window).Ink(); };
  EXPECT_NEAR(ink(), 30.0 * 4.0, 1.0);
  scene.Mapper->SetSegmentLength(2.0);
  const InkTestImage image(scene.Window);
  EXPECT_NEAR(image.Ink(), 60.0 * 4.0, 1.0);
  for (const int step : { -28, -10, 0, 10, 28 })
  {
    EXPECT_TRUE(image.IsDark(static_cast<int>(50.0 + 0.8 * step), static_cast<int>(50.0 - 0.6 * step)))
      << step;
  }
  const double drawn = image.Ink();
  scene.Mapper->SetLowestValue(7.1);
  EXPECT_EQ(ink(), 0.0);
  scene.Mapper->SetLowestValue(6.9);
  scene.Mapper->SetHighestValue(6.95);
  EXPECT_EQ(ink(), 0.0);
  scene.Mapper->SetHighestValue(7.1);
  scene.Mapper->SetLeastGradientMagnitude(5.01);
  EXPECT_EQ(ink(), 0.0);
  scene.Mapper->SetLeastGradientMagnitude(4.99);
  scene.Mapper->SetLargestCosine(std::sin(0.99 * tilt));
  EXPECT_EQ(ink(), 0.0);
  scene.Mapper->SetLargestCosine(std::sin(1.01 * tilt));
  EXPECT_EQ(ink(), drawn);
  scene.Mapper->SetDensity(0.0);
  EXPECT_EQ(ink(), 0.0);
  scene.Mapper->SetDensity(1.0);
  scene.Mapper->SilhouettesOff();
  EXPECT_EQ(ink(), 0.0);
  scene.Mapper->SilhouettesOn();
  // The middle half has its full width if each end takes a quarter.
  scene.Mapper->SetTaper(0.5);
  EXPECT_NEAR(ink(), 0.75 * drawn, 2.0);
  scene.Mapper->SetTaper(0.0);
  scene.Mapper->DashedOn();
  scene.Mapper->SetDashLength(10.0);
  scene.Mapper->SetGapLength(10.0);
  EXPECT_NEAR(ink(), 0.5 * drawn, 2.0);
}

/// Each of very many segments, a pixel large, and none of those that face the eye.
TEST(VoxelStrokes, ManySegments)
{
  for (const int side : { 34, 334 }) // 1,040 and 100,400 segments
  {
    std::vector<Voxel> voxels;
    const auto hasSegment = [](int i, int j) { return (i + j) % 10 != 0; };
    for (int j = 0; j < side; ++j)
    {
      for (int i = 0; i < side; ++i)
      {
        voxels.push_back(
          { { 3.0 * i + 1.5, 3.0 * j + 1.5, 0.0 }, { 0.0, 1.0, hasSegment(i, j) ? 0.05 : 0.15 }, 1.0 });
      }
    }
    Scene scene(MakeVoxels(voxels, 1.0), 3 * side);
    LookAtPixels(scene);
    scene.Mapper->SetCapToButt();
    scene.Mapper->SetLineWidth(1.0);
    const InkTestImage image(scene.Window);
    int segments = 0;
    int wrong = 0;
    for (int j = 0; j < side; ++j)
    {
      for (int i = 0; i < side; ++i)
      {
        segments += hasSegment(i, j);
        wrong += image.IsDark(3 * i + 1, 3 * j + 1) != hasSegment(i, j);
      }
    }
    EXPECT_EQ(wrong, 0) << "of " << side * side;
    EXPECT_NEAR(image.Ink() / segments, 1.0, 0.02) << "nothing else";
  }
}

/// While camera and thresholds change, nothing is sent to the GPU.
TEST(VoxelStrokes, UploadedOnce)
{
  const auto voxels = FindVoxels(MakeBalls(), 5.0);
  Scene scene(voxels);
  const InkTestImage first(scene.Window);
  const vtkMTimeType time = scene.Mapper->GetUploadTime();
  scene.Renderer->GetActiveCamera()->Azimuth(40.0);
  scene.Mapper->SetLargestCosine(0.2);
  EXPECT_GT(InkTestImage(scene.Window).CountDifferent(first, 50), 500);
  EXPECT_EQ(scene.Mapper->GetUploadTime(), time);
  voxels->GetPointData()->GetArray("Gradient")->Modified();
  scene.Window->Render();
  EXPECT_GT(scene.Mapper->GetUploadTime(), time);
}

TEST(VoxelStrokes, SurfaceHides)
{
  const auto voxels = FindVoxels(MakeBalls(), 5.0);
  Scene scene(voxels);
  const InkTestImage all(scene.Window);
  // Before the right half.
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(1000.0, -50.0, 30.0);
  plane->SetPoint1(1100.0, -50.0, 30.0);
  plane->SetPoint2(1000.0, 50.0, 30.0);
  plane->Update();
  scene.Mapper->SetSurfaceData(plane->GetOutput());
  const InkTestImage half(scene.Window);
  EXPECT_GT(all.CountDark(110, 0, 200, 200), 200);
  EXPECT_EQ(half.CountDark(101, 0, 200, 200), 0);
  EXPECT_EQ(half.CountDark(0, 0, 90, 200), all.CountDark(0, 0, 90, 200));
}

TEST(VoxelStrokes, ClippingTilesAndViewports)
{
  const auto voxels = FindVoxels(MakeBalls(), 5.0);
  Scene scene(voxels, 150);
  const InkTestImage all(scene.Window);
  EXPECT_EQ(InkTestImage(scene.Window).CountDifferent(all), 0);

  vtkNew<vtkPlane> plane;
  plane->SetOrigin(1000.0, 0.0, 0.0);
  plane->SetNormal(1.0, 0.0, 0.0);
  scene.Mapper->AddClippingPlane(plane);
  const InkTestImage clipped(scene.Window);
  EXPECT_EQ(clipped.CountDark(0, 0, 74, 150), 0);
  EXPECT_EQ(clipped.CountDark(80, 0, 150, 150), all.CountDark(80, 0, 150, 150));
  scene.Mapper->RemoveAllClippingPlanes();

  // Two tiles along each axis, against one window twice as large.
  const InkTestImage tiles(scene.Window, 2);
  scene.Window->SetSize(300, 300);
  scene.Mapper->SetLineWidth(4.0);
  const InkTestImage large(scene.Window);
  EXPECT_LE(tiles.CountDifferent(large, 4), 10);

  scene.Window->SetSize(300, 150);
  scene.Mapper->SetLineWidth(2.0);
  EXPECT_LE(CountDifferentInViewports(all, scene, scene.Actor, 4), 4);
}

/// Selection finds voxels, and only those that are drawn.
TEST(VoxelStrokes, Selection)
{
  const auto voxels = FindVoxels(MakeBalls(), 5.0);
  Scene scene(voxels);
  scene.Window->Render();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.Renderer);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_POINTS);
  selector->SetArea(0, 0, 199, 199);
  const auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  ASSERT_EQ(selection->GetNumberOfNodes(), 1u);
  auto* ids = vtkIdTypeArray::SafeDownCast(selection->GetNode(0)->GetSelectionList());
  EXPECT_GT(ids->GetNumberOfTuples(), 50);
  double eye[3];
  scene.Renderer->GetActiveCamera()->GetPosition(eye);
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
  {
    double p[3];
    double g[3];
    voxels->GetPoint(ids->GetValue(i), p);
    voxels->GetPointData()->GetArray("Gradient")->GetTuple(ids->GetValue(i), g);
    const double e[3] = { eye[0] - p[0], eye[1] - p[1], eye[2] - p[2] };
    const double cosine = (g[0] * e[0] + g[1] * e[1] + g[2] * e[2]) /
      (std::hypot(g[0], g[1], g[2]) * std::hypot(e[0], e[1], e[2]));
    EXPECT_LE(std::abs(cosine), 0.1001);
  }
}

TEST(VoxelStrokes, OddVoxels)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Voxel good{ { 50.0, 50.0, 0.0 }, { 1.0, 0.0, 0.0 }, 1.0 };
  const auto make = [&](Voxel odd) { return MakeVoxels({ odd, good }, 30.0); };
  Voxel nowhere = good;
  nowhere.Position[1] = nan;
  Voxel flat = good;
  flat.Gradient[0] = 0.0;
  Voxel unknown = good;
  unknown.Gradient[2] = nan;
  Voxel along = good;
  along.Gradient[0] = 0.0;
  along.Gradient[2] = 1.0;
  Voxel tiny = good;
  tiny.Gradient[0] = 1e-35;
  for (const Voxel& odd : { nowhere, flat, unknown, along, tiny })
  {
    Scene scene(make(odd), 100);
    LookAtPixels(scene);
    scene.Mapper->SetCapToButt();
    scene.Mapper->SetLargestCosine(1.0);
    EXPECT_NEAR(InkTestImage(scene.Window).Ink(), 60.0, 1.0);
  }
  // Alone, the faintest gradient has a direction, too.
  Scene faint(MakeVoxels({ tiny }, 30.0), 100);
  LookAtPixels(faint);
  faint.Mapper->SetCapToButt();
  EXPECT_NEAR(InkTestImage(faint.Window).Ink(), 60.0, 1.0);

  for (const char* name : { "Gradient", "Value", "Radius" })
  {
    const auto bare = make(good);
    bare->GetPointData()->RemoveArray(name);
    Scene scene(bare, 100);
    vtkNew<InkTestMessages> messages;
    messages->Observe(scene.Mapper);
    EXPECT_EQ(InkTestImage(scene.Window).Ink(), 0.0);
    scene.Window->Render();
    messages->Expect(name, { name, "vtkInkEdgeVoxels", "found none" });
  }

  for (const char* name : { "Gradient", "Value", "Radius" })
  {
    const auto fewer = make(good);
    fewer->GetPointData()->GetArray(name)->SetNumberOfTuples(1);
    Scene scene(fewer, 100);
    vtkNew<InkTestMessages> messages;
    messages->Observe(scene.Mapper);
    EXPECT_EQ(InkTestImage(scene.Window).Ink(), 0.0);
    messages->Expect(name, { name, "2 points", "found 1" });
  }
}

/// Voxels have the colors of cells where there is a cell for each.
TEST(VoxelStrokes, ColorsOfCells)
{
  const auto voxels = MakeVoxels(
    { { { 50.0, 30.0, 0.0 }, { 1.0, 0.0, 0.0 }, 1.0 }, { { 50.0, 70.0, 0.0 }, { 1.0, 0.0, 0.0 }, 1.0 } },
    30.0);
  Scene scene(voxels, 100);
  LookAtPixels(scene);
  scene.Mapper->SetLineWidth(6.0);
  scene.Mapper->ScalarVisibilityOn();
  scene.Mapper->SetScalarModeToUseCellData();
  const auto color = [&](const std::vector<std::vector<vtkIdType>>& cells)
  {
    vtkNew<vtkCellArray> verts;
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetNumberOfComponents(3);
    for (std::size_t cell = 0; cell < cells.size(); ++cell)
    {
      verts->InsertNextCell(static_cast<vtkIdType>(cells[cell].size()), cells[cell].data());
      colors->InsertNextTuple3(cell == 0 ? 255 : 0, cell == 1 ? 255 : 0, 0);
    }
    voxels->SetVerts(verts);
    voxels->GetCellData()->SetScalars(colors);
    voxels->Modified();
    return InkTestImage(scene.Window);
  };
  vtkNew<InkTestMessages> messages;
  messages->Observe(scene.Mapper);
  const InkTestImage each = color({ { 0 }, { 1 } });
  EXPECT_EQ(each.Channel(50, 30, 0), 255);
  EXPECT_EQ(each.Channel(50, 30, 1), 0);
  EXPECT_EQ(each.Channel(50, 70, 0), 0);
  EXPECT_EQ(each.Channel(50, 70, 1), 255);
  messages->Expect("a cell for each", {});
  const InkTestImage all = color({ { 0, 1 } });
  EXPECT_TRUE(all.IsDark(50, 30) && all.IsDark(50, 70));
  messages->Expect("a cell for both", { "scalars of points", "found 1 of cells" });
}
