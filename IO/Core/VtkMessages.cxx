// SPDX-License-Identifier: BSD-3-Clause
#include "VtkMessages.h"

#include "Pattern.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"

#include <iostream>
#include <mutex>
#include <sstream>

namespace ink
{
namespace
{

class CatchingWindow : public vtkOutputWindow
{
public:
  static CatchingWindow* New();
  vtkTypeMacro(CatchingWindow, vtkOutputWindow);

  void DisplayText(const char*) override {}
  void DisplayDebugText(const char*) override {}
  void DisplayErrorText(const char* message) override { keepFirst(this->Error, message); }
  void DisplayWarningText(const char*) override {}
  void DisplayGenericWarningText(const char*) override {}

  std::string Error;

protected:
  CatchingWindow() = default;

private:
  static void keepFirst(std::string& kept, const char* message)
  {
    if (kept.empty())
    {
      kept = plainMessage(message ? message : "");
    }
  }
};
vtkStandardNewMacro(CatchingWindow);

/// Of a whole process are the window and the stream. Recursive, as what catches may call what does.
std::recursive_mutex& catching()
{
  static std::recursive_mutex mutex;
  return mutex;
}

} // namespace

std::string plainMessage(const std::string& message)
{
  static const io::Pattern position(R"(^\s*(ERROR|Warning|Generic Warning): In [^\n]*, line \d+\s*)");
  static const io::Pattern object(R"(^\s*\w+ \((0x)?[0-9a-fA-F]+\): )");
  // Spaces within a line may be those of a file's name.
  static const io::Pattern lineEnds(R"(\s*\n\s*)");
  const std::string text = lineEnds.replace(object.replace(position.replace(message, ""), ""), " ");
  const auto first = text.find_first_not_of(" \t");
  const auto last = text.find_last_not_of(" \t.");
  return first == std::string::npos || last == std::string::npos ? "" : text.substr(first, last - first + 1);
}

struct VtkMessages::Caught
{
  std::unique_lock<std::recursive_mutex> Alone{ catching() };
  vtkSmartPointer<CatchingWindow> Window = vtkSmartPointer<CatchingWindow>::New();
  std::ostringstream Stream;
  std::streambuf* PreviousBuffer = nullptr;
};

VtkMessages::VtkMessages()
  : Messages(std::make_unique<Caught>())
  , PreviousWindow(vtkOutputWindow::GetInstance())
{
  vtkOutputWindow::SetInstance(this->Messages->Window);
  this->Messages->PreviousBuffer = std::cerr.rdbuf(this->Messages->Stream.rdbuf());
}

VtkMessages::~VtkMessages()
{
  std::cerr.rdbuf(this->Messages->PreviousBuffer);
  vtkOutputWindow::SetInstance(this->PreviousWindow);
}

std::string VtkMessages::error() const
{
  return this->Messages->Window->Error.empty() ? plainMessage(this->Messages->Stream.str())
                                               : this->Messages->Window->Error;
}

} // namespace ink
