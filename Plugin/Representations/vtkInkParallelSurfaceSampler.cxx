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
  return this->Mesh->Take(input, this->GetNumberOfInputPorts(),
    [&](vtkInformationVector** whole) { return this->Superclass::RequestData(request, whole, output); });
}
