// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkIllustrationRepresentation.h"

#include "vtkInkIllustrationStyle.h"

#include "vtkObjectFactory.h"
#include "vtkPVView.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkInkIllustrationRepresentation);

vtkInkIllustrationRepresentation::vtkInkIllustrationRepresentation()
  : vtkInkRepresentation(vtkSmartPointer<vtkInkIllustrationStyle>::New())
{
  this->SetProgressText("Making an illustration");
}

vtkInkIllustrationRepresentation::~vtkInkIllustrationRepresentation() = default;

void vtkInkIllustrationRepresentation::SetAutomaticIsoValue(bool automatic)
{
  this->AutomaticIsoValue = automatic;
  this->UpdateIsoValue();
}

void vtkInkIllustrationRepresentation::SetIsoValue(double value)
{
  this->IsoValue = value;
  this->UpdateIsoValue();
}

void vtkInkIllustrationRepresentation::UpdateIsoValue()
{
  this->ChangeStyle(
    [this](vtkInkStyle* style)
    {
      if (this->AutomaticIsoValue)
      {
        style->SetParameterAsString("IsoValues", "");
      }
      else
      {
        style->SetParameter("IsoValues", this->IsoValue);
      }
    });
}

int vtkInkIllustrationRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  auto view = vtkPVView::SafeDownCast(this->GetView());
  if (request == vtkPVView::REQUEST_UPDATE() && view)
  {
    // The same on all processes. Down, as data seldom fills the view and stipples grow better than they
    // shrink.
    const int pixels = std::max(view->GetSize()[0], view->GetSize()[1]);
    const double size = std::exp2(std::floor(std::log2(std::clamp(pixels, 256, 8192))));
    this->ChangeStyle(
      [=](vtkInkStyle* style)
      {
        style->SetPictureSize(size);
        // Sizes are relative to the height: the same stipples in a view of any size.
        style->SetPictureHeight(size);
      });
  }
  return this->Superclass::ProcessViewRequest(request, inInfo, outInfo);
}
