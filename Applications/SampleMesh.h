#pragma once

#include "vtkSmartPointer.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

class vtkInkSurfaceSampler;
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
  static constexpr long long leastCount = 200'000;
  static constexpr long long mostCount = 1'000'000;

  /// None: twice as many as the mesh has points, but from leastCount to mostCount.
  std::optional<long long> count = {};
  std::optional<double> radius = {}; ///< given: says how many, in place of `count`
  std::optional<int> method = {};    ///< none: the sampler's own choice
  int seed = 0;
  int precision = 2;
  bool normals = true;
  bool radiusArray = true;
  bool priority = true;
  CloudSampling cloud = {};
};

/// Makes points of meshes. Those of one mesh after the other with the same faces are the same samples, moved,
/// if that is asked for.
class MeshSampler
{
public:
  /// \param follow move the samples of the first mesh
  explicit MeshSampler(MeshSampling sampling, bool follow = false);

  const MeshSampling& sampling() const { return this->Wanted; }

  /// Samples the surface of a mesh; points without polygons are taken as they are, with normals estimated
  /// where they have none. \param notes what was chosen and what was not as expected, each a sentence without
  /// its dot, is added \throw Failure if there are no points, UsageError for options that only points without
  /// polygons have
  vtkSmartPointer<vtkPolyData> sample(vtkPolyData* mesh, std::vector<std::string>& notes, Progress& progress);

private:
  MeshSampling Wanted;
  vtkSmartPointer<vtkInkSurfaceSampler> Sampler;
};

} // namespace ink::cli
