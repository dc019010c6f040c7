// SPDX-License-Identifier: BSD-3-Clause
// Parameters by name, copied and printed.
#include "vtkInkStrokeMapper.h"

#include "vtkAlgorithmOutput.h"
#include "vtkImageData.h"
#include "vtkInformation.h"

const char* vtkInkStrokeMapper::GetSizeUnitAsString()
{
  static const char* const names[] = { "Thousandths", "Pixels", "World" };
  return names[this->SizeUnit];
}

const char* vtkInkStrokeMapper::GetJoinAsString()
{
  return this->Join == MITER_JOIN ? "Miter" : "Round";
}

const char* vtkInkStrokeMapper::GetCapAsString()
{
  return this->Cap == BUTT_CAP ? "Butt" : "Round";
}

const char* vtkInkStrokeMapper::GetHiddenPartsAsString()
{
  static const char* const names[] = { "Omitted", "Faint", "Dashed" };
  return names[this->HiddenParts];
}

void vtkInkStrokeMapper::ShallowCopy(vtkAbstractMapper* mapper)
{
  auto* from = vtkInkStrokeMapper::SafeDownCast(mapper);
  if (from && from != this)
  {
    this->SetSurfaceConnection(
      from->GetNumberOfInputConnections(1) > 0 ? from->GetInputConnection(1, 0) : nullptr);
    this->SetInputArrayToProcess(0, from->GetInputArrayInformation(0));
    this->SetSizeUnit(from->GetSizeUnit());
    this->SetLineWidth(from->GetLineWidth());
    this->SetTaper(from->GetTaper());
    this->SetDepthWidth(from->GetDepthWidth());
    this->SetJoin(from->GetJoin());
    this->SetMiterLimit(from->GetMiterLimit());
    this->SetCap(from->GetCap());
    this->SetDashed(from->GetDashed());
    this->SetDashLength(from->GetDashLength());
    this->SetGapLength(from->GetGapLength());
    this->SetTexture(from->GetTexture());
    this->SetTextureLength(from->GetTextureLength());
    this->SetDensity(from->GetDensity());
    this->SetInkColor(from->GetInkColor());
    this->SetLift(from->GetLift());
    this->SetDepthTolerance(from->GetDepthTolerance());
    this->SetHiddenParts(from->GetHiddenParts());
    this->SetHiddenOpacity(from->GetHiddenOpacity());
    this->SetShortestPart(from->GetShortestPart());
    this->SetHatching(from->GetHatching());
    this->SetHatchSpacing(from->GetHatchSpacing());
    this->SetTone(from->GetTone());
    this->SetDarkestTone(from->GetDarkestTone());
    this->SetSilhouetteWeight(from->GetSilhouetteWeight());
    this->SetDiffuseTruncation(from->GetDiffuseTruncation());
    this->SetSilhouetteTruncation(from->GetSilhouetteTruncation());
    this->SetCrosshatching(from->GetCrosshatching());
    this->SetCullingCosine(from->GetCullingCosine());
  }
  this->Superclass::ShallowCopy(mapper);
}

void vtkInkStrokeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SizeUnit: " << this->GetSizeUnitAsString() << "\n";
  os << indent << "LineWidth: " << this->LineWidth << "\n";
  os << indent << "Taper: " << this->Taper << "\n";
  os << indent << "DepthWidth: " << this->DepthWidth << "\n";
  os << indent << "Join: " << this->GetJoinAsString() << "\n";
  os << indent << "MiterLimit: " << this->MiterLimit << "\n";
  os << indent << "Cap: " << this->GetCapAsString() << "\n";
  os << indent << "Dashed: " << (this->Dashed ? "On" : "Off") << "\n";
  os << indent << "DashLength: " << this->DashLength << "\n";
  os << indent << "GapLength: " << this->GapLength << "\n";
  os << indent << "Texture: " << this->Texture.Get() << "\n";
  os << indent << "TextureLength: " << this->TextureLength << "\n";
  os << indent << "Density: " << this->Density << "\n";
  os << indent << "InkColor: " << this->InkColor[0] << ' ' << this->InkColor[1] << ' ' << this->InkColor[2]
     << "\n";
  os << indent << "Lift: " << this->Lift << "\n";
  os << indent << "DepthTolerance: " << this->DepthTolerance << "\n";
  os << indent << "HiddenParts: " << this->GetHiddenPartsAsString() << "\n";
  os << indent << "HiddenOpacity: " << this->HiddenOpacity << "\n";
  os << indent << "ShortestPart: " << this->ShortestPart << "\n";
  os << indent << "Hatching: " << (this->Hatching ? "On" : "Off") << "\n";
  os << indent << "HatchSpacing: " << this->HatchSpacing << "\n";
  os << indent << "Tone: " << this->Tone << "\n";
  os << indent << "DarkestTone: " << this->DarkestTone << "\n";
  os << indent << "SilhouetteWeight: " << this->SilhouetteWeight << "\n";
  os << indent << "DiffuseTruncation: " << this->DiffuseTruncation << "\n";
  os << indent << "SilhouetteTruncation: " << this->SilhouetteTruncation << "\n";
  os << indent << "Crosshatching: " << this->Crosshatching << "\n";
  os << indent << "CullingCosine: " << this->CullingCosine << "\n";
}
