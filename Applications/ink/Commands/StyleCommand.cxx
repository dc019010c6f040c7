// SPDX-License-Identifier: BSD-3-Clause
#include "StyleCommand.h"

#include "Errors.h"
#include "RenderCommand.h"
#include "Validators.h"

#include <CLI/CLI.hpp>

#include <iostream>

namespace ink::cli
{

void StyleCommand::add(CLI::App* command, const std::string& styleName, bool all)
{
  std::string known;
  for (const std::string& one : StyleArguments::names())
  {
    known += (known.empty() ? "" : " or ") + one;
  }
  command->add_option("NAME", this->name, "the style: " + known)
    ->required()
    ->check(oneOf(StyleArguments::names()));
  this->parameters.add(command, styleName, all);
}

void StyleCommand::run()
{
  std::cout << this->parameters.make(PictureSize().supersampling())->GetParametersAsJSON();
}

} // namespace ink::cli
