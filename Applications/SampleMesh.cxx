#include "SampleMesh.h"

#include "Errors.h"
#include "Progress.h"
#include "VtkMessages.h"

#include "vtkInkSurfaceSampler.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <utility>

namespace ink::cli
{

MeshSampler::MeshSampler(MeshSampling sampling, bool follow)
  : Wanted(std::move(sampling))
  , Sampler(vtkSmartPointer<vtkInkSurfaceSampler>::New())
{
  this->Sampler->SetFollowDeformation(follow);
}

vtkSmartPointer<vtkPolyData> MeshSampler::sample(
  vtkPolyData* mesh, std::vector<std::string>& notes, Progress& progress)
{
  const MeshSampling& sampling = this->Wanted;
  vtkInkSurfaceSampler* sampler = this->Sampler;
  const auto points = static_cast<long long>(mesh->GetNumberOfPoints());
  const bool isCloud = mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips() == 0;
  const long long count =
    sampling.count.value_or(std::clamp(2 * points, MeshSampling::leastCount, MeshSampling::mostCount));
  sampler->SetInputData(mesh);
  sampler->SetNumberOfSamples(count);
  if (sampling.radius)
  {
    sampler->SetAmountToSampleRadius();
    sampler->SetSampleRadius(*sampling.radius);
  }
  sampler->SetMethod(sampling.method.value_or(vtkInkSurfaceSampler::AUTOMATIC));
  sampler->SetSeed(sampling.seed);
  sampler->SetOutputPointsPrecision(sampling.precision);
  sampler->SetComputeNormals(sampling.normals);
  sampler->SetComputeRadius(sampling.radiusArray);
  sampler->SetComputePriority(sampling.priority);
  const CloudSampling& cloud = sampling.cloud;
  if (!isCloud && !cloud.given.empty())
  {
    throw UsageError(cloud.given + ": expected points without polygons, found a mesh");
  }
  sampler->SetNormalNeighbors(cloud.neighbors.value_or(sampler->GetNormalNeighbors()));
  if (cloud.viewpoint)
  {
    sampler->OrientTowardsViewpointOn();
    sampler->SetViewpoint(cloud.viewpoint->data());
  }
  progress.step(isCloud ? "looking at the points" : "sampling the mesh", sampler);
  const VtkMessages messages;
  sampler->Update();
  if (const std::string problem = messages.error(); !problem.empty())
  {
    throw Failure(problem);
  }
  // The sampler's own output is another mesh's when it is asked again.
  const auto samples = vtkSmartPointer<vtkPolyData>::New();
  samples->ShallowCopy(sampler->GetOutput());
  if (samples->GetNumberOfPoints() == 0)
  {
    throw Failure("no surface: no point was made on the mesh");
  }
  if (isCloud)
  {
    const bool estimated = sampling.normals && !mesh->GetPointData()->GetNormals();
    notes.push_back("the file has no polygons; its " + std::to_string(points) +
      " points are taken as they are" + (estimated ? ", with normals estimated from their neighbors" : ""));
    if (const vtkIdType isolated = sampler->GetNumberOfIsolatedPoints(); isolated > 0)
    {
      notes.push_back(std::to_string(isolated) + " points that are far from all others are left out");
    }
  }
  return samples;
}

} // namespace ink::cli
