// SPDX-License-Identifier: BSD-3-Clause
// The points that lines of meshes, and of points, are drawn of.
#include "vtkInkSplattingLinesStyle.h"

#include "InkDiscStipples.h"
#include "InkFeatureNormals.h"
#include "InkHasPolygons.h"
#include "InkLeaves.h"
#include "InkSampledMesh.h"
#include "InkSilhouettes.h"
#include "InkStyleProcesses.h"
#include "vtkInkSurfaceSampler.h"

#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <string>
#include <vector>

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
  mesh = this->NumberOfSamples == 0 ? mesh : this->TakeCurved(mesh); // 0: its own points
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
    problem = this->NumberOfSamples == 0 && InkHasPolygons(mesh)
      ? this->TakeMeshWithNormals(mesh, this->GetPiece(POINTS))
      : this->SampleMesh(mesh);
  }
  return problem.empty() && !leaves.Problem.empty() ? reason : problem;
}

vtkIdType vtkInkSplattingLinesStyle::CountForMesh(vtkPolyData* mesh)
{
  return std::clamp<vtkIdType>(2 * mesh->GetNumberOfPoints(), 200'000, 1'000'000);
}

std::string vtkInkSplattingLinesStyle::SampleMesh(vtkPolyData* mesh)
{
  vtkInkSurfaceSampler* sampler = this->SurfaceSampler;
  const bool isCloud = !InkHasPolygons(mesh);
  vtkSmartPointer<vtkPolyData> sampled = mesh;
  if (this->GetInteractive())
  {
    sampled = isCloud ? InkKnowPoints(mesh, this->Colors) : InkWithFeatureNormals(mesh);
    sampler->SetKeepFaces(!isCloud);
  }
  sampler->SetInputData(sampled);
  sampler->SetNumberOfSamples(this->NumberOfSamples > 0 ? this->NumberOfSamples : CountForMesh(mesh));
  const std::string problem = this->Follow(sampler, isCloud ? "looking at the points" : "sampling the mesh");
  // The sampler's own output is another mesh's when it is asked again.
  vtkPolyData* points = this->GetPiece(POINTS);
  points->ShallowCopy(sampler->GetOutput());
  if (this->GetInteractive() && !isCloud)
  {
    InkKnowFaces(sampled, this->Colors, points);
  }
  if (problem.empty() && isCloud)
  {
    const bool estimated = sampler->GetComputeNormals() && !mesh->GetPointData()->GetNormals();
    this->AddNote("there are no polygons; the " + std::to_string(mesh->GetNumberOfPoints()) +
      " points are taken as they are" + (estimated ? ", with normals estimated from their neighbors" : ""));
    if (const vtkIdType isolated = sampler->GetNumberOfIsolatedPoints(); isolated > 0)
    {
      this->AddNote(std::to_string(isolated) + " points that are far from all others are left out");
    }
  }
  if (problem.empty() && points->GetNumberOfPoints() == 0)
  {
    this->AddNote("nothing to draw: no point was made on the mesh");
  }
  return problem;
}

void vtkInkSplattingLinesStyle::SetColorArray(const InkColorArray& colors)
{
  if (this->Colors.Name != colors.Name || this->Colors.OfCells != colors.OfCells)
  {
    this->Colors = colors;
    this->Modified();
  }
}
