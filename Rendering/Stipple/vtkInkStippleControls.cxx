// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkStippleControls.h"

#include "vtkInkStippleMapper.h"

#include "Tone/Stipple/Sliders.h"

#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <sstream>

vtkStandardNewMacro(vtkInkStippleControls);

namespace
{

/// The sliders compute in single precision, whose numbers nobody wants to read: .65 is .649999976158 in it.
template <class... Format>
double Rounded(float number, Format... format)
{
  std::array<char, 64> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number, format...).ptr;
  double rounded = number;
  std::from_chars(digits.data(), end, rounded);
  return rounded;
}

/// With the fewest digits that tell it from other ones.
double Shortest(float number)
{
  return Rounded(number);
}

/// With as many digits as are exact after some arithmetic.
double Exact(float number)
{
  return Rounded(number, std::chars_format::general, std::numeric_limits<float>::digits10);
}

/// What each slider stands for.
using Part = void (*)(const ink::stipple::Tone&, vtkInkStippleMapper*);

void ApplyGradient(const ink::stipple::Tone& tone, vtkInkStippleMapper* mapper)
{
  mapper->SetBoundaryBase(Exact(tone.boundary.base));
  mapper->SetBoundaryGain(Exact(tone.boundary.gain));
}

void ApplySharpness(const ink::stipple::Tone& tone, vtkInkStippleMapper* mapper)
{
  mapper->SetBoundaryExponent(Exact(tone.boundary.exponent));
  mapper->SetSilhouetteExponent(Exact(tone.silhouette.exponent));
  mapper->SetLightingExponent(Exact(tone.lighting.exponent));
}

void ApplyOrientation(const ink::stipple::Tone& tone, vtkInkStippleMapper* mapper)
{
  mapper->SetSilhouetteGain(Exact(tone.silhouette.gain));
  mapper->SetLightingExponent(Exact(tone.lighting.exponent));
}

void ApplyDistance(const ink::stipple::Tone& tone, vtkInkStippleMapper* mapper)
{
  mapper->SetDistanceExponent(Exact(tone.distance.exponent));
  mapper->SetDistanceSize(Exact(tone.distance.size));
}

void ApplyInterior(const ink::stipple::Tone& tone, vtkInkStippleMapper* mapper)
{
  mapper->SetInteriorExponent(Exact(tone.interior.exponent));
  mapper->SetInteriorSize(Exact(tone.interior.size));
}

void ApplyColor(const ink::stipple::Tone& tone, vtkInkStippleMapper* mapper)
{
  mapper->SetWarmCool(Exact(tone.warmCool.amount));
}

} // namespace

class vtkInkStippleControls::vtkInternals
{
public:
  void Set(vtkInkStippleControls* self, float ink::stipple::Sliders::*slider, double value, Part apply)
  {
    if (std::isnan(value))
    {
      vtkErrorWithObjectMacro(self, "Expected a slider's value from 0 to 1, found " << value << '.');
      return;
    }
    const float limited = static_cast<float>(std::clamp(value, 0.0, 1.0));
    if (this->Sliders.*slider != limited)
    {
      this->Sliders.*slider = limited;
      self->Modified();
    }
    if (this->Mapper)
    {
      apply(this->FindTone(), this->Mapper);
    }
  }

  ink::stipple::Tone FindTone() const
  {
    ink::stipple::Tone tone;
    this->Preset->apply(tone);
    this->Sliders.apply(tone);
    return tone;
  }

  const ink::stipple::Preset* Preset = &ink::stipple::presets().front();
  ink::stipple::Sliders Sliders = this->Preset->sliders;
  vtkSmartPointer<vtkInkStippleMapper> Mapper;
};

vtkInkStippleControls::vtkInkStippleControls()
  : Internals(std::make_unique<vtkInternals>())
{
}

vtkInkStippleControls::~vtkInkStippleControls() = default;

bool vtkInkStippleControls::SetPreset(const char* name)
{
  const ink::stipple::Preset* preset = ink::stipple::findPreset(name ? name : "");
  if (!preset)
  {
    std::ostringstream names;
    for (const ink::stipple::Preset& known : ink::stipple::presets())
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
  return static_cast<int>(ink::stipple::presets().size());
}

const char* vtkInkStippleControls::GetPresetName(int index)
{
  return index >= 0 && index < GetNumberOfPresets() ? ink::stipple::presets()[index].name.data() : nullptr;
}

void vtkInkStippleControls::Reset()
{
  this->Internals->Sliders = this->Internals->Preset->sliders;
  this->Modified();
  if (this->Internals->Mapper)
  {
    this->Apply(this->Internals->Mapper);
  }
}

void vtkInkStippleControls::SetGradient(double gradient)
{
  this->Internals->Set(this, &ink::stipple::Sliders::gradient, gradient, ApplyGradient);
}

double vtkInkStippleControls::GetGradient()
{
  return Shortest(this->Internals->Sliders.gradient);
}

void vtkInkStippleControls::SetSharpness(double sharpness)
{
  this->Internals->Set(this, &ink::stipple::Sliders::sharpness, sharpness, ApplySharpness);
}

double vtkInkStippleControls::GetSharpness()
{
  return Shortest(this->Internals->Sliders.sharpness);
}

void vtkInkStippleControls::SetOrientation(double orientation)
{
  this->Internals->Set(this, &ink::stipple::Sliders::orientation, orientation, ApplyOrientation);
}

double vtkInkStippleControls::GetOrientation()
{
  return Shortest(this->Internals->Sliders.orientation);
}

void vtkInkStippleControls::SetDistance(double distance)
{
  this->Internals->Set(this, &ink::stipple::Sliders::distance, distance, ApplyDistance);
}

double vtkInkStippleControls::GetDistance()
{
  return Shortest(this->Internals->Sliders.distance);
}

void vtkInkStippleControls::SetInterior(double interior)
{
  this->Internals->Set(this, &ink::stipple::Sliders::interior, interior, ApplyInterior);
}

double vtkInkStippleControls::GetInterior()
{
  return Shortest(this->Internals->Sliders.interior);
}

void vtkInkStippleControls::SetColor(double color)
{
  this->Internals->Set(this, &ink::stipple::Sliders::color, color, ApplyColor);
}

double vtkInkStippleControls::GetColor()
{
  return Shortest(this->Internals->Sliders.color);
}

void vtkInkStippleControls::SetMapper(vtkInkStippleMapper* mapper)
{
  if (this->Internals->Mapper != mapper)
  {
    this->Internals->Mapper = mapper;
    this->Modified();
  }
}

vtkInkStippleMapper* vtkInkStippleControls::GetMapper()
{
  return this->Internals->Mapper;
}

void vtkInkStippleControls::Apply(vtkInkStippleMapper* mapper)
{
  const ink::stipple::Tone tone = this->Internals->FindTone();
  for (const Part apply :
    { ApplyGradient, ApplySharpness, ApplyOrientation, ApplyDistance, ApplyInterior, ApplyColor })
  {
    apply(tone, mapper);
  }
  mapper->SetBoundary(tone.boundary.on);
  mapper->SetSilhouette(tone.silhouette.on);
  mapper->SetSilhouetteBase(Exact(tone.silhouette.base));
  mapper->SetResolution(tone.resolution.on);
  mapper->SetResolutionExponent(Exact(tone.resolution.exponent));
  mapper->SetSlantExponent(Exact(tone.resolution.slantExponent));
  mapper->SetLighting(tone.lighting.on);
  mapper->SetLightInk(tone.lighting.lightInk);
  mapper->SetDistance(tone.distance.on);
  mapper->SetInterior(tone.interior.on);
  mapper->SetValueEffect(Exact(tone.valueEffect));
  mapper->SetSizeUnit(
    this->Internals->Preset->sizesInPixels ? vtkInkStippleMapper::PIXELS : vtkInkStippleMapper::THOUSANDTHS);
  mapper->SetPixelsPerStipple(Exact(tone.pixelsPerStipple));
  mapper->SetStippleSize(Exact(tone.diameter));
  mapper->SetFadeBySize(tone.fadeBySize);
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
  os << indent << "Mapper: " << this->Internals->Mapper.Get() << "\n";
}
