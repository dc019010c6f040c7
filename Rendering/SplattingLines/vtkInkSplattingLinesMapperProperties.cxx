// SPDX-License-Identifier: BSD-3-Clause
// Properties that are more than one number, and what is printed of all.
#include "vtkInkSplattingLinesMapperInternals.h"

void vtkInkSplattingLinesMapper::SetMaximumDownsampling(int pixels)
{
  const int texel = pixels >= 4 ? 4 : pixels >= 2 ? 2 : 1;
  if (this->MaximumDownsampling != texel)
  {
    this->MaximumDownsampling = texel;
    this->Modified();
  }
}

const char* vtkInkSplattingLinesMapper::GetInkColorModeAsString()
{
  static const char* const names[] = { "Ink", "Scalars", "Tone" };
  return names[this->InkColorMode];
}

bool vtkInkSplattingLinesMapper::CheckLayer(const char* property, int layer)
{
  const bool exists = this->Internals->FindLayer(layer) != nullptr;
  if (!exists)
  {
    vtkWarningMacro(<< property << ": expected a layer from 0 to " << InkSplatStyle::MostLayers - 1
                    << ", found " << layer << '.');
  }
  return exists;
}

void vtkInkSplattingLinesMapper::SetLayerColor(int layer, double red, double green, double blue)
{
  if (!this->CheckLayer("LayerColor", layer))
  {
    return;
  }
  if (layer == 0)
  {
    this->SetInkColor(red, green, blue);
    return;
  }
  auto& own = this->Internals->FindLayer(layer)->Color;
  std::array<double, 3> color{};
  this->GetLayerColor(layer, color.data());
  const bool changed = InkSetColor(this, "LayerColor", color.data(), red, green, blue);
  const bool refused = std::isnan(red) || std::isnan(green) || std::isnan(blue);
  if (changed || (!own && !refused))
  {
    own = color;
    this->Modified();
  }
}

void vtkInkSplattingLinesMapper::ResetLayerColor(int layer)
{
  if (this->CheckLayer("LayerColor", layer) && this->Internals->FindLayer(layer)->Color)
  {
    this->Internals->FindLayer(layer)->Color.reset();
    this->Modified();
  }
}

void vtkInkSplattingLinesMapper::SetLayerColor(int layer, const double color[3])
{
  this->SetLayerColor(layer, color[0], color[1], color[2]);
}

void vtkInkSplattingLinesMapper::GetLayerColor(int layer, double color[3])
{
  const auto* style = this->Internals->FindLayer(layer);
  std::copy_n(style && style->Color ? style->Color->data() : this->InkColor, 3, color);
}

void vtkInkSplattingLinesMapper::SetLayerStrength(int layer, double strength)
{
  if (this->CheckLayer("LayerStrength", layer) &&
    InkSetClamped(this, "LayerStrength", this->Internals->FindLayer(layer)->Strength, strength, 0.0, 1.0))
  {
    this->Modified();
  }
}

double vtkInkSplattingLinesMapper::GetLayerStrength(int layer)
{
  return this->Internals->Get(layer, &vtkInternals::LayerStyle::Strength);
}

void vtkInkSplattingLinesMapper::SetLayerLineWidth(int layer, double width)
{
  if (this->CheckLayer("LayerLineWidth", layer) &&
    InkSetClamped(this, "LayerLineWidth", this->Internals->FindLayer(layer)->LineWidth, width, -20.0, 20.0))
  {
    this->Modified();
  }
}

double vtkInkSplattingLinesMapper::GetLayerLineWidth(int layer)
{
  return this->Internals->Get(layer, &vtkInternals::LayerStyle::LineWidth);
}

void vtkInkSplattingLinesMapper::SetLayerDashLength(int layer, double length)
{
  if (this->CheckLayer("LayerDashLength", layer) &&
    InkSetClamped(this, "LayerDashLength", this->Internals->FindLayer(layer)->DashLength, length, 0.0, 100.0))
  {
    this->Modified();
  }
}

double vtkInkSplattingLinesMapper::GetLayerDashLength(int layer)
{
  return this->Internals->Get(layer, &vtkInternals::LayerStyle::DashLength);
}

void vtkInkSplattingLinesMapper::SetLineWidth(double width)
{
  for (int layer = 0; layer < InkSplatStyle::MostLayers; ++layer)
  {
    this->SetLayerLineWidth(layer, width);
  }
}

void vtkInkSplattingLinesMapper::ShallowCopy(vtkAbstractMapper* mapper)
{
  this->Superclass::ShallowCopy(mapper);
  auto* other = vtkInkSplattingLinesMapper::SafeDownCast(mapper);
  if (!other || other == this)
  {
    return;
  }
  for (int array : { NORMALS, RADIUS })
  {
    this->SetInputArrayToProcess(array, other->GetInputArrayInformation(array));
  }
  this->SetLambda(other->Lambda);
  this->SetTau(other->Tau);
  this->SetPhi(other->Phi);
  this->SetSigma(other->Sigma);
  this->SetAsPublished(other->AsPublished);
  this->SetRadius(other->Radius);
  this->SetMinimumRadius(other->MinimumRadius);
  this->SetHiddenLayers(other->HiddenLayers);
  this->SetNumberOfLayers(other->NumberOfLayers);
  this->SetPeelBackFaces(other->PeelBackFaces);
  this->SetHardness(other->Hardness);
  this->SetSpeckleLength(other->SpeckleLength);
  this->SetThinning(other->Thinning);
  this->SetInkColorMode(other->InkColorMode);
  this->SetToneColor(other->ToneColor);
  this->SetMaximumDownsampling(other->MaximumDownsampling);
  this->SetHalfFloats(other->HalfFloats);
  this->SetPointFraction(other->PointFraction);
  this->SetInkColor(other->InkColor);
  this->SetPaperColor(other->PaperColor);
  this->SetPaperVisibility(other->PaperVisibility);
  this->Internals->Layers = other->Internals->Layers;
  this->Modified();
}

void vtkInkSplattingLinesMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Lambda: " << this->Lambda << "\n";
  os << indent << "Tau: " << this->Tau << "\n";
  os << indent << "Phi: " << this->Phi << "\n";
  os << indent << "Sigma: " << this->Sigma << "\n";
  os << indent << "AsPublished: " << (this->AsPublished ? "On" : "Off") << "\n";
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "InkColor: " << this->InkColor[0] << ' ' << this->InkColor[1] << ' ' << this->InkColor[2]
     << "\n";
  os << indent << "PaperColor: " << this->PaperColor[0] << ' ' << this->PaperColor[1] << ' '
     << this->PaperColor[2] << "\n";
  os << indent << "MinimumRadius: " << this->MinimumRadius << "\n";
  os << indent << "HiddenLayers: " << (this->HiddenLayers ? "On" : "Off") << "\n";
  os << indent << "NumberOfLayers: " << this->NumberOfLayers << "\n";
  os << indent << "PeelBackFaces: " << (this->PeelBackFaces ? "On" : "Off") << "\n";
  for (int layer = 0; layer < InkSplatStyle::MostLayers; ++layer)
  {
    double color[3];
    this->GetLayerColor(layer, color);
    os << indent << "Layer " << layer << ": color " << color[0] << ' ' << color[1] << ' ' << color[2]
       << ", strength " << this->GetLayerStrength(layer) << ", line width " << this->GetLayerLineWidth(layer)
       << ", dash length " << this->GetLayerDashLength(layer) << "\n";
  }
  os << indent << "Hardness: " << this->Hardness << "\n";
  os << indent << "SpeckleLength: " << this->SpeckleLength << "\n";
  os << indent << "Thinning: " << (this->Thinning ? "On" : "Off") << "\n";
  os << indent << "InkColorMode: " << this->GetInkColorModeAsString() << "\n";
  os << indent << "ToneColor: " << this->ToneColor[0] << ' ' << this->ToneColor[1] << ' '
     << this->ToneColor[2] << "\n";
  os << indent << "MaximumDownsampling: " << this->MaximumDownsampling << "\n";
  os << indent << "HalfFloats: " << (this->HalfFloats ? "On" : "Off") << "\n";
  os << indent << "PointFraction: " << this->PointFraction << "\n";
  os << indent << "PaperVisibility: " << (this->PaperVisibility ? "On" : "Off") << "\n";
}
