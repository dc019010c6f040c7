// SPDX-License-Identifier: BSD-3-Clause
#include "SampleVolume.h"

#include "Core/FormatNumber.h"
#include "Errors.h"
#include "Input.h"
#include "Memory.h"
#include "Progress.h"
#include "Volume.h"
#include "VolumeSlices.h"
#include "VtkMessages.h"

#include "InkVolumeValues.h"
#include "IsoSurface/ResampledSamples.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInkIsoSurfaceSampler.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTrivialProducer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <numeric>

namespace ink::cli
{
namespace
{

double chooseIsoValue(VolumeSlices& volume, std::vector<std::string>& notes, Progress& progress)
{
  progress.step("choosing an iso-value");
  const std::vector<IsoSuggestion> suggestions = suggestIsoValues(volume, progress);
  if (suggestions.empty())
  {
    checkIsoValues({}, findFiniteRange(volume));
    throw Failure("no iso-value could be chosen; give one with --iso");
  }
  notes.push_back(InkDescribeChoice(suggestions));
  return suggestions.front().value;
}

/// Layers of cells: layer n lies between the slices n and n + 1.
struct Layers
{
  int begin;
  int end;
};

/// Samples a volume layer by layer.
class LayerSampler
{
public:
  LayerSampler(VolumeSlices& volume, const VolumeSampling& sampling, const Memory& memory, Progress& progress)
    : Volume(volume)
    , WithIndex(sampling.surfaceIndex)
    , MostPoints(memory.forNewPoints() / bytesPerPoint)
    , Reach(reachOf(sampling))
    , PointsPerCell(pointsPerCell(sampling))
  {
    setUp(this->Sampler.Get(), sampling);
    // Parts of the volume are seen once, and points that are kept should take no more memory than they need.
    this->Sampler->UseIndexOff();
    this->Sampler->ReuseArraysOff();
    this->Sampler->SetComputeCellIds(sampling.cellIds);
    this->Sampler->SetInputConnection(this->Producer->GetOutputPort());
    this->Producer->SetWholeExtent(volume.frame()->GetExtent());
    progress.step("sampling the surface", this->Sampler);
  }

  /// The slices on either side of a layer's that its points depend on.
  static int reachOf(const VolumeSampling& sampling)
  {
    return isoSurfaceResamplingReach(sampling.smoothing, sampling.subdivision);
  }

  /// Samples layers whose slices are loaded, with as many more on either side as they reach.
  void sample(const Layers& layers, int surface, double isoValue, const PointSink& sink)
  {
    this->Sampler->SetValue(0, isoValue);
    for (const Layers& part : this->split(layers, isoValue))
    {
      this->Producer->SetOutput(this->imageOf(part));
      this->Sampler->Update();
      if (const std::string problem = this->Messages.error(); !problem.empty())
      {
        throw Failure(problem);
      }
      vtkNew<vtkPolyData> points;
      points->ShallowCopy(this->Sampler->GetOutput());
      this->Sampler->GetOutput()->Initialize();
      if (this->WithIndex)
      {
        addSurfaceIndex(points, surface);
      }
      this->Count += points->GetNumberOfPoints();
      sink(surface, points);
    }
  }

  vtkIdType count() const { return this->Count; }

private:
  /// Parts with no more points each than there may be at a time.
  std::vector<Layers> split(const Layers& layers, double isoValue)
  {
    const std::uint64_t layerCells =
      static_cast<std::uint64_t>(std::max(this->Volume.dimensions()[0] - 1, 0)) *
      static_cast<std::uint64_t>(std::max(this->Volume.dimensions()[1] - 1, 0));
    if (this->PointsPerCell * layerCells * static_cast<std::uint64_t>(layers.end - layers.begin) <=
      this->MostPoints)
    {
      return { layers };
    }
    const CrossingRule rule = this->Sampler->GetCrossingRule() == vtkInkIsoSurfaceSampler::STRICT
      ? CrossingRule::Strict
      : CrossingRule::HalfOpen;
    const auto counts = boundActiveCells(this->Volume.get(layers.begin, layers.end + 1), isoValue, rule);
    const std::uint64_t most = this->PointsPerCell * *std::max_element(counts.begin(), counts.end());
    if (most > this->MostPoints)
    {
      throw Failure("a layer of the volume has up to " + std::to_string(most) +
        " points: expected --memory " + memoryText(Memory::limitFor(most * bytesPerPoint, 4)) + " or more");
    }
    std::vector<Layers> parts;
    std::uint64_t sum = 0;
    for (int layer = layers.begin; layer < layers.end; ++layer)
    {
      const std::uint64_t count =
        this->PointsPerCell * counts[static_cast<std::size_t>(layer - layers.begin)];
      // Layers without any are left out, but for those that smoothing may move the surface to.
      if (count == 0 && this->Reach == 1)
      {
        continue;
      }
      if (parts.empty() || parts.back().end < layer || sum + count > this->MostPoints)
      {
        parts.push_back({ layer, layer });
        sum = 0;
      }
      parts.back().end = layer + 1;
      sum += count;
    }
    return parts;
  }

  /// The slices that some layers need, with their neighbors, whose cells are marked as not ours.
  vtkSmartPointer<vtkImageData> imageOf(const Layers& layers)
  {
    const int first = std::max(layers.begin - this->Reach, 0);
    const int end = std::min(layers.end + 1 + this->Reach, this->Volume.dimensions()[2]);
    vtkSmartPointer<vtkImageData> image = this->Volume.get(first, end);
    if (end - first == this->Volume.dimensions()[2] && layers.end - layers.begin == end - first - 1)
    {
      return image;
    }
    vtkNew<vtkUnsignedCharArray> marks;
    marks->SetName(vtkDataSetAttributes::GhostArrayName());
    const vtkIdType cells = image->GetNumberOfCells();
    const vtkIdType perLayer = cells / (end - first - 1);
    marks->SetNumberOfValues(cells);
    unsigned char* mark = marks->GetPointer(0);
    std::fill(mark, mark + cells, static_cast<unsigned char>(0));
    constexpr unsigned char notOurs = vtkDataSetAttributes::DUPLICATECELL;
    std::fill(mark, mark + (layers.begin - first) * perLayer, notOurs);
    std::fill(mark + (layers.end - first) * perLayer, mark + cells, notOurs);
    image->GetCellData()->AddArray(marks);
    return image;
  }

  VolumeSlices& Volume;
  bool WithIndex;
  std::uint64_t MostPoints;
  int Reach;
  std::uint64_t PointsPerCell; ///< about, where voxels are divided
  vtkIdType Count = 0;
  vtkNew<vtkTrivialProducer> Producer;
  vtkNew<vtkInkIsoSurfaceSampler> Sampler;
  const VtkMessages Messages;
};

} // namespace

void checkIsoValues(const std::vector<double>& isoValues, const FiniteRange& values)
{
  if (!(values.least < values.greatest))
  {
    throw Failure(values.least == values.greatest
        ? "no surface: all voxels have the value " + formatNumber(values.least)
        : "no surface: no voxel has a finite value");
  }
  for (const double value : isoValues)
  {
    // Also for NaN.
    if (!(value > values.least && value <= values.greatest))
    {
      throw UsageError("--iso " + formatNumber(value) + ": expected a value above " +
        formatNumber(values.least) + " and up to " + formatNumber(values.greatest) +
        ", which the volume has");
    }
  }
}

void addSurfaceIndex(vtkPolyData* points, int surface)
{
  vtkNew<vtkIntArray> index;
  index->SetName("SurfaceIndex");
  index->SetNumberOfValues(points->GetNumberOfPoints());
  index->Fill(surface);
  points->GetPointData()->AddArray(index);
}

std::vector<double> chooseIsoValue(const Input& input, std::vector<std::string>& notes, Progress& progress)
{
  std::vector<double> isoValues;
  takeSurfaceValue(input, isoValues, notes);
  if (isoValues.empty() && input.volume)
  {
    isoValues.push_back(chooseIsoValue(*input.volume, notes, progress));
  }
  return isoValues;
}

std::vector<std::string> sampleVolume(const Input& input, VolumeSampling sampling, const Memory& memory,
  const PointSink& sink, Progress& progress)
{
  std::vector<std::string> notes;
  takeSurfaceValue(input, sampling.isoValues, notes);
  const std::vector<std::string> more = input.volume
    ? sampleVolume(*input.volume, sampling, memory, sink, progress)
    : input.volumeSampler(sampling, memory, sink, progress);
  notes.insert(notes.end(), more.begin(), more.end());
  return notes;
}

std::vector<std::string> sampleVolume(VolumeSlices& volume, const VolumeSampling& sampling,
  const Memory& memory, const PointSink& sink, Progress& progress)
{
  std::vector<std::string> notes;
  FiniteRange values;
  if (volume.inMemory())
  {
    values = findFiniteRange(volume.frame());
    checkIsoValues(sampling.isoValues, values);
  }
  std::vector<double> isoValues = sampling.isoValues;
  if (isoValues.empty())
  {
    isoValues.push_back(chooseIsoValue(volume, notes, progress));
  }

  const int slices = volume.dimensions()[2];
  const int reach = LayerSampler::reachOf(sampling);
  const int atOnce = volume.atOnce() == slices ? slices : volume.atOnce() - 1 - 2 * reach;
  if (atOnce < 1)
  {
    throw Failure("the smoothed surface needs " + std::to_string(2 + 2 * reach) +
      " slices at a time, and there is memory for " + std::to_string(volume.atOnce()) +
      ": expected more --memory than " + memoryText(memory.limit) + ", or less --smoothing");
  }
  LayerSampler sampler(volume, sampling, memory, progress);
  for (int begin = 0; begin == 0 || begin < slices - 1; begin += atOnce)
  {
    const Layers layers{ begin, std::min(begin + atOnce, slices - 1) };
    progress.part(static_cast<double>(begin) / slices, static_cast<double>(layers.end) / slices);
    const FiniteRange here =
      findFiniteRange(volume.get(std::max(begin - reach, 0), std::min(layers.end + 1 + reach, slices)));
    values.add(here);
    for (std::size_t i = 0; i < isoValues.size(); ++i)
    {
      // Most parts of a large volume are air or all inside; smoothed values may overshoot a little.
      const bool inRange = isoValues[i] >= here.least && isoValues[i] <= here.greatest;
      if (layers.begin < layers.end && (inRange || reach > 1))
      {
        sampler.sample(layers, static_cast<int>(i), isoValues[i], sink);
      }
    }
  }
  checkIsoValues(isoValues, values);
  if (sampler.count() == 0)
  {
    throw Failure("no surface at iso-value " + formatNumber(isoValues.front()));
  }
  return notes;
}

} // namespace ink::cli
