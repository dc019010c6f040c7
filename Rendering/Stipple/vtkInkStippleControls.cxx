// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkStippleControls.h"

#include "vtkInkStippleMapper.h"

#include "Tone/StippleSliders.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>
#include <sstream>

vtkStandardNewMacro(vtkInkStippleControls);

class vtkInkStippleControls::vtkInternals
{
public:
  void Set(vtkInkStippleControls* self, float ink::StippleSliders::*slider, double value)
  {
    if (std::isnan(value))
    {
      vtkErrorWithObjectMacro(self, "Expected a slider's place from 0 to 1, found " << value << '.');
      return;
    }
    const float limited = static_cast<float>(std::clamp(value, 0.0, 1.0));
    if (this->Sliders.*slider != limited)
    {
      this->Sliders.*slider = limited;
      self->Modified();
    }
  }

  const ink::StipplePreset* Preset = &ink::stipplePresets().front();
  ink::StippleSliders Sliders = this->Preset->sliders;
};

vtkInkStippleControls::vtkInkStippleControls()
  : Internals(std::make_unique<vtkInternals>())
{
}

vtkInkStippleControls::~vtkInkStippleControls() = default;

bool vtkInkStippleControls::SetPreset(const char* name)
{
  const ink::StipplePreset* preset = ink::findStipplePreset(name ? name : "");
  if (!preset)
  {
    std::ostringstream names;
    for (const ink::StipplePreset& known : ink::stipplePresets())
    {
      names << (names.tellp() > 0 ? ", " : "") << known.name;
    }
    vtkErrorMacro("No preset \"" << (name ? name : "") << "\"; expected one of " << names.str() << ".");
    return false;
  }
  this->Internals->Preset = preset;
  this->Reset();
  return true;
}

const char* vtkInkStippleControls::GetPreset()
{
  return this->Internals->Preset->name.data();
}

int vtkInkStippleControls::GetNumberOfPresets()
{
  return static_cast<int>(ink::stipplePresets().size());
}

const char* vtkInkStippleControls::GetPresetName(int index)
{
  return index >= 0 && index < GetNumberOfPresets() ? ink::stipplePresets()[index].name.data() : nullptr;
}

void vtkInkStippleControls::Reset()
{
  this->Internals->Sliders = this->Internals->Preset->sliders;
  this->Modified();
}

void vtkInkStippleControls::SetGradient(double gradient)
{
  this->Internals->Set(this, &ink::StippleSliders::gradient, gradient);
}

double vtkInkStippleControls::GetGradient()
{
  return this->Internals->Sliders.gradient;
}

void vtkInkStippleControls::SetSharpness(double sharpness)
{
  this->Internals->Set(this, &ink::StippleSliders::sharpness, sharpness);
}

double vtkInkStippleControls::GetSharpness()
{
  return this->Internals->Sliders.sharpness;
}

void vtkInkStippleControls::SetOrientation(double orientation)
{
  this->Internals->Set(this, &ink::StippleSliders::orientation, orientation);
}

double vtkInkStippleControls::GetOrientation()
{
  return this->Internals->Sliders.orientation;
}

void vtkInkStippleControls::SetDistance(double distance)
{
  this->Internals->Set(this, &ink::StippleSliders::distance, distance);
}

double vtkInkStippleControls::GetDistance()
{
  return this->Internals->Sliders.distance;
}

void vtkInkStippleControls::SetInterior(double interior)
{
  this->Internals->Set(this, &ink::StippleSliders::interior, interior);
}

double vtkInkStippleControls::GetInterior()
{
  return this->Internals->Sliders.interior;
}

void vtkInkStippleControls::SetColor(double color)
{
  this->Internals->Set(this, &ink::StippleSliders::color, color);
}

double vtkInkStippleControls::GetColor()
{
  return this->Internals->Sliders.color;
}

void vtkInkStippleControls::Apply(vtkInkStippleMapper* mapper)
{
  ink::StippleTone tone;
  this->Internals->Preset->apply(tone);
  this->Internals->Sliders.apply(tone);
  mapper->SetBoundary(tone.boundary.on);
  mapper->SetKgc(tone.boundary.kgc);
  mapper->SetKgs(tone.boundary.kgs);
  mapper->SetKge(tone.boundary.kge);
  mapper->SetSilhouette(tone.silhouette.on);
  mapper->SetKsc(tone.silhouette.ksc);
  mapper->SetKss(tone.silhouette.kss);
  mapper->SetKse(tone.silhouette.kse);
  mapper->SetResolution(tone.resolution.on);
  mapper->SetKrc(tone.resolution.krc);
  mapper->SetKnz(tone.resolution.knz);
  mapper->SetLighting(tone.lighting.on);
  mapper->SetKle(tone.lighting.kle);
  mapper->SetLightInk(tone.lighting.lightInk);
  mapper->SetDistance(tone.distance.on);
  mapper->SetKde(tone.distance.kde);
  mapper->SetDistanceSize(tone.distance.size);
  mapper->SetInterior(tone.interior.on);
  mapper->SetKie(tone.interior.kie);
  mapper->SetInteriorSize(tone.interior.size);
  mapper->SetWarmCool(tone.warmCool.amount);
  mapper->SetValueEffect(tone.valueEffect);
  mapper->SetPixelsPerStipple(tone.pixelsPerStipple);
  mapper->SetStippleSize(tone.diameter);
  mapper->SetAppearBySize(tone.appearBySize);
  const double ink = tone.lighting.lightInk ? 1.0 : 0.0;
  mapper->SetInkColor(ink, ink, ink);
}

void vtkInkStippleControls::GetPaperColor(double rgb[3])
{
  std::fill_n(rgb, 3, this->Internals->Preset->lightInk ? 0.0 : 1.0);
}

void vtkInkStippleControls::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Preset: " << this->GetPreset() << "\n";
  os << indent << "Gradient: " << this->GetGradient() << "\n";
  os << indent << "Sharpness: " << this->GetSharpness() << "\n";
  os << indent << "Orientation: " << this->GetOrientation() << "\n";
  os << indent << "Distance: " << this->GetDistance() << "\n";
  os << indent << "Interior: " << this->GetInterior() << "\n";
  os << indent << "Color: " << this->GetColor() << "\n";
}
