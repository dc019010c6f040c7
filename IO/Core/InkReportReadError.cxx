// SPDX-License-Identifier: BSD-3-Clause
#include "InkReportReadError.h"

#include "InkReportException.h"
#include "ReadError.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkErrorCode.h"

unsigned long InkReportReadError(
  vtkAlgorithm* reader, vtkDataObject* output, const std::filesystem::path& file)
{
  try
  {
    throw;
  }
  catch (const ink::io::ReadAborted&)
  {
    if (output)
    {
      output->Initialize();
    }
    return vtkErrorCode::NoError;
  }
  catch (const ink::io::ReadError& error)
  {
    if (output)
    {
      output->Initialize();
    }
    vtkErrorWithObjectMacro(reader, << error.what() << ".");
    return vtkErrorCode::FileFormatError;
  }
  catch (...)
  {
    InkReportException(reader, output, "cannot read '" + file.string() + "'");
    return vtkErrorCode::UnknownError;
  }
}
