// SPDX-License-Identifier: BSD-3-Clause
// SPDX-License-Identifier: BSD-3-Clause Setters that clamp, names of enumerations, and PrintSelf.
#include "vtkInkStippleGenerator.h"

#include "InkPrecision.h"
#include "InkSetNumber.h"

const char* vtkInkStippleGenerator::GetThresholdModeAsString()
{
  return this->ThresholdMode == PERCENTILE ? "Percentile" : "Magnitude";
}

const char* vtkInkStippleGenerator::GetGradientMethodAsString()
{
  return this->GradientMethod == REGRESSION ? "Regression" : "CentralDifference";
}

const char* vtkInkStippleGenerator::GetGradientWeightingAsString()
{
  return this->GradientWeighting == INVERSE_DISTANCE ? "InverseDistance" : "Uniform";
}

const char* vtkInkStippleGenerator::GetMaximumStipplesModeAsString()
{
  return this->MaximumStipplesMode == PROJECTED ? "Projected" : "Fixed";
}

const char* vtkInkStippleGenerator::GetOutputPointsPrecisionAsString()
{
  return InkNameOfPrecision(this->OutputPointsPrecision);
}

void vtkInkStippleGenerator::SetPictureSize(double pixels)
{
  InkSetClampedNumber(this, "PictureSize", this->PictureSize, pixels, 100.0, 100000.0);
}

void vtkInkStippleGenerator::SetGradientPercentile(double percentile)
{
  InkSetClampedNumber(this, "GradientPercentile", this->GradientPercentile, percentile, 0.0, 100.0);
}

void vtkInkStippleGenerator::SetGradientThreshold(double threshold)
{
  InkSetClampedNumber(this, "GradientThreshold", this->GradientThreshold, threshold, 0.0, VTK_DOUBLE_MAX);
}

void vtkInkStippleGenerator::SetLayerThickness(double thickness)
{
  InkSetClampedNumber(this, "LayerThickness", this->LayerThickness, thickness, 0.0, 2.0);
}

void vtkInkStippleGenerator::SetScalarWindow(double lowest, double highest)
{
  InkSetRange(this, "ScalarWindow", this->ScalarWindow, lowest, highest);
}

void vtkInkStippleGenerator::SetReferenceScalarRange(double lowest, double highest)
{
  InkSetRange(this, "ReferenceScalarRange", this->ReferenceScalarRange, lowest, highest);
}

void vtkInkStippleGenerator::SetReferenceGradient(double magnitude)
{
  InkSetClampedNumber(this, "ReferenceGradient", this->ReferenceGradient, magnitude, 0.0, VTK_DOUBLE_MAX);
}

void vtkInkStippleGenerator::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumStipplesMode: " << this->GetMaximumStipplesModeAsString() << "\n"
     << indent << "PictureSize: " << this->PictureSize << "\n"
     << indent << "MaximumStipples: " << this->MaximumStipples << "\n"
     << indent << "NumberOfSurfaceStipples: " << this->NumberOfSurfaceStipples << "\n"
     << indent << "ThresholdMode: " << this->GetThresholdModeAsString() << "\n"
     << indent << "GradientPercentile: " << this->GradientPercentile << "\n"
     << indent << "GradientThreshold: " << this->GradientThreshold << "\n"
     << indent << "LayerThickness: " << this->LayerThickness << "\n"
     << indent << "GradientMethod: " << this->GetGradientMethodAsString() << "\n"
     << indent << "GradientWeighting: " << this->GetGradientWeightingAsString() << "\n"
     << indent << "UseScalarWindow: " << this->UseScalarWindow << "\n"
     << indent << "ScalarWindow: " << this->ScalarWindow[0] << " " << this->ScalarWindow[1] << "\n"
     << indent << "UseReferenceRanges: " << this->UseReferenceRanges << "\n"
     << indent << "ReferenceScalarRange: " << this->ReferenceScalarRange[0] << " "
     << this->ReferenceScalarRange[1] << "\n"
     << indent << "ReferenceGradient: " << this->ReferenceGradient << "\n"
     << indent << "PassScalars: " << this->PassScalars << "\n"
     << indent << "Seed: " << this->Seed << "\n"
     << indent << "ArrayComponent: " << this->ArrayComponent << "\n"
     << indent << "OutputPointsPrecision: " << this->GetOutputPointsPrecisionAsString() << "\n";
}
