// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace ink::cli
{

class CommandLine;

/// The manual page ink(1), in the macros of man(7): all commands with all options, those of each style in
/// groups of their own.
std::string manPage(const CommandLine& commandLine);

} // namespace ink::cli
