// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace ink::cli
{

class CommandLine;

/// A script that completes commands, options and their words in bash, to be read by it or to lie in
/// share/bash-completion/completions/ink.
std::string bashCompletion(const CommandLine& commandLine);

/// The same for zsh, to lie as _ink in a folder of its fpath.
std::string zshCompletion(const CommandLine& commandLine);

} // namespace ink::cli
