// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkSplattingLinesRepresentation.h"

#include "vtkInkGatherPoints.h"
#include "vtkInkSplattingLinesMapper.h"

#include "vtkActor.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkInkSplattingLinesRepresentation);

vtkInkSplattingLinesRepresentation::vtkInkSplattingLinesRepresentation()
  : vtkInkRepresentation(vtkSmartPointer<vtkActor>::New(), 1, 1)
{
  this->GetActor()->SetMapper(this->Mapper);
}

vtkInkSplattingLinesRepresentation::~vtkInkSplattingLinesRepresentation() = default;

int vtkInkSplattingLinesRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const vtkInkGatheredPoints gathered = vtkInkGatherPoints(
    vtkDataObject::GetData(inputVector[0], 0), this->GetArrayName(0), this->GetArrayAssociation(0));
  this->GetPiece(0)->ShallowCopy(gathered.Points);
  if (gathered.IdsAreInputs)
  {
    this->MarkIdsAsInputs();
  }
  if (!gathered.Problem.empty())
  {
    vtkWarningMacro(<< "Splatting Lines draws nothing for " << gathered.Problem);
  }
  return this->Superclass::RequestData(request, inputVector, outputVector);
}

void vtkInkSplattingLinesRepresentation::Show(const std::vector<vtkPolyData*>& delivered)
{
  this->Mapper->SetInputDataObject(delivered[0]);
}

void vtkInkSplattingLinesRepresentation::SetLambda(double lambda)
{
  this->Mapper->SetLambda(lambda);
}

void vtkInkSplattingLinesRepresentation::SetTau(double tau)
{
  this->Mapper->SetTau(tau);
}

void vtkInkSplattingLinesRepresentation::SetPhi(double phi)
{
  this->Mapper->SetPhi(phi);
}

void vtkInkSplattingLinesRepresentation::SetSigma(double sigma)
{
  this->Mapper->SetSigma(sigma);
}

void vtkInkSplattingLinesRepresentation::SetAsPublished(bool asPublished)
{
  this->Mapper->SetAsPublished(asPublished);
}

void vtkInkSplattingLinesRepresentation::SetRadius(double radius)
{
  this->Mapper->SetRadius(radius);
}

void vtkInkSplattingLinesRepresentation::SetInkColor(double red, double green, double blue)
{
  this->Mapper->SetInkColor(red, green, blue);
}

void vtkInkSplattingLinesRepresentation::SetPaperColor(double red, double green, double blue)
{
  this->Mapper->SetPaperColor(red, green, blue);
}

void vtkInkSplattingLinesRepresentation::SetPaperVisibility(bool visible)
{
  this->Mapper->SetPaperVisibility(visible);
}
