// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkParallelSurfaceSampler.h"

#include "vtkInkWholeMesh.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkInkParallelSurfaceSampler);

vtkInkParallelSurfaceSampler::vtkInkParallelSurfaceSampler()
  : Mesh(std::make_unique<vtkInkWholeMesh>())
{
}

vtkInkParallelSurfaceSampler::~vtkInkParallelSurfaceSampler() = default;

int vtkInkParallelSurfaceSampler::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  this->Mesh->LookAt(request, input);
  return this->Superclass::RequestUpdateExtent(request, input, output);
}

int vtkInkParallelSurfaceSampler::RequestData(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkInformationVector** whole = this->Mesh->Gather(input, this->GetNumberOfInputPorts());
  const int result = this->Superclass::RequestData(request, whole, output);
  this->Mesh->Release();
  return result;
}
