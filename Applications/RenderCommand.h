#pragma once

#include "Color.h"
#include "Input.h"
#include "SampleMesh.h"
#include "StippleStyle.h"
#include "View.h"

#include "vtkSmartPointer.h"

#include <optional>

class vtkInkSplattingLinesMapper;

namespace ink::cli
{

/// Width and height of a picture in pixels.
struct PictureSize
{
  /// What is rendered is this much larger on either side; see takePicture.
  static constexpr int supersampling = 2;
  /// OpenGL implementations of today draw 16384 pixels.
  static constexpr int largestSide = 16384 / supersampling;
  /// Some OpenGL implementations, Mesa's for the CPU among them, refuse float images of more than 2 GiB.
  static constexpr int mostPixels = 24'000'000;

  int width = 1024;
  int height = 1024;

  /// From "WxH". \throw UsageError
  static PictureSize parse(const std::string& text);
};

/// More than one picture.
struct Animation
{
  std::vector<std::filesystem::path>
    files;                         ///< of a series; empty: the viewer goes once around what stands still
  std::vector<std::size_t> frames; ///< which of the files, or places on the way
  double framesPerSecond = 25;     ///< of a video
};

/// What `ink render` was asked for.
struct RenderOptions
{
  InputOptions input;
  std::filesystem::path output;
  std::vector<double> isoValues;    ///< empty: one is chosen; with stipples none
  std::optional<long long> samples; ///< on a mesh; none: as many as suit it, 0: its vertices are drawn
  CloudSampling cloud;
  std::string view = "front";
  double azimuth = 0;   ///< degrees
  double elevation = 0; ///< degrees
  double zoom = 1;
  bool parallel = false;
  PictureSize size;
  std::optional<StippleStyle> stipple;
  vtkSmartPointer<vtkInkSplattingLinesMapper> lines; ///< unless there are stipples
  std::optional<Color> paperColor{ { 1, 1, 1 } };    ///< none: ink only
  Color background{ 1, 1, 1 };
  bool transparent = false;
  std::optional<Animation> animation; ///< none: one picture
  bool quiet = false;
};

/// What of an input is needed for what was asked for.
Wanted wantedOf(const RenderOptions& options);

/// Draws a picture of a volume or a mesh, or those of an animation.
/// \throw Failure, UsageError
void render(const RenderOptions& options);

} // namespace ink::cli
