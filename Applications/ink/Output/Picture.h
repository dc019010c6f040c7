// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>
#include <vector>

class vtkRenderWindow;

namespace ink::cli
{

/// Some rows of a picture from the top on: red, green and blue, 8 bits each.
struct PictureRows
{
  int width = 0;
  int height = 0;
  std::vector<unsigned char> pixels; ///< rows from top to bottom

  void resize(int columns, int rows);
  std::size_t rowBytes() const { return 3 * static_cast<std::size_t>(this->width); }
};

/// A part of a window, in its pixels from the lower left.
struct WindowPart
{
  int left = 0;
  int bottom = 0;
  int width = 0;
  int height = 0;
};

/// Takes a part of what is in a window into rows of a picture, made smaller by a factor: each pixel is the
/// mean of factor x factor rendered ones, which smooths edges and lines alike.
/// @param part its sides are multiples of the factor
/// @param column of the picture where the part begins, which is as high as the rows are
void takePicture(vtkRenderWindow* window, const WindowPart& part, int factor, PictureRows& rows, int column);

/// Rows with alpha as files have it, not multiplied into the colors, from the same scene before black and
/// before white: where both are equal, the scene hides the background. What alpha VTK itself leaves behind
/// depends on how it blends, and that on its version.
/// @return red, green, blue and alpha of each pixel
std::vector<unsigned char> findAlpha(
  std::span<const unsigned char> onBlack, std::span<const unsigned char> onWhite);

} // namespace ink::cli
