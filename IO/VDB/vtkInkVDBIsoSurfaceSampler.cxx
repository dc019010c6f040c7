// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkVDBIsoSurfaceSampler.h"

#include "InkImageGrid.h"
#include "InkMemoryBudget.h"
#include "InkPointOutput.h"
#include "InkPrecision.h"
#include "InkReportException.h"
#include "InkSampleCell.h"
#include "InkVDBSamples.h"
#include "InkVDBSource.h"
#include "InkVTKCompat.h"
#include "IsoSurface/IsoSurfaceSamples.h"
#include "IsoSurface/Vdb/VdbSamples.h"
#include "Statistics/FiniteRange.h"
#include "Statistics/Vdb/VdbNoiseEstimate.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkInkVDBReader.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace
{

/// The values; without any, that of the surface that a grid is about, if it is about one.
std::vector<double> OrSurface(std::vector<double> values, const ink::VdbGridInfo& grid)
{
  if (values.empty() && grid.surface)
  {
    values.push_back(*grid.surface);
  }
  return values;
}

} // namespace

vtkStandardNewMacro(vtkInkVDBIsoSurfaceSampler);

vtkInkVDBIsoSurfaceSampler::vtkInkVDBIsoSurfaceSampler()
  : Source(std::make_unique<InkVDBSource>())
{
  this->SetNumberOfInputPorts(0);
  this->MaximumMemory = 4096;
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
  vtkInformation* info = outputVector->GetInformationObject(0);
  vtkPolyData* output = vtkPolyData::GetData(info);
  this->TrySampling(output,
    [&]
    {
      const int pieces = std::max(info->Get(SDDP::UPDATE_NUMBER_OF_PIECES()), 1);
      const int piece = std::clamp(info->Get(SDDP::UPDATE_PIECE_NUMBER()), 0, pieces - 1);
      const auto progress = [this](double done)
      {
        this->UpdateProgress(done);
        return !InkCheckAbort(this);
      };
      const ink::VdbGrid& grid = this->ReadGrid();
      if (const std::optional<InkVDBSamples> samples =
            InkSampleVDB(grid, this->MakeRequest(grid, this->TakeIsoValues(), piece, pieces), progress))
      {
        this->FillOutput(*samples, output);
      }
    });
  return 1;
}

bool vtkInkVDBIsoSurfaceSampler::SampleParts(const PartSink& sink)
{
  this->UpdateInformation();
  return this->TrySampling(nullptr,
    [&]
    {
      const ink::VdbGrid& grid = this->ReadGrid();
      const std::vector<double> isoValues = this->TakeIsoValues();
      const int pieces = this->CountPieces(grid);
      // Without values that of the file.
      const std::size_t surfaces = std::max<std::size_t>(isoValues.size(), 1);
      const double parts = static_cast<double>(surfaces) * pieces;
      double before = 0.0;
      const auto progress = [&](double done)
      {
        this->UpdateProgress((before + done) / parts);
        return !InkCheckAbort(this);
      };
      for (std::size_t surface = 0; surface < surfaces; ++surface)
      {
        std::vector<double> own;
        if (!isoValues.empty())
        {
          own.push_back(isoValues[surface]);
        }
        for (int piece = 0; piece < pieces; ++piece, ++before)
        {
          const std::optional<InkVDBSamples> samples =
            InkSampleVDB(grid, this->MakeRequest(grid, own, piece, pieces), progress);
          if (!samples)
          {
            return;
          }
          vtkNew<vtkPolyData> part;
          this->FillOutput(*samples, part);
          part->SetVerts(nullptr);
          sink(static_cast<int>(surface), part);
        }
      }
    });
}

int vtkInkVDBIsoSurfaceSampler::CountPieces(const ink::VdbGrid& grid) const
{
  // Which parts of a surface are small each piece would look at again.
  if (this->SmallestPart != 0.0 || this->LargestParts != 0)
  {
    return 1;
  }
  const std::uint64_t voxels = grid.memory() / (grid.info().isDouble ? sizeof(double) : sizeof(float));
  const auto subdivision = static_cast<std::uint64_t>(this->Subdivision);
  const std::uint64_t room = InkMemoryBudget::OfMebibytes(this->MaximumMemory).ForNewPoints();
  return static_cast<int>(
    voxels * subdivision * subdivision * InkBytesPerPoint / std::max<std::uint64_t>(room, 1) + 1);
}

bool vtkInkVDBIsoSurfaceSampler::Negates(const ink::VdbGrid& grid) const
{
  return this->InvertLevelSets && grid.info().gridClass == ink::VdbClass::LevelSet;
}

std::uint64_t vtkInkVDBIsoSurfaceSampler::MemoryBeside(const ink::VdbGrid& grid) const
{
  const std::uint64_t most = static_cast<std::uint64_t>(this->MaximumMemory) << 20;
  return most == 0 ? ink::VdbGrid::noLimit : most - std::min(most, grid.memory());
}

ink::SuggestedSmoothing vtkInkVDBIsoSurfaceSampler::SuggestSmoothings(double isoValue)
{
  ink::SuggestedSmoothing smoothing;
  this->UpdateInformation();
  this->TrySampling(nullptr,
    [&]
    {
      const ink::VdbGrid& grid = this->ReadGrid();
      smoothing =
        ink::suggestSmoothings(ink::estimateNoise(grid, isoValue, this->Negates(grid)), grid.info().spacing);
    });
  return smoothing;
}

vtkIdType vtkInkVDBIsoSurfaceSampler::CountActiveCells(double isoValue)
{
  vtkIdType count = 0;
  this->UpdateInformation();
  this->TrySampling(nullptr,
    [&]
    {
      const ink::VdbGrid& grid = this->ReadGrid();
      const auto rule = static_cast<ink::CrossingRule>(this->CrossingRule);
      count = static_cast<vtkIdType>(
        ink::findActiveCells(grid, isoValue, rule, this->Negates(grid), {}, this->MemoryBeside(grid)).count);
    });
  return count;
}

std::vector<double> vtkInkVDBIsoSurfaceSampler::FindIsoValues()
{
  std::vector<double> values = this->Superclass::FindIsoValues();
  this->UpdateInformation();
  if (values.empty() && !this->Failed)
  {
    this->TrySampling(nullptr,
      [&]
      {
        const std::string file = InkTextOf(this->FileName);
        values = OrSurface({}, this->Source->List(file).find(InkTextOf(this->GridName)));
      });
  }
  return values;
}

vtkSmartPointer<vtkImageData> vtkInkVDBIsoSurfaceSampler::MakeFrame()
{
  vtkNew<vtkInkVDBReader> reader;
  reader->SetFileName(this->FileName);
  reader->SetGridName(this->GridName);
  reader->SetMaximumMemory(this->MaximumMemory);
  reader->UpdateInformation();
  return InkMakeFrame(reader->GetOutputInformation(0));
}

ink::FiniteRange vtkInkVDBIsoSurfaceSampler::FindRange()
{
  const ink::VdbGrid& grid = this->ReadGrid();
  return grid.values(this->Negates(grid));
}

const ink::VdbGrid& vtkInkVDBIsoSurfaceSampler::ReadGrid()
{
  return this->Source->Read(InkTextOf(this->FileName), InkTextOf(this->GridName), this->MaximumMemory);
}

InkVDBSampleRequest vtkInkVDBIsoSurfaceSampler::MakeRequest(
  const ink::VdbGrid& grid, std::vector<double> isoValues, int piece, int pieces) const
{
  InkVDBSampleRequest request;
  request.IsoValues = OrSurface(std::move(isoValues), grid.info());
  request.DoubleArithmetic = this->ArithmeticPrecision == DOUBLE_PRECISION;
  request.PointsPrecision = this->OutputPointsPrecision;
  ink::VdbTileOptions& options = request.Options;
  options.samples = this->MakeSampleOptions();
  options.negate = this->Negates(grid);
  options.smoothing = this->Smoothing;
  options.subdivision = this->Subdivision;
  options.target = static_cast<ink::SmoothingTarget>(this->SmoothingTarget);
  options.ofMask = this->LabelMap;
  options.borders = this->LabelBorders;
  options.shapeBased =
    this->ShapeBasedInterpolation && ink::thickSlices(grid.geometry(grid.activeBox()).spacing());
  options.projectionSteps = this->ProjectionSteps;
  options.cut = static_cast<ink::CutSurface>(this->Cut);
  options.parts = { this->SmallestPart, static_cast<std::size_t>(this->LargestParts) };
  options.normals = this->ComputeNormals;
  options.pieces = pieces;
  options.piece = piece;
  options.memory = this->MemoryBeside(grid);
  return request;
}

bool vtkInkVDBIsoSurfaceSampler::TrySampling(vtkPolyData* output, const std::function<void()>& sample)
{
  if (this->Failed)
  {
    return false;
  }
  try
  {
    sample();
    return true;
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
  return false;
}

void vtkInkVDBIsoSurfaceSampler::FillOutput(const InkVDBSamples& samples, vtkPolyData* output)
{
  const vtkIdType count = samples.Points->GetNumberOfPoints();
  vtkPointData* data = output->GetPointData();
  output->SetPoints(samples.Points);
  if (samples.Normals)
  {
    data->SetNormals(samples.Normals);
  }
  if (this->ComputeRadius)
  {
    const vtkSmartPointer<vtkDataArray> radii = InkMakeConstant(
      "Radius", samples.Points->GetDataType(), count, ink::isoSurfaceSampleRadius(samples.Cells));
    if (this->Cut != OPEN)
    {
      InkNarrowRims(samples.Points, radii);
    }
    data->AddArray(radii);
  }
  if (this->ComputeSurfaceIndex && samples.Counts.size() > 1)
  {
    data->AddArray(InkMakeSurfaceIndex(samples.Counts));
  }
  if (this->GenerateVertices && count > 0)
  {
    output->SetVerts(InkMakePolyVertex(count));
  }
  InkSetSampleCell(output, samples.Cells);
}

void vtkInkVDBIsoSurfaceSampler::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << InkTextOf(this->FileName) << "\n"
     << indent << "GridName: " << InkTextOf(this->GridName) << "\n"
     << indent << "InvertLevelSets: " << this->InvertLevelSets << "\n";
}
