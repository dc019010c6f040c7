// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkContoursRepresentation.h"

#include "InkIsoSurface.h"
#include "vtkInkContoursStyle.h"

#include "vtkObjectFactory.h"
#include "vtkPVView.h"
#include "vtkPolyData.h"

#include <utility>

vtkStandardNewMacro(vtkInkContoursRepresentation);

vtkInkContoursRepresentation::vtkInkContoursRepresentation()
  : vtkInkContoursRepresentation(vtkSmartPointer<vtkInkContoursStyle>::New())
{
  this->SetProgressText("Making contours");
}

vtkInkContoursRepresentation::vtkInkContoursRepresentation(vtkSmartPointer<vtkInkStyle> style)
  : vtkInkRepresentation(std::move(style))
{
}

vtkInkContoursRepresentation::~vtkInkContoursRepresentation() = default;

std::vector<double> vtkInkContoursRepresentation::GetUsedIsoValues()
{
  return vtkInkContoursStyle::SafeDownCast(this->GetStyle())->GetIsoSurface()->GetUsedIsoValues();
}

std::string vtkInkContoursRepresentation::MakeMarks(const vtkInkStyle::Input& input)
{
  std::string problem = this->Superclass::MakeMarks(input);
  // As a mesh without normals gets some, points at its edges are split.
  auto* mesh = vtkPolyData::SafeDownCast(input.Data);
  if (mesh && mesh->GetNumberOfPoints() > 0 && mesh->GetPoints() == this->GetPiece(0)->GetPoints())
  {
    this->MarkIdsAsInputs();
  }
  return problem;
}

int vtkInkContoursRepresentation::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
  AskForGhostsOfGrids(inputVector);
  return 1;
}

int vtkInkContoursRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  if (request == vtkPVView::REQUEST_UPDATE())
  {
    this->UpdatePictureSize();
  }
  return this->Superclass::ProcessViewRequest(request, inInfo, outInfo);
}
