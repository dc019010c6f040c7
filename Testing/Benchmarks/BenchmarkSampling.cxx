// SPDX-License-Identifier: BSD-3-Clause
// vtkInkIsoSurfaceSampler against vtkFlyingEdges3D with normals and without scalars: the same volumes,
// iso-values and numbers of threads, in one process. Both run as filters, so both allocate a new output in
// every iteration.
//
// vtkFlyingEdges3D runs on vtkSMPTools' STDThread backend where this VTK has it, else on the one it was built
// with. Times are wall-clock; each case is repeated and the repetitions are interleaved, so compare medians.

#include "vtkInkIsoSurfaceSampler.h"

#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkNIFTIImageReader.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkVersion.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

namespace
{

struct Scene
{
  std::string Name;
  vtkSmartPointer<vtkImageData> Image;
  double IsoValue;
};

vtkSmartPointer<vtkImageData> Read(const std::string& name)
{
  const std::string path = std::string(INK_DATA_DIR) + "/" + name;
  if (!std::filesystem::exists(path))
  {
    std::cerr << "no file " << path << "\n";
    std::exit(EXIT_FAILURE);
  }
  vtkNew<vtkNIFTIImageReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

/// The distance from the middle of a cube of n^3 samples, as float.
vtkSmartPointer<vtkImageData> MakeDistance(int n)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(n, n, n);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* value = static_cast<float*>(image->GetScalarPointer());
  const double middle = 0.5 * (n - 1);
  for (int k = 0; k < n; ++k)
  {
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < n; ++i)
      {
        *value++ = static_cast<float>(std::hypot(i - middle, j - middle, k - middle));
      }
    }
  }
  return image;
}

void SetThreads(int threads)
{
  setenv("VTK_SMP_MAX_THREADS", std::to_string(threads).c_str(), 1);
  vtkSMPTools::SetBackend("STDThread");
  vtkSMPTools::Initialize(threads);
}

template <class Filter>
void Run(benchmark::State& state, const Scene& scene, int threads)
{
  SetThreads(threads);
  vtkNew<Filter> filter;
  filter->SetInputData(scene.Image);
  filter->SetValue(0, scene.IsoValue);
  filter->ComputeNormalsOn();
  if constexpr (std::is_same_v<Filter, vtkFlyingEdges3D>)
  {
    filter->ComputeScalarsOff();
    filter->ComputeGradientsOff();
  }
  for ([[maybe_unused]] auto iteration : state)
  {
    filter->Modified();
    filter->Update();
  }
  state.counters["points"] = static_cast<double>(filter->GetOutput()->GetNumberOfPoints());
}

} // namespace

int main(int argc, char* argv[])
{
  // What the caller gives comes later and wins.
  std::vector<char*> arguments(argv, argv + 1);
  std::string defaults[] = { "--benchmark_repetitions=15", "--benchmark_enable_random_interleaving=true",
    "--benchmark_report_aggregates_only=true", "--benchmark_min_time=0.05" };
  for (std::string& argument : defaults)
  {
    arguments.push_back(argument.data());
  }
  arguments.insert(arguments.end(), argv + 1, argv + argc);
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data()))
  {
    return EXIT_FAILURE;
  }

  const std::vector<Scene> scenes = { { "engine", Read("engine.nii.gz"), 80.0 },
    { "bonsai", Read("bonsai.nii.gz"), 40.0 }, { "sphere", MakeDistance(256), 100.3 } };
  for (const Scene& scene : scenes)
  {
    for (const int threads : { 1, 2 })
    {
      const std::string name = scene.Name + "/threads:" + std::to_string(threads) + "/";
      const auto add = [&](const char* filter, auto run)
      {
        benchmark::RegisterBenchmark(
          (name + filter).c_str(), [=, &scene](benchmark::State& state) { run(state, scene, threads); })
          ->Unit(benchmark::kMillisecond)
          ->MeasureProcessCPUTime()
          ->UseRealTime();
      };
      add("vtkInkIsoSurfaceSampler", Run<vtkInkIsoSurfaceSampler>);
      add("vtkFlyingEdges3D", Run<vtkFlyingEdges3D>);
    }
  }
  SetThreads(1);
  benchmark::AddCustomContext("VTK", vtkVersion::GetVTKVersion());
  benchmark::AddCustomContext("vtkSMPTools backend", vtkSMPTools::GetBackend());
  benchmark::RunSpecifiedBenchmarks();
  return EXIT_SUCCESS;
}
