// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkIllustrationRepresentation.h"

#include "InkIsoSurface.h"
#include "vtkInkIllustrationStyle.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkInkIllustrationRepresentation);

vtkInkIllustrationRepresentation::vtkInkIllustrationRepresentation()
  : vtkInkRepresentation(vtkSmartPointer<vtkInkIllustrationStyle>::New())
{
  this->SetProgressText("Making an illustration");
}

vtkInkIllustrationRepresentation::~vtkInkIllustrationRepresentation() = default;

std::vector<double> vtkInkIllustrationRepresentation::GetUsedIsoValues()
{
  auto* style = vtkInkIllustrationStyle::SafeDownCast(this->GetStyle());
  std::vector<double> values = style->GetIsoSurface()->GetUsedIsoValues();
  const std::vector<double>& outer = style->GetUsedOuterIsoValue();
  values.insert(values.end(), outer.begin(), outer.end());
  return values;
}

void vtkInkIllustrationRepresentation::SetAutomaticOuterIsoValue(bool automatic)
{
  this->OuterIsoValue.Automatic = automatic;
  this->ApplyChoice("OuterIsoValue", this->OuterIsoValue);
}

void vtkInkIllustrationRepresentation::SetOuterIsoValue(double value)
{
  this->OuterIsoValue.Value = value;
  this->ApplyChoice("OuterIsoValue", this->OuterIsoValue);
}

std::string vtkInkIllustrationRepresentation::MakeMarks(const vtkInkStyle::Input& input)
{
  vtkInkIllustrationStyle::SafeDownCast(this->GetStyle())
    ->SetColorArray(this->GetColorArray(), this->GetColorAssociation());
  return this->Superclass::MakeMarks(input);
}

bool vtkInkIllustrationRepresentation::BlendsMarks()
{
  return vtkInkIllustrationStyle::SafeDownCast(this->GetStyle())->GetSeeThrough() ||
    this->Superclass::BlendsMarks();
}

int vtkInkIllustrationRepresentation::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
  AskForGhostsOfGrids(inputVector);
  return 1;
}
