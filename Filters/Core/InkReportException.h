// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkReportException_h
#define InkReportException_h

#include "vtkInkFiltersCoreModule.h" // for the export macro

#include <string>

class vtkAlgorithm;
class vtkDataObject;

/// To be called in a `catch (...)` around a filter's RequestData: reports the exception as one error of the
/// filter, "<failure>: <reason>.", and empties the output, so that a failure of one filter (usually out of
/// memory) terminates neither the pipeline nor the program.
/// @param failure what failed, as a clause: "The image cannot be sampled"
/// @param output may be null
VTKINKFILTERSCORE_EXPORT void InkReportException(
  vtkAlgorithm* filter, vtkDataObject* output, const std::string& failure);

/// What VTK's error macros add to a text taken away: file, line, class and address before it, and newlines
/// and the dot at its end.
/// @param message as observers of an ErrorEvent get it
VTKINKFILTERSCORE_EXPORT std::string InkTextOfMessage(const char* message);

#endif
