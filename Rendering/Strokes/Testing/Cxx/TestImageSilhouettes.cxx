// SPDX-License-Identifier: BSD-3-Clause
// Silhouettes of images, drawn straight from their samples.
#include "ContourUpdates.h"
#include "InkTestImage.h"
#include "InkTestMessages.h"
#include "InkTestScene.h"
#include "InkTestViewports.h"
#include "InkTestVolume.h"
#include "SilhouetteOfUnitBall.h"
#include "vtkInkSilhouetteMapper.h"

#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkFloatArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkPlane.h"
#include "vtkPolyDataMapper.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace
{

class Scene : public InkTestScene<vtkInkSilhouetteMapper>
{
public:
  explicit Scene(vtkImageData* image, std::vector<double> values = { 0.0 }, int size = 200)
    : InkTestScene(nullptr, size, size)
  {
    this->Mapper->SetInputData(image);
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      this->Mapper->SetValue(static_cast<int>(i), values[i]);
    }
    this->Mapper->SetSizeUnitToPixels();
    this->Mapper->SetLineWidth(3.0);
    this->Renderer->ResetCamera();
  }
  vtkPolyData* GetContours() { return this->Mapper->GetContours(this->Renderer, this->Actor); }
};

/// A cube of samples around the origin.
template <class Function>
vtkSmartPointer<vtkImageData> MakeImage(int samples, double width, const Function& function)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(samples, samples, samples);
  image->SetOrigin(-0.5 * width, -0.5 * width, -0.5 * width);
  const double step = width / (samples - 1);
  image->SetSpacing(step, step, step);
  InkTestFill(image, VTK_FLOAT, function);
  return image;
}

double Ball(double x, double y, double z)
{
  return 1.0 - std::hypot(x, y, z);
}

vtkSmartPointer<vtkImageData> BallImage(int samples = 33, double width = 2.4)
{
  return MakeImage(samples, width, Ball);
}

/// Two balls on the z axis, the nearer one smaller.
vtkSmartPointer<vtkImageData> TwoBalls()
{
  return MakeImage(65, 4.0,
    [](double x, double y, double z)
    { return std::max(1.0 - std::hypot(x, y, z + 0.8), 0.6 - std::hypot(x - 0.6, y, z - 1.2)); });
}

vtkSmartPointer<vtkPolyData> MeshOf(vtkImageData* image)
{
  vtkNew<vtkFlyingEdges3D> surface;
  surface->SetInputData(image);
  surface->SetValue(0, 0.0);
  surface->Update();
  return surface->GetOutput();
}

} // namespace

/// The outline of a ball's samples is the circle of the ball.
TEST(ImageSilhouettes, Ball)
{
  for (const bool parallel : { false, true })
  {
    Scene scene(BallImage());
    ExpectOutlineOfUnitBall(scene, parallel);
  }
}

/// Contours are found again when the camera, the actor, the image or an iso-value changes, and not otherwise.
TEST(ImageSilhouettes, Updates)
{
  const auto ball = BallImage();
  Scene scene(ball);
  ContourUpdates expect(scene);
  const auto radius = [&]
  {
    double bounds[6];
    scene.GetContours()->GetBounds(bounds);
    return 0.5 * (bounds[3] - bounds[2]);
  };
  expect.ExpectThoseOfTheView();
  const double large = radius();
  scene.Mapper->SetValue(0, 0.5);
  expect(true, "another iso-value");
  EXPECT_NEAR(radius() / large, 0.5, 0.02);
  scene.Mapper->SetValue(0, 0.5);
  expect(false, "the same iso-value");
  scene.Mapper->SetValue(1, 0.0);
  expect(true, "one more");
  EXPECT_EQ(scene.GetContours()->GetNumberOfLines(), 2);
  auto* index = scene.GetContours()->GetCellData()->GetArray("SurfaceIndex");
  ASSERT_TRUE(index);
  EXPECT_EQ(index->GetComponent(0, 0), 0.0);
  EXPECT_EQ(index->GetComponent(1, 0), 1.0);
  scene.Mapper->SetNumberOfContours(1);
  expect(true, "one less");
  EXPECT_EQ(scene.GetContours()->GetNumberOfLines(), 1);
  ball->GetPointData()->GetScalars()->Modified();
  expect(true, "another image");
  expect(false, "the same picture again");
}

/// Discs hide what a mesh of the surface hides: of the farther ball's outline, what lies behind the nearer
/// one.
TEST(ImageSilhouettes, HiddenParts)
{
  const auto balls = TwoBalls();
  for (const int size : { 200, 800 })
  {
    Scene scene(balls, { 0.0 }, size);
    Scene ofMesh(balls, { 0.0 }, size);
    ofMesh.Mapper->SetInputData(MeshOf(balls));
    ofMesh.Mapper->SetLineWidth(3.0);
    std::vector<double> ink;
    for (Scene* one : { &scene, &ofMesh })
    {
      vtkCamera* camera = one->Renderer->GetActiveCamera();
      camera->SetPosition(0.0, 0.0, 9.0);
      camera->SetFocalPoint(0.0, 0.0, 0.0);
      one->Renderer->ResetCameraClippingRange();
      for (const int parts :
        { vtkInkStrokeMapper::OMITTED, vtkInkStrokeMapper::FAINT, vtkInkStrokeMapper::DASHED })
      {
        one->Mapper->SetHiddenParts(parts);
        one->Mapper->SetHiddenOpacity(1.0);
        one->Mapper->SetDashLength(6.0);
        one->Mapper->SetGapLength(6.0);
        ink.push_back(InkTestImage(one->Window).Ink());
      }
    }
    const double hidden = ink[1] - ink[0];
    EXPECT_GT(hidden, 0.1 * ink[1]) << size;
    EXPECT_NEAR((ink[2] - ink[0]) / hidden, 0.5, 0.08) << size;
    EXPECT_NEAR(ink[0] / ink[3], 1.0, 0.01) << size << ": visible, as of the mesh";
    EXPECT_NEAR(ink[1] / ink[4], 1.0, 0.01) << size << ": all";
  }
  // Another surface hides them instead.
  Scene other(balls);
  vtkNew<vtkSphereSource> far;
  far->SetCenter(0.0, 0.0, -50.0);
  far->Update();
  const double visible = InkTestImage(other.Window).Ink();
  other.Mapper->SetSurfaceData(far->GetOutput());
  EXPECT_GT(InkTestImage(other.Window).Ink(), 1.05 * visible);
}

/// Discs that are large beside the surface's curvature, and in the picture, hide nothing of its own outline.
TEST(ImageSilhouettes, CoarseImage)
{
  for (const int samples : { 7, 9, 13 })
  {
    Scene scene(BallImage(samples), { 0.0 }, 800);
    for (const double azimuth : { 0.0, 20.0, 25.0 })
    {
      scene.Renderer->GetActiveCamera()->Azimuth(azimuth);
      scene.Renderer->GetActiveCamera()->Elevation(0.5 * azimuth);
      scene.Mapper->SetHiddenPartsToOmitted();
      const double visible = InkTestImage(scene.Window).Ink();
      scene.Mapper->SetHiddenPartsToFaint();
      scene.Mapper->SetHiddenOpacity(1.0);
      EXPECT_EQ(InkTestImage(scene.Window).Ink(), visible) << samples << ", " << azimuth;
      EXPECT_GT(visible, 3000.0);
    }
  }
}

/// Where a surface leaves the image it has a border, and may be seen from its inside.
TEST(ImageSilhouettes, Borders)
{
  const auto half = MakeImage(33, 2.4, [](double x, double y, double z) { return Ball(x, y, z - 1.2); });
  Scene scene(half);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(1.5);
  camera->SetFocalPoint(0.0, 0.0, 1.0);
  camera->SetPosition(0.0, 6.0, 7.0);
  scene.Renderer->ResetCameraClippingRange();
  const auto kinds = [&]
  {
    scene.Window->Render();
    std::vector<int> found;
    auto* array =
      vtkUnsignedCharArray::SafeDownCast(scene.GetContours()->GetCellData()->GetArray("ContourKind"));
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      found.push_back(array->GetValue(i));
    }
    return found;
  };
  EXPECT_EQ(kinds(), (std::vector<int>{ 0, 2 }));
  const double all = InkTestImage(scene.Window).Ink();
  scene.Mapper->BordersOff();
  EXPECT_EQ(kinds(), (std::vector<int>{ 0 }));
  const double silhouette = InkTestImage(scene.Window).Ink();
  scene.Mapper->BordersOn();
  scene.Mapper->SilhouettesOff();
  EXPECT_EQ(kinds(), (std::vector<int>{ 2 }));
  const double border = InkTestImage(scene.Window).Ink();
  // In pixels 66.7 to a unit; the circle of the border is seen as an ellipse, the half of the outline as half
  // a circle.
  const double unit = 100.0 / 1.5;
  EXPECT_NEAR(silhouette / (3.0 * std::numbers::pi * unit), 1.0, 0.05);
  // Of half axes 1 and cos(45 degrees).
  EXPECT_NEAR(border / (3.0 * 5.4026 * unit), 1.0, 0.05);
  EXPECT_NEAR(all / (silhouette + border), 0.95, 0.03) << "they overlap where they meet";
}

TEST(ImageSilhouettes, ClippingPlanes)
{
  Scene scene(BallImage());
  const InkTestImage whole(scene.Window);
  vtkNew<vtkPlane> right;
  right->SetNormal(1.0, 0.0, 0.0);
  scene.Mapper->AddClippingPlane(right);
  const InkTestImage image(scene.Window);
  EXPECT_EQ(image.CountDark(0, 0, 99, 200), 0);
  EXPECT_EQ(image.CountDark(101, 0, 200, 200), whole.CountDark(101, 0, 200, 200));
}

/// Samples of the image beside the outline are picked.
TEST(ImageSilhouettes, Selection)
{
  const auto ball = BallImage();
  Scene scene(ball);
  scene.Window->Render();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.Renderer);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_POINTS);
  selector->SetArea(100, 0, 199, 199);
  const auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  ASSERT_EQ(selection->GetNumberOfNodes(), 1u);
  auto* ids = vtkIdTypeArray::SafeDownCast(selection->GetNode(0)->GetSelectionList());
  EXPECT_GT(ids->GetNumberOfTuples(), 10);
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
  {
    double p[3];
    ball->GetPoint(ids->GetValue(i), p);
    EXPECT_LT(std::abs(Ball(p[0], p[1], p[2])), 0.07) << "by no more than a cell from the surface";
    EXPECT_TRUE(p[0] > -0.15 && std::abs(p[2]) < 0.5) << "beside the right half of the outline";
  }
}

/// The same picture with any number of threads, in a viewport and in tiles.
TEST(ImageSilhouettes, ThreadsViewportsTiles)
{
  const auto balls = TwoBalls();
  setenv("VTK_SMP_MAX_THREADS", "1", 1);
  Scene one(balls);
  const InkTestImage expected(one.Window);
  setenv("VTK_SMP_MAX_THREADS", "2", 1);
  Scene two(balls);
  EXPECT_EQ(InkTestImage(two.Window).CountDifferent(expected), 0) << "two threads";
  unsetenv("VTK_SMP_MAX_THREADS");
  EXPECT_GT(expected.CountDark(), 500);

  Scene large(balls, { 0.0 }, 400);
  large.Mapper->SetLineWidth(6.0);
  EXPECT_LE(InkTestImage(two.Window, 2).CountDifferent(InkTestImage(large.Window), 6), 4) << "tiles";
  Scene narrow(balls);
  narrow.Window->SetSize(100, 200);
  narrow.Renderer->ResetCamera();
  EXPECT_EQ(CountDifferentInViewports(InkTestImage(narrow.Window), one, one.Actor, 2), 0) << "viewports";
}

/// Every scalar type, oriented and anisotropic grids, samples that are missing or hidden.
TEST(ImageSilhouettes, AnyImage)
{
  const double ink = InkTestImage(Scene(BallImage()).Window).Ink();
  for (const int type :
    { VTK_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_INT, VTK_LONG_LONG, VTK_DOUBLE })
  {
    auto image = BallImage();
    InkTestFill(image, type, [](double x, double y, double z) { return 60.0 + 50.0 * Ball(x, y, z); });
    EXPECT_NEAR(InkTestImage(Scene(image, { 60.0 }).Window).Ink() / ink, 1.0, 0.02) << type;
  }
  auto turned = vtkSmartPointer<vtkImageData>::New();
  turned->SetExtent(-20, 20, 3, 43, 0, 13);
  turned->SetSpacing(0.06, 0.06, 0.18);
  turned->SetDirectionMatrix(0.0, 0.6, 0.8, 1.0, 0.0, 0.0, 0.0, 0.8, -0.6);
  double middle[3];
  turned->TransformContinuousIndexToPhysicalPoint(0.0, 23.0, 6.5, middle);
  turned->SetOrigin(-middle[0], -middle[1], -middle[2]);
  InkTestFill(turned, VTK_FLOAT, Ball);
  Scene scene(turned);
  scene.Renderer->ResetCamera(-1.2, 1.2, -1.2, 1.2, -1.2, 1.2);
  EXPECT_NEAR(InkTestImage(scene.Window).Ink() / ink, 1.0, 0.03) << "turned";

  auto holes = BallImage();
  holes->GetPointData()->GetScalars()->SetComponent(16 + 33 * (16 + 33 * 30), 0, NAN);
  Scene withHole(holes);
  withHole.Window->Render();
  EXPECT_EQ(withHole.GetContours()->GetNumberOfLines(), 2) << "the border of a hole";
  holes->AllocatePointGhostArray();
  holes->GetPointGhostArray()->SetValue(16 + 33 * (16 + 33 * 2), vtkDataSetAttributes::HIDDENPOINT);
  holes->Modified();
  withHole.Window->Render();
  EXPECT_EQ(withHole.GetContours()->GetNumberOfLines(), 3) << "of two";
}

TEST(ImageSilhouettes, ArraysAndComponents)
{
  auto image = BallImage();
  vtkNew<vtkFloatArray> two;
  two->SetName("Two");
  two->SetNumberOfComponents(2);
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    two->InsertNextTuple2(-5.0, scalars->GetComponent(i, 0) + 7.0);
  }
  image->GetPointData()->AddArray(two);
  const InkTestImage expected(Scene(image).Window);
  Scene other(image, { 7.0 });
  other.Mapper->SetInputArrayToProcess(1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Two");
  other.Mapper->SetImageComponent(1);
  EXPECT_LT(InkTestImage(other.Window).CountDifferent(expected, 40), 10);
  vtkNew<vtkInkSilhouetteMapper> copy;
  copy->ShallowCopy(other.Mapper);
  EXPECT_EQ(copy->GetNumberOfContours(), 1);
  EXPECT_EQ(copy->GetValue(0), 7.0);
  EXPECT_EQ(copy->GetImageComponent(), 1);
  const InkTestImage before(other.Window);
  other.Actor->SetMapper(copy);
  EXPECT_EQ(InkTestImage(other.Window).CountDifferent(before), 0);
}

/// A mapper may get an image after a mesh, and a mesh after an image.
TEST(ImageSilhouettes, OtherInputs)
{
  const auto ball = BallImage();
  Scene scene(ball);
  const InkTestImage expected(scene.Window);
  scene.Mapper->SetInputData(MeshOf(ball));
  const InkTestImage ofMesh(scene.Window);
  EXPECT_GT(ofMesh.CountDark(), 500);
  EXPECT_LT(ofMesh.CountDifferent(expected, 60), 60);
  scene.Mapper->SetInputData(ball);
  EXPECT_EQ(InkTestImage(scene.Window).CountDifferent(expected), 0);
}

TEST(ImageSilhouettes, Messages)
{
  const auto ball = BallImage();
  const auto expect = [&](vtkImageData* image, const std::vector<double>& values, const char* name,
                        const std::vector<std::string>& words, const auto& prepare)
  {
    Scene scene(image, values);
    vtkNew<InkTestMessages> messages;
    messages->Observe(scene.Mapper);
    prepare(scene.Mapper.Get());
    EXPECT_EQ(InkTestImage(scene.Window).Ink(), 0.0) << name;
    scene.Window->Render();
    messages->Expect(name, words);
  };
  const auto plain = [](vtkInkSilhouetteMapper*) {};
  expect(ball, {}, "no iso-value", { "No iso-value", "SetValue" }, plain);
  expect(ball, { 50.0 }, "outside", { "50", "up to 1" }, plain);
  expect(ball, { std::numeric_limits<double>::quiet_NaN() }, "NaN", { "NaN" }, plain);
  auto flat = vtkSmartPointer<vtkImageData>::New();
  flat->SetDimensions(10, 10, 1);
  flat->AllocateScalars(VTK_FLOAT, 1);
  expect(flat, { 0.0 }, "flat", { "10 x 10 x 1", "at least 2" }, plain);
  expect(ball, { 0.0 }, "array", { "Nothing", "Density" },
    [](vtkInkSilhouetteMapper* mapper)
    { mapper->SetInputArrayToProcess(1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Nothing"); });
  expect(ball, { 0.0 }, "component", { "Component 3", "1 component" },
    [](vtkInkSilhouetteMapper* mapper) { mapper->SetImageComponent(3); });
  expect(ball, { 0.0 }, "image space", { "polygons", "image" },
    [](vtkInkSilhouetteMapper* mapper) { mapper->SetMethodToImageSpace(); });
  expect(ball, { 0.0 }, "toon", { "polygons", "image" },
    [](vtkInkSilhouetteMapper* mapper) { mapper->SetMethodToToon(); });
  expect(ball, { 0.0 }, "voxels", { "vtkInkEdgeVoxels", "image" },
    [](vtkInkSilhouetteMapper* mapper) { mapper->SetMethodToVoxelSegments(); });
}
