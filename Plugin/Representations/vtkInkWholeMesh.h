// SPDX-License-Identifier: BSD-3-Clause
/**
 * What filters need that make marks of meshes as one process would where several hold parts of the mesh.
 */
#ifndef vtkInkWholeMesh_h
#define vtkInkWholeMesh_h

#include "vtkInformationVector.h"
#include "vtkNew.h"

#include <array>

class vtkInformation;

/// A filter's input with all processes' parts of the mesh on its first port put together, see
/// vtkInkGatherMesh: on the first process all, on the others nothing.
class vtkInkWholeMesh
{
public:
  /// To be called in RequestUpdateExtent. Of composite data a filter is run for each leaf that a process has,
  /// which others need not have: each stays where it is.
  void LookAt(vtkInformation* request, vtkInformationVector** input);
  /// The input itself on a single process, of leaves, or where no process has a mesh with faces. To be called
  /// in RequestData, by all processes at once.
  /// @param ports of the filter, two at most
  vtkInformationVector** Gather(vtkInformationVector** input, int ports);
  /// Lets go of the mesh.
  void Release();

private:
  bool IsComposite = false;
  std::array<vtkNew<vtkInformationVector>, 2> Gathered;
  std::array<vtkInformationVector*, 2> Pointers{};
};

#endif
