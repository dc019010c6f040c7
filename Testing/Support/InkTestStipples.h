// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkTestStipples_h
#define InkTestStipples_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

/// Stipples in the form that vtkInkStippleGenerator gives them, on analytic shapes.
namespace InkTestStipples
{

/// The voxels of a grid with a spacing whose centers lie within one spacing of a sphere around the origin,
/// each with stipples at hashed positions on the sphere's tangent plane. Normals outwards, Value 1 down to
/// 1/2 and GradientMagnitude 1 down to 0.1 with the distance from the sphere.
vtkSmartPointer<vtkPolyData> SphereVoxels(double radius, double spacing, int stipplesPerVoxel);

/// Stipples on a sphere's surface, one element for each of a grid of patches of equal area.
vtkSmartPointer<vtkPolyData> SphereSurface(double radius, int patches, int stipplesPerPatch);

/// A square of the plane z = 0, of a side length, in elements x elements squares, facing +z: a surface, with
/// evenly spread stipples.
vtkSmartPointer<vtkPolyData> PlaneSurface(double side, int elements, int stipplesPerElement);

/// Scales the points and ElementSize, then shifts the points.
vtkSmartPointer<vtkPolyData> Transform(vtkPolyData* stipples, double scale, const double shift[3]);

} // namespace InkTestStipples

#endif
