// SPDX-License-Identifier: BSD-3-Clause
// Iso-surface samples: the angle between their normals and the true ones, and their distance from the
// surface, against the time to compute them.

#include "Tradeoff.h"

#include "AnalyticFields.h"
#include "HashNoise.h"
#include "IsoSurface/ProjectSamples.h"
#include "SampledVolume.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace
{

using namespace ink::testing;
using ink::Arithmetic;
using ink::NormalMethod;
using ink::SampleOptions;

/// What is stored of a normal: float, or an integer of so many steps to 1.
enum class Storage
{
  Float = 0,
  Short = 32767,
  Char = 127
};

const Torus Shape{ 14.0, 6.0 };

/// What a scanner sees of a torus: 1 inside, 0 outside, blurred by a Gaussian of deviation 1 across the
/// surface, with noise of a share of the step.
Volume<float> Scan(const ink::GridGeometry& grid, double noise)
{
  std::uint64_t index = 0;
  return Volume<float>::from(grid,
    [&](const glm::dvec3& p)
    { return 0.5 * std::erfc(Shape.distance(p) / std::sqrt(2.0)) + noise * hashNormal(1, index++); });
}

/// The scan with voxels of that spacing.
Volume<float> ScanAt(const glm::dvec3& spacing, double noise)
{
  const glm::ivec3 n(glm::ceil(glm::dvec3(48.0, 48.0, 24.0) / spacing));
  return Scan(ink::GridGeometry(n, -0.5 * spacing * glm::dvec3(n - 1), spacing), noise);
}

/// Mean angle in degrees at the samples within 1 of the surface.
double Error(const glm::dvec3& spacing, double noise, const SampleOptions& options, Storage storage)
{
  const auto volume = ScanAt(spacing, noise);
  const auto samples = sampleIsoSurface<float>(volume.field(), 0.5, options);
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    if (std::abs(Shape.distance(samples.point(i))) > 1.0)
    {
      continue;
    }
    glm::dvec3 normal = samples.normal(i);
    if (storage != Storage::Float)
    {
      normal = glm::normalize(glm::round(normal * static_cast<double>(storage)));
    }
    const glm::dvec3 truth = glm::normalize(Shape.gradient(samples.point(i)));
    sum += std::atan2(glm::length(glm::cross(normal, truth)), glm::dot(normal, truth));
    ++count;
  }
  return sum / count * 180.0 / std::acos(-1.0);
}

Tradeoff::Errors ErrorsOf(const SampleOptions& options, Storage storage)
{
  const glm::dvec3 even(1.0);
  const glm::dvec3 uneven(1.0, 1.0, 3.0);
  return { { "no noise", Error(even, 0.0, options, storage) },
    { "5 % noise", Error(even, 0.05, options, storage) },
    { "spacing 1:1:3, no noise", Error(uneven, 0.0, options, storage) } };
}

/// Mean distance, in voxels, of projected samples from the surface of the interpolated field and, last, from
/// the torus that was scanned.
Tradeoff::Errors DistancesOf(int steps)
{
  const auto project = [steps](const Volume<float>& volume)
  {
    auto samples = sampleIsoSurface<float>(volume.field(), 0.5);
    ink::projectSamples(volume.field(), volume.geometry, 0.5, steps, std::span<float>(samples.coordinates));
    return samples;
  };
  const auto mean = [](const auto& samples, const auto& distance)
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < samples.size(); ++i)
    {
      sum += std::abs(distance(samples.point(i)));
    }
    return sum / static_cast<double>(samples.size());
  };
  const auto fromInterpolated = [&](const Volume<float>& volume)
  {
    const auto field = volume.field();
    return mean(project(volume),
      [&](const glm::dvec3& p) { return (field.value(p) - 0.5) / glm::length(field.gradient(p)); });
  };
  const Volume<float> even = ScanAt(glm::dvec3(1.0), 0.0);
  return { { "no noise", fromInterpolated(even) },
    { "5 % noise", fromInterpolated(ScanAt(glm::dvec3(1.0), 0.05)) },
    { "spacing 1:1:3, no noise", fromInterpolated(ScanAt({ 1.0, 1.0, 3.0 }, 0.0)) },
    { "from the true torus, no noise",
      mean(project(even), [](const glm::dvec3& p) { return Shape.distance(p); }) } };
}

/// Samples a surface of some 100,000 points in what it finds in memory.
class Run
{
public:
  Run()
    : Fine(Scan(
        ink::GridGeometry({ 220, 220, 110 }, glm::dvec3(-24.0, -24.0, -12.0), glm::dvec3(48.0 / 219.0)), 0.0))
  {
  }

  void operator()(const SampleOptions& options, Storage storage, int projectionSteps = 0)
  {
    const ink::GrowRoom grow = [&](std::size_t count)
    {
      this->Points.resize(std::max(this->Points.size(), 3 * count));
      ink::SampleRoom room;
      room.points = this->Points.data();
      room.capacity = this->Points.size() / 3;
      const auto use = [&](auto& normals)
      {
        normals.resize(this->Points.size());
        return normals.data();
      };
      room.normals = storage == Storage::Float ? use(this->Floats) : nullptr;
      room.shortNormals = storage == Storage::Short ? use(this->Shorts) : nullptr;
      room.byteNormals = storage == Storage::Char ? use(this->Bytes) : nullptr;
      return room;
    };
    const double isoValue = 0.5;
    std::vector<std::size_t> counts;
    ink::sampleIsoSurfaces(this->Fine.field(), std::span<const double>(&isoValue, 1), options, {}, nullptr,
      grow, std::size_t(200000), counts);
    if (projectionSteps > 0)
    {
      ink::projectSamples(this->Fine.field(), this->Fine.geometry, isoValue, projectionSteps,
        std::span<float>(this->Points.data(), 3 * counts[0]));
    }
  }

private:
  Volume<float> Fine;
  std::vector<float> Points;
  std::vector<float> Floats;
  std::vector<std::int16_t> Shorts;
  std::vector<std::int8_t> Bytes;
};

const char* const ErrorUnit = "mean angle to the true normal, degrees";
const char* const Work = "the samples of a torus in 220x220x110 floats";

} // namespace

int main()
{
  Tradeoff::PrintHeader();
  Run run;

  Tradeoff methods("Normal method (vtkInkIsoSurfaceSampler)",
    "Keep central differences; take the cell's own gradient for previews, and the regression where there is "
    "noise.",
    ErrorUnit, Work);
  for (const auto& [name, method] :
    { std::pair("cell", NormalMethod::Cell), std::pair("gradient", NormalMethod::InterpolatedGradient),
      std::pair("central difference", NormalMethod::InterpolatedNormal),
      std::pair("regression", NormalMethod::Regression) })
  {
    const SampleOptions options{ ink::CrossingRule::HalfOpen, method, Arithmetic::Single };
    methods.Add(
      name, [&run, options] { run(options, Storage::Float); }, ErrorsOf(options, Storage::Float),
      method == NormalMethod::InterpolatedNormal ? Tradeoff::Default : Tradeoff::Choice);
  }
  methods.Print();

  Tradeoff precision("Precision of samples (vtkInkIsoSurfaceSampler)",
    "Keep single precision; take normals of 16 or 8 bits where memory is short.", ErrorUnit, Work);
  for (const auto& [name, arithmetic, storage] : { std::tuple("double", Arithmetic::Double, Storage::Float),
         std::tuple("single", Arithmetic::Single, Storage::Float),
         std::tuple("single, normals of 16 bits", Arithmetic::Single, Storage::Short),
         std::tuple("single, normals of 8 bits", Arithmetic::Single, Storage::Char) })
  {
    const SampleOptions options{ ink::CrossingRule::HalfOpen, NormalMethod::InterpolatedNormal, arithmetic };
    const Storage kept = storage;
    precision.Add(
      name, [&run, options, kept] { run(options, kept); }, ErrorsOf(options, storage),
      arithmetic == Arithmetic::Single && storage == Storage::Float ? Tradeoff::Default : Tradeoff::Choice);
  }
  precision.Print();

  Tradeoff projection("Projection steps (vtkInkIsoSurfaceSampler)",
    "Keep 0, whose points are some hundredths of a voxel off, less than lines show; take 2 where what is "
    "computed from points needs them on the surface, which takes 1 us a point and comes little closer to "
    "what "
    "was scanned.",
    "mean distance from the surface of the interpolated field, voxels", Work);
  for (const int steps : { 0, 1, 2, 3 })
  {
    projection.Add(
      std::to_string(steps), [&run, steps] { run({}, Storage::Float, steps); }, DistancesOf(steps),
      steps == 0 ? Tradeoff::Default : Tradeoff::Choice);
  }
  projection.Print();
  return EXIT_SUCCESS;
}
