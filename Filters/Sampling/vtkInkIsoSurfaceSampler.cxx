// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkIsoSurfaceSampler.h"

#include "Fields/Grid/GridField.h"
#include "InkAddCuts.h"
#include "InkImageGrid.h"
#include "InkKeptSamples.h"
#include "InkOutsideRange.h"
#include "InkPrecision.h"
#include "InkReportException.h"
#include "InkSampleCell.h"
#include "InkSurfaceParts.h"
#include "InkVTKCompat.h"
#include "InkWithGridField.h"
#include "IsoSurface/IsoSurfaceSamples.h"
#include "IsoSurface/MinMaxBricks.h"
#include "IsoSurface/ProjectSamples.h"
#include "IsoSurface/ResampledSamples.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkContourValues.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkWeakPointer.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
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

  InkKeptSamples Samples;
  std::size_t Expected = 0; ///< samples of the next run

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
  const std::size_t bytes = this->Internals->Ranges.bytes() + this->Internals->TileRanges.bytes();
  return static_cast<vtkIdType>(bytes);
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
    this->Internals->Samples.Release();
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
  const ink::GridGeometry sampled = ink::resampledGeometry(geometry, resampling.subdivision);
  const double radius = ink::isoSurfaceSampleRadius(sampled);
  const int normalType = !this->ComputeNormals         ? VTK_VOID
    : this->OutputNormalsPrecision == SINGLE_PRECISION ? VTK_FLOAT
    : this->OutputNormalsPrecision == SHORT_PRECISION  ? VTK_SHORT
                                                       : VTK_SIGNED_CHAR;
  const ink::ComponentSelection parts =
    ink::ComponentSelection{ this->SmallestPart, static_cast<std::size_t>(this->LargestParts) }
      .inDividedCells(this->Subdivision);
  const InkSampleArrays arrays = internals.Samples.Renew(
    doubles ? VTK_DOUBLE : VTK_FLOAT, normalType, this->ComputeCellIds || !parts.keepsAll());
  const ink::GrowRoom grow = [&](std::size_t count) { return InkKeptSamples::Grow(arrays, count); };
  std::vector<std::size_t>& counts = internals.Samples.Counts;
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
        resampling, this->ProjectionSteps, this->UseIndex ? &internals.TileRanges : nullptr, grow, counts,
        progressFrom(0.0));
    }
    return ink::sampleIsoSurfaces(field, request.IsoValues, request.Options, request.Cells,
             this->UseIndex ? &internals.Ranges : nullptr, grow, request.Expected, counts,
             progressFrom(0.0)) &&
      (this->ProjectionSteps == 0 ||
        Project(field, request, this->ProjectionSteps, grow(0), counts, progressFrom(share)));
  };
  if (!InkWithGridField(geometry, values, component, hidden, sample))
  {
    internals.Samples.Release();
    return;
  }
  if (std::any_of(cuts.begin(), cuts.end(), [](const ink::CutSamples& cut) { return !cut.points.empty(); }))
  {
    InkAddCuts(cuts, arrays, counts);
  }
  if (!parts.keepsAll())
  {
    const auto* cells = static_cast<const ink::ActiveCellId*>(arrays.Cells->GetVoidPointer(0));
    const std::size_t count = std::accumulate(counts.begin(), counts.end(), std::size_t(0));
    InkKeepParts({ cells, count }, parts, arrays.All(), counts);
  }
  const std::size_t total = std::accumulate(counts.begin(), counts.end(), std::size_t(0));
  internals.Expected = total + total / 8;
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  internals.Samples.Fill(
    { this->ComputeNormals, this->ComputeSurfaceIndex, this->ComputeCellIds, this->GenerateVertices,
      this->ComputeRadius ? std::optional(radius) : std::nullopt },
    output);
  InkSetSampleCell(output, sampled);
  if (!this->ReuseArrays)
  {
    internals.Samples.Release();
  }
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
