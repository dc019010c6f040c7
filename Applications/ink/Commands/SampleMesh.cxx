// SPDX-License-Identifier: BSD-3-Clause
#include "SampleMesh.h"

#include "Errors.h"
#include "InkHasPolygons.h"
#include "InkSilhouettes.h"
#include "MakeMarks.h"

#include "vtkInkSplattingLinesStyle.h"
#include "vtkInkSurfaceSampler.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

namespace ink::cli
{

vtkSmartPointer<vtkPolyData> sampleMesh(
  vtkPolyData* mesh, const MeshSampling& sampling, std::vector<std::string>& notes, Progress& progress)
{
  const CloudSampling& cloud = sampling.cloud;
  if (InkHasPolygons(mesh) && !cloud.given.empty())
  {
    throw UsageError(cloud.given + ": expected points without polygons, found a mesh");
  }
  // As they are drawn, but on the polygons that are there.
  vtkNew<vtkInkSplattingLinesStyle> style;
  style->CurvedMeshesOff();
  style->GetSilhouettes()->SetSharpEdges(false);
  vtkInkSurfaceSampler* sampler = style->GetSurfaceSampler();
  style->SetNumberOfSamples(sampling.count.value_or(-1));
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
  sampler->SetNormalNeighbors(cloud.neighbors.value_or(sampler->GetNormalNeighbors()));
  if (cloud.viewpoint)
  {
    sampler->OrientTowardsViewpointOn();
    sampler->SetViewpoint(cloud.viewpoint->data());
  }
  makeMarks(style, { mesh }, notes, progress);
  return style->GetPiece(0);
}

} // namespace ink::cli
