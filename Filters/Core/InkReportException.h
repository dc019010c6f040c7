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

#endif
