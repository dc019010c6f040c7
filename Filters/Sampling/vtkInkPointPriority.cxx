// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkPointPriority.h"

#include "InkPointCloud.h"
#include "InkReportException.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkInkPointPriority);

vtkInkPointPriority::vtkInkPointPriority() = default;
vtkInkPointPriority::~vtkInkPointPriority() = default;

int vtkInkPointPriority::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  return 1;
}

int vtkInkPointPriority::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPointSet* input = vtkPointSet::GetData(inputVector[0]);
  if (!input || input->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  InkPointCloudOptions options;
  options.Normals = this->EstimateNormals;
  options.Radius = this->EstimateRadius;
  options.Vertices = this->GenerateVertices;
  options.Seed = this->Seed;
  try
  {
    InkPreparePointCloud(input, options, this, vtkPolyData::GetData(outputVector));
  }
  catch (...)
  {
    InkReportException(this, vtkPolyData::GetData(outputVector), "The points cannot be ordered");
  }
  return 1;
}

void vtkInkPointPriority::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Seed: " << this->Seed << "\n"
     << indent << "EstimateNormals: " << this->EstimateNormals << "\n"
     << indent << "EstimateRadius: " << this->EstimateRadius << "\n"
     << indent << "GenerateVertices: " << this->GenerateVertices << "\n";
}
