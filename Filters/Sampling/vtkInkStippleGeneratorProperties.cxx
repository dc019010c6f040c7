// SPDX-License-Identifier: BSD-3-Clause
// Names of enumerations, and PrintSelf.
#include "vtkInkStippleGenerator.h"

#include "InkPrecision.h"

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

void vtkInkStippleGenerator::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumStipplesMode: " << this->GetMaximumStipplesModeAsString() << "\n"
     << indent << "PictureSize: " << this->PictureSize << "\n"
     << indent << "MaximumStipples: " << this->MaximumStipples << "\n"
     << indent << "NumberOfSurfaceStipples: " << this->NumberOfSurfaceStipples << "\n"
     << indent << "Smoothing: " << this->Smoothing << "\n"
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
