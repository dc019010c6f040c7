// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkContours.h"

#include "Curves/Contours/MeshContours.h"
#include "InkCameraEye.h"
#include "InkCellCenters.h"
#include "InkContourLines.h"
#include "InkHasPolygons.h"
#include "InkImageContours.h"
#include "InkImageGrid.h"
#include "InkImageVoxels.h"
#include "InkMeshTriangles.h"
#include "InkNotFiniteFaces.h"
#include "InkOutsideRange.h"
#include "InkPointNormals.h"
#include "InkReportException.h"
#include "InkVTKCompat.h"

#include "vtkCamera.h"
#include "vtkContourValues.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

/// What is kept between eyes: an index of the last mesh, and what it was made from.
class vtkInkContours::vtkInternals
{
public:
  std::optional<ink::MeshContours> Index;
  std::vector<vtkIdType> CellIds;
  vtkPolyData* Mesh = nullptr; ///< only compared
  vtkMTimeType MeshTime = 0;
  ink::MeshContourOptions Options;
  InkImageContours Image;
  /// Edge voxels, and what they were made from.
  struct VoxelSource
  {
    vtkImageData* Image; ///< only compared
    vtkMTimeType Time;
    vtkDataArray* Array; ///< only compared
    int Component;
    glm::ivec3 OwnBegin;
    glm::ivec3 OwnEnd;
    double Scale;
    double LeastMagnitude;
    bool operator==(const VoxelSource&) const = default;
  };
  InkPointInput Input;
  std::optional<VoxelSource> VoxelsFrom;
  ink::EdgeVoxels Voxels;
  int Builds = 0;
  bool HasWarnedOfNormals = false;

  static ink::Eye FindEye(vtkInkContours* self);
  static ink::ContourArrays FindArrays(vtkInkContours* self);

  bool IsOf(vtkPolyData* mesh, const ink::MeshContourOptions& options) const
  {
    return this->Index && this->Mesh == mesh && this->MeshTime == mesh->GetMTime() &&
      this->Options == options;
  }
};

vtkStandardNewMacro(vtkInkContours);

vtkInkContours::vtkInkContours()
  : Internals(std::make_unique<vtkInternals>())
{
  // vtkContourValues initially holds one value.
  this->ContourValues->SetNumberOfContours(0);
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

vtkInkContours::~vtkInkContours() = default;

const char* vtkInkContours::GetEyeAsString()
{
  switch (this->Eye)
  {
    case POSITION:
      return "Position";
    case DIRECTION:
      return "Direction";
    default:
      return "Camera";
  }
}

const char* vtkInkContours::GetMethodAsString()
{
  static const char* const names[] = { "Chains", "VoxelSegments", "VoxelSearch" };
  return names[this->Method];
}

void vtkInkContours::SetCamera(vtkCamera* camera)
{
  if (this->Camera != camera)
  {
    this->Camera = camera;
    this->Modified();
  }
}

vtkCamera* vtkInkContours::GetCamera()
{
  return this->Camera;
}

int vtkInkContours::GetNumberOfIndexBuilds()
{
  return this->Internals->Builds;
}

vtkMTimeType vtkInkContours::GetMTime()
{
  const vtkMTimeType own = std::max(this->Superclass::GetMTime(), this->ContourValues->GetMTime());
  return this->Eye == CAMERA && this->Camera ? std::max(own, this->Camera->GetMTime()) : own;
}

void vtkInkContours::SetValue(int i, double value)
{
  this->ContourValues->SetValue(i, value);
}

double vtkInkContours::GetValue(int i)
{
  return this->ContourValues->GetValue(i);
}

void vtkInkContours::SetNumberOfContours(int number)
{
  this->ContourValues->SetNumberOfContours(number);
}

vtkIdType vtkInkContours::GetNumberOfContours()
{
  return this->ContourValues->GetNumberOfContours();
}

void vtkInkContours::GenerateValues(int numContours, double rangeStart, double rangeEnd)
{
  this->ContourValues->GenerateValues(numContours, rangeStart, rangeEnd);
}

int vtkInkContours::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkInkContours::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  using SDDP = vtkStreamingDemandDrivenPipeline;
  vtkInformation* info = input[0]->GetInformationObject(0);
  if (vtkImageData::GetData(info))
  {
    // A gradient at a piece's border depends on values across it, and that at a point that has moved by up to
    // a cell on those beyond; whether a voxel is one of an edge, on those around its neighbors.
    const int levels = this->Method == CHAINS ? 1 + (this->ProjectionSteps > 0 ? 1 : 0)
      : this->Method == VOXEL_SEGMENTS        ? InkGetVoxelGhostLevels(this->EdgeScale)
                                              : 2;
    info->Set(SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS(),
      output->GetInformationObject(0)->Get(SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS()) + levels +
        InkPointInput::GetGhostLevels(this, info));
  }
  return 1;
}

int vtkInkContours::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  vtkPolyData* mesh = vtkPolyData::GetData(inputVector[0]);
  try
  {
    if (mesh)
    {
      this->FindContoursOfMesh(mesh, output);
    }
    else if (this->Method != CHAINS)
    {
      this->FindVoxelSegments(this->Internals->Input.Take(this, inputVector), outputVector);
    }
    else
    {
      this->FindContoursOfImage(this->Internals->Input.Take(this, inputVector), outputVector);
    }
  }
  catch (...)
  {
    // What is half made must not be used again.
    this->Internals->Image.Clear();
    this->Internals->VoxelsFrom.reset();
    InkReportException(
      this, output, std::string("The contours of the ") + (mesh ? "mesh" : "image") + " cannot be found");
  }
  return 1;
}

ink::Eye vtkInkContours::vtkInternals::FindEye(vtkInkContours* self)
{
  if (self->Eye != CAMERA)
  {
    const double* v = self->Eye == POSITION ? self->EyePosition : self->EyeDirection;
    return self->Eye == POSITION ? ink::Eye::at({ v[0], v[1], v[2] }) : ink::Eye::along({ v[0], v[1], v[2] });
  }
  if (!self->Camera)
  {
    throw std::invalid_argument(
      "there is no camera; expected one by SetCamera, or EyePosition or EyeDirection by SetEye");
  }
  return InkCameraEye(self->Camera);
}

ink::ContourArrays vtkInkContours::vtkInternals::FindArrays(vtkInkContours* self)
{
  return { self->ComputeNormals, self->ComputeRadialCurvature, self->ComputeArcLength, self->ComputeCellIds };
}

void vtkInkContours::FindContoursOfMesh(vtkPolyData* mesh, vtkPolyData* output)
{
  if (this->Method != CHAINS)
  {
    throw std::invalid_argument("segments through voxels need an image; found a mesh of " +
      std::to_string(mesh->GetNumberOfPoints()) + " points");
  }
  const ink::Eye eye = vtkInternals::FindEye(this);
  if (!InkHasPolygons(mesh))
  {
    if (mesh->GetNumberOfPoints() > 0)
    {
      vtkWarningMacro("The input has " << mesh->GetNumberOfPoints() << " points and no polygons or strips; "
                                       << "expected a surface. There are no contours.");
    }
    return;
  }
  const ink::MeshContourOptions options{ this->Silhouettes, this->Faceted, this->Creases, this->FeatureAngle,
    this->Borders, this->NonManifoldEdges, this->ShortestCrease, this->ShortestBorder };
  vtkInternals& kept = *this->Internals;
  if (!kept.IsOf(mesh, options))
  {
    kept.Index.reset();
    // Those of a mesh without normals are made from its faces.
    InkMeshTriangles triangles(mesh, true, InkMeshTriangles::Order::OfMesh);
    if (options.silhouettes && !options.faceted && !InkPointNormals(mesh) && !kept.HasWarnedOfNormals)
    {
      kept.HasWarnedOfNormals = true;
      vtkWarningMacro("The input has no point normals; expected a point array \"Normals\" for smooth "
                      "silhouettes. The mean over the faces around each point is used.");
    }
    this->UpdateProgress(0.2);
    kept.Index.emplace(triangles.GetMesh(), triangles.Normals, options);
    kept.CellIds = std::move(triangles.FaceIds);
    if (kept.Mesh != mesh || kept.MeshTime != mesh->GetMTime())
    {
      InkWarnOfNotFiniteFaces(this, mesh);
    }
    kept.Mesh = mesh;
    kept.MeshTime = mesh->GetMTime();
    kept.Options = options;
    ++kept.Builds;
    this->UpdateProgress(0.9);
  }
  InkMakeContourLines(kept.Index->find(eye, vtkInternals::FindArrays(this)), mesh->GetPoints()->GetDataType(),
    kept.CellIds, output);
}

void vtkInkContours::FindContoursOfImage(
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const ink::Eye eye = vtkInternals::FindEye(this);
  vtkInformation* info = inputVector[0]->GetInformationObject(0);
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  vtkImageData* image = vtkImageData::GetData(info);
  // An empty piece is not an error.
  if (image->GetNumberOfPoints() == 0 || !this->Silhouettes)
  {
    return;
  }
  const InkExtent whole = InkGetWholeExtent(info, image);
  const glm::ivec3 samples = whole.GetDimensions();
  if (std::min({ samples.x, samples.y, samples.z }) < 2)
  {
    vtkWarningMacro("The image has " << samples.x << " x " << samples.y << " x " << samples.z
                                     << " samples. An iso-surface needs at least 2 along each axis.");
    return;
  }
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkDataArray* found = this->GetInputArrayToProcess(0, inputVector, association);
  vtkDataArray* scalars = InkChooseScalars(this, image, found, association, this->ArrayComponent);
  if (!scalars)
  {
    return;
  }
  const std::span<const double> isoValues(
    this->ContourValues->GetValues(), static_cast<std::size_t>(this->ContourValues->GetNumberOfContours()));
  if (std::any_of(isoValues.begin(), isoValues.end(), [](double value) { return std::isnan(value); }))
  {
    vtkWarningMacro("An iso-value is not a number (NaN) and has no contours.");
  }
  vtkInternals& kept = *this->Internals;
  const auto progress = [this](double done)
  {
    this->UpdateProgress(0.9 * done);
    return !InkCheckAbort(this);
  };
  kept.Builds += kept.Image.Update(
    { image, scalars, this->ArrayComponent, InkSelectCells(info, outInfo, image) }, isoValues, progress);
  if (InkCheckAbort(this))
  {
    kept.Image.Clear();
    return;
  }
  ink::GridContourOptions options;
  options.projectionSteps = this->ProjectionSteps;
  std::vector<int> surfaces;
  const ink::Contours contours = kept.Image.Find(eye, vtkInternals::FindArrays(this), options, surfaces);
  const bool doubles = InkNeedsDoublePrecision(InkMakeGrid(image, whole));
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  InkMakeContourLines(contours, doubles ? VTK_DOUBLE : VTK_FLOAT, {}, output);
  kept.Image.AddSurfaceIndex(surfaces, output);
  const std::string outside = output->GetNumberOfPoints() == 0 && InkIsWholeImage(info, outInfo, image)
    ? InkDescribeOutside(isoValues, scalars, this->ArrayComponent, "contours")
    : std::string();
  if (!outside.empty())
  {
    vtkWarningMacro(<< outside);
  }
}

void vtkInkContours::FindVoxelSegments(vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const ink::Eye eye = vtkInternals::FindEye(this);
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkDataArray* found = this->GetInputArrayToProcess(0, inputVector, association);
  const InkVoxelInput input =
    InkVoxelInput::Take(this, found, association, inputVector, outputVector, this->ArrayComponent);
  if (!input.Scalars || !this->Silhouettes)
  {
    return;
  }
  ink::SilhouetteCriteria criteria;
  criteria.lowest = static_cast<float>(this->LowestValue);
  criteria.highest = static_cast<float>(this->HighestValue);
  criteria.leastMagnitude = static_cast<float>(this->LeastGradientMagnitude);
  criteria.largestCosine = static_cast<float>(this->LargestCosine);
  vtkInternals& kept = *this->Internals;
  std::vector<std::uint32_t> selected;
  if (this->Method == VOXEL_SEARCH)
  {
    kept.VoxelsFrom.reset();
    kept.Voxels = InkSearchSilhouetteVoxels(input, criteria, eye);
    selected.resize(kept.Voxels.samples.size());
    std::iota(selected.begin(), selected.end(), 0u);
  }
  else
  {
    const vtkInternals::VoxelSource source{ input.Image,
      std::max(input.Image->GetMTime(), input.Array->GetMTime()), input.Array, this->ArrayComponent,
      input.Own.begin, input.Own.end, this->EdgeScale, this->LeastGradientMagnitude };
    if (kept.VoxelsFrom != source)
    {
      kept.VoxelsFrom.reset();
      kept.Voxels = InkFindEdgeVoxels(input, this->EdgeScale, this->LeastGradientMagnitude,
        [this](double done)
        {
          this->UpdateProgress(0.9 * done);
          return !InkCheckAbort(this);
        });
      if (InkCheckAbort(this))
      {
        return;
      }
      kept.VoxelsFrom = source;
      ++kept.Builds;
    }
    selected = ink::selectSilhouetteVoxels(kept.Voxels, criteria, eye);
  }
  const double length = this->SegmentLength * 2.0 * std::numbers::inv_sqrt3 * InkGetVoxelRadius(input.Image);
  const InkExtent whole = InkGetWholeExtent(inputVector[0]->GetInformationObject(0), input.Image);
  const bool doubles = InkNeedsDoublePrecision(InkMakeGrid(input.Image, whole));
  InkMakeContourLines(
    ink::silhouetteSegments(kept.Voxels, selected, eye, length, vtkInternals::FindArrays(this)),
    doubles ? VTK_DOUBLE : VTK_FLOAT, {}, vtkPolyData::GetData(outputVector));
}

void vtkInkContours::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->GetMethodAsString() << "\n";
  os << indent << "Eye: " << this->GetEyeAsString() << "\n";
  os << indent << "Camera: " << this->Camera.Get() << "\n";
  os << indent << "EyePosition: " << this->EyePosition[0] << ", " << this->EyePosition[1] << ", "
     << this->EyePosition[2] << "\n";
  os << indent << "EyeDirection: " << this->EyeDirection[0] << ", " << this->EyeDirection[1] << ", "
     << this->EyeDirection[2] << "\n";
  os << indent << "ContourValues:\n";
  this->ContourValues->PrintSelf(os, indent.GetNextIndent());
  os << indent << "ArrayComponent: " << this->ArrayComponent << "\n";
  os << indent << "ProjectionSteps: " << this->ProjectionSteps << "\n";
  os << indent << "EdgeScale: " << this->EdgeScale << "\n";
  os << indent << "LowestValue: " << this->LowestValue << "\n";
  os << indent << "HighestValue: " << this->HighestValue << "\n";
  os << indent << "LeastGradientMagnitude: " << this->LeastGradientMagnitude << "\n";
  os << indent << "LargestCosine: " << this->LargestCosine << "\n";
  os << indent << "SegmentLength: " << this->SegmentLength << "\n";
  os << indent << "Silhouettes: " << this->Silhouettes << "\n";
  os << indent << "Faceted: " << this->Faceted << "\n";
  os << indent << "Creases: " << this->Creases << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "ShortestCrease: " << this->ShortestCrease << "\n";
  os << indent << "ShortestBorder: " << this->ShortestBorder << "\n";
  os << indent << "Borders: " << this->Borders << "\n";
  os << indent << "NonManifoldEdges: " << this->NonManifoldEdges << "\n";
  os << indent << "ComputeNormals: " << this->ComputeNormals << "\n";
  os << indent << "ComputeRadialCurvature: " << this->ComputeRadialCurvature << "\n";
  os << indent << "ComputeArcLength: " << this->ComputeArcLength << "\n";
  os << indent << "ComputeCellIds: " << this->ComputeCellIds << "\n";
}
