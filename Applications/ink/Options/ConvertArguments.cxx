// SPDX-License-Identifier: BSD-3-Clause
#include "ConvertArguments.h"

#include <CLI/CLI.hpp>

namespace ink::cli
{

void ConvertArguments::add(CLI::App* command)
{
  // What suits every gradient, and what would no longer be narrow.
  constexpr int narrowest = 1;
  constexpr int widest = 64;
  this->input.addFile(command, "not a mesh");
  command->add_option("OUT,-o,--output", this->output, "the OpenVDB file to write")
    ->required()
    ->type_name("OUT.vdb");
  command
    ->add_option("--around", this->options.around,
      "keep only a narrow band around the surface of this value; the voxels outside of it just say which\n"
      "side they are on. Without it the whole volume is written, equal regions as one")
    ->type_name("ISO")
    ->check(anyNumber());
  command
    ->add_option("--half-width", this->options.halfWidth,
      "how many voxels the band goes on beyond those beside the surface (3)")
    ->type_name("VOXELS")
    ->needs("--around")
    ->check(wholeNumber(narrowest, widest));
  command->add_option("--name", this->options.name, "name of the grid (density)")->type_name("NAME");
  command->add_flag("-q,--quiet", this->options.quiet, "print nothing but errors");
  this->input.addReading(command);
}

void ConvertArguments::run()
{
  this->options.input = this->input.options();
  this->options.output = this->output;
  convert(this->options);
}

} // namespace ink::cli
