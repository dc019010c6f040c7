// SPDX-License-Identifier: BSD-3-Clause
#include "InkSampleSlabs.h"

#include "Fields/Resampling/SliceDistances.h"
#include "InkImageSlabs.h"
#include "InkMemoryBudget.h"
#include "InkReportException.h"
#include "InkVolumeValues.h"
#include "IsoSurface/IsoSurfaceSamples.h"
#include "IsoSurface/ResampledSamples.h"
#include "vtkInkIsoSurfaceSampler.h"

#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTrivialProducer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{

/// Layers of cells: layer n lies between the slices n and n + 1.
struct Layers
{
  int Begin;
  int End;
};

/// Samples an image layer by layer.
class LayerSampler
{
public:
  LayerSampler(InkImageSlabs& slabs, vtkInkIsoSurfaceSampler* settings, bool cellIds,
    const InkMemoryBudget& budget, const ink::Progress& progress)
    : Slabs(slabs)
    , MostPoints(budget.ForNewPoints() / InkBytesPerPoint)
    , Reach(ink::isoSurfaceResamplingReach(settings->GetSmoothing(), settings->GetSubdivision(),
              settings->FindThickSlices(slabs.GetFrame()))
              .z +
        (settings->GetProjectionSteps() > 0 ? 1 : 0))
    , PointsPerCell(static_cast<std::uint64_t>(settings->GetSubdivision()) *
        static_cast<std::uint64_t>(settings->GetSubdivision()))
    , Rule(settings->GetCrossingRule() == vtkInkIsoSurfaceAlgorithm::STRICT ? ink::CrossingRule::Strict
                                                                            : ink::CrossingRule::HalfOpen)
    , Progress(progress)
  {
    this->Sampler->CopyProperties(settings);
    this->Sampler->SetOutputNormalsPrecision(settings->GetOutputNormalsPrecision());
    this->Sampler->SetNumberOfContours(1);
    this->Sampler->SetSmallestPart(0.0);
    this->Sampler->SetLargestParts(0);
    this->Sampler->GenerateVerticesOff();
    this->Sampler->SetComputeCellIds(cellIds);
    // Parts of the image are seen once, and points that are kept should take no more memory than they need.
    this->Sampler->UseIndexOff();
    this->Sampler->ReuseArraysOff();
    this->Sampler->SetInputConnection(this->Producer->GetOutputPort());
    this->Producer->SetWholeExtent(slabs.GetFrame()->GetExtent());
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(this);
    command->SetCallback(
      [](vtkObject*, unsigned long event, void* self, void* data)
      {
        event == vtkCommand::ErrorEvent
          ? static_cast<LayerSampler*>(self)->KeepError(static_cast<const char*>(data))
          : static_cast<LayerSampler*>(self)->ShowProgress();
      });
    this->Sampler->AddObserver(vtkCommand::ErrorEvent, command);
    this->Sampler->AddObserver(vtkCommand::ProgressEvent, command);
  }

  /// The slices on either side of a layer's that its points depend on.
  int GetReach() const { return this->Reach; }

  /// What is sampled next counts from `begin` to `end`, both from 0 to 1, of the progress.
  void SetPart(double begin, double end)
  {
    this->PartBegin = begin;
    this->PartEnd = end;
  }

  /// Samples layers whose slices are loaded, with as many more on either side as they reach.
  /// @return false when stopped
  bool Sample(
    const Layers& layers, int surface, double isoValue, const vtkInkIsoSurfaceAlgorithm::PartSink& sink)
  {
    this->Sampler->SetValue(0, isoValue);
    for (const Layers& part : this->Split(layers, isoValue))
    {
      this->Producer->SetOutput(this->ImageOf(part));
      this->Sampler->Update();
      if (!this->Error.empty())
      {
        throw std::runtime_error(this->Error);
      }
      if (this->Stopped)
      {
        return false;
      }
      vtkNew<vtkPolyData> points;
      points->ShallowCopy(this->Sampler->GetOutput());
      this->Sampler->GetOutput()->Initialize();
      sink(surface, points);
    }
    return true;
  }

private:
  void KeepError(const char* message)
  {
    this->Error = this->Error.empty() ? InkTextOfMessage(message) : this->Error;
  }
  void ShowProgress()
  {
    const double done = this->Sampler->GetProgress();
    if (!this->Progress(this->PartBegin + done * (this->PartEnd - this->PartBegin)))
    {
      this->Stopped = true;
      this->Sampler->SetAbortExecute(1);
    }
  }

  /// Parts with no more points each than there may be at a time.
  std::vector<Layers> Split(const Layers& layers, double isoValue)
  {
    const auto& dimensions = this->Slabs.GetDimensions();
    const std::uint64_t layerCells = static_cast<std::uint64_t>(std::max(dimensions[0] - 1, 0)) *
      static_cast<std::uint64_t>(std::max(dimensions[1] - 1, 0));
    const auto count = static_cast<std::uint64_t>(layers.End - layers.Begin);
    if (this->PointsPerCell * layerCells * count <= this->MostPoints)
    {
      return { layers };
    }
    const std::vector<std::size_t> counts =
      InkBoundLayerPoints(this->Slabs.Get(layers.Begin, layers.End + 1), isoValue, this->Rule);
    const std::uint64_t most = this->PointsPerCell * *std::max_element(counts.begin(), counts.end());
    if (most > this->MostPoints)
    {
      throw std::runtime_error("a layer of the volume has up to " + std::to_string(most) +
        " points: expected MaximumMemory " +
        InkFormatMemory(InkMemoryBudget::LimitFor(most * InkBytesPerPoint, 4)) + " or more");
    }
    std::vector<Layers> parts;
    std::uint64_t sum = 0;
    for (int layer = layers.Begin; layer < layers.End; ++layer)
    {
      const std::uint64_t points =
        this->PointsPerCell * counts[static_cast<std::size_t>(layer - layers.Begin)];
      // Layers without any are left out, but for those that smoothing may move the surface to.
      if (points == 0 && this->Reach == 1)
      {
        continue;
      }
      if (parts.empty() || parts.back().End < layer || sum + points > this->MostPoints)
      {
        parts.push_back({ layer, layer });
        sum = 0;
      }
      parts.back().End = layer + 1;
      sum += points;
    }
    return parts;
  }

  /// The slices that some layers need, with their neighbors, whose cells are marked as not ours.
  vtkSmartPointer<vtkImageData> ImageOf(const Layers& layers)
  {
    const int slices = this->Slabs.GetDimensions()[2];
    const int first = std::max(layers.Begin - this->Reach, 0);
    const int end = std::min(layers.End + 1 + this->Reach, slices);
    vtkSmartPointer<vtkImageData> image = this->Slabs.Get(first, end);
    if (end - first == slices && layers.End - layers.Begin == slices - 1)
    {
      return image;
    }
    // It may be the input's own.
    auto marked = vtkSmartPointer<vtkImageData>::New();
    marked->ShallowCopy(image);
    vtkNew<vtkUnsignedCharArray> marks;
    marks->SetName(vtkDataSetAttributes::GhostArrayName());
    const vtkIdType cells = image->GetNumberOfCells();
    const vtkIdType perLayer = cells / (end - first - 1);
    if (vtkUnsignedCharArray* given = image->GetCellGhostArray())
    {
      marks->DeepCopy(given);
    }
    else
    {
      marks->SetNumberOfValues(cells);
      marks->FillValue(0);
    }
    constexpr unsigned char notOurs = vtkDataSetAttributes::DUPLICATECELL;
    unsigned char* mark = marks->GetPointer(0);
    std::fill(mark, mark + (layers.Begin - first) * perLayer, notOurs);
    std::fill(mark + (layers.End - first) * perLayer, mark + cells, notOurs);
    marked->GetCellData()->AddArray(marks);
    return marked;
  }

  InkImageSlabs& Slabs;
  std::uint64_t MostPoints;
  int Reach;
  std::uint64_t PointsPerCell; ///< about, where voxels are divided
  ink::CrossingRule Rule;
  const ink::Progress& Progress;
  double PartBegin = 0.0;
  double PartEnd = 1.0;
  bool Stopped = false;
  std::string Error;
  vtkNew<vtkTrivialProducer> Producer;
  vtkNew<vtkInkIsoSurfaceSampler> Sampler;
};

} // namespace

ink::FiniteRange InkSampleSlabs(InkImageSlabs& slabs, vtkInkIsoSurfaceSampler* settings,
  std::span<const double> isoValues, bool cellIds, const InkMemoryBudget& budget,
  const vtkInkIsoSurfaceAlgorithm::PartSink& sink, const ink::Progress& progress)
{
  LayerSampler sampler(slabs, settings, cellIds, budget, progress);
  const int slices = slabs.GetDimensions()[2];
  const int reach = sampler.GetReach();
  const bool shapeBased = settings->FindThickSlices(slabs.GetFrame()).has_value();
  const int most = slabs.GetAtOnce(shapeBased ? InkBytesOfDistance : 0);
  const int atOnce = most == slices ? slices : most - 1 - 2 * reach;
  if (atOnce < 1)
  {
    throw std::runtime_error("the smoothed surface needs " + std::to_string(2 + 2 * reach) +
      " slices at a time, and there is memory for " + std::to_string(most) +
      ": expected more MaximumMemory than " + InkFormatMemory(budget.Limit) + ", " +
      (shapeBased ? "ShapeBasedInterpolation off, " : "") + "or less Smoothing");
  }
  ink::FiniteRange values;
  for (int begin = 0; begin == 0 || begin < slices - 1; begin += atOnce)
  {
    const Layers layers{ begin, std::min(begin + atOnce, slices - 1) };
    sampler.SetPart(static_cast<double>(begin) / slices, static_cast<double>(layers.End) / slices);
    const ink::FiniteRange here =
      InkFindFiniteRange(slabs.Get(std::max(begin - reach, 0), std::min(layers.End + 1 + reach, slices)));
    values.add(here);
    for (std::size_t i = 0; i < isoValues.size(); ++i)
    {
      // Most parts of a large volume are air or all inside; smoothed values may overshoot a little.
      const bool inRange = isoValues[i] >= here.least && isoValues[i] <= here.greatest;
      if (layers.Begin < layers.End && (inRange || reach > 1) &&
        !sampler.Sample(layers, static_cast<int>(i), isoValues[i], sink))
      {
        return values;
      }
    }
  }
  return values;
}
