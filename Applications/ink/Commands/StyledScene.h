// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Input.h"

#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <string>
#include <vector>

class vtkInkSplattingLinesStyle;
class vtkInkStyle;
class vtkPolyData;

namespace ink::cli
{

struct RenderOptions;

/// The style that draws lines, or draws them in this one; null if there are none.
vtkInkSplattingLinesStyle* linesOf(vtkInkStyle* style);

/// What is drawn, before it has a camera.
struct StyledScene
{
  vtkSmartPointer<vtkPoints> frame;   ///< what a picture of it is fitted to
  vtkSmartPointer<vtkInkStyle> style; ///< with the points as its marks
  std::vector<std::string> notes;
};

/// Makes subjects, one or the frames of an animation, with the one style of the options.
class SceneMaker
{
public:
  /// @param options kept as a reference
  /// @param follow whether the samples of a mesh are those of the one before, moved
  explicit SceneMaker(const RenderOptions& options, bool follow = false);

  /// @throws Failure, UsageError
  StyledScene make(const Input& input, Progress& progress);

  /// The iso-value that the first volume was given, where there was none, is the following ones', too.
  void keepIsoValue(const Input& input, std::vector<std::string>& notes, Progress& progress);

private:
  /// What of the volume the style needs to know before it makes marks of it.
  void prepareVolume(const Input& input, std::vector<std::string>& notes);

  const RenderOptions& Options;
};

} // namespace ink::cli
