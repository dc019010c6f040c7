// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkSmartPointer.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

class vtkPolyData;

namespace ink::cli
{

class Progress;

/// What is done with points without polygons.
struct CloudSampling
{
  std::optional<int> neighbors; ///< for normals; none: the sampler's own number
  std::optional<std::array<double, 3>> viewpoint;
  std::string given; ///< one of the options that was given, as it is called; empty: none
};

/// How a mesh becomes points. What vtkInkSurfaceSampler has numbers for is given as these.
struct MeshSampling
{
  std::optional<long long> count = {}; ///< none: as many as are drawn of it
  std::optional<double> radius = {};   ///< given: says how many, in place of `count`
  std::optional<int> method = {};      ///< none: the sampler's own choice
  int seed = 0;
  int precision = 2;
  bool normals = true;
  bool radiusArray = true;
  bool priority = true;
  CloudSampling cloud = {};
};

/// Samples the surface of a mesh; points without polygons are taken as they are, with normals estimated where
/// they have none.
/// @param notes what was chosen and what was not as expected, each a sentence without its dot, is added
/// @throws Failure if there are no points, UsageError for options that only points without polygons have
vtkSmartPointer<vtkPolyData> sampleMesh(
  vtkPolyData* mesh, const MeshSampling& sampling, std::vector<std::string>& notes, Progress& progress);

} // namespace ink::cli
