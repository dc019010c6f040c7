// SPDX-License-Identifier: BSD-3-Clause
// Stipples hidden by a surface leave OpenGL's state as they found it, and look the same in tiles and under
// depth peeling.
#include "InkTestImage.h"
#include "InkTestStipples.h"
#include "StippleScene.h"

#include "InkOpenGLCompat.h"

#include "vtkCallbackCommand.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <array>
#include <tuple>

namespace
{

vtkSmartPointer<vtkPolyData> SphereMesh()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(1.0);
  sphere->SetThetaResolution(80);
  sphere->SetPhiResolution(80);
  sphere->Update();
  return sphere->GetOutput();
}

} // namespace

/// The polygon offset is what another mapper of the scene left.
TEST(StippleOpenGL, PolygonOffset)
{
  StippleScene scene(InkTestStipples::SphereSurface(1.0, 800, 8));
  scene.Mapper->SetSurfaceData(SphereMesh());
  scene.Window->Render();
  for (const bool enabled : { false, true })
  {
    // After the mapper's input is up to date, before it draws.
    vtkNew<vtkCallbackCommand> before;
    before->SetClientData(const_cast<bool*>(&enabled));
    before->SetCallback(
      [](vtkObject*, unsigned long, void* wanted, void*)
      {
        *static_cast<const bool*>(wanted) ? glEnable(GL_POLYGON_OFFSET_FILL)
                                          : glDisable(GL_POLYGON_OFFSET_FILL);
        glPolygonOffset(1.5f, 7.0f);
      });
    std::array<float, 3> found{};
    vtkNew<vtkCallbackCommand> after;
    after->SetClientData(found.data());
    after->SetCallback(
      [](vtkObject*, unsigned long, void* values, void*)
      {
        auto* offset = static_cast<float*>(values);
        offset[0] = glIsEnabled(GL_POLYGON_OFFSET_FILL) ? 1.0f : 0.0f;
        glGetFloatv(GL_POLYGON_OFFSET_FACTOR, offset + 1);
        glGetFloatv(GL_POLYGON_OFFSET_UNITS, offset + 2);
      });
    const unsigned long first = scene.Mapper->AddObserver(vtkCommand::EndEvent, before);
    const unsigned long last = scene.Mapper->AddObserver(vtkCommand::ProgressEvent, after);
    scene.Renderer->GetActiveCamera()->Azimuth(5.0);
    scene.Window->Render();
    EXPECT_EQ(found, (std::array{ enabled ? 1.0f : 0.0f, 1.5f, 7.0f }))
      << "the polygon offset as before, found " << found[0] << ' ' << found[1] << ' ' << found[2];
    scene.Mapper->RemoveObserver(first);
    scene.Mapper->RemoveObserver(last);
    glDisable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(0.0f, 0.0f);
  }
}

/// A picture in tiles is that of a window as large: dots on a seam are whole, also where a surface hides
/// others.
TEST(StippleOpenGL, Tiles)
{
  const auto stipples = InkTestStipples::SphereSurface(1.0, 800, 8);
  constexpr int size = 240;
  // Pixels of the window that is shown in tiles; small dots are far less than one.
  for (const auto& [tiles, diameter, room] : { std::tuple(4, 21.6, 346.0), std::tuple(8, 0.6, 0.5) })
  {
    const auto draw = [&, diameter = diameter, room = room](int parts)
    {
      StippleScene scene(stipples, size / parts, size / parts);
      scene.Mapper->SetSurfaceData(SphereMesh());
      scene.Renderer->GetActiveCamera()->Zoom(1.7);
      scene.Mapper->SetStippleSize(diameter / parts);
      scene.Mapper->SetPixelsPerStipple(room / (parts * parts));
      return InkTestImage(scene.Window, parts);
    };
    const InkTestImage whole = draw(1);
    const InkTestImage tiled = draw(tiles);
    const int different = tiled.CountDifferent(whole, 2);
    EXPECT_EQ(different, 0) << tiles << " x " << tiles << " tiles";
    EXPECT_GT(whole.Ink(), 2000.0) << diameter;
  }
}

/// Depth peeling draws several times, into its own buffers and blending by maxima; the surface's image is
/// drawn among that.
TEST(StippleOpenGL, Peeled)
{
  const auto stipples = InkTestStipples::SphereSurface(1.0, 800, 8);
  const auto draw = [&](bool peeled)
  {
    StippleScene scene(stipples);
    scene.Mapper->SetSurfaceData(SphereMesh());
    scene.Renderer->SetUseDepthPeeling(peeled);
    scene.Renderer->SetMaximumNumberOfPeels(20);
    scene.Renderer->SetOcclusionRatio(0.0);
    return InkTestImage(scene.Window);
  };
  const InkTestImage usual = draw(false);
  const int different = draw(true).CountDifferent(usual, 12);
  EXPECT_TRUE(usual.Ink() > 1000.0 && different == 0)
    << "the same picture peeled, but for " << different << " pixels";
}
