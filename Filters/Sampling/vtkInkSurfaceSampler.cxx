// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkSurfaceSampler.h"

#include "InkFeatureNormals.h"
#include "InkHasPolygons.h"
#include "InkMeshTriangles.h"
#include "InkNotFiniteFaces.h"
#include "InkPointCloud.h"
#include "InkPointOutput.h"
#include "InkPrecision.h"
#include "InkReportException.h"
#include "InkSampleDensity.h"
#include "InkSampleFaces.h"
#include "InkSurfaceOf.h"
#include "InkSurfaceSamples.h"
#include "InkVTKCompat.h"

#include "vtkDataObject.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <sstream>
#include <string>

namespace
{

// The number of samples from which AUTOMATIC uses white noise.
constexpr vtkIdType WhiteNoiseFrom = 500'000;

// How far edges are looked for: somewhat farther than the discs of lines reach.
constexpr double EdgeReach = 4.0;

bool HasTimeSteps(vtkInformation* info)
{
  return info->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS()) > 0;
}

} // namespace

vtkStandardNewMacro(vtkInkSurfaceSampler);

vtkInkSurfaceSampler::vtkInkSurfaceSampler()
{
  this->SetNumberOfInputPorts(2);
}

vtkInkSurfaceSampler::~vtkInkSurfaceSampler() = default;

const char* vtkInkSurfaceSampler::GetMethodAsString()
{
  switch (this->Method)
  {
    case WHITE_NOISE:
      return "WhiteNoise";
    case BLUE_NOISE:
      return "BlueNoise";
    case PROGRESSIVE_BLUE_NOISE:
      return "ProgressiveBlueNoise";
    default:
      return "Automatic";
  }
}

const char* vtkInkSurfaceSampler::GetAmountAsString()
{
  return this->Amount == SAMPLE_RADIUS ? "SampleRadius" : "NumberOfSamples";
}

const char* vtkInkSurfaceSampler::GetOutputPointsPrecisionAsString()
{
  return InkNameOfPrecision(this->OutputPointsPrecision);
}

void vtkInkSurfaceSampler::SetFirstFrameData(vtkPolyData* samples)
{
  this->SetInputData(1, samples);
}

int vtkInkSurfaceSampler::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPointSet" : "vtkPolyData");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

vtkMTimeType vtkInkSurfaceSampler::GetUpstreamMTime()
{
  // Without this filter's own, which does not grow with the input's changes.
  auto* upstream = this->GetNumberOfInputConnections(0) > 0
    ? vtkDemandDrivenPipeline::SafeDownCast(this->GetInputExecutive(0, 0))
    : nullptr;
  return upstream ? upstream->GetPipelineMTime() : 0;
}

std::string vtkInkSurfaceSampler::DescribeSampling()
{
  // Not the modification time, which also grows when the input is set, as in programs that deform meshes
  // themselves.
  vtkInformation* density = this->GetInputArrayInformation(0);
  const char* name = density->Get(vtkDataObject::FIELD_NAME());
  std::ostringstream all;
  all << std::hexfloat << this->Method << ' ' << this->Amount << ' ' << this->NumberOfSamples << ' '
      << this->SampleRadius << ' ' << this->CoverageSlack << ' ' << this->Seed << ' ' << this->ComputeNormals
      << ' ' << this->ComputeRadius << ' ' << this->ComputePriority << ' ' << this->ComputeEdgeOffsets << ' '
      << density->Get(vtkDataObject::FIELD_ASSOCIATION()) << ' ' << (name ? name : "");
  return all.str();
}

bool vtkInkSurfaceSampler::HasFirstSamples(vtkInformation* inputInfo)
{
  // Without time steps, changes of the input are followed.
  const bool sameSeries = !HasTimeSteps(inputInfo) || this->SampledUpstream == this->GetUpstreamMTime();
  return this->FirstSamples && this->SampledAs == this->DescribeSampling() && sameSeries;
}

bool vtkInkSurfaceSampler::HasSamplesOfFaces(vtkPolyData* mesh)
{
  const auto fit = [mesh](vtkPolyData* samples) { return samples && InkAreSamplesOf(samples, mesh); };
  return this->FollowDeformation && mesh && (fit(this->FirstSamples) || fit(this->LaterSamples));
}

int vtkInkSurfaceSampler::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
  vtkInformation* input = inputVector[0]->GetInformationObject(0);
  vtkInformation* output = outputVector->GetInformationObject(0);
  this->AtFirstStep = false;
  if (!this->FollowDeformation || this->GetNumberOfInputConnections(1) > 0 || !HasTimeSteps(input))
  {
    return 1;
  }
  this->AtFirstStep = !this->TriedFirstStep && !this->HasFirstSamples(input);
  if (this->AtFirstStep)
  {
    input->Set(Pipeline::UPDATE_TIME_STEP(), input->Get(Pipeline::TIME_STEPS())[0]);
  }
  else if (output->Has(Pipeline::UPDATE_TIME_STEP()))
  {
    input->Set(Pipeline::UPDATE_TIME_STEP(), output->Get(Pipeline::UPDATE_TIME_STEP()));
  }
  else
  {
    // The first step was requested last; no particular time is requested now.
    input->Remove(Pipeline::UPDATE_TIME_STEP());
  }
  return 1;
}

void vtkInkSurfaceSampler::FollowMesh(vtkInformation* request, vtkInformation* inputInfo,
  vtkInformation* outputInfo, vtkPolyData* mesh, vtkPolyData* output)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  const bool hasFaces = InkHasPolygons(mesh);
  const auto sample = [&]
  {
    auto samples = vtkSmartPointer<vtkPolyData>::New();
    if (hasFaces)
    {
      this->SampleMesh(mesh, samples, true);
    }
    return samples;
  };
  if (this->AtFirstStep || !this->HasFirstSamples(inputInfo))
  {
    this->FirstSamples = nullptr;
    this->LaterSamples = nullptr;
    this->FirstSamples = sample();
    // Sampling may have been aborted.
    const bool valid = !hasFaces || this->FirstSamples->GetNumberOfPoints() > 0;
    this->SampledAs = valid ? this->DescribeSampling() : std::string();
    this->SampledUpstream = this->GetUpstreamMTime();
  }
  if (this->AtFirstStep)
  {
    this->AtFirstStep = false;
    const double first = inputInfo->Get(Pipeline::TIME_STEPS())[0];
    if (outputInfo->Has(Pipeline::UPDATE_TIME_STEP()) &&
      outputInfo->Get(Pipeline::UPDATE_TIME_STEP()) != first)
    {
      this->TriedFirstStep = true;
      request->Set(Pipeline::CONTINUE_EXECUTING(), 1);
      return;
    }
  }
  if (!hasFaces)
  {
    return;
  }
  if (!this->HasSamplesOfFaces(mesh))
  {
    // Without time steps, the first mesh is never requested again.
    const bool temporal = HasTimeSteps(inputInfo);
    (temporal ? this->LaterSamples : this->FirstSamples) = sample();
  }
  this->MoveSamples(
    mesh, InkAreSamplesOf(this->FirstSamples, mesh) ? this->FirstSamples : this->LaterSamples, output);
  if (!this->KeepFaces)
  {
    InkRemoveFaces(output);
  }
}

int vtkInkSurfaceSampler::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPointSet* input = vtkPointSet::GetData(inputVector[0]);
  vtkPolyData* firstFrame =
    this->GetNumberOfInputConnections(1) > 0 ? vtkPolyData::GetData(inputVector[1]) : nullptr;
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  this->NumberOfIsolatedPoints = 0;
  request->Remove(vtkStreamingDemandDrivenPipeline::CONTINUE_EXECUTING());
  this->TriedFirstStep = false;
  if (!input)
  {
    return 1;
  }
  try
  {
    const vtkSmartPointer<vtkPolyData> mesh = InkSurfaceOf(input);
    const bool follows =
      this->FollowDeformation && !firstFrame && (InkHasPolygons(mesh) || this->AtFirstStep);
    // An empty piece or time step is not an error.
    if (mesh->GetNumberOfPoints() == 0 && !follows)
    {
      return 1;
    }
    if (follows)
    {
      this->FollowMesh(request, inputVector[0]->GetInformationObject(0),
        outputVector->GetInformationObject(0), mesh, output);
    }
    if (request->Has(vtkStreamingDemandDrivenPipeline::CONTINUE_EXECUTING()) ||
      mesh->GetNumberOfPoints() == 0)
    {
      return 1;
    }
    if (!InkHasPolygons(mesh))
    {
      InkPointCloudOptions options;
      options.Normals = this->ComputeNormals;
      options.NormalNeighbors = this->NormalNeighbors;
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
    else if (!follows)
    {
      this->SampleMesh(mesh, output, this->KeepFaces);
    }
  }
  catch (...)
  {
    InkReportException(this, output, "The mesh cannot be sampled");
  }
  return 1;
}

void vtkInkSurfaceSampler::SampleMesh(vtkPolyData* input, vtkPolyData* output, bool keepFaces)
{
  ++this->NumberOfSamplings;
  const char* chosen = this->GetInputArrayInformation(0)->Get(vtkDataObject::FIELD_NAME());
  // ParaView's panel gives "None".
  const bool hasDensity = chosen && *chosen && std::string(chosen) != "None";
  const int association = this->GetInputArrayInformation(0)->Get(vtkDataObject::FIELD_ASSOCIATION());
  vtkDataArray* density = hasDensity ? InkGetDensity(input, chosen, association) : nullptr;
  // Samples that are to be moved with the mesh keep its own points.
  const vtkSmartPointer<vtkPolyData> mesh =
    this->ComputeNormals && !keepFaces ? InkWithFeatureNormals(input) : vtkSmartPointer<vtkPolyData>(input);
  InkMeshTriangles triangles(mesh, this->ComputeNormals || this->ComputePriority);
  if (density)
  {
    density = InkGetDensity(mesh, chosen, association);
    triangles.SetDensity(density, association == vtkDataObject::FIELD_ASSOCIATION_CELLS);
  }
  InkSampleRequest request;
  request.ByRadius = this->Amount == SAMPLE_RADIUS;
  const bool many = !request.ByRadius && this->NumberOfSamples >= WhiteNoiseFrom;
  const int method = this->Method != AUTOMATIC ? this->Method : many ? WHITE_NOISE : BLUE_NOISE;
  request.Noise = method == WHITE_NOISE ? InkNoise::White
    : method == BLUE_NOISE              ? InkNoise::Blue
                                        : InkNoise::Progressive;
  request.Count = static_cast<std::size_t>(this->NumberOfSamples);
  request.Radius = this->SampleRadius;
  request.CoverageSlack = this->CoverageSlack;
  request.Priority = this->ComputePriority;
  request.Seed = this->Seed;
  request.Progress = [this](double done)
  {
    this->UpdateProgress(done);
    return !InkCheckAbort(this);
  };
  const InkSurfaceSamples samples(triangles, request);
  InkWarnOfNotFiniteFaces(this, mesh);
  const std::string unusable = density ? InkDescribeUnusableDensity(density) : "";
  if (!unusable.empty())
  {
    vtkWarningMacro("Of the " << density->GetNumberOfTuples() << " values of the density \"" << chosen
                              << "\" there are " << unusable
                              << ". Nothing is sampled there; expected 0 or more.");
  }

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
  if (this->ComputeEdgeOffsets && this->ComputeNormals && count > 0)
  {
    if (const vtkSmartPointer<vtkDataArray> offsets = samples.MakeEdgeOffsets(EdgeReach))
    {
      pointData->AddArray(offsets);
    }
  }
  if (keepFaces)
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
  os << indent << "Method: " << this->GetMethodAsString() << "\n"
     << indent << "Amount: " << this->GetAmountAsString() << "\n"
     << indent << "NumberOfSamples: " << this->NumberOfSamples << "\n"
     << indent << "SampleRadius: " << this->SampleRadius << "\n"
     << indent << "CoverageSlack: " << this->CoverageSlack << "\n"
     << indent << "Seed: " << this->Seed << "\n"
     << indent << "ComputeNormals: " << this->ComputeNormals << "\n"
     << indent << "ComputeRadius: " << this->ComputeRadius << "\n"
     << indent << "ComputePriority: " << this->ComputePriority << "\n"
     << indent << "ComputeEdgeOffsets: " << this->ComputeEdgeOffsets << "\n"
     << indent << "KeepFaces: " << this->KeepFaces << "\n"
     << indent << "FollowDeformation: " << this->FollowDeformation << "\n"
     << indent << "NumberOfSamplings: " << this->NumberOfSamplings << "\n"
     << indent << "NormalNeighbors: " << this->NormalNeighbors << "\n"
     << indent << "OrientTowardsViewpoint: " << this->OrientTowardsViewpoint << "\n"
     << indent << "Viewpoint: " << this->Viewpoint[0] << " " << this->Viewpoint[1] << " "
     << this->Viewpoint[2] << "\n"
     << indent << "UniformRadius: " << this->UniformRadius << "\n"
     << indent << "RemoveIsolated: " << this->RemoveIsolated << "\n"
     << indent << "NumberOfIsolatedPoints: " << this->NumberOfIsolatedPoints << "\n"
     << indent << "GenerateVertices: " << this->GenerateVertices << "\n"
     << indent << "OutputPointsPrecision: " << this->GetOutputPointsPrecisionAsString() << "\n";
}
