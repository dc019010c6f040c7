// SPDX-License-Identifier: BSD-3-Clause
// vtkInkIsoSurfaceSampler of images that it asks for a few slices at a time.
#include "vtkInkIsoSurfaceSampler.h"

#include "Fields/Resampling/SliceDistances.h"
#include "InkCellCenters.h"
#include "InkImageGrid.h"
#include "InkImageSlabs.h"
#include "InkJoinedSamples.h"
#include "InkMemoryBudget.h"
#include "InkReportException.h"
#include "InkSampleSlabs.h"
#include "InkVTKCompat.h"
#include "InkVolumeValues.h"
#include "IsoSurface/ActiveCellComponents.h"
#include "Statistics/FiniteRange.h"

#include "vtkAlgorithmOutput.h"
#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTrivialProducer.h"

#include <numeric>

bool vtkInkIsoSurfaceSampler::TakesSlabs(vtkInformation* input, vtkInformation* output)
{
  using SDDP = vtkStreamingDemandDrivenPipeline;
  const bool shapeBased = this->FindThickSlices(InkMakeFrame(input)).has_value();
  return this->MaximumMemory > 0 && output->Get(SDDP::UPDATE_NUMBER_OF_PIECES()) <= 1 &&
    vtkImageData::SafeDownCast(input->Get(vtkDataObject::DATA_OBJECT())) &&
    !vtkTrivialProducer::SafeDownCast(this->GetInputAlgorithm()) &&
    InkImageSlabs::GetBytes(input, this->GetArrayName(), shapeBased ? InkBytesOfDistance : 0) >
    InkMemoryBudget::OfMebibytes(this->MaximumMemory).ForWholeImage();
}

std::string vtkInkIsoSurfaceSampler::GetArrayName()
{
  vtkInformation* array = this->GetInputArrayInformation(0);
  const char* name = array->Get(vtkDataObject::FIELD_NAME());
  return name ? name : "";
}

void vtkInkIsoSurfaceSampler::SampleSlabs(vtkPolyData* output)
{
  const std::vector<double> isoValues = this->TakeIsoValues();
  const ink::ComponentSelection parts =
    ink::ComponentSelection{ this->SmallestPart, static_cast<std::size_t>(this->LargestParts) }
      .inDividedCells(this->Subdivision);
  InkJoinedSamples joined(InkMemoryBudget::OfMebibytes(this->MaximumMemory));
  this->SampleParts([&](int surface, vtkPolyData* part) { joined.Add(surface, part); }, isoValues,
    this->ComputeCellIds || !parts.keepsAll());
  joined.Fill(output, parts,
    { this->ComputeCellIds, this->ComputeSurfaceIndex && isoValues.size() > 1, this->GenerateVertices });
  if (output->GetNumberOfPoints() == 0 && !InkCheckAbort(this))
  {
    this->WarnIfOutside(isoValues, this->FoundRange[0], this->FoundRange[1]);
  }
}

bool vtkInkIsoSurfaceSampler::SampleParts(const PartSink& sink)
{
  try
  {
    this->SampleParts(sink, this->TakeIsoValues(), this->ComputeCellIds);
    return true;
  }
  catch (...)
  {
    InkReportException(this, nullptr, "The image cannot be sampled");
    return false;
  }
}

void vtkInkIsoSurfaceSampler::SampleParts(
  const PartSink& sink, const std::vector<double>& isoValues, bool cellIds)
{
  const InkMemoryBudget budget = InkMemoryBudget::OfMebibytes(this->MaximumMemory);
  InkImageSlabs slabs(this->GetInputConnection(0, 0), budget, this->GetArrayName());
  const ink::FiniteRange range = InkSampleSlabs(slabs, this, isoValues, cellIds, budget, sink,
    [this](double done)
    {
      this->UpdateProgress(done);
      return !InkCheckAbort(this);
    });
  this->FoundRange[0] = range.least;
  this->FoundRange[1] = range.greatest;
}

template <class Use>
void vtkInkIsoSurfaceSampler::UseSlabs(const Use& use)
{
  try
  {
    InkImageSlabs slabs(this->GetInputConnection(0, 0), InkMemoryBudget::OfMebibytes(this->MaximumMemory),
      this->GetArrayName());
    use(slabs);
  }
  catch (...)
  {
    InkReportException(this, nullptr, "The image cannot be read");
  }
}

ink::SuggestedSmoothing vtkInkIsoSurfaceSampler::SuggestSmoothings(double isoValue)
{
  ink::SuggestedSmoothing smoothing;
  this->UseSlabs(
    [&](InkImageSlabs& slabs)
    {
      smoothing = InkSuggestSmoothing(slabs, isoValue,
        [this](double done)
        {
          this->UpdateProgress(done);
          return true;
        });
    });
  return smoothing;
}

vtkIdType vtkInkIsoSurfaceSampler::CountActiveCells(double isoValue)
{
  vtkIdType count = 0;
  const auto rule = static_cast<ink::CrossingRule>(this->CrossingRule);
  this->UseSlabs(
    [&](InkImageSlabs& slabs)
    {
      const std::vector<std::size_t> layers = InkBoundLayerPoints(slabs, isoValue, rule);
      count = static_cast<vtkIdType>(std::accumulate(layers.begin(), layers.end(), std::size_t{ 0 }));
    });
  return count;
}

vtkSmartPointer<vtkImageData> vtkInkIsoSurfaceSampler::MakeFrame()
{
  vtkAlgorithmOutput* port = this->GetInputConnection(0, 0);
  port->GetProducer()->UpdateInformation();
  return InkMakePointFrame(port->GetProducer()->GetOutputInformation(port->GetIndex()), this->GetArrayName());
}

ink::FiniteRange vtkInkIsoSurfaceSampler::FindRange()
{
  return { this->FoundRange[0], this->FoundRange[1] };
}
