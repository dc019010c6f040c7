#include "Surface.h"

#include "Errors.h"
#include "Progress.h"
#include "SampleVolume.h"

#include "vtkAppendPolyData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"

namespace ink::cli
{
namespace
{

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
    VolumeSampling sampling;
    sampling.isoValues = isoValues;
    Surface surface;
    vtkNew<vtkAppendPolyData> all;
    surface.notes = sampleVolume(
      image, sampling, [&all](int, vtkPolyData* part) { all->AddInputData(part); }, progress);
    all->SetOutputPointsPrecision(vtkAlgorithm::DEFAULT_PRECISION);
    all->Update();
    surface.points = all->GetOutput();
    return surface;
  }
  if (!isoValues.empty())
  {
    throw UsageError("--iso: a mesh has no iso-values, only volumes have");
  }
  return takeVertices(vtkPolyData::SafeDownCast(input.data), progress);
}

} // namespace ink::cli
