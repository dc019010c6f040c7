// SPDX-License-Identifier: BSD-3-Clause
// Parameters by name, copied and printed.
#include "vtkInkSilhouetteMapper.h"

#include "vtkContourValues.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkPolyData.h"

#include <algorithm>

const char* vtkInkSilhouetteMapper::GetMethodAsString()
{
  static const char* const names[] = { "Chains", "VoxelSegments", "ImageSpace", "Toon" };
  return names[this->Method];
}

void vtkInkSilhouetteMapper::SetInputData(vtkPolyData* surface)
{
  this->SetInputDataInternal(0, surface);
}

void vtkInkSilhouetteMapper::SetInputData(vtkImageData* image)
{
  this->SetInputDataInternal(0, image);
}

vtkMTimeType vtkInkSilhouetteMapper::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->ContourValues->GetMTime());
}

void vtkInkSilhouetteMapper::SetValue(int i, double value)
{
  this->ContourValues->SetValue(i, value);
}

double vtkInkSilhouetteMapper::GetValue(int i)
{
  return this->ContourValues->GetValue(i);
}

void vtkInkSilhouetteMapper::SetNumberOfContours(int number)
{
  this->ContourValues->SetNumberOfContours(number);
}

vtkIdType vtkInkSilhouetteMapper::GetNumberOfContours()
{
  return this->ContourValues->GetNumberOfContours();
}

void vtkInkSilhouetteMapper::GenerateValues(int numContours, double rangeStart, double rangeEnd)
{
  this->ContourValues->GenerateValues(numContours, rangeStart, rangeEnd);
}

void vtkInkSilhouetteMapper::ShallowCopy(vtkAbstractMapper* mapper)
{
  auto* from = vtkInkSilhouetteMapper::SafeDownCast(mapper);
  if (from && from != this)
  {
    this->SetMethod(from->GetMethod());
    this->ContourValues->DeepCopy(from->ContourValues);
    this->SetImageComponent(from->GetImageComponent());
    this->SetInputArrayToProcess(1, from->GetInputArrayInformation(1));
    this->SetLowestValue(from->GetLowestValue());
    this->SetHighestValue(from->GetHighestValue());
    this->SetLeastGradientMagnitude(from->GetLeastGradientMagnitude());
    this->SetLargestCosine(from->GetLargestCosine());
    this->SetSegmentLength(from->GetSegmentLength());
    this->SetThinning(from->GetThinning());
    this->SetSilhouettes(from->GetSilhouettes());
    this->SetFaceted(from->GetFaceted());
    this->SetCreases(from->GetCreases());
    this->SetFeatureAngle(from->GetFeatureAngle());
    this->SetShortestCrease(from->GetShortestCrease());
    this->SetSharpCreasesOnly(from->GetSharpCreasesOnly());
    this->SetShortestBorder(from->GetShortestBorder());
    this->SetBorders(from->GetBorders());
    this->SetNonManifoldEdges(from->GetNonManifoldEdges());
    this->SetCoherentDashes(from->GetCoherentDashes());
  }
  this->Superclass::ShallowCopy(mapper);
}

void vtkInkSilhouetteMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->GetMethodAsString() << "\n";
  os << indent << "Values:";
  for (vtkIdType i = 0; i < this->GetNumberOfContours(); ++i)
  {
    os << ' ' << this->GetValue(static_cast<int>(i));
  }
  os << "\n";
  os << indent << "ImageComponent: " << this->ImageComponent << "\n";
  os << indent << "LowestValue: " << this->LowestValue << "\n";
  os << indent << "HighestValue: " << this->HighestValue << "\n";
  os << indent << "LeastGradientMagnitude: " << this->LeastGradientMagnitude << "\n";
  os << indent << "LargestCosine: " << this->LargestCosine << "\n";
  os << indent << "SegmentLength: " << this->SegmentLength << "\n";
  os << indent << "Thinning: " << (this->Thinning ? "On" : "Off") << "\n";
  os << indent << "Silhouettes: " << (this->Silhouettes ? "On" : "Off") << "\n";
  os << indent << "Faceted: " << (this->Faceted ? "On" : "Off") << "\n";
  os << indent << "Creases: " << (this->Creases ? "On" : "Off") << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "ShortestCrease: " << this->ShortestCrease << "\n";
  os << indent << "SharpCreasesOnly: " << (this->SharpCreasesOnly ? "On" : "Off") << "\n";
  os << indent << "ShortestBorder: " << this->ShortestBorder << "\n";
  os << indent << "Borders: " << (this->Borders ? "On" : "Off") << "\n";
  os << indent << "NonManifoldEdges: " << (this->NonManifoldEdges ? "On" : "Off") << "\n";
  os << indent << "CoherentDashes: " << (this->CoherentDashes ? "On" : "Off") << "\n";
}
