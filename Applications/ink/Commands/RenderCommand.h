// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Input.h"

#include "vtkInkView.h"
#include "vtkSmartPointer.h"

#include <array>
#include <optional>

class vtkInkStyle;

namespace ink::cli
{

class StyleArguments;

/// Width and height of a picture in pixels.
struct PictureSize
{
  /// OpenGL implementations of today draw 16384 pixels.
  static constexpr int longestWindow = 16384 / vtkInkView::LEAST_SUPERSAMPLING;
  /// More than about a gigabyte of images should not be needed at once.
  static constexpr int mostPixelsAtOnce = 4'200'000;
  /// The side of tiles of what is larger, by default.
  static constexpr int usualTile = 1024;
  /// In smaller ones the least sizes in pixels that splats have would show, enlarged.
  static constexpr int shortestTile = 256;
  static constexpr int longestSide = 100'000;
  static constexpr long long mostPixels = 2'000'000'000;

  int width = 1024;
  int height = 1024;
  int tile = 0; ///< the longest side of a tile, pixels; 0: none where the picture can be drawn at once

  /// How much larger what is rendered is on either side; see takePicture.
  int supersampling() const { return vtkInkView::GetSupersampling(this->width, this->height); }

  /// The longest side that is drawn at once.
  int longestTile() const;

  /// From "N", which is a square, or "WxH". @throws UsageError
  static PictureSize parse(const std::string& text);
};

/// More than one picture.
struct Animation
{
  std::vector<std::filesystem::path>
    files;                         ///< of a series; empty: the viewer goes once around what stands still
  std::vector<std::size_t> frames; ///< which of the files, or parts of the way
  double framesPerSecond = 25;     ///< of a video
};

/// What `ink render` was asked for.
struct RenderOptions
{
  InputOptions input;
  std::filesystem::path output;
  std::optional<std::string> view; ///< by its name; none: the side of a mesh that shows most, or the front
  std::optional<std::string> up;   ///< the axis that is up; none: as a mesh seems to stand, or z
  std::optional<std::array<double, 3>> position;   ///< of the viewer, in place of one from where all is seen
  std::optional<std::array<double, 3>> focalPoint; ///< in the middle of the picture
  double roll = 0;                                 ///< degrees that the picture is turned counterclockwise
  std::optional<double> azimuth;                   ///< degrees
  std::optional<double> elevation;                 ///< degrees; none: 0, or from above where a mesh lies flat
  double zoom = 1;
  bool parallel = false;
  PictureSize size;
  double dotsPerInch = 300;
  vtkSmartPointer<vtkInkStyle> style;         ///< set up but for its data
  const StyleArguments* parameters = nullptr; ///< that it was set up by
  bool transparent = false;
  std::optional<Animation> animation; ///< none: one picture
  bool quiet = false;
  bool timings = false; ///< whether to say how long each step took; of one picture
};

/// What of an input is needed for what was asked for.
Wanted wantedOf(const RenderOptions& options);

/// Draws a picture of a volume or a mesh, or those of an animation.
/// @throws Failure, UsageError
void render(const RenderOptions& options);

} // namespace ink::cli
