// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkSplatPoints_h
#define InkSplatPoints_h

#include "InkShiftScale.h"

#include "vtkFloatArray.h"
#include "vtkNew.h"

#include <array>

class vtkDataArray;
class vtkPoints;
class vtkUnsignedCharArray;

/// Points, normals and radii in the form that the splat shaders read: single precision, relative to the
/// data's center and size, so that neither large nor tiny coordinates lose digits.
class InkSplatPoints
{
public:
  /// Reads the arrays, all of equal length.
  /// @param normals 3 components, any length; points with a zero or not finite normal are not drawn
  /// @param radii 1 component, world units, or null; points with a radius that is not positive and finite
  ///   are not drawn
  /// @param edges 6 components, world units, or null: where discs end, see vtkInkSplattingLinesMapper
  /// @param radius for all points where radii is null; 0: estimated from the points' spacing
  /// @param ghosts `vtkGhostType` or null; points that it marks as hidden or duplicate are not drawn
  /// Points whose position is not finite are not drawn.
  void Read(vtkPoints* points, vtkDataArray* normals, vtkDataArray* radii, vtkDataArray* edges, double radius,
    vtkUnsignedCharArray* ghosts);

  /// How many points can be drawn.
  vtkIdType GetNumberOfVisiblePoints() const { return this->NumberOfVisiblePoints; }

  /// The shaders' coordinates.
  const InkShiftScale& GetFrame() const { return this->Frame; }
  /// The largest radius, in the frame's unit.
  double GetLargestRadius() const { return this->LargestRadius; }

  /// The least and the greatest coordinate of the points that can be drawn, along each axis.
  const std::array<float, 6>& GetBounds() const { return this->Bounds; }

  /// One tuple per input point: position (3), and normal and radius (4, radius 0 for what is not drawn).
  vtkFloatArray* GetPositions() { return this->Positions; }
  vtkFloatArray* GetNormalsAndRadii() { return this->NormalsAndRadii; }
  /// The vectors to the two edges where a disc ends (3 each, 0: none); empty where there were none to read.
  std::array<vtkFloatArray*, 2> GetEdges() { return { this->Edges[0], this->Edges[1] }; }
  /// Frees the arrays.
  void ReleaseArrays();

private:
  float EstimateRadius() const;
  void ReadEdges(vtkDataArray* edges);

  vtkNew<vtkFloatArray> Positions;
  vtkNew<vtkFloatArray> NormalsAndRadii;
  std::array<vtkNew<vtkFloatArray>, 2> Edges;
  InkShiftScale Frame;
  double LargestRadius = 0.0;
  std::array<float, 6> Bounds{};
  vtkIdType NumberOfVisiblePoints = 0;
};

#endif
