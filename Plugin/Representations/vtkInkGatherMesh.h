// SPDX-License-Identifier: BSD-3-Clause
/**
 * A mesh that may lie on several processes, put together.
 */
#ifndef vtkInkGatherMesh_h
#define vtkInkGatherMesh_h

#include "vtkSmartPointer.h"

#include <vector>

class vtkMultiProcessController;
class vtkPolyData;

/// Which points of a mesh's parts become one.
enum class vtkInkCommonPoints
{
  All,        ///< those at the same position, with the same normal if there are normals
  WithNormals ///< none if there are none: an edge that has its points twice may be meant to be sharp
};

/**
 * All parts of all processes as one mesh, for the first process, which needs memory for the whole; an empty
 * one for the others. Cells that are marked as another part's are dropped, and common points become one, so
 * that the mesh does not show where it was cut. To be called by all processes at once, also without parts.
 */
vtkSmartPointer<vtkPolyData> vtkInkGatherMesh(const std::vector<vtkSmartPointer<vtkPolyData>>& parts,
  vtkInkCommonPoints common, vtkMultiProcessController* controller);

#endif
