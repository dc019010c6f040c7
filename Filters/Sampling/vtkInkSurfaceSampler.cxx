// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkSurfaceSampler.h"

#include "InkMeshTriangles.h"
#include "InkPointCloud.h"
#include "InkPointOutput.h"
#include "InkSurfaceSamples.h"
#include "InkVTKCompat.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <new>
#include <stdexcept>
#include <string>

vtkStandardNewMacro(vtkInkSurfaceSampler);

vtkInkSurfaceSampler::vtkInkSurfaceSampler()
{
  this->SetNumberOfInputPorts(2);
}

vtkInkSurfaceSampler::~vtkInkSurfaceSampler() = default;

void vtkInkSurfaceSampler::SetFirstFrameData(vtkPolyData* samples)
{
  this->SetInputData(1, samples);
}

int vtkInkSurfaceSampler::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

int vtkInkSurfaceSampler::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* mesh = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* firstFrame =
    this->GetNumberOfInputConnections(1) > 0 ? vtkPolyData::GetData(inputVector[1]) : nullptr;
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  this->NumberOfIsolatedPoints = 0;
  // A piece, or a time step, of nothing is no error.
  if (!mesh || mesh->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  try
  {
    if (mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips() == 0)
    {
      InkPointCloudOptions options;
      options.Normals = this->ComputeNormals;
      options.NormalNeighbours = this->NormalNeighbours;
      options.Viewpoint = this->OrientTowardsViewpoint ? this->Viewpoint : nullptr;
      options.UniformRadius = this->UniformRadius;
      options.RemoveIsolated = this->RemoveIsolated;
      options.Radius = this->ComputeRadius;
      options.Priority = this->ComputePriority;
      options.Vertices = this->GenerateVertices;
      options.Seed = this->Seed;
      this->NumberOfIsolatedPoints = InkPreparePointCloud(mesh, options, this, output);
    }
    else if (firstFrame)
    {
      this->MoveSamples(mesh, firstFrame, output);
    }
    else
    {
      this->SampleMesh(mesh, output);
    }
  }
  catch (const std::invalid_argument& error)
  {
    vtkErrorMacro("The mesh cannot be sampled: " << error.what() << ".");
    output->Initialize();
  }
  catch (const std::bad_alloc&)
  {
    vtkErrorMacro("The mesh cannot be sampled: there is not enough memory for its samples.");
    output->Initialize();
  }
  return 1;
}

void vtkInkSurfaceSampler::SampleMesh(vtkPolyData* mesh, vtkPolyData* output)
{
  InkMeshTriangles triangles(mesh, this->ComputeNormals || this->ComputePriority);
  const char* chosen = this->GetInputArrayInformation(0)->Get(vtkDataObject::FIELD_NAME());
  // ParaView's panel gives "None".
  if (chosen && *chosen && std::string(chosen) != "None")
  {
    const int association = this->GetInputArrayInformation(0)->Get(vtkDataObject::FIELD_ASSOCIATION());
    triangles.SetDensity(
      InkGetDensity(mesh, chosen, association), association == vtkDataObject::FIELD_ASSOCIATION_CELLS);
  }
  InkSampleRequest request;
  request.BlueNoise = this->Method == BLUE_NOISE;
  request.ByRadius = this->Amount == SAMPLE_RADIUS;
  request.Count = static_cast<std::size_t>(this->NumberOfSamples);
  request.Radius = this->SampleRadius;
  request.Gap = this->Gap;
  request.Priority = this->ComputePriority;
  request.Seed = this->Seed;
  request.Progress = [this](double done)
  {
    this->UpdateProgress(done);
    return !InkCheckAbort(this);
  };
  const InkSurfaceSamples samples(triangles, request);

  const int type = this->OutputPointsPrecision == DEFAULT_PRECISION ? mesh->GetPoints()->GetDataType()
    : this->OutputPointsPrecision == DOUBLE_PRECISION               ? VTK_DOUBLE
                                                                    : VTK_FLOAT;
  output->SetPoints(samples.MakePoints(type));
  const vtkIdType count = output->GetNumberOfPoints();
  vtkPointData* pointData = output->GetPointData();
  if (this->ComputeNormals)
  {
    pointData->SetNormals(samples.MakeNormals());
  }
  if (this->ComputeRadius)
  {
    pointData->AddArray(samples.MakeRadius(output->GetPoints()->GetDataType()));
  }
  if (this->ComputePriority)
  {
    pointData->AddArray(InkMakePriority(count));
  }
  if (this->KeepFaces)
  {
    samples.AddFaces(mesh, output);
  }
  if (this->GenerateVertices)
  {
    output->SetVerts(InkMakePolyVertex(count));
  }
}

void vtkInkSurfaceSampler::MoveSamples(vtkPolyData* mesh, vtkPolyData* samples, vtkPolyData* output)
{
  InkMoveSamples(mesh, samples, this->ComputeNormals,
    this->OutputPointsPrecision == DEFAULT_PRECISION    ? mesh->GetPoints()->GetDataType()
      : this->OutputPointsPrecision == DOUBLE_PRECISION ? VTK_DOUBLE
                                                        : VTK_FLOAT,
    output);
  output->SetVerts(this->GenerateVertices ? InkMakePolyVertex(output->GetNumberOfPoints()).Get() : nullptr);
}

void vtkInkSurfaceSampler::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << (this->Method == BLUE_NOISE ? "BLUE_NOISE" : "WHITE_NOISE") << "\n"
     << indent << "Amount: " << (this->Amount == SAMPLE_RADIUS ? "SAMPLE_RADIUS" : "NUMBER_OF_SAMPLES")
     << "\n"
     << indent << "NumberOfSamples: " << this->NumberOfSamples << "\n"
     << indent << "SampleRadius: " << this->SampleRadius << "\n"
     << indent << "Gap: " << this->Gap << "\n"
     << indent << "Seed: " << this->Seed << "\n"
     << indent << "ComputeNormals: " << this->ComputeNormals << "\n"
     << indent << "ComputeRadius: " << this->ComputeRadius << "\n"
     << indent << "ComputePriority: " << this->ComputePriority << "\n"
     << indent << "KeepFaces: " << this->KeepFaces << "\n"
     << indent << "NormalNeighbours: " << this->NormalNeighbours << "\n"
     << indent << "OrientTowardsViewpoint: " << this->OrientTowardsViewpoint << "\n"
     << indent << "Viewpoint: " << this->Viewpoint[0] << " " << this->Viewpoint[1] << " "
     << this->Viewpoint[2] << "\n"
     << indent << "UniformRadius: " << this->UniformRadius << "\n"
     << indent << "RemoveIsolated: " << this->RemoveIsolated << "\n"
     << indent << "NumberOfIsolatedPoints: " << this->NumberOfIsolatedPoints << "\n"
     << indent << "GenerateVertices: " << this->GenerateVertices << "\n"
     << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
}
