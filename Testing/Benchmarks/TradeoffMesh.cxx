// SPDX-License-Identifier: BSD-3-Clause
// Samples of meshes: how large the holes between them are against the time to make them.

#include "Tradeoff.h"

#include "SampledMeshes.h"
#include "Sampling/BlueNoise.h"
#include "Sampling/WhiteNoise.h"

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

std::vector<ink::SurfaceSample> Sample(const Mesh& mesh, bool blue, double radius, double gap)
{
  const auto areas = ink::cumulateArea(mesh.view());
  return blue ? ink::sampleBlueNoise(mesh.view(), areas, radius, gap, 1).samples
              : ink::sampleWhiteNoise(
                  mesh.view(), areas, static_cast<std::size_t>(ink::saturatedCount / (radius * radius)), 1);
}

/// The farthest of many places on the mesh from the nearest sample.
double Hole(const Mesh& mesh, const std::vector<ink::SurfaceSample>& samples)
{
  const auto areas = ink::cumulateArea(mesh.view());
  const auto places = positionsOf(mesh.view(), ink::sampleWhiteNoise(mesh.view(), areas, 2000, 77));
  const auto points = positionsOf(mesh.view(), samples);
  return largestGap(places, points, points.size());
}

void MeasureGap()
{
  const double radius = 0.01;
  Tradeoff knob("Gap (vtkInkSurfaceSampler)",
    "Keep 0.06: wider gaps save up to a fifth of the time, the widest two fifths; they are for those who "
    "want fewer samples of the same least distance.",
    "farthest place from a sample, of the radius",
    "blue noise of a radius of a hundredth of the square root of the area, on the torus");
  for (const double gap : { 0.02, 0.06, 0.15, 0.3, 0.6, 1.0 })
  {
    Tradeoff::Errors errors;
    for (const auto& [name, mesh] : AllScenes)
    {
      const auto samples = Sample(mesh, true, radius, gap);
      errors.emplace_back(name, Hole(mesh, samples) / radius);
    }
    std::string title = std::to_string(gap);
    knob.Add(
      title.substr(0, 4), [=] { Sample(AllScenes[0].second, true, radius, gap); }, errors,
      gap == ink::defaultGap ? Tradeoff::Default : Tradeoff::Choice);
  }
  knob.Print(3);
}

void MeasureDensity()
{
  Tradeoff knob("Number of samples (vtkInkSurfaceSampler)",
    "Keep some 100,000 samples of blue noise for a drawing of a thousand pixels; four times as many halve "
    "the holes, and "
    "white noise has the same holes with four times as many, in a twentieth of the time.",
    "farthest place from a sample, of the square root of the area", "samples of the torus");
  for (const bool blue : { false, true })
  {
    for (const int count : { 1000, 10000, 100000, 400000 })
    {
      const double radius = std::sqrt(ink::saturatedCount / count);
      Tradeoff::Errors errors;
      for (const auto& [name, mesh] : AllScenes)
      {
        errors.emplace_back(name, Hole(mesh, Sample(mesh, blue, radius, ink::defaultGap)));
      }
      knob.Add(
        std::to_string(count) + (blue ? " blue" : " white"),
        [=] { Sample(AllScenes[0].second, blue, radius, ink::defaultGap); }, errors,
        blue && count == 100000 ? Tradeoff::Default : Tradeoff::Choice);
    }
  }
  knob.Print(3);
}

} // namespace

int main()
{
  Tradeoff::PrintHeader();
  MeasureGap();
  MeasureDensity();
  return 0;
}
