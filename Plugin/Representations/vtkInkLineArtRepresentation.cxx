// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkLineArtRepresentation.h"

#include "InkIsoSurface.h"
#include "vtkInkLineArtStyle.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkInkLineArtRepresentation);

vtkInkLineArtRepresentation::vtkInkLineArtRepresentation()
  : vtkInkContoursRepresentation(vtkSmartPointer<vtkInkLineArtStyle>::New())
{
  this->SetProgressText("Making line art");
}

vtkInkLineArtRepresentation::~vtkInkLineArtRepresentation() = default;

std::vector<double> vtkInkLineArtRepresentation::GetUsedIsoValues()
{
  return vtkInkLineArtStyle::SafeDownCast(this->GetStyle())->GetIsoSurface()->GetUsedIsoValues();
}

void vtkInkLineArtRepresentation::SetMagnification(double) {}
