// SPDX-License-Identifier: BSD-3-Clause
// vtkInkIsoSurfaceSampler against vtkFlyingEdges3D with normals and without scalars: the same volumes,
// iso-values and numbers of threads, in one process, one run of each after the other, and the medians.
//
//   BenchmarkSampling [--repetitions N] [--fresh] [--wall] [word ...]
//
// Only cases whose name holds all the words are run (for example: sphere threads:1). VTKINK_INSTRUCTION_SET
// names the instructions to use (baseline, avx2, avx512). Times are the process's CPU time on one thread,
// which other programs disturb less than wall-clock time, and wall-clock time on more threads, or always with
// --wall.
//
// The allocation rule: both filters' output buffers are warm. The C library keeps what is freed instead of
// giving it back to the system (mallopt), so that vtkFlyingEdges3D, which makes new arrays in every run,
// finds pages that are there; vtkInkIsoSurfaceSampler fills its own arrays again (ReuseArrays). With --fresh
// neither: the C library as it is, and ReuseArrays off.
//
// Cold: the first run on an input, which also builds the index (a run after ReleaseIndex). Warm: a run for
// another iso-value nearby. vtkFlyingEdges3D has no such difference; it runs for the same iso-values.
//
// Rows are best whose samples fill words of 64: bonsai-250, -302 and -500 have others, bonsai and bonsai-512
// these.

#include "ProcessorTime.h"
#include "Simd/SamplingKernels.h"

#include "vtkInkIsoSurfaceSampler.h"

#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkNIFTIImageReader.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkVersion.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

#include <malloc.h>

namespace
{

struct Scene
{
  std::string Name;
  std::function<vtkSmartPointer<vtkImageData>()> Make;
  double IsoValue;
  double Step; ///< to the next iso-value
};

struct Options
{
  int Repetitions = 9;
  bool Fresh = false;
  bool Wall = false;
  std::vector<std::string> Words;

  bool wants(const std::string& name) const
  {
    return std::all_of(this->Words.begin(), this->Words.end(),
      [&](const std::string& word) { return name.find(word) != std::string::npos; });
  }
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

/// The first n^3 of a volume's bytes, again and again where it has fewer.
vtkSmartPointer<vtkImageData> Fit(vtkImageData* from, int n)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(n, n, n);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  const int* size = from->GetDimensions();
  auto* value = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int k = 0; k < n; ++k)
  {
    for (int j = 0; j < n; ++j)
    {
      const auto* row = static_cast<unsigned char*>(from->GetScalarPointer(0, j % size[1], k % size[2]));
      for (int i = 0; i < n; ++i)
      {
        *value++ = row[i % size[0]];
      }
    }
  }
  return image;
}

/// The distance from the middle of a cube of n^3 samples, times `scale`.
template <class T>
vtkSmartPointer<vtkImageData> MakeDistance(int n, int type, double scale)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(n, n, n);
  image->AllocateScalars(type, 1);
  auto* value = static_cast<T*>(image->GetScalarPointer());
  const double middle = 0.5 * (n - 1);
  for (int k = 0; k < n; ++k)
  {
    for (int j = 0; j < n; ++j)
    {
      const double across = (j - middle) * (j - middle) + (k - middle) * (k - middle);
      for (int i = 0; i < n; ++i)
      {
        *value++ = static_cast<T>(scale * std::sqrt((i - middle) * (i - middle) + across));
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

double Milliseconds(bool wall)
{
  if (wall)
  {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double, std::milli>(now).count();
  }
  return ProcessorTime();
}

double Time(vtkAlgorithm* filter, bool wall)
{
  filter->Modified();
  const double before = Milliseconds(wall);
  filter->Update();
  return Milliseconds(wall) - before;
}

double Median(std::vector<double> times)
{
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

void Run(const Scene& scene, vtkImageData* image, int threads, const Options& options)
{
  SetThreads(threads);
  vtkNew<vtkInkIsoSurfaceSampler> sampler;
  sampler->SetInputData(image);
  sampler->SetReuseArrays(!options.Fresh);
  vtkNew<vtkFlyingEdges3D> edges;
  edges->SetInputData(image);
  edges->ComputeNormalsOn();
  edges->ComputeScalarsOff();
  edges->ComputeGradientsOff();
  const bool wall = options.Wall || threads > 1;
  std::vector<double> cold;
  std::vector<double> warm;
  std::vector<double> peer;
  std::vector<double> cells;
  // The first runs warm everything up.
  for (int n = -1; n < options.Repetitions; ++n)
  {
    const double isoValue = scene.IsoValue + scene.Step * (n % 3);
    edges->SetValue(0, isoValue);
    const double ofPeer = Time(edges, wall);
    sampler->SetValue(0, isoValue);
    sampler->ReleaseIndex();
    const double first = Time(sampler, wall);
    sampler->SetValue(0, isoValue + 0.5 * scene.Step);
    const double next = Time(sampler, wall);
    sampler->SetNormalMethodToCell();
    const double ofCells = Time(sampler, wall);
    sampler->SetNormalMethodToInterpolatedNormal();
    if (n >= 0)
    {
      peer.push_back(ofPeer);
      cold.push_back(first);
      warm.push_back(next);
      cells.push_back(ofCells);
    }
  }
  const double p = Median(peer);
  const double c = Median(cold);
  const double w = Median(warm);
  const double m = Median(cells);
  std::printf("| %-12s | %7lld | %d | %8.2f | %7.2f | %5.1f | %7.2f | %5.1f | %7.2f | %5.1f | %5.2f %% |\n",
    scene.Name.c_str(), static_cast<long long>(sampler->GetOutput()->GetNumberOfPoints()), threads, p, c,
    p / c, w, p / w, m, p / m,
    100.0 * static_cast<double>(sampler->GetIndexMemory()) /
      (1024.0 * static_cast<double>(image->GetActualMemorySize())));
  std::fflush(stdout);
}

Options Parse(int argc, char* argv[])
{
  Options options;
  for (int n = 1; n < argc; ++n)
  {
    const std::string word = argv[n];
    if (word == "--fresh")
    {
      options.Fresh = true;
    }
    else if (word == "--wall")
    {
      options.Wall = true;
    }
    else if (word == "--repetitions" && n + 1 < argc)
    {
      options.Repetitions = std::max(1, std::atoi(argv[++n]));
    }
    else if (word.starts_with("--benchmark_"))
    {
      // Meant for the other benchmarks, which Utilities/bench.sh runs too.
    }
    else if (word.starts_with("--"))
    {
      std::cerr << "unknown option " << word << "; there are --repetitions N, --fresh and --wall\n";
      std::exit(EXIT_FAILURE);
    }
    else
    {
      options.Words.push_back(word);
    }
  }
  return options;
}

} // namespace

int main(int argc, char* argv[])
{
  const Options options = Parse(argc, argv);
  if (!options.Fresh)
  {
    mallopt(M_MMAP_THRESHOLD, 1 << 30);
    mallopt(M_TRIM_THRESHOLD, 2000000000);
  }
  const std::vector<Scene> scenes = {
    { "bonsai", [] { return Read("bonsai.nii.gz"); }, 40.0, 0.1 },
    { "bonsai-250", [] { return Fit(Read("bonsai.nii.gz"), 250); }, 40.0, 0.1 },
    { "bonsai-302", [] { return Fit(Read("bonsai.nii.gz"), 302); }, 40.0, 0.1 },
    { "bonsai-500", [] { return Fit(Read("bonsai.nii.gz"), 500); }, 40.0, 0.1 },
    { "bonsai-512", [] { return Fit(Read("bonsai.nii.gz"), 512); }, 40.0, 0.1 },
    { "engine", [] { return Read("engine.nii.gz"); }, 80.0, 0.1 },
    { "sphere-float", [] { return MakeDistance<float>(512, VTK_FLOAT, 1.0); }, 150.3, 0.1 },
    { "sphere-short", [] { return MakeDistance<short>(512, VTK_SHORT, 64.0); }, 64 * 150.3, 6.4 },
  };
  SetThreads(1);
  std::printf("VTK %s (%s), instruction set %s, %s output buffers, medians of %d\n\n",
    vtkVersion::GetVTKVersion(), vtkSMPTools::GetBackend(), ink::samplingKernels().name,
    options.Fresh ? "fresh" : "warm", options.Repetitions);
  std::printf(
    "| volume | points | threads | FlyingEdges, ms | cold, ms | times faster | warm, ms | times faster | "
    "warm, cell normals, ms | times faster | index |\n|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const Scene& scene : scenes)
  {
    vtkSmartPointer<vtkImageData> image;
    for (const int threads : { 1, 2 })
    {
      if (options.wants(scene.Name + " threads:" + std::to_string(threads)))
      {
        image = image ? image : scene.Make();
        Run(scene, image, threads, options);
      }
    }
  }
  return EXIT_SUCCESS;
}
