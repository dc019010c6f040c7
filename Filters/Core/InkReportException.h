// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkReportException_h
#define InkReportException_h

#include "vtkInkFiltersCoreModule.h" // for the export macro

#include <string>

class vtkAlgorithm;
class vtkDataObject;

/// In a `catch (...)` around what a filter does in answer to a request: makes the exception one error of the
/// filter, "<failure>: <reason>.", and empties the output, so that what one filter lacks (memory, as a rule)
/// ends neither the pipeline nor the program.
/// @param failure what did not work, as a clause: "The image cannot be sampled"
/// @param output  may be null
VTKINKFILTERSCORE_EXPORT void InkReportException(
  vtkAlgorithm* filter, vtkDataObject* output, const std::string& failure);

#endif
