// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkParallelStippleGenerator
 * @brief   vtkInkStippleGenerator with the same stipples of a mesh on any number of ParaView's processes
 *
 * The parts of a mesh that lies on several processes are put together on the first, which needs memory for
 * the whole and makes all stipples, while the others wait. Points that parts have in common become one where
 * the mesh has normals; without, an edge may be meant to be sharp. Composite data is done leaf by leaf, each
 * by the process that has it.
 *
 * @sa vtkInkStippleGenerator
 */
#ifndef vtkInkParallelStippleGenerator_h
#define vtkInkParallelStippleGenerator_h

#include "vtkInkPluginRepresentationsModule.h" // for the export macro
#include "vtkInkStippleGenerator.h"

#include <memory> // for the input

class vtkInkWholeMesh;

class VTKINKPLUGINREPRESENTATIONS_EXPORT vtkInkParallelStippleGenerator : public vtkInkStippleGenerator
{
public:
  static vtkInkParallelStippleGenerator* New();
  vtkTypeMacro(vtkInkParallelStippleGenerator, vtkInkStippleGenerator);

protected:
  vtkInkParallelStippleGenerator();
  ~vtkInkParallelStippleGenerator() override;

  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkInkParallelStippleGenerator(const vtkInkParallelStippleGenerator&) = delete;
  void operator=(const vtkInkParallelStippleGenerator&) = delete;

  const std::unique_ptr<vtkInkWholeMesh> Mesh;
};

#endif
