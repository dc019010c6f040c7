// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkIsoSurfaceSampler.h"

#include "Fields/Grid/GridField.h"
#include "InkAddCuts.h"
#include "InkAllocate.h"
#include "InkImageGrid.h"
#include "InkOutsideRange.h"
#include "InkPrecision.h"
#include "InkReportException.h"
#include "InkSurfaceParts.h"
#include "InkTrimArray.h"
#include "InkVTKCompat.h"
#include "InkWithGridField.h"
#include "IsoSurface/IsoSurfaceSamples.h"
#include "IsoSurface/MinMaxBricks.h"
#include "IsoSurface/ProjectSamples.h"
#include "IsoSurface/ResampledSamples.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkCellArray.h"
#include "vtkContourValues.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkShortArray.h"
#include "vtkSignedCharArray.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"
#include "vtkWeakPointer.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

vtkStandardNewMacro(vtkInkIsoSurfaceSampler);

/// The state kept from one run to the next.
class vtkInkIsoSurfaceSampler::vtkInternals
{
public:
  /// The ranges of bricks, and the array that they belong to.
  ink::MinMaxBricks Ranges;
  ink::TileRanges TileRanges;
  vtkWeakPointer<vtkDataArray> RangesOf;
  vtkMTimeType RangesTime = 0;
  int RangesComponent = 0;

  /// The output's arrays.
  vtkSmartPointer<vtkPoints> Points;
  vtkSmartPointer<vtkDataArray> Normals;
  vtkSmartPointer<vtkDataArray> Radii;
  vtkSmartPointer<vtkDataArray> SurfaceIndex;
  vtkSmartPointer<vtkDataArray> CellIds;
  vtkSmartPointer<vtkDataArray> Vertices;
  /// The number of samples per iso-value in the last run.
  std::vector<std::size_t> Counts;
  std::size_t Expected = 0;

  void ReleaseArrays()
  {
    this->Points = nullptr;
    this->Normals = this->Radii = this->SurfaceIndex = this->CellIds = this->Vertices = nullptr;
  }

  /// The kept array if nobody else references it and it has the right type, otherwise a new one.
  static void Renew(vtkSmartPointer<vtkDataArray>& array, int type, int components)
  {
    if (!array || array->GetReferenceCount() > 1 || array->GetDataType() != type ||
      array->GetNumberOfComponents() != components)
    {
      array = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(type));
      array->SetNumberOfComponents(components);
    }
  }
  void RenewPoints(int type)
  {
    if (!this->Points || this->Points->GetReferenceCount() > 1 || this->Points->GetDataType() != type ||
      this->Points->GetData()->GetReferenceCount() > 1)
    {
      this->Points = vtkSmartPointer<vtkPoints>::New();
      this->Points->SetDataType(type);
    }
  }
  void ClearRanges()
  {
    this->Ranges.clear();
    this->TileRanges.clear();
  }
  /// Drops ranges of other values.
  void KeepRangesOf(vtkDataArray* array, vtkImageData* image, int component)
  {
    const vtkMTimeType time = std::max(array->GetMTime(), image->GetMTime());
    if (this->RangesOf != array || this->RangesTime != time || this->RangesComponent != component)
    {
      this->ClearRanges();
      this->RangesOf = array;
      this->RangesTime = time;
      this->RangesComponent = component;
    }
  }
};

namespace
{

template <class T, class Array>
T* PointerTo(vtkDataArray* array)
{
  auto* typed = Array::SafeDownCast(array);
  return typed ? typed->GetPointer(0) : nullptr;
}

template <class IdArray>
void NumberFrom0(vtkDataArray* array, vtkIdType count)
{
  auto* ids = IdArray::SafeDownCast(array);
  std::iota(ids->GetPointer(0), ids->GetPointer(0) + count, typename IdArray::ValueType(0));
}

template <class IdArray>
vtkSmartPointer<vtkDataArray> MakeOffsets(vtkIdType count)
{
  auto offsets = vtkSmartPointer<IdArray>::New();
  offsets->SetNumberOfValues(2);
  offsets->SetValue(0, 0);
  offsets->SetValue(1, static_cast<typename IdArray::ValueType>(count));
  return offsets;
}

/// One VTK_POLY_VERTEX cell over points 0 ... count - 1, with the connectivity array `ids`.
template <class IdArray>
vtkSmartPointer<vtkCellArray> MakePolyVertex(vtkDataArray* ids, vtkIdType count)
{
  InkSetNumberOfTuples(ids, count);
  InkTrimArray(ids);
  NumberFrom0<IdArray>(ids, count);
  ids->Modified();
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(IdArray::SafeDownCast(MakeOffsets<IdArray>(count)), IdArray::SafeDownCast(ids));
  return cells;
}

/// One run over all iso-values.
struct SampleRequest
{
  std::span<const double> IsoValues;
  ink::SampleOptions Options;
  ink::CellSelection Cells;
  std::size_t Expected;
};

/// Moves the samples of each iso-value, which come one after the other. Returns false when aborted.
template <class T>
bool Project(const ink::GridField<T>& field, const SampleRequest& request, int steps,
  const ink::SampleRoom& room, const std::vector<std::size_t>& counts, const ink::Progress& progress)
{
  const double total =
    std::max(1.0, static_cast<double>(std::accumulate(counts.begin(), counts.end(), std::size_t(0))));
  std::size_t before = 0;
  for (std::size_t n = 0; n < counts.size(); ++n)
  {
    const auto part = [&](double done)
    { return progress((static_cast<double>(before) + done * static_cast<double>(counts[n])) / total); };
    const auto project = [&](auto* points)
    {
      return ink::projectSamples(field, field.geometry(), request.IsoValues[n], steps,
        std::span(points + 3 * before, 3 * counts[n]), part);
    };
    if (!(room.doublePoints ? project(room.doublePoints) : project(room.points)))
    {
      return false;
    }
    before += counts[n];
  }
  return true;
}

/// The number of samples to allocate before any is known: a multiple of the image's largest cross-section.
/// Memory that is never written to costs only address space.
std::size_t GuessCount(const glm::ivec3& samples)
{
  const auto area = [&](int a, int b) { return static_cast<std::size_t>(samples[a]) * samples[b]; };
  constexpr std::size_t surfaces = 12;
  return surfaces * std::max({ area(0, 1), area(0, 2), area(1, 2) });
}

} // namespace

vtkInkIsoSurfaceSampler::vtkInkIsoSurfaceSampler()
  : Internals(std::make_unique<vtkInternals>())
{
  // vtkContourValues initially holds one value.
  this->ContourValues->SetNumberOfContours(0);
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

vtkInkIsoSurfaceSampler::~vtkInkIsoSurfaceSampler() = default;

void vtkInkIsoSurfaceSampler::SetValue(int i, double value)
{
  this->ContourValues->SetValue(i, value);
}

double vtkInkIsoSurfaceSampler::GetValue(int i)
{
  return this->ContourValues->GetValue(i);
}

void vtkInkIsoSurfaceSampler::SetNumberOfContours(int number)
{
  this->ContourValues->SetNumberOfContours(number);
}

vtkIdType vtkInkIsoSurfaceSampler::GetNumberOfContours()
{
  return this->ContourValues->GetNumberOfContours();
}

void vtkInkIsoSurfaceSampler::GenerateValues(int numContours, double rangeStart, double rangeEnd)
{
  this->ContourValues->GenerateValues(numContours, rangeStart, rangeEnd);
}

const char* vtkInkIsoSurfaceSampler::GetCrossingRuleAsString()
{
  return this->CrossingRule == STRICT ? "Strict" : "HalfOpen";
}

const char* vtkInkIsoSurfaceSampler::GetSmoothingTargetAsString()
{
  return this->SmoothingTarget == NORMALS ? "Normals" : "Surface";
}

const char* vtkInkIsoSurfaceSampler::GetCutAsString()
{
  constexpr const char* names[] = { "Open", "Rim", "Cap" };
  return names[this->Cut];
}

const char* vtkInkIsoSurfaceSampler::GetNormalMethodAsString()
{
  constexpr const char* names[] = { "Cell", "InterpolatedGradient", "InterpolatedNormal", "Regression" };
  return names[this->NormalMethod];
}

const char* vtkInkIsoSurfaceSampler::GetOutputNormalsPrecisionAsString()
{
  return this->OutputNormalsPrecision == CHAR_PRECISION ? "Char"
    : this->OutputNormalsPrecision == SHORT_PRECISION   ? "Short"
                                                        : InkNameOfPrecision(this->OutputNormalsPrecision);
}

const char* vtkInkIsoSurfaceSampler::GetOutputPointsPrecisionAsString()
{
  return InkNameOfPrecision(this->OutputPointsPrecision);
}

const char* vtkInkIsoSurfaceSampler::GetArithmeticPrecisionAsString()
{
  return InkNameOfPrecision(this->ArithmeticPrecision);
}

vtkIdType vtkInkIsoSurfaceSampler::GetIndexMemory()
{
  return static_cast<vtkIdType>(this->Internals->Ranges.bytes() + this->Internals->TileRanges.bytes());
}

void vtkInkIsoSurfaceSampler::ReleaseIndex()
{
  this->Internals->ClearRanges();
}

vtkMTimeType vtkInkIsoSurfaceSampler::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->ContourValues->GetMTime());
}

int vtkInkIsoSurfaceSampler::FillInputPortInformation(int, vtkInformation* info)
{
  // Accepts other data than images, to explain what to do with them.
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  return 1;
}

int vtkInkIsoSurfaceSampler::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  // A normal at a piece's border depends on values across it, and the gradient at a point that has moved by
  // up to a cell on those beyond.
  using SDDP = vtkStreamingDemandDrivenPipeline;
  const int ghostLevels = output->GetInformationObject(0)->Get(SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS()) +
    ink::isoSurfaceResamplingReach(this->Smoothing, this->Subdivision) + (this->ProjectionSteps > 0 ? 1 : 0);
  input[0]->GetInformationObject(0)->Set(SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS(), ghostLevels);
  return 1;
}

int vtkInkIsoSurfaceSampler::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  try
  {
    this->SampleImage(inputVector, outputVector);
  }
  catch (...)
  {
    // Partially filled ranges must not be reused.
    this->Internals->ReleaseArrays();
    this->ReleaseIndex();
    InkReportException(this, vtkPolyData::GetData(outputVector), "The image cannot be sampled");
  }
  return 1;
}

void vtkInkIsoSurfaceSampler::SampleImage(
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* info = inputVector[0]->GetInformationObject(0);
  vtkDataSet* data = vtkDataSet::GetData(info);
  // An empty piece is not an error.
  if (!data || data->GetNumberOfPoints() == 0)
  {
    return;
  }
  auto* image = vtkImageData::SafeDownCast(data);
  if (!image)
  {
    vtkErrorMacro("The input is a " << data->GetClassName()
                                    << "; expected a vtkImageData. vtkResampleToImage makes one of a grid; "
                                       "vtkInkSurfaceSampler samples the surfaces of meshes and grids.");
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
  vtkInternals& internals = *this->Internals;
  SampleRequest request;
  request.IsoValues = std::span<const double>(
    this->ContourValues->GetValues(), static_cast<std::size_t>(this->ContourValues->GetNumberOfContours()));
  request.Options.rule =
    this->CrossingRule == STRICT ? ink::CrossingRule::Strict : ink::CrossingRule::HalfOpen;
  request.Options.method = static_cast<ink::NormalMethod>(this->NormalMethod);
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  request.Cells = InkSelectCells(info, outInfo, image);
  if (this->UseIndex)
  {
    internals.KeepRangesOf(scalars, image, this->ArrayComponent);
  }
  request.Expected = std::max(internals.Expected, std::size_t(1024));
  if (std::any_of(request.IsoValues.begin(), request.IsoValues.end(), [](double v) { return std::isnan(v); }))
  {
    vtkWarningMacro("An iso-value is not a number (NaN) and makes no points.");
  }

  const ink::GridGeometry geometry = InkMakeGrid(image, InkExtent(image->GetExtent()));
  const bool doubles = this->OutputPointsPrecision == DOUBLE_PRECISION ||
    (this->OutputPointsPrecision == DEFAULT_PRECISION && InkNeedsDoublePrecision(InkMakeGrid(image, whole)));
  request.Options.arithmetic = doubles || this->ArithmeticPrecision == DOUBLE_PRECISION
    ? ink::Arithmetic::Double
    : ink::Arithmetic::Single;
  if (internals.Expected == 0)
  {
    request.Expected = GuessCount(geometry.dimensions());
  }
  const ink::IsoSurfaceResampling resampling = ink::makeIsoSurfaceResampling(
    geometry, this->Smoothing, this->Subdivision, static_cast<ink::SmoothingTarget>(this->SmoothingTarget));
  const double radius = ink::isoSurfaceSampleRadius(ink::resampledGeometry(geometry, resampling.subdivision));
  internals.RenewPoints(doubles ? VTK_DOUBLE : VTK_FLOAT);
  const int normalType = this->OutputNormalsPrecision == SINGLE_PRECISION ? VTK_FLOAT
    : this->OutputNormalsPrecision == SHORT_PRECISION                     ? VTK_SHORT
                                                                          : VTK_SIGNED_CHAR;
  vtkInternals::Renew(internals.Normals, normalType, 3);
  const ink::ComponentSelection parts =
    ink::ComponentSelection{ this->SmallestPart, static_cast<std::size_t>(this->LargestParts) }
      .inDividedCells(this->Subdivision);
  const bool needsCells = this->ComputeCellIds || !parts.keepsAll();
  if (needsCells)
  {
    vtkInternals::Renew(internals.CellIds, VTK_TYPE_INT64, 1);
  }
  const InkSampleArrays arrays{ internals.Points->GetData(),
    this->ComputeNormals ? internals.Normals.Get() : nullptr,
    needsCells ? internals.CellIds.Get() : nullptr };
  const ink::GrowRoom grow = [&](std::size_t count)
  {
    vtkIdType capacity = VTK_ID_MAX;
    for (vtkDataArray* array : arrays.All())
    {
      InkReserve(array, static_cast<vtkIdType>(count));
      capacity = std::min(capacity, InkGetCapacity(array) / array->GetNumberOfComponents());
    }
    ink::SampleRoom room;
    room.capacity = static_cast<std::size_t>(capacity);
    room.points = PointerTo<float, vtkFloatArray>(arrays.Points);
    room.doublePoints = PointerTo<double, vtkDoubleArray>(arrays.Points);
    if (arrays.Normals)
    {
      room.normals = PointerTo<float, vtkFloatArray>(arrays.Normals);
      room.shortNormals = PointerTo<std::int16_t, vtkShortArray>(arrays.Normals);
      room.byteNormals = PointerTo<std::int8_t, vtkSignedCharArray>(arrays.Normals);
    }
    if (arrays.Cells)
    {
      room.cells = static_cast<ink::ActiveCellId*>(arrays.Cells->GetVoidPointer(0));
    }
    return room;
  };
  int component = this->ArrayComponent;
  const vtkSmartPointer<vtkDataArray> values = InkMakeContiguous(scalars, component);
  const ink::ElementMarks hidden = InkGetMarks(image->GetPointData(), vtkDataSetAttributes::HIDDENPOINT);
  const double share = this->ProjectionSteps > 0 && resampling.isIdentity() ? 0.5 : 1.0;
  const auto progressFrom = [this, share](double begin)
  {
    return [this, share, begin](double done)
    {
      this->UpdateProgress(begin + share * done);
      return !InkCheckAbort(this);
    };
  };
  std::vector<ink::CutSamples> cuts;
  const auto sample = [&](const auto& field)
  {
    for (std::size_t n = 0; this->Cut != OPEN && n < request.IsoValues.size(); ++n)
    {
      cuts.push_back(ink::sampleCut(field, request.IsoValues[n], static_cast<ink::CutSurface>(this->Cut),
        whole.First, whole.Last, request.Cells, resampling));
    }
    if (!resampling.isIdentity())
    {
      return ink::sampleResampledIsoSurfaces(field, request.IsoValues, request.Options, request.Cells,
        resampling, this->ProjectionSteps, this->UseIndex ? &internals.TileRanges : nullptr, grow,
        internals.Counts, progressFrom(0.0));
    }
    return ink::sampleIsoSurfaces(field, request.IsoValues, request.Options, request.Cells,
             this->UseIndex ? &internals.Ranges : nullptr, grow, request.Expected, internals.Counts,
             progressFrom(0.0)) &&
      (this->ProjectionSteps == 0 ||
        Project(field, request, this->ProjectionSteps, grow(0), internals.Counts, progressFrom(share)));
  };
  if (!InkWithGridField(geometry, values, component, hidden, sample))
  {
    internals.ReleaseArrays();
    return;
  }
  if (std::any_of(cuts.begin(), cuts.end(), [](const ink::CutSamples& cut) { return !cut.points.empty(); }))
  {
    InkAddCuts(cuts, arrays, internals.Counts);
  }
  if (!parts.keepsAll())
  {
    const auto* cells = static_cast<const ink::ActiveCellId*>(arrays.Cells->GetVoidPointer(0));
    const std::size_t count =
      std::accumulate(internals.Counts.begin(), internals.Counts.end(), std::size_t(0));
    InkKeepParts({ cells, count }, parts, arrays.All(), internals.Counts);
  }
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  this->FillOutput(radius, output);
  // A part of an image may legitimately have no points.
  if (output->GetNumberOfPoints() == 0 && InkIsWholeImage(info, outInfo, image))
  {
    const std::string outside =
      InkDescribeOutside(request.IsoValues, scalars, this->ArrayComponent, "points");
    if (!outside.empty())
    {
      vtkWarningMacro(<< outside);
    }
  }
}

void vtkInkIsoSurfaceSampler::FillOutput(double radius, vtkPolyData* output)
{
  vtkInternals& internals = *this->Internals;
  const std::size_t total = std::accumulate(internals.Counts.begin(), internals.Counts.end(), std::size_t(0));
  internals.Expected = total + total / 8;
  const vtkIdType count = static_cast<vtkIdType>(total);
  const auto finish = [count](vtkDataArray* array, const char* name)
  {
    InkSetNumberOfTuples(array, count);
    InkTrimArray(array);
    array->SetName(name);
    array->Modified();
  };

  finish(internals.Points->GetData(), nullptr);
  internals.Points->Modified();
  output->SetPoints(internals.Points);
  if (this->ComputeNormals)
  {
    finish(internals.Normals, "Normals");
    output->GetPointData()->SetNormals(internals.Normals);
  }
  if (this->ComputeRadius)
  {
    // The precision of the points: where float is too coarse for the points, it may be for the radius, too.
    vtkInternals::Renew(internals.Radii, internals.Points->GetDataType(), 1);
    finish(internals.Radii, "Radius");
    internals.Radii->Fill(radius);
    output->GetPointData()->AddArray(internals.Radii);
  }
  if (this->ComputeSurfaceIndex && internals.Counts.size() > 1)
  {
    vtkInternals::Renew(internals.SurfaceIndex, VTK_INT, 1);
    finish(internals.SurfaceIndex, "SurfaceIndex");
    int* index = PointerTo<int, vtkIntArray>(internals.SurfaceIndex);
    for (std::size_t n = 0; n < internals.Counts.size(); ++n)
    {
      index = std::fill_n(index, internals.Counts[n], static_cast<int>(n));
    }
    output->GetPointData()->AddArray(internals.SurfaceIndex);
  }
  if (this->ComputeCellIds)
  {
    finish(internals.CellIds, "CellId");
    output->GetPointData()->AddArray(internals.CellIds);
  }
  if (this->GenerateVertices && count > 0)
  {
    const bool small = count <= std::numeric_limits<vtkTypeInt32>::max();
    vtkInternals::Renew(internals.Vertices, small ? VTK_TYPE_INT32 : VTK_TYPE_INT64, 1);
    output->SetVerts(small ? MakePolyVertex<vtkTypeInt32Array>(internals.Vertices, count)
                           : MakePolyVertex<vtkTypeInt64Array>(internals.Vertices, count));
  }
  if (!this->ReuseArrays)
  {
    internals.ReleaseArrays();
  }
}

void vtkInkIsoSurfaceSampler::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CrossingRule: " << this->GetCrossingRuleAsString() << "\n"
     << indent << "NormalMethod: " << this->GetNormalMethodAsString() << "\n"
     << indent << "OutputNormalsPrecision: " << this->GetOutputNormalsPrecisionAsString() << "\n"
     << indent << "ComputeSurfaceIndex: " << this->ComputeSurfaceIndex << "\n"
     << indent << "ArithmeticPrecision: " << this->GetArithmeticPrecisionAsString() << "\n"
     << indent << "UseIndex: " << this->UseIndex << "\n"
     << indent << "IndexMemory: " << this->GetIndexMemory() << "\n"
     << indent << "ReuseArrays: " << this->ReuseArrays << "\n"
     << indent << "ComputeNormals: " << this->ComputeNormals << "\n"
     << indent << "ComputeRadius: " << this->ComputeRadius << "\n"
     << indent << "GenerateVertices: " << this->GenerateVertices << "\n"
     << indent << "Cut: " << this->GetCutAsString() << "\n"
     << indent << "SmallestPart: " << this->SmallestPart << "\n"
     << indent << "LargestParts: " << this->LargestParts << "\n"
     << indent << "ComputeCellIds: " << this->ComputeCellIds << "\n"
     << indent << "ArrayComponent: " << this->ArrayComponent << "\n"
     << indent << "OutputPointsPrecision: " << this->GetOutputPointsPrecisionAsString() << "\n"
     << indent << "ProjectionSteps: " << this->ProjectionSteps << "\n"
     << indent << "Smoothing: " << this->Smoothing << "\n"
     << indent << "SmoothingTarget: " << this->GetSmoothingTargetAsString() << "\n"
     << indent << "Subdivision: " << this->Subdivision << "\n"
     << indent << "ContourValues:\n";
  this->ContourValues->PrintSelf(os, indent.GetNextIndent());
}
