// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkStippleRepresentation.h"

#include "InkCellCenters.h"
#include "InkIsoSurface.h"
#include "vtkInkEarlyFXAA.h"
#include "vtkInkStippleGenerator.h"
#include "vtkInkStippleStyle.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPVRenderView.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

vtkStandardNewMacro(vtkInkStippleRepresentation);

vtkInkStippleRepresentation::vtkInkStippleRepresentation()
  : vtkInkStippleRepresentation(vtkSmartPointer<vtkInkStippleStyle>::New())
{
}

vtkInkStippleRepresentation::vtkInkStippleRepresentation(vtkSmartPointer<vtkInkStippleStyle> style)
  : vtkInkRepresentation(style)
  , Style(style)
  , FXAA(std::make_unique<vtkInkEarlyFXAA>())
{
  this->FXAA->SetActive(this->GetVisibility());
  this->SetProgressText("Making stipples");
}

vtkInkStippleRepresentation::~vtkInkStippleRepresentation() = default;

bool vtkInkStippleRepresentation::AddToView(vtkView* view)
{
  if (auto renderView = vtkPVRenderView::SafeDownCast(view))
  {
    this->FXAA->Attach(renderView->GetRenderer());
  }
  return this->Superclass::AddToView(view);
}

bool vtkInkStippleRepresentation::RemoveFromView(vtkView* view)
{
  this->FXAA->Detach();
  return this->Superclass::RemoveFromView(view);
}

void vtkInkStippleRepresentation::SetVisibility(bool visible)
{
  this->FXAA->SetActive(visible);
  this->Superclass::SetVisibility(visible);
}

int vtkInkStippleRepresentation::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
  if (inputVector[0]->GetNumberOfInformationObjects() == 1)
  {
    using SDDP = vtkStreamingDemandDrivenPipeline;
    vtkInformation* info = inputVector[0]->GetInformationObject(0);
    // As the generator asks for them; of grids as many as tell the outer surface.
    const int ofGrids = vtkPolyData::GetData(info) ? 0 : 1;
    vtkImageData* image = vtkImageData::GetData(info);
    const InkIsoSurface& values = *this->Style->GetIsoSurface();
    const int ofCells = image && InkTakesCells(image, values.GetScalars()) ? 1 : 0;
    const int levels =
      image ? vtkInkStippleGenerator::GetGhostLevels(values.GetSmoothing()) + ofCells : ofGrids;
    info->Set(SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS(),
      std::max(levels, info->Get(SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS())));
  }
  return 1;
}

std::string vtkInkStippleRepresentation::MakeMarks(const vtkInkStyle::Input& input)
{
  this->Style->SetColorArray(this->GetColorArray(), this->GetColorAssociation());
  std::string problem = this->Superclass::MakeMarks(input);
  if (this->Style->GetIdsAreInputs())
  {
    this->MarkIdsAsInputs();
  }
  return problem;
}

bool vtkInkStippleRepresentation::ServesFor(const std::string& name, int association)
{
  return name == this->Style->GetMadeColorArray() && association == this->Style->GetMadeColorAssociation();
}

void vtkInkStippleRepresentation::SetMagnification(double) {}

void vtkInkStippleRepresentation::SetPictureSize(double pixels)
{
  this->ChangeStyle([=](vtkInkStyle* style) { style->SetPictureSize(std::clamp(pixels, 100.0, 100000.0)); });
}
