// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkTestPoints_h
#define InkTestPoints_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>

/// Evenly spread points on analytic surfaces, with the point arrays Normals (unit, outwards) and, where a
/// radius is given, Radius. No cells.
namespace InkTestPoints
{

using Vector = std::array<double, 3>;

/// A golden-spiral sphere.
vtkSmartPointer<vtkPolyData> Sphere(double radius, double spacing, Vector center = {});

/// A torus around the z axis.
vtkSmartPointer<vtkPolyData> Torus(double radius, double tubeRadius, double spacing);

/// A square of a side length in the plane z = 0, facing +z.
vtkSmartPointer<vtkPolyData> Plane(double side, double spacing);

/// Adds the array Radius with one value for all points.
void SetRadius(vtkPolyData* points, double radius);

/// The points of both.
vtkSmartPointer<vtkPolyData> Join(vtkPolyData* a, vtkPolyData* b);

/// Scales the points (and the Radius array), then shifts them.
vtkSmartPointer<vtkPolyData> Transform(vtkPolyData* points, double scale, Vector shift);

} // namespace InkTestPoints

#endif
