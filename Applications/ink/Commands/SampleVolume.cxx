// SPDX-License-Identifier: BSD-3-Clause
#include "SampleVolume.h"

#include "Core/FormatNumber.h"
#include "Errors.h"
#include "MakeMarks.h"
#include "Progress.h"
#include "VtkMessages.h"

#include "InkImageSlabs.h"
#include "InkVolumeValues.h"

#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace ink::cli
{
namespace
{

/// Adds the array SurfaceIndex: all points belong to that one.
void addSurfaceIndex(vtkPolyData* points, int surface)
{
  vtkNew<vtkIntArray> index;
  index->SetName("SurfaceIndex");
  index->SetNumberOfValues(points->GetNumberOfPoints());
  index->Fill(surface);
  points->GetPointData()->AddArray(index);
}

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

std::vector<double> chooseIsoValue(const Input& input, const InkMemoryBudget& memory, bool inner,
  std::vector<std::string>& notes, Progress& progress)
{
  std::vector<double> isoValues;
  takeSurfaceValue(input, isoValues, notes);
  if (!isoValues.empty() || !input.image)
  {
    return isoValues;
  }
  progress.step("choosing an iso-value");
  const VtkMessages messages;
  try
  {
    InkImageSlabs slabs(input.image->GetOutputPort(), memory);
    std::vector<IsoSuggestion> suggestions = InkSuggestIsoValues(slabs,
      [&](double done)
      {
        progress.at(done);
        return true;
      });
    if (suggestions.empty())
    {
      checkIsoValues({}, InkFindFiniteRange(slabs));
      throw Failure("no iso-value could be chosen; give one with --iso");
    }
    if (inner)
    {
      preferInner(suggestions);
    }
    for (const std::string& note : InkDescribeChoice(suggestions))
    {
      notes.push_back(note);
    }
    return { suggestions.front().value };
  }
  catch (const std::runtime_error& error)
  {
    // What reads the file says more.
    throw Failure(inTermsOfInk(messages.error().empty() ? error.what() : messages.error()));
  }
}

std::vector<std::string> sampleVolume(const Input& input, const VolumeSampling& sampling,
  const InkMemoryBudget& memory, const vtkInkIsoSurfaceAlgorithm::PartSink& sink, Progress& progress)
{
  std::vector<std::string> notes;
  std::vector<double> isoValues = sampling.isoValues;
  if (isoValues.empty())
  {
    isoValues = chooseIsoValue(input, memory, false, notes, progress);
  }
  vtkInkIsoSurfaceAlgorithm* sampler = input.sampler;
  sampler->SetValues(isoValues);
  sampler->SetCrossingRule(sampling.crossingRule);
  sampler->SetOutputPointsPrecision(sampling.precision);
  sampler->SetComputeNormals(sampling.normals);
  sampler->SetComputeRadius(sampling.radius);
  progress.step("sampling the surface", sampler);
  std::vector<vtkIdType> counts(isoValues.size());
  {
    const VtkMessages messages;
    sampler->SampleParts(
      [&](int surface, vtkPolyData* points)
      {
        counts[static_cast<std::size_t>(surface)] += points->GetNumberOfPoints();
        if (sampling.surfaceIndex)
        {
          addSurfaceIndex(points, surface);
        }
        sink(surface, points);
      });
    if (const std::string problem = messages.error(); !problem.empty())
    {
      throw Failure(inTermsOfInk(problem));
    }
  }
  if (std::find(counts.begin(), counts.end(), 0) != counts.end())
  {
    checkIsoValues(isoValues, sampler->FindRange());
  }
  if (std::all_of(counts.begin(), counts.end(), [](vtkIdType count) { return count == 0; }))
  {
    throw Failure("no surface at iso-value " + formatNumber(isoValues.front()));
  }
  return notes;
}

} // namespace ink::cli
