#include "Surface.h"

#include "Errors.h"
#include "PointStore.h"
#include "Progress.h"
#include "SampleMesh.h"
#include "SampleVolume.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"

namespace ink::cli
{
namespace
{

// A point as it is made, as it is drawn, and as OpenGL may keep it.
constexpr std::uint64_t drawnPointBytes = 100;

/// Of a mesh with polygons. Normals are those of the file; without any they follow from the polygons. The
/// points stay what they are.
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

/// All points at once, as the mapper needs them.
Surface sampleWhole(
  const Input& input, const std::vector<double>& isoValues, const Memory& memory, Progress& progress)
{
  VolumeSampling sampling;
  sampling.isoValues = isoValues;
  PointStore points(memory.limit, {});
  const auto keep = [&](int index, vtkPolyData* part)
  {
    const std::uint64_t count = points.size() + static_cast<std::uint64_t>(part->GetNumberOfPoints());
    if (count * drawnPointBytes > memory.limit)
    {
      throw Failure("the surface has " + std::to_string(count) +
        " points or more, which cannot be drawn in less than " + memoryText(count * drawnPointBytes) +
        ": expected --memory of more than that, found " + memoryText(memory.limit));
    }
    points.add(index, part);
  };
  Surface surface;
  surface.notes = sampleVolume(input, sampling, memory, keep, progress);
  surface.points = points.take();
  return surface;
}

} // namespace

Surface makeSurface(const Input& input, const std::vector<double>& isoValues, MeshSampler& meshes,
  const Memory& memory, Progress& progress)
{
  const CloudSampling& cloud = meshes.sampling().cloud;
  if (input.isVolume())
  {
    if (!cloud.given.empty())
    {
      throw UsageError(cloud.given + ": expected points without polygons, found a volume");
    }
    return sampleWhole(input, isoValues, memory, progress);
  }
  if (!isoValues.empty())
  {
    throw UsageError("--iso: a mesh has no iso-values, only volumes have");
  }
  auto* mesh = vtkPolyData::SafeDownCast(input.data);
  if (meshes.sampling().count == 0 && mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips() > 0 &&
    cloud.given.empty())
  {
    return takeVertices(mesh, progress);
  }
  Surface surface;
  surface.points = meshes.sample(mesh, surface.notes, progress);
  return surface;
}

} // namespace ink::cli
