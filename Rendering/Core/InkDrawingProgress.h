// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkDrawingProgress_h
#define InkDrawingProgress_h

#include "vtkInkRenderingCoreModule.h" // for the export macro

class vtkAlgorithm;

/// How far a mapper's picture is, for those who observe the mapper's progress. OpenGL draws later than it is
/// told to; only where somebody observes it is waited for.
class VTKINKRENDERINGCORE_EXPORT InkDrawingProgress
{
public:
  /// @param end of the mapper's progress, above 0 to 1: where another one's begins
  explicit InkDrawingProgress(vtkAlgorithm* mapper, double end = 1.0);

  bool IsWatched() const { return this->Watched; }

  /// What is drawn next ends at this part of the picture, 0 to 1.
  void Until(double part);
  /// Waits until OpenGL has done so much of it, 0 to 1, and tells it.
  void Report(double share = 1.0);

private:
  vtkAlgorithm* const Mapper;
  const double WholeEnd;
  const bool Watched;
  double Begin = 0.0;
  double End = 0.0;
};

/// For as long as it exists a mapper's progress is a part of another one's, and told by that one.
class VTKINKRENDERINGCORE_EXPORT InkProgressPart
{
public:
  /// @param begin, end of the whole, 0 to 1
  InkProgressPart(vtkAlgorithm* whole, vtkAlgorithm* part, double begin, double end);
  ~InkProgressPart();
  InkProgressPart(const InkProgressPart&) = delete;
  void operator=(const InkProgressPart&) = delete;

private:
  vtkAlgorithm* const Whole;
  vtkAlgorithm* const Part;
  const double Begin;
  const double End;
  unsigned long Observer = 0; ///< 0: nobody observes the whole
};

#endif
