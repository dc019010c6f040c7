// SPDX-License-Identifier: BSD-3-Clause
#include "SampleArguments.h"

#include "Errors.h"

#include "vtkAlgorithm.h"
#include "vtkInkIsoSurfaceSampler.h"
#include "vtkInkSurfaceSampler.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <limits>
#include <map>

namespace ink::cli
{
namespace
{

const std::map<std::string, int>& rules()
{
  static const std::map<std::string, int> all{ { "half-open", vtkInkIsoSurfaceSampler::HALF_OPEN },
    { "strict", vtkInkIsoSurfaceSampler::STRICT } };
  return all;
}

const std::map<std::string, int>& precisions()
{
  static const std::map<std::string, int> all{ { "auto", vtkAlgorithm::DEFAULT_PRECISION },
    { "float", vtkAlgorithm::SINGLE_PRECISION }, { "double", vtkAlgorithm::DOUBLE_PRECISION } };
  return all;
}

const std::map<std::string, int>& methods()
{
  static const std::map<std::string, int> all{ { "white", vtkInkSurfaceSampler::WHITE_NOISE },
    { "blue", vtkInkSurfaceSampler::BLUE_NOISE },
    { "progressive", vtkInkSurfaceSampler::PROGRESSIVE_BLUE_NOISE } };
  return all;
}

std::vector<std::string> namesOf(const std::map<std::string, int>& map)
{
  std::vector<std::string> names;
  for (const auto& [name, value] : map)
  {
    names.push_back(name);
  }
  return names;
}

} // namespace

void SampleArguments::add(CLI::App* command)
{
  this->input.addFile(command);
  command
    ->add_option("OUT,-o,--output", this->output,
      "the points to write: .vtp, .vtk or .ply, binary; .csv, text with a line of names; .xyz, text, only\n"
      "coordinates and normals")
    ->required()
    ->type_name("OUT.vtp");
  command
    ->add_option("--iso", this->options.volume.isoValues,
      "values of the surfaces in a volume, with commas or one by one. Without any one is chosen and named")
    ->type_name("V")
    ->delimiter(',')
    ->allow_extra_args(false)
    ->take_all()
    ->check(anyNumber());
  command
    ->add_option("--arrays", this->arrays,
      "what to write with the points: Normals, Radius (discs of this radius leave no holes), Priority (on\n"
      "meshes: points below any priority are spread evenly), SurfaceIndex (in volumes: which iso-value, "
      "from\n"
      "0), or none (Normals,Radius; Priority of a mesh; SurfaceIndex if there are several iso-values)")
    ->type_name("A,B")
    ->delimiter(',')
    ->allow_extra_args(false)
    ->check(oneOf({ "Normals", "Radius", "Priority", "SurfaceIndex", "none" }));
  command
    ->add_option("--precision", this->precision,
      "of coordinates: float, double, or auto: of a mesh the file's, in a volume float unless that moves\n"
      "points by a thousandth of a voxel (auto)")
    ->type_name("NAME")
    ->check(oneOf(namesOf(precisions())));
  command->add_flag("-q,--quiet", this->options.quiet, "print nothing but errors");
  command
    ->add_option("--rule", this->rule,
      "which edges between voxels the surface crosses: half-open, without holes or doubles, or strict, as\n"
      "published (half-open)")
    ->type_name("NAME")
    ->group("Volumes")
    ->check(oneOf(namesOf(rules())));
  MeshSampling& mesh = this->options.mesh;
  auto* count =
    command
      ->add_option("--count", mesh.count,
        "how many points to make (twice as many as the mesh has, or more where it has much surface for its "
        "size, but 200000 to 1000000)")
      ->type_name("N")
      ->group("Meshes")
      ->check(wholeNumber(1, 1e12));
  command
    ->add_option(
      "--radius", mesh.radius, "least distance between points along the surface, in place of --count")
    ->type_name("R")
    ->group("Meshes")
    ->check(within(1e-30, 1e30))
    ->excludes(count);
  command
    ->add_option("--noise", this->noise,
      "white: independent points, fast; blue: they keep a distance and leave no gaps; progressive: blue,\n"
      "less even, several times as fast (blue below 500000 points, else white; without --count progressive "
      "above 200000)")
    ->type_name("NAME")
    ->group("Meshes")
    ->check(oneOf(namesOf(methods())));
  command->add_option("--seed", mesh.seed, "another seed makes other points, just as good (0)")
    ->type_name("N")
    ->group("Meshes")
    ->check(wholeNumber(std::numeric_limits<int>::min(), std::numeric_limits<int>::max()));
  this->cloud.add(command);
  this->app = command;
  this->input.addReading(command);
}

void SampleArguments::run()
{
  this->options.input = this->input.options();
  this->options.output = this->output;
  VolumeSampling& volume = this->options.volume;
  volume.crossingRule = rules().at(this->rule);
  volume.precision = precisions().at(this->precision);
  const auto wants = [this](const char* name)
  { return std::find(this->arrays.begin(), this->arrays.end(), name) != this->arrays.end(); };
  if (wants("none") && this->arrays.size() > 1)
  {
    throw UsageError("--arrays: expected names of arrays or none, found both");
  }
  const bool standard = this->arrays.empty();
  volume.normals = standard || wants("Normals");
  volume.radius = standard || wants("Radius");
  volume.surfaceIndex = standard ? volume.isoValues.size() > 1 : wants("SurfaceIndex");
  MeshSampling& mesh = this->options.mesh;
  mesh.cloud = this->cloud.options();
  mesh.precision = volume.precision;
  mesh.normals = volume.normals;
  mesh.radiusArray = volume.radius;
  mesh.priority = standard || wants("Priority");
  if (!this->noise.empty())
  {
    mesh.method = methods().at(this->noise);
  }
  for (const char* name : { "--count", "--radius", "--noise", "--seed" })
  {
    if (this->app->count(name) > 0)
    {
      this->options.meshOption = name;
    }
  }
  if (!mesh.cloud.given.empty())
  {
    this->options.meshOption = mesh.cloud.given;
  }
  if (wants("Priority"))
  {
    this->options.meshOption = "--arrays Priority";
  }
  sample(this->options);
}

} // namespace ink::cli
