// SPDX-License-Identifier: BSD-3-Clause
// The eye just before the object and in it: the room for stipples is each element's own, wherever the
// clipping planes are.
#include "InkTestChecks.h"
#include "InkTestStipples.h"
#include "StippleScene.h"

#include "vtkFloatArray.h"

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
  scene.Mapper->FindMarks(scene.Renderer, scene.Actor, marks);
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

int TestStippleCloseUp(int, char*[])
{
  InkTestChecks check;
  // At the size of this sphere's box the room falls to a ninth at most, where the eye is as far from its
  // nearest point as that is from its middle.
  constexpr double mostUneven = 9.0;
  for (const auto& [kind, stipples] : { std::pair("volume", InkTestStipples::SphereVoxels(1.0, 0.1, 8)),
         std::pair("surface", InkTestStipples::SphereSurface(1.0, 800, 8)) })
  {
    StippleScene scene(stipples);
    scene.AllOff();
    scene.Mapper->GrowingOff();
    scene.Mapper->SetKnz(0.0);
    vtkCamera* camera = scene.Renderer->GetActiveCamera();
    for (const double place : { 3.5, 2.0, 1.5, 1.1, 1.0, 0.9, 0.5, 0.0, -0.5 })
    {
      const std::string where = std::string(kind) + " from " + std::to_string(place);
      camera->SetPosition(0.0, 0.0, place);
      camera->SetFocalPoint(0.0, 0.0, place - 1.0);
      scene.Mapper->ResolutionOn();
      scene.Mapper->SetKrc(-2.0);
      const std::vector<double> even = FindTones(scene, stipples, 0.01);
      for (const double krc : { 0.0, -1.0 })
      {
        scene.Mapper->SetResolution(krc != 0.0);
        scene.Mapper->SetKrc(krc);
        const std::vector<double> tones = FindTones(scene, stipples, 0.01);
        check(!tones.empty() && tones == FindTones(scene, stipples, 0.15), where, ", k_rc ", krc,
          ": the same number of stipples with another clipping range");
        double uneven = 0.0;
        for (std::size_t i = 0; i < tones.size() && i < even.size(); ++i)
        {
          uneven = std::max(uneven, std::max(tones[i] / even[i], even[i] / tones[i]));
        }
        check(uneven > 0.99 && uneven < mostUneven * 1.01, where, ", k_rc ", krc,
          ": about the even pattern's, found ", uneven, " times as many");
      }
    }
  }
  return check.Result();
}
