// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkSplattingLinesMapper.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkInkSplattingLinesMapper);

vtkInkSplattingLinesMapper::vtkInkSplattingLinesMapper() = default;
vtkInkSplattingLinesMapper::~vtkInkSplattingLinesMapper() = default;

void vtkInkSplattingLinesMapper::RenderPiece(vtkRenderer*, vtkActor*) {}

void vtkInkSplattingLinesMapper::ReleaseGraphicsResources(vtkWindow*) {}

bool vtkInkSplattingLinesMapper::HasOpaqueGeometry()
{
  return this->PaperVisibility;
}

bool vtkInkSplattingLinesMapper::HasTranslucentPolygonalGeometry()
{
  return !this->PaperVisibility;
}

void vtkInkSplattingLinesMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
