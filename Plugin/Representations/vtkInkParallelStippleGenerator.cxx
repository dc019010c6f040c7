// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkParallelStippleGenerator.h"

#include "vtkInkWholeMesh.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkInkParallelStippleGenerator);

vtkInkParallelStippleGenerator::vtkInkParallelStippleGenerator()
  : Mesh(std::make_unique<vtkInkWholeMesh>())
{
}

vtkInkParallelStippleGenerator::~vtkInkParallelStippleGenerator() = default;

int vtkInkParallelStippleGenerator::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  this->Mesh->LookAt(request, input);
  return this->Superclass::RequestUpdateExtent(request, input, output);
}

int vtkInkParallelStippleGenerator::RequestData(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkInformationVector** whole = this->Mesh->Gather(input, this->GetNumberOfInputPorts());
  const int result = this->Superclass::RequestData(request, whole, output);
  this->Mesh->Release();
  return result;
}
