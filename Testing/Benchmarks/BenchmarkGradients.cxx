// SPDX-License-Identifier: BSD-3-Clause
// vtkInkGradient against VTK's own gradients of images: the same volume and number of threads, in one
// process. The peers are vtkImageGradient (central differences, doubles) where this VTK has it, and
// vtkGradientFilter (the same, in the input's type). All run as filters; vtkImageGradient and vtkInkGradient
// write into the memory of their last output again, vtkGradientFilter allocates anew.
//
// Each case has a counter with its error: the mean angle in degrees to the true gradient near the surface of
// a ball with noise of 5 % of the step. Times are wall-clock and the process's; the repetitions are
// interleaved.

#include "BenchmarkArguments.h"
#include "HashNoise.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkGradientFilter.h"
#include "vtkImageData.h"
#include "vtkInkGradient.h"
#include "vtkMultiThreader.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkVersion.h"

#if __has_include("vtkImageGaussianSmooth.h")
#  include "vtkImageGaussianSmooth.h"
#  define INK_HAS_IMAGE_GAUSSIAN_SMOOTH
#endif
#if __has_include("vtkImageLaplacian.h")
#  include "vtkImageLaplacian.h"
#  define INK_HAS_IMAGE_LAPLACIAN
#endif
#if __has_include("vtkImageGradient.h")
#  include "vtkImageGradient.h"
#  define INK_HAS_IMAGE_GRADIENT
#endif

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace
{

constexpr double Pi = 3.141592653589793;

/// A ball of a third of the cube's size: 1 inside and 0 outside, blurred across four samples, with noise.
template <class T>
vtkSmartPointer<vtkImageData> MakeBall(int type, int n)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(n, n, n);
  image->SetOrigin(-0.5 * (n - 1), -0.5 * (n - 1), -0.5 * (n - 1));
  image->AllocateScalars(type, 1);
  T* value = static_cast<T*>(image->GetScalarPointer());
  const double scale = std::is_integral_v<T> ? 180.0 : 1.0;
  const double offset = std::is_integral_v<T> ? 37.0 : 0.0;
  for (vtkIdType point = 0; point < image->GetNumberOfPoints(); ++point)
  {
    double p[3];
    image->GetPoint(point, p);
    const double distance = std::hypot(p[0], p[1], p[2]) - n / 3.0;
    const double density = 0.5 * std::erfc(distance / std::sqrt(2.0)) +
      0.05 * ink::testing::hashNormal(1, static_cast<std::uint64_t>(point));
    *value++ = static_cast<T>(std::clamp(
      density * scale + offset, std::is_integral_v<T> ? 0.0 : -10.0, std::is_integral_v<T> ? 255.0 : 10.0));
  }
  return image;
}

double MeanAngle(vtkImageData* image, vtkDataArray* gradients)
{
  double sum = 0.0;
  int count = 0;
  const int n = image->GetDimensions()[0];
  for (vtkIdType point = 0; point < image->GetNumberOfPoints(); ++point)
  {
    double p[3];
    image->GetPoint(point, p);
    const double r = std::hypot(p[0], p[1], p[2]);
    if (std::abs(r - n / 3.0) < 1.0)
    {
      double g[3];
      gradients->GetTuple(point, g);
      const double cosine = -(g[0] * p[0] + g[1] * p[1] + g[2] * p[2]) / (r * std::hypot(g[0], g[1], g[2]));
      sum += std::acos(std::clamp(cosine, -1.0, 1.0)) * 180.0 / Pi;
      ++count;
    }
  }
  return sum / count;
}

void SetThreads(int threads)
{
  setenv("VTK_SMP_MAX_THREADS", std::to_string(threads).c_str(), 1);
  vtkSMPTools::SetBackend("STDThread");
  vtkSMPTools::Initialize(threads);
  vtkMultiThreader::SetGlobalMaximumNumberOfThreads(threads);
}

/// Times a filter that `make` sets up; `result` finds its gradients, null for none.
template <class Filter>
void Run(benchmark::State& state, vtkImageData* image, int threads, const std::function<void(Filter*)>& make,
  const std::function<vtkDataArray*(vtkPointData*)>& result)
{
  SetThreads(threads);
  vtkNew<Filter> filter;
  filter->SetInputData(image);
  make(filter);
  filter->Update();
  for ([[maybe_unused]] auto iteration : state)
  {
    filter->Modified();
    filter->Update();
  }
  if (vtkDataArray* gradients =
        result(vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0))->GetPointData()))
  {
    state.counters["degrees"] = MeanAngle(image, gradients);
  }
}

} // namespace

int main(int argc, char* argv[])
{
  if (!InitializeBenchmarks(argc, argv, 9))
  {
    return EXIT_FAILURE;
  }

  const std::vector<std::pair<std::string, vtkSmartPointer<vtkImageData>>> images = {
    { "float 256^3", MakeBall<float>(VTK_FLOAT, 256) },
    { "uint8 256^3", MakeBall<unsigned char>(VTK_UNSIGNED_CHAR, 256) }
  };
  for (const auto& [name, image] : images)
  {
    for (const int threads : { 1, 2 })
    {
      const std::string prefix = name + "/threads:" + std::to_string(threads) + "/";
      const auto add = [&, data = image.Get()](const std::string& what, auto make, auto result)
      {
        benchmark::RegisterBenchmark(
          (prefix + what).c_str(), [=](benchmark::State& state) { make(state, data, threads, result); })
          ->Unit(benchmark::kMillisecond)
          ->MeasureProcessCPUTime()
          ->UseRealTime();
      };
      const auto ours = [&](const std::string& what, const std::function<void(vtkInkGradient*)>& change)
      {
        add(
          "vtkInkGradient " + what,
          [change](benchmark::State& state, vtkImageData* data, int t, const auto& result)
          {
            Run<vtkInkGradient>(
              state, data, t,
              [&](vtkInkGradient* filter)
              {
                filter->ComputeGradientMagnitudeOff();
                change(filter);
              },
              result);
          },
          [](vtkPointData* data) { return data->GetArray("Gradient"); });
      };
      ours("central difference", [](vtkInkGradient* filter) { filter->SetMethodToCentralDifference(); });
      ours("3x3x3 uniform", [](vtkInkGradient* filter) { filter->SetWeightingToUniform(); });
      ours("3x3x3 inverse distance", [](vtkInkGradient* filter) { filter->SetWeightingToInverseDistance(); });
      ours("3x3x3 uniform, doubles",
        [](vtkInkGradient* filter)
        {
          filter->SetWeightingToUniform();
          filter->SetOutputArraysPrecision(vtkAlgorithm::DOUBLE_PRECISION);
        });
      ours("3x3x3 uniform, all arrays",
        [](vtkInkGradient* filter)
        {
          filter->SetWeightingToUniform();
          filter->ComputeGradientMagnitudeOn();
          filter->ComputeValueOn();
        });
      ours("5x5x5 uniform",
        [](vtkInkGradient* filter)
        {
          filter->SetWeightingToUniform();
          filter->SetNeighborhoodTo5();
        });
      ours("5x5x5 inverse distance",
        [](vtkInkGradient* filter)
        {
          filter->SetWeightingToInverseDistance();
          filter->SetNeighborhoodTo5();
        });
      ours("Laplacian, scale 1",
        [](vtkInkGradient* filter)
        {
          filter->ComputeGradientOff();
          filter->ComputeLaplacianOn();
        });
      add(
        "vtkGradientFilter",
        [](benchmark::State& state, vtkImageData* data, int t, const auto& result)
        {
          Run<vtkGradientFilter>(
            state, data, t, [](vtkGradientFilter* filter) { filter->SetResultArrayName("Result"); }, result);
        },
        [](vtkPointData* data) { return data->GetArray("Result"); });
      [[maybe_unused]] const auto none = [](vtkPointData*) -> vtkDataArray* { return nullptr; };
#ifdef INK_HAS_IMAGE_GAUSSIAN_SMOOTH
      // A peer of the Laplacian is the sum of this and the next, which has to wait for it.
      add(
        "vtkImageGaussianSmooth, scale 1",
        [](benchmark::State& state, vtkImageData* data, int t, const auto& result)
        {
          Run<vtkImageGaussianSmooth>(
            state, data, t,
            [](vtkImageGaussianSmooth* filter)
            {
              filter->SetStandardDeviation(1.0);
              // As far as vtkInkGradient's.
              filter->SetRadiusFactors(4.0, 4.0, 4.0);
            },
            result);
        },
        none);
#endif
#ifdef INK_HAS_IMAGE_LAPLACIAN
      add(
        "vtkImageLaplacian",
        [](benchmark::State& state, vtkImageData* data, int t, const auto& result)
        {
          Run<vtkImageLaplacian>(
            state, data, t, [](vtkImageLaplacian* filter) { filter->SetDimensionality(3); }, result);
        },
        none);
#endif
#ifdef INK_HAS_IMAGE_GRADIENT
      add(
        "vtkImageGradient",
        [](benchmark::State& state, vtkImageData* data, int t, const auto& result)
        {
          Run<vtkImageGradient>(
            state, data, t,
            [t](vtkImageGradient* filter)
            {
              filter->SetDimensionality(3);
              filter->SetEnableSMP(true);
              filter->SetNumberOfThreads(t);
            },
            result);
        },
        [](vtkPointData* data) { return data->GetScalars(); });
#endif
    }
  }
  SetThreads(1);
  benchmark::AddCustomContext("VTK", vtkVersion::GetVTKVersion());
  benchmark::AddCustomContext("vtkSMPTools backend", vtkSMPTools::GetBackend());
  benchmark::RunSpecifiedBenchmarks();
  return EXIT_SUCCESS;
}
