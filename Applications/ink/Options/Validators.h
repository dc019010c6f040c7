// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace ink::cli
{

/// A finite number between two others; CLI11's own check lets NaN pass.
CLI::Validator within(double least, double greatest);

/// Any finite number.
CLI::Validator anyNumber();

/// A number without a fraction between two others.
CLI::Validator wholeNumber(double least, double greatest);

/// One of some words; what is nearest to a wrong one is suggested.
CLI::Validator oneOf(const std::vector<std::string>& words);

} // namespace ink::cli
