// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMInkStippleRepresentationProxy.h"

#include "vtkInkStippleControls.h"
#include "vtkInkStippleMapper.h"

#include "vtkObjectFactory.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSessionProxyManager.h"

#include <string>

vtkStandardNewMacro(vtkSMInkStippleRepresentationProxy);

struct vtkSMInkStippleSlider
{
  const char* Property;
  double (vtkInkStippleControls::*Get)();
  void (vtkInkStippleControls::*Set)(double);
};

namespace
{

constexpr const char* PresetProperty = "StipplePreset";
constexpr const char* InkProperty = "StippleInkColor";

using Controls = vtkInkStippleControls;

constexpr vtkSMInkStippleSlider Sliders[] = {
  { "StippleGradient", &Controls::GetGradient, &Controls::SetGradient },
  { "StippleSharpness", &Controls::GetSharpness, &Controls::SetSharpness },
  { "StippleOrientation", &Controls::GetOrientation, &Controls::SetOrientation },
  { "StippleDistance", &Controls::GetDistance, &Controls::SetDistance },
  { "StippleInterior", &Controls::GetInterior, &Controls::SetInterior },
  { "StippleColor", &Controls::GetColor, &Controls::SetColor },
};

/// What vtkInkStippleControls::Apply sets.
struct Parameter
{
  const char* Property;
  double (*Get)(vtkInkStippleMapper*);
};

constexpr Parameter Parameters[] = {
  { "BoundaryEnhancement", [](vtkInkStippleMapper* m) -> double { return m->GetBoundary(); } },
  { "Kgc", [](vtkInkStippleMapper* m) -> double { return m->GetKgc(); } },
  { "Kgs", [](vtkInkStippleMapper* m) -> double { return m->GetKgs(); } },
  { "Kge", [](vtkInkStippleMapper* m) -> double { return m->GetKge(); } },
  { "SilhouetteEnhancement", [](vtkInkStippleMapper* m) -> double { return m->GetSilhouette(); } },
  { "Ksc", [](vtkInkStippleMapper* m) -> double { return m->GetKsc(); } },
  { "Kss", [](vtkInkStippleMapper* m) -> double { return m->GetKss(); } },
  { "Kse", [](vtkInkStippleMapper* m) -> double { return m->GetKse(); } },
  { "ResolutionEnhancement", [](vtkInkStippleMapper* m) -> double { return m->GetResolution(); } },
  { "Krc", [](vtkInkStippleMapper* m) -> double { return m->GetKrc(); } },
  { "Knz", [](vtkInkStippleMapper* m) -> double { return m->GetKnz(); } },
  { "LightingEnhancement", [](vtkInkStippleMapper* m) -> double { return m->GetLighting(); } },
  { "Kle", [](vtkInkStippleMapper* m) -> double { return m->GetKle(); } },
  { "LightInk", [](vtkInkStippleMapper* m) -> double { return m->GetLightInk(); } },
  { "DistanceEnhancement", [](vtkInkStippleMapper* m) -> double { return m->GetDistance(); } },
  { "Kde", [](vtkInkStippleMapper* m) -> double { return m->GetKde(); } },
  { "DistanceSize", [](vtkInkStippleMapper* m) -> double { return m->GetDistanceSize(); } },
  { "InteriorEnhancement", [](vtkInkStippleMapper* m) -> double { return m->GetInterior(); } },
  { "Kie", [](vtkInkStippleMapper* m) -> double { return m->GetKie(); } },
  { "InteriorSize", [](vtkInkStippleMapper* m) -> double { return m->GetInteriorSize(); } },
  { "ValueEffect", [](vtkInkStippleMapper* m) -> double { return m->GetValueEffect(); } },
  { "AppearBySize", [](vtkInkStippleMapper* m) -> double { return m->GetAppearBySize(); } },
  { "WarmCool", [](vtkInkStippleMapper* m) -> double { return m->GetWarmCool(); } },
  { "PixelsPerStipple", [](vtkInkStippleMapper* m) -> double { return m->GetPixelsPerStipple(); } },
  { "StippleSize", [](vtkInkStippleMapper* m) -> double { return m->GetStippleSize(); } },
};

} // namespace

vtkSMInkStippleRepresentationProxy::vtkSMInkStippleRepresentationProxy() = default;

vtkSMInkStippleRepresentationProxy::~vtkSMInkStippleRepresentationProxy() = default;

bool vtkSMInkStippleRepresentationProxy::ReadsState()
{
  vtkSMSessionProxyManager* manager = this->GetSessionProxyManager();
  return manager && manager->GetInLoadXMLState();
}

int vtkSMInkStippleRepresentationProxy::ReadXMLAttributes(
  vtkSMSessionProxyManager* manager, vtkPVXMLElement* element)
{
  this->Following = true;
  const int result = this->Superclass::ReadXMLAttributes(manager, element);
  this->Following = false;
  return result;
}

void vtkSMInkStippleRepresentationProxy::SetPropertyModifiedFlag(const char* name, int flag)
{
  this->Superclass::SetPropertyModifiedFlag(name, flag);
  if (!flag || !name || this->Following || this->ReadsState())
  {
    return;
  }
  this->Following = true;
  if (std::string(name) == PresetProperty)
  {
    this->FollowPreset();
  }
  for (const vtkSMInkStippleSlider& slider : Sliders)
  {
    if (std::string(name) == slider.Property)
    {
      this->FollowSlider(slider);
    }
  }
  this->Following = false;
}

void vtkSMInkStippleRepresentationProxy::FollowPreset()
{
  this->ReadControls();
  this->Controls->Reset();
  for (const vtkSMInkStippleSlider& slider : Sliders)
  {
    vtkSMPropertyHelper(this, slider.Property).Set((this->Controls.Get()->*slider.Get)());
  }
  vtkNew<vtkInkStippleMapper> mapper;
  this->Controls->Apply(mapper);
  vtkSMPropertyHelper(this, InkProperty).Set(mapper->GetInkColor(), 3);
  for (const Parameter& parameter : Parameters)
  {
    vtkSMPropertyHelper(this, parameter.Property).Set(parameter.Get(mapper));
  }
}

void vtkSMInkStippleRepresentationProxy::FollowSlider(const vtkSMInkStippleSlider& slider)
{
  this->ReadControls();
  const auto apply = [&](double position, vtkInkStippleMapper* mapper)
  {
    (this->Controls.Get()->*slider.Set)(position);
    this->Controls->Apply(mapper);
  };
  const double position = (this->Controls.Get()->*slider.Get)();
  vtkNew<vtkInkStippleMapper> low;
  vtkNew<vtkInkStippleMapper> high;
  vtkNew<vtkInkStippleMapper> here;
  apply(0.0, low);
  apply(1.0, high);
  apply(position, here);
  // Only what the slider stands for: what was chosen for the others stays.
  for (const Parameter& parameter : Parameters)
  {
    if (parameter.Get(low) != parameter.Get(high))
    {
      vtkSMPropertyHelper(this, parameter.Property).Set(parameter.Get(here));
    }
  }
}

void vtkSMInkStippleRepresentationProxy::ReadControls()
{
  this->Controls->SetPreset(Controls::GetPresetName(vtkSMPropertyHelper(this, PresetProperty).GetAsInt()));
  for (const vtkSMInkStippleSlider& slider : Sliders)
  {
    (this->Controls.Get()->*slider.Set)(vtkSMPropertyHelper(this, slider.Property).GetAsDouble());
  }
}
