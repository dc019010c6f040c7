// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkStippleGenerator.h"

#include "InkCellCenters.h"
#include "InkDiscStipples.h"
#include "InkFeatureNormals.h"
#include "InkHasPolygons.h"
#include "InkImageGrid.h"
#include "InkNotFiniteFaces.h"
#include "InkOwnedSamples.h"
#include "InkPointNormals.h"
#include "InkReportException.h"
#include "InkSurfaceStipples.h"
#include "InkVTKCompat.h"
#include "InkVolumeStipples.h"

#include "Stippling/SmoothedVoxels.h"
#include "Tone/Stipple/ProjectedSize.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMassProperties.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTriangleFilter.h"

#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

using SDDP = vtkStreamingDemandDrivenPipeline;

vtkStandardNewMacro(vtkInkStippleGenerator);

namespace
{

/// N_max of a whole image's voxels in a picture in which its longest side has that many pixels.
int ProjectedListLength(const ink::GridGeometry& whole, double pixels)
{
  const glm::dvec3 sides = glm::abs(glm::dvec3(whole.dimensions()) * whole.spacing());
  const double longest = std::max({ sides.x, sides.y, sides.z });
  const double edge = std::cbrt(std::abs(glm::determinant(whole.stepToWorld())));
  return ink::stipple::projectedListLength(static_cast<float>(edge / longest),
    static_cast<float>(1.0 / pixels), ink::stipple::maximumStipplesPerVoxel);
}

} // namespace

vtkInkStippleGenerator::vtkInkStippleGenerator()
{
  for (const int index : { 0, 1 })
  {
    this->SetInputArrayToProcess(
      index, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
  }
}

vtkInkStippleGenerator::~vtkInkStippleGenerator() = default;

int vtkInkStippleGenerator::FillInputPortInformation(int, vtkInformation* info)
{
  // Accepts other data than images and meshes, to explain what to do with them.
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  return 1;
}

bool vtkInkStippleGenerator::NeedsWholeImage() const
{
  // Percentiles and ranges are those of the whole image.
  const bool measures = this->ThresholdMode == PERCENTILE || !this->UseReferenceRanges;
  return measures && !this->Statistics && !this->Measured;
}

bool vtkInkStippleGenerator::Measure(vtkInformation* request, ink::stipple::VolumeStatistics& statistics)
{
  this->Measured = &statistics;
  this->Modified();
  this->Update(request);
  const bool done = !this->Measured;
  this->Measured = nullptr;
  // The output has no stipples now.
  this->Modified();
  return done;
}

void vtkInkStippleGenerator::SetStatistics(std::shared_ptr<const ink::stipple::VolumeStatistics> statistics)
{
  if (statistics != this->Statistics)
  {
    this->Statistics = std::move(statistics);
    this->Modified();
  }
}

int vtkInkStippleGenerator::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkInformation* info = input[0]->GetInformationObject(0);
  if (!vtkImageData::GetData(info))
  {
    return 1;
  }
  vtkInformation* outInfo = output->GetInformationObject(0);
  if (this->NeedsWholeImage() && (outInfo->Get(SDDP::UPDATE_PIECE_NUMBER()) == 0 || InkKnowsPieces(this)))
  {
    info->Set(SDDP::UPDATE_PIECE_NUMBER(), 0);
    info->Set(SDDP::UPDATE_NUMBER_OF_PIECES(), 1);
    info->Set(SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
    if (info->Has(SDDP::WHOLE_EXTENT()))
    {
      info->Set(SDDP::UPDATE_EXTENT(), info->Get(SDDP::WHOLE_EXTENT()), 6);
    }
  }
  else
  {
    const int levels = outInfo->Get(SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS());
    info->Set(SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS(),
      levels + GetGhostLevels(this->Smoothing) + InkPointInput::GetGhostLevels(this, info));
  }
  return 1;
}

int vtkInkStippleGenerator::GetGhostLevels(double smoothing)
{
  // The gradients around a voxel that its stipples depend on, their support, and what is smoothed into that.
  return ink::stipple::stippleReach.x + 1 + ink::stipple::smoothingReach(smoothing);
}

int vtkInkStippleGenerator::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataSet* data = vtkDataSet::GetData(inputVector[0]);
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  vtkPolyData* output = vtkPolyData::GetData(outInfo);
  // An empty piece is not an error.
  if (!data || data->GetNumberOfPoints() == 0)
  {
    this->Measured = nullptr;
    return 1;
  }
  auto* mesh = vtkPolyData::SafeDownCast(data);
  if (!mesh && !vtkImageData::SafeDownCast(data))
  {
    vtkErrorMacro(
      "The input is a " << data->GetClassName()
                        << "; expected a vtkImageData or a vtkPolyData. vtkResampleToImage makes an "
                           "image of a grid, vtkDataSetSurfaceFilter a mesh of its surface.");
    return 1;
  }
  const bool hasPolygons = mesh && InkHasPolygons(mesh);
  const std::string kind = !mesh ? "image" : hasPolygons || !InkHasDiscs(mesh) ? "mesh" : "surface";
  try
  {
    if (kind == "surface")
    {
      this->StippleDiscs(mesh, inputVector, output);
    }
    else if (mesh)
    {
      this->StippleSurface(mesh, inputVector, output);
    }
    else
    {
      InkPointInput points;
      this->StippleVolume(points.Take(this, inputVector), outInfo, output);
    }
  }
  catch (...)
  {
    InkReportException(this, output, "The " + kind + " cannot be stippled");
  }
  return 1;
}

void vtkInkStippleGenerator::StippleVolume(
  vtkInformationVector** input, vtkInformation* outInfo, vtkPolyData* output)
{
  vtkInformation* info = input[0]->GetInformationObject(0);
  vtkImageData* image = vtkImageData::GetData(info);
  const ink::SampleBox own = InkGetOwnedSamples(info, outInfo, image);
  if (own.empty())
  {
    this->Measured = nullptr;
    return;
  }
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkDataArray* found = this->GetInputArrayToProcess(0, input, association);
  vtkDataArray* scalars = InkChooseScalars(this, image, found, association, this->ArrayComponent);
  if (!scalars)
  {
    return;
  }
  constexpr double infinity = std::numeric_limits<double>::infinity();
  InkVolumeStippleRequest request;
  request.Scalars = scalars;
  request.Component = this->ArrayComponent;
  request.Smoothing = this->Smoothing;
  request.Gradient.method = this->GradientMethod == CENTRAL_DIFFERENCE
    ? ink::GradientMethod::CentralDifference
    : ink::GradientMethod::Regression;
  request.Gradient.weighting = this->GradientWeighting == INVERSE_DISTANCE
    ? ink::RegressionWeighting::InverseDistance
    : ink::RegressionWeighting::Uniform;
  request.ByPercentile = this->ThresholdMode == PERCENTILE;
  request.Percentile = this->GradientPercentile;
  request.Threshold = this->GradientThreshold;
  request.Window[0] = this->UseScalarWindow ? this->ScalarWindow[0] : -infinity;
  request.Window[1] = this->UseScalarWindow ? this->ScalarWindow[1] : infinity;
  const ink::GridGeometry whole = InkMakeGrid(image, InkGetWholeExtent(info, image));
  request.Stipples.perVoxel = this->MaximumStipplesMode == PROJECTED
    ? ProjectedListLength(whole, this->PictureSize)
    : this->MaximumStipples;
  request.Stipples.thickness = this->LayerThickness;
  request.Stipples.seed = static_cast<std::uint64_t>(this->Seed);
  request.GivenRanges = this->UseReferenceRanges;
  std::copy_n(this->ReferenceScalarRange, 2, request.ScalarRange);
  request.SteepestGradient = this->ReferenceGradient;
  request.Own = own;
  request.Doubles = this->OutputPointsPrecision == DOUBLE_PRECISION ||
    (this->OutputPointsPrecision == DEFAULT_PRECISION && InkNeedsDoublePrecision(whole));
  bool ofCells = false;
  request.Colors = this->GetColors(image, input, ofCells);
  if (ofCells)
  {
    throw std::invalid_argument("the scalars to pass on are cell data; expected point data");
  }
  request.Statistics = this->Statistics.get();
  request.Progress = [this](double share) { return this->ReportProgress(share); };
  if (this->Measured)
  {
    if (InkMeasureVolume(image, request, *this->Measured))
    {
      this->Measured = nullptr;
    }
    return;
  }
  InkMakeVolumeStipples(image, request, output);
  // A part of an image may legitimately have none.
  if (output->GetNumberOfPoints() == 0 && InkIsWholeImage(info, outInfo, image) && !InkCheckAbort(this))
  {
    this->ReportNothing(scalars);
  }
}

void vtkInkStippleGenerator::ReportNothing(vtkDataArray* scalars)
{
  double range[2];
  scalars->GetFiniteRange(range, this->ArrayComponent);
  std::ostringstream message;
  message << "No voxel has a gradient that is steep enough";
  if (this->UseScalarWindow)
  {
    message << " and values between " << this->ScalarWindow[0] << " and " << this->ScalarWindow[1];
  }
  message << ", so none is stippled. ";
  if (range[0] <= range[1])
  {
    message << "The values range from " << range[0] << " to " << range[1] << '.';
  }
  else
  {
    message << "None of the values is finite.";
  }
  vtkWarningMacro(<< message.str());
}

void vtkInkStippleGenerator::StippleSurface(
  vtkPolyData* given, vtkInformationVector** input, vtkPolyData* output)
{
  if (!InkHasPolygons(given))
  {
    throw std::invalid_argument("it has " + std::to_string(given->GetNumberOfPoints()) + " points and " +
      std::to_string(given->GetNumberOfCells()) +
      " cells, none of them a polygon; expected polygons, or points with the arrays \"Normals\" of 3 "
      "components and \"Radius\" of 1");
  }
  // Without normals, stipples have those of polygons.
  const vtkSmartPointer<vtkPolyData> mesh =
    InkPointNormals(given) ? InkWithFeatureNormals(given) : vtkSmartPointer<vtkPolyData>(given);
  InkSurfaceStippleRequest request;
  request.Count = this->CountForSurface(mesh);
  request.PerPolygon = this->MaximumStipples;
  request.Seed = this->Seed;
  request.Doubles = this->MakesDoubles(mesh);
  request.Colors = this->GetColors(mesh, input, request.ColorsOfCells);
  request.Progress = [this](double share) { return this->ReportProgress(share); };
  InkMakeSurfaceStipples(mesh, request, output);
  InkWarnOfNotFiniteFaces(this, mesh);
}

vtkIdType vtkInkStippleGenerator::CountForSurface(vtkPolyData* surface)
{
  return this->NumberOfSurfaceStipples == 0 && this->MaximumStipplesMode == PROJECTED
    ? CountForPicture(surface, this->PictureSize, 1.0)
    : this->NumberOfSurfaceStipples;
}

bool vtkInkStippleGenerator::MakesDoubles(vtkPolyData* surface)
{
  return this->OutputPointsPrecision == DOUBLE_PRECISION ||
    (this->OutputPointsPrecision == DEFAULT_PRECISION && surface->GetPoints()->GetDataType() == VTK_DOUBLE);
}

void vtkInkStippleGenerator::StippleDiscs(
  vtkPolyData* points, vtkInformationVector** input, vtkPolyData* output)
{
  InkDiscStippleRequest request;
  request.Count = this->CountForSurface(points);
  request.PerPoint = this->MaximumStipples;
  request.Seed = this->Seed;
  request.Doubles = this->MakesDoubles(points);
  bool ofCells = false;
  request.Colors = this->GetColors(points, input, ofCells);
  if (ofCells)
  {
    throw std::invalid_argument("the scalars to pass on are cell data; expected point data");
  }
  request.Progress = [this](double share) { return this->ReportProgress(share); };
  InkMakeDiscStipples(points, request, output);
}

vtkDataArray* vtkInkStippleGenerator::GetColors(vtkDataSet* data, vtkInformationVector** input, bool& ofCells)
{
  if (!this->PassScalars)
  {
    return nullptr;
  }
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  const char* chosen = this->GetInputArrayInformation(1)->Get(vtkDataObject::FIELD_NAME());
  vtkDataArray* colors = chosen && !*chosen ? data->GetPointData()->GetScalars()
                                            : this->GetInputArrayToProcess(1, input, association);
  ofCells = association == vtkDataObject::FIELD_ASSOCIATION_CELLS;
  vtkDataSetAttributes* own = data->GetAttributes(ofCells ? vtkDataObject::CELL : vtkDataObject::POINT);
  if (colors && colors->GetName() && own->HasArray(colors->GetName()))
  {
    // The input's lacks the points that `data` repeats at edges.
    colors = own->GetArray(colors->GetName());
  }
  const vtkIdType expected = ofCells ? data->GetNumberOfCells() : data->GetNumberOfPoints();
  const std::string name = chosen && *chosen ? "array \"" + std::string(chosen) + "\"" : "active scalars";
  if (!colors)
  {
    throw std::invalid_argument("it has no " + name + " to pass on; expected a numeric array");
  }
  if (colors->GetNumberOfTuples() != expected)
  {
    throw std::invalid_argument("the " + name + " to pass on have " +
      std::to_string(colors->GetNumberOfTuples()) + " values; expected " + std::to_string(expected));
  }
  return colors;
}

namespace
{

double AreaOf(vtkPolyData* mesh)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(mesh);
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  vtkNew<vtkMassProperties> properties;
  properties->SetInputConnection(triangles->GetOutputPort());
  return properties->GetSurfaceArea();
}

} // namespace

vtkIdType vtkInkStippleGenerator::CountForPicture(vtkPolyData* mesh, double pixels, double pixelsPerStipple)
{
  constexpr double fewest = 20'000;
  constexpr double most = ink::stipple::mostForPicture;
  const bool hasPolygons = InkHasPolygons(mesh);
  if (!hasPolygons && !InkHasDiscs(mesh))
  {
    return 0;
  }
  const double* box = mesh->GetBounds();
  const double side = std::max({ box[1] - box[0], box[3] - box[2], box[5] - box[4] });
  const double pixel = side / pixels;
  const double area = hasPolygons ? AreaOf(mesh) : InkAreaOfDiscs(mesh);
  const double room = area / (pixel * pixel * pixelsPerStipple);
  return static_cast<vtkIdType>(std::llround(std::isfinite(room) ? std::clamp(room, fewest, most) : fewest));
}

bool vtkInkStippleGenerator::ReportProgress(double share)
{
  this->UpdateProgress(share);
  return !InkCheckAbort(this);
}
