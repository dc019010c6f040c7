#include "Surface.h"

#include "Errors.h"
#include "Progress.h"
#include "Text.h"
#include "Volume.h"
#include "VtkMessages.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInkIsoSurfaceSampler.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"

namespace ink::cli
{
namespace
{

Surface sampleVolume(vtkImageData* image, const std::vector<double>& isoValues, Progress& progress)
{
  Surface surface;
  surface.isoValues = isoValues;
  double range[2];
  finiteRange(image, range);
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
  if (surface.isoValues.empty())
  {
    progress.step("choosing an iso-value");
    const std::optional<IsoSuggestion> suggestion = suggestIsoValue(image);
    if (!suggestion)
    {
      throw Failure("no iso-value could be chosen; give one with --iso");
    }
    surface.isoValues.push_back(suggestion->value);
    surface.notes.push_back("iso-value " + text(suggestion->value) + ": " + methodText(*suggestion));
  }

  vtkNew<vtkInkIsoSurfaceSampler> sampler;
  sampler->SetInputData(image);
  sampler->SetNumberOfContours(static_cast<int>(surface.isoValues.size()));
  for (std::size_t i = 0; i < surface.isoValues.size(); ++i)
  {
    sampler->SetValue(static_cast<int>(i), surface.isoValues[i]);
  }
  progress.step("sampling the surface", sampler);
  const VtkMessages messages;
  sampler->Update();
  if (const std::string problem = messages.error(); !problem.empty())
  {
    throw Failure(problem);
  }
  surface.points = sampler->GetOutput();
  if (surface.points->GetNumberOfPoints() == 0)
  {
    const int* dimensions = image->GetDimensions();
    const bool flat = dimensions[0] < 2 || dimensions[1] < 2 || dimensions[2] < 2;
    throw Failure(flat ? "no surface: a volume of " + dimensionsText(dimensions) + " voxels has no cells"
                       : "no surface at iso-value " + text(surface.isoValues.front()));
  }
  return surface;
}

/// Normals are those of the file; without any they follow from the polygons. The points stay what they are.
Surface takeVertices(vtkPolyData* mesh, Progress& progress)
{
  Surface surface;
  surface.points = mesh;
  vtkPointData* pointData = mesh->GetPointData();
  if (vtkDataArray* named = pointData->GetArray("Normals");
      named && named->GetNumberOfComponents() == 3 && !pointData->GetNormals())
  {
    pointData->SetNormals(named);
  }
  if (pointData->GetNormals())
  {
    return surface;
  }
  if (mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips() == 0)
  {
    throw Failure("no surface: the points have no normals, and there are no polygons to compute them from");
  }
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(mesh);
  normals->SplittingOff();
  normals->ConsistencyOff();
  progress.step("computing normals", normals);
  normals->Update();
  surface.points = normals->GetOutput();
  surface.notes.emplace_back("the mesh has no normals; they are computed from its polygons");
  return surface;
}

} // namespace

Surface makeSurface(const Input& input, const std::vector<double>& isoValues, Progress& progress)
{
  if (auto* image = vtkImageData::SafeDownCast(input.data))
  {
    return sampleVolume(image, isoValues, progress);
  }
  if (!isoValues.empty())
  {
    throw UsageError("--iso: a mesh has no iso-values, only volumes have");
  }
  return takeVertices(vtkPolyData::SafeDownCast(input.data), progress);
}

} // namespace ink::cli
