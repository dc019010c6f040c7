// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkStippleEnhancements.h"

void vtkInkStippleEnhancements::ShallowCopy(vtkAbstractMapper* mapper)
{
  if (auto* from = vtkInkStippleEnhancements::SafeDownCast(mapper))
  {
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
  }
  this->Superclass::ShallowCopy(mapper);
}

void vtkInkStippleEnhancements::PrintSelf(ostream& os, vtkIndent indent)
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
}
