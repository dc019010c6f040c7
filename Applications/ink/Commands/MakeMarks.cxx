// SPDX-License-Identifier: BSD-3-Clause
#include "MakeMarks.h"

#include "Errors.h"
#include "Progress.h"
#include "VtkMessages.h"

#include "vtkCallbackCommand.h"
#include "vtkInkStyle.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <utility>

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

void makeMarks(vtkInkStyle* style, const vtkInkStyle::Input& input, std::vector<std::string>& notes,
  Progress& progress, const std::function<void()>& checkNone)
{
  const VtkMessages messages;
  const FollowedStyle followed(style, progress);
  const std::string problem = style->MakeMarks(input);
  // What reads a file in parts says itself that it cannot.
  const std::string error = messages.error();
  if (!problem.empty())
  {
    throw Failure(inTermsOfInk(error.empty() ? problem : error));
  }
  // What goes wrong inside of a style's algorithms is not theirs to tell.
  if (!error.empty())
  {
    throw Failure(std::string(style->GetLabel()) + ": " + error);
  }
  for (int i = 0; i < style->GetNumberOfNotes(); ++i)
  {
    notes.push_back(inTermsOfInk(style->GetNote(i)));
  }
  if (style->GetPiece(0)->GetNumberOfPoints() == 0)
  {
    if (checkNone)
    {
      checkNone();
    }
    throw Failure(notes.empty() ? "nothing to draw" : notes.back());
  }
}

std::string inTermsOfInk(const std::string& problem)
{
  std::string text = problem;
  const std::pair<const char*, const char*> words[] = { { "(MaximumMemory)", "(--memory)" },
    { "MaximumMemory", "--memory" }, { "less Smoothing", "less --smoothing" },
    { "ShapeBasedInterpolation off", "--shape-based-interpolation off" },
    { "Smoothing 0 asks", "--smoothing 0 asks" }, { "Subdivision 1 asks", "--subdivision 1 asks" },
    { "SeeThrough", "--see-through" }, { "or the style ", "or --style " } };
  for (const auto& [from, to] : words)
  {
    if (const std::size_t found = text.find(from); found != std::string::npos)
    {
      text.replace(found, std::string(from).size(), to);
    }
  }
  return text;
}

} // namespace ink::cli
