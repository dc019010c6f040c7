// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkSplatPoints_h
#define InkSplatPoints_h

#include "vtkFloatArray.h"
#include "vtkNew.h"

#include <array>
#include <string>

class vtkDataArray;
class vtkPoints;

/// Points, normals and radii in the form that the splat shaders read: single precision, relative to the
/// data's centre and size, so that neither large nor tiny coordinates lose digits.
class InkSplatPoints
{
public:
  /// Reads the arrays, all of equal length.
  /// @param normals 3 components, any length; points with a zero or not finite normal are not drawn
  /// @param radii 1 component, world units, or null; points with a radius that is not positive and finite
  ///   are not drawn
  /// @param radius for all points where radii is null; 0: estimated from the points' spacing
  /// Points whose position is not finite are not drawn.
  void Read(vtkPoints* points, vtkDataArray* normals, vtkDataArray* radii, double radius);

  /// The bounds of the finite points, as VTK writes bounds; uninitialized bounds if there are none.
  static void FindFiniteBounds(vtkPoints* points, double bounds[6]);

  /// How many points can be drawn.
  vtkIdType GetNumberOfVisiblePoints() const { return this->NumberOfVisiblePoints; }

  /// The origin of the shaders' coordinates, and their unit, in the input's coordinates.
  const std::array<double, 3>& GetCenter() const { return this->Center; }
  double GetUnit() const { return this->Unit; }
  /// The largest radius, in that unit.
  double GetLargestRadius() const { return this->LargestRadius; }

  /// One tuple per input point: position (3), and normal and radius (4, radius 0 for what is not drawn).
  vtkFloatArray* GetPositions() { return this->Positions; }
  vtkFloatArray* GetNormalsAndRadii() { return this->NormalsAndRadii; }
  /// Frees both arrays.
  void ReleaseArrays();

private:
  void FindCenterAndUnit(vtkPoints* points);
  float EstimateRadius() const;

  vtkNew<vtkFloatArray> Positions;
  vtkNew<vtkFloatArray> NormalsAndRadii;
  std::array<double, 3> Center{};
  double Unit = 1.0;
  double LargestRadius = 0.0;
  vtkIdType NumberOfVisiblePoints = 0;
};

#endif
