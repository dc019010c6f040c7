// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkStrokeRuns_h
#define InkStrokeRuns_h

#include <cstdint>
#include <vector>

class InkStrokePoints;
struct InkViewUniforms;

/// Which parts of strokes are drawn, as the shader reads it: their points, each on a segment of a stroke, and
/// what belongs together.
struct InkStrokeRuns
{
  struct Point
  {
    std::uint32_t Source;   ///< a point of the strokes
    std::uint32_t Fraction; ///< of the way to the next one, times 2^32
    std::uint32_t Run;
    std::uint32_t Unused;
  };
  enum Flags
  {
    Closed = 1,   ///< the last point is the first once more
    CutBegin = 2, ///< the stroke begins before, hidden
    CutEnd = 4,
    Hidden = 8
  };
  struct Run
  {
    std::int32_t First; ///< of the points here
    std::int32_t Last;
    std::int32_t Stroke;
    std::int32_t Flags;
  };

  /// All of all strokes.
  static InkStrokeRuns FindWhole(const InkStrokePoints& strokes);

  /// How far silhouettes that a rougher surface hides may lie within its outline at most, in pixels of a
  /// view; see ink::CurveOccluders.
  static double FindWithinOutline(const InkViewUniforms& view);

  /// What a surface leaves visible.
  /// @param view that the depth image shows
  /// @param depths of the surface, one for each pixel of the view
  /// @param tolerance how far behind the surface they may lie, in view units
  /// @param leastRun pixels of the depth image: shorter runs join their neighbors
  /// @param withHidden the parts that it hides, too
  static InkStrokeRuns FindVisible(const InkStrokePoints& strokes, const InkViewUniforms& view,
    const std::vector<float>& depths, double tolerance, double leastRun, bool withHidden);

  std::vector<Point> Points;
  std::vector<Run> Runs; ///< the hidden ones first, so that others are drawn over them

private:
  void Add(const InkStrokePoints& strokes, int stroke, double from, double to, bool hidden);
};

#endif
