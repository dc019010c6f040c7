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
  return this->Mesh->Take(input, this->GetNumberOfInputPorts(),
    [&](vtkInformationVector** whole) { return this->Superclass::RequestData(request, whole, output); });
}
