// SPDX-License-Identifier: BSD-3-Clause
#include "MakeMarks.h"

#include "Errors.h"
#include "Progress.h"
#include "VtkMessages.h"

#include "vtkCallbackCommand.h"
#include "vtkInkStyle.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

namespace ink::cli
{
namespace
{

/// Shows what a style does while it makes its marks.
class FollowedStyle
{
public:
  FollowedStyle(vtkInkStyle* style, Progress& progress)
    : Style(style)
    , Shown(progress)
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(this);
    command->SetCallback(
      [](vtkObject*, unsigned long, void* self, void*) { static_cast<FollowedStyle*>(self)->show(); });
    this->Observer = style->AddObserver(vtkCommand::ProgressEvent, command);
  }
  ~FollowedStyle() { this->Style->RemoveObserver(this->Observer); }
  FollowedStyle(const FollowedStyle&) = delete;
  FollowedStyle& operator=(const FollowedStyle&) = delete;

private:
  void show()
  {
    if (this->Step != this->Style->GetProgressText())
    {
      this->Step = this->Style->GetProgressText();
      this->Shown.step(this->Step);
    }
    this->Shown.at(this->Style->GetProgress());
  }

  vtkInkStyle* const Style;
  Progress& Shown;
  unsigned long Observer;
  std::string Step;
};

} // namespace

void makeMarks(vtkInkStyle* style, vtkDataObject* data, std::vector<std::string>& notes, Progress& progress)
{
  const VtkMessages messages;
  const FollowedStyle followed(style, progress);
  if (const std::string problem = style->MakeMarks({ data }); !problem.empty())
  {
    throw Failure(problem);
  }
  // What goes wrong inside of a style's algorithms is not theirs to tell.
  if (const std::string error = messages.error(); !error.empty())
  {
    throw Failure(std::string(style->GetLabel()) + ": " + error);
  }
  for (int i = 0; i < style->GetNumberOfNotes(); ++i)
  {
    notes.emplace_back(style->GetNote(i));
  }
  if (style->GetPiece(0)->GetNumberOfPoints() == 0)
  {
    throw Failure(notes.empty() ? "nothing to draw" : notes.back());
  }
}

} // namespace ink::cli
