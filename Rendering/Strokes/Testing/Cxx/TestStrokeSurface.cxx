// SPDX-License-Identifier: BSD-3-Clause
// Two mappers that draw strokes on one surface share what the GPU has of it.
#include "InkTestImage.h"
#include "StrokeScene.h"
#include "vtkInkSilhouetteMapper.h"

#include "InkOpenGLCompat.h"

#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace
{

/// A sphere's meridians, and over them its contours.
class MeridianScene : public StrokeScene
{
public:
  explicit MeridianScene(bool shares)
    : StrokeScene(Meridians())
  {
    this->Sphere->SetRadius(0.99);
    this->Sphere->SetThetaResolution(40);
    this->Sphere->SetPhiResolution(30);
    this->Sphere->Update();
    this->Mapper->SetSurfaceData(this->Sphere->GetOutput());
    this->Contours->SetInputData(this->Sphere->GetOutput());
    this->Contours->SetSizeUnitToPixels();
    this->Mapper->SetOverlay(this->Contours);
    if (shares)
    {
      this->Mapper->ShareSurface(this->Contours);
    }
  }

  /// How many triangles and points OpenGL draws in a picture from somewhere else.
  int CountPrimitives()
  {
    this->Renderer->GetActiveCamera()->Azimuth(7.0);
    this->Window->MakeCurrent();
    GLuint query = 0;
    glGenQueries(1, &query);
    glBeginQuery(GL_PRIMITIVES_GENERATED, query);
    this->Window->Render();
    glEndQuery(GL_PRIMITIVES_GENERATED);
    GLuint count = 0;
    glGetQueryObjectuiv(query, GL_QUERY_RESULT, &count);
    glDeleteQueries(1, &query);
    return static_cast<int>(count);
  }

  vtkNew<vtkSphereSource> Sphere;
  vtkNew<vtkInkSilhouetteMapper> Contours;

private:
  static vtkSmartPointer<vtkPolyData> Meridians()
  {
    std::vector<StrokePolyline> lines(20);
    for (std::size_t line = 0; line < lines.size(); ++line)
    {
      const double longitude = 0.1 * std::numbers::pi * static_cast<double>(line);
      for (int i = 1; i < 40; ++i)
      {
        const double latitude = std::numbers::pi * (i / 40.0 - 0.5);
        lines[line].push_back({ std::cos(latitude) * std::cos(longitude), std::sin(latitude),
          std::cos(latitude) * std::sin(longitude) });
      }
    }
    return MakeStrokes(lines);
  }
};

} // namespace

TEST(StrokeSurface, DepthIsDrawnOnceWhereItIsShared)
{
  MeridianScene shared(true);
  MeridianScene apart(false);
  shared.Window->Render();
  apart.Window->Render();
  const int triangles = static_cast<int>(shared.Sphere->GetOutput()->GetNumberOfPolys());
  for (int picture = 0; picture < 3; ++picture)
  {
    EXPECT_EQ(shared.CountPrimitives() + triangles, apart.CountPrimitives()) << picture;
  }
  const InkTestImage image(shared.Window);
  EXPECT_EQ(image.CountDifferent(InkTestImage(apart.Window)), 0);
  EXPECT_GT(image.Ink(), 1000.0);
}

TEST(StrokeSurface, ReleasedByEither)
{
  MeridianScene scene(true);
  const InkTestImage before(scene.Window);
  scene.Contours->vtkInkMapper::ReleaseGraphicsResources(scene.Window);
  EXPECT_EQ(before.CountDifferent(InkTestImage(scene.Window)), 0);
  scene.Contours->ReleaseGraphicsResources(scene.Window);
  EXPECT_EQ(before.CountDifferent(InkTestImage(scene.Window)), 0);
  scene.Mapper->SetOverlay(nullptr);
  scene.Mapper->ReleaseGraphicsResources(scene.Window);
  EXPECT_GT(InkTestImage(scene.Window).Ink(), 100.0);
  // Another surface than the other mapper's.
  scene.Sphere->SetRadius(1.5);
  scene.Sphere->Update();
  EXPECT_LT(InkTestImage(scene.Window).Ink(), 1.0) << "all strokes lie within";
}
