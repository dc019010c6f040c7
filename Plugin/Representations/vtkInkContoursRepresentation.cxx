// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkContoursRepresentation.h"

#include "InkIsoSurface.h"
#include "InkSourcePoints.h"
#include "vtkInkContoursStyle.h"

#include "vtkObjectFactory.h"
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
  // Points of a mesh that gets more of them, at its edges or as a curved surface, say which of its own they
  // are.
  auto* mesh = vtkPolyData::SafeDownCast(input.Data);
  vtkPolyData* drawn = this->GetPiece(0);
  if (mesh && mesh->GetNumberOfPoints() > 0 &&
    (mesh->GetPoints() == drawn->GetPoints() || InkGetSourcePoints(drawn)))
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
