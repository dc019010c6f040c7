#include "Picture.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkRenderWindow.h"
#include "vtkUnsignedCharArray.h"

#include <cstddef>

namespace ink::cli
{

vtkSmartPointer<vtkImageData> takePicture(vtkRenderWindow* window, int factor, bool transparent)
{
  const int* size = window->GetSize();
  const int width = size[0] / factor;
  const int height = size[1] / factor;
  vtkNew<vtkUnsignedCharArray> rendered;
  constexpr int backBuffer = 0;
  window->GetRGBACharPixelData(0, 0, size[0] - 1, size[1] - 1, backBuffer, rendered);

  const int components = transparent ? 4 : 3;
  vtkNew<vtkImageData> picture;
  picture->SetDimensions(width, height, 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, components);
  auto* target = static_cast<unsigned char*>(picture->GetScalarPointer());
  const unsigned char* source = rendered->GetPointer(0);
  const std::size_t rowLength = 4 * static_cast<std::size_t>(size[0]);
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x, target += components)
    {
      int sum[4] = { 0, 0, 0, 0 };
      for (int j = 0; j < factor; ++j)
      {
        const unsigned char* pixel =
          source + (y * factor + j) * rowLength + 4 * static_cast<std::size_t>(x) * factor;
        for (int i = 0; i < 4 * factor; ++i)
        {
          sum[i % 4] += pixel[i];
        }
      }
      const int count = factor * factor;
      // Rendered colours are multiplied by alpha.
      const int weight = transparent ? sum[3] : 255 * count;
      for (int i = 0; i < 3; ++i)
      {
        const int color = weight == 0 ? 0 : (sum[i] * 255 + weight / 2) / weight;
        target[i] = static_cast<unsigned char>(color < 255 ? color : 255);
      }
      if (transparent)
      {
        target[3] = static_cast<unsigned char>((sum[3] + count / 2) / count);
      }
    }
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
