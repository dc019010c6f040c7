#include "SampleMesh.h"

#include "Errors.h"

namespace ink::cli
{

void sampleMesh(vtkPolyData*, PointStore&, Progress&)
{
  throw Failure("ink sample: expected a volume, found a mesh");
}

} // namespace ink::cli
