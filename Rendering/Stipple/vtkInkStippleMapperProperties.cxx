// SPDX-License-Identifier: BSD-3-Clause
// Parameters by name, copied and printed.
#include "vtkInkStippleMapper.h"

#include "vtkAlgorithmOutput.h"

const char* vtkInkStippleMapper::GetSmallElementsAsString()
{
  return this->SmallElements == PROBABILITY ? "Probability" : "Intensity";
}

const char* vtkInkStippleMapper::GetSizeUnitAsString()
{
  return this->SizeUnit == PIXELS ? "Pixels" : "Thousandths";
}

const char* vtkInkStippleMapper::GetPositionPrecisionAsString()
{
  return this->PositionPrecision == QUANTIZED ? "Quantized" : "Float";
}

void vtkInkStippleMapper::ShallowCopy(vtkAbstractMapper* mapper)
{
  if (auto* from = vtkInkStippleMapper::SafeDownCast(mapper))
  {
    this->SetSurfaceConnection(
      from->GetNumberOfInputConnections(1) > 0 ? from->GetInputConnection(1, 0) : nullptr);
    this->SetBoundary(from->GetBoundary());
    this->SetBoundaryBase(from->GetBoundaryBase());
    this->SetBoundaryGain(from->GetBoundaryGain());
    this->SetBoundaryExponent(from->GetBoundaryExponent());
    this->SetSilhouette(from->GetSilhouette());
    this->SetSilhouetteBase(from->GetSilhouetteBase());
    this->SetSilhouetteGain(from->GetSilhouetteGain());
    this->SetSilhouetteExponent(from->GetSilhouetteExponent());
    this->SetResolution(from->GetResolution());
    this->SetResolutionExponent(from->GetResolutionExponent());
    this->SetSlantExponent(from->GetSlantExponent());
    this->SetLighting(from->GetLighting());
    this->SetLightingExponent(from->GetLightingExponent());
    this->SetFacingAngle(from->GetFacingAngle());
    this->SetHeadlight(from->GetHeadlight());
    this->SetLightInk(from->GetLightInk());
    this->SetDistance(from->GetDistance());
    this->SetDistanceExponent(from->GetDistanceExponent());
    this->SetDistanceSize(from->GetDistanceSize());
    this->SetInterior(from->GetInterior());
    this->SetInteriorExponent(from->GetInteriorExponent());
    this->SetInteriorSize(from->GetInteriorSize());
    this->SetValueEffect(from->GetValueEffect());
    this->SetSizeUnit(from->GetSizeUnit());
    this->SetPixelsPerStipple(from->GetPixelsPerStipple());
    this->SetStippleSize(from->GetStippleSize());
    this->SetGrowWithZoom(from->GetGrowWithZoom());
    this->SetSmallElements(from->GetSmallElements());
    this->SetMinimumCoverage(from->GetMinimumCoverage());
    this->SetFade(from->GetFade());
    this->SetFadeBySize(from->GetFadeBySize());
    this->SetWarmCool(from->GetWarmCool());
    this->SetToneWeight(from->GetToneWeight());
    this->SetDistanceWeight(from->GetDistanceWeight());
    this->SetWarmColor(from->GetWarmColor());
    this->SetCoolColor(from->GetCoolColor());
    this->SetInkColor(from->GetInkColor());
    this->SetOccluderOffset(from->GetOccluderOffset());
    this->SetSurfaceFromInput(from->GetSurfaceFromInput());
    this->SetPositionPrecision(from->GetPositionPrecision());
  }
  this->Superclass::ShallowCopy(mapper);
}

void vtkInkStippleMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Boundary: " << (this->Boundary ? "On" : "Off") << "\n";
  os << indent << "BoundaryBase: " << this->BoundaryBase << "\n";
  os << indent << "BoundaryGain: " << this->BoundaryGain << "\n";
  os << indent << "BoundaryExponent: " << this->BoundaryExponent << "\n";
  os << indent << "Silhouette: " << (this->Silhouette ? "On" : "Off") << "\n";
  os << indent << "SilhouetteBase: " << this->SilhouetteBase << "\n";
  os << indent << "SilhouetteGain: " << this->SilhouetteGain << "\n";
  os << indent << "SilhouetteExponent: " << this->SilhouetteExponent << "\n";
  os << indent << "Resolution: " << (this->Resolution ? "On" : "Off") << "\n";
  os << indent << "ResolutionExponent: " << this->ResolutionExponent << "\n";
  os << indent << "SlantExponent: " << this->SlantExponent << "\n";
  os << indent << "Lighting: " << (this->Lighting ? "On" : "Off") << "\n";
  os << indent << "LightingExponent: " << this->LightingExponent << "\n";
  os << indent << "FacingAngle: " << this->FacingAngle << "\n";
  os << indent << "Headlight: " << (this->Headlight ? "On" : "Off") << "\n";
  os << indent << "LightInk: " << (this->LightInk ? "On" : "Off") << "\n";
  os << indent << "Distance: " << (this->Distance ? "On" : "Off") << "\n";
  os << indent << "DistanceExponent: " << this->DistanceExponent << "\n";
  os << indent << "DistanceSize: " << this->DistanceSize << "\n";
  os << indent << "Interior: " << (this->Interior ? "On" : "Off") << "\n";
  os << indent << "InteriorExponent: " << this->InteriorExponent << "\n";
  os << indent << "InteriorSize: " << this->InteriorSize << "\n";
  os << indent << "ValueEffect: " << this->ValueEffect << "\n";
  os << indent << "SizeUnit: " << this->GetSizeUnitAsString() << "\n";
  os << indent << "PixelsPerStipple: " << this->PixelsPerStipple << "\n";
  os << indent << "StippleSize: " << this->StippleSize << "\n";
  os << indent << "GrowWithZoom: " << (this->GrowWithZoom ? "On" : "Off") << "\n";
  os << indent << "SmallElements: " << this->GetSmallElementsAsString() << "\n";
  os << indent << "MinimumCoverage: " << this->MinimumCoverage << "\n";
  os << indent << "Fade: " << this->Fade << "\n";
  os << indent << "FadeBySize: " << (this->FadeBySize ? "On" : "Off") << "\n";
  os << indent << "WarmCool: " << this->WarmCool << "\n";
  os << indent << "ToneWeight: " << this->ToneWeight << "\n";
  os << indent << "DistanceWeight: " << this->DistanceWeight << "\n";
  os << indent << "WarmColor: " << this->WarmColor[0] << ' ' << this->WarmColor[1] << ' '
     << this->WarmColor[2] << "\n";
  os << indent << "CoolColor: " << this->CoolColor[0] << ' ' << this->CoolColor[1] << ' '
     << this->CoolColor[2] << "\n";
  os << indent << "InkColor: " << this->InkColor[0] << ' ' << this->InkColor[1] << ' ' << this->InkColor[2]
     << "\n";
  os << indent << "OccluderOffset: " << this->OccluderOffset << "\n";
  os << indent << "SurfaceFromInput: " << (this->SurfaceFromInput ? "On" : "Off") << "\n";
  os << indent << "PositionPrecision: " << this->GetPositionPrecisionAsString() << "\n";
}
