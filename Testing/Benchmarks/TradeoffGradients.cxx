// SPDX-License-Identifier: BSD-3-Clause
// Gradient kernels: the angle to the true gradient against the time.

#include "Tradeoff.h"

#include "Fields/Grid/GridField.h"

#include "AnalyticFields.h"
#include "EstimatedGradients.h"
#include "HashNoise.h"
#include "SampledVolume.h"

#include <cmath>

namespace
{

using namespace ink::testing;

/// What a scanner sees of a solid: 1 inside, 0 outside, blurred by a Gaussian of deviation 1 across the
/// surface, with noise of a share of the step.
template <class Shape>
Volume<float> Scan(const Shape& shape, const ink::GridGeometry& grid, double noise)
{
  std::uint64_t index = 0;
  return Volume<float>::from(grid,
    [&](const glm::dvec3& p)
    { return 0.5 * std::erfc(shape.distance(p) / std::sqrt(2.0)) + noise * hashNormal(1, index++); });
}

/// Mean angle in degrees at the samples within 1 of the surface.
template <class Shape>
double Error(const Shape& shape, const glm::dvec3& spacing, double noise, const ink::GradientOptions& options)
{
  const glm::ivec3 n = glm::ivec3(48.0 / spacing);
  const ink::GridGeometry grid(n, -0.5 * glm::dvec3(n - 1) * spacing, spacing);
  const Volume<float> volume = Scan(shape, grid, noise);
  const auto gradients = gradientsOf<float>(volume.field(), options);
  double sum = 0.0;
  int count = 0;
  forEachSample(inside(grid, 2),
    [&](const glm::ivec3& sample)
    {
      const glm::dvec3 p = grid.toWorld(sample);
      if (std::abs(shape.distance(p)) < 1.0)
      {
        sum += angleBetween(gradients.gradient(sample), -shape.gradient(p));
        ++count;
      }
    });
  return sum / count;
}

Tradeoff::Errors ErrorsOf(const ink::GradientOptions& options)
{
  const Torus torus{ 14.0, 6.0 };
  const glm::dvec3 even(1.0);
  const glm::dvec3 uneven(1.0, 1.0, 3.0);
  return { { "no noise", Error(torus, even, 0.0, options) },
    { "5 % noise", Error(torus, even, 0.05, options) },
    { "spacing 1:1:3, no noise", Error(torus, uneven, 0.0, options) },
    { "spacing 1:1:3, 5 % noise", Error(torus, uneven, 0.05, options) } };
}

} // namespace

int main()
{
  Tradeoff::PrintHeader();
  Tradeoff knob("Gradient method (vtkInkGradient)",
    "Keep the regression over 3x3x3 neighbors with equal weights; weigh by inverse distance where the "
    "spacing is uneven, take 5x5x5 neighbors for data so noisy that features smaller than five samples "
    "are lost anyway, and central differences only where no neighbor but the nearest may count.",
    "mean angle to the true gradient, degrees", "the gradients of 160x160x160 floats");
  const ink::GridGeometry grid({ 160, 160, 160 }, glm::dvec3(-24.0), glm::dvec3(48.0 / 159.0));
  const Volume<float> volume = Scan(Torus{ 14.0, 6.0 }, grid, 0.05);
  const ink::GridField<float> field = volume.field();
  const ink::SampleBox box{ glm::ivec3(0), grid.dimensions() };
  std::vector<float> gradients(3 * box.count());
  for (const ink::GradientOptions& options : allGradientOptions())
  {
    const auto run = [&, options] {
      ink::estimateGradients<float, float>(field, box, options, { gradients, {}, {} });
    };
    const ink::GradientOptions standard;
    const bool isDefault = nameOf(options) == nameOf(standard);
    knob.Add(nameOf(options), run, ErrorsOf(options), isDefault ? Tradeoff::Default : Tradeoff::Choice);
  }
  knob.Print();
  return EXIT_SUCCESS;
}
