// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkTestImage_h
#define InkTestImage_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkRenderWindow;

/// A picture that a test asks questions about: RGB or RGBA, pixel (0, 0) at the lower left.
class InkTestImage
{
public:
  /// Renders the window and takes its picture.
  /// @param scale the picture is this many times larger than the window, drawn in tiles
  /// @param alpha take the alpha channel, too
  explicit InkTestImage(vtkRenderWindow* window, int scale = 1, bool alpha = false);

  int GetWidth() const;
  int GetHeight() const;

  /// Brightness, 0 to 255: the mean of red, green and blue.
  int Gray(int x, int y) const;
  int Channel(int x, int y, int channel) const;
  bool IsDark(int x, int y) const { return this->Gray(x, y) < 128; }

  /// How many pixels of [x0, x1) x [y0, y1) are darker than a brightness; without bounds, of all.
  int CountDark(int x0, int y0, int x1, int y1, int brightness = 128) const;
  int CountDark(int brightness = 128) const;

  /// The darkness of all pixels: the sum of 1 - brightness / 255.
  double Ink() const;

  /// How many pixels differ by more than a tolerance in any channel; all of them when the sizes differ.
  int CountDifferent(const InkTestImage& other, int tolerance = 0) const;

  vtkImageData* GetData() const { return this->Data; }
  void Write(const std::string& path) const;

private:
  vtkSmartPointer<vtkImageData> Data;
};

#endif
