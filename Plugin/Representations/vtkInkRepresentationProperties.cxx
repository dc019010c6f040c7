// SPDX-License-Identifier: BSD-3-Clause
// The properties of vtkInkRepresentation: the style's parameters by name, and the state of its actor and
// paper.
#include "vtkInkRepresentation.h"

#include "InkChosenScalars.h"
#include "vtkInkPaper.h"

#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkProperty.h"
#include "vtkSMViewProxy.h"
#include "vtkScalarsToColors.h"
#include "vtkTransform.h"

#include <string>

void vtkInkRepresentation::SetVisibility(bool visible)
{
  this->Style->GetActor()->SetVisibility(visible);
  this->Paper->SetVisible(visible);
  this->Superclass::SetVisibility(visible);
}

void vtkInkRepresentation::SetPaper(bool paper)
{
  this->Paper->SetFills(paper);
}

void vtkInkRepresentation::SetParameter(const char* name, double value)
{
  this->ChangeStyle([=](vtkInkStyle* style) { style->SetParameter(name, value); });
}

void vtkInkRepresentation::SetParameter(const char* name, double first, double second)
{
  this->ChangeStyle([=](vtkInkStyle* style) { style->SetParameter(name, first, second); });
}

void vtkInkRepresentation::SetParameter(const char* name, double first, double second, double third)
{
  this->ChangeStyle([=](vtkInkStyle* style) { style->SetParameter(name, first, second, third); });
  if (std::string(name) == "PaperColor")
  {
    this->Paper->SetColor(first, second, third);
  }
}

void vtkInkRepresentation::SetParameterAsString(const char* name, const char* text)
{
  this->ChangeStyle([=](vtkInkStyle* style) { style->SetParameterAsString(name, text); });
}

void vtkInkRepresentation::SelectScalars(int, int, int, int, const char* name)
{
  this->SetParameterAsString("Scalars", InkChosenScalars(name).c_str());
}

void vtkInkRepresentation::SetAutomaticIsoValue(bool automatic)
{
  this->IsoValue.Automatic = automatic;
  this->ApplyChoice("IsoValues", this->IsoValue);
}

void vtkInkRepresentation::SetIsoValue(double value)
{
  this->IsoValue.Value = value;
  this->ApplyChoice("IsoValues", this->IsoValue);
}

void vtkInkRepresentation::ApplyChoice(const char* parameter, const Choice& choice)
{
  this->ChangeStyle(
    [&](vtkInkStyle* style)
    {
      if (choice.Automatic)
      {
        style->SetParameterAsString(parameter, "");
      }
      else
      {
        style->SetParameter(parameter, choice.Value);
      }
    });
}

void vtkInkRepresentation::SetLookupTable(vtkScalarsToColors* table)
{
  this->Style->GetMapper()->SetLookupTable(table);
}

void vtkInkRepresentation::SetMapScalars(bool map)
{
  // How scalars become colors, which is not what colors the marks.
  this->Style->GetMapper()->SetColorMode(map ? VTK_COLOR_MODE_MAP_SCALARS : VTK_COLOR_MODE_DIRECT_SCALARS);
}

void vtkInkRepresentation::SetTransparentBackground(bool transparent)
{
  // ParaView's own knows it on the client only.
  vtkSMViewProxy::SetTransparentBackground(transparent);
}

void vtkInkRepresentation::SetPickable(bool pickable)
{
  this->Pickable = pickable;
  this->UpdatePickable();
}

void vtkInkRepresentation::SetOpacity(double opacity)
{
  this->Style->GetActor()->GetProperty()->SetOpacity(opacity);
}

void vtkInkRepresentation::SetPosition(double x, double y, double z)
{
  this->Style->GetActor()->SetPosition(x, y, z);
}

void vtkInkRepresentation::SetScale(double x, double y, double z)
{
  this->Style->GetActor()->SetScale(x, y, z);
}

void vtkInkRepresentation::SetOrientation(double x, double y, double z)
{
  this->Style->GetActor()->SetOrientation(x, y, z);
}

void vtkInkRepresentation::SetOrigin(double x, double y, double z)
{
  this->Style->GetActor()->SetOrigin(x, y, z);
}

void vtkInkRepresentation::SetUserTransform(const double matrix[16])
{
  vtkNew<vtkTransform> transform;
  transform->SetMatrix(matrix);
  this->Style->GetActor()->SetUserTransform(transform);
}
