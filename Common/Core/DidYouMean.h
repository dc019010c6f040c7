// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace ink
{

/// "; did you mean 'render'?" for what was mistyped, or nothing where no known word is near: no more than a
/// third of the letters inserted, left out, replaced or swapped with their neighbor (optimal string alignment
/// distance, Damerau 1964). Of several, the nearest, then the first. Case does not matter.
std::string didYouMean(const std::string& found, const std::vector<std::string>& known);

} // namespace ink
