// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkStrokePoints_h
#define InkStrokePoints_h

#include "InkShiftScale.h"
#include "Tone/Hatching/StrokeWidth.h"

#include "vtkType.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

class vtkDataArray;
class vtkIdTypeArray;
class vtkPolyData;
class vtkUnsignedCharArray;

/// The arrays of strokes that the mapper reads; null for what the data lacks.
struct InkStrokeArrays
{
  /// Looks for them.
  /// @param widths what the user chose
  /// @param hatching whether the strokes are to be hatching, which needs more of them
  InkStrokeArrays(vtkPolyData* data, vtkDataArray* widths, bool hatching);

  vtkPolyData* Data;
  vtkDataArray* Normals;         ///< of the points, 3 components: of the surface that they lie on
  vtkDataArray* Widths;          ///< of the points, 1 component: factors of the line width
  vtkDataArray* ArcLengths;      ///< of the points, 1 component: from the stroke's begin, in the data's unit
  vtkDataArray* RadialCurvature; ///< of the points, 1 component: negative where their surface hides them
  vtkIdTypeArray* OriginalIds;   ///< of the points, 1 component: what selection finds; null: their own
  vtkDataArray* Priorities;      ///< of the cells or of the points, 1 component
  bool CellPriorities;
  bool Hatching;
  vtkDataArray* Spacings; ///< of the cells, 1 component; only of hatching
  vtkDataArray* Families; ///< of the cells, 1 component: 0, or 1 for the second; only of hatching
  vtkDataArray* Ratios;   ///< of the points, 8 components: ink::hatching::SpacingRatios; only of hatching

  /// Why they cannot be drawn, for the user: what was expected and what was found; empty if they can.
  std::string FindProblem() const;

  /// In [0, 1]; without an array by chance.
  /// @param line among the lines
  /// @param point the line's first
  float FindPriority(vtkIdType cell, vtkIdType line, vtkIdType point) const;

  /// Modification times, which no other objects ever have.
  using Key = std::array<vtkMTimeType, 12>;
  Key GetKey() const;
};

/// The arrays of edge voxels, as vtkInkEdgeVoxels makes them; null for what the data lacks.
struct InkVoxelArrays
{
  explicit InkVoxelArrays(vtkPolyData* data);

  vtkPolyData* Data;
  vtkDataArray* Gradients; ///< of the points, 3 components
  vtkDataArray* Values;    ///< of the points, 1 component
  vtkDataArray* Radii;     ///< of the points, 1 component: half of a voxel's diagonal

  /// Why they cannot be drawn, for the user; empty if they can.
  std::string FindProblem() const;

  /// As that of strokes.
  InkStrokeArrays::Key GetKey() const;
};

/// The edges of a surface's polygons and strips.
struct InkEdgeArrays
{
  vtkPolyData* Surface;

  /// Why they cannot be drawn, for the user; empty if they can.
  std::string FindProblem() const;

  /// As that of strokes.
  InkStrokeArrays::Key GetKey() const;
};

/// Strokes in the form that the shader reads, one stroke's points after the other's.
class InkStrokePoints
{
public:
  struct Point
  {
    float Position[3]; ///< in the local frame
    float ArcLength;   ///< in the local frame's unit
  };
  struct Shape
  {
    float Normal[3]; ///< zero: none
    float Width;     ///< a factor
  };
  struct Stroke
  {
    int First;       ///< of the points
    int Last;        ///< the last point, in a closed stroke a repetition of the first
    vtkIdType Cell;  ///< in the input
    float ArcBegin;  ///< arc length at the first point
    float ArcLength; ///< of all of the stroke
    float Priority;
    bool Closed;
    float Spacing = 0.0f; ///< of hatching: of all strokes of the family, in the local frame's unit
    int Family = 0;       ///< of hatching
  };

  /// Reads arrays without problems. Points that are not finite divide strokes; points that repeat the one
  /// before and strokes of a single point are left out. Strokes are in the order of the lines, or if they
  /// are hatching in that of their priorities.
  void Read(const InkStrokeArrays& arrays);

  /// Reads voxels without problems: each is a stroke with both points at its center, which the shader moves
  /// apart. Points have the voxel's value in place of the arc length, shapes its gradient, divided by the
  /// greatest magnitude, and half the edge of a cube with its diagonal in place of the width. Voxels whose
  /// position, gradient or radius is zero or not finite are left out.
  void Read(const InkVoxelArrays& arrays);
  /// Reads edges without problems: each is a stroke. The shape of its first point has the outward normal of
  /// one of its polygons, that of its last point the other one's, or of an edge of one the same.
  void Read(const InkEdgeArrays& arrays);
  /// Of voxels the greatest gradient magnitude; 1 without voxels.
  double GetGradientUnit() const { return this->GradientUnit; }

  /// Up to which point strokes with no larger priority go, where that is their order.
  int CountPoints(float priority) const;

  /// RGBA of each point here, from colors of the input's points or cells.
  std::vector<std::uint32_t> OrderColors(vtkUnsignedCharArray* colors, bool ofCells) const;

  const InkShiftScale& GetFrame() const { return this->Frame; }
  const std::array<double, 6>& GetLocalBounds() const { return this->LocalBounds; }
  const std::vector<Point>& GetPoints() const { return this->Points; }
  const std::vector<Shape>& GetShapes() const { return this->Shapes; }
  /// The input's point that a point here is.
  vtkIdType GetSource(int point) const { return this->Sources[static_cast<std::size_t>(point)]; }
  const std::vector<std::uint32_t>& GetIds() const { return this->Ids; }                 ///< for selection
  const std::vector<float>& GetRadialCurvature() const { return this->RadialCurvature; } ///< may be empty
  /// One per point of hatching, otherwise none.
  const std::vector<ink::hatching::SpacingRatios>& GetSpacingRatios() const { return this->Ratios; }
  const std::vector<Stroke>& GetStrokes() const { return this->Strokes; }

private:
  void ReadLine(const InkStrokeArrays& arrays, vtkIdType line);
  void AddPoint(const InkStrokeArrays& arrays, vtkIdType id, const float local[3], double arcLength);
  void AddToBounds(const float position[3], double margin = 0.0);
  void EndStroke(const InkStrokeArrays& arrays, int first, vtkIdType cell, vtkIdType line, bool closed);

  InkShiftScale Frame;
  std::array<double, 6> LocalBounds{};
  double GradientUnit = 1.0;
  std::vector<Point> Points;
  std::vector<Shape> Shapes;
  std::vector<vtkIdType> Sources; ///< points of the input
  std::vector<std::uint32_t> Ids;
  std::vector<float> RadialCurvature;
  std::vector<ink::hatching::SpacingRatios> Ratios;
  std::vector<Stroke> Strokes;
};

#endif
