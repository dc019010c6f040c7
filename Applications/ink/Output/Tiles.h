// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace ink::cli
{

/// How a picture is rendered in a window that may be smaller than it. Pixels are rendered ones.
///
/// The windows overlap: what is near a tile's border is drawn with what lies beyond it and then cut off.
class Tiles
{
public:
  /// A column or a row of tiles: where its window begins, and the part of it that is used.
  struct Strip
  {
    int first;  ///< pixel of the picture where the used part begins
    int length; ///< of the used part
    int before; ///< pixels of the window before the used part
  };

  /// @param width, height of the picture in rendered pixels, multiples of `factor`
  /// @param longest side of a window; a picture that is no larger is one tile
  /// @param overlap on each side of a tile
  /// @param factor what borders between tiles are multiples of
  Tiles(int width, int height, int longest, int overlap, int factor);

  bool isWhole() const { return this->Scale == 1; }
  /// How many times higher the picture is than a window, for vtkWindow::SetTileScale.
  int scale() const { return this->Scale; }
  /// Of the picture: no more than that of as many windows.
  int height() const { return this->Height; }
  int windowWidth() const { return this->WindowWidth; }
  int windowHeight() const { return this->WindowHeight; }
  const std::vector<Strip>& columns() const { return this->Columns; } ///< from the left
  const std::vector<Strip>& rows() const { return this->Rows; }       ///< from the top

private:
  int Scale = 1;
  int Height;
  int WindowWidth;
  int WindowHeight;
  std::vector<Strip> Columns;
  std::vector<Strip> Rows;
};

} // namespace ink::cli
