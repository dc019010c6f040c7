// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkLineArtRepresentation.h"

#include "vtkInkLineArtStyle.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkInkLineArtRepresentation);

vtkInkLineArtRepresentation::vtkInkLineArtRepresentation()
  : vtkInkContoursRepresentation(vtkSmartPointer<vtkInkLineArtStyle>::New())
{
  this->SetProgressText("Making line art");
}

vtkInkLineArtRepresentation::~vtkInkLineArtRepresentation() = default;
