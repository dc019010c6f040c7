// SPDX-License-Identifier: BSD-3-Clause
#ifndef StyleErrors_h
#define StyleErrors_h

#include "vtkCallbackCommand.h"
#include "vtkInkStyle.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

/// All styles there are.
inline std::vector<vtkSmartPointer<vtkInkStyle>> MakeStyles()
{
  std::vector<vtkSmartPointer<vtkInkStyle>> styles;
  for (int i = 0; i < vtkInkStyle::GetNumberOfStyles(); ++i)
  {
    styles.push_back(vtk::TakeSmartPointer(vtkInkStyle::CreateStyle(vtkInkStyle::GetStyleName(i))));
  }
  return styles;
}

/// What an object reports as errors.
class StyleErrors
{
public:
  explicit StyleErrors(vtkObject* object)
    : Object(object)
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(this);
    command->SetCallback([](vtkObject*, unsigned long, void* self, void* text)
      { static_cast<StyleErrors*>(self)->All.emplace_back(static_cast<const char*>(text)); });
    this->Observer = object->AddObserver(vtkCommand::ErrorEvent, command);
  }
  ~StyleErrors() { this->Object->RemoveObserver(this->Observer); }
  StyleErrors(const StyleErrors&) = delete;
  void operator=(const StyleErrors&) = delete;

  std::vector<std::string> All;

private:
  const vtkSmartPointer<vtkObject> Object;
  unsigned long Observer;
};

#endif
