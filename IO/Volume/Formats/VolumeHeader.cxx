// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeHeader.h"

#include <cmath>

namespace ink::io
{

double spacingOf(double given)
{
  return std::isfinite(given) && given != 0.0 ? std::abs(given) : 1.0;
}

} // namespace ink::io
