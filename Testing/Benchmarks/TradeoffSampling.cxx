// SPDX-License-Identifier: BSD-3-Clause
// Iso-surface samples: the angle between their normals and the true ones against the time to place them.

#include "Tradeoff.h"

#include "AnalyticFields.h"
#include "HashNoise.h"
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

/// Mean angle in degrees at the samples within 1 of the surface.
double Error(const glm::dvec3& spacing, double noise, const SampleOptions& options, Storage storage)
{
  const glm::ivec3 n(glm::ceil(glm::dvec3(48.0, 48.0, 24.0) / spacing));
  const auto volume = Scan(ink::GridGeometry(n, -0.5 * spacing * glm::dvec3(n - 1), spacing), noise);
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

/// Samples a surface of some 100,000 points in what it finds in memory.
class Run
{
public:
  Run()
    : Fine(Scan(
        ink::GridGeometry({ 220, 220, 110 }, glm::dvec3(-24.0, -24.0, -12.0), glm::dvec3(48.0 / 219.0)), 0.0))
  {
  }

  void operator()(const SampleOptions& options, Storage storage)
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
    { std::pair("cell", NormalMethod::Cell), std::pair("gradient", NormalMethod::Gradient),
      std::pair("central difference", NormalMethod::CentralDifference),
      std::pair("regression", NormalMethod::Regression) })
  {
    const SampleOptions options{ ink::CrossingRule::HalfOpen, method, Arithmetic::Single };
    methods.Add(
      name, [&run, options] { run(options, Storage::Float); }, ErrorsOf(options, Storage::Float),
      method == NormalMethod::CentralDifference ? Tradeoff::Default : Tradeoff::Choice);
  }
  methods.Print();

  Tradeoff precision("Precision of samples (vtkInkIsoSurfaceSampler)",
    "Keep single precision; take normals of 16 or 8 bits where memory is short.", ErrorUnit, Work);
  for (const auto& [name, arithmetic, storage] : { std::tuple("double", Arithmetic::Double, Storage::Float),
         std::tuple("single", Arithmetic::Single, Storage::Float),
         std::tuple("single, normals of 16 bits", Arithmetic::Single, Storage::Short),
         std::tuple("single, normals of 8 bits", Arithmetic::Single, Storage::Char) })
  {
    const SampleOptions options{ ink::CrossingRule::HalfOpen, NormalMethod::CentralDifference, arithmetic };
    const Storage kept = storage;
    precision.Add(
      name, [&run, options, kept] { run(options, kept); }, ErrorsOf(options, storage),
      arithmetic == Arithmetic::Single && storage == Storage::Float ? Tradeoff::Default : Tradeoff::Choice);
  }
  precision.Print();
  return EXIT_SUCCESS;
}
