// SPDX-License-Identifier: BSD-3-Clause
// Properties that are more than one number, and what is printed of all.
#include "vtkInkSplattingLinesMapperInternals.h"

void vtkInkSplattingLinesMapper::SetCoarsestTexel(int pixels)
{
  const int texel = pixels >= 4 ? 4 : pixels >= 2 ? 2 : 1;
  if (this->CoarsestTexel != texel)
  {
    this->CoarsestTexel = texel;
    this->Modified();
  }
}

void vtkInkSplattingLinesMapper::SetLayerColor(int layer, double red, double green, double blue)
{
  if (layer == 0)
  {
    this->SetInkColor(red, green, blue);
  }
  else if (auto* style = this->Internals->FindLayer(layer))
  {
    const std::array<double, 3> color{ std::clamp(red, 0.0, 1.0), std::clamp(green, 0.0, 1.0),
      std::clamp(blue, 0.0, 1.0) };
    if (style->Color != color)
    {
      style->Color = color;
      this->Modified();
    }
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
  if (this->Internals->Set(layer, &vtkInternals::LayerStyle::Strength, strength, 0.0, 1.0))
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
  if (this->Internals->Set(layer, &vtkInternals::LayerStyle::LineWidth, width, -20.0, 20.0))
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
  if (this->Internals->Set(layer, &vtkInternals::LayerStyle::DashLength, length, 0.0, 100.0))
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
  os << indent << "InkColorMode: " << this->InkColorMode << "\n";
  os << indent << "ToneColor: " << this->ToneColor[0] << ' ' << this->ToneColor[1] << ' '
     << this->ToneColor[2] << "\n";
  os << indent << "CoarsestTexel: " << this->CoarsestTexel << "\n";
  os << indent << "HalfFloats: " << (this->HalfFloats ? "On" : "Off") << "\n";
  os << indent << "PointFraction: " << this->PointFraction << "\n";
  os << indent << "PaperVisibility: " << (this->PaperVisibility ? "On" : "Off") << "\n";
}
