// SPDX-License-Identifier: BSD-3-Clause
// Surfaces of volumes that are not in memory as a whole.
#include "InkIsoSurface.h"

#include "Core/FormatNumber.h"
#include "InkActiveScalars.h"
#include "InkImageSlabs.h"
#include "InkMemoryBudget.h"
#include "InkSubdivision.h"
#include "InkVolumeValues.h"
#include "IsoSurface/ResampledSamples.h"
#include "Statistics/NoiseEstimate.h"
#include "vtkInkIsoSurfaceSampler.h"

#include "vtkImageData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

/// Chooses smoothing and subdivision of a volume as InkIsoSurface::Prepare does those of images in memory.
/// What is less than that, as memory is short, it notes.
class InkIsoSurface::SamplingOfParts
{
public:
  /// All are kept. @param slabs of a sampler of an image, otherwise null @param values the iso-values
  SamplingOfParts(vtkInkStyle* style, vtkInkIsoSurfaceAlgorithm* sampler, InkImageSlabs* slabs,
    const std::vector<double>& values)
    : Style(style)
    , Sampler(sampler)
    , Slabs(slabs)
    , Values(values)
  {
  }

  /// What went wrong; empty if nothing did.
  const std::string& GetProblem() const { return this->Problem; }

  /// Whether memory has room for the slices that noise is measured in.
  bool CanMeasure() const
  {
    return !this->Slabs ||
      this->Slabs->GetAtOnce() >= std::min(ink::NoiseEstimate::slices, this->Slabs->GetDimensions()[2]);
  }

  /// What smoothing the values ask for; only if they can be measured.
  ink::SuggestedSmoothing SuggestSmoothing()
  {
    ink::SuggestedSmoothing smoothing;
    if (this->Slabs)
    {
      for (const double value : this->Values)
      {
        smoothing.add(InkSuggestSmoothing(*this->Slabs, value, this->Style->StartStep("measuring noise")));
      }
    }
    else
    {
      this->Follow(
        "measuring noise", [&](double value) { smoothing.add(this->Sampler->SuggestSmoothings(value)); });
    }
    return smoothing;
  }

  /// Whether memory has room for what distances reach into; notes it if not.
  /// @param smoothing, subdivision those that are given, or none
  bool HasRoomForShapes(double smoothing, int subdivision)
  {
    return !this->FindThickSlices() ||
      this->HasRoomFor(this->CountSlices(smoothing, subdivision),
        "values are interpolated between slices, not contours", "ShapeBasedInterpolation off");
  }

  /// What memory has room for of what was suggested; nothing was if it could not be measured.
  double FitSmoothing(double suggested)
  {
    // How much memory it takes is not known before it was measured.
    const double smoothing = this->CanMeasure() ? suggested : ink::mostSuggestedSmoothing;
    const bool hasRoom =
      this->HasRoomFor(this->CountSlices(smoothing, 1), "the surface is not smoothed", "Smoothing 0");
    return hasRoom && this->CanMeasure() ? suggested : 0.0;
  }

  int ChooseSubdivision(double smoothing)
  {
    const vtkSmartPointer<vtkImageData> frame = this->Sampler->MakeFrame();
    const VoxelSides voxel = MeasureVoxel(frame);
    const double* box = frame->GetBounds();
    double longest = std::max({ box[1] - box[0], box[3] - box[2], box[5] - box[4] });
    if (this->Slabs)
    {
      longest = FitLongest(
        longest, this->Values, [this](double value) { return InkFindSurfaceLength(*this->Slabs, value); });
    }
    // The other half is for what points are made of.
    const InkMemoryBudget budget = InkMemoryBudget::OfMebibytes(this->Sampler->GetMaximumMemory());
    const auto mostPoints =
      static_cast<double>(budget.Limit) / (2.0 * static_cast<double>(InkBytesPerDrawnPoint));
    const InkSubdivision chosen = InkChooseSubdivision(
      this->Style, voxel.Shortest, voxel.Ratio, longest, [this] { return this->BoundPoints(); },
      std::min(InkMostDividedPoints, mostPoints));
    TakeSubdivision(this->Style, chosen);
    const bool hasRoom = chosen.Cells == 1 ||
      this->HasRoomFor(this->CountSlices(smoothing, chosen.Cells), "voxels are not divided", "Subdivision 1");
    return hasRoom ? this->FitLayers(chosen.Cells, voxel.Ratio, budget) : 1;
  }

private:
  /// The slices of an image between which distances are interpolated, if they are.
  std::optional<ink::ThickSlices> FindThickSlices() const
  {
    return this->Slabs ? this->Sampler->FindThickSlices(this->Slabs->GetFrame()) : std::nullopt;
  }

  /// The slices that a surface needs at a time: those of a layer of cells with what their points depend on.
  int CountSlices(double smoothing, int subdivision) const
  {
    return 2 + 2 * ink::isoSurfaceResamplingReach(smoothing, subdivision, this->FindThickSlices()).z;
  }

  template <class Use>
  void Follow(const char* step, const Use& use)
  {
    const std::string problem = this->Style->Follow(this->Sampler, step,
      [&]
      {
        for (const double value : this->Values)
        {
          use(value);
        }
      });
    this->Problem = this->Problem.empty() ? problem : this->Problem;
  }

  bool HasRoomFor(int slices, const std::string& otherwise, const std::string& setting)
  {
    if (!this->Slabs)
    {
      return true;
    }
    const int needed = std::min(slices, this->Slabs->GetDimensions()[2]);
    const int beside = this->FindThickSlices() ? InkBytesOfDistance : 0;
    const int room = this->Slabs->GetAtOnce(beside);
    if (room >= needed)
    {
      return true;
    }
    this->Style->AddNote(otherwise + ", as memory has room for " + std::to_string(room) +
      " slices at a time: MaximumMemory " + InkFormatMemory(this->Slabs->GetMemoryFor(needed, beside)) +
      " is enough; " + setting + " asks for no more");
    return false;
  }

  /// The points that surfaces have before voxels are divided, at most.
  double BoundPoints()
  {
    double all = 0.0;
    this->Follow("counting voxels",
      [&](double value)
      {
        if (!this->Slabs)
        {
          all += static_cast<double>(this->Sampler->CountActiveCells(value));
          return;
        }
        for (const std::size_t count : InkBoundLayerPoints(*this->Slabs, value, ink::CrossingRule::HalfOpen))
        {
          all += static_cast<double>(count);
          this->MostOfALayer = std::max(this->MostOfALayer, static_cast<double>(count));
        }
      });
    return all;
  }

  /// So many cells or fewer, so that memory has room for a layer of voxels, which is made at a time at least.
  int FitLayers(int wanted, double ratio, const InkMemoryBudget& budget)
  {
    const double room = static_cast<double>(budget.ForNewPoints()) / static_cast<double>(InkBytesPerPoint);
    int cells = wanted;
    while (cells > 1 && this->MostOfALayer * InkGrowthOfPoints(cells, ratio) > room)
    {
      cells /= 2;
    }
    if (cells < wanted)
    {
      const auto points = static_cast<std::uint64_t>(this->MostOfALayer * InkGrowthOfPoints(wanted, ratio));
      this->Style->AddNote("voxels are divided by " + std::to_string(cells) + ", not " +
        std::to_string(wanted) + ", along each axis, as a layer of them would have up to " +
        std::to_string(points) + " points: MaximumMemory " +
        InkFormatMemory(InkMemoryBudget::LimitFor(points * InkBytesPerPoint, 4)) + " is enough");
    }
    return cells;
  }

  vtkInkStyle* Style;
  vtkInkIsoSurfaceAlgorithm* Sampler;
  InkImageSlabs* Slabs;
  const std::vector<double>& Values;
  std::string Problem;
  double MostOfALayer = 0.0; ///< of slices; otherwise 0
};

std::string InkIsoSurface::SampleBy(
  vtkInkStyle* style, vtkInkIsoSurfaceAlgorithm* sampler, vtkPolyData* points)
{
  std::vector<double> values = this->IsoValues.GetGiven();
  this->IsoValues.Use({});
  std::optional<InkImageSlabs> slabs;
  if (auto* ofImage = vtkInkIsoSurfaceSampler::SafeDownCast(sampler))
  {
    InkSelectScalars(ofImage, this->Scalars);
    slabs.emplace(ofImage->GetInputConnection(0, 0),
      InkMemoryBudget::OfMebibytes(ofImage->GetMaximumMemory()), this->Scalars);
  }
  if (slabs && values.empty())
  {
    std::vector<ink::IsoSuggestion> suggestions =
      InkSuggestIsoValues(*slabs, style->StartStep("choosing an iso-value"));
    if (suggestions.empty())
    {
      return InkIsoValues::None;
    }
    this->Choose(suggestions);
    for (const std::string& note : InkDescribeChoice(suggestions))
    {
      style->AddNote(note);
    }
    values.push_back(suggestions.front().value);
  }
  this->IsoValues.Use(values);
  sampler->CopyProperties(this->Sampler);
  sampler->SetValues(values);
  values = sampler->FindIsoValues();
  SamplingOfParts sampling(style, sampler, slabs ? &*slabs : nullptr, values);
  // Without a measure there are no borders.
  ink::SuggestedSmoothing suggested{ .clearBorders = false };
  const auto hasThickSlices = [&] { return slabs && HasThickSlices(slabs->GetFrame()); };
  if (this->AsksForSuggestion(hasThickSlices) && sampling.CanMeasure())
  {
    suggested = sampling.SuggestSmoothing();
  }
  const bool labels = this->TakeLabels(
    sampler, suggested,
    [&] { return sampling.HasRoomForShapes(std::max(this->Smoothing, 0.0), std::max(this->Subdivision, 1)); },
    [&](bool ofLabels)
    {
      if (!slabs)
      {
        return ofLabels;
      }
      const double least = *std::min_element(values.begin(), values.end());
      return (ofLabels || IsSlab(slabs->GetFrame())) && !InkSurroundsObject(*slabs, least);
    });
  sampler->SetSmoothing(this->Smoothing < 0.0
      ? sampling.FitSmoothing(suggested.get(sampler->GetShapeBasedInterpolation()).get(labels))
      : this->Smoothing);
  sampler->SetSubdivision(
    this->Subdivision == 0 ? sampling.ChooseSubdivision(sampler->GetSmoothing()) : this->Subdivision);
  if (!sampling.GetProblem().empty())
  {
    return sampling.GetProblem();
  }
  slabs.reset();
  const std::string problem = style->Follow(sampler, "sampling the surface");
  points->ShallowCopy(sampler->GetOutput());
  if (problem.empty() && points->GetNumberOfPoints() == 0)
  {
    style->AddNote("nothing to draw: no surface" +
      (values.empty() ? std::string() : " at iso-value " + ink::formatNumber(values.front())));
  }
  return problem;
}
