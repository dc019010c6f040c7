// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMInkStippleRepresentationProxy.h"

#include "vtkInkStippleControls.h"
#include "vtkInkStippleMapper.h"
#include "vtkSMInkDoubleVectorProperty.h"
#include "vtkSMInkIsoValueInitializationHelper.h"
#include "vtkSMInkRestoring.h"

#include "vtkDataSetAttributes.h"
#include "vtkObjectFactory.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"

#include <algorithm>
#include <string>
#include <vector>

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
constexpr const char* PaperProperty = "StipplePaperColor";

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

/// What starts with a value that suits the input when it is switched on.
struct Start
{
  const char* Switch;
  const char* Property;
  void (*Set)(vtkSMProxy*, const char* property);
};

constexpr const char* ArrayProperty = "StippleBy";

constexpr Start Starts[] = {
  { "UseScalarWindow", "ScalarWindow",
    [](vtkSMProxy* proxy, const char* property) { proxy->GetProperty(property)->ResetToDomainDefaults(); } },
  { "IsoSurfaceHides", "StippleIsoValue",
    [](vtkSMProxy* proxy, const char* property)
    {
      if (const auto value = vtkSMInkIsoValueInitializationHelper::Suggest(proxy, ArrayProperty))
      {
        vtkSMPropertyHelper(proxy, property).Set(*value);
      }
    } },
};

bool IsOn(vtkSMProxy* proxy, const Start& start)
{
  return vtkSMPropertyHelper(proxy, start.Switch).GetAsInt() != 0;
}

/// Ranges are those of an array with a name: that of the active scalars, if none is chosen.
void ChooseArray(vtkSMProxy* proxy)
{
  const vtkSMPropertyHelper inputs(proxy, "Input");
  auto input = vtkSMSourceProxy::SafeDownCast(inputs.GetAsProxy());
  if (!input || !proxy->GetProperty(ArrayProperty)->IsValueDefault())
  {
    return;
  }
  input->UpdatePipeline();
  const vtkPVArrayInformation* scalars = input->GetDataInformation(inputs.GetOutputPort())
                                           ->GetPointDataInformation()
                                           ->GetAttributeInformation(vtkDataSetAttributes::SCALARS);
  if (scalars && scalars->GetName())
  {
    constexpr unsigned int name = 4;
    vtkSMPropertyHelper(proxy, ArrayProperty).Set(name, scalars->GetName());
  }
}

bool IsUnset(vtkSMProxy* proxy, const Start& start)
{
  return vtkSMInkDoubleVectorProperty::SafeDownCast(proxy->GetProperty(start.Property))->IsUnset();
}

} // namespace

vtkSMInkStippleRepresentationProxy::vtkSMInkStippleRepresentationProxy() = default;

vtkSMInkStippleRepresentationProxy::~vtkSMInkStippleRepresentationProxy() = default;

int vtkSMInkStippleRepresentationProxy::ReadXMLAttributes(
  vtkSMSessionProxyManager* manager, vtkPVXMLElement* element)
{
  // There are not all properties yet.
  const vtkSMInkRestoring restoring(this);
  return this->Superclass::ReadXMLAttributes(manager, element);
}

void vtkSMInkStippleRepresentationProxy::SetPropertyModifiedFlag(const char* name, int flag)
{
  this->Superclass::SetPropertyModifiedFlag(name, flag);
  // Before there is an input the person's own defaults are read.
  if (!flag || !name || this->Restoring > 0 || vtkSMPropertyHelper(this, "Input").GetNumberOfElements() == 0)
  {
    return;
  }
  const vtkSMInkRestoring restoring(this);
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
  for (const Start& start : Starts)
  {
    if (std::string(name) == start.Switch && IsOn(this, start) && IsUnset(this, start))
    {
      ChooseArray(this);
      start.Set(this, start.Property);
    }
  }
}

bool vtkSMInkStippleRepresentationProxy::IsAsFollowed(vtkSMProperty* property)
{
  auto proxy = vtkSMInkStippleRepresentationProxy::SafeDownCast(property->GetParent());
  return !proxy || !property->GetXMLName() || proxy->IsAsFollowed(std::string(property->GetXMLName()));
}

bool vtkSMInkStippleRepresentationProxy::IsAsFollowed(const std::string& name)
{
  const auto is = [&](const auto& known) { return name == known.Property; };
  const auto slider = std::find_if(std::begin(Sliders), std::end(Sliders), is);
  const double number = vtkSMPropertyHelper(this, name.c_str()).GetAsDouble();
  this->ReadControls();
  if (slider != std::end(Sliders))
  {
    this->Controls->Reset();
    return number == (this->Controls.Get()->*slider->Get)();
  }
  vtkNew<vtkInkStippleMapper> mapper;
  this->Controls->Apply(mapper);
  if (name == InkProperty || name == PaperProperty)
  {
    double color[3];
    this->Controls->GetPaperColor(color);
    const double* expected = name == PaperProperty ? color : mapper->GetInkColor();
    const std::vector<double> found = vtkSMPropertyHelper(this, name.c_str()).GetArray<double>();
    return std::equal(found.begin(), found.end(), expected);
  }
  const auto start = std::find_if(std::begin(Starts), std::end(Starts), is);
  if (start != std::end(Starts))
  {
    return !IsOn(this, *start);
  }
  const auto parameter = std::find_if(std::begin(Parameters), std::end(Parameters), is);
  return parameter == std::end(Parameters) || number == parameter->Get(mapper);
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
  double paper[3];
  this->Controls->GetPaperColor(paper);
  vtkSMPropertyHelper(this, PaperProperty).Set(paper, 3);
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
