// SPDX-License-Identifier: BSD-3-Clause
#include "InfoArguments.h"

namespace ink::cli
{

void InfoArguments::add(CLI::App* command)
{
  command->add_option("FILE", this->files, InputArguments::fileHelp("mesh"))->required();
  command->add_flag("--json", this->options.json, "print JSON, a list with an object for each file");
  command->add_flag("-q,--quiet", this->options.quiet, "show no progress");
  this->input.addReading(command);
}

void InfoArguments::run()
{
  this->options.input = this->input.options();
  this->options.files.assign(this->files.begin(), this->files.end());
  info(this->options);
}

} // namespace ink::cli
