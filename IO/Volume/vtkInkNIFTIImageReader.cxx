// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkNIFTIImageReader.h"

#include "InkKeepRange.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"

vtkStandardNewMacro(vtkInkNIFTIImageReader);

int vtkInkNIFTIImageReader::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const int result = this->Superclass::RequestData(request, inputVector, outputVector);
  vtkDataArray* values = vtkImageData::GetData(outputVector)->GetPointData()->GetScalars();
  if (result && values)
  {
    InkKeepRange(values);
  }
  return result;
}
