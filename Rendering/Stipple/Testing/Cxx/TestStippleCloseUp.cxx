// SPDX-License-Identifier: BSD-3-Clause
// The eye just before the object and in it: the room for stipples is each element's own, wherever the
// clipping planes are.
#include "InkTestStipples.h"
#include "StippleScene.h"

#include "vtkFloatArray.h"
#include "vtkPlaneSource.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace
{

/// T of all stipples that lie beyond the near plane.
std::vector<double> FindTones(StippleScene& scene, vtkPolyData* stipples, double nearPlane)
{
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetClippingRange(nearPlane, 10.0);
  scene.Window->Render();
  vtkNew<vtkFloatArray> marks;
  scene.Mapper->EvaluateMarks(scene.Renderer, scene.Actor, marks);
  std::vector<double> tones;
  for (vtkIdType i = 0; i < marks->GetNumberOfTuples(); ++i)
  {
    if (camera->GetPosition()[2] - stipples->GetPoint(i)[2] > 0.2)
    {
      tones.push_back(marks->GetComponent(i, 0));
    }
  }
  return tones;
}

} // namespace

/// Stipples are lifted before the surface that hides others, but no farther than half the way to the eye:
/// else those close by would be behind it, and not seen.
TEST(StippleCloseUp, HidingSurface)
{
  StippleScene scene(InkTestStipples::PlaneSurface(4.0, 4, 50));
  scene.AllOff();
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  constexpr double eye = 5.0;
  camera->SetPosition(0.0, 0.0, eye);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetClippingRange(0.1, 10.0);
  // Shares of the stipples that are seen with the surface at such parts of the way from the eye to them.
  const auto seen = [&](double offset, double part)
  {
    vtkNew<vtkPlaneSource> surface;
    surface->SetOrigin(-9.0, -9.0, eye * (1.0 - part));
    surface->SetPoint1(9.0, -9.0, eye * (1.0 - part));
    surface->SetPoint2(-9.0, 9.0, eye * (1.0 - part));
    surface->Update();
    scene.Mapper->SetSurfaceData(surface->GetOutput());
    scene.Mapper->SetOccluderOffset(offset);
    scene.Window->Render();
    vtkNew<vtkFloatArray> marks;
    scene.Mapper->EvaluateMarks(scene.Renderer, scene.Actor, marks);
    double number = 0.0;
    for (vtkIdType i = 0; i < marks->GetNumberOfTuples(); ++i)
    {
      number += marks->GetComponent(i, 1) > 0.0;
    }
    return number / 800.0;
  };
  // A lift of an element's size, 1, and of twenty ways to the eye.
  const struct
  {
    double Offset;
    double Part;
    double Seen;
  } cases[] = { { 1.0, 1.0, 1.0 }, { 1.0, 0.85, 1.0 }, { 1.0, 0.75, 0.0 }, { 100.0, 1.0, 1.0 },
    { 100.0, 0.6, 1.0 }, { 100.0, 0.45, 0.0 } };
  for (const auto& one : cases)
  {
    const double found = seen(one.Offset, one.Part);
    EXPECT_EQ(found, one.Seen) << "stipples lifted by " << one.Offset << " before a surface at " << one.Part
                               << " of the way: seen " << one.Seen << ", found " << found;
  }
}

TEST(StippleCloseUp, RoomIsAboutEven)
{
  // At the size of this sphere's box the room falls to a ninth at most, where the eye is as far from its
  // nearest point as that is from its middle.
  constexpr double mostUneven = 9.0;
  for (const auto& [kind, stipples] : { std::pair("volume", InkTestStipples::SphereVoxels(1.0, 0.1, 8)),
         std::pair("surface", InkTestStipples::SphereSurface(1.0, 800, 8)) })
  {
    StippleScene scene(stipples);
    scene.AllOff();
    scene.Mapper->GrowWithZoomOff();
    scene.Mapper->SetSlantExponent(0.0);
    vtkCamera* camera = scene.Renderer->GetActiveCamera();
    for (const double z : { 3.5, 2.0, 1.5, 1.1, 1.0, 0.9, 0.5, 0.0, -0.5 })
    {
      const std::string where = std::string(kind) + " from " + std::to_string(z);
      camera->SetPosition(0.0, 0.0, z);
      camera->SetFocalPoint(0.0, 0.0, z - 1.0);
      scene.Mapper->ResolutionOn();
      scene.Mapper->SetResolutionExponent(-2.0);
      const std::vector<double> even = FindTones(scene, stipples, 0.01);
      for (const double krc : { 0.0, -1.0 })
      {
        scene.Mapper->SetResolution(krc != 0.0);
        scene.Mapper->SetResolutionExponent(krc);
        const std::vector<double> tones = FindTones(scene, stipples, 0.01);
        EXPECT_TRUE(!tones.empty() && tones == FindTones(scene, stipples, 0.15))
          << where << ", k_rc " << krc << ": the same number of stipples with another clipping range";
        double uneven = 0.0;
        for (std::size_t i = 0; i < tones.size() && i < even.size(); ++i)
        {
          uneven = std::max(uneven, std::max(tones[i] / even[i], even[i] / tones[i]));
        }
        EXPECT_TRUE(uneven > 0.99 && uneven < mostUneven * 1.01)
          << where << ", k_rc " << krc << ": about the even pattern's, found " << uneven << " times as many";
      }
    }
  }
}
