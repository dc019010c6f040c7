// SPDX-License-Identifier: BSD-3-Clause
#include "InkFrame.h"

#include "vtkHardwareSelector.h"
#include "vtkShaderProgram.h"

#include <algorithm>

InkIdColors::InkIdColors(vtkHardwareSelector* selector)
{
  switch (selector->GetCurrentPass())
  {
    case vtkHardwareSelector::POINT_ID_LOW24:
      this->Shift = 0;
      break;
    case vtkHardwareSelector::POINT_ID_HIGH24:
      this->Shift = 24;
      break;
    case vtkHardwareSelector::CELL_ID_LOW24:
    case vtkHardwareSelector::CELL_ID_HIGH24:
      break;
    default:
      std::copy_n(selector->GetPropColorValue(), 3, this->Prop.begin());
      break;
  }
}

void InkIdColors::SetUniforms(vtkShaderProgram* program) const
{
  program->SetUniformi("idShift", this->Shift);
  program->SetUniform3f("propColor", this->Prop.data());
}

void InkFrame::SetOrigin(vtkShaderProgram* program) const
{
  const float origin[2] = { static_cast<float>(this->Viewport[0]), static_cast<float>(this->Viewport[1]) };
  program->SetUniform2f("viewportOrigin", origin);
}
