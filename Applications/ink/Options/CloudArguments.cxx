// SPDX-License-Identifier: BSD-3-Clause
#include "CloudArguments.h"

#include "InputArguments.h"

#include "vtkInkSurfaceSampler.h"
#include "vtkNew.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <limits>

namespace ink::cli
{

void CloudArguments::add(CLI::App* command)
{
  constexpr const char* group = "Points without polygons";
  constexpr double most = std::numeric_limits<double>::max();
  // The range and the default are the sampler's own.
  vtkNew<vtkInkSurfaceSampler> sampler;
  this->All.push_back(
    command
      ->add_option("--neighbors", this->sampling.neighbors,
        "from how many neighbors normals are estimated where there are none; more smooth\n"
        "noise (" +
          std::to_string(sampler->GetNormalNeighbors()) + ")")
      ->type_name("N")
      ->group(group)
      ->check(wholeNumber(sampler->GetNormalNeighborsMinValue(), sampler->GetNormalNeighborsMaxValue())));
  this->All.push_back(command
                        ->add_option("--viewpoint", this->viewpoint,
                          "where the scanner stood: estimated normals point to its side (outwards)")
                        ->delimiter(',')
                        ->expected(3)
                        ->allow_extra_args(false)
                        ->type_name("x,y,z")
                        ->group(group)
                        ->check(within(-most, most)));
}

CloudSampling CloudArguments::options() const
{
  CloudSampling options = this->sampling;
  if (!this->viewpoint.empty())
  {
    std::copy(this->viewpoint.begin(), this->viewpoint.end(), options.viewpoint.emplace().begin());
  }
  for (const CLI::Option* option : this->All)
  {
    options.given = option->count() > 0 ? option->get_name() : options.given;
  }
  return options;
}

} // namespace ink::cli
