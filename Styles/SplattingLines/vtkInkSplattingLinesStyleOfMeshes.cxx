// SPDX-License-Identifier: BSD-3-Clause
// The points that lines of meshes, and of points, are drawn of.
#include "vtkInkSplattingLinesStyle.h"

#include "InkDiscStipples.h"
#include "InkFeatureNormals.h"
#include "InkHasPolygons.h"
#include "InkLeaves.h"
#include "InkMeshTriangles.h"
#include "InkSampledMesh.h"
#include "InkSilhouettes.h"
#include "InkStyleProcesses.h"
#include "vtkInkSurfaceSampler.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{

constexpr vtkIdType FewestSamples = 200'000;
constexpr vtkIdType MostSamples = 1'000'000;

/// The radius of the disc that each sample stands for, as a part of the mesh's diagonal, at most: it is
/// little more than a pixel where the mesh fills the picture.
constexpr double SampleShare = 0.0013;

/// How many samples of that radius a mesh has room for. Much of the surface may lie inside, as gears in their
/// casing do, and is sampled all the same.
double CountByArea(vtkPolyData* mesh)
{
  try
  {
    const InkMeshTriangles triangles(mesh, false, InkMeshTriangles::Order::OfMesh);
    const double radius = SampleShare * mesh->GetLength();
    const double count =
      ink::cumulateArea(triangles.GetMesh()).area.back() / (std::numbers::pi * radius * radius);
    return std::isfinite(count) ? count : 0.0;
  }
  catch (const std::invalid_argument&)
  {
    // Sampling says what is wrong.
    return 0.0;
  }
}

} // namespace

std::string vtkInkSplattingLinesStyle::MakeOfMeshes(
  const Input& input, const InkLeaves& leaves, const std::string& reason)
{
  if (const std::string grids = leaves.DescribeGrids(); !grids.empty())
  {
    this->AddNote(grids);
  }
  // All processes take part, also without points; the first one draws those of all.
  const std::vector<vtkSmartPointer<vtkPolyData>> parts = leaves.MakeMeshes();
  vtkSmartPointer<vtkPolyData> mesh =
    input.IsGathered ? InkAppend(parts) : this->GetProcesses().Gather(parts);
  double hasPoints = mesh->GetNumberOfPoints() > 0 ? 1.0 : 0.0;
  this->GetProcesses().TakeGreatest({ &hasPoints, 1 });
  if (mesh->GetNumberOfPoints() == 0)
  {
    return hasPoints > 0.0 && leaves.Problem.empty() ? std::string() : reason;
  }
  mesh = this->NumberOfSamples == 0 ? mesh : this->TakeSurface(mesh); // 0: its own points
  if (InkHasPolygons(mesh))
  {
    this->SetFramePoints(mesh->GetPoints());
  }
  std::string problem = this->Silhouettes->MakeOfMesh(this, mesh, this->GetPiece(SILHOUETTES));
  if (problem.empty() && !InkHasPolygons(mesh) && InkHasDiscs(mesh))
  {
    // As a sampler made them.
    this->GetPiece(POINTS)->ShallowCopy(mesh);
  }
  else if (problem.empty())
  {
    problem = !InkHasPolygons(mesh) ? this->TakeCloud(mesh)
      : this->NumberOfSamples == 0  ? this->TakeMeshWithNormals(mesh, this->GetPiece(POINTS))
                                    : this->SampleMesh(mesh);
  }
  return problem.empty() && !leaves.Problem.empty() ? reason : problem;
}

vtkIdType vtkInkSplattingLinesStyle::CountForMesh(vtkPolyData* mesh)
{
  const double points = 2.0 * static_cast<double>(mesh->GetNumberOfPoints());
  const double most = MostSamples;
  return std::max(FewestSamples, static_cast<vtkIdType>(std::min(std::max(points, CountByArea(mesh)), most)));
}

std::string vtkInkSplattingLinesStyle::TakeCloud(vtkPolyData* points)
{
  vtkPolyData* piece = this->GetPiece(POINTS);
  vtkSmartPointer<vtkPolyData> taken = points;
  if (this->GetInteractive())
  {
    taken = InkKnowPoints(points, this->Colors);
  }
  const std::string problem = this->TakeDiscs(this->SurfaceSampler, taken, piece);
  if (problem.empty() && piece->GetNumberOfPoints() == 0)
  {
    this->AddNote("nothing to draw: no point has others near it");
  }
  return problem;
}

std::string vtkInkSplattingLinesStyle::SampleMesh(vtkPolyData* mesh)
{
  vtkInkSurfaceSampler* sampler = this->SurfaceSampler;
  vtkSmartPointer<vtkPolyData> sampled = mesh;
  if (this->GetInteractive())
  {
    sampled = InkWithFeatureNormals(mesh);
    sampler->KeepFacesOn();
  }
  if (this->NumberOfSamples > 0)
  {
    this->AutomaticSamples = 0;
  }
  else if (this->AutomaticSamples == 0 || !sampler->HasSamplesOfFaces(sampled))
  {
    this->AutomaticSamples = CountForMesh(mesh);
  }
  const vtkIdType count = this->NumberOfSamples > 0 ? this->NumberOfSamples : this->AutomaticSamples;
  // Of many, the fastest that leaves no gaps, for which discs would have to be twice as large.
  const bool isProgressive = this->NumberOfSamples < 0 &&
    sampler->GetAmount() == vtkInkSurfaceSampler::NUMBER_OF_SAMPLES &&
    sampler->GetMethod() == vtkInkSurfaceSampler::AUTOMATIC && count > FewestSamples;
  if (isProgressive)
  {
    sampler->SetMethodToProgressiveBlueNoise();
  }
  // Lines that are drawn on sharp edges need no splats across them.
  sampler->SetComputeEdgeOffsets(this->Silhouettes->GetSharpEdges());
  sampler->SetInputData(sampled);
  sampler->SetNumberOfSamples(count);
  const std::string problem = this->Follow(sampler, "sampling the mesh");
  if (isProgressive)
  {
    sampler->SetMethodToAutomatic();
  }
  // The sampler's own output is another mesh's when it is asked again.
  vtkPolyData* points = this->GetPiece(POINTS);
  points->ShallowCopy(sampler->GetOutput());
  if (this->GetInteractive())
  {
    InkKnowFaces(sampled, this->Colors, points);
  }
  if (problem.empty() && points->GetNumberOfPoints() == 0)
  {
    this->AddNote("nothing to draw: no point was made on the mesh");
  }
  return problem;
}

void vtkInkSplattingLinesStyle::SetColorArray(const InkColorArray& colors)
{
  if (this->Colors != colors)
  {
    this->Colors = colors;
    this->Modified();
  }
}
