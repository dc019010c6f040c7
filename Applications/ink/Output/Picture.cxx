// SPDX-License-Identifier: BSD-3-Clause
#include "Picture.h"

#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace ink::cli
{

void PictureRows::resize(int columns, int rows)
{
  this->width = columns;
  this->height = rows;
  this->pixels.resize(this->rowBytes() * static_cast<std::size_t>(rows));
}

void takePicture(vtkRenderWindow* window, const WindowPart& part, int factor, PictureRows& rows, int column)
{
  // Of what was rendered only some rows are in memory, too.
  constexpr int rowsAtOnce = 128;
  const int width = part.width / factor;
  const int height = part.height / factor;
  const int count = factor * factor;
  vtkNew<vtkUnsignedCharArray> rendered;
  for (int first = 0; first < height; first += rowsAtOnce)
  {
    const int end = std::min(first + rowsAtOnce, height);
    const int bottom = part.bottom + first * factor;
    constexpr int backBuffer = 0;
    window->GetPixelData(part.left, bottom, part.left + part.width - 1, bottom + (end - first) * factor - 1,
      backBuffer, rendered);
    const std::size_t rowLength = 3 * static_cast<std::size_t>(part.width);
    for (int y = first; y < end; ++y)
    {
      // OpenGL's lowest row is the first.
      unsigned char* target = rows.pixels.data() +
        static_cast<std::size_t>(height - 1 - y) * rows.rowBytes() + 3 * static_cast<std::size_t>(column);
      for (int x = 0; x < width; ++x, target += 3)
      {
        int sum[3] = { 0, 0, 0 };
        for (int j = 0; j < factor; ++j)
        {
          const unsigned char* source = rendered->GetPointer(0) +
            static_cast<std::size_t>((y - first) * factor + j) * rowLength +
            3 * static_cast<std::size_t>(x) * static_cast<std::size_t>(factor);
          for (int i = 0; i < 3 * factor; ++i)
          {
            sum[i % 3] += source[i];
          }
        }
        std::transform(sum, sum + 3, target,
          [count](int s) { return static_cast<unsigned char>((s + count / 2) / count); });
      }
    }
  }
}

std::vector<unsigned char> findAlpha(
  std::span<const unsigned char> onBlack, std::span<const unsigned char> onWhite)
{
  const std::size_t count = onBlack.size() / 3;
  std::vector<unsigned char> picture(4 * count);
  const unsigned char* black = onBlack.data();
  const unsigned char* white = onWhite.data();
  unsigned char* target = picture.data();
  for (std::size_t i = 0; i < count; ++i, black += 3, white += 3, target += 4)
  {
    int background = 0;
    for (int j = 0; j < 3; ++j)
    {
      background += white[j] - black[j];
    }
    const int alpha = std::clamp(255 - (background + 1) / 3, 0, 255);
    for (int j = 0; j < 3; ++j)
    {
      const int color = alpha == 0 ? 0 : (black[j] * 255 + alpha / 2) / alpha;
      target[j] = static_cast<unsigned char>(std::min(color, 255));
    }
    target[3] = static_cast<unsigned char>(alpha);
  }
  return picture;
}

} // namespace ink::cli
