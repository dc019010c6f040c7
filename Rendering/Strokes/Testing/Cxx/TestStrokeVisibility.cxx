// SPDX-License-Identifier: BSD-3-Clause
// Which parts of contours are drawn: those that the surface does not hide.
#include "InkTestImage.h"
#include "InkTestScene.h"
#include "InkTestVolume.h"
#include "StrokeScene.h"
#include "TubeSurfaces.h"
#include "vtkInkSilhouetteMapper.h"

#include "Curves/Contours/MeshContours.h"

#include "vtkImageData.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"

#include <gtest/gtest.h>

#include <vector>

namespace
{

struct Sample
{
  double X; ///< pixels
  double Y;
  bool Hidden;
};

/// Where a camera that looks at the origin is, and how it projects.
struct View
{
  glm::dvec3 Position;
  bool Parallel = false;

  ink::Eye GetEye() const
  {
    return this->Parallel ? ink::Eye::along(-this->Position) : ink::Eye::at(this->Position);
  }
  /// A point that rays from one of the surface to the eye pass.
  glm::dvec3 TowardsEye(const glm::dvec3& point) const
  {
    return this->Parallel ? point + 4.0 * this->Position : this->Position;
  }
};

/// A view on which pixels of a square picture are known by heart.
void LookAt(vtkRenderer* renderer, const View& view)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(view.Position.x, view.Position.y, view.Position.z);
  camera->SetParallelProjection(view.Parallel);
  camera->SetParallelScale(1.5);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetViewUp(0.0, 1.0, 0.1);
  camera->SetViewAngle(30.0);
  renderer->ResetCameraClippingRange();
}

/// Points of the exact surface's contour, found on a much finer mesh.
std::vector<glm::dvec3> FindContour(const TubeSurface& surface, const View& view)
{
  const auto mesh = surface.Mesh(600, 300);
  std::vector<glm::dvec3> points;
  std::vector<glm::vec3> normals;
  std::vector<ink::Triangle> triangles;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    points.emplace_back(p[0], p[1], p[2]);
    mesh->GetPointData()->GetNormals()->GetTuple(i, p);
    normals.emplace_back(p[0], p[1], p[2]);
  }
  for (vtkIdType i = 0; i < mesh->GetNumberOfPolys(); ++i)
  {
    vtkIdType count;
    const vtkIdType* ids;
    mesh->GetPolys()->GetCellAtId(i, count, ids);
    triangles.push_back({ static_cast<std::uint32_t>(ids[0]), static_cast<std::uint32_t>(ids[1]),
      static_cast<std::uint32_t>(ids[2]) });
  }
  const ink::MeshContours finder({ points, triangles, {}, {} }, normals);
  std::vector<glm::dvec3> contour;
  for (glm::dvec3 p : finder.find(view.GetEye()).positions)
  {
    // Onto the exact surface.
    const double step = 1e-6;
    const glm::dvec3 gradient(
      surface.Distance(p + glm::dvec3(step, 0, 0)) - surface.Distance(p - glm::dvec3(step, 0, 0)),
      surface.Distance(p + glm::dvec3(0, step, 0)) - surface.Distance(p - glm::dvec3(0, step, 0)),
      surface.Distance(p + glm::dvec3(0, 0, step)) - surface.Distance(p - glm::dvec3(0, 0, step)));
    contour.push_back(p - surface.Distance(p) * glm::normalize(gradient));
  }
  return contour;
}

/// Those of them that are in the picture, evenly spaced there: in space a contour runs along the view where
/// it ends in a cusp.
std::vector<Sample> FindTruth(const TubeSurface& surface, const std::vector<glm::dvec3>& contour,
  vtkRenderer* renderer, const View& view, int size)
{
  std::vector<Sample> samples;
  const double spacing = size / 500.0;
  for (const glm::dvec3& p : contour)
  {
    renderer->SetWorldPoint(p.x, p.y, p.z, 1.0);
    renderer->WorldToDisplay();
    const double* display = renderer->GetDisplayPoint();
    const bool apart =
      samples.empty() || std::hypot(display[0] - samples.back().X, display[1] - samples.back().Y) >= spacing;
    if (apart && display[0] > 3 && display[1] > 3 && display[0] < size - 3 && display[1] < size - 3)
    {
      samples.push_back({ display[0], display[1], surface.Hides(p, view.TowardsEye(p)) });
    }
  }
  return samples;
}

/// Whether there is ink within so many pixels.
bool HasInk(const InkTestImage& image, const Sample& sample, double reach)
{
  for (int y = static_cast<int>(sample.Y - reach); y <= sample.Y + reach; ++y)
  {
    for (int x = static_cast<int>(sample.X - reach); x <= sample.X + reach; ++x)
    {
      if (std::hypot(x + 0.5 - sample.X, y + 0.5 - sample.Y) <= reach && image.Gray(x, y) < 150)
      {
        return true;
      }
    }
  }
  return false;
}

bool IsNearVisible(const std::vector<Sample>& samples, const Sample& sample, double reach)
{
  for (const Sample& other : samples)
  {
    if (!other.Hidden && std::hypot(other.X - sample.X, other.Y - sample.Y) < reach)
    {
      return true;
    }
  }
  return false;
}

} // namespace

namespace
{

constexpr double LineWidth = 3.0; // pixels

/// Counts how much of a surface's exact contour a scene draws of it, and expects no less than a share of what
/// is visible, and of what is hidden to be left out.
void ExpectShares(InkTestScene<vtkInkSilhouetteMapper>& scene, const TubeSurface& surface,
  const std::vector<glm::dvec3>& contour, const View& view, double least, const std::string& name)
{
  const int size = scene.Window->GetSize()[0];
  scene.Mapper->SetSizeUnitToPixels();
  scene.Mapper->SetLineWidth(LineWidth);
  scene.Mapper->BordersOff();
  LookAt(scene.Renderer, view);
  // The surface itself is drawn, too, and hides nothing of its contours.
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(surface.Mesh(240, 120));
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetLighting(false);
  scene.Renderer->AddActor(actor);
  const InkTestImage image(scene.Window);
  const std::vector<Sample> truth = FindTruth(surface, contour, scene.Renderer, view, size);
  int visible = 0;
  int drawn = 0;
  int hidden = 0;
  int omitted = 0;
  for (const Sample& sample : truth)
  {
    if (!sample.Hidden)
    {
      ++visible;
      drawn += HasInk(image, sample, 1.5);
    }
    else if (!IsNearVisible(truth, sample, 0.5 * LineWidth + 1.5))
    {
      ++hidden;
      omitted += !HasInk(image, sample, 0.7);
    }
  }
  testing::Test::RecordProperty(name,
    std::to_string(drawn) + " of " + std::to_string(visible) + ", " + std::to_string(omitted) + " of " +
      std::to_string(hidden));
  EXPECT_GT(visible, 500) << name;
  EXPECT_GT(hidden, 100) << name;
  EXPECT_GE(drawn, least * visible) << name << ": visible " << visible;
  EXPECT_GE(omitted, least * hidden) << name << ": hidden " << hidden;
}

struct ShareCase
{
  TubeSurface Surface;
  std::vector<View> Views;
};

std::vector<ShareCase> ShareCases()
{
  return { { MakeTorus(), { { { 1.0, -4.7, 1.5 } }, { { 0.3, -4.0, 2.0 } }, { { 0.6, -4.5, 2.2 }, true } } },
    { MakeKnot(), { { { 1.0, -4.0, 3.0 } }, { { 0.5, 1.5, 5.5 } }, { { -0.7, 2.0, 5.0 }, true } } },
    { MakeSpheres(), { { { 0.5, 1.5, 5.5 } }, { { -1.5, 1.0, 5.0 } }, { { 0.4, 1.2, 5.5 }, true } } } };
}

std::string NameOf(const TubeSurface& surface, const View& view, int size)
{
  return surface.Name + (view.Parallel ? " parallel" : "") + " from z = " + std::to_string(view.Position.z) +
    " at " + std::to_string(size);
}

} // namespace

/// Of the exact contours no less than 99 % of the visible part is drawn, and of the hidden part is not.
TEST(StrokeVisibility, ShareOfTheContour)
{
  for (const auto& [surface, views] : ShareCases())
  {
    for (const View& view : views)
    {
      const std::vector<glm::dvec3> contour = FindContour(surface, view);
      for (const int size : { 512, 2048 })
      {
        InkTestScene<vtkInkSilhouetteMapper> scene(surface.Mesh(240, 120), size, size);
        ExpectShares(scene, surface, contour, view, 0.99, NameOf(surface, view, size));
      }
    }
  }
}

/// Straight from samples, with discs in place of the surface.
TEST(StrokeVisibility, ShareOfTheContourOfAnImage)
{
  for (const auto& [surface, views] : ShareCases())
  {
    constexpr double spacing = 0.03;
    constexpr double margin = 0.1;
    double box[6];
    surface.Mesh(60, 30)->GetBounds(box);
    vtkNew<vtkImageData> image;
    const auto samples = [&](int axis)
    { return static_cast<int>((box[2 * axis + 1] - box[2 * axis] + 2.0 * margin) / spacing) + 2; };
    image->SetDimensions(samples(0), samples(1), samples(2));
    image->SetOrigin(box[0] - margin, box[2] - margin, box[4] - margin);
    image->SetSpacing(spacing, spacing, spacing);
    InkTestFill(image, VTK_FLOAT,
      [&](double x, double y, double z) {
        return -surface.Distance({ x, y, z });
      });
    for (const View& view : views)
    {
      const std::vector<glm::dvec3> contour = FindContour(surface, view);
      for (const int size : { 512, 2048 })
      {
        InkTestScene<vtkInkSilhouetteMapper> scene(nullptr, size, size);
        scene.Mapper->SetInputData(image);
        scene.Mapper->SetValue(0, 0.0);
        ExpectShares(scene, surface, contour, view, 0.99, NameOf(surface, view, size));
      }
    }
  }
}

/// How short a hidden part is that joins its neighbors is in pixels of the window that is shown in tiles.
TEST(StrokeVisibility, ShortestPartInTiles)
{
  vtkNew<vtkPlaneSource> bar;
  bar->SetOrigin(40.0, 20.0, 10.0);
  bar->SetPoint1(46.0, 20.0, 10.0);
  bar->SetPoint2(40.0, 80.0, 10.0);
  bar->Update();
  for (const double shortest : { 4.0, 8.0 })
  {
    StrokeScene scene(MakeStrokes({ { { 10.0, 50.0, 0.0 }, { 90.0, 50.0, 0.0 } } }), 100, 100);
    scene.LookAtPixels();
    scene.Mapper->SetSurfaceData(bar->GetOutput());
    scene.Mapper->SetLineWidth(3.0);
    scene.Mapper->SetShortestPart(shortest);
    for (const int tiles : { 1, 2 })
    {
      const InkTestImage image(scene.Window, tiles);
      EXPECT_EQ(image.IsDark(43 * tiles, 50 * tiles), shortest > 6.0) << tiles << " tiles, " << shortest;
      EXPECT_TRUE(image.IsDark(30 * tiles, 50 * tiles) && image.IsDark(60 * tiles, 50 * tiles));
    }
  }
}
