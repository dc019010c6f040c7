// SPDX-License-Identifier: BSD-3-Clause
#include "Picture.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkRenderWindow.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstddef>

namespace ink::cli
{
namespace
{

vtkSmartPointer<vtkImageData> makePicture(int width, int height, int components)
{
  vtkNew<vtkImageData> picture;
  picture->SetDimensions(width, height, 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, components);
  return picture;
}

unsigned char* pixels(vtkImageData* picture)
{
  return static_cast<unsigned char*>(picture->GetScalarPointer());
}

} // namespace

vtkSmartPointer<vtkImageData> takePicture(vtkRenderWindow* window, int factor)
{
  const int* size = window->GetSize();
  vtkNew<vtkUnsignedCharArray> rendered;
  constexpr int backBuffer = 0;
  window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, backBuffer, rendered);

  const int width = size[0] / factor;
  const int height = size[1] / factor;
  const auto picture = makePicture(width, height, 3);
  unsigned char* target = pixels(picture);
  const std::size_t rowLength = 3 * static_cast<std::size_t>(size[0]);
  const int count = factor * factor;
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x, target += 3)
    {
      int sum[3] = { 0, 0, 0 };
      for (int j = 0; j < factor; ++j)
      {
        const unsigned char* source =
          rendered->GetPointer(0) + (y * factor + j) * rowLength + 3 * static_cast<std::size_t>(x) * factor;
        for (int i = 0; i < 3 * factor; ++i)
        {
          sum[i % 3] += source[i];
        }
      }
      std::transform(
        sum, sum + 3, target, [count](int s) { return static_cast<unsigned char>((s + count / 2) / count); });
    }
  }
  return picture;
}

vtkSmartPointer<vtkImageData> findAlpha(vtkImageData* onBlack, vtkImageData* onWhite)
{
  const int* size = onBlack->GetDimensions();
  const auto picture = makePicture(size[0], size[1], 4);
  const unsigned char* black = pixels(onBlack);
  const unsigned char* white = pixels(onWhite);
  unsigned char* target = pixels(picture);
  for (vtkIdType i = 0; i < picture->GetNumberOfPoints(); ++i, black += 3, white += 3, target += 4)
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

vtkSmartPointer<vtkUnsignedCharArray> encodePng(vtkImageData* picture)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(picture);
  writer->WriteToMemoryOn();
  writer->Write();
  return writer->GetResult();
}

} // namespace ink::cli
