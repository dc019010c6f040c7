#pragma once

#include "vtkSmartPointer.h"

#include <memory>
#include <string>

class vtkOutputWindow;

namespace ink::cli
{

/// Catches what VTK and the libraries in it print while this object lives, so that `ink` can say it in its
/// own one line: errors and warnings sent to vtkOutputWindow, and text written to std::cerr (MetaIO reports
/// there).
class VtkMessages
{
public:
  VtkMessages();
  ~VtkMessages();
  VtkMessages(const VtkMessages&) = delete;
  VtkMessages& operator=(const VtkMessages&) = delete;

  /// The first error, on one line and without VTK's source positions and addresses; empty if there was none.
  std::string error() const;

private:
  struct Caught;
  std::unique_ptr<Caught> Messages;
  vtkSmartPointer<vtkOutputWindow> PreviousWindow;
};

} // namespace ink::cli
