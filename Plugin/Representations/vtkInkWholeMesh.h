// SPDX-License-Identifier: BSD-3-Clause
/**
 * What filters need that make marks of meshes as one process would where several hold parts of the mesh.
 */
#ifndef vtkInkWholeMesh_h
#define vtkInkWholeMesh_h

#include "vtkInformationVector.h"
#include "vtkNew.h"

#include <array>
#include <functional>

class vtkInformation;

/// A filter's input with all processes' parts of the mesh on its first port put together, see
/// vtkInkGatherMesh: on the first process all, on the others nothing.
class vtkInkWholeMesh
{
public:
  /// To be called in RequestUpdateExtent. Of composite data a filter is run for each leaf that a process has,
  /// which others need not have: each stays where it is.
  void LookAt(vtkInformation* request, vtkInformationVector** input);
  /// To be called in RequestData, by all processes at once.
  /// @param ports of the filter, two at most
  /// @param use what the filter does with its input, which may be that of the whole mesh
  /// @return what `use` returns
  int Take(vtkInformationVector** input, int ports, const std::function<int(vtkInformationVector**)>& use);

private:
  /// The input itself on a single process, of leaves, or where no process has a mesh with faces.
  vtkInformationVector** Gather(vtkInformationVector** input, int ports);

  bool IsComposite = false;
  std::array<vtkNew<vtkInformationVector>, 2> Gathered;
  std::array<vtkInformationVector*, 2> Pointers{};
};

#endif
