// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the points that lines are drawn of know of the data that they were made of: which of its points they
 * are, or are near to (InkSourcePoints), for selection, and the values of one of its arrays, as active
 * scalars.
 */
#ifndef InkSampledMesh_h
#define InkSampledMesh_h

#include "InkProbeColors.h"

#include "vtkSmartPointer.h"

#include <string>

class vtkPolyData;

/// An array to color by.
struct InkColorArray
{
  std::string Name;     ///< empty: none
  bool OfCells = false; ///< or of points
  bool Active = false;  ///< without a name: of images the active scalars
  bool InOrder = false; ///< of labels, see InkProbeColors
  bool operator==(const InkColorArray&) const = default;
};

/// Points without polygons, for what takes some of them with all their arrays.
/// @return the same points with the arrays that make these know them
vtkSmartPointer<vtkPolyData> InkKnowPoints(vtkPolyData* points, const InkColorArray& colors);

/// Lets samples of a mesh's polygons, which vtkInkSurfaceSampler made with KeepFaces, know them, and forget
/// the faces. Point values are interpolated.
void InkKnowFaces(vtkPolyData* mesh, const InkColorArray& colors, vtkPolyData* samples);

#endif
