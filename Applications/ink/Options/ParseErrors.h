// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace ink::cli
{

/// What is wrong with a command line, in the words of ink's other messages: the option, what was found and
/// what was expected, and the option or command that was meant where one is near.
/// @param error that parsing ended with
/// @param app what parsed it, with the arguments that were left over
std::string describe(const CLI::ParseError& error, const CLI::App& app);

} // namespace ink::cli
