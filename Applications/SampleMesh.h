#pragma once

class vtkPolyData;

namespace ink::cli
{

class PointStore;
class Progress;

/// Samples the surface of a mesh.
/// \throw Failure if there are no points.
void sampleMesh(vtkPolyData* mesh, PointStore& points, Progress& progress);

} // namespace ink::cli
