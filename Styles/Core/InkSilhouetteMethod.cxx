// SPDX-License-Identifier: BSD-3-Clause
#include "InkSilhouetteMethod.h"

#include "InkHasPolygons.h"
#include "InkStyleProcesses.h"
#include "vtkInkEdgeVoxels.h"
#include "vtkInkSilhouetteMapper.h"
#include "vtkInkStyle.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>

using Mapper = vtkInkSilhouetteMapper;

InkSilhouetteMethod::InkSilhouetteMethod(vtkInkSilhouetteMapper* mapper)
  : Mapper(mapper)
{
}

InkSilhouetteMethod::~InkSilhouetteMethod() = default;

bool InkSilhouetteMethod::NeedsVoxels() const
{
  return this->Method == Mapper::VOXEL_SEGMENTS;
}

void InkSilhouetteMethod::SetMethod(int method)
{
  const bool needed = this->NeedsVoxels();
  this->Method = std::clamp<int>(method, Mapper::CHAINS, Mapper::TOON);
  if (needed != this->NeedsVoxels())
  {
    this->Changed.Modified();
  }
  this->Follow();
}

void InkSilhouetteMethod::SetEdgeScale(double scale)
{
  if (scale != this->GetEdgeScale())
  {
    this->EdgeVoxels->SetEdgeScale(scale);
    this->Changed.Modified();
  }
}

double InkSilhouetteMethod::GetEdgeScale() const
{
  return this->EdgeVoxels->GetEdgeScale();
}

void InkSilhouetteMethod::SetLeastGradient(double share)
{
  this->LeastGradient = share;
  this->Follow();
}

void InkSilhouetteMethod::SetValueRange(const std::vector<double>& range)
{
  this->ValueRange = range;
  const bool all = range.size() != 2;
  this->Mapper->SetLowestValue(all ? -1e38 : range[0]);
  this->Mapper->SetHighestValue(all ? 1e38 : range[1]);
}

std::string InkSilhouetteMethod::MakeVoxels(
  vtkInkStyle* style, std::span<vtkImageData* const> images, vtkPolyData* voxels)
{
  std::string problem;
  std::vector<vtkSmartPointer<vtkPolyData>> parts;
  for (vtkImageData* image : style->GetProcesses().GatherImages(images))
  {
    this->EdgeVoxels->SetInputData(image);
    problem = style->Follow(this->EdgeVoxels, "finding edge voxels");
    parts.push_back(vtkSmartPointer<vtkPolyData>::New());
    parts.back()->ShallowCopy(this->EdgeVoxels->GetOutput());
    if (!problem.empty())
    {
      break;
    }
  }
  this->EdgeVoxels->SetInputData(nullptr);
  if (problem.empty() && !parts.empty())
  {
    voxels->ShallowCopy(InkAppend(parts));
    if (voxels->GetNumberOfPoints() == 0)
    {
      style->AddNote("no voxel of the image lies on an edge");
    }
  }
  return problem;
}

bool InkSilhouetteMethod::IsOfVoxels(vtkPolyData* piece)
{
  return piece && !InkHasPolygons(piece) && piece->GetPointData()->HasArray("Gradient");
}

void InkSilhouetteMethod::Follow()
{
  vtkPolyData* piece = this->Mapper->GetInput();
  if (!IsOfVoxels(piece))
  {
    this->Mapper->SetMethod(this->NeedsVoxels() ? Mapper::IMAGE_SPACE : this->Method);
    return;
  }
  this->Mapper->SetMethodToVoxelSegments();
  // The magnitudes'.
  double range[2];
  piece->GetPointData()->GetArray("Gradient")->GetFiniteRange(range, -1);
  this->Mapper->SetLeastGradientMagnitude(this->LeastGradient * range[1]);
}
