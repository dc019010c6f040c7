// SPDX-License-Identifier: BSD-3-Clause
// The shader and the reference in Common/Tone, on the same stipples: number, opacity, diameter and color.
#include "InkTestStipples.h"
#include "StippleScene.h"

#include "Core/Hash.h"
#include "Tone/Stipple/ProjectedSize.h"
#include "Tone/Stipple/Tone.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <glm/glm.hpp>
#include <random>
#include <string>

namespace
{

glm::dvec4 Times(vtkMatrix4x4* matrix, const glm::dvec4& v)
{
  glm::dvec4 result;
  matrix->MultiplyPoint(&v.x, &result.x);
  return result;
}

/// The tone's parameters, from the mapper's.
ink::stipple::Tone Expected(vtkInkStippleMapper* m, bool surface)
{
  ink::stipple::Tone tone;
  tone.surface = surface;
  tone.boundary = { m->GetBoundary(), float(m->GetBoundaryBase()), float(m->GetBoundaryGain()),
    float(m->GetBoundaryExponent()) };
  tone.silhouette = { m->GetSilhouette(), float(m->GetSilhouetteBase()), float(m->GetSilhouetteGain()),
    float(m->GetSilhouetteExponent()) };
  tone.resolution = { m->GetResolution(), float(m->GetResolutionExponent()), float(m->GetSlantExponent()) };
  tone.lighting = { m->GetLighting(), float(m->GetLightingExponent()),
    float(std::cos(vtkMath::RadiansFromDegrees(m->GetFacingAngle()))), m->GetLightInk() };
  tone.distance = { m->GetDistance(), float(m->GetDistanceExponent()), float(m->GetDistanceSize()) };
  tone.interior = { m->GetInterior(), float(m->GetInteriorExponent()), float(m->GetInteriorSize()) };
  tone.smallElements.way = static_cast<ink::stipple::SmallElements::Way>(m->GetSmallElements());
  tone.smallElements.minimumCoverage = float(m->GetMinimumCoverage());
  tone.smallElements.fade = float(m->GetFade());
  const auto hls = [](const double* c) { return ink::hlsFromRgb({ c[0], c[1], c[2] }); };
  tone.warmCool = { hls(m->GetWarmColor()), hls(m->GetCoolColor()), float(m->GetToneWeight()),
    float(m->GetDistanceWeight()), float(m->GetWarmCool()) };
  tone.valueEffect = float(m->GetValueEffect());
  tone.pixelsPerStipple = float(m->GetPixelsPerStipple());
  tone.diameter = float(m->GetStippleSize());
  tone.growWithZoom = m->GetGrowWithZoom();
  tone.fadeBySize = m->GetFadeBySize();
  return tone;
}

/// @param light the scene's only one, looking at the origin
void Compare(StippleScene& scene, vtkPolyData* stipples, vtkLight* light, const std::string& what)
{
  scene.Window->Render();
  vtkNew<vtkFloatArray> found;
  ASSERT_TRUE(scene.Mapper->EvaluateMarks(scene.Renderer, scene.Actor, found)) << "marks of " << what;
  ASSERT_EQ(found->GetNumberOfTuples(), stipples->GetNumberOfPoints()) << "a mark for each point of " << what;
  const auto field = [&](const char* name) { return stipples->GetFieldData()->GetArray(name)->GetTuple1(0); };
  const bool surface = field("ElementKind") == 1.0;
  const ink::stipple::Tone tone = Expected(scene.Mapper, surface);

  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  vtkMatrix4x4* toView = camera->GetModelViewTransformMatrix();
  double bounds[6];
  stipples->GetBounds(bounds);
  double nearest = 1e300;
  double farthest = -1e300;
  for (int corner = 0; corner < 8; ++corner)
  {
    const double distance = -Times(
      toView, { bounds[corner & 1], bounds[2 + (corner >> 1 & 1)], bounds[4 + (corner >> 2 & 1)], 1.0 })
                               .z;
    nearest = std::min(nearest, distance);
    farthest = std::max(farthest, distance);
  }
  ink::stipple::Tone::View view{};
  view.listed = float(field("StipplesPerElement"));
  view.parallel = camera->GetParallelProjection();
  view.middle = float(0.5 * (nearest + farthest));
  view.halfRange = float(0.5 * (farthest - nearest));
  view.nearest = ink::stipple::Resolution::nearestDistance(view.middle, view.halfRange);
  const int height = scene.Renderer->GetSize()[1];
  const double pixel = view.parallel
    ? 2.0 * camera->GetParallelScale() / height
    : 2.0 * std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle())) / height;
  const auto maximumAt = [&](double distance)
  {
    return ink::stipple::maximumStipples(
      float(field("ElementSize")), float(pixel * (view.parallel ? 1.0 : distance)), tone.pixelsPerStipple);
  };
  view.maximumStipples = maximumAt(view.nearest);
  view.smallness = tone.smallElements.weight(maximumAt(std::max(view.middle, view.halfRange)));
  const double* from = light->GetPosition();
  const glm::dvec3 source(from[0], from[1], from[2]);
  const glm::vec4 towards(Times(toView, glm::dvec4(glm::normalize(source), 0.0)));
  ink::Light lights[1] = { { towards, 1.0f } };
  if (light->GetPositional())
  {
    lights[0] = { glm::vec4(Times(toView, glm::dvec4(source, 1.0))), 1.0f, -glm::vec3(towards),
      light->GetConeAngle() > 90.0 ? -1.0f
                                   : float(std::cos(vtkMath::RadiansFromDegrees(light->GetConeAngle()))),
      float(light->GetExponent()) };
    const double* attenuation = light->GetAttenuationValues();
    lights[0].attenuation = { attenuation[0], attenuation[1], attenuation[2] };
  }

  const auto array = [&](const char* name) { return stipples->GetCellData()->GetArray(name); };
  double worst[4] = {};
  int visible = 0;
  int partial = 0;
  vtkIdType point = 0;
  for (vtkIdType cell = 0; cell < stipples->GetNumberOfCells(); ++cell)
  {
    const vtkIdType length = stipples->GetVerts()->GetCellSize(cell);
    double position[3];
    stipples->GetPoint(point, position);
    const auto bits = [&](int axis) { return std::bit_cast<std::uint64_t>(position[axis] + 0.0); };
    const float random = ink::unitFloat(ink::hash(ink::hash(0x5717b1e, bits(0), bits(1)), bits(2)));
    for (int rank = 0; rank < length; ++rank, ++point)
    {
      double p[3];
      double n[3];
      stipples->GetPoint(point, p);
      array("Normals")->GetTuple(cell, n);
      const ink::stipple::Tone::Element element{ glm::vec3(Times(toView, { p[0], p[1], p[2], 1.0 })),
        glm::vec3(Times(toView, { n[0], n[1], n[2], 0.0 })),
        surface ? 1.0f : float(array("Value")->GetTuple1(cell)),
        surface ? 1.0f : float(array("GradientMagnitude")->GetTuple1(cell)), float(length), random,
        glm::vec3(0.1f, 0.2f, 0.3f) };
      const auto mark = tone.mark(view, lights, element, rank);
      const double* shader = found->GetTuple(point);
      visible += mark.opacity > 0.0f;
      partial += mark.opacity > 0.0f && mark.opacity < 1.0f;
      worst[0] = std::max(worst[0], std::abs(shader[0] - mark.tone) / std::max(1.0f, mark.tone));
      // With a sharp threshold, rounding may decide. There, one side's opacity is as good as the other's.
      const bool threshold = mark.tone > 0.0f &&
        tone.mark(view, lights, element, rank).opacity != shader[1] && tone.smallElements.fade < 1.0f &&
        std::abs(mark.tone +
          (tone.smallElements.way == ink::stipple::SmallElements::Way::probability
              ? view.smallness * (element.random - 0.5f)
              : 0.0f) -
          float(rank) - 0.5f) < 1e-3f;
      if (!threshold)
      {
        worst[1] = std::max(worst[1], std::abs(shader[1] - mark.opacity));
        worst[2] = std::max(worst[2],
          tone.fadeBySize && mark.opacity == 0.0f ? 0.0
                                                  : std::abs(shader[2] - mark.diameter) / mark.diameter);
      }
      for (int i = 0; i < 3; ++i)
      {
        worst[3] = std::max<double>(worst[3], std::abs(shader[3 + i] - mark.color[i]));
      }
    }
  }
  EXPECT_GT(visible, 50) << "stipples to see of " << what << ": " << visible;
  const char* parts[4] = { "T", "opacity", "diameter", "color" };
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_LT(worst[i], (i == 2 ? 5e-3 : 1e-3))
      << parts[i] << " of " << what << " within " << worst[i] << ", of " << visible << " stipples ("
      << partial << " in part)";
  }
}

} // namespace

TEST(StippleShader, IsTheFormulas)
{
  auto voxels = InkTestStipples::SphereVoxels(1.0, 0.12, 24);
  auto surface = InkTestStipples::SphereSurface(1.0, 600, 24);

  vtkLight* light = nullptr;
  using Change = std::function<void(StippleScene&)>;
  const auto off = [](StippleScene& s) { s.AllOff(); };
  const struct
  {
    const char* Name;
    Change Make;
  } changes[] = {
    { "defaults", [](StippleScene&) {} },
    { "no enhancement", off },
    { "boundary",
      [&](StippleScene& s)
      {
        off(s);
        s.Mapper->BoundaryOn();
        s.Mapper->SetValueEffect(0.4);
        s.Mapper->SetBoundaryExponent(1.7);
      } },
    { "silhouette",
      [&](StippleScene& s)
      {
        off(s);
        s.Mapper->SilhouetteOn();
        s.Mapper->SetSilhouetteExponent(0.7);
      } },
    { "resolution",
      [&](StippleScene& s)
      {
        off(s);
        s.Mapper->ResolutionOn();
        s.Mapper->SetResolutionExponent(-1.5);
        s.Mapper->SetSlantExponent(0.6);
      } },
    { "lighting",
      [&](StippleScene& s)
      {
        off(s);
        s.Mapper->LightingOn();
        s.Mapper->SetLightingExponent(0.6);
      } },
    { "a lamp",
      [&](StippleScene&)
      {
        light->PositionalOn();
        light->SetConeAngle(180.0);
        light->SetAttenuationValues(0.5, 0.2, 0.05);
      } },
    { "a spotlight",
      [&](StippleScene& s)
      {
        light->PositionalOn();
        light->SetConeAngle(14.0);
        light->SetExponent(20.0);
        s.Mapper->SetLightingExponent(0.5);
      } },
    { "light ink and a facing angle",
      [&](StippleScene& s)
      {
        off(s);
        s.Mapper->LightingOn();
        s.Mapper->LightInkOn();
        s.Mapper->SetFacingAngle(50.0);
      } },
    { "distance",
      [&](StippleScene& s)
      {
        off(s);
        s.Mapper->DistanceOn();
        s.Mapper->SetDistanceExponent(0.5);
      } },
    { "interior",
      [&](StippleScene& s)
      {
        off(s);
        s.Mapper->InteriorOn();
        s.Mapper->SetInteriorExponent(2.0);
      } },
    { "probability", [](StippleScene& s) { s.Mapper->SetSmallElements(vtkInkStippleMapper::PROBABILITY); } },
    { "little fade",
      [](StippleScene& s)
      {
        s.Mapper->SetFade(0.3);
        s.Mapper->SetPixelsPerStipple(0.5);
      } },
    { "stipples that appear by size", [](StippleScene& s) { s.Mapper->FadeBySizeOn(); } },
    { "warm and cool",
      [](StippleScene& s)
      {
        s.Mapper->SetWarmCool(0.7);
        s.Mapper->SetDistanceWeight(0.4);
      } },
    { "a parallel projection",
      [](StippleScene& s) { s.Renderer->GetActiveCamera()->ParallelProjectionOn(); } },
    { "a close view",
      [](StippleScene& s)
      {
        s.Renderer->GetActiveCamera()->Dolly(2.5);
        s.Renderer->ResetCameraClippingRange();
      } },
    { "a view from just before it",
      [&](StippleScene& s)
      {
        off(s);
        s.Mapper->GrowWithZoomOff();
        s.Renderer->GetActiveCamera()->SetPosition(0.2, 0.1, 1.3);
        s.Renderer->GetActiveCamera()->SetClippingRange(0.01, 3.0);
      } },
    { "a far view",
      [](StippleScene& s)
      {
        s.Renderer->GetActiveCamera()->Dolly(0.2);
        s.Renderer->ResetCameraClippingRange();
      } },
  };
  for (const auto& [data, kind] : { std::pair{ voxels, "a volume" }, std::pair{ surface, "a surface" } })
  {
    for (const auto& [name, change] : changes)
    {
      StippleScene scene(data);
      scene.Mapper->SetInkColor(0.1, 0.2, 0.3);
      scene.Renderer->GetActiveCamera()->Azimuth(25.0);
      scene.Renderer->GetActiveCamera()->Elevation(15.0);
      vtkNew<vtkLight> only;
      light = only;
      light->SetLightTypeToSceneLight();
      light->SetPosition(1.0, 2.0, 1.5);
      light->SetFocalPoint(0.0, 0.0, 0.0);
      scene.Renderer->AddLight(light);
      scene.Renderer->ResetCameraClippingRange();
      change(scene);
      Compare(scene, data, light, std::string(name) + " on " + kind);
    }
  }
}
