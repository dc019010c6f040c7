// SPDX-License-Identifier: BSD-3-Clause
// Samples of meshes: how large the holes between them are against the time to make them.

#include "Tradeoff.h"

#include "PointSampling/PoissonDisk.h"
#include "PointSampling/PoissonDiskCount.h"
#include "PointSampling/ProgressiveBlueNoise.h"
#include "PointSampling/WhiteNoise.h"
#include "SampledMeshes.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace
{

using namespace ink::test;

/// Meshes of area 1: a torus of many triangles, and a square of two.
std::vector<std::pair<std::string, Mesh>> Scenes()
{
  std::vector<std::pair<std::string, Mesh>> scenes = { { "torus", torus(1.0, 0.4, 300, 150) },
    { "square", square(1) } };
  for (auto& [name, mesh] : scenes)
  {
    const double scale = 1.0 / std::sqrt(ink::cumulateArea(mesh.view()).area.back());
    for (glm::dvec3& point : mesh.points)
    {
      point *= scale;
    }
  }
  return scenes;
}

const auto AllScenes = Scenes();

std::vector<ink::SurfaceSample> Sample(const Mesh& mesh, bool blue, double radius, double slack)
{
  const auto areas = ink::cumulateArea(mesh.view());
  return blue ? ink::samplePoissonDisk(mesh.view(), areas, radius, slack, 1).samples
              : ink::sampleWhiteNoise(
                  mesh.view(), areas, static_cast<std::size_t>(ink::saturatedCount / (radius * radius)), 1);
}

/// The farthest of many points on the mesh from the nearest sample.
double Hole(const Mesh& mesh, const std::vector<ink::SurfaceSample>& samples)
{
  const auto areas = ink::cumulateArea(mesh.view());
  const auto candidates = positionsOf(mesh.view(), ink::sampleWhiteNoise(mesh.view(), areas, 2000, 77));
  const auto points = positionsOf(mesh.view(), samples);
  return largestGap(candidates, points, points.size());
}

void MeasureCoverageSlack()
{
  const double radius = 0.01;
  Tradeoff knob("CoverageSlack (vtkInkSurfaceSampler)",
    "Keep 0.06: more slack saves up to a fifth of the time, the most slack two fifths; they are for those "
    "who "
    "want fewer samples of the same least distance.",
    "farthest point from a sample, of the radius",
    "blue noise of a radius of a hundredth of the square root of the area, on the torus");
  for (const double slack : { 0.02, 0.06, 0.15, 0.3, 0.6, 1.0 })
  {
    Tradeoff::Errors errors;
    for (const auto& [name, mesh] : AllScenes)
    {
      const auto samples = Sample(mesh, true, radius, slack);
      errors.emplace_back(name, Hole(mesh, samples) / radius);
    }
    std::string title = std::to_string(slack);
    knob.Add(
      title.substr(0, 4), [=] { Sample(AllScenes[0].second, true, radius, slack); }, errors,
      slack == ink::defaultCoverageSlack ? Tradeoff::Default : Tradeoff::Choice);
  }
  knob.Print(3);
}

void MeasureDensity()
{
  Tradeoff knob("Number of samples (vtkInkSurfaceSampler)",
    "Keep some 100,000 samples of blue noise for a drawing of a thousand pixels; four times as many halve "
    "the holes, and "
    "white noise has the same holes with four times as many, in a twentieth of the time.",
    "farthest point from a sample, of the square root of the area", "samples of the torus");
  for (const bool blue : { false, true })
  {
    for (const int count : { 1000, 10000, 100000, 400000 })
    {
      const double radius = std::sqrt(ink::saturatedCount / count);
      Tradeoff::Errors errors;
      for (const auto& [name, mesh] : AllScenes)
      {
        errors.emplace_back(name, Hole(mesh, Sample(mesh, blue, radius, ink::defaultCoverageSlack)));
      }
      knob.Add(
        std::to_string(count) + (blue ? " blue" : " white"),
        [=] { Sample(AllScenes[0].second, blue, radius, ink::defaultCoverageSlack); }, errors,
        blue && count == 100000 ? Tradeoff::Default : Tradeoff::Choice);
    }
  }
  knob.Print(3);
}

/// Samples in order of priority. Of the progressive ones the filter makes those of eight candidates.
void MeasureMethod()
{
  constexpr std::size_t count = 100000;
  Tradeoff knob("Method (vtkInkSurfaceSampler)",
    "Take progressive blue noise for stipples, for millions of samples, and where the first samples are "
    "drawn "
    "more often than all of them; blue noise where all are drawn and every hole counts.",
    "farthest point from a sample, of the square root of the area, with all of 100,000 samples and with the "
    "first quarter",
    "100,000 samples of the torus, in order of priority");
  const Mesh& mesh = AllScenes[0].second;
  const auto areas = ink::cumulateArea(mesh.view());
  const auto add = [&](const std::string& name, const auto& sample, Tradeoff::Role role)
  {
    const std::vector<ink::SurfaceSample> samples = sample();
    knob.Add(
      name, [=] { sample(); },
      { { "all", Hole(mesh, samples) },
        { "a quarter", Hole(mesh, { samples.begin(), samples.begin() + count / 4 }) } },
      role);
  };
  add(
    "blue noise",
    [=, &mesh] {
      return ink::samplePoissonDiskCount(mesh.view(), areas, {}, count, ink::defaultCoverageSlack, 1).samples;
    },
    Tradeoff::Default);
  for (const double candidates : { 2.0, 4.0, 8.0, 16.0, 32.0 })
  {
    add(
      "progressive, " + std::to_string(static_cast<int>(candidates)) + " candidates",
      [=, &mesh] { return ink::sampleProgressively(mesh.view(), areas, {}, count, candidates, 1); },
      Tradeoff::Choice);
  }
  knob.Print(3);
}

} // namespace

int main()
{
  Tradeoff::PrintHeader();
  MeasureCoverageSlack();
  MeasureDensity();
  MeasureMethod();
  return 0;
}
