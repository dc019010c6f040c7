// SPDX-License-Identifier: BSD-3-Clause
// What the benchmarks that draw frames share: clocks, a window, data, plain points.
#ifndef DrawingBenchmark_h
#define DrawingBenchmark_h

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkNIFTIImageReader.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <string>
#include <vector>

#include <sys/resource.h>

namespace drawing
{

/// Of all threads, in the program and in the system, in seconds.
inline double ProcessorTime()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time)
  { return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec); };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

inline double WallTime()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// In MiB.
inline double PeakMemory()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

inline double Median(std::vector<double> times)
{
  std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2), times.end());
  return times[times.size() / 2];
}

/// The times of frames, in seconds.
struct Frames
{
  std::vector<double> Wall;
  std::vector<double> Processor;

  template <typename Draw>
  void Measure(const Draw& draw)
  {
    const double wallStart = WallTime();
    const double processorStart = ProcessorTime();
    draw();
    this->Wall.push_back(WallTime() - wallStart);
    this->Processor.push_back(ProcessorTime() - processorStart);
  }
};

/// 1024 x 768 pixels of white, without multisampling.
struct Window
{
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Render;

  Window()
  {
    this->Renderer->SetBackground(1.0, 1.0, 1.0);
    this->Render->SetOffScreenRendering(true);
    this->Render->SetMultiSamples(0);
    this->Render->SetSize(1024, 768);
    this->Render->AddRenderer(this->Renderer);
  }
  void ResetCamera()
  {
    this->Renderer->ResetCamera();
    this->Renderer->GetActiveCamera()->Zoom(1.4);
  }
  void Turn(double degrees)
  {
    this->Renderer->GetActiveCamera()->Azimuth(degrees);
    this->Renderer->ResetCameraClippingRange();
  }
  void Draw()
  {
    this->Render->Render();
    this->Render->WaitForCompletion();
  }
};

inline vtkSmartPointer<vtkImageData> ReadVolume(const char* name)
{
  vtkNew<vtkNIFTIImageReader> reader;
  reader->SetFileName((std::string(INK_DATA_DIR "/") + name).c_str());
  reader->Update();
  return reader->GetOutput();
}

/// Three shells, one in the other, of different densities, with noise.
inline vtkSmartPointer<vtkImageData> MakeVolume(int x, int y, int z)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(x, y, z);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* values = vtkUnsignedCharArray::SafeDownCast(image->GetPointData()->GetScalars());
  unsigned int random = 1;
  vtkIdType n = 0;
  for (int k = 0; k < z; ++k)
  {
    for (int j = 0; j < y; ++j)
    {
      for (int i = 0; i < x; ++i, ++n)
      {
        const double r = 2.0 * std::hypot((i + 0.5) / x - 0.5, (j + 0.5) / y - 0.5, (k + 0.5) / z - 0.5);
        const double shells = r < 0.3 ? 220.0 : r < 0.6 ? 120.0 : r < 0.9 ? 60.0 : 0.0;
        random = random * 1664525u + 1013904223u;
        values->SetValue(n, static_cast<unsigned char>(shells + (random >> 28)));
      }
    }
  }
  return image;
}

/// One cell over all points, as VTK's own mappers need it.
inline void AddVertices(vtkPolyData* points)
{
  vtkNew<vtkIdList> ids;
  ids->SetNumberOfIds(points->GetNumberOfPoints());
  std::iota(ids->begin(), ids->end(), 0);
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell(ids);
  points->SetVerts(vertices);
}

struct Arguments
{
  int Frames;
  std::vector<int> Counts;
};

/// What a program was given as `--frames 15 1000 10000`.
/// @param frames, counts where it was given none
inline Arguments ReadArguments(int argc, char* argv[], int frames, const std::vector<int>& counts)
{
  Arguments given{ frames, {} };
  for (int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    if (argument == "--frames" && i + 1 < argc)
    {
      given.Frames = std::max(1, std::atoi(argv[++i]));
    }
    else if (const int count = std::atoi(argument.c_str()); count > 0)
    {
      given.Counts.push_back(count);
    }
  }
  given.Counts = given.Counts.empty() ? counts : given.Counts;
  return given;
}

} // namespace drawing

#endif
