#include "SampleVolume.h"

#include "Errors.h"
#include "Progress.h"
#include "Text.h"
#include "Volume.h"
#include "VtkMessages.h"

#include "vtkImageData.h"
#include "vtkInkIsoSurfaceSampler.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace ink::cli
{
namespace
{

void checkIsoValues(const std::vector<double>& isoValues, const double range[2])
{
  if (!(range[0] < range[1]))
  {
    throw Failure(range[0] == range[1] ? "no surface: all voxels have the value " + text(range[0])
                                       : "no surface: no voxel has a finite value");
  }
  for (const double value : isoValues)
  {
    // Also for NaN.
    if (!(value > range[0] && value <= range[1]))
    {
      throw UsageError("--iso " + text(value) + ": expected a value above " + text(range[0]) + " and up to " +
        text(range[1]) + ", which the volume has");
    }
  }
}

double chooseIsoValue(vtkImageData* image, std::vector<std::string>& notes, Progress& progress)
{
  progress.step("choosing an iso-value");
  const std::optional<IsoSuggestion> suggestion = suggestIsoValue(image);
  if (!suggestion)
  {
    throw Failure("no iso-value could be chosen; give one with --iso");
  }
  notes.push_back("iso-value " + text(suggestion->value) + ": " + methodText(*suggestion));
  return suggestion->value;
}

void addSurfaceIndex(vtkPolyData* points, int surface)
{
  vtkNew<vtkIntArray> index;
  index->SetName("SurfaceIndex");
  index->SetNumberOfValues(points->GetNumberOfPoints());
  index->Fill(surface);
  points->GetPointData()->AddArray(index);
}

} // namespace

std::vector<std::string> sampleVolume(
  vtkImageData* image, const VolumeSampling& sampling, const PointSink& sink, Progress& progress)
{
  std::vector<std::string> notes;
  double range[2];
  finiteRange(image, range);
  checkIsoValues(sampling.isoValues, range);
  std::vector<double> isoValues = sampling.isoValues;
  if (isoValues.empty())
  {
    isoValues.push_back(chooseIsoValue(image, notes, progress));
  }

  vtkNew<vtkInkIsoSurfaceSampler> sampler;
  sampler->SetInputData(image);
  sampler->SetNumberOfContours(1);
  sampler->SetCrossingRule(sampling.crossingRule);
  sampler->SetOutputPointsPrecision(sampling.precision);
  sampler->SetComputeNormals(sampling.normals);
  sampler->SetComputeRadius(sampling.radius);
  sampler->GenerateVerticesOff();
  progress.step("sampling the surface", sampler);
  const VtkMessages messages;
  vtkIdType count = 0;
  for (std::size_t i = 0; i < isoValues.size(); ++i)
  {
    sampler->SetValue(0, isoValues[i]);
    sampler->Update();
    if (const std::string problem = messages.error(); !problem.empty())
    {
      throw Failure(problem);
    }
    vtkNew<vtkPolyData> points;
    points->ShallowCopy(sampler->GetOutput());
    if (sampling.surfaceIndex)
    {
      addSurfaceIndex(points, static_cast<int>(i));
    }
    count += points->GetNumberOfPoints();
    sink(static_cast<int>(i), points);
  }
  if (count == 0)
  {
    const int* dimensions = image->GetDimensions();
    const bool flat = dimensions[0] < 2 || dimensions[1] < 2 || dimensions[2] < 2;
    throw Failure(flat ? "no surface: a volume of " + dimensionsText(dimensions) + " voxels has no cells"
                       : "no surface at iso-value " + text(isoValues.front()));
  }
  return notes;
}

} // namespace ink::cli
