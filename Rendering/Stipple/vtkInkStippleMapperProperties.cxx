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
