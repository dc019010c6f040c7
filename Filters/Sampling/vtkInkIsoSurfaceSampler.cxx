// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkIsoSurfaceSampler.h"

#include "Fields/Grid/GridField.h"
#include "InkAddCuts.h"
#include "InkCellCenters.h"
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

/// One run over all iso-values.
struct vtkInkIsoSurfaceSampler::Run
{
  ink::GridGeometry Geometry; ///< of the piece
  InkExtent Whole;
  ink::CellSelection Cells = {};
  std::vector<double> IsoValues = {};
  ink::SampleOptions Options = {};
  ink::CutSurface Cut = ink::CutSurface::Open;
  std::size_t Expected = 0;
  ink::IsoSurfaceResampling Resampling = {};
  ink::ComponentSelection Parts = {};
  int ProjectionSteps = 0;
  bool Doubles = false; ///< points
  bool UseIndex = false;
};

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

  InkPointInput Input;
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

  /// Samples the surfaces into the kept arrays. @return false when aborted
  template <class T>
  bool Sample(const ink::GridField<T>& field, const Run& run, const InkSampleArrays& arrays,
    const ink::Progress& progress)
  {
    const ink::GrowRoom grow = [&](std::size_t count) { return InkKeptSamples::Grow(arrays, count); };
    if (!run.Resampling.isIdentity())
    {
      return ink::sampleResampledIsoSurfaces(field, run.IsoValues, run.Options, run.Cells, run.Resampling,
        run.ProjectionSteps, run.UseIndex ? &this->TileRanges : nullptr, grow, this->Samples.Counts,
        progress);
    }
    // Half of the work, if there are steps.
    const double share = run.ProjectionSteps > 0 ? 0.5 : 1.0;
    const auto sampling = [&](double done) { return progress(share * done); };
    const auto projecting = [&](double done) { return progress(share + share * done); };
    return ink::sampleIsoSurfaces(field, run.IsoValues, run.Options, run.Cells,
             run.UseIndex ? &this->Ranges : nullptr, grow, run.Expected, this->Samples.Counts, sampling) &&
      (run.ProjectionSteps == 0 || this->Project(field, run, grow(0), projecting));
  }

  /// Adds the points of cuts to those of their surfaces, and leaves out the parts that are not wanted.
  void Finish(std::span<const ink::CutSamples> cuts, const Run& run, const InkSampleArrays& arrays)
  {
    std::vector<std::size_t>& counts = this->Samples.Counts;
    const auto sum = [&] { return std::accumulate(counts.begin(), counts.end(), std::size_t(0)); };
    if (std::any_of(cuts.begin(), cuts.end(), [](const ink::CutSamples& cut) { return !cut.points.empty(); }))
    {
      InkAddCuts(cuts, arrays, counts);
    }
    if (!run.Parts.keepsAll())
    {
      const auto* cells = static_cast<const ink::ActiveCellId*>(arrays.Cells->GetVoidPointer(0));
      InkKeepParts({ cells, sum() }, run.Parts, arrays.All(), counts);
    }
    this->Expected = sum() + sum() / 8;
  }

private:
  /// Moves the samples of each iso-value, which come one after the other. @return false when aborted
  template <class T>
  bool Project(const ink::GridField<T>& field, const Run& run, const ink::SampleRoom& room,
    const ink::Progress& progress) const
  {
    const std::vector<std::size_t>& counts = this->Samples.Counts;
    const double total =
      std::max(1.0, static_cast<double>(std::accumulate(counts.begin(), counts.end(), std::size_t(0))));
    std::size_t before = 0;
    for (std::size_t n = 0; n < counts.size(); ++n)
    {
      const auto part = [&](double done)
      { return progress((static_cast<double>(before) + done * static_cast<double>(counts[n])) / total); };
      const auto project = [&](auto* points)
      {
        return ink::projectSamples(field, field.geometry(), run.IsoValues[n], run.ProjectionSteps,
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
};

namespace
{

/// The number of samples to allocate before any is known: a multiple of the image's largest cross-section.
/// Memory that is never written to costs only address space.
std::size_t GuessCount(const glm::ivec3& samples)
{
  const auto area = [&](int a, int b) { return static_cast<std::size_t>(samples[a]) * samples[b]; };
  constexpr std::size_t surfaces = 12;
  return surfaces * std::max({ area(0, 1), area(0, 2), area(1, 2) });
}

/// What is added to each surface where it leaves the image; nothing where cuts are open.
template <class Field, class Run>
std::vector<ink::CutSamples> SampleCuts(const Field& field, const Run& run)
{
  std::vector<ink::CutSamples> cuts;
  for (std::size_t n = 0; run.Cut != ink::CutSurface::Open && n < run.IsoValues.size(); ++n)
  {
    cuts.push_back(ink::sampleCut(
      field, run.IsoValues[n], run.Cut, run.Whole.First, run.Whole.Last, run.Cells, run.Resampling));
  }
  return cuts;
}

/// @param precision of vtkInkIsoSurfaceSampler's normals @return VTK's type
int TypeOfNormals(int precision)
{
  return precision == vtkAlgorithm::SINGLE_PRECISION        ? VTK_FLOAT
    : precision == vtkInkIsoSurfaceSampler::SHORT_PRECISION ? VTK_SHORT
                                                            : VTK_SIGNED_CHAR;
}

} // namespace

vtkInkIsoSurfaceSampler::vtkInkIsoSurfaceSampler()
  : Internals(std::make_unique<vtkInternals>())
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

vtkInkIsoSurfaceSampler::~vtkInkIsoSurfaceSampler() = default;

const char* vtkInkIsoSurfaceSampler::GetOutputNormalsPrecisionAsString()
{
  return this->OutputNormalsPrecision == CHAR_PRECISION ? "Char"
    : this->OutputNormalsPrecision == SHORT_PRECISION   ? "Short"
                                                        : InkNameOfPrecision(this->OutputNormalsPrecision);
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
  vtkInformation* info = input[0]->GetInformationObject(0);
  const glm::ivec3 reach = ink::isoSurfaceResamplingReach(
    this->Smoothing, this->Subdivision, this->FindThickSlices(InkMakeFrame(info)));
  const int ghostLevels = output->GetInformationObject(0)->Get(SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS()) +
    std::max({ reach.x, reach.y, reach.z }) + (this->ProjectionSteps > 0 ? 1 : 0);
  info->Set(SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS(), ghostLevels + InkPointInput::GetGhostLevels(this, info));
  if (this->TakesSlabs(info, output->GetInformationObject(0)))
  {
    // They are asked for one by one.
    int nothing[6] = { 0, -1, 0, -1, 0, -1 };
    info->Set(SDDP::UPDATE_EXTENT(), nothing, 6);
  }
  return 1;
}

int vtkInkIsoSurfaceSampler::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  try
  {
    vtkInformation* info = inputVector[0]->GetInformationObject(0);
    this->TakesSlabs(info, outputVector->GetInformationObject(0))
      ? this->SampleSlabs(vtkPolyData::GetData(outputVector))
      : this->SampleImage(this->Internals->Input.Take(this, inputVector), outputVector);
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

vtkImageData* vtkInkIsoSurfaceSampler::TakeImage(vtkInformation* info)
{
  vtkDataSet* data = vtkDataSet::GetData(info);
  // An empty piece is not an error.
  if (!data || data->GetNumberOfPoints() == 0)
  {
    return nullptr;
  }
  auto* image = vtkImageData::SafeDownCast(data);
  if (!image)
  {
    vtkErrorMacro("The input is a " << data->GetClassName()
                                    << "; expected a vtkImageData. vtkResampleToImage makes one of a grid; "
                                       "vtkInkSurfaceSampler samples the surfaces of meshes and grids.");
    return nullptr;
  }
  const glm::ivec3 samples = InkGetWholeExtent(info, image).GetDimensions();
  if (std::min({ samples.x, samples.y, samples.z }) < 2)
  {
    vtkWarningMacro("The image has " << samples.x << " x " << samples.y << " x " << samples.z
                                     << " samples. An iso-surface needs at least 2 along each axis.");
    return nullptr;
  }
  return image;
}

vtkInkIsoSurfaceSampler::Run vtkInkIsoSurfaceSampler::MakeRun(
  vtkImageData* image, vtkInformation* input, vtkInformation* output)
{
  const ink::GridGeometry geometry = InkMakeGrid(image, InkExtent(image->GetExtent()));
  const InkExtent whole = InkGetWholeExtent(input, image);
  Run run{ geometry, whole };
  run.Cells = InkSelectCells(input, output, image);
  run.IsoValues = this->TakeIsoValues();
  run.Doubles = this->OutputPointsPrecision == DOUBLE_PRECISION ||
    (this->OutputPointsPrecision == DEFAULT_PRECISION && InkNeedsDoublePrecision(InkMakeGrid(image, whole)));
  run.Options = this->MakeSampleOptions();
  run.Options.arithmetic = run.Doubles || this->ArithmeticPrecision == DOUBLE_PRECISION
    ? ink::Arithmetic::Double
    : ink::Arithmetic::Single;
  run.Cut = static_cast<ink::CutSurface>(this->Cut);
  run.ProjectionSteps = this->ProjectionSteps;
  run.UseIndex = this->UseIndex;
  run.Expected = this->Internals->Expected == 0 ? GuessCount(geometry.dimensions())
                                                : std::max(this->Internals->Expected, std::size_t(1024));
  run.Resampling = ink::makeIsoSurfaceResampling(geometry, this->Smoothing, this->Subdivision,
    static_cast<ink::SmoothingTarget>(this->SmoothingTarget), this->LabelMap, this->ShapeBasedInterpolation);
  run.Resampling.borders = this->LabelBorders;
  run.Parts = ink::ComponentSelection{ this->SmallestPart, static_cast<std::size_t>(this->LargestParts) }
                .inDividedCells(this->Subdivision);
  return run;
}

void vtkInkIsoSurfaceSampler::SampleImage(
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* info = inputVector[0]->GetInformationObject(0);
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  vtkImageData* image = this->TakeImage(info);
  if (!image)
  {
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
  const Run run = this->MakeRun(image, info, outInfo);
  if (run.UseIndex)
  {
    internals.KeepRangesOf(scalars, image, this->ArrayComponent);
  }
  const InkSampleArrays arrays = internals.Samples.Renew(run.Doubles ? VTK_DOUBLE : VTK_FLOAT,
    this->ComputeNormals ? TypeOfNormals(this->OutputNormalsPrecision) : VTK_VOID,
    this->ComputeCellIds || !run.Parts.keepsAll());
  int component = this->ArrayComponent;
  const vtkSmartPointer<vtkDataArray> values = InkMakeContiguous(scalars, component);
  const ink::ElementMarks hidden = InkGetMarks(image->GetPointData(), vtkDataSetAttributes::HIDDENPOINT);
  const auto progress = [this](double done)
  {
    this->UpdateProgress(done);
    return !InkCheckAbort(this);
  };
  std::vector<ink::CutSamples> cuts;
  const auto sample = [&](const auto& field)
  {
    cuts = SampleCuts(field, run);
    return internals.Sample(field, run, arrays, progress);
  };
  if (!InkWithGridField(run.Geometry, values, component, hidden, sample))
  {
    internals.Samples.Release();
    return;
  }
  internals.Finish(cuts, run, arrays);
  const ink::GridGeometry sampled = ink::resampledGeometry(run.Geometry, run.Resampling.subdivision);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  internals.Samples.Fill(
    { this->ComputeNormals, this->ComputeSurfaceIndex, this->ComputeCellIds, this->GenerateVertices,
      this->ComputeRadius ? std::optional(ink::isoSurfaceSampleRadius(sampled)) : std::nullopt,
      this->Cut != OPEN },
    output);
  InkSetSampleCell(output, sampled);
  if (!this->ReuseArrays)
  {
    internals.Samples.Release();
  }
  // A part of an image may legitimately have no points.
  if (output->GetNumberOfPoints() == 0 && InkIsWholeImage(info, outInfo, image))
  {
    double range[2];
    scalars->GetFiniteRange(range, this->ArrayComponent);
    this->WarnIfOutside(run.IsoValues, range[0], range[1]);
  }
}

void vtkInkIsoSurfaceSampler::WarnIfOutside(
  const std::vector<double>& isoValues, double least, double greatest)
{
  const std::string outside = InkDescribeOutside(isoValues, least, greatest, "points");
  if (!outside.empty())
  {
    vtkWarningMacro(<< outside);
  }
}

void vtkInkIsoSurfaceSampler::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "OutputNormalsPrecision: " << this->GetOutputNormalsPrecisionAsString() << "\n"
     << indent << "UseIndex: " << this->UseIndex << "\n"
     << indent << "IndexMemory: " << this->GetIndexMemory() << "\n"
     << indent << "ReuseArrays: " << this->ReuseArrays << "\n"
     << indent << "ComputeCellIds: " << this->ComputeCellIds << "\n"
     << indent << "ArrayComponent: " << this->ArrayComponent << "\n";
}
