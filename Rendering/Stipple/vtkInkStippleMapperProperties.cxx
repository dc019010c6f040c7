// SPDX-License-Identifier: BSD-3-Clause
// Parameters by name, copied and printed.
#include "vtkInkStippleMapper.h"

#include "vtkAlgorithmOutput.h"

const char* vtkInkStippleMapper::GetSmallElementsAsString()
{
  return this->SmallElements == PROBABILITY ? "Probability" : "Intensity";
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
    this->SetKgc(from->GetKgc());
    this->SetKgs(from->GetKgs());
    this->SetKge(from->GetKge());
    this->SetSilhouette(from->GetSilhouette());
    this->SetKsc(from->GetKsc());
    this->SetKss(from->GetKss());
    this->SetKse(from->GetKse());
    this->SetResolution(from->GetResolution());
    this->SetKrc(from->GetKrc());
    this->SetKnz(from->GetKnz());
    this->SetLighting(from->GetLighting());
    this->SetKle(from->GetKle());
    this->SetFacingAngle(from->GetFacingAngle());
    this->SetHeadlight(from->GetHeadlight());
    this->SetLightInk(from->GetLightInk());
    this->SetDistance(from->GetDistance());
    this->SetKde(from->GetKde());
    this->SetDistanceSize(from->GetDistanceSize());
    this->SetInterior(from->GetInterior());
    this->SetKie(from->GetKie());
    this->SetInteriorSize(from->GetInteriorSize());
    this->SetValueEffect(from->GetValueEffect());
    this->SetPixelsPerStipple(from->GetPixelsPerStipple());
    this->SetStippleSize(from->GetStippleSize());
    this->SetGrowing(from->GetGrowing());
    this->SetSmallElements(from->GetSmallElements());
    this->SetMinimumCoverage(from->GetMinimumCoverage());
    this->SetFade(from->GetFade());
    this->SetAppearBySize(from->GetAppearBySize());
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
  os << indent << "Kgc: " << this->Kgc << "\n";
  os << indent << "Kgs: " << this->Kgs << "\n";
  os << indent << "Kge: " << this->Kge << "\n";
  os << indent << "Silhouette: " << (this->Silhouette ? "On" : "Off") << "\n";
  os << indent << "Ksc: " << this->Ksc << "\n";
  os << indent << "Kss: " << this->Kss << "\n";
  os << indent << "Kse: " << this->Kse << "\n";
  os << indent << "Resolution: " << (this->Resolution ? "On" : "Off") << "\n";
  os << indent << "Krc: " << this->Krc << "\n";
  os << indent << "Knz: " << this->Knz << "\n";
  os << indent << "Lighting: " << (this->Lighting ? "On" : "Off") << "\n";
  os << indent << "Kle: " << this->Kle << "\n";
  os << indent << "FacingAngle: " << this->FacingAngle << "\n";
  os << indent << "Headlight: " << (this->Headlight ? "On" : "Off") << "\n";
  os << indent << "LightInk: " << (this->LightInk ? "On" : "Off") << "\n";
  os << indent << "Distance: " << (this->Distance ? "On" : "Off") << "\n";
  os << indent << "Kde: " << this->Kde << "\n";
  os << indent << "DistanceSize: " << this->DistanceSize << "\n";
  os << indent << "Interior: " << (this->Interior ? "On" : "Off") << "\n";
  os << indent << "Kie: " << this->Kie << "\n";
  os << indent << "InteriorSize: " << this->InteriorSize << "\n";
  os << indent << "ValueEffect: " << this->ValueEffect << "\n";
  os << indent << "PixelsPerStipple: " << this->PixelsPerStipple << "\n";
  os << indent << "StippleSize: " << this->StippleSize << "\n";
  os << indent << "Growing: " << (this->Growing ? "On" : "Off") << "\n";
  os << indent << "SmallElements: " << this->GetSmallElementsAsString() << "\n";
  os << indent << "MinimumCoverage: " << this->MinimumCoverage << "\n";
  os << indent << "Fade: " << this->Fade << "\n";
  os << indent << "AppearBySize: " << (this->AppearBySize ? "On" : "Off") << "\n";
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
