// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkVDBIsoSurfaceSampler.h"

#include "Fields/Vdb/VdbField.h"
#include "InkAllocate.h"
#include "InkImageGrid.h"
#include "InkPrecision.h"
#include "InkReportException.h"
#include "InkSampleCell.h"
#include "InkVDBSource.h"
#include "InkVTKCompat.h"
#include "IsoSurface/IsoSurfaceSamples.h"
#include "IsoSurface/ProjectSamples.h"
#include "IsoSurface/Vdb/VdbSamples.h"
#include "IsoSurface/Vdb/VdbTiles.h"

#include "vtkCellArray.h"
#include "vtkContourValues.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <span>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkInkVDBIsoSurfaceSampler);

namespace
{

/// A piece's share of the blocks.
ink::VdbActiveCells ShareOf(ink::VdbActiveCells cells, int piece, int pieces)
{
  const auto at = [&](int n)
  {
    return cells.blocks.begin() +
      static_cast<std::ptrdiff_t>(
        cells.blocks.size() * static_cast<std::size_t>(n) / static_cast<std::size_t>(pieces));
  };
  ink::VdbActiveCells share;
  share.blocks.assign(at(piece), at(piece + 1));
  for (ink::VdbActiveCells::Block& block : share.blocks)
  {
    block.before = share.count;
    for (const std::uint64_t layer : block.cells)
    {
      share.count += static_cast<std::size_t>(std::popcount(layer));
    }
  }
  return share;
}

/// The active cells of several surfaces, and the output positions of their samples.
struct Surfaces
{
  std::vector<double> IsoValues;
  std::vector<ink::VdbActiveCells> Cells;
  std::size_t Count = 0;
};

template <class Array, class NextStep>
bool PlaceSamples(const ink::VdbGrid& grid, const Surfaces& surfaces, const ink::SampleOptions& options,
  bool negate, int projectionSteps, Array* points, vtkFloatArray* normals, const NextStep& nextStep)
{
  using Real = typename Array::ValueType;
  InkSetNumberOfTuples(points, static_cast<vtkIdType>(surfaces.Count));
  Real* point = points->GetPointer(0);
  float* normal = normals ? normals->GetPointer(0) : nullptr;
  // As in the dense copy, inactive voxels have their values.
  const ink::VdbField field(grid, ink::VdbField::Inactive::Background);
  const ink::GridGeometry geometry = grid.geometry(grid.activeBox());
  for (std::size_t i = 0; i < surfaces.Cells.size(); ++i)
  {
    const std::size_t size = 3 * surfaces.Cells[i].count;
    if (!ink::placeIsoSurfaceSamples(grid, surfaces.IsoValues[i], options, negate, surfaces.Cells[i],
          std::span<Real>(point, size), std::span<float>(normal, normal ? size : 0), nextStep()))
    {
      return false;
    }
    // Of -f the surface is at minus the iso-value, and the steps to it are the same.
    const double isoValue = negate ? -surfaces.IsoValues[i] : surfaces.IsoValues[i];
    if (projectionSteps > 0 &&
      !ink::projectSamples(
        field, geometry, isoValue, projectionSteps, std::span<Real>(point, size), nextStep()))
    {
      return false;
    }
    point += size;
    normal += normal ? size : 0;
  }
  return true;
}

/// @param counts the points of each surface
vtkSmartPointer<vtkIntArray> IndexOf(const std::vector<std::size_t>& counts)
{
  vtkNew<vtkIntArray> index;
  index->SetName("SurfaceIndex");
  InkSetNumberOfTuples(
    index, static_cast<vtkIdType>(std::accumulate(counts.begin(), counts.end(), std::size_t(0))));
  int* next = index->GetPointer(0);
  for (std::size_t i = 0; i < counts.size(); ++i)
  {
    next = std::fill_n(next, counts[i], static_cast<int>(i));
  }
  return index;
}

/// @return false when stopped
template <class Array>
bool SampleTiles(const ink::VdbGrid& grid, const std::vector<double>& isoValues,
  const ink::VdbTileOptions& options, Array* points, vtkFloatArray* normals, std::vector<std::size_t>& counts,
  const ink::Progress& progress)
{
  ink::VdbTileSamples<typename Array::ValueType> samples;
  if (!ink::sampleVdbTiles(grid, isoValues, options, samples, progress))
  {
    return false;
  }
  InkSetNumberOfTuples(points, static_cast<vtkIdType>(samples.points.size() / 3));
  std::copy(samples.points.begin(), samples.points.end(), points->GetPointer(0));
  if (normals)
  {
    InkSetNumberOfTuples(normals, points->GetNumberOfTuples());
    std::copy(samples.normals.begin(), samples.normals.end(), normals->GetPointer(0));
  }
  counts = samples.counts;
  return true;
}

} // namespace

vtkInkVDBIsoSurfaceSampler::vtkInkVDBIsoSurfaceSampler()
  : Source(std::make_unique<InkVDBSource>())
{
  this->SetNumberOfInputPorts(0);
  // vtkContourValues initially holds one value.
  this->ContourValues->SetNumberOfContours(0);
}

vtkInkVDBIsoSurfaceSampler::~vtkInkVDBIsoSurfaceSampler()
{
  this->SetFileName(nullptr);
  this->SetGridName(nullptr);
}

vtkStringArray* vtkInkVDBIsoSurfaceSampler::GetGridNames()
{
  return this->Names;
}

void vtkInkVDBIsoSurfaceSampler::SetValue(int i, double value)
{
  this->ContourValues->SetValue(i, value);
}

double vtkInkVDBIsoSurfaceSampler::GetValue(int i)
{
  return this->ContourValues->GetValue(i);
}

void vtkInkVDBIsoSurfaceSampler::SetNumberOfContours(int number)
{
  this->ContourValues->SetNumberOfContours(number);
}

vtkIdType vtkInkVDBIsoSurfaceSampler::GetNumberOfContours()
{
  return this->ContourValues->GetNumberOfContours();
}

void vtkInkVDBIsoSurfaceSampler::GenerateValues(int numContours, double rangeStart, double rangeEnd)
{
  this->ContourValues->GenerateValues(numContours, rangeStart, rangeEnd);
}

const char* vtkInkVDBIsoSurfaceSampler::GetCrossingRuleAsString()
{
  return this->CrossingRule == STRICT ? "Strict" : "HalfOpen";
}

const char* vtkInkVDBIsoSurfaceSampler::GetNormalMethodAsString()
{
  constexpr const char* names[] = { "Cell", "InterpolatedGradient", "InterpolatedNormal", "Regression" };
  return names[this->NormalMethod];
}

const char* vtkInkVDBIsoSurfaceSampler::GetOutputPointsPrecisionAsString()
{
  return InkNameOfPrecision(this->OutputPointsPrecision);
}

const char* vtkInkVDBIsoSurfaceSampler::GetArithmeticPrecisionAsString()
{
  return InkNameOfPrecision(this->ArithmeticPrecision);
}

const char* vtkInkVDBIsoSurfaceSampler::GetSmoothingTargetAsString()
{
  return this->SmoothingTarget == NORMALS ? "Normals" : "Surface";
}

const char* vtkInkVDBIsoSurfaceSampler::GetCutAsString()
{
  return this->Cut == CAP ? "Cap" : this->Cut == RIM ? "Rim" : "Open";
}

bool vtkInkVDBIsoSurfaceSampler::SamplesTiles() const
{
  return this->Smoothing > 0.0 || this->Subdivision > 1 || this->Cut != OPEN || this->SmallestPart != 0.0 ||
    this->LargestParts > 0;
}

vtkMTimeType vtkInkVDBIsoSurfaceSampler::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->ContourValues->GetMTime());
}

int vtkInkVDBIsoSurfaceSampler::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  outputVector->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  this->Names->SetNumberOfValues(0);
  this->Failed = true;
  try
  {
    for (const ink::VdbGridInfo& grid : this->Source->List(InkTextOf(this->FileName)).grids)
    {
      if (grid.problem.empty())
      {
        this->Names->InsertNextValue(grid.name);
      }
    }
    this->Failed = false;
  }
  catch (const ink::VdbError& error)
  {
    vtkErrorMacro(<< error.what() << ".");
  }
  catch (...)
  {
    InkReportException(this, nullptr, "Cannot read \"" + InkTextOf(this->FileName) + "\"");
  }
  return 1;
}

int vtkInkVDBIsoSurfaceSampler::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  using SDDP = vtkStreamingDemandDrivenPipeline;
  if (this->Failed)
  {
    return 1;
  }
  vtkInformation* info = outputVector->GetInformationObject(0);
  vtkPolyData* output = vtkPolyData::GetData(info);
  try
  {
    const ink::VdbGrid& grid =
      this->Source->Read(InkTextOf(this->FileName), InkTextOf(this->GridName), this->MaximumMemory);
    const bool levelSet = grid.info().gridClass == ink::VdbClass::LevelSet;
    const bool negate = this->InvertLevelSets && levelSet;
    ink::SampleOptions options;
    options.rule = this->CrossingRule == STRICT ? ink::CrossingRule::Strict : ink::CrossingRule::HalfOpen;
    options.method = static_cast<ink::NormalMethod>(this->NormalMethod);
    Surfaces surfaces;
    surfaces.IsoValues.assign(this->ContourValues->GetValues(),
      this->ContourValues->GetValues() + this->ContourValues->GetNumberOfContours());
    if (surfaces.IsoValues.empty() && levelSet)
    {
      surfaces.IsoValues.push_back(0.0);
    }
    if (std::any_of(
          surfaces.IsoValues.begin(), surfaces.IsoValues.end(), [](double v) { return std::isnan(v); }))
    {
      vtkWarningMacro("An iso-value is not a number (NaN) and makes no points.");
    }
    // One step to find an iso-value's cells, one to place its samples and one to project them.
    double step = 0.0;
    const double steps = (this->ProjectionSteps > 0 ? 3.0 : 2.0) *
      std::max<double>(1.0, static_cast<double>(surfaces.IsoValues.size()));
    const auto nextStep = [&]() -> ink::Progress
    {
      return [this, before = step++, steps](double fraction)
      {
        this->UpdateProgress((before + fraction) / steps);
        return !InkCheckAbort(this);
      };
    };
    const int pieces = std::max(info->Get(SDDP::UPDATE_NUMBER_OF_PIECES()), 1);
    const int piece = std::clamp(info->Get(SDDP::UPDATE_PIECE_NUMBER()), 0, pieces - 1);
    const std::uint64_t most = static_cast<std::uint64_t>(this->MaximumMemory) << 20;
    const std::uint64_t allowed = most == 0 ? ink::VdbGrid::noLimit : most - std::min(most, grid.memory());
    for (std::size_t n = 0; n < surfaces.IsoValues.size() && !this->SamplesTiles(); ++n)
    {
      const double isoValue = surfaces.IsoValues[n];
      surfaces.Cells.push_back(ShareOf(
        ink::findActiveCells(grid, isoValue, options.rule, negate, nextStep(), allowed), piece, pieces));
      if (InkCheckAbort(this))
      {
        return 1;
      }
      surfaces.Count += surfaces.Cells.back().count;
      // Per sample a point, a normal and at most a radius, an index and a vertex.
      constexpr std::uint64_t bytesPerPoint = 48;
      if (surfaces.Count > allowed / bytesPerPoint)
      {
        throw ink::VdbTooLarge("the surface has " + std::to_string(surfaces.Count) +
          " points or more, which take " + InkMebibytes(static_cast<double>(surfaces.Count * bytesPerPoint)));
      }
    }

    const ink::GridGeometry geometry = grid.geometry(grid.activeBox());
    const bool doubles = this->OutputPointsPrecision == DOUBLE_PRECISION ||
      (this->OutputPointsPrecision == DEFAULT_PRECISION && (surfaces.Count > 0 || this->SamplesTiles()) &&
        InkNeedsDoublePrecision(geometry));
    options.arithmetic = doubles || this->ArithmeticPrecision == DOUBLE_PRECISION ? ink::Arithmetic::Double
                                                                                  : ink::Arithmetic::Single;
    vtkNew<vtkPoints> points;
    points->SetDataType(doubles ? VTK_DOUBLE : VTK_FLOAT);
    vtkNew<vtkFloatArray> normals;
    normals->SetNumberOfComponents(3);
    InkSetNumberOfTuples(normals, this->ComputeNormals ? static_cast<vtkIdType>(surfaces.Count) : 0);
    vtkFloatArray* wanted = this->ComputeNormals ? normals.Get() : nullptr;
    std::vector<std::size_t> counts;
    if (this->SamplesTiles())
    {
      ink::VdbTileOptions tiles;
      tiles.samples = options;
      tiles.negate = negate;
      tiles.smoothing = this->Smoothing;
      tiles.subdivision = this->Subdivision;
      tiles.target = static_cast<ink::SmoothingTarget>(this->SmoothingTarget);
      tiles.projectionSteps = this->ProjectionSteps;
      tiles.cut = static_cast<ink::CutSurface>(this->Cut);
      tiles.parts = { this->SmallestPart, static_cast<std::size_t>(this->LargestParts) };
      tiles.normals = this->ComputeNormals;
      tiles.piece = piece;
      tiles.pieces = pieces;
      tiles.memory = allowed;
      const auto progress = [this](double done)
      {
        this->UpdateProgress(done);
        return !InkCheckAbort(this);
      };
      const auto sample = [&](auto* array)
      { return SampleTiles(grid, surfaces.IsoValues, tiles, array, wanted, counts, progress); };
      if (!(doubles ? sample(vtkDoubleArray::SafeDownCast(points->GetData()))
                    : sample(vtkFloatArray::SafeDownCast(points->GetData()))))
      {
        return 1;
      }
      const ink::IsoSurfaceResampling resampling =
        ink::makeIsoSurfaceResampling(geometry, this->Smoothing, this->Subdivision, tiles.target);
      const bool indexed = this->ComputeSurfaceIndex && surfaces.IsoValues.size() > 1;
      const vtkSmartPointer<vtkIntArray> index = indexed ? IndexOf(counts) : nullptr;
      const ink::GridGeometry sampled = ink::resampledGeometry(geometry, resampling.subdivision);
      this->FillOutput(points, wanted, index, ink::isoSurfaceSampleRadius(sampled), output);
      InkSetSampleCell(output, sampled);
      return 1;
    }
    for (const ink::VdbActiveCells& cells : surfaces.Cells)
    {
      counts.push_back(cells.count);
    }
    const bool whole = doubles ? PlaceSamples(grid, surfaces, options, negate, this->ProjectionSteps,
                                   vtkDoubleArray::SafeDownCast(points->GetData()), wanted, nextStep)
                               : PlaceSamples(grid, surfaces, options, negate, this->ProjectionSteps,
                                   vtkFloatArray::SafeDownCast(points->GetData()), wanted, nextStep);
    if (!whole)
    {
      return 1;
    }
    vtkSmartPointer<vtkIntArray> surfaceIndex;
    if (this->ComputeSurfaceIndex && surfaces.IsoValues.size() > 1)
    {
      surfaceIndex = IndexOf(counts);
    }
    this->FillOutput(points, wanted, surfaceIndex, ink::isoSurfaceSampleRadius(geometry), output);
    InkSetSampleCell(output, geometry);
  }
  catch (const ink::VdbTooLarge& error)
  {
    vtkErrorMacro("Cannot sample \"" << InkTextOf(this->FileName) << "\": " << error.what()
                                     << "; allowed are " << this->MaximumMemory
                                     << " MiB for it and the grid (MaximumMemory).");
  }
  catch (const ink::VdbError& error)
  {
    vtkErrorMacro(<< error.what() << ".");
  }
  catch (...)
  {
    InkReportException(this, output, "Cannot sample \"" + InkTextOf(this->FileName) + "\"");
  }
  return 1;
}

void vtkInkVDBIsoSurfaceSampler::FillOutput(
  vtkPoints* points, vtkFloatArray* normals, vtkIntArray* surfaceIndex, double radius, vtkPolyData* output)
{
  const vtkIdType count = points->GetNumberOfPoints();
  output->SetPoints(points);
  if (normals)
  {
    normals->SetName("Normals");
    output->GetPointData()->SetNormals(normals);
  }
  if (this->ComputeRadius)
  {
    vtkSmartPointer<vtkDataArray> radii =
      vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(points->GetDataType()));
    radii->SetName("Radius");
    InkSetNumberOfTuples(radii, count);
    radii->Fill(radius);
    output->GetPointData()->AddArray(radii);
  }
  if (surfaceIndex)
  {
    output->GetPointData()->AddArray(surfaceIndex);
  }
  if (this->GenerateVertices && count > 0)
  {
    vtkNew<vtkIdTypeArray> offsets;
    offsets->InsertNextValue(0);
    offsets->InsertNextValue(count);
    vtkNew<vtkIdTypeArray> ids;
    InkSetNumberOfTuples(ids, count);
    std::iota(ids->GetPointer(0), ids->GetPointer(0) + count, vtkIdType(0));
    vtkNew<vtkCellArray> cells;
    cells->SetData(offsets, ids);
    output->SetVerts(cells);
  }
}

void vtkInkVDBIsoSurfaceSampler::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << InkTextOf(this->FileName) << "\n"
     << indent << "GridName: " << InkTextOf(this->GridName) << "\n"
     << indent << "InvertLevelSets: " << this->InvertLevelSets << "\n"
     << indent << "CrossingRule: " << this->GetCrossingRuleAsString() << "\n"
     << indent << "NormalMethod: " << this->GetNormalMethodAsString() << "\n"
     << indent << "ComputeNormals: " << this->ComputeNormals << "\n"
     << indent << "ComputeSurfaceIndex: " << this->ComputeSurfaceIndex << "\n"
     << indent << "ComputeRadius: " << this->ComputeRadius << "\n"
     << indent << "GenerateVertices: " << this->GenerateVertices << "\n"
     << indent << "OutputPointsPrecision: " << this->GetOutputPointsPrecisionAsString() << "\n"
     << indent << "ProjectionSteps: " << this->ProjectionSteps << "\n"
     << indent << "Smoothing: " << this->Smoothing << "\n"
     << indent << "SmoothingTarget: " << this->GetSmoothingTargetAsString() << "\n"
     << indent << "Subdivision: " << this->Subdivision << "\n"
     << indent << "Cut: " << this->GetCutAsString() << "\n"
     << indent << "SmallestPart: " << this->SmallestPart << "\n"
     << indent << "LargestParts: " << this->LargestParts << "\n"
     << indent << "ArithmeticPrecision: " << this->GetArithmeticPrecisionAsString() << "\n"
     << indent << "MaximumMemory: " << this->MaximumMemory << "\n"
     << indent << "ContourValues:\n";
  this->ContourValues->PrintSelf(os, indent.GetNextIndent());
}
