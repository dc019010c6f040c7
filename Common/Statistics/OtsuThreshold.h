// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace ink
{

/// Otsu's threshold (IEEE Trans. SMC 9, 1979), which splits a histogram in the two parts whose means differ
/// most, for their sizes. @return as a position between bins: i at the end of bin i; the middle of equally
/// good ones
double otsuThreshold(const std::vector<std::int64_t>& histogram);

} // namespace ink
