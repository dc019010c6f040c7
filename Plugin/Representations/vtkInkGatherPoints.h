// SPDX-License-Identifier: BSD-3-Clause
/**
 * What a representation draws of its input: the points with normals of all leaves, as one vtkPolyData.
 */
#ifndef vtkInkGatherPoints_h
#define vtkInkGatherPoints_h

#include "vtkSmartPointer.h"

#include <string>

class vtkDataObject;
class vtkPolyData;

struct vtkInkGatheredPoints
{
  /// Never null. Points without cells, with the point array `Normals` and, if all leaves have them, `Radius`,
  /// `Priority` and the array to color by, the active scalars.
  vtkSmartPointer<vtkPolyData> Points;
  /// Whether point i is point i of the input: not so for composite data, and after ghost points were dropped.
  bool IdsAreInputs = true;
  /// What of the input cannot be drawn and what was expected instead; empty if all can. The first such leaf
  /// stands for all.
  std::string Problem;
};

/**
 * Gathers from a vtkPointSet, or from the leaves of a composite dataset, the points that this process owns
 * (neither duplicate nor hidden). Normals are the point array `Normals` of 3 components, else the active
 * point normals, whatever their name. A null input gives no points and no problem.
 * @param colorArray the array to color by; none if empty
 * @param association vtkDataObject::FIELD_ASSOCIATION_POINTS, or _CELLS: then points get the mean of their
 * cells' values
 */
vtkInkGatheredPoints vtkInkGatherPoints(vtkDataObject* input, const std::string& colorArray, int association);

#endif
