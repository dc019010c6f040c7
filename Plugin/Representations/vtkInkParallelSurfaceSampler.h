// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkParallelSurfaceSampler
 * @brief   vtkInkSurfaceSampler with the same samples of a mesh on any number of ParaView's processes
 *
 * The parts of a mesh that lies on several processes are put together on the first, which needs memory for
 * the whole and makes all samples, while the others wait. Points that parts have in common become one where
 * the mesh has normals; without, an edge may be meant to be sharp. Composite data is done leaf by leaf, each
 * by the process that has it, and so are grids, which have a surface only after Extract Surface.
 *
 * @sa vtkInkSurfaceSampler
 */
#ifndef vtkInkParallelSurfaceSampler_h
#define vtkInkParallelSurfaceSampler_h

#include "vtkInkPluginRepresentationsModule.h" // for the export macro
#include "vtkInkSurfaceSampler.h"

#include <memory> // for the input

class vtkInkWholeMesh;

class VTKINKPLUGINREPRESENTATIONS_EXPORT vtkInkParallelSurfaceSampler : public vtkInkSurfaceSampler
{
public:
  static vtkInkParallelSurfaceSampler* New();
  vtkTypeMacro(vtkInkParallelSurfaceSampler, vtkInkSurfaceSampler);

protected:
  vtkInkParallelSurfaceSampler();
  ~vtkInkParallelSurfaceSampler() override;

  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkInkParallelSurfaceSampler(const vtkInkParallelSurfaceSampler&) = delete;
  void operator=(const vtkInkParallelSurfaceSampler&) = delete;

  const std::unique_ptr<vtkInkWholeMesh> Mesh;
};

#endif
