// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkInkIOCoreModule.h" // for the export macro

#include "vtkSmartPointer.h"

#include <memory>
#include <string>

class vtkOutputWindow;

namespace ink
{

/// "ERROR: In file.cxx, line 7\nvtkReader (0x55d0): what happened.\n\n" to "what happened".
VTKINKIOCORE_EXPORT std::string plainMessage(const std::string& message);

/// Catches what VTK and the libraries in it print while this object lives, so that it can be said in one
/// line: errors and warnings sent to vtkOutputWindow, and text written to std::cerr (MetaIO reports there).
/// It replaces the one vtkOutputWindow, so another thread that makes one waits until this one is gone. To be
/// destroyed by the thread that made it.
class VTKINKIOCORE_EXPORT VtkMessages
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

} // namespace ink
