#include "SampleArguments.h"

#include "Errors.h"

#include "vtkAlgorithm.h"
#include "vtkInkIsoSurfaceSampler.h"

#include <algorithm>
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
      "value of the surface in a volume; may be given several times. Without it one is chosen and named")
    ->type_name("V")
    ->expected(1)
    ->take_all();
  command
    ->add_option("--arrays", this->arrays,
      "what to write with the points: Normals, Radius (half the diagonal of a voxel), SurfaceIndex (which\n"
      "iso-value, from 0), or none (Normals,Radius, and SurfaceIndex if there are several iso-values)")
    ->type_name("A,B")
    ->delimiter(',')
    ->check(CLI::IsMember({ "Normals", "Radius", "SurfaceIndex", "none" }));
  command
    ->add_option("--precision", this->precision,
      "of coordinates: float, double, or auto: float unless that moves points by a thousandth of a voxel "
      "(auto)")
    ->type_name("NAME")
    ->check(CLI::IsMember(namesOf(precisions())));
  command->add_flag("-q,--quiet", this->options.quiet, "print nothing but errors");
  command
    ->add_option("--rule", this->rule,
      "which edges between voxels the surface crosses: half-open, without holes or doubles, or strict, as\n"
      "published (half-open)")
    ->type_name("NAME")
    ->group("Volumes")
    ->check(CLI::IsMember(namesOf(rules())));
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
  sample(this->options);
}

} // namespace ink::cli
