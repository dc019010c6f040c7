// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkReportReadError_h
#define InkReportReadError_h

#include "vtkInkIOCoreModule.h" // for the export macro

#include <filesystem>

class vtkAlgorithm;
class vtkDataObject;

/// In a `catch (...)` around what a reader does in answer to a request: makes a ReadError, or whatever else
/// it is, one error of the reader that names the file, and empties the output. Nothing is said of a
/// ReadAborted.
/// @param output may be null
/// @return the error code for the reader, as vtkErrorCode::FileFormatError
VTKINKIOCORE_EXPORT unsigned long InkReportReadError(
  vtkAlgorithm* reader, vtkDataObject* output, const std::filesystem::path& file);

#endif
