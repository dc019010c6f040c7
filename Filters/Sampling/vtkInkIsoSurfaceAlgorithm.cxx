// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkIsoSurfaceAlgorithm.h"

#include "Fields/Resampling/SliceDistances.h"
#include "InkPrecision.h"
#include "IsoSurface/IsoSurfaceSamples.h"
#include "Statistics/NoiseEstimate.h"

#include "vtkContourValues.h"
#include "vtkImageData.h"

#include <algorithm>
#include <cmath>

vtkInkIsoSurfaceAlgorithm::vtkInkIsoSurfaceAlgorithm()
{
  // vtkContourValues initially holds one value.
  this->ContourValues->SetNumberOfContours(0);
}

vtkInkIsoSurfaceAlgorithm::~vtkInkIsoSurfaceAlgorithm() = default;

void vtkInkIsoSurfaceAlgorithm::SetValue(int i, double value)
{
  this->ContourValues->SetValue(i, value);
}

double vtkInkIsoSurfaceAlgorithm::GetValue(int i)
{
  return this->ContourValues->GetValue(i);
}

void vtkInkIsoSurfaceAlgorithm::SetNumberOfContours(int number)
{
  this->ContourValues->SetNumberOfContours(number);
}

vtkIdType vtkInkIsoSurfaceAlgorithm::GetNumberOfContours()
{
  return this->ContourValues->GetNumberOfContours();
}

void vtkInkIsoSurfaceAlgorithm::GenerateValues(int numContours, double rangeStart, double rangeEnd)
{
  this->ContourValues->GenerateValues(numContours, rangeStart, rangeEnd);
}

void vtkInkIsoSurfaceAlgorithm::SetValues(const std::vector<double>& values)
{
  this->SetNumberOfContours(static_cast<int>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    this->SetValue(static_cast<int>(i), values[i]);
  }
}

std::vector<double> vtkInkIsoSurfaceAlgorithm::TakeIsoValues()
{
  const double* values = this->ContourValues->GetValues();
  std::vector<double> taken(values, values + this->ContourValues->GetNumberOfContours());
  if (std::any_of(taken.begin(), taken.end(), [](double value) { return std::isnan(value); }))
  {
    vtkWarningMacro("An iso-value is not a number (NaN) and makes no points.");
  }
  return taken;
}

ink::SampleOptions vtkInkIsoSurfaceAlgorithm::MakeSampleOptions() const
{
  ink::SampleOptions options;
  options.rule = this->CrossingRule == STRICT ? ink::CrossingRule::Strict : ink::CrossingRule::HalfOpen;
  options.method = static_cast<ink::NormalMethod>(this->NormalMethod);
  return options;
}

std::optional<ink::ThickSlices> vtkInkIsoSurfaceAlgorithm::FindThickSlices(vtkImageData* frame) const
{
  const double* spacing = frame->GetSpacing();
  return this->ShapeBasedInterpolation ? ink::thickSlices({ spacing[0], spacing[1], spacing[2] })
                                       : std::nullopt;
}

double vtkInkIsoSurfaceAlgorithm::SuggestSmoothing(double isoValue)
{
  return this->SuggestSmoothings(isoValue).get(this->ShapeBasedInterpolation).get(this->LabelMap);
}

bool vtkInkIsoSurfaceAlgorithm::SuggestLabelMap(double isoValue)
{
  return this->SuggestSmoothings(isoValue).labels;
}

bool vtkInkIsoSurfaceAlgorithm::SuggestShapeBasedInterpolation(double isoValue)
{
  return this->LabelMap || this->SuggestSmoothings(isoValue).shapeBased;
}

bool vtkInkIsoSurfaceAlgorithm::SuggestLabelBorders(double isoValue)
{
  const ink::SuggestedSmoothing suggested = this->SuggestSmoothings(isoValue);
  return suggested.labels && suggested.clearBorders;
}

std::vector<double> vtkInkIsoSurfaceAlgorithm::FindIsoValues()
{
  const double* values = this->ContourValues->GetValues();
  return { values, values + this->ContourValues->GetNumberOfContours() };
}

void vtkInkIsoSurfaceAlgorithm::CopyProperties(vtkInkIsoSurfaceAlgorithm* from)
{
  this->SetCrossingRule(from->CrossingRule);
  this->SetNormalMethod(from->NormalMethod);
  this->SetComputeNormals(from->ComputeNormals);
  this->SetComputeSurfaceIndex(from->ComputeSurfaceIndex);
  this->SetComputeRadius(from->ComputeRadius);
  this->SetGenerateVertices(from->GenerateVertices);
  this->SetOutputPointsPrecision(from->OutputPointsPrecision);
  this->SetProjectionSteps(from->ProjectionSteps);
  this->SetSmoothing(from->Smoothing);
  this->SetSmoothingTarget(from->SmoothingTarget);
  this->SetLabelMap(from->LabelMap);
  this->SetLabelBorders(from->LabelBorders);
  this->SetShapeBasedInterpolation(from->ShapeBasedInterpolation);
  this->SetSubdivision(from->Subdivision);
  this->SetCut(from->Cut);
  this->SetSmallestPart(from->SmallestPart);
  this->SetLargestParts(from->LargestParts);
  this->SetArithmeticPrecision(from->ArithmeticPrecision);
}

const char* vtkInkIsoSurfaceAlgorithm::GetCrossingRuleAsString()
{
  return this->CrossingRule == STRICT ? "Strict" : "HalfOpen";
}

const char* vtkInkIsoSurfaceAlgorithm::GetSmoothingTargetAsString()
{
  return this->SmoothingTarget == NORMALS ? "Normals" : "Surface";
}

const char* vtkInkIsoSurfaceAlgorithm::GetCutAsString()
{
  constexpr const char* names[] = { "Open", "Rim", "Cap" };
  return names[this->Cut];
}

const char* vtkInkIsoSurfaceAlgorithm::GetNormalMethodAsString()
{
  constexpr const char* names[] = { "Cell", "InterpolatedGradient", "InterpolatedNormal", "Regression" };
  return names[this->NormalMethod];
}

const char* vtkInkIsoSurfaceAlgorithm::GetOutputPointsPrecisionAsString()
{
  return InkNameOfPrecision(this->OutputPointsPrecision);
}

const char* vtkInkIsoSurfaceAlgorithm::GetArithmeticPrecisionAsString()
{
  return InkNameOfPrecision(this->ArithmeticPrecision);
}

vtkMTimeType vtkInkIsoSurfaceAlgorithm::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->ContourValues->GetMTime());
}

void vtkInkIsoSurfaceAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CrossingRule: " << this->GetCrossingRuleAsString() << "\n"
     << indent << "NormalMethod: " << this->GetNormalMethodAsString() << "\n"
     << indent << "ComputeNormals: " << this->ComputeNormals << "\n"
     << indent << "ComputeSurfaceIndex: " << this->ComputeSurfaceIndex << "\n"
     << indent << "ComputeRadius: " << this->ComputeRadius << "\n"
     << indent << "GenerateVertices: " << this->GenerateVertices << "\n"
     << indent << "OutputPointsPrecision: " << this->GetOutputPointsPrecisionAsString() << "\n"
     << indent << "ProjectionSteps: " << this->ProjectionSteps << "\n"
     << indent << "Smoothing: " << this->Smoothing << "\n"
     << indent << "SmoothingTarget: " << this->GetSmoothingTargetAsString() << "\n"
     << indent << "LabelMap: " << this->LabelMap << "\n"
     << indent << "LabelBorders: " << this->LabelBorders << "\n"
     << indent << "ShapeBasedInterpolation: " << this->ShapeBasedInterpolation << "\n"
     << indent << "Subdivision: " << this->Subdivision << "\n"
     << indent << "Cut: " << this->GetCutAsString() << "\n"
     << indent << "SmallestPart: " << this->SmallestPart << "\n"
     << indent << "LargestParts: " << this->LargestParts << "\n"
     << indent << "ArithmeticPrecision: " << this->GetArithmeticPrecisionAsString() << "\n"
     << indent << "MaximumMemory: " << this->MaximumMemory << "\n"
     << indent << "ContourValues:\n";
  this->ContourValues->PrintSelf(os, indent.GetNextIndent());
}
